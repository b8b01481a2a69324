#ifndef ALGSURF_SHADE_H
#define ALGSURF_SHADE_H
#include <stddef.h>
#include "algsurf/ray.h"
#ifdef __cplusplus
extern "C" {
#endif
#define ALGSURF_MAX_LIGHTS 16
typedef struct algsurf_material {
    size_t size;
    double outside[3];
    double inside[3];
    double diffuse;
    double ambient;
    double fill;
    double specular;
    double roughness;
    double haze;
} algsurf_material;
typedef enum algsurf_light_kind {
    ALGSURF_LIGHT_AREA = 0
} algsurf_light_kind;
typedef struct algsurf_light {
    double position[3];
    double colour[3];
    double edge_u[3], edge_v[3];
    int samples_u, samples_v;
    int kind;
    double reserved[8];
} algsurf_light;
typedef struct algsurf_lighting {
    size_t size;
    const algsurf_material *material;
    const algsurf_light *lights;
    size_t light_count;
    double up[3], forward[3];
    double centre[3], radius;
    int bounded;
} algsurf_lighting;
ALGSURF_API algsurf_status algsurf_light_sample(const algsurf_light *light, int a, int b, double position[3]);
ALGSURF_API algsurf_status algsurf_shade(const algsurf_lighting *lighting, const double *visible,
                                         const double point[3], const double normal[3],
                                         const double direction[3], double colour[3]);
ALGSURF_API algsurf_status algsurf_shade_preview(const algsurf_lighting *lighting, const double point[3],
                                                 const double normal[3], const double direction[3],
                                                 double colour[3]);
ALGSURF_API algsurf_status algsurf_srgb_encode(const double colour[3], unsigned char bytes[3]);
ALGSURF_API algsurf_status algsurf_srgb_decode(const unsigned char bytes[3], double colour[3]);
#ifdef __cplusplus
}
#endif
#endif
