#import "nff_t.h"
#import "diag_t.h"
#include "attribute_check.h"
#include "grow.h"

@implementation nff_t (view)

static const struct attribute view[] = {
  { .name = "from", .kind = ATTRIBUTE_POINT, .is_required = 1 },
  { .name = "at", .kind = ATTRIBUTE_POINT, .is_required = 1 },
  { .name = "up", .kind = ATTRIBUTE_VECTOR, .is_required = 1 },
  { .name = "angle", .kind = ATTRIBUTE_NUMBER, .is_required = 1,
    .range = RANGE_STRICTLY_BETWEEN, .least = 0, .most = 180 },
  { .name = "hither", .kind = ATTRIBUTE_NUMBER },
  { .name = "resolution", .kind = ATTRIBUTE_WHOLE_PAIR, .is_required = 1,
    .range = RANGE_BETWEEN, .least = 1, .most = 1000000 },
  { .name = NULL }
};

/** The bits of what is required and was not given. */
static uint64_t
missing(uint64_t given)
{
  uint64_t missing = 0, bit = 1;

  for (const struct attribute *a = view; a->name; a++, bit <<= 1)
    {
      missing |= a->is_required && !(given & bit) ? bit : 0;
    }
  return missing;
}

- (void) skipView
{
  while (attribute_named(view, token_peek(text->cursor)))
    {
      store->has_camera = YES;
      token_next(&text->cursor);
      [self resume];
    }
}

/** Reads attributes into their places; the bits of those given. Something
    else may be meant to be one as long as not all are there: that is a fault,
    and *faults of them cannot be used. */
- (uint64_t) readView: (struct value (*)[3])values faults: (unsigned *)faults
{
  uint64_t given = 0;

  for (;;)
    {
      struct token t = token_peek(text->cursor);
      const struct attribute *a = attribute_named(view, t);

      if (a == NULL && (t.length == 0 || missing(given) == 0
                        || [self isEntity: t]))
        {
          return given;
        }
      token_next(&text->cursor);
      if (a == NULL)
        {
          FAULT(t.at, @"%@ %@%@%@", [self isNumber: t]
                ? @"one number too many:" : @"unknown attribute",
                [self quote: t], [self owner],
                [self advise: t among: attribute_names(view)]);
        }
      else if (given & 1u << (a - view))
        {
          FAULT(t.at, @"second %s%@, expected one", a->name, [self owner]);
        }
      else if ([self read: a into: values[a - view]])
        {
          given |= 1u << (a - view);
          continue;
        }
      ++*faults;
      [self resume];
    }
}

- (BOOL) readView
{
  static const char *const names[] = {
    "viewpoint", "lookat", "up", "angle", NULL, "pixeldim"
  };
  struct value values[6][3];
  unsigned faults = 0;
  BOOL is_good = store->camera == NO_RECORD;

  if (!is_good)
    {
      FAULT(letter.at, @"second camera, expected one in the whole model;"
            @" the first is at %@", [diag nameOf: [text placeAt:
              store->records[store->camera].order]]);
    }

  uint64_t lacking = missing([self readView: values faults: &faults]);

  store->has_camera = YES;
  if (lacking && faults == 0)
    {
      FAULT(letter.at, @"expected %@%@, found none",
            attribute_list(attribute_names_of(view, lacking), @"and"),
            [self owner]);
    }
  if (lacking == 0 && faults == 0 && is_good)
    {
      store->camera = store->record_count;
      [self begin: KIND_CAMERA : "v" : 1];
      for (unsigned i = 0; i < 6; i++)
        {
          if (names[i])
            {
              nff_give(self, names[i], values[i]);
            }
        }
    }
  return YES;
}

- (BOOL) readBackground
{
  static const struct attribute color =
    { .name = "the colour", .kind = ATTRIBUTE_COLOR };
  struct value rgb[3];
  BOOL is_good = !store->has_background;

  if (!is_good)
    {
      FAULT(letter.at, @"second b, expected one background in the whole"
            @" model");
    }
  if (![self read: &color into: rgb])
    {
      return NO;
    }
  store->has_background = YES;
  store->background_order = [self orderOf: letter];
  store->background = k_vec(rgb[0].number, rgb[1].number, rgb[2].number);
  return is_good;
}

- (BOOL) readLight
{
  static const struct attribute place =
    { .name = "the place", .kind = ATTRIBUTE_POINT };
  static const struct attribute color =
    { .name = "the colour", .kind = ATTRIBUTE_COLOR };
  struct value xyz[3], rgb[3] = { [self valueOf: letter] };
  struct value falloff = [self valueOf: letter];

  lights++;
  if (![self read: &place into: xyz])
    {
      return NO;
    }

  struct token next = token_peek(text->cursor);
  BOOL has_color = next.length > 0 && ![self endsValues: next];

  if (has_color && ![self read: &color into: rgb])
    {
      return NO;
    }
  falloff.number = 0;
  [self begin: KIND_LIGHT : "l" : lights];
  nff_give(self, "location", xyz);
  if (!has_color)
    {
      grow((void **)&plain_lights, plain_light_count, &plain_light_capacity,
           sizeof *plain_lights);
      plain_lights[plain_light_count++] = store->value_count;
    }
  nff_give(self, "emissivity", rgb);
  nff_give(self, "falloff", &falloff);
  return YES;
}

@end
