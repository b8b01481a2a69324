/* roots_write.h - the roots of a line as text. */
#ifndef ROOTS_WRITE_H
#define ROOTS_WRITE_H
#include "roots_digits.h"
#include "roots_line.h"
#include "shortest.h"

/* Text that grows; starts as zeros, and its text is to be freed. */
typedef struct roots_text {
    char *text;
    size_t length, capacity;
} roots_text;

/* Adds what printf would print, without numbers that need a locale or all digits. */
void roots_add(roots_text *to, const char *format, ...) CLI_FORMAT(2, 3);

/* For programs: line, index, re, im, re_lo, re_hi, im_lo, im_hi, multiplicity, 1. */
void roots_write_columns(roots_text *to, const shortest_powers *powers, size_t line, const roots_row *rows,
                         int count);

/* For people; exact: the root is the double itself; rounded: of a polynomial whose numbers were rounded. */
void roots_write_sentence(roots_text *to, const shortest_powers *powers, int index, const roots_row *row,
                          int exact, int rounded);

/* The same for a root as decimals. */
void roots_write_decimal_columns(roots_text *to, size_t line, int index, const roots_decimals *re,
                                 const roots_decimals *im, int multiplicity);
void roots_write_decimal_sentence(roots_text *to, int index, const roots_decimals *re,
                                  const roots_decimals *im, int real, int multiplicity);

/* A number, as shortest_write has it. */
void roots_add_number(roots_text *to, const shortest_powers *powers, double x);

#endif
