/* decided.c - what it costs to decide every ray: decided --help.
 *
 * Rays that doubles decide, and rays that they cannot: which begin at the root, meet roots closer than any
 * double separates, touch the surface, lie in it, or end on it.  Their answers are known from how the rays
 * were made (decided_cases.h), and are checked before any time is told: state, number and multiplicities of
 * the roots, and that the first one's interval holds at most two neighbouring doubles where integers decided.
 */
#include <math.h>
#include <stdlib.h>

#include "cli.h"
#include "decided_report.h"
#include "results.h"

enum { MOST_RAYS = 10000, NAMED = 2 };

typedef struct bench_options {
    const char *extra; /* a plain argument, which this program does not take */
    const char *output;
    int rays, seed, quick;
} bench_options;

#define FIELD(member) offsetof(bench_options, member)

static const cli_option options_table[] = {
    {"--rays", "N", "rays of a surface, default 64", cli_set_int, FIELD(rays), 1, MOST_RAYS},
    {"--quick", NULL, "8 rays of a surface: a few seconds", cli_set_flag, FIELD(quick), 0, 0},
    {"--seed", "S", "of the random surfaces and rays, default 1", cli_set_int, FIELD(seed), 0, 1000000000},
    {"--output", "FOLDER", "gets decided.csv and decided.svg; made if there is none", cli_set_text,
     FIELD(output), 0, 0},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "decided",
    .synopsis = "[options]",
    .about = "Asks for the first hit of rays that doubles decide and of rays that only integers can,\n"
             "by degree of the surface; checks the answers, then prints how long they took.  A wrong\n"
             "answer: one line on standard error, no table, exit status 1.",
    .options = options_table,
    .positional = FIELD(extra),
};

static const char legend[] =
    "What it costs to decide a ray, certified tier, one ray at a time.\n"
    "  surface  random: all coefficients, whole numbers; else a named one\n"
    "  kind     clear: one simple root; end: the ray begins at the double before it; gap: two roots 2^-20,\n"
    "           2^-60, 2^-200 apart; tangent: the ray touches; square: P = Q^2; inside: the ray lies in\n"
    "           the surface; own-ball: the surface is that of the extent\n"
    "  open%    share of the rays that doubles leave to integers\n"
    "  us50%    CPU time of a ray, microseconds, median of the rays; 10%, 90%: their spread\n"
    "  lanes    of a clear ray, by doubles alone; -: they do not decide it\n"
    "  times    us50% in units of that\n";

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
        if (hits[k].state != ALGSURF_HIT || (e->least == e->most && hits[k].multiplicity != e->multiplicity))
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
    int open = by_doubles.state == ALGSURF_UNCERTAIN;
    if (hit.state != ALGSURF_HIT) refuse(e, i, "no hit");
    if (hit.multiplicity != e->multiplicity) refuse(e, i, "a hit of another multiplicity");
    if ((hit.side == 0) != (hit.multiplicity == 0)) refuse(e, i, "a side where there is none, or none");
    if (!(hit.t_lo <= hit.t && hit.t <= hit.t_hi)) refuse(e, i, "t outside of its interval");
    if (!(fabs(hit.t - e->t[i]) <= 1e-3 * fabs(e->t[i]))) refuse(e, i, "a hit elsewhere");
    if (open && hit.t_hi > nextafter(hit.t_lo, INFINITY)) refuse(e, i, "an interval wider than it must be");
    if (!open && by_doubles.state != ALGSURF_HIT) refuse(e, i, "no hit by doubles");
    judge_all(e, i);
    return open;
}

/* ---- time ---- */

typedef struct task {
    const example *example;
    size_t ray;
    algsurf_intersect_options options;
} task;

static void ask(void *data) {
    task *w = data;
    const example *e = w->example;
    algsurf_hit hit;
    (void)algsurf_intersect_first(e->equation, &e->extent, &e->ray[w->ray], &w->options, &hit);
}

/* Microseconds of each ray, sorted. */
static double *take_times(const example *e, algsurf_tier tier) {
    task w = {e, 0, {.size = sizeof w.options, .tier = tier}};
    double *us = calloc(e->count, sizeof *us);
    if (!us) cli_no_memory();
    for (; w.ray < e->count; w.ray++) us[w.ray] = 1e6 * measure_call(ask, &w);
    measure_sort(us, e->count);
    return us;
}

static finding examine(const example *e) {
    finding f = {.surface = e->surface, .degree = e->degree, .kind = e->kind, .rays = e->count, .lanes = NAN};
    for (size_t i = 0; i < e->count; i++) f.open += (size_t)judge(e, i);
    double *us = take_times(e, ALGSURF_TIER_CERTIFIED);
    f.us = measure_quantile(us, e->count, 0.5);
    f.us_low = measure_quantile(us, e->count, 0.1);
    f.us_high = measure_quantile(us, e->count, 0.9);
    free(us);
    if (e->kind != KIND_CLEAR || f.open > 0) return f;
    us = take_times(e, ALGSURF_TIER_BOUNDED);
    f.lanes = measure_quantile(us, e->count, 0.5);
    free(us);
    return f;
}

/* ---- the run ---- */

static const int degrees[] = {2, 4, 6, 8, 10, 16, 20, 32};
enum { DEGREES = sizeof degrees / sizeof *degrees, MOST_FINDINGS = DEGREES * KINDS + 2 * NAMED };

static size_t run_random(const bench_options *o, finding *f) {
    size_t count = 0;
    for (int d = 0; d < DEGREES; d++)
        for (int which = 0; which < KINDS; which++, count++) {
            example e;
            example_random(&e, degrees[d], (kind)which, (size_t)o->rays, o->seed);
            f[count] = examine(&e);
            if (which != KIND_CLEAR) f[count].lanes = f[count - (size_t)which].lanes;
            example_free(&e);
        }
    return count;
}

static size_t run_named(const bench_options *o, finding *f) {
    static const char *const names[NAMED] = {"barth", "barth-decic"};
    size_t count = 0;
    for (int s = 0; s < NAMED; s++)
        for (int which = KIND_CLEAR; which <= KIND_END; which++, count++) {
            example e;
            example_named(&e, names[s], (kind)which, (size_t)o->rays, o->seed);
            f[count] = examine(&e);
            if (which != KIND_CLEAR) f[count].lanes = f[count - 1].lanes;
            example_free(&e);
        }
    return count;
}

static void print_head(const bench_options *o) {
    char machine[512];
    measure_machine(machine, sizeof machine);
    printf("%smachine: %s\nkernel: %s\nrays: %d of a surface\nseed: %d\n", legend, machine,
           algsurf_kernel_name(0), o->rays, o->seed);
}

int main(int argc, char **argv) {
    bench_options o = {.seed = 1};
    finding f[MOST_FINDINGS];
    cli_parse(&program, argc, argv, &o);
    if (o.extra) cli_fail(CLI_BAD_INPUT, "unexpected '%s'", cli_quote(o.extra).text);
    if (o.rays == 0) o.rays = o.quick ? 8 : 64;
    if (o.output) results_folder(o.output); /* before the work */
    size_t count = run_random(&o, f);
    count += run_named(&o, f + count);
    if (o.output) report_files(f, count, o.output);
    print_head(&o);
    report_table(f, count);
    cli_finish_output();
    return 0;
}
