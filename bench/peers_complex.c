/* peers_complex.c - all complex roots of a polynomial, by this library and by others.
 *
 * This library's boxes are proved to hold the roots; so are Arb's balls.  Each of the others' roots is
 * matched with a box, and each box takes as many roots as it holds: a disc must reach the box, a root without
 * a disc must come within 1e-6 of it (relative to 1 or its size).  Where Arb and this library contradict each
 * other there is no table; of the others, roots are counted that match no box, and boxes left without.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "algsurf/algsurf.h"
#include "cli.h"
#include "measure.h"
#include "peers.h"
#include "peers_rays.h"
#include "peers_solver.h"

static const double RIGHT = 1e-6;     /* of a root without a disc */
static const double ROUNDING = 1e-15; /* centres and radii of discs were rounded to doubles: some 4 2^-53 */

typedef struct set {
    const char *name;
    int degree, real;
    size_t count;
    double *re, *im; /* polynomial by polynomial */
    algsurf_enclosure *box;
    int *boxes;
} set;

/* all: null for this library. */
typedef struct solver {
    const char *program;
    peer_all *all;
    int real_only, proves;
    set *on;
    peer_root *root;
    int *roots;
} solver;

static void solve_here(set *on, size_t i) {
    size_t n = (size_t)on->degree, from = i * (n + 1);
    algsurf_complex c[ALGSURF_MAX_DEGREE + 1];
    algsurf_enclosure *box = on->box + i * n;
    for (size_t k = 0; k <= n; k++) c[k] = (algsurf_complex){on->re[from + k], on->im[from + k]};
    algsurf_status status = on->real ? algsurf_roots_real(on->re + from, NULL, on->degree, box, &on->boxes[i])
                                     : algsurf_roots(c, NULL, on->degree, box, &on->boxes[i]);
    if (status != ALGSURF_OK)
        cli_fail(CLI_BROKEN, "%s, polynomial %zu: %s", on->name, i, algsurf_status_text(status));
}

static void solve(void *self, size_t begin, size_t end) {
    const solver *s = self;
    size_t n = (size_t)s->on->degree;
    for (size_t i = begin; i < end; i++)
        if (s->all)
            s->roots[i] = s->all(s->on->re + i * (n + 1), s->on->real ? NULL : s->on->im + i * (n + 1),
                                 s->on->degree, s->root + i * n);
        else
            solve_here(s->on, i);
}

/* ---- the polynomials ---- */

static void *allocate(size_t count, size_t size) {
    void *memory = calloc(count, size);
    if (!memory) cli_no_memory();
    return memory;
}

static void make_room(set *s) {
    size_t n = (size_t)s->degree;
    s->re = allocate(s->count * (n + 1), sizeof *s->re);
    s->im = allocate(s->count * (n + 1), sizeof *s->im);
    s->box = allocate(s->count * n, sizeof *s->box);
    s->boxes = allocate(s->count, sizeof *s->boxes);
}

static void open_rays(set *s, const char *name, size_t count) {
    const catalogue_entry *entry = catalogue_find(name);
    *s = (set){.name = name, .degree = entry->degree, .real = 1, .count = count};
    make_room(s);
    peers_rays(entry, 2, count, s->re);
}

/* Coefficients uniform in [-1,1] x [-1,1] i. */
static void open_random(set *s, const char *name, int degree, size_t count) {
    measure_random random = {(uint64_t)degree};
    *s = (set){.name = name, .degree = degree, .count = count};
    make_room(s);
    for (size_t i = 0; i < count * ((size_t)degree + 1); i++) {
        s->re[i] = measure_uniform(&random, -1, 1);
        s->im[i] = measure_uniform(&random, -1, 1);
    }
}

static void close_set(set *s) {
    free(s->re);
    free(s->im);
    free(s->box);
    free(s->boxes);
}

/* ---- right or wrong ---- */

static double outside(algsurf_interval interval, double x) {
    return fmax(0, fmax(interval.lo - x, x - interval.hi));
}

static double reach(const peer_root *root) {
    double size = hypot(root->re, root->im);
    return isnan(root->radius) ? RIGHT * fmax(1, size) : root->radius + ROUNDING * size;
}

/* The nearest root without a box that reaches this one; -1: none. */
static int nearest(const algsurf_enclosure *box, const peer_root *root, const char *taken, int roots) {
    double least = INFINITY;
    int best = -1;
    for (int k = 0; k < roots; k++) {
        double away = hypot(outside(box->box.re, root[k].re), outside(box->box.im, root[k].im));
        if (taken[k] || !(away <= reach(&root[k])) || away >= least) continue;
        least = away;
        best = k;
    }
    return best;
}

