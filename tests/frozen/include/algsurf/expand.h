#ifndef ALGSURF_EXPAND_H
#define ALGSURF_EXPAND_H
#include "algsurf/ray.h"
#include "algsurf/surface.h"
#ifdef __cplusplus
extern "C" {
#endif
ALGSURF_API algsurf_status algsurf_expand_power(const algsurf_surface *surface, const algsurf_ray *ray,
                                                double *c, double *r);
ALGSURF_API algsurf_status algsurf_expand_bernstein(const algsurf_surface *surface, const algsurf_ray *ray,
                                                    double *b, double *r);
#ifdef __cplusplus
}
#endif
#endif
