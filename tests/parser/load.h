// load.h - models from files that a test writes into a folder of its own.

#ifndef LOAD_H
#define LOAD_H

#import "support.h"
#include <sys/stat.h>

#define CAMERA "camera cam { pixeldim 8 6 worlddim 4 3 viewpoint 2 1.5 4 }\n"
#define GLASS "material glass { diffuse 1 1 1 }\n"

/** What came of reading a file. Everything is autoreleased. */
struct load
{
  model_t *model;
  NSString *report;
  NSData *text;
  NSString *canonical;
  NSError *error;
  unsigned long faults;
};

/** The folder in which the test works. */
static inline NSString *
load_folder(void)
{
  const char *folder = getenv("TMP");

  return [NSString stringWithUTF8String: folder ? folder : "/tmp"];
}

static inline NSString *
load_path(const char *name)
{
  return [load_folder() stringByAppendingPathComponent:
    [NSString stringWithUTF8String: name]];
}

/** Writes a file of `length` bytes. */
static inline void
load_write_bytes(const char *name, const char *bytes, size_t length)
{
  [[NSData dataWithBytes: bytes length: length]
    writeToFile: load_path(name) atomically: NO];
}

static inline void
load_write(const char *name, const char *text)
{
  load_write_bytes(name, text, strlen(text));
}

/** Reads a file of that folder. */
static inline struct load
load_file(const char *name, NSArray *includePath)
{
  diag_t *diag = [[[diag_t alloc] init] autorelease];
  struct load load = { .model = nil };

  load.model = [parser_t modelFromFile: load_path(name)
                           includePath: includePath
                               options: support_options()
                                  diag: diag
                                  text: &load.text
                             canonical: &load.canonical
                                 error: &load.error];
  load.report = [diag report];
  load.faults = [diag faultCount];
  return load;
}

/** Reads a text. */
static inline struct load
load_text(const char *text)
{
  load_write("text.mdl", text);
  return load_file("text.mdl", [NSArray array]);
}

/** Reads a text with a camera before it. */
static inline struct load
load_scene(const char *text)
{
  return load_text([[NSString stringWithFormat: @CAMERA "%s", text]
                     UTF8String]);
}

/** Whether the two say the same. */
static inline BOOL
is_text(NSString *got, const char *want)
{
  BOOL is_same = [got isEqual: [NSString stringWithUTF8String: want]];

  if (!is_same)
    {
      printf("# got:\n");
      for (NSString *line in [got componentsSeparatedByString: @"\n"])
        {
          printf("#   %s\n", [line UTF8String]);
        }
    }
  return is_same;
}

#endif
