/* shade_impl.h - checks and the formulas without checks, for the rooms below shade. */
#ifndef ALGSURF_SHADE_IMPL_H
#define ALGSURF_SHADE_IMPL_H
#include "algsurf/shade.h"

#define ALGSURF_MAX_LIGHT_SAMPLES 64 /* along one edge */

/* Each: OK, E_ARGUMENT (null, out of range) or E_NOT_FINITE. */
algsurf_status algsurf_i_colour_check(const double colour[3]);
algsurf_status algsurf_i_material_read(const algsurf_material *given, algsurf_material *material);
algsurf_status algsurf_i_light_check(const algsurf_light *light);

/* The normal turned towards the viewer: facing = +-normal with facing.direction <= 0, or -direction for
 * a zero normal.  Returns 1 when the outside is seen. */
int algsurf_i_facing(const double normal[3], const double direction[3], double facing[3]);

/* The public functions for checked arguments, in the standard floating-point environment. */
void algsurf_i_light_sample(const algsurf_light *light, int a, int b, double position[3]);
void algsurf_i_shade(const algsurf_material *material, const algsurf_light *lights, int count,
                     const double *visible, const double point[3], const double normal[3],
                     const double direction[3], double colour[3]);
void algsurf_i_shade_preview(const algsurf_material *material, const double normal[3],
                             const double direction[3], double depth, double colour[3]);

#endif