static void judge_polynomial(const solver *s, size_t i, peers_row *row) {
    size_t n = (size_t)s->on->degree;
    const algsurf_enclosure *box = s->on->box + i * n;
    const peer_root *root = s->root + i * n;
    char taken[ALGSURF_MAX_DEGREE] = {0};
    int matched = 0;
    for (int b = 0; b < s->on->boxes[i]; b++)
        for (int m = 0; m < box[b].multiplicity; m++) {
            int k = nearest(&box[b], root, taken, s->roots[i]);
            if (k < 0) {
                row->missed++;
                continue;
            }
            taken[k] = 1;
            matched++;
            double off = hypot(root[k].re - box[b].value.re, root[k].im - box[b].value.im);
            if (box[b].multiplicity == 1)
                row->error = fmax(row->error, off / fmax(1, hypot(root[k].re, root[k].im)));
        }
    row->extra += (size_t)(s->roots[i] - matched);
    if (s->proves && row->missed + row->extra > 0)
        cli_fail(CLI_BROKEN, "%s, polynomial %zu: %s and algsurf contradict each other", s->on->name, i,
                 s->program);
}

/* ---- the contest ---- */

static const solver solvers[] = {
    {"algsurf", NULL, 0, 0, NULL, NULL, NULL},
#ifdef WITH_ARB
    {"Arb", peer_arb_all, 0, 1, NULL, NULL, NULL},
#endif
#ifdef WITH_MPSOLVE
    {"MPSolve isolate", peer_mpsolve_isolate, 0, 0, NULL, NULL, NULL},
    {"MPSolve approximate", peer_mpsolve_approximate, 0, 0, NULL, NULL, NULL},
#endif
#ifdef WITH_PARI
    {"PARI", peer_pari_all, 0, 0, NULL, NULL, NULL},
#endif
#ifdef WITH_GSL
    {"GSL", peer_gsl_all, 1, 0, NULL, NULL, NULL},
#endif
};

enum { SOLVERS = sizeof solvers / sizeof *solvers };

static void contend(set *on, const peers_effort *effort, peers_table *table) {
    solver own[SOLVERS];
    peers_contestant contestant[SOLVERS];
    peers_row row[SOLVERS];
    size_t count = 0;
    for (int k = 0; k < SOLVERS; k++) {
        if (solvers[k].real_only && !on->real) continue;
        solver *s = &own[count];
        *s = solvers[k];
        s->on = on;
        s->root = allocate(on->count * (size_t)on->degree, sizeof *s->root);
        s->roots = allocate(on->count, sizeof *s->roots);
        contestant[count] = (peers_contestant){.program = s->program, .solve = solve, .self = s};
        row[count++] = (peers_row){.section = "all roots",
                                   .task = on->name,
                                   .degree = on->degree,
                                   .program = s->program,
                                   .unit = "us"};
    }
    peers_warm_up(contestant, 1, on->count, INFINITY); /* all boxes, to judge by */
    peers_warm_up(contestant + 1, count - 1, on->count, effort->budget);
    for (size_t k = 0; k < count; k++) {
        row[k].count = contestant[k].count;
        for (size_t i = 0; own[k].all && i < contestant[k].count; i++) judge_polynomial(&own[k], i, &row[k]);
    }
    peers_contend(contestant, count, effort->takes);
    for (size_t k = 0; k < count; k++) {
        peers_tell_time(&row[k], contestant[k].seconds, (size_t)effort->takes, 1e6);
        peers_add(table, &row[k]);
        free(own[k].root);
        free(own[k].roots);
    }
}

void peers_all_roots(const peers_effort *effort, peers_table *table) {
    static const char *const names[] = {"tangle", "barth", "barth-decic"};
    static const struct {
        const char *name;
        int degree;
    } random[] = {{"random-16", 16}, {"random-32", 32}, {"random-64", 64}};
    set on;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        open_rays(&on, names[i], effort->complex);
        contend(&on, effort, table);
        close_set(&on);
    }
    for (size_t i = 0; i < sizeof random / sizeof *random && random[i].degree <= effort->most_degree; i++) {
        open_random(&on, random[i].name, random[i].degree, effort->complex);
        contend(&on, effort, table);
        close_set(&on);
    }
}
