/* table_template.h - entries of a caller's table, LANES polynomials side by side. */
#ifndef ALGSURF_TABLE_TEMPLATE_H
#define ALGSURF_TABLE_TEMPLATE_H
#include "../simd/lanes.h"
#include "algsurf/poly.h"

/* Those of power k of polynomials at .. at+count-1. */
INLINE lanes load_table(const algsurf_table *t, int k, size_t at, int count) {
    return load_steps(t->at + k * t->power + (ptrdiff_t)at * t->polynomial, t->polynomial, count);
}

#endif
