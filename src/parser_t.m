#import "parser_t.h"
#import "builder_t.h"
#import "compiler_t.h"
#import "diag_t.h"
#import "format_t.h"
#import "mdl_t.h"

@implementation parser_t

/** Reads the blocks, makes the model of them; nil if there was a fault.
    keeps_all: the store has all blocks afterwards. */
+ (model_t *) model: (struct parse_options)options from: (source_t *)source
             reader: (mdl_t *)reader
               into: (store_t *)store keepsAll: (BOOL)keeps_all
               text: (text_t *)text diag: (diag_t *)diag
{
  builder_t *builder;
  model_t *model = [[model_t alloc] init];

  model->polygon_test = options.polygon_test;
  model->max_depth = options.max_depth;
  model->compiler = [options.compiler retain];
  builder = [[builder_t alloc] init: store text: text diag: diag
                              model: model];
  store->builder = keeps_all ? nil : builder;
  [reader read: source];
  [builder build];
  [builder release];
  if ([diag faultCount] > 0)
    {
      [model release];
      return nil;
    }
  return [model autorelease];
}

+ (model_t *) modelFromFile: (NSString *)path
                includePath: (NSArray *)includePath
                    options: (struct parse_options)options
                       diag: (diag_t *)diag
                       text: (NSData **)bytes
                  canonical: (NSString **)canonical
                      error: (NSError **)error
{
  source_t *source = [[source_t alloc] initWithScene: path error: error];

  if (source == nil)
    {
      return nil;
    }

  text_t *text = [[text_t alloc] init: diag];
  store_t *store = [[store_t alloc] init];
  mdl_t *reader = [[mdl_t alloc] init: text into: store diag: diag
                          includePath: includePath];
  model_t *model = [self model: options from: source reader: reader
                          into: store keepsAll: canonical != NULL
                          text: text diag: diag];

  if (bytes)
    {
      *bytes = [[[text bytes] retain] autorelease];
    }
  if (canonical)
    {
      *canonical = model ? [format_t textOf: store] : nil;
    }
  [reader release];
  [store release];
  [text release];
  [source release];
  return model;
}

@end
