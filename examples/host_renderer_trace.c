/* host_renderer_trace.c - Whitted's ray tracing, N rays at a time: hit, shadow, mirror.
 *
 * A new ray starts at a hit on the side it was seen from: a little above it where the geometry has a lift,
 * else exactly there, and the ray tells the geometry what it starts on.
 */
#include <math.h>
#include <string.h>

#include "host_renderer_host.h"

static const double AMBIENT = 0.25, SHINE = 0.6;

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

void host_set_ray(host_rays *r, int i, const double org[3], const double dir[3], double tfar) {
    for (int k = 0; k < 3; k++) {
        r->org[k][i] = org[k];
        r->dir[k][i] = dir[k];
    }
    r->tnear[i] = 0;
    r->tfar[i] = tfar;
    r->geomID[i] = r->from[i] = HOST_NONE;
}

/* ---- which geometries a ray may meet, and what comes of it ---- */

void host_commit(host_scene *scene) {
    for (int g = 0; g < scene->count; g++)
        scene->geometry[g].bounds(scene->geometry[g].user, &scene->bounds[g]);
}

static int meets(const host_bounds *box, const host_rays *r, int i) {
    double in = r->tnear[i], out = r->tfar[i];
    for (int k = 0; k < 3; k++) {
        double p = (box->lower[k] - r->org[k][i]) / r->dir[k][i];
        double q = (box->upper[k] - r->org[k][i]) / r->dir[k][i];
        in = fmax(in, fmin(p, q)); /* fmin, fmax: 0/0, within a face, is no limit */
        out = fmin(out, fmax(p, q));
    }
    return in <= out * (1 + 0x1p-48); /* a ball touches its box: room for rounding */
}

/* Calls one callback of every geometry whose bounds some ray meets, for those rays. */
static void visit(const host_scene *scene, host_rays *rays, const int *valid, int N, int shadow) {
    for (int g = 0; g < scene->count; g++) {
        int near[HOST_MAX_RAYS], any = 0;
        for (int i = 0; i < N; i++) any |= near[i] = -(valid[i] && meets(&scene->bounds[g], rays, i));
        if (!any) continue;
        const host_geometry *geometry = &scene->geometry[g];
        const host_arguments arguments = {near, geometry->user, rays, N, g};
        (shadow ? geometry->occluded : geometry->intersect)(&arguments);
    }
}

/* ---- shading ---- */

typedef struct hit {
    double dir[3];                        /* of the ray */
    double point[3], start[3], normal[3]; /* start: of new rays; normal: to the viewer's side */
    int geomID, side;
    double base[3], mirror;
} hit;

static void sky(double height, double colour[3]) {
    const double low[3] = {0.86, 0.84, 0.82}, high[3] = {0.10, 0.22, 0.50};
    double w = sqrt(fmax(height, 0));
    for (int k = 0; k < 3; k++) colour[k] = low[k] + w * (high[k] - low[k]);
}

static hit hit_of(const host_scene *scene, const host_rays *r, int i) {
    const host_geometry *geometry = &scene->geometry[r->geomID[i]];
    const host_material *m = &geometry->material;
    hit h = {.dir = {r->dir[0][i], r->dir[1][i], r->dir[2][i]}, .geomID = r->geomID[i], .side = r->side[i]};
    double n[3] = {r->Ng[0][i], r->Ng[1][i], r->Ng[2][i]};
    double cosine = -dot(n, h.dir);
    int back = cosine < 0;
    for (int k = 0; k < 3; k++) {
        h.point[k] = r->org[k][i] + r->tfar[i] * h.dir[k];
        h.normal[k] = dot(n, n) == 0 ? -h.dir[k] : back ? -n[k] : n[k]; /* a singular point has no normal */
        h.start[k] = h.point[k] + geometry->lift * h.normal[k];
    }
    if (m->chequered) back = ((int)floor(h.point[0]) + (int)floor(h.point[1])) & 1;
    memcpy(h.base, back ? m->back : m->front, sizeof h.base);
    h.mirror = m->mirror + (1 - m->mirror) * pow(1 - fmin(fabs(cosine), 1), 5); /* Schlick 1994 */
    return h;
}

/* Ray i, which goes on from a hit. */
static void go_on(const hit *h, host_rays *r, int i, const double dir[3], double tfar) {
    host_set_ray(r, i, h->start, dir, tfar);
    r->from[i] = h->geomID;
    r->from_side[i] = h->side;
}

/* What is seen along ray i without light from the lamp, and the ray to it; 0 when nothing is hit. */
static int begin(const host_scene *scene, const host_rays *rays, int i, const double lamp[3], hit *h,
                 host_rays *to_lamp, double colour[3]) {
    sky(rays->dir[2][i], colour);
    if (rays->geomID[i] == HOST_NONE) return 0;
    *h = hit_of(scene, rays, i);
    double dir[3];
    for (int k = 0; k < 3; k++) {
        colour[k] = AMBIENT * h->base[k] * (0.75 + 0.25 * h->normal[2]);
        dir[k] = lamp[k] - h->start[k];
    }
    go_on(h, to_lamp, i, dir, 1);
    return 1;
}

/* Adds light that comes straight from the lamp. */
static void shine(const host_scene *scene, const hit *h, const host_rays *to_lamp, int i, double colour[3]) {
    double l[3] = {to_lamp->dir[0][i], to_lamp->dir[1][i], to_lamp->dir[2][i]}, half[3];
    double length = sqrt(dot(l, l));
    for (int k = 0; k < 3; k++) half[k] = l[k] / length - h->dir[k];
    double diffuse = dot(h->normal, l) / length;
    double gloss = SHINE * pow(fmax(dot(h->normal, half), 0) / sqrt(dot(half, half)), 90);
    for (int k = 0; k < 3; k++) colour[k] += scene->light.colour[k] * (h->base[k] * diffuse + gloss);
}

void host_trace(const host_scene *scene, host_rays *rays, const int *valid, int N, int a, int b, int depth,
                double colour[][3]) {
    hit hits[HOST_MAX_RAYS];
    host_rays next;
    int lit[HOST_MAX_RAYS] = {0}, mirrored[HOST_MAX_RAYS] = {0}, mirrors = 0;
    double lamp[3], seen[HOST_MAX_RAYS][3];
    (void)algsurf_light_sample(&scene->light, a, b, lamp);
    visit(scene, rays, valid, N, 0);
    for (int i = 0; i < N; i++) {
        if (!valid[i] || !begin(scene, rays, i, lamp, &hits[i], &next, colour[i])) continue;
        double to_lamp[3] = {next.dir[0][i], next.dir[1][i], next.dir[2][i]};
        lit[i] = -(dot(hits[i].normal, to_lamp) > 0);
        mirrors |= mirrored[i] = -(depth > 0 && hits[i].mirror > 0);
    }
    visit(scene, &next, lit, N, 1);
    for (int i = 0; i < N; i++) {
        const hit *h = &hits[i];
        if (lit[i] && next.tfar[i] > 0) shine(scene, h, &next, i, colour[i]);
        if (!mirrored[i]) continue;
        double along = 2 * dot(h->dir, h->normal), away[3];
        for (int k = 0; k < 3; k++) away[k] = h->dir[k] - along * h->normal[k];
        go_on(h, &next, i, away, INFINITY);
    }
    if (!mirrors) return;
    host_trace(scene, &next, mirrored, N, a, b, depth - 1, seen);
    for (int i = 0; i < N; i++)
        for (int k = 0; mirrored[i] && k < 3; k++)
            colour[i][k] += hits[i].mirror * (seen[i][k] - colour[i][k]);
}
