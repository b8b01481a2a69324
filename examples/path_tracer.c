/* path_tracer.c - a path tracer on top of the library: Barth's sextic, cut by a ball, as glass over a
 * chequered floor.  It shows how rays go on from where they hit.
 *
 * No epsilon.  A ray that goes on starts exactly at the position of the hit, which rounding may have put on
 * either side of the surface.  It says which hits count instead: in the air P < 0, in the glass P > 0, so in
 * the air only hits before which P < 0 (options.side = -1), in the glass only those before which P > 0.
 *
 * A capped solid.  The glass is where P >= 0 inside the ball.  A ray from outside is in the glass at once if
 * P > 0 where it enters the ball, which the first hit, or the miss, tells by its side.  A ray in the glass
 * that meets nothing more leaves through the ball.
 *
 *     path_tracer [WIDTHxHEIGHT [SAMPLES [FILE]]]      default: 320x240 16 path_tracer.png
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "algsurf/algsurf.h"
#include "image.h"

#define EQUATION "4(p^2x^2-y^2)(p^2y^2-z^2)(p^2z^2-x^2) - (1+2p)(x^2+y^2+z^2-1)^2" /* p: the golden ratio */
#define RADIUS 1.75
#define FLOOR (-1.9)
#define INDEX 1.5 /* of refraction */
enum { MOST_BOUNCES = 24, MOST_SAMPLES = 1000000 };

/* Where a path is: a point, a direction of unit length, and what it goes through. */
typedef struct path {
    algsurf_ray ray;
    double light[3];                                /* what of each colour is left */
    enum { OUTSIDE, IN_AIR, IN_GLASS, AWAY } place; /* before the ball; in it; away from it for good */
    uint64_t random;
} path;

static algsurf_surface *sextic;
static const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {RADIUS, 0, 0}};
static unsigned long rays, self_hits;

static void check(algsurf_status status) {
    if (status == ALGSURF_OK) return;
    fprintf(stderr, "path_tracer: %s\n", algsurf_status_text(status));
    exit(1);
}

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* splitmix64: the same numbers for a pixel's sample, whoever draws it. */
static double random_unit(path *p) {
    uint64_t z = p->random += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9, z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return (double)((z ^ z >> 31) >> 11) * 0x1p-53;
}

/* ---- geometry ---- */

/* The next point of the glass's surface, its normal towards the air; 0: none. */
static int next_point(const path *p, double point[3], double normal[3]) {
    const algsurf_intersect_options how = {.size = sizeof how,
                                           .side = p->place == IN_AIR     ? -1
                                                   : p->place == IN_GLASS ? 1
                                                                          : 0};
    algsurf_hit hit;
    algsurf_ray chord = p->ray;
    int meets = 0, capped;
    check(algsurf_intersect_first(sextic, &ball, &p->ray, &how, &hit));
    rays++;
    self_hits += p->place != OUTSIDE && hit.state == ALGSURF_STATE_HIT && hit.t < 1e-9;
    capped = p->place == OUTSIDE ? hit.side > 0 : p->place == IN_GLASS && hit.state == ALGSURF_STATE_MISS;
    if (capped) { /* where the ray enters or leaves the ball */
        check(algsurf_ray_clip(&p->ray, &ball, NULL, 0, &chord, &meets));
        double t = p->place == OUTSIDE ? chord.t_min : chord.t_max;
        for (int i = 0; meets && i < 3; i++) {
            point[i] = p->ray.origin[i] + t * p->ray.direction[i];
            normal[i] = point[i] / RADIUS;
        }
        return meets;
    }
    for (int i = 0; i < 3; i++) point[i] = hit.position[i], normal[i] = -hit.normal[i]; /* P falls there */
    return hit.state == ALGSURF_STATE_HIT;
}

/* ---- light ---- */

/* The sky is light above, and there is a wide soft sun; the direction is of unit length. */
static void sky(const double d[3], double colour[3]) {
    static const double sun[3] = {0.48, -0.36, 0.8};
    const double up = fmax(0, d[2]), glow = pow(fmax(0, dot(d, sun)), 60);
    colour[0] = 0.85 - 0.55 * up + 5 * glow;
    colour[1] = 0.92 - 0.42 * up + 4.6 * glow;
    colour[2] = 1.00 - 0.22 * up + 4 * glow;
}

/* Fresnel's share of light that is reflected, unpolarised; *cosine: that of the refracted ray. */
static double reflected(double cosine_in, double ratio, double *cosine) {
    const double square = 1 - ratio * ratio * (1 - cosine_in * cosine_in);
    if (square <= 0) return 1;
    *cosine = sqrt(square);
    const double s = (ratio * cosine_in - *cosine) / (ratio * cosine_in + *cosine);
    const double t = (cosine_in - ratio * *cosine) / (cosine_in + ratio * *cosine);
    return 0.5 * (s * s + t * t);
}

