/* seed.c - the comparison of root finders that this library grew from, made again: seed --help.
 *
 * Six surfaces of Chuyeshov, Visualization of algebraic surfaces, 2005, by bisection, regula falsi, Brent's
 * method, the library's default, and three younger methods that are no part of the library; the Barth decic
 * where regula falsi breaks; Newton's method where it finds another root.  Every root of every ray is
 * compared with one that is proved before a time is told; a method that misses one ends the program without a
 * table, except regula falsi, whose wrong roots are the result.  Methods take turns, so that what else runs
 * on the machine hits them alike.
 */
#include <math.h>

#include "must.h"
#include "results.h"
#include "seed.h"

static const double TOLERANCE = 1e-7;

enum {
    TIMED = 1 << 14, /* rays of a surface, evenly spread, that are timed: some 5 ms a pass */
    REPEAT = 5,
    PICTURES = 3,
    QUICK_REPEAT = 3
};

typedef struct bench_options {
    const char *output;
    int quick;
} bench_options;

static int width_of(const bench_options *o) { return o->quick ? 160 : 1024; }
static int height_of(const bench_options *o) { return o->quick ? 120 : 768; }

#define FIELD(member) offsetof(bench_options, member)

static const cli_option options_table[] = {
    {"--output", "FOLDER", "tables as CSV and charts as SVG and PNG go there; made if there is none",
     cli_set_text, FIELD(output), 0, 0},
    {"--quick", NULL, "small pictures, three repetitions: seconds instead of a minute", cli_set_flag,
     FIELD(quick), 0, 0},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "seed",
    .synopsis = "[options]",
    .about = "Compares bisection, regula falsi, Brent's method, the library's default, Illinois,\n"
             "Chandrupatla and ITP on the rays of seven surfaces, checks every root, then prints\n"
             "what each costs and where it fails.  A root missed by a method that may not: one line\n"
             "on standard error, no table, exit status 1.",
    .options = options_table,
};

static const char *const surfaces[SEED_SURFACES] = {"barth",  "cusp",       "torus",
                                                    "pillow", "lemniscate", "tangle"};

/* ---- roots ---- */

/* A method on all brackets: what it found, judged. */
static void judge(const seed_view *view, int m, seed_cost *cost) {
    const seed_method *method = &seed_methods[m];
    double evaluations = 0;
    for (const seed_ray *ray = view->rays; ray < view->rays + view->count; ray++) {
        algsurf_refined_root root;
        if (!ray->bracketed) continue;
        algsurf_status status =
            seed_solve(method, ray->c, view->entry->degree, ray->lo, ray->hi, TOLERANCE, 0, &root);
        double allowed = seed_allowed(view, ray, TOLERANCE);
        int right = status == ALGSURF_OK && fabs(root.root - ray->root) <= allowed;
        int encloses = status >= 0 && root.lo <= ray->root + allowed && root.hi >= ray->root - allowed;
        if (!encloses || (!right && !method->may_fail))
            cli_fail(CLI_BROKEN, "%s, %s: pixel %d,%d has its root at %.17g, not %.17g", view->entry->name,
                     method->name, ray->pixel % view->width, ray->pixel / view->width, ray->root, root.root);
        cost->wrong += !right;
        evaluations += root.evaluations;
        if (root.evaluations > cost->evaluations_most) cost->evaluations_most = root.evaluations;
    }
    cost->evaluations = evaluations / (double)view->bracketed;
}

static int bare_is_right(const seed_ray *ray, int degree) {
    double lo, hi;
    int found = seed_bare_isolate(ray->c, degree, &lo, &hi);
    return found == ray->bracketed && (!found || (lo <= ray->root && ray->root <= hi));
}

/* Everything about a view that is no time. */
static void count(const seed_view *view, seed_result *result) {
    double sum = 0;
    size_t wrong = 0;
    for (const seed_ray *ray = view->rays; ray < view->rays + view->count; ray++) {
        if (ray->bracketed) sum += log(ray->hi - ray->lo);
        wrong += !bare_is_right(ray, view->entry->degree);
    }
    *result = (seed_result){.name = view->entry->name,
                            .degree = view->entry->degree,
                            .rays = view->count,
                            .brackets = view->bracketed,
                            .undecided = view->undecided,
                            .width = exp(sum / (double)view->bracketed),
                            .bare_wrong = wrong};
    for (int m = 0; m < SEED_METHODS; m++) judge(view, m, &result->cost[m]);
}

