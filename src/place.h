// place.h - where in the text of a model something stands.

#ifndef PLACE_H
#define PLACE_H

/** A place in a file. diag_t knows the files; `order` grows in the order in
    which the text was read, includes in their place, so that faults can be
    told in that order whenever they are found. */
struct place
{
  int file;             // diag_t's number for the file; -1 for no place
  int line, column;     // from 1; columns in characters, a tab is one
  unsigned long order;
};

#endif
