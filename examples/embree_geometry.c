/* embree_geometry.c - an algebraic surface as a user geometry of Embree 3, checked against single rays.
 *
 * The callbacks are the part to copy.  main traces the same rays through rtcIntersect1, 4, 8, 16 and
 * rtcOccluded1, 4, 8, 16 with flush-to-zero and denormals-are-zero on, as Embree's manual asks, over a floor
 * of two triangles, and compares every answer with algsurf_intersect_first.  A fifth of the rays start where
 * others hit the surface.  Exit status 1 if any answer differs.
 *
 * Rays that start on the surface need no epsilon, although floats put their origin some 1e-7 beside it: the
 * context that Embree hands on tells on which side each ray starts, by its id, and only hits from that side
 * count (options.side).
 *
 *     cc -O2 -I../include embree_geometry.c $(find ../lib -name "*.c") -lembree3 -lm -pthread
 */
#include <embree3/rtcore.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <xmmintrin.h>

#include "algsurf/algsurf.h"

/* ---- the user geometry ---- */

typedef struct user_surface {
    algsurf_surface *surface;
    algsurf_extent extent; /* a ball */
} user_surface;

/* What rtcIntersect and rtcOccluded are given. */
typedef struct user_context {
    struct RTCIntersectContext embree; /* the first member */
    const signed char *side; /* of the surface that the ray with that id starts on: -1, 1; 0: it does not */
} user_context;

enum { LANES = 16 }; /* rays that are handed on together */

/* Embree's rays are structures of arrays of N floats: ray.org_x[N], org_y[N], ... hit.Ng_x[N], ... */
enum { ORG = 0, TNEAR = 3, DIR = 4, TFAR = 8, ID = 10 };
enum { NG = 12, U = 15, V = 16, PRIM = 17, GEOM = 18, INST = 19 };

static void bounds(const struct RTCBoundsFunctionArguments *a) {
    const user_surface *s = a->geometryUserPtr;
    const double *c = s->extent.centre, r = s->extent.size[0];
    float lower[3], upper[3];
    for (int k = 0; k < 3; k++) { /* outward */
        lower[k] = nextafterf((float)(c[k] - r), -INFINITY);
        upper[k] = nextafterf((float)(c[k] + r), INFINITY);
    }
    *a->bounds_o = (struct RTCBounds){lower[0], lower[1], lower[2], 0, upper[0], upper[1], upper[2], 0};
}

/* At most LANES rays as doubles: those of N from `first` on; active are those that start on one side. */
typedef struct lanes {
    double org[3][LANES], dir[3][LANES], t_min[LANES], t_max[LANES];
    unsigned char active[LANES];
    int any;
    algsurf_intersect_options how;
    algsurf_ray_packet packet;
} lanes;

static void load(lanes *l, const float *ray, const int *valid, unsigned N, unsigned first,
                 const struct RTCIntersectContext *context, int side) {
    const signed char *sides = ((const user_context *)context)->side;
    const unsigned *id = (const unsigned *)ray + ID * N + first;
    unsigned count = N - first < LANES ? N - first : LANES;
    l->any = 0;
    for (unsigned i = 0; i < count; i++) {
        for (unsigned k = 0; k < 3; k++) {
            l->org[k][i] = ray[(ORG + k) * N + first + i];
            l->dir[k][i] = ray[(DIR + k) * N + first + i];
        }
        l->t_min[i] = ray[TNEAR * N + first + i];
        l->t_max[i] = ray[TFAR * N + first + i];
        l->any |= l->active[i] = valid[first + i] && sides[id[i]] == side;
    }
    l->how = (algsurf_intersect_options){.size = sizeof l->how, .side = side};
    l->packet = (algsurf_ray_packet){.size = sizeof l->packet,
                                     .count = count,
                                     .origin = {l->org[0], l->org[1], l->org[2]},
                                     .direction = {l->dir[0], l->dir[1], l->dir[2]},
                                     .t_min = l->t_min,
                                     .t_max = l->t_max,
                                     .active = l->active};
}