/* At a point of the glass: reflected or refracted, by chance. */
static void meet_glass(path *p, const double point[3], const double normal[3]) {
    static const double absorption[3] = {0.55, 0.16, 0.10}; /* for each unit of length */
    double *d = p->ray.direction, away[3], n[3], cosine = 1, length = 0, square = dot(point, point);
    const int in_glass = p->place == IN_GLASS, at_cap = square > RADIUS * RADIUS * (1 - 1e-9);
    for (int i = 0; i < 3; i++) {
        away[i] = point[i] - p->ray.origin[i];
        n[i] = in_glass ? -normal[i] : normal[i]; /* towards where the ray comes from */
    }
    length = sqrt(dot(away, away));
    for (int i = 0; in_glass && i < 3; i++) p->light[i] *= exp(-absorption[i] * length);
    const double cosine_in = fmin(1, fmax(0, -dot(d, n))), ratio = in_glass ? INDEX : 1 / INDEX;
    const int mirrored = random_unit(p) < reflected(cosine_in, ratio, &cosine);
    for (int i = 0; i < 3; i++) {
        d[i] = mirrored ? d[i] + 2 * cosine_in * n[i] : ratio * d[i] + (ratio * cosine_in - cosine) * n[i];
        p->ray.origin[i] = point[i];
    }
    const double size = sqrt(dot(d, d));
    for (int i = 0; i < 3; i++) d[i] /= size;
    p->place = in_glass == mirrored ? IN_GLASS : at_cap ? AWAY : IN_AIR;
}

/* Past the ball: the floor, from which light goes anywhere above it, or the sky; 0: the path ends. */
static int meet_world(path *p, double colour[3]) {
    double *d = p->ray.direction, *o = p->ray.origin, light[3];
    if (d[2] >= 0 || o[2] <= FLOOR) {
        sky(d, light);
        for (int i = 0; i < 3; i++) colour[i] += p->light[i] * light[i];
        return 0;
    }
    const double t = (FLOOR - o[2]) / d[2], x = o[0] + t * d[0], y = o[1] + t * d[1];
    const int dark = fmod(floor(x) + floor(y), 2) != 0; /* far away no integer holds them */
    const double fade = exp(-0.0035 * (x * x + y * y)), grey = dark ? 0.62 - 0.4 * fade : 0.62 + 0.18 * fade;
    for (int i = 0; i < 3; i++) p->light[i] *= grey;
    const double r = sqrt(random_unit(p)), angle = 6.283185307179586 * random_unit(p);
    *o = x, o[1] = y, o[2] = FLOOR;
    *d = r * cos(angle), d[1] = r * sin(angle), d[2] = sqrt(fmax(0, 1 - r * r));
    p->place = OUTSIDE;
    return 1;
}

static void follow(path *p, double colour[3]) {
    double point[3], normal[3];
    for (int bounce = 0; bounce < MOST_BOUNCES; bounce++) {
        if (p->place != AWAY && next_point(p, point, normal))
            meet_glass(p, point, normal);
        else if (!meet_world(p, colour))
            return;
    }
}

/* ---- a picture ---- */

static uint8_t byte_of(double light) { /* a soft shoulder, then sRGB's gamma, nearly */
    const double shown = 1 - exp(-1.15 * light);
    return (uint8_t)(255 * pow(shown, 1 / 2.2) + 0.5);
}

static void draw(int width, int height, int samples, uint8_t *pixels) {
    const double eye[3] = {5.2, -4.4, 1.5}, middle[3] = {0, 0, -0.28}, up[3] = {0, 0, 1};
    algsurf_camera camera;
    check(algsurf_camera_pinhole(eye, middle, up, 36, &camera));
    for (int k = 0; k < width * height; k++) {
        double colour[3] = {0, 0, 0};
        for (int s = 0; s < samples; s++) {
            path p = {.light = {1, 1, 1}, .place = OUTSIDE};
            p.random = ((uint64_t)k << 32) + (uint64_t)s * 0x2545f4914f6cdd1d;
            const double x = k % width + random_unit(&p), y = k / width + random_unit(&p);
            check(algsurf_camera_ray(&camera, width, height, x, y, &p.ray));
            const double size = sqrt(dot(p.ray.direction, p.ray.direction));
            for (int i = 0; i < 3; i++) p.ray.direction[i] /= size;
            follow(&p, colour);
        }
        for (int i = 0; i < 3; i++) pixels[3 * k + i] = byte_of(colour[i] / samples);
    }
}

int main(int argc, char **argv) {
    const double golden = 0.5 + sqrt(1.25);
    const algsurf_constant p = {"p", golden};
    const char *name = argc > 3 ? argv[3] : "path_tracer.png";
    const long samples = argc > 2 ? strtol(argv[2], NULL, 10) : 16;
    int width = 320, height = 240;
    if (argc > 4 || (argc > 1 && sscanf(argv[1], "%5dx%5d", &width, &height) != 2) || width < 1 ||
        height < 1 || width > 4096 || height > 4096 || samples < 1 || samples > MOST_SAMPLES) {
        fprintf(stderr, "usage: path_tracer [WIDTHxHEIGHT [SAMPLES [FILE.png]]]\n");
        return 2;
    }
    uint8_t *pixels = malloc((size_t)width * (size_t)height * 3);
    if (!pixels) check(ALGSURF_E_NO_MEMORY);
    check(algsurf_surface_from_equation(EQUATION, &p, 1, &sextic, NULL));
    draw(width, height, (int)samples, pixels);
    FILE *file = fopen(name, "wb");
    const char *wrong = file ? image_write(file, IMAGE_PNG, width, height, pixels) : "cannot be written";
    if (file && (ferror(file) | fclose(file)) && !wrong) wrong = "cannot be written";
    if (wrong) fprintf(stderr, "path_tracer: %s: %s\n", name, wrong);
    printf("%lu rays, %lu met where they started\n", rays, self_hits);
    algsurf_surface_free(sextic);
    free(pixels);
    return wrong ? 1 : 0;
}
