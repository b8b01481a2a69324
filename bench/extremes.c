/* extremes.c - how intersections fare at the edges of what doubles can say: extremes --help.
 *
 * Eight sweeps, each towards an edge: a far eye, large and small surfaces, roots close together, high
 * degrees, singular points, extents, coefficients of different size, vanishing leading coefficients.  At
 * every step rays are asked for their first hit in each tier, and as a packet; the answers are judged
 * (extremes_truth.c) before anything is timed.  A wrong one ends the program without a table.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "extremes.h"
#include "must.h"
#include "results.h"

enum { REPEAT = 3, MOST_VARIANTS = 6, MOST_RAYS = 10000 };

typedef struct bench_options {
    const char *output;
    const sweep *only; /* null: all sweeps */
    int rays, seed, quick;
} bench_options;

static void set_sweep(const cli_option *option, const char *value, void *field) {
    bench_options *o = field;
    o->only = NULL;
    for (const sweep *s = sweeps; s < sweeps + SWEEPS; s++)
        if (strcmp(s->name, value) == 0) o->only = s;
    if (!o->only) cli_expected(option, value);
}

#define FIELD(member) offsetof(bench_options, member)

static const cli_option options_table[] = {
    {"--rays", "N", "rays of a scene (a value has 1 to 6 scenes), default 64", cli_set_int, FIELD(rays), 1,
     MOST_RAYS},
    {"--quick", NULL, "12 rays of a scene: seconds instead of a minute", cli_set_flag, FIELD(quick), 0, 0},
    {"--seed", "S", "of the random rays, default 1", cli_set_int, FIELD(seed), 0, 1000000000},
    {"--sweep", "distance|scale|gap|degree|singular|extent|spread|leading", "that one only, default all",
     set_sweep, 0, 0, 0},
    {"--output", "FOLDER", "extremes.csv and a chart of each sweep go there; made if there is none",
     cli_set_text, FIELD(output), 0, 0},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "extremes",
    .synopsis = "[options]",
    .about = "Asks for first hits at the edges of what doubles can say, checks the answers, then\n"
             "prints how many were undecided, how far off, and how long they took.  A wrong\n"
             "answer: one line on standard error, no table, exit status 1.",
    .options = options_table,
};

static const char legend[] =
    "First hits at the extremes.\n"
    "  manner      bounded, certified: a tier, rays one by one; packet: certified tier, the rays of a\n"
    "              scene as one packet (they have nothing in common)\n"
    "  rays, hits  asked; those that hit\n"
    "  undecided%  share of the rays that the tier leaves open\n"
    "  error50%    of t, median; max: the largest.  Unit: u kappa |t|, u = 2^-53,\n"
    "              kappa = 1 + S / |t P'(t)|, S = sum of |a x^i y^j z^k|: what rounding coefficients and t "
    "may do\n"
    "  ns50%       CPU time of a ray, median of the repetitions; min, max: their spread\n"
    "The truth is known from how a ray was made, or what the certified tier proves, with its root\n"
    "polished in double-double.\n";

/* ---- one scene, in all manners ---- */

static answers make_answers(size_t count) {
    return (answers){must_allocate(count, 1), must_allocate(count, sizeof(double)),
                     must_allocate(count, sizeof(double)), must_allocate(count, sizeof(double))};
}

static void free_answers(answers *a) {
    free(a->state);
    free(a->t);
    free(a->t_lo);
    free(a->t_hi);
}

/* What is found out about the rays of one value, scene by scene. */
typedef struct tally {
    size_t rays, hits, undecided, errors;
    double *error;
    double seconds[REPEAT]; /* for all rays, once */
} tally;

typedef struct work {
    const bench_options *options;
    const sweep *sweep;
    int point, variant;
    scene scene;
    manner manner;
    answers answers;
} work;

static void ask(void *data) {
    work *w = data;
    if (!scene_ask(&w->scene, w->manner, &w->answers))
        cli_fail(CLI_BROKEN, "%s %g, scene %d, %s: a ray is refused", w->sweep->name,
                 w->sweep->values[w->point], w->variant, manner_names[w->manner]);
}

