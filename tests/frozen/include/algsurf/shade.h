/* algsurf/shade.h - colour at a point of a surface: ambient, diffuse and specular light.
 *
 * Colours are red, green, blue, 0 = none, 1 = full, in display space (they are written to the picture
 * as they are, clamped; no gamma is applied).  Both sides of a surface are lit alike: the normal is
 * turned towards the viewer, and the side decides between two colours.
 */
#ifndef ALGSURF_SHADE_H
#define ALGSURF_SHADE_H
#include <stddef.h>

#include "algsurf/ray.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How a surface reflects light. */
typedef struct algsurf_material {
    size_t size;                       /* sizeof(algsurf_material) */
    double outside[3];                 /* colour where P grows towards the viewer (P > 0 in front) */
    double inside[3];                  /* colour of the other side */
    double ambient, diffuse, specular; /* weights, >= 0 */
    double shininess;                  /* Blinn-Phong exponent, > 0 */
} algsurf_material;

/* A light: a point, or a parallelogram of samples_u x samples_v points
 * position + (a/(samples_u-1) - 1/2) edge_u + (b/(samples_v-1) - 1/2) edge_v  (1 sample: the middle). */
typedef struct algsurf_light {
    double position[3];          /* of its middle, finite */
    double colour[3];            /* each >= 0 */
    double edge_u[3], edge_v[3]; /* of the parallelogram, finite */
    int samples_u, samples_v;    /* 1..64 each; 1, 1 is a point light */
} algsurf_light;

/* Position of sample (a,b) of a light, 0 <= a < samples_u, 0 <= b < samples_v.
 * Errors: E_ARGUMENT (also a colour below 0), E_NOT_FINITE (the light).  Since 1.0. */
ALGSURF_API algsurf_status algsurf_light_sample(const algsurf_light *light, int a, int b, double position[3]);

/* The colour seen along the unit direction at a point with the unit normal grad P / |grad P|.
 *   lights, count  may be null when count is 0
 *   visible        for each light the share of its samples that reach the point, 0..1; null: all 1
 *   colour         receives red, green, blue, each >= 0, not clamped above
 * The formula, its last sum over the lights l with N.L_l > 0:
 *     colour = base (ambient + diffuse sum_l visible_l colour_l max(0, N.L_l))
 *              + specular sum_l visible_l colour_l max(0, N.H_l)^shininess
 * N is the normal turned towards the viewer, base the colour of the side seen; L points to the light's
 * middle, H halves L and the direction to the viewer.
 * A zero normal (a singular point) is lit as if it faced the viewer.
 * Errors: E_ARGUMENT (null, negative colours or weights, shininess not positive, visible outside 0..1),
 * E_NOT_FINITE.  Cost: about 30 ns a light.  Source: Blinn 1977.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_shade(const algsurf_material *material, const algsurf_light *lights,
                                         int count, const double *visible, const double point[3],
                                         const double normal[3], const double direction[3], double colour[3]);

/* The colour without any illumination model: the base colour of the side seen, darker with the depth.
 *   depth  from 0, the end of the extent nearest to the viewer, to 1, the farthest: 0.3 as bright there
 * Errors: E_ARGUMENT (also a depth outside 0..1), E_NOT_FINITE.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_shade_preview(const algsurf_material *material, const double normal[3],
                                                 const double direction[3], double depth, double colour[3]);

#ifdef __cplusplus
}
#endif
#endif