/* CPU seconds a ray: of those with a bracket, from there; or, isolated as well, of all. */
static double pass(const seed_view *view, int m, double tolerance, int with_isolation) {
    size_t stride = 1 + view->count / TIMED, rays = 0;
    int degree = view->entry->degree;
    double begun = measure_cpu();
    for (size_t i = 0; i < view->count; i += stride) {
        const seed_ray *ray = &view->rays[i];
        algsurf_bracket bracket;
        algsurf_refined_root root;
        int found;
        if (with_isolation) (void)algsurf_isolate_first(ray->c, NULL, degree, -1, 1, NULL, &bracket, &found);
        rays += with_isolation || ray->bracketed;
        if (ray->bracketed)
            (void)seed_solve(&seed_methods[m], ray->c, degree, ray->lo, ray->hi, tolerance, 0, &root);
    }
    return (measure_cpu() - begun) / (double)rays;
}

/* CPU seconds a ray of isolation alone. */
static double pass_isolation(const seed_view *view, int bare) {
    size_t stride = 1 + view->count / TIMED, rays = 0;
    double begun = measure_cpu();
    for (size_t i = 0; i < view->count; i += stride, rays++) {
        algsurf_bracket bracket;
        int found;
        if (bare)
            (void)seed_bare_isolate(view->rays[i].c, view->entry->degree, &bracket.lo, &bracket.hi);
        else
            (void)algsurf_isolate_first(view->rays[i].c, NULL, view->entry->degree, -1, 1, NULL, &bracket,
                                        &found);
    }
    return (measure_cpu() - begun) / (double)rays;
}

/* ---- a surface ---- */

static void time_roots(const seed_view *view, seed_result *result) {
    for (int m = 0; m < SEED_METHODS; m++) {
        measure_take(&result->cost[m].refine, pass(view, m, TOLERANCE, 0));
        measure_take(&result->cost[m].solve, pass(view, m, TOLERANCE, 1));
    }
    measure_take(&result->idle[0], pass(view, SEED_BRENT, 1, 0)); /* half a bracket is at most 1 */
    measure_take(&result->idle[1], pass(view, SEED_OWN, 1, 0));
    measure_take(&result->isolation, pass_isolation(view, 0));
    measure_take(&result->bare, pass_isolation(view, 1));
}

static void time_pictures(const seed_view *view, seed_result *result, int repeat) {
    seed_easel easel;
    seed_easel_open(&easel, view);
    for (int k = 0; k < repeat; k++) {
        size_t none;
        for (int m = 0; m < SEED_OWN; m++) {
            double seconds = seed_draw(&easel, &seed_methods[m], TOLERANCE, 0, &result->cost[m].wrong_pixels);
            measure_take(&result->cost[m].picture, seconds);
        }
        measure_take(&result->packets, seed_draw(&easel, &seed_methods[SEED_DEFAULT], TOLERANCE, 1, &none));
    }
    seed_easel_close(&easel);
}

static void measure_surface(int which, const bench_options *o, seed_result *result, seed_census *census) {
    seed_view view;
    seed_open(&view, surfaces[which], width_of(o), height_of(o));
    if (view.bracketed == 0) cli_fail(CLI_BROKEN, "%s: no root at all", surfaces[which]);
    count(&view, result);
    for (int k = 0; k < (o->quick ? QUICK_REPEAT : REPEAT); k++) time_roots(&view, result);
    time_pictures(&view, result, o->quick ? QUICK_REPEAT : PICTURES);
    seed_newton_census(&view, census);
    seed_close(&view);
}

/* ---- the run ---- */

int main(int argc, char **argv) {
    bench_options o = {0};
    static seed_result results[SEED_COUNTED];
    static seed_census censuses[SEED_SURFACES];
    static seed_decic decic;
    results_begin(&program, argc, argv, &o, &o.output);
    for (int i = 0; i < SEED_SURFACES; i++) measure_surface(i, &o, &results[i], &censuses[i]);
    seed_decic_run(&decic, width_of(&o), height_of(&o), o.output);
    count(&decic.view, &results[SEED_DECIC]);
    seed_report(results, censuses, &decic, o.output);
    seed_close(&decic.view);
    return 0;
}
