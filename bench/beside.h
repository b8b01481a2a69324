/* beside.h - another edition of the library, to be timed beside this one: see the script beside.
 *
 * Editions number their tiers and lay out their hits differently, so a program can use the headers of one of
 * them only.  beside.c is compiled with those of the other, and linked with its archive to a shared object
 * with one name of interest, `beside`; the program loads that.  What both must have alike, surfaces,
 * extents and rays, is checked by size.
 */
#ifndef BESIDE_H
#define BESIDE_H
#include <stddef.h>

#include "algsurf/algsurf.h"

typedef enum beside_answer { BESIDE_NO_HIT, BESIDE_HIT, BESIDE_UNDECIDED, BESIDE_REFUSED } beside_answer;

typedef struct beside_edition {
    const char *name;
    size_t term_size, extent_size, ray_size;
    algsurf_status (*surface_from_terms)(const algsurf_term *terms, size_t count, algsurf_surface **surface);
    void (*surface_free)(algsurf_surface *surface);
    /* The certified tier's first hit, and where it is. */
    beside_answer (*first)(const algsurf_surface *surface, const algsurf_extent *extent,
                           const algsurf_ray *ray, double *t);
} beside_edition;

extern const beside_edition beside;

#endif