static void intersect_lanes(const struct RTCIntersectFunctionNArguments *a, unsigned first, int side) {
    const user_surface *s = a->geometryUserPtr;
    float *ray = (float *)a->rayhit;
    unsigned *id = (unsigned *)a->rayhit, N = a->N;
    lanes l;
    unsigned char state[LANES] = {ALGSURF_STATE_MISS}; /* as is 0 */
    double t[LANES], n[3][LANES];
    algsurf_hit_packet hits = {.size = sizeof hits, .state = state, .t = t, .normal = {n[0], n[1], n[2]}};
    load(&l, ray, a->valid, N, first, a->context, side);
    if (!l.any) return;
    (void)algsurf_intersect_packet(s->surface, &s->extent, &l.packet, &l.how,
                                   &hits); /* a bad ray is refused alone */
    for (unsigned i = 0, j = first; i < l.packet.count; i++, j++) {
        if (!l.active[i] || state[i] != ALGSURF_STATE_HIT) continue;
        ray[TFAR * N + j] = (float)t[i];
        for (unsigned k = 0; k < 3; k++) ray[(NG + k) * N + j] = (float)n[k][i];
        ray[U * N + j] = ray[V * N + j] = 0;
        id[PRIM * N + j] = a->primID;
        id[GEOM * N + j] = a->geomID;
        id[INST * N + j] = a->context->instID[0];
    }
}

static void intersect(const struct RTCIntersectFunctionNArguments *a) {
    for (unsigned first = 0; first < a->N; first += LANES)
        for (int side = -1; side <= 1; side++) intersect_lanes(a, first, side);
}

static void occluded_lanes(const struct RTCOccludedFunctionNArguments *a, unsigned first, int side) {
    const user_surface *s = a->geometryUserPtr;
    float *ray = (float *)a->ray;
    lanes l;
    unsigned char state[LANES] = {ALGSURF_STATE_MISS}; /* as is 0 */
    load(&l, ray, a->valid, a->N, first, a->context, side);
    if (!l.any) return;
    (void)algsurf_occluded_packet(s->surface, &s->extent, &l.packet, &l.how, state);
    for (unsigned i = 0; i < l.packet.count; i++)
        if (l.active[i] && state[i] == ALGSURF_STATE_HIT) ray[TFAR * a->N + first + i] = -INFINITY;
}

static void occluded(const struct RTCOccludedFunctionNArguments *a) {
    for (unsigned first = 0; first < a->N; first += LANES)
        for (int side = -1; side <= 1; side++) occluded_lanes(a, first, side);
}

static void attach_surface(RTCDevice device, RTCScene scene, user_surface *s, unsigned geomID) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, 1);
    rtcSetGeometryUserData(geometry, s);
    rtcSetGeometryBoundsFunction(geometry, bounds, NULL);
    rtcSetGeometryIntersectFunction(geometry, intersect);
    rtcSetGeometryOccludedFunction(geometry, occluded);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, geomID);
    rtcReleaseGeometry(geometry);
}

/* ---- the check ---- */

enum { RAYS = 1 << 14, MEMBERS = 20, FLOOR = 0, SURFACE = 1 };

static void attach_floor(RTCDevice device, RTCScene scene) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float *v =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 4);
    unsigned *index = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                              3 * sizeof(unsigned), 2);
    const float corners[12] = {-9, -9, -1, 9, -9, -1, -9, 9, -1, 9, 9, -1};
    const unsigned triangles[6] = {0, 1, 2, 1, 3, 2};
    memcpy(v, corners, sizeof corners);
    memcpy(index, triangles, sizeof triangles);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, FLOOR);
    rtcReleaseGeometry(geometry);
}

static float uniform(void) { /* in [-1,1): Knuth's linear congruential generator, from a fixed seed */
    static uint64_t state = 20050101;
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (float)(state >> 40) * 0x1p-23f - 1;
}

static struct RTCRayHit rays[RAYS], want[RAYS];
static signed char side[RAYS], left[RAYS]; /* where rays start; where they met the surface */

