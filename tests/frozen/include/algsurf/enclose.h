#ifndef ALGSURF_ENCLOSE_H
#define ALGSURF_ENCLOSE_H
#include "algsurf/ray.h"
#include "algsurf/surface.h"
#ifdef __cplusplus
extern "C" {
#endif
typedef enum algsurf_part {
    ALGSURF_PART_ALL = 0,
    ALGSURF_PART_SINGULAR = 1
} algsurf_part;
ALGSURF_API algsurf_status algsurf_surface_enclose(const algsurf_surface *surface,
                                                   const algsurf_extent *extent, algsurf_part part,
                                                   double precision, double lo[3], double hi[3], int *empty);
#ifdef __cplusplus
}
#endif
#endif
