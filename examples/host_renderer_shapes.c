/* host_renderer_shapes.c - balls and the floor: see host_renderer_host.h. */
#include <math.h>

#include "host_renderer_host.h"

/* Where ray i meets a shape within [tnear,tfar], with the normal there; 0: nowhere. */
typedef int shape(const void *user, const host_rays *r, int i, double *t, double normal[3]);

static int meet_ball(const void *user, const host_rays *r, int i, double *t, double normal[3]) {
    const host_ball *ball = user;
    double dd = 0, od = 0, oo = -ball->radius * ball->radius;
    for (int k = 0; k < 3; k++) {
        double o = r->org[k][i] - ball->centre[k], d = r->dir[k][i];
        dd += d * d;
        od += o * d;
        oo += o * o;
    }
    double root = sqrt(od * od - dd * oo); /* NaN: beside the ball */
    *t = (-od - root) / dd;
    if (!(*t >= r->tnear[i])) *t = (-od + root) / dd;
    if (!(*t >= r->tnear[i] && *t <= r->tfar[i])) return 0;
    for (int k = 0; k < 3; k++)
        normal[k] = (r->org[k][i] + *t * r->dir[k][i] - ball->centre[k]) / ball->radius;
    return 1;
}

static int meet_floor(const void *user, const host_rays *r, int i, double *t, double normal[3]) {
    const host_floor *ground = user;
    *t = (ground->height - r->org[2][i]) / r->dir[2][i];
    if (!(*t >= r->tnear[i] && *t <= r->tfar[i])) return 0;
    normal[0] = normal[1] = 0;
    normal[2] = 1;
    return hypot(r->org[0][i] + *t * r->dir[0][i], r->org[1][i] + *t * r->dir[1][i]) <= ground->radius;
}

static void intersect(const host_arguments *a, shape *meet) {
    for (int i = 0; i < a->N; i++) {
        double t, normal[3];
        if (!a->valid[i] || !meet(a->user, a->rays, i, &t, normal)) continue;
        a->rays->tfar[i] = t;
        for (int k = 0; k < 3; k++) a->rays->Ng[k][i] = normal[k];
        a->rays->geomID[i] = a->geomID;
    }
}

static void occluded(const host_arguments *a, shape *meet) {
    double t, normal[3];
    for (int i = 0; i < a->N; i++)
        if (a->valid[i] && meet(a->user, a->rays, i, &t, normal)) a->rays->tfar[i] = -INFINITY;
}

static void ball_intersect(const host_arguments *a) { intersect(a, meet_ball); }
static void ball_occluded(const host_arguments *a) { occluded(a, meet_ball); }
static void floor_intersect(const host_arguments *a) { intersect(a, meet_floor); }
static void floor_occluded(const host_arguments *a) { occluded(a, meet_floor); }

static void ball_bounds(const void *user, host_bounds *b) {
    const host_ball *ball = user;
    for (int k = 0; k < 3; k++) {
        b->lower[k] = ball->centre[k] - ball->radius;
        b->upper[k] = ball->centre[k] + ball->radius;
    }
}

static void floor_bounds(const void *user, host_bounds *b) {
    const host_floor *f = user;
    *b = (host_bounds){{-f->radius, -f->radius, f->height}, {f->radius, f->radius, f->height}};
}

/* Above the tangent plane: a point that rounding has put below it would cover itself for every ray that
 * leaves at a low angle, whatever its tnear.  A millionth of a unit is invisible. */
static const double LIFT = 1e-6;

host_geometry host_ball_geometry(const host_ball *ball, const host_material *material) {
    return (host_geometry){ball, ball_bounds, ball_intersect, ball_occluded, *material, LIFT};
}

host_geometry host_floor_geometry(const host_floor *ground, const host_material *material) {
    return (host_geometry){ground, floor_bounds, floor_intersect, floor_occluded, *material, LIFT};
}