/* A ray towards the middle of things; every sixteenth has a subnormal component. */
static struct RTCRayHit make_ray(int number) {
    struct RTCRayHit r = {.ray = {.tfar = INFINITY, .mask = -1u, .id = (unsigned)number},
                          .hit = {.geomID = RTC_INVALID_GEOMETRY_ID}};
    r.ray.org_x = 5 * uniform();
    r.ray.org_y = 5 * uniform();
    r.ray.org_z = 3 + 2 * uniform();
    r.ray.dir_x = 1.5f * uniform() - r.ray.org_x;
    r.ray.dir_y = number % 16 ? 1.5f * uniform() - r.ray.org_y : 0x1p-140f;
    r.ray.dir_z = 1.5f * uniform() - r.ray.org_z;
    return r;
}

/* From where another ray met the surface: mirrored, and a little aside. */
static struct RTCRayHit make_next(int number, const struct RTCRayHit *last) {
    struct RTCRayHit r = make_ray(number);
    const struct RTCHit *h = &last->hit;
    const float *o = &last->ray.org_x, *d = &last->ray.dir_x, n[3] = {h->Ng_x, h->Ng_y, h->Ng_z};
    const float along = 2 * (d[0] * n[0] + d[1] * n[1] + d[2] * n[2]);
    for (int k = 0; k < 3; k++) {
        (&r.ray.org_x)[k] = o[k] + last->ray.tfar * d[k];
        (&r.ray.dir_x)[k] = d[k] - along * n[k] * (1 + 0.5f * uniform());
    }
    return r;
}

/* What single rays say: the floor alone from Embree, the surface, up to there, from the library. */
static struct RTCRayHit truth(RTCScene floor, const user_surface *s, struct RTCRayHit r) {
    const algsurf_intersect_options how = {.size = sizeof how, .side = side[r.ray.id]};
    user_context context = {.side = side};
    rtcInitIntersectContext(&context.embree);
    rtcIntersect1(floor, &context.embree, &r);
    const algsurf_ray ray = {{r.ray.org_x, r.ray.org_y, r.ray.org_z},
                             {r.ray.dir_x, r.ray.dir_y, r.ray.dir_z},
                             r.ray.tnear,
                             r.ray.tfar};
    algsurf_hit hit;
    if (algsurf_intersect_first(s->surface, &s->extent, &ray, &how, &hit) < 0) exit(1);
    if (hit.state == ALGSURF_STATE_MISS) return r;
    r.ray.tfar = (float)hit.t;
    left[r.ray.id] = (signed char)hit.side;
    r.hit = (struct RTCHit){.Ng_x = (float)hit.normal[0],
                            .Ng_y = (float)hit.normal[1],
                            .Ng_z = (float)hit.normal[2],
                            .geomID = SURFACE};
    return r;
}

/* Traces N rays of which some are not valid and hold anything. */
static void trace(RTCScene scene, const int *valid, unsigned N, int shadow, void *p) {
    user_context user = {.side = side};
    struct RTCIntersectContext *context = &user.embree;
    rtcInitIntersectContext(context);
    if (N == 1 && shadow) rtcOccluded1(scene, context, p);
    if (N == 1 && !shadow) rtcIntersect1(scene, context, p);
    if (N == 4 && shadow) rtcOccluded4(valid, scene, context, p);
    if (N == 4 && !shadow) rtcIntersect4(valid, scene, context, p);
    if (N == 8 && shadow) rtcOccluded8(valid, scene, context, p);
    if (N == 8 && !shadow) rtcIntersect8(valid, scene, context, p);
    if (N == 16 && shadow) rtcOccluded16(valid, scene, context, p);
    if (N == 16 && !shadow) rtcIntersect16(valid, scene, context, p);
}

static int agrees(const struct RTCRayHit *got, const struct RTCRayHit *wanted, int shadow) {
    int met = wanted->hit.geomID != RTC_INVALID_GEOMETRY_ID;
    if (shadow) return got->ray.tfar == (met ? -INFINITY : INFINITY);
    if (got->hit.geomID != wanted->hit.geomID) return 0;
    if (!met) return got->ray.tfar == INFINITY;
    return got->ray.tfar == wanted->ray.tfar && got->hit.Ng_x == wanted->hit.Ng_x &&
           got->hit.Ng_y == wanted->hit.Ng_y && got->hit.Ng_z == wanted->hit.Ng_z; /* the same bits */
}

