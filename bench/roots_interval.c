/* roots_interval.c - all real roots in [-1,1] of polynomials along rays, by this library and by others.
 *
 * What is right is what algsurf_real_roots proves; Arb, which decides in exact arithmetic, must agree with it
 * on those it gets to; if not there is no table.  The others' answers may be wrong: they are counted. */
#include <math.h>

#include "must.h"
#include "roots.h"

static const double RIGHT = 1e-6; /* an answer is right that is off by no more */

/* The answers are s->count and s->real. */
static void solve_each(const roots_solver *s, size_t begin, size_t end) {
    for (size_t i = begin; i < end; i++)
        s->count[i] = s->by.interval(roots_set_at(s->on, s->on->c, i), s->on->degree,
                                     s->real + i * (size_t)s->on->degree);
}

static int find_here(const double *c, int degree, double *roots) {
    algsurf_real_root found[ALGSURF_MAX_DEGREE];
    int count;
    must(algsurf_real_roots(c, degree, -1, 1, found, ALGSURF_MAX_DEGREE, &count), "real roots");
    for (int i = 0; i < count; i++) roots[i] = found[i].root;
    return count;
}

static void solve_packet(const roots_solver *s, size_t begin, size_t end) {
    static algsurf_real_root found[ROOTS_AT_ONCE * ALGSURF_MAX_DEGREE];
    size_t n = (size_t)s->on->degree;
    const double lo = -1, hi = 1;
    const algsurf_real_batch packet = {.size = sizeof packet,
                                       .count = end - begin,
                                       .degree = s->on->degree,
                                       .coefficients = roots_set_rows(s->on, s->on->c, begin),
                                       .lo = &lo,
                                       .hi = &hi};
    must(algsurf_real_roots_batch(&packet, NULL, found, s->count + begin), "packet");
    for (size_t i = begin; i < end; i++)
        for (int k = 0; k < s->count[i]; k++)
            s->real[i * n + (size_t)k] = found[(i - begin) * n + (size_t)k].root;
}

/* ---- the contest ---- */

static const roots_solver solvers[] = {
    {.program = "algsurf", .solve = solve_each, .by.interval = find_here, .proves = 1},
    {.program = "algsurf 1024 at once", .solve = solve_packet, .packet = ROOTS_AT_ONCE, .proves = 1},
    {.program = "algsurf 8 at once", .solve = solve_packet, .packet = ROOTS_FEW, .proves = 1},
#ifdef WITH_CYPOLYNOMIAL
    {.program = "cyPolynomial", .solve = solve_each, .by.interval = by_cy_interval},
#endif
#ifdef WITH_GSL
    {.program = "GSL", .solve = solve_each, .by.interval = by_gsl_interval},
#endif
#ifdef WITH_PARI
    {.program = "PARI", .solve = solve_each, .by.interval = by_pari_interval},
#endif
#ifdef WITH_ARB
    {.program = "Arb", .solve = solve_each, .by.interval = by_arb_interval, .proves = 1},
#endif
};

/* Of one polynomial: both are in increasing order. */
static void compare(const double *truth, int roots, const double *answer, int answers, contest_row *row) {
    int i = 0, k = 0;
    while (i < roots && k < answers) {
        double off = fabs(answer[k] - truth[i]);
        if (off <= RIGHT) {
            row->error = fmax(row->error, off);
            i++, k++;
        } else if (answer[k] < truth[i]) {
            row->extra++, k++;
        } else {
            row->missed++, i++;
        }
    }
    row->missed += (size_t)(roots - i);
    row->extra += (size_t)(answers - k);
}

static void judge(const roots_solver *s, const roots_solver *first, contest_row *row) {
    size_t n = (size_t)s->on->degree;
    for (size_t i = 0; i < row->count; i++)
        compare(first->real + i * n, first->count[i], s->real + i * n, s->count[i], row);
    if (s->packet && row->error > 0) cli_fail(CLI_BROKEN, "%s: packets and single calls differ", s->on->name);
}

void roots_interval(const roots_effort *effort, contest_table *table) {
    static const char *const surfaces[] = {"sphere", "cusp", "tangle", "barth", "barth-decic"};
    const roots_contest contest = {"interval", "ns", solvers, sizeof solvers / sizeof *solvers, judge, 0};
    for (size_t i = 0; i < sizeof surfaces / sizeof *surfaces; i++) {
        roots_set on;
        roots_set_of_rays(&on, surfaces[i], effort->real);
        roots_contend(&contest, &on, effort, table);
        roots_set_free(&on);
    }
}
