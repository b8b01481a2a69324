/* ledger.c - the tasks of the ledger in lib/README.md, each timed by itself: ledger [--kernel NAME] TASK...
 *
 * Prints a line for each task: its name, and nanoseconds of CPU time for a pixel, a ray or a polynomial, the
 * least of some takes.  The script bench/ledger runs it in turn with one of a library without a mechanism.
 * TASK is KIND/WHAT: a kind of the table below, and a surface of the catalogue or a family of polynomials.
 * The kernel is for pictures, rays and batches; calls for one polynomial take the fastest.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "measure.h"
#include "must.h"
#include "rays.h"

static const double BUDGET = 0.1; /* seconds for a task */
enum { RAYS = 4096, POLYNOMIALS = 512, ROOM = 160 };

static const char *kernel; /* null: the fastest */

static const catalogue_entry *entry_of(const char *name) {
    const catalogue_entry *entry = catalogue_find(name);
    if (!entry) cli_fail(CLI_BAD_INPUT, "no surface %s", name);
    return entry;
}

/* The least seconds of a call of work(data), again and again for BUDGET seconds, twice at least. */
static double least_of(void (*work)(void *data), void *data) {
    double least = HUGE_VAL, begun = measure_cpu();
    for (int takes = 0; takes < 2 || measure_cpu() - begun < BUDGET; takes++) {
        const double before = measure_cpu();
        work(data);
        least = fmin(least, measure_cpu() - before);
    }
    return least;
}

/* ---- pictures ---- */

enum { PLAIN, WIDE, SMALL, ANTIALIAS, FULL, COMPLEX };

typedef struct studio {
    algsurf_scene *scene;
    algsurf_render_options options;
    algsurf_picture planes;
} studio;

static void render(void *data) {
    const studio *s = data;
    must_answer(algsurf_render(s->scene, &s->options, &s->planes, NULL), "picture");
}

static double time_picture(const char *name, int kind) {
    const catalogue_entry *entry = entry_of(name);
    const algsurf_complex_space space = {.size = sizeof space, .sector = {0.2, 0.5}};
    const algsurf_intersect_options how = {.size = sizeof how, .kernel = kernel};
    const int width = kind == WIDE      ? 3840
                      : kind == COMPLEX ? 320
                                        : 640,
              height = kind == WIDE      ? 2160
                       : kind == COMPLEX ? 240
                                         : 480;
    const size_t pixels = (size_t)width * (size_t)height;
    algsurf_camera camera = rays_camera(&entry->extent);
    if (kind == SMALL) camera.half_height *= 2.5;
    algsurf_surface *surface = rays_surface(entry);
    algsurf_scene *scene = rays_scene(surface, &entry->extent, &camera);
    uint8_t *bytes = must_allocate(3 * pixels, 1);
    must_answer(algsurf_scene_set_intersect_options(scene, &how), name);
    if (kind == FULL) must_answer(algsurf_scene_set_quality(scene, ALGSURF_QUALITY_FULL), name);
    if (kind == COMPLEX) must_answer(algsurf_scene_set_complex_space(scene, &space), name);
    if (kind == ANTIALIAS) {
        must_answer(algsurf_scene_set_antialias(scene, 4), name);
        must_answer(algsurf_scene_set_antialias_threshold(scene, 0.1), name);
    }
    studio s = {scene,
                {.size = sizeof s.options, .width = width, .height = height, .threads = 1},
                {.size = sizeof s.planes, .pixels = bytes}};
    const double seconds = least_of(render, &s);
    free(bytes);
    algsurf_scene_free(scene);
    algsurf_surface_free(surface);
    return seconds / (double)pixels;
}

/* ---- rays ---- */

enum { SINGLE, PACKET, SQUARED, ENDLESS, ENDLESS_PACKET };

/* The square of a surface's polynomial. */
static algsurf_surface *square_of(const catalogue_entry *entry) {
    char text[1000];
    algsurf_surface *surface;
    snprintf(text, sizeof text, "(%s)^2", entry->equation);
    must_answer(algsurf_surface_from_equation(text, NULL, 0, &surface, NULL), entry->name);
    return surface;
}

typedef struct shots {
    const algsurf_surface *surface;
    const algsurf_extent *extent;
    algsurf_ray ray[RAYS];
    algsurf_ray_packet packet;
    int together;
} shots;

static void shoot(void *data) {
    static double t[RAYS];
    static unsigned char state[RAYS];
    const shots *s = data;
    const algsurf_intersect_options how = {.size = sizeof how, .kernel = kernel};
    const algsurf_hit_packet hits = {.size = sizeof hits, .state = state, .t = t};
    if (s->together)
        must_answer(algsurf_intersect_packet(s->surface, s->extent, &s->packet, &how, &hits), "packet");
    for (int i = 0; i < RAYS && !s->together; i++) {
        algsurf_hit hit;
        must_answer(algsurf_intersect_first(s->surface, s->extent, &s->ray[i], &how, &hit), "ray");
    }
}