static truth *find_truths(work *w) {
    truth *known = must_allocate(w->scene.count, sizeof *known);
    w->manner = MANNER_CERTIFIED;
    ask(w);
    for (size_t i = 0; i < w->scene.count; i++) known[i] = scene_truth(&w->scene, i, &w->answers);
    return known;
}

/* Counts the answers; a wrong one ends the program. */
static void judge_all(const work *w, const truth *known, tally *t) {
    for (size_t i = 0; i < w->scene.count; i++) {
        verdict v = judge(&known[i], &w->answers, i);
        if (v.wrong)
            cli_fail(CLI_BROKEN, "seed %d, %s %g, scene %d, ray %zu of %zu, %s: %s", w->options->seed,
                     w->sweep->name, w->sweep->values[w->point], w->variant, i, w->scene.count,
                     manner_names[w->manner], v.wrong);
        t->rays++;
        t->hits += known[i].state == ALGSURF_STATE_HIT;
        t->undecided += (size_t)v.undecided;
        if (!isnan(v.error)) t->error[t->errors++] = v.error;
    }
}

static void run_scene(work *w, tally tallies[MANNERS]) {
    const bench_options *o = w->options;
    scene_make(w->sweep, w->point, w->variant, (size_t)o->rays, o->seed, &w->scene);
    truth *known = find_truths(w);
    for (int m = 0; m < MANNERS; m++) {
        w->manner = (manner)m;
        ask(w);
        judge_all(w, known, &tallies[m]);
    }
    for (int turn = 0; turn < REPEAT; turn++)
        for (int m = 0; m < MANNERS; m++) {
            w->manner = (manner)m;
            tallies[m].seconds[turn] += measure_call(ask, w);
        }
    free(known);
    scene_free(&w->scene);
}

/* ---- a sweep ---- */

static finding find(const tally *t) {
    const double unit = 1e9 / (double)t->rays;
    return (finding){t->rays,
                     t->hits,
                     t->undecided,
                     measure_quantile(t->error, t->errors, 0.5),
                     measure_quantile(t->error, t->errors, 1),
                     unit * measure_quantile(t->seconds, REPEAT, 0.5),
                     unit * measure_quantile(t->seconds, REPEAT, 0),
                     unit * measure_quantile(t->seconds, REPEAT, 1)};
}

static void run_sweep(const bench_options *o, const sweep *which, record *r) {
    size_t rays = (size_t)o->rays;
    work w = {.options = o, .sweep = which, .answers = make_answers(rays)};
    r->sweep = which;
    for (w.point = 0; w.point < which->points; w.point++) {
        tally tallies[MANNERS] = {{0}};
        for (int m = 0; m < MANNERS; m++)
            tallies[m].error = must_allocate(MOST_VARIANTS * rays, sizeof(double));
        for (w.variant = 0; w.variant < which->variants; w.variant++) run_scene(&w, tallies);
        for (int m = 0; m < MANNERS; m++) {
            r->finding[w.point][m] = find(&tallies[m]);
            free(tallies[m].error);
        }
    }
    free_answers(&w.answers);
}

/* ---- the run ---- */

int main(int argc, char **argv) {
    bench_options o = {.seed = 1};
    record records[SWEEPS];
    size_t count = 0;
    results_begin(&program, argc, argv, &o, &o.output);
    if (o.rays == 0) o.rays = o.quick ? 12 : 64;
    for (const sweep *s = sweeps; s < sweeps + SWEEPS; s++)
        if (!o.only || s == o.only) run_sweep(&o, s, &records[count++]);
    measure_head("", (const char *const[]){legend, NULL});
    printf("kernel: %s\nrays: %d of a scene\nseed: %d\n", algsurf_kernel_name(0), o.rays, o.seed);
    report(records, count, o.output);
    cli_finish_output();
    return 0;
}
