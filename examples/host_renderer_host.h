/* host_renderer_host.h - what this small renderer asks of everything it draws.
 *
 * The callbacks have the shapes of Embree's user geometries (RTCBoundsFunction, RTCIntersectFunctionN,
 * RTCOccludedFunctionN) with doubles for floats: rays come N at a time as structure of arrays, and `valid`
 * tells which of them are meant.
 */
#ifndef HOST_RENDERER_HOST_H
#define HOST_RENDERER_HOST_H
#include "algsurf/algsurf.h"

enum { HOST_MAX_RAYS = 64, HOST_MAX_GEOMETRIES = 8, HOST_NONE = -1 };

typedef struct host_rays {
    double org[3][HOST_MAX_RAYS], dir[3][HOST_MAX_RAYS];
    double tnear[HOST_MAX_RAYS];
    double tfar[HOST_MAX_RAYS];   /* the end; then where the ray hit, or -inf when it is occluded */
    double Ng[3][HOST_MAX_RAYS];  /* unit normal at the hit, on either side */
    int geomID[HOST_MAX_RAYS];    /* what was hit, or HOST_NONE */
    int side[HOST_MAX_RAYS];      /* of a surface that was hit, the side the ray came from: the sign of P */
    int from[HOST_MAX_RAYS];      /* what the ray starts on, or HOST_NONE */
    int from_side[HOST_MAX_RAYS]; /* on which side of it: the `side` of that hit */
} host_rays;

typedef struct host_arguments {
    const int *valid; /* -1: look at this ray; 0: leave it alone */
    const void *user;
    host_rays *rays;
    int N, geomID;
} host_arguments;

typedef struct host_bounds {
    double lower[3], upper[3];
} host_bounds;

typedef struct host_material {
    double front[3], back[3]; /* colours of the side Ng points to and of the other */
    double mirror;            /* share of light mirrored at right angles, 0..1; more when it grazes */
    int chequered;            /* every other unit square seen from above is in `back` */
} host_material;

typedef struct host_geometry {
    const void *user;
    void (*bounds)(const void *user, host_bounds *bounds);
    void (*intersect)(const host_arguments *arguments);
    void (*occluded)(const host_arguments *arguments);
    host_material material;
    double lift; /* how far above a hit on it a new ray starts; 0 if it uses `from` instead */
} host_geometry;

typedef struct host_scene {
    host_geometry geometry[HOST_MAX_GEOMETRIES];
    host_bounds bounds[HOST_MAX_GEOMETRIES]; /* host_commit fills them */
    int count;
    algsurf_light light;
} host_scene;

/* ---- host_renderer_surface.c: an algebraic surface as such a geometry ---- */

typedef struct host_surface {
    algsurf_surface *surface;
    algsurf_extent extent; /* a ball */
    int cut;               /* 1: what lies in the box `removed` is not there */
    host_bounds removed;
} host_surface;

host_geometry host_surface_geometry(const host_surface *surface, const host_material *material);

/* ---- host_renderer_shapes.c: what the renderer knows by itself ---- */

typedef struct host_ball {
    double centre[3], radius;
} host_ball;

typedef struct host_floor { /* a disc about the z axis */
    double height, radius;
} host_floor;

host_geometry host_ball_geometry(const host_ball *ball, const host_material *material);
host_geometry host_floor_geometry(const host_floor *ground, const host_material *material);

/* ---- host_renderer_trace.c ---- */

/* Ray i, from org along dir until t = tfar; it starts on nothing, and has hit nothing yet. */
void host_set_ray(host_rays *rays, int i, const double org[3], const double dir[3], double tfar);

void host_commit(host_scene *scene);

/* The light that comes along N rays; sample (a,b) of the light is the one that shines. */
void host_trace(const host_scene *scene, host_rays *rays, const int *valid, int N, int a, int b, int depth,
                double colour[][3]);

#endif