/* All rays, N at a time; returns how many answers differ from those wanted. */
static int check(RTCScene scene, unsigned N, int shadow) {
    _Alignas(64) float packet[MEMBERS * LANES];
    _Alignas(64) int valid[LANES];
    int differ = 0;
    for (unsigned first = 0; first < RAYS; first += N) {
        for (unsigned i = 0; i < N; i++) {
            valid[i] = N > 1 && uniform() < -0.5f ? 0 : -1;
            for (unsigned m = 0; m < MEMBERS; m++)
                memcpy(&packet[m * N + i], (const float *)&rays[first + i] + m, sizeof(float));
            if (!valid[i]) packet[ORG * N + i] = packet[TFAR * N + i] = NAN;
        }
        trace(scene, valid, N, shadow, packet);
        for (unsigned i = 0; i < N; i++) {
            struct RTCRayHit got;
            for (unsigned m = 0; m < MEMBERS; m++)
                memcpy((float *)&got + m, &packet[m * N + i], sizeof(float));
            differ += valid[i] ? !agrees(&got, &want[first + i], shadow) : !isnan(got.ray.tfar);
        }
    }
    return differ;
}

int main(int argc, char **argv) {
    if (argc > 1) {
        fprintf(stderr, "%s: takes no arguments\n", argv[0]);
        return 2;
    }
    user_surface s = {.extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2, 0, 0}}};
    const char *barth = "4(a x^2 - y^2)(a y^2 - z^2)(a z^2 - x^2) = b (x^2 + y^2 + z^2 - 1)^2";
    const algsurf_constant constants[2] = {{"a", (3 + sqrt(5)) / 2}, {"b", 2 + sqrt(5)}};
    if (algsurf_surface_from_equation(barth, constants, 2, &s.surface, NULL) != ALGSURF_OK) return 1;

    _mm_setcsr(_mm_getcsr() | 0x8040u); /* flush to zero, denormals are zero */
    unsigned control = _mm_getcsr() & ~0x3fu;
    RTCDevice device = rtcNewDevice("threads=1");
    RTCScene scene = rtcNewScene(device), floor = rtcNewScene(device);
    attach_floor(device, floor);
    attach_floor(device, scene);
    attach_surface(device, scene, &s, SURFACE);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST); /* no ray slips past the edges of the bounds */
    rtcCommitScene(floor);
    rtcCommitScene(scene);

    int surface = 0, ground = 0, started = 0, stuck = 0, wrong = 0;
    for (int i = 0; i < RAYS; i++) {
        const int last = i - RAYS / 2;
        side[i] = last >= 0 ? left[last] : 0;
        rays[i] = side[i] ? make_next(i, &want[last]) : make_ray(i);
        want[i] = truth(floor, &s, rays[i]);
        started += side[i] != 0;
        stuck += side[i] != 0 && want[i].ray.tfar < 1e-4f;
        surface += want[i].hit.geomID == SURFACE;
        ground += want[i].hit.geomID == FLOOR;
    }
    printf("%d rays: %d hit the surface first, %d the floor\n", RAYS, surface, ground);
    printf("%d rays start on the surface: %d meet it there again\n", started, stuck);
    for (unsigned N = 1; N <= LANES; N = N == 1 ? 4 : 2 * N) {
        int hits = check(scene, N, 0), shadows = check(scene, N, 1);
        printf("%2u at a time: %d first hits and %d occlusions differ from single rays\n", N, hits, shadows);
        wrong += hits + shadows;
    }
    int kept = (_mm_getcsr() & ~0x3fu) == control;
    if (!kept) puts("the floating-point environment has changed");

    rtcReleaseScene(scene);
    rtcReleaseScene(floor);
    rtcReleaseDevice(device);
    algsurf_surface_free(s.surface);
    return wrong > 0 || !kept || surface < RAYS / 10 || ground < RAYS / 10 || started < RAYS / 10 ||
           stuck > 0;
}
