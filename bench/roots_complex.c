/* roots_complex.c - all complex roots of a polynomial, by this library and by others.
 *
 * This library's boxes are proved to hold the roots; so are Arb's balls.  Each of the others' roots is
 * matched with a box, and each box takes as many roots as it holds.  Where Arb and this library contradict
 * each other there is no table; of the others, roots are counted that match no box, and boxes left without.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "must.h"
#include "roots.h"
#include "roots_others.h"

static const double RIGHT = 1e-6;     /* of a root without a disc */
static const double ROUNDING = 1e-15; /* centres and radii of discs were rounded to doubles: some 4 2^-53 */

/* all: null for this library, in packets of so many. */
typedef struct solver {
    const char *program;
    size_t packet;
    other_all *all;
    int real_only, proves;
    const roots_set *on;
    other_root *root;
    int *roots;
} solver;

/* This library's answers, one by one and in packets. */
static algsurf_complex_root *box, *packed_box;
static int *boxes, *packed_boxes;

static void solve_here(const roots_set *on, size_t i) {
    size_t n = (size_t)on->degree, from = i * (n + 1);
    algsurf_complex c[ALGSURF_MAX_DEGREE + 1];
    for (size_t k = 0; on->im && k <= n; k++) c[k] = (algsurf_complex){on->c[from + k], on->im[from + k]};
    algsurf_status status =
        on->im ? algsurf_complex_roots(c, NULL, on->degree, box + i * n, &boxes[i])
               : algsurf_complex_roots_of_real(on->c + from, NULL, on->degree, box + i * n, &boxes[i]);
    if (status != ALGSURF_OK)
        cli_fail(CLI_BROKEN, "%s, polynomial %zu: %s", on->name, i, algsurf_status_text(status));
}

static void solve_packet(const roots_set *on, size_t begin, size_t end) {
    const algsurf_complex_batch packet = {.size = sizeof packet,
                                          .count = end - begin,
                                          .degree = on->degree,
                                          .re = roots_set_rows(on, on->c, begin),
                                          .im = roots_set_rows(on, on->im, begin)};
    algsurf_status status = algsurf_complex_roots_batch(
        &packet, NULL, packed_box + begin * (size_t)on->degree, packed_boxes + begin);
    if (status != ALGSURF_OK) cli_fail(CLI_BROKEN, "%s, packet: %s", on->name, algsurf_status_text(status));
}

static void solve(void *self, size_t begin, size_t end) {
    const solver *s = self;
    size_t n = (size_t)s->on->degree, step = s->packet ? s->packet : 1;
    for (size_t i = begin; i < end; i += step)
        if (s->packet)
            solve_packet(s->on, i, end - i < step ? end : i + step);
        else if (s->all)
            s->roots[i] = s->all(s->on->c + i * (n + 1), s->on->im ? s->on->im + i * (n + 1) : NULL,
                                 s->on->degree, s->root + i * n);
        else
            solve_here(s->on, i);
}

/* ---- right or wrong ---- */

static double outside(algsurf_interval interval, double x) {
    return fmax(0, fmax(interval.lo - x, x - interval.hi));
}

static double reach(const other_root *root, double unit) {
    double size = hypot(root->re, root->im);
    return isnan(root->radius) ? RIGHT * fmax(unit, size) : root->radius + ROUNDING * size;
}

/* The nearest root without a box that reaches this one; -1: none. */
static int nearest(const algsurf_complex_root *own, const other_root *root, const char *taken, int roots,
                   double unit) {
    double least = INFINITY;
    int best = -1;
    for (int k = 0; k < roots; k++) {
        double away = hypot(outside(own->box.re, root[k].re), outside(own->box.im, root[k].im));
        if (taken[k] || !(away <= reach(&root[k], unit)) || away >= least) continue;
        least = away;
        best = k;
    }
    return best;
}

/* Packets must give the bits of single calls. */
static void compare_packets(const roots_set *on, size_t count) {
    size_t n = (size_t)on->degree;
    for (size_t i = 0; i < count; i++)
        if (boxes[i] != packed_boxes[i] ||
            memcmp(box + i * n, packed_box + i * n, (size_t)boxes[i] * sizeof *box) != 0)
            cli_fail(CLI_BROKEN, "%s, polynomial %zu: packets and single calls differ", on->name, i);
}

