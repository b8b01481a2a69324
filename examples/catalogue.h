/* catalogue.h - the named surfaces: equation, what of it is shown, from where, in which colours. */
#ifndef CATALOGUE_H
#define CATALOGUE_H
#include <stddef.h>

#include "algsurf/algsurf.h"

typedef struct catalogue_entry {
    const char *name;
    int degree;
    const char *equation;  /* "... = 0"; constants are written out, so that nothing is rounded beforehand */
    algsurf_extent extent; /* what is shown */
    double eye[3], look_at[3], up[3], fov; /* from where; the vertical field of view in degrees */
    double outside[3], inside[3];          /* colours where the polynomial is > 0 and < 0 in front */
} catalogue_entry;

/* All of them; the last row has a null name. */
extern const catalogue_entry catalogue[];

/* The surface of that name, or null. */
const catalogue_entry *catalogue_find(const char *name);

/* The first entry with the same equation: another one is a synonym, perhaps seen from elsewhere. */
const catalogue_entry *catalogue_first_of(const catalogue_entry *entry);

#endif