static double time_rays(const char *name, int kind) {
    static shots s;
    const catalogue_entry *entry = entry_of(name);
    algsurf_surface *surface = kind == SQUARED ? square_of(entry) : rays_surface(entry);
    const algsurf_camera camera = rays_camera(&entry->extent);
    measure_random random = {7};
    s.surface = surface;
    s.extent = kind >= ENDLESS ? NULL : &entry->extent;
    s.together = kind == PACKET || kind == SQUARED || kind == ENDLESS_PACKET;
    for (int i = 0; i < RAYS; i++)
        must_answer(algsurf_camera_ray(&camera, 1024, 768, measure_uniform(&random, 128, 896),
                                       measure_uniform(&random, 0, 768), &s.ray[i]),
                    name);
    s.packet = rays_packet(s.ray, RAYS);
    s.packet.t_min = s.packet.t_max = NULL;
    const double seconds = least_of(shoot, &s);
    rays_packet_free(&s.packet);
    algsurf_surface_free(surface);
    return seconds / RAYS;
}

/* ---- polynomials ---- */

/* The number behind a family's name, or -1: it is another name.  From 1 to ROOM. */
static int number_of(const char *name, const char *family) {
    const size_t length = strlen(family);
    if (strncmp(name, family, length) != 0 || !strchr("0123456789", name[length])) return -1;
    const int number = atoi(name + length);
    if (number < 1 || number > ROOM) cli_fail(CLI_BAD_INPUT, "%s: the number is 1 to %d", name, ROOM);
    return number;
}

/* Legendre's polynomial: (m+1) P_(m+1) = (2m+1) t P_m - m P_(m-1). */
static void make_legendre(int n, double *c) {
    double before[ROOM + 1] = {0}, now[ROOM + 1] = {1}, next[ROOM + 1] = {0};
    for (int m = 0; m < n; m++) {
        for (int k = 0; k <= m + 1; k++)
            next[k] = ((2 * m + 1) * (k > 0 ? now[k - 1] : 0) - m * before[k]) / (m + 1);
        memcpy(before, now, sizeof now);
        memcpy(now, next, sizeof next);
    }
    memcpy(c, now, (size_t)(n + 1) * sizeof *c);
}

/* 1 + t^(n-2) (t + 20000)^2, which is nearly 0 at -20000 and nowhere 0. */
static void make_kameny(int n, double *c) {
    memset(c, 0, (size_t)(n + 1) * sizeof *c);
    c[0] = c[n] = 1, c[n - 1] = 40000, c[n - 2] = 400000000;
}

/* "random40": coefficients in [-1,1]; "wide40": times 2^-300 to 2^300; "power24": t^24 - a; "legendre20";
 * "kameny24"; else those along the rays of a surface.  Returns the degree. */
static int make_polynomials(const char *name, double *c) {
    const int power = number_of(name, "power"), legendre = number_of(name, "legendre"),
              kameny = number_of(name, "kameny"), wide = number_of(name, "wide");
    const int n = power > 0      ? power
                  : legendre > 0 ? legendre
                  : kameny > 2   ? kameny
                  : wide > 0     ? wide
                                 : number_of(name, "random");
    measure_random random = {1};
    if (n < 0) {
        const catalogue_entry *entry = entry_of(name);
        rays_polynomials(entry, 1, POLYNOMIALS, c);
        return entry->degree;
    }
    for (int i = 0; i < POLYNOMIALS; i++, c += n + 1) {
        if (legendre > 0) make_legendre(n, c);
        if (kameny > 0) make_kameny(n, c);
        for (int k = 0; k <= n && legendre < 0 && kameny < 0; k++)
            c[k] = wide > 0 ? ldexp(measure_uniform(&random, -1, 1), (int)measure_uniform(&random, -300, 300))
                   : power < 0 ? measure_uniform(&random, -1, 1)
                   : k == n    ? 1
                   : k         ? 0
                               : -measure_uniform(&random, 0.1, 2);
    }
    return n;
}

enum { FIRST, BATCH, ROOTS, LINE, NUMBER, ISOLATE, BOXES };

typedef struct polynomials {
    double c[POLYNOMIALS * (ROOM + 1)];
    int n, kind;
} polynomials;

static void solve_batch(const polynomials *p) {
    static algsurf_real_root roots[POLYNOMIALS * ROOM];
    static double root[POLYNOMIALS], lo = -1, hi = 1;
    static unsigned char state[POLYNOMIALS];
    static int count[POLYNOMIALS];
    const int first = p->kind == FIRST;
    const algsurf_batch_options how = {.size = sizeof how, .kernel = kernel};
    const algsurf_real_batch batch = {.size = sizeof batch,
                                      .count = POLYNOMIALS,
                                      .degree = p->n,
                                      .coefficients = {p->c, 1, p->n + 1},
                                      .lo = first ? &lo : NULL,
                                      .hi = first ? &hi : NULL};
    must_answer(first ? algsurf_first_roots_batch(&batch, &how, state, root)
                      : algsurf_real_roots_batch(&batch, &how, roots, count),
                "batch");
}

