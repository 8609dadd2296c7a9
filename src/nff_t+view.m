#import "nff_t.h"
#import "diag_t.h"
#include "attribute_check.h"
#include "grow.h"

@implementation nff_t (view)

/** Whether all that is required was given; a fault if not. */
- (BOOL) isComplete: (const struct attribute *)table given: (unsigned)given
{
  uint64_t missing = 0, bit = 1;

  for (const struct attribute *a = table; a->name; a++, bit <<= 1)
    {
      missing |= a->is_required && !(given & bit) ? bit : 0;
    }
  if (missing)
    {
      FAULT(letter.at, @"expected %@%@, found none",
            attribute_list(attribute_names_of(table, missing), @"and"),
            [self owner]);
    }
  return missing == 0;
}

- (BOOL) readView
{
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
  static const char *const names[] = {
    "viewpoint", "lookat", "up", "angle", NULL, "pixeldim"
  };
  struct value values[6][3];
  unsigned given = 0;
  BOOL is_good = store->camera == NO_RECORD;
  const struct attribute *a;

  if (!is_good)
    {
      FAULT(letter.at, @"second camera, expected one in the whole model;"
            @" the first is at %@", [diag nameOf: [text placeAt:
              store->records[store->camera].order]]);
    }
  while ((a = attribute_named(view, token_peek(text->cursor))))
    {
      struct token t = token_next(&text->cursor);
      if (given & 1u << (a - view))
        {
          is_good = NO;
          FAULT(t.at, @"second %s%@, expected one", a->name, [self owner]);
        }
      given |= 1u << (a - view);
      if (![self read: a into: values[a - view]])
        {
          is_good = NO;
          [self resume];
        }
    }
  store->has_camera = YES;
  if ([self isComplete: view given: given] && is_good)
    {
      store->camera = store->record_count;
      [self begin: KIND_CAMERA : "v" : 1];
      for (unsigned i = 0; i < 6; i++)
        {
          if (names[i])
            {
              [self give: names[i] : values[i]];
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
  [self give: "location" : xyz];
  if (!has_color)
    {
      grow((void **)&plain_lights, plain_light_count, &plain_light_capacity,
           sizeof *plain_lights);
      plain_lights[plain_light_count++] = store->value_count;
    }
  [self give: "emissivity" : rgb];
  [self give: "falloff" : &falloff];
  return YES;
}

@end
