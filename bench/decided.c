/* decided.c - what it costs to decide every ray: decided --help.
 *
 * Rays that doubles decide, and rays that they cannot: which begin at the root, meet roots closer than any
 * double separates, touch the surface, lie in it, or end on it.  Their answers are known from how the rays
 * were made (decided_cases.c), and are checked before any time is told: state, number and multiplicities of
 * the roots, and that the first one's interval holds at most two neighbouring doubles where integers decided.
 */
#include <math.h>
#include <stdlib.h>

#include "decided.h"
#include "must.h"
#include "results.h"

enum { MOST_RAYS = 10000, NAMED = 2 };

typedef struct bench_options {
    const char *output;
    const beside_edition *beside; /* null: none */
    int rays, seed, quick;
} bench_options;

static void set_beside(const cli_option *option, const char *value, void *field) {
    (void)option;
    *(const beside_edition **)field = beside_load(value);
}

#define FIELD(member) offsetof(bench_options, member)

static const cli_option options_table[] = {
    {"--rays", "N", "rays of a surface, default 64", cli_set_int, FIELD(rays), 1, MOST_RAYS},
    {"--quick", NULL, "8 rays of a surface: a few seconds", cli_set_flag, FIELD(quick), 0, 0},
    {"--seed", "S", "of the random surfaces and rays, default 1", cli_set_int, FIELD(seed), 0, 1000000000},
    {"--output", "FOLDER", "gets decided.csv and decided.svg; made if there is none", cli_set_text,
     FIELD(output), 0, 0},
    {"--beside", "FILE",
     "another edition of the library, asked the same in turn; the script bench/beside\n"
     "makes the file, and calls this program",
     set_beside, FIELD(beside), 0, 0},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "decided",
    .synopsis = "[options]",
    .about = "Asks for the first hit of rays that doubles decide and of rays that only integers can,\n"
             "by degree of the surface; checks the answers, then prints how long they took.  A wrong\n"
             "answer: one line on standard error, no table, exit status 1.",
    .options = options_table,
};

static const char legend[] =
    "What it costs to decide a ray, certified tier, one ray at a time.\n"
    "  surface  random: all coefficients, whole numbers; else a named one\n"
    "  kind     clear: one simple root; end: the ray begins at the double before it; gap: two roots 2^-20,\n"
    "           2^-60, 2^-200 apart; tangent: the ray touches; double: a double root; inside: the ray\n"
    "           lies in the surface; own-ball: the surface is that of the extent\n"
    "  open%    share of the rays that doubles leave to integers\n"
    "  us50%    CPU time of a ray, microseconds, median of the rays; 10%, 90%: their spread\n"
    "  lanes    of a clear ray, by doubles alone; -: they do not decide it\n"
    "  times    us50% in units of that\n";

static const char legend_beside[] =
    "  beside   us50% of the other edition, certified tier, asked in turn with this one\n"
    "  ratio    its time of a ray in units of this edition's, median; above 1: this one is faster\n"
    "  undec%   share of the rays that the other edition does not decide\n"
    "  wrong%   share that it answers wrongly: no hit, or one elsewhere\n";

/* ---- judgement ---- */

static _Noreturn void refuse(const example *e, size_t i, const char *what) {
    cli_fail(CLI_BROKEN, "%s surface of degree %d, %s, ray %zu: %s", e->surface, e->degree,
             kind_names[e->kind], i, what);
}

static void judge_all(const example *e, size_t i) {
    algsurf_hit hits[ALGSURF_MAX_DEGREE];
    int count = 0;
    if (algsurf_intersect_all(e->equation, &e->extent, &e->ray[i], NULL, hits, ALGSURF_MAX_DEGREE, &count) !=
        ALGSURF_OK)
        refuse(e, i, "its roots are refused");
    if (count < e->least || count > e->most) refuse(e, i, "another number of roots");
    for (int k = 0; k < count; k++)
        if (hits[k].state != ALGSURF_STATE_HIT ||
            (e->least == e->most && hits[k].multiplicity != e->multiplicity))
            refuse(e, i, "a root that is not as it was made");
}

/* Returns whether doubles leave the ray open. */
static int judge(const example *e, size_t i) {
    const algsurf_intersect_options bounded = {.size = sizeof bounded, .tier = ALGSURF_TIER_BOUNDED};
    const algsurf_ray *ray = &e->ray[i];
    algsurf_hit hit, by_doubles;
    if (algsurf_intersect_first(e->equation, &e->extent, ray, NULL, &hit) != ALGSURF_OK ||
        algsurf_intersect_first(e->equation, &e->extent, ray, &bounded, &by_doubles) != ALGSURF_OK)
        refuse(e, i, "it is refused");
    int open = by_doubles.state == ALGSURF_STATE_UNDECIDED;
    if (hit.state != ALGSURF_STATE_HIT) refuse(e, i, "no hit");
    if (hit.multiplicity != e->multiplicity) refuse(e, i, "a hit of another multiplicity");
    if ((hit.side == 0) != (hit.multiplicity == 0)) refuse(e, i, "a side where there is none, or none");
    if (!(hit.t_lo <= hit.t && hit.t <= hit.t_hi)) refuse(e, i, "t outside of its interval");
    if (!example_hit_at(e, i, hit.t)) refuse(e, i, "a hit elsewhere");
    if (open && hit.t_hi > nextafter(hit.t_lo, INFINITY)) refuse(e, i, "an interval wider than it must be");
    if (!open && by_doubles.state != ALGSURF_STATE_HIT) refuse(e, i, "no hit by doubles");
    judge_all(e, i);
    return open;
}

