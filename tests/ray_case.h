/* ray_case.h - rays, clips and messages that the tests of the room ray share. */
#ifndef RAY_CASE_H
#define RAY_CASE_H
#include "algsurf/ray.h"
#include "exact.h"
#include "unit.h"

static inline algsurf_ray make_ray(const double o[3], const double d[3], double t_min, double t_max) {
    algsurf_ray ray = {.t_min = t_min, .t_max = t_max};
    memcpy(ray.origin, o, sizeof ray.origin);
    memcpy(ray.direction, d, sizeof ray.direction);
    return ray;
}

static inline void print_case(const algsurf_extent *e, const algsurf_ray *r, const double *got) {
    fprintf(stderr, "kind %d\n", (int)e->kind);
    exact_print_doubles("centre", e->centre, 3);
    exact_print_doubles("size", e->size, 3);
    exact_print_doubles("origin", r->origin, 3);
    exact_print_doubles("direction", r->direction, 3);
    if (got) exact_print_doubles("ends", got, 2);
}

static inline int clip(const algsurf_extent *e, const algsurf_ray *r, algsurf_ray *chord) {
    int meets = -1;
    assert_ok(algsurf_extent_clip(e, r, chord, &meets));
    return meets;
}

#endif
