/* roots_first.c - the first real root in [-1,1] of polynomials along rays, by this library and by others.
 *
 * What is right is what algsurf_isolate_first proves, refined as far as double goes.  The library's packets
 * must agree with it on every polynomial; if not there is no table.  The others' answers may be wrong: they
 * are counted. */
#include <math.h>

#include "must.h"
#include "roots.h"

static const double TOLERANCE = 1e-12; /* asked for: half of the final bracket; the chord is 2 long */
static const double RIGHT = 1e-6;      /* an answer is right that is off by no more */

/* ---- this library ---- */

static double refine_here(const double *c, int degree, double lo, double hi, double tolerance) {
    const algsurf_refine_options options = {.size = sizeof options, .absolute_tolerance = 2 * tolerance};
    algsurf_refined_root root;
    must_answer(algsurf_refine_poly(c, NULL, degree, lo, hi, &options, &root), "refinement");
    return root.root;
}

static double first_root(const double *c, int degree, other_refine *refine, double tolerance) {
    algsurf_bracket bracket;
    int found;
    must_answer(algsurf_isolate_first(c, NULL, degree, -1, 1, NULL, &bracket, &found), "isolation");
    if (!found) return NAN;
    if (bracket.lo == bracket.hi) return bracket.lo;
    return refine(c, degree, bracket.lo, bracket.hi, tolerance);
}

/* In two steps, the second by the solver; the answers are s->real, NaN: none. */
static void solve_in_steps(const roots_solver *s, size_t begin, size_t end) {
    for (size_t i = begin; i < end; i++)
        s->real[i] = first_root(roots_set_at(s->on, s->on->c, i), s->on->degree, s->by.refine, TOLERANCE);
}

static void solve_each(const roots_solver *s, size_t begin, size_t end) {
    for (size_t i = begin; i < end; i++)
        s->real[i] = s->by.first(roots_set_at(s->on, s->on->c, i), s->on->degree);
}

static void solve_packet(const roots_solver *s, size_t begin, size_t end) {
    unsigned char state[ROOTS_AT_ONCE];
    const double lo = -1, hi = 1;
    const algsurf_real_batch packet = {.size = sizeof packet,
                                       .count = end - begin,
                                       .degree = s->on->degree,
                                       .coefficients = roots_set_rows(s->on, s->on->c, begin),
                                       .lo = &lo,
                                       .hi = &hi};
    must_answer(algsurf_first_roots_batch(&packet, NULL, state, s->real + begin), "packet");
    for (size_t i = 0; i < packet.count; i++) /* +inf is none there */
        if (state[i] != ALGSURF_FIRST_ROOT_FOUND) s->real[begin + i] = NAN;
}

/* ---- the contest ---- */

static const roots_solver solvers[] = {
    {.program = "algsurf", .solve = solve_packet, .packet = 1, .proves = 1},
    {.program = "algsurf in two steps", .solve = solve_in_steps, .by.refine = refine_here},
    {.program = "algsurf 1024 at once", .solve = solve_packet, .packet = ROOTS_AT_ONCE, .proves = 1},
    {.program = "algsurf 8 at once", .solve = solve_packet, .packet = ROOTS_FEW, .proves = 1},
#ifdef WITH_CYPOLYNOMIAL
    {.program = "cyPolynomial", .solve = solve_each, .by.first = by_cy_first},
#endif
#ifdef WITH_BOOST
    {.program = "isolated + TOMS 748", .solve = solve_in_steps, .by.refine = by_toms748},
#endif
#ifdef WITH_GSL
    {.program = "GSL", .solve = solve_each, .by.first = by_gsl_first},
#endif
#ifdef WITH_PARI
    {.program = "PARI", .solve = solve_each, .by.first = by_pari_first},
#endif
};

static void judge(const roots_solver *s, const roots_solver *first, contest_row *row) {
    (void)first; /* to 1e-12 only */
    for (size_t i = 0; i < row->count; i++) {
        double truth = first_root(roots_set_at(s->on, s->on->c, i), s->on->degree, refine_here, 0);
        double off = fabs(s->real[i] - truth);
        if (isnan(truth))
            row->extra += isnan(s->real[i]) == 0;
        else if (!(off <= RIGHT))
            row->missed++;
        else
            row->error = fmax(row->error, off);
    }
}

void roots_first(const roots_effort *effort, contest_table *table) {
    static const char *const surfaces[] = {"sphere", "cusp",  "torus",      "tangle",
                                           "boy",    "barth", "barth-decic"};
    static const struct {
        const char *name;
        int degree;
    } grazing[] = {{"grazing-4", 4}, {"grazing-6", 6}, {"grazing-10", 10}};
    const roots_contest contest = {"first root", "ns", solvers, sizeof solvers / sizeof *solvers, judge, 0};
    roots_set on;
    for (size_t i = 0; i < sizeof surfaces / sizeof *surfaces; i++) {
        roots_set_of_rays(&on, surfaces[i], effort->real);
        roots_contend(&contest, &on, effort, table);
        roots_set_free(&on);
    }
    for (size_t i = 0; i < sizeof grazing / sizeof *grazing; i++) {
        roots_set_grazing(&on, grazing[i].name, grazing[i].degree, effort->real);
        roots_contend(&contest, &on, effort, table);
        roots_set_free(&on);
    }
}
