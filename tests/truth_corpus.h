/* truth_corpus.h - reading the corpus of certified answers in tests/data (see its README.md).
 *
 * Every function here ends the program with a message when the corpus itself cannot be read: a test
 * without its data has failed.
 */
#ifndef TRUTH_CORPUS_H
#define TRUTH_CORPUS_H
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "algsurf/algsurf.h"

/* A table of cells, row by row; the header line is skipped. */
typedef struct truth_table {
    char *text;
    char **cell;
    size_t rows, columns;
} truth_table;

/* The only argument of a program; ends it where there is another number of them. */
const char *truth_folder(int argc, char **argv);

_Noreturn void truth_give_up(const char *what, const char *which);

truth_table truth_read(const char *folder, const char *file, size_t columns);
void truth_free(truth_table *table);
static inline char *truth_cell(const truth_table *t, size_t row, size_t column) {
    return t->cell[row * t->columns + column];
}

/* A number that takes all of the text, as strtod reads it. */
double truth_number(const char *text);

/* The ray of eight numbers as text: origin, direction, t_min, t_max. */
algsurf_ray truth_ray(char *const field[8]);

/* The surface folder/surfaces/NAME.terms; the one asked for last is kept, free it with name null. */
const algsurf_surface *truth_surface(const char *folder, const char *name);

#endif