/* ---- time ---- */

/* Who is asked. */
typedef enum way { CERTIFIED, LANES, OTHER, WAYS } way;

typedef struct task {
    const example *example;
    const beside_edition *other; /* null: none */
    algsurf_surface *others_surface;
    size_t ray;
} task;

static void ask(const task *w, int tier) {
    const algsurf_intersect_options options = {.size = sizeof options, .tier = tier};
    const example *e = w->example;
    algsurf_hit hit;
    (void)algsurf_intersect_first(e->equation, &e->extent, &e->ray[w->ray], &options, &hit);
}

static void ask_certified(void *data) { ask(data, ALGSURF_TIER_CERTIFIED); }
static void ask_lanes(void *data) { ask(data, ALGSURF_TIER_BOUNDED); }
static void ask_other(void *data) {
    const task *w = data;
    double t;
    (void)w->other->first(w->others_surface, &w->example->extent, &w->example->ray[w->ray], &t);
}

/* Microseconds of each ray, of each way that has room for them.  They take turns at each ray, since a
 * processor's clock drifts; a call before fills the caches. */
static void take_times(task *w, double *us[WAYS]) {
    static void (*const asks[WAYS])(void *) = {ask_certified, ask_lanes, ask_other};
    for (w->ray = 0; w->ray < w->example->count; w->ray++)
        for (int k = 0; k < WAYS; k++) {
            if (!us[k]) continue;
            asks[k](w);
            us[k][w->ray] = 1e6 * measure_call(asks[k], w);
        }
}

/* Of the rays' ratios, NaN where a way was not asked. */
static double median_ratio(const double *us, const double *by, size_t count) {
    if (!us || !by) return NAN;
    double *ratio = must_allocate(count, sizeof(double));
    for (size_t i = 0; i < count; i++) ratio[i] = us[i] / by[i];
    double median = measure_quantile(ratio, count, 0.5);
    free(ratio);
    return median;
}

static finding examine(const example *e, const beside_edition *other) {
    finding f = {.surface = e->surface, .degree = e->degree, .kind = e->kind, .rays = e->count};
    task w = {.example = e, .other = other};
    for (size_t i = 0; i < e->count; i++) f.open += (size_t)judge(e, i);
    if (other) {
        w.others_surface = beside_surface(other, e);
        beside_judge(other, e, w.others_surface, &f.undecided, &f.wrong);
    }
    const int asked[WAYS] = {1, e->kind == KIND_CLEAR && f.open == 0, other != NULL};
    double *us[WAYS] = {NULL};
    for (int k = 0; k < WAYS; k++)
        if (asked[k]) us[k] = must_allocate(e->count, sizeof(double));
    take_times(&w, us);
    f.ratio = median_ratio(us[OTHER], us[CERTIFIED], e->count);
    f.us = measure_quantile(us[CERTIFIED], e->count, 0.5);
    f.us_low = measure_quantile(us[CERTIFIED], e->count, 0.1);
    f.us_high = measure_quantile(us[CERTIFIED], e->count, 0.9);
    f.lanes = asked[LANES] ? measure_quantile(us[LANES], e->count, 0.5) : NAN;
    f.beside = asked[OTHER] ? measure_quantile(us[OTHER], e->count, 0.5) : NAN;
    for (int k = 0; k < WAYS; k++) free(us[k]);
    if (other) other->surface_free(w.others_surface);
    return f;
}

/* ---- the run ---- */

static const int degrees[] = {2, 4, 6, 8, 10, 16, 20, 32};
enum { DEGREES = sizeof degrees / sizeof *degrees, MOST_FINDINGS = DEGREES * KINDS + 2 * NAMED };

/* The findings of a surface, kinds from the clear ray on; returns how many. */
static int run(const bench_options *o, const char *name, int degree, finding *f) {
    const int kinds = name ? KIND_END + 1 : KINDS;
    for (int which = KIND_CLEAR; which < kinds; which++) {
        example e;
        if (name)
            example_named(&e, name, (kind)which, (size_t)o->rays, o->seed);
        else
            example_random(&e, degree, (kind)which, (size_t)o->rays, o->seed);
        f[which] = examine(&e, o->beside);
        f[which].lanes = f[KIND_CLEAR].lanes;
        example_free(&e);
    }
    return kinds;
}

int main(int argc, char **argv) {
    static const char *const names[NAMED] = {"barth", "barth-decic"};
    bench_options o = {.seed = 1};
    finding f[MOST_FINDINGS];
    int count = 0;
    results_begin(&program, argc, argv, &o, &o.output);
    if (o.rays == 0) o.rays = o.quick ? 8 : 64;
    for (int d = 0; d < DEGREES; d++) count += run(&o, NULL, degrees[d], f + count);
    for (int s = 0; s < NAMED; s++) count += run(&o, names[s], 0, f + count);
    measure_head("", (const char *const[]){legend, o.beside ? legend_beside : NULL, NULL});
    printf("kernel: %s\nrays: %d of a surface\nseed: %d\n", algsurf_kernel_name(0), o.rays, o.seed);
    if (o.beside) printf("beside: %s\n", o.beside->name);
    report(f, (size_t)count, o.beside ? o.beside->name : NULL, o.output);
    cli_finish_output();
    return 0;
}