static algsurf_status solve_one(const double *c, int n, int kind) {
    static algsurf_real_root roots[ROOM];
    static algsurf_complex_root boxes[ROOM];
    algsurf_bracket bracket;
    int count;
    switch (kind) {
    case ROOTS:
        return algsurf_real_roots(c, n, -1, 1, roots, n, &count);
    case LINE:
        return algsurf_real_roots(c, n, -HUGE_VAL, HUGE_VAL, roots, n, &count);
    case NUMBER:
        return algsurf_count_roots(c, NULL, n, -HUGE_VAL, HUGE_VAL, &count);
    case ISOLATE:
        return algsurf_isolate_first(c, NULL, n, -1, 1, NULL, &bracket, &count);
    default:
        return algsurf_complex_roots_of_real(c, NULL, n, boxes, &count);
    }
}

static void solve(void *data) {
    const polynomials *p = data;
    if (p->kind == FIRST || p->kind == BATCH) {
        solve_batch(p);
        return;
    }
    for (int i = 0; i < POLYNOMIALS; i++)
        must_answer(solve_one(p->c + i * (p->n + 1), p->n, p->kind), "polynomial");
}

static double time_polynomials(const char *name, int kind) {
    static polynomials p;
    p.n = make_polynomials(name, p.c);
    p.kind = kind;
    return least_of(solve, &p) / POLYNOMIALS;
}

static void solve_cluster(void *data) {
    for (int i = 0; i < POLYNOMIALS; i++) {
        algsurf_real_root roots[2];
        int count;
        must_answer(algsurf_real_roots_integers(data, 2, 0, 1, roots, 2, &count), "cluster");
        if (count != 2) cli_fail(CLI_BROKEN, "cluster: %d roots", count);
    }
}

/* "40", at most ROOM: (2^40 (8 t - 5))^2 - 1, whose roots are 2^-42 apart, in integers. */
static double time_cluster(const char *what, int kind) {
    const int bits = 2 * number_of(what, ""), limbs = bits / 64 + 2;
    (void)kind;
    if (bits < 0) cli_fail(CLI_BAD_INPUT, "cluster/%s: expected a number", what);
    uint64_t *limb = must_allocate(3 * (size_t)limbs, sizeof *limb);
    const uint64_t terms[3] = {25, 80, 64};
    for (int k = 0; k < 3; k++) {
        limb[k * limbs + bits / 64] = terms[k] << bits % 64;
        limb[k * limbs + bits / 64 + 1] = bits % 64 ? terms[k] >> (64 - bits % 64) : 0;
    }
    for (int i = 0; limb[i]-- == 0; i++) continue;
    algsurf_integer c[3] = {{limb, limbs}, {limb + limbs, -limbs}, {limb + 2 * limbs, limbs}};
    const double seconds = least_of(solve_cluster, c);
    free(limb);
    return seconds / POLYNOMIALS;
}

/* ---- tasks ---- */

static const struct task_kind {
    const char *name;
    double (*time)(const char *what, int kind);
    int kind;
} kinds[] = {{"picture", time_picture, PLAIN},
             {"wide", time_picture, WIDE},
             {"small", time_picture, SMALL},
             {"antialias", time_picture, ANTIALIAS},
             {"full", time_picture, FULL},
             {"complex", time_picture, COMPLEX},
             {"ray", time_rays, SINGLE},
             {"packet", time_rays, PACKET},
             {"squared", time_rays, SQUARED},
             {"endless", time_rays, ENDLESS},
             {"endless-packet", time_rays, ENDLESS_PACKET},
             {"first", time_polynomials, FIRST},
             {"line-batch", time_polynomials, BATCH},
             {"roots", time_polynomials, ROOTS},
             {"line", time_polynomials, LINE},
             {"number", time_polynomials, NUMBER},
             {"isolate", time_polynomials, ISOLATE},
             {"boxes", time_polynomials, BOXES},
             {"cluster", time_cluster, 0}};

static void run(const char *task) {
    const char *slash = strchr(task, '/');
    for (size_t i = 0; slash && i < sizeof kinds / sizeof *kinds; i++) {
        if (strncmp(kinds[i].name, task, (size_t)(slash - task)) || kinds[i].name[slash - task]) continue;
        printf("%s\t%.3f\n", task, 1e9 * kinds[i].time(slash + 1, kinds[i].kind));
        return;
    }
    cli_fail(CLI_BAD_INPUT, "no task %s", task);
}

int main(int argc, char **argv) {
    int i = 1;
    if (argc == 2 && strcmp(argv[1], "--help") == 0)
        return puts("usage: ledger [--kernel NAME] KIND/WHAT..."), 0;
    if (argc > 2 && strcmp(argv[1], "--kernel") == 0) kernel = argv[2], i = 3;
    if (i == argc) cli_fail(CLI_BAD_INPUT, "usage: ledger [--kernel NAME] KIND/WHAT...");
    for (; i < argc; i++) run(argv[i]);
    return 0;
}
