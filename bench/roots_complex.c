/* roots_complex.c - all complex roots of a polynomial, by this library and by others.
 *
 * This library's boxes are proved to hold the roots; so are Arb's balls.  Each of the others' roots is
 * matched with a box, and each box takes as many roots as it holds.  Where Arb and this library contradict
 * each other there is no table; of the others, roots are counted that match no box, and boxes left without.
 */
#include <math.h>
#include <string.h>

#include "must.h"
#include "roots.h"

static const double RIGHT = 1e-6;     /* of a root without a disc */
static const double ROUNDING = 1e-15; /* centres and radii of discs were rounded to doubles: some 4 2^-53 */

/* This library's answers are s->count and s->box, one by one or in packets; the others' s->count and s->root.
 */
static void solve_here(const roots_solver *s, size_t begin, size_t end) {
    const roots_set *on = s->on;
    const int n = on->degree;
    algsurf_complex c[ALGSURF_MAX_DEGREE + 1];
    for (size_t i = begin; i < end; i++) {
        const double *re = roots_set_at(on, on->c, i), *im = roots_set_at(on, on->im, i);
        algsurf_complex_root *box = s->box + i * (size_t)n;
        for (int k = 0; im && k <= n; k++) c[k] = (algsurf_complex){re[k], im[k]};
        must(im ? algsurf_complex_roots(c, NULL, n, box, &s->count[i])
                : algsurf_complex_roots_of_real(re, NULL, n, box, &s->count[i]),
             on->name);
    }
}

static void solve_packet(const roots_solver *s, size_t begin, size_t end) {
    const algsurf_complex_batch packet = {.size = sizeof packet,
                                          .count = end - begin,
                                          .degree = s->on->degree,
                                          .re = roots_set_rows(s->on, s->on->c, begin),
                                          .im = roots_set_rows(s->on, s->on->im, begin)};
    must(algsurf_complex_roots_batch(&packet, NULL, s->box + begin * (size_t)s->on->degree, s->count + begin),
         s->on->name);
}

static void solve_each(const roots_solver *s, size_t begin, size_t end) {
    const roots_set *on = s->on;
    for (size_t i = begin; i < end; i++)
        s->count[i] = s->by.all(roots_set_at(on, on->c, i), roots_set_at(on, on->im, i), on->degree,
                                s->root + i * (size_t)on->degree);
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

/* ---- the contest ---- */

static const roots_solver solvers[] = {
    {.program = "algsurf", .solve = solve_here},
    {.program = "algsurf 1024 at once", .solve = solve_packet, .packet = ROOTS_AT_ONCE},
#ifdef WITH_ARB
    {.program = "Arb", .solve = solve_each, .by.all = by_arb_all, .proves = 1},
#endif
#ifdef WITH_MPSOLVE
    {.program = "MPSolve isolate", .solve = solve_each, .by.all = by_mpsolve_isolate},
    {.program = "MPSolve approximate", .solve = solve_each, .by.all = by_mpsolve_approximate},
#endif
#ifdef WITH_PARI
    {.program = "PARI", .solve = solve_each, .by.all = by_pari_all},
#endif
#ifdef WITH_GSL
    {.program = "GSL", .solve = solve_each, .by.all = by_gsl_all, .real_only = 1},
#endif
};

/* Packets must give the bits of single calls. */
static void judge(const roots_solver *s, const roots_solver *first, contest_row *row) {
    for (size_t i = 0; i < row->count; i++) {
        size_t at = i * (size_t)s->on->degree, boxes = (size_t)first->count[i];
        if (s->by.all)
            roots_judge(first->box + at, first->count[i], s->root + at, s->count[i], 1, row);
        else if (s->count[i] != first->count[i] ||
                 memcmp(s->box + at, first->box + at, boxes * sizeof *s->box) != 0)
            cli_fail(CLI_BROKEN, "%s, polynomial %zu: packets and single calls differ", s->on->name, i);
    }
}

void roots_complex(const roots_effort *effort, contest_table *table) {
    static const char *const surfaces[] = {"sphere", "cusp", "tangle", "barth", "barth-decic"};
    static const struct {
        const char *name;
        int degree, complex;
    } random[] = {{"real-16", 16, 0}, {"random-16", 16, 1}, {"random-32", 32, 1}, {"random-64", 64, 1}};
    const roots_contest contest = {"all roots", "us", solvers, sizeof solvers / sizeof *solvers, judge, 0};
    roots_set on;
    for (size_t i = 0; i < sizeof surfaces / sizeof *surfaces; i++) {
        roots_set_of_rays(&on, surfaces[i], effort->complex);
        roots_contend(&contest, &on, effort, table);
        roots_set_free(&on);
    }
    for (size_t i = 0; i < sizeof random / sizeof *random && random[i].degree <= effort->most_degree; i++) {
        roots_set_at_random(&on, random[i].name, random[i].degree, random[i].complex, effort->complex);
        roots_contend(&contest, &on, effort, table);
        roots_set_free(&on);
    }
}