void roots_judge(const algsurf_complex_root *own, int count, const other_root *root, int roots, double unit,
                 contest_row *row) {
    char taken[ALGSURF_MAX_POLY_DEGREE] = {0};
    int matched = 0;
    for (int b = 0; b < count; b++)
        for (int m = 0; m < own[b].multiplicity; m++) {
            int k = nearest(&own[b], root, taken, roots, unit);
            if (k < 0) {
                row->missed++;
                continue;
            }
            taken[k] = 1;
            matched++;
            double off = hypot(root[k].re - own[b].root.re, root[k].im - own[b].root.im);
            if (own[b].multiplicity == 1)
                row->error = fmax(row->error, off / fmax(unit, hypot(root[k].re, root[k].im)));
        }
    row->extra += (size_t)(roots - matched);
}

static void judge_polynomial(const solver *s, size_t i, contest_row *row) {
    size_t n = (size_t)s->on->degree;
    roots_judge(box + i * n, boxes[i], s->root + i * n, s->roots[i], 1, row);
    if (s->proves && row->missed + row->extra > 0)
        cli_fail(CLI_BROKEN, "%s, polynomial %zu: %s and algsurf contradict each other", s->on->name, i,
                 s->program);
}

/* ---- the contest ---- */

static const solver solvers[] = {
    {"algsurf", 0, NULL, 0, 0, NULL, NULL, NULL},
    {"algsurf 1024 at once", ROOTS_AT_ONCE, NULL, 0, 0, NULL, NULL, NULL},
#ifdef WITH_ARB
    {"Arb", 0, by_arb_all, 0, 1, NULL, NULL, NULL},
#endif
#ifdef WITH_MPSOLVE
    {"MPSolve isolate", 0, by_mpsolve_isolate, 0, 0, NULL, NULL, NULL},
    {"MPSolve approximate", 0, by_mpsolve_approximate, 0, 0, NULL, NULL, NULL},
#endif
#ifdef WITH_PARI
    {"PARI", 0, by_pari_all, 0, 0, NULL, NULL, NULL},
#endif
#ifdef WITH_GSL
    {"GSL", 0, by_gsl_all, 1, 0, NULL, NULL, NULL},
#endif
};

enum { SOLVERS = sizeof solvers / sizeof *solvers };

static void contend(const roots_set *on, const roots_effort *effort, contest_table *table) {
    solver own[SOLVERS];
    contestant contestants[SOLVERS];
    contest_row row[SOLVERS];
    size_t count = 0;
    box = must_allocate(on->count * (size_t)on->degree, sizeof *box);
    boxes = must_allocate(on->count, sizeof *boxes);
    packed_box = must_allocate(on->count * (size_t)on->degree, sizeof *packed_box);
    packed_boxes = must_allocate(on->count, sizeof *packed_boxes);
    for (int k = 0; k < SOLVERS; k++) {
        if (solvers[k].real_only && on->im) continue;
        solver *s = &own[count];
        *s = solvers[k];
        s->on = on;
        s->root = must_allocate(on->count * (size_t)on->degree, sizeof *s->root);
        s->roots = must_allocate(on->count, sizeof *s->roots);
        contestants[count] = (contestant){.program = s->program, .solve = solve, .self = s};
        row[count++] = (contest_row){.section = "all roots",
                                     .task = on->name,
                                     .degree = on->degree,
                                     .program = s->program,
                                     .unit = "us"};
    }
    contest_warm_up(contestants, 1, on->count, INFINITY); /* all boxes, to judge by */
    contest_warm_up(contestants + 1, count - 1, on->count, effort->budget);
    compare_packets(on, contestants[1].count);
    for (size_t k = 0; k < count; k++) {
        row[k].count = contestants[k].count;
        for (size_t i = 0; own[k].all && i < contestants[k].count; i++) judge_polynomial(&own[k], i, &row[k]);
    }
    contest_run(contestants, row, count, effort->takes, 1e6, table);
    for (size_t k = 0; k < count; k++) {
        free(own[k].root);
        free(own[k].roots);
    }
    free(box);
    free(boxes);
    free(packed_box);
    free(packed_boxes);
}

void roots_complex(const roots_effort *effort, contest_table *table) {
    static const char *const surfaces[] = {"sphere", "cusp", "tangle", "barth", "barth-decic"};
    static const struct {
        const char *name;
        int degree, complex;
    } random[] = {{"real-16", 16, 0}, {"random-16", 16, 1}, {"random-32", 32, 1}, {"random-64", 64, 1}};
    roots_set on;
    for (size_t i = 0; i < sizeof surfaces / sizeof *surfaces; i++) {
        roots_set_of_rays(&on, surfaces[i], effort->complex);
        contend(&on, effort, table);
        roots_set_free(&on);
    }
    for (size_t i = 0; i < sizeof random / sizeof *random && random[i].degree <= effort->most_degree; i++) {
        roots_set_at_random(&on, random[i].name, random[i].degree, random[i].complex, effort->complex);
        contend(&on, effort, table);
        roots_set_free(&on);
    }
}
