/* table.h - entries of a caller's table, one by one. */
#ifndef ALGSURF_POLY_TABLE_H
#define ALGSURF_POLY_TABLE_H
#include "algsurf/poly.h"

/* That of power k of polynomial i. */
static inline double algsurf_i_table_entry(const algsurf_table *t, int k, size_t i) {
    return t->at[k * t->power + (ptrdiff_t)i * t->polynomial];
}

/* Those of powers 0 .. degree of polynomial i. */
static inline void algsurf_i_table_row(const algsurf_table *t, int degree, size_t i, double *row) {
    for (int k = 0; k <= degree; k++) row[k] = algsurf_i_table_entry(t, k, i);
}

#endif
