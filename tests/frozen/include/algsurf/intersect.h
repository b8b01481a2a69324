#ifndef ALGSURF_INTERSECT_H
#define ALGSURF_INTERSECT_H
#include "algsurf/observe.h"
#include "algsurf/ray.h"
#include "algsurf/refine.h"
#include "algsurf/select.h"
#include "algsurf/surface.h"
#ifdef __cplusplus
extern "C" {
#endif
typedef enum algsurf_tier {
    ALGSURF_TIER_CERTIFIED = 0,
    ALGSURF_TIER_BOUNDED = 1
} algsurf_tier;
typedef enum algsurf_undecided_as {
    ALGSURF_AS_UNDECIDED = 0,
    ALGSURF_AS_HIT = 1,
    ALGSURF_AS_MISS = 2
} algsurf_undecided_as;
typedef enum algsurf_hit_state {
    ALGSURF_STATE_MISS = 0,
    ALGSURF_STATE_HIT = 1,
    ALGSURF_STATE_UNDECIDED = 2,
    ALGSURF_STATE_THIN = 3,
    ALGSURF_STATE_REFUSED = 4
} algsurf_hit_state;
typedef struct algsurf_hit {
    int state;
    int reason;
    int multiplicity;
    int side;
    double t;
    double t_lo, t_hi;
    double position[3];
    double normal[3];
} algsurf_hit;
typedef struct algsurf_intersect_options {
    size_t size;
    int tier;
    int method;
    int max_iterations;
    double absolute_tolerance;
    const char *kernel;
    int undecided_as;
    size_t max_memory;
    algsurf_observer *observer;
    const algsurf_plane *planes;
    size_t plane_count;
    int side;
} algsurf_intersect_options;
#define ALGSURF_DEFAULT_MEMORY ((size_t)1 << 30)
ALGSURF_API const char *algsurf_kernel_name(int index);
ALGSURF_API algsurf_status algsurf_intersect_first(const algsurf_surface *surface,
                                                   const algsurf_extent *extent, const algsurf_ray *ray,
                                                   const algsurf_intersect_options *options,
                                                   algsurf_hit *hit);
ALGSURF_API algsurf_status algsurf_intersect_all(const algsurf_surface *surface, const algsurf_extent *extent,
                                                 const algsurf_ray *ray,
                                                 const algsurf_intersect_options *options, algsurf_hit *hits,
                                                 int capacity, int *count);
ALGSURF_API algsurf_status algsurf_occluded(const algsurf_surface *surface, const algsurf_extent *extent,
                                            const algsurf_ray *ray, const algsurf_intersect_options *options,
                                            int *state);
ALGSURF_API algsurf_status algsurf_hit_leave(const algsurf_surface *surface, const algsurf_ray *ray,
                                             const algsurf_hit *hit, int side, double start[3]);
typedef struct algsurf_ray_packet {
    size_t size;
    size_t count;
    const double *origin[3], *direction[3];
    const double *t_min, *t_max;
    const unsigned char *active;
    ptrdiff_t step;
    const float *float_origin[3], *float_direction[3];
    const float *float_t_min, *float_t_max;
} algsurf_ray_packet;
typedef struct algsurf_hit_packet {
    size_t size;
    unsigned char *state;
    double *t, *t_lo, *t_hi;
    double *position[3], *normal[3];
    int *multiplicity;
    signed char *side, *reason;
} algsurf_hit_packet;
ALGSURF_API algsurf_status algsurf_intersect_packet(const algsurf_surface *surface,
                                                    const algsurf_extent *extent,
                                                    const algsurf_ray_packet *rays,
                                                    const algsurf_intersect_options *options,
                                                    const algsurf_hit_packet *hits);
ALGSURF_API algsurf_status algsurf_occluded_packet(const algsurf_surface *surface,
                                                   const algsurf_extent *extent,
                                                   const algsurf_ray_packet *rays,
                                                   const algsurf_intersect_options *options,
                                                   unsigned char *state);
typedef struct algsurf_complex_space {
    size_t size;
    algsurf_sector sector;
    const double *imaginary;
    size_t imaginary_count;
} algsurf_complex_space;
ALGSURF_API algsurf_status algsurf_intersect_complex(const algsurf_surface *surface,
                                                     const algsurf_extent *extent, const algsurf_ray *ray,
                                                     const algsurf_complex_space *space,
                                                     const algsurf_complex *start, algsurf_complex *roots,
                                                     algsurf_hit *hit, algsurf_complex *root);
#ifdef __cplusplus
}
#endif
#endif
