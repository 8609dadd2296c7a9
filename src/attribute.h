// attribute.h - what a block of a model file may contain. A class that reads
// a block says so in one table; the parser then reads, counts and checks the
// values, and every message about them is made in one place.

#ifndef ATTRIBUTE_H
#define ATTRIBUTE_H

/** What the values after an attribute's name are. */
enum attribute_kind
{
  ATTRIBUTE_NUMBER,     // one number
  ATTRIBUTE_WHOLE,      // one whole number, digits only
  ATTRIBUTE_PAIR,       // two numbers
  ATTRIBUTE_WHOLE_PAIR, // two whole numbers, digits only
  ATTRIBUTE_POINT,      // three numbers, a place
  ATTRIBUTE_VECTOR,     // three numbers, not all zero
  ATTRIBUTE_COLOR,      // three numbers, each >= 0
  ATTRIBUTE_MATERIAL,   // the name of a material of the same model
  ATTRIBUTE_NAME,       // any name
  ATTRIBUTE_WORD        // one of the words of `words`
};

/** Which numbers are allowed, beside the range of all numbers (0 or a
    magnitude of 2^-400 to 2^400). */
enum attribute_range
{
  RANGE_ANY,
  RANGE_POSITIVE,       // > 0
  RANGE_NOT_NEGATIVE,   // >= 0
  RANGE_BETWEEN,        // least <= value <= most
  RANGE_STRICTLY_BETWEEN        // least < value < most
};

struct attribute
{
  const char *name;
  enum attribute_kind kind;
  int is_required;
  enum attribute_range range;
  double least, most;   // for the two last ranges
  const char *words;    // for ATTRIBUTE_WORD: "square disc"
  int is_repeated;      // may be given more than once (polygon's vertex)
};

#endif
