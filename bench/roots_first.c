/* roots_first.c - the first real root in [-1,1] of polynomials along rays, by this library and by others.
 *
 * What is right is what algsurf_isolate_first proves, refined as far as double goes.  The library's packets
 * must agree with it on every polynomial; if not there is no table.  The others' answers may be wrong: they
 * are counted. */
#include <math.h>
#include <stdlib.h>

#include "cli.h"
#include "must.h"
#include "roots.h"
#include "roots_others.h"

static const double TOLERANCE = 1e-12; /* asked for: half of the final bracket; the chord is 2 long */
static const double RIGHT = 1e-6;      /* an answer is right that is off by no more */

/* A contestant: by packets of so many, or by one of the two. */
typedef struct solver {
    const char *program;
    size_t packet;
    other_first *first;
    other_refine *refine;
    const roots_set *on;
    double *answer; /* NaN: none */
} solver;

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

static void solve_packet(const solver *s, size_t begin, size_t end) {
    unsigned char state[ROOTS_AT_ONCE];
    const double lo = -1, hi = 1;
    const algsurf_real_batch packet = {.size = sizeof packet,
                                       .count = end - begin,
                                       .degree = s->on->degree,
                                       .coefficients = roots_set_rows(s->on, s->on->c, begin),
                                       .lo = &lo,
                                       .hi = &hi};
    must_answer(algsurf_first_roots_batch(&packet, NULL, state, s->answer + begin), "packet");
    for (size_t i = 0; i < packet.count; i++) /* +inf is none there */
        if (state[i] != ALGSURF_FIRST_ROOT_FOUND) s->answer[begin + i] = NAN;
}

static void solve(void *self, size_t begin, size_t end) {
    const solver *s = self;
    size_t stride = (size_t)s->on->degree + 1, step = s->packet ? s->packet : 1;
    for (size_t i = begin; i < end; i += step) {
        const double *c = s->on->c + i * stride;
        if (s->packet)
            solve_packet(s, i, end - i < step ? end : i + step);
        else
            s->answer[i] =
                s->first ? s->first(c, s->on->degree) : first_root(c, s->on->degree, s->refine, TOLERANCE);
    }
}

/* ---- the contest ---- */

static const solver solvers[] = {
    {"algsurf", 1, NULL, NULL, NULL, NULL},
    {"algsurf in two steps", 0, NULL, refine_here, NULL, NULL},
    {"algsurf 1024 at once", ROOTS_AT_ONCE, NULL, NULL, NULL, NULL},
    {"algsurf 8 at once", ROOTS_FEW, NULL, NULL, NULL, NULL},
#ifdef WITH_CYPOLYNOMIAL
    {"cyPolynomial", 0, by_cy_first, NULL, NULL, NULL},
#endif
#ifdef WITH_BOOST
    {"isolated + TOMS 748", 0, NULL, by_toms748, NULL, NULL},
#endif
#ifdef WITH_GSL
    {"GSL", 0, by_gsl_first, NULL, NULL, NULL},
#endif
#ifdef WITH_PARI
    {"PARI", 0, by_pari_first, NULL, NULL, NULL},
#endif
};

enum { SOLVERS = sizeof solvers / sizeof *solvers };

static void judge(const solver *s, const double *truth, contest_row *row) {
    for (size_t i = 0; i < row->count; i++) {
        if (isnan(truth[i]))
            row->extra += isnan(s->answer[i]) == 0;
        else if (!(fabs(s->answer[i] - truth[i]) <= RIGHT))
            row->missed++;
        else
            row->error = fmax(row->error, fabs(s->answer[i] - truth[i]));
    }
    if (s->packet && row->missed + row->extra > 0)
        cli_fail(CLI_BROKEN, "%s: packets and single calls contradict each other", s->on->name);
}

static void contend(const roots_set *on, const roots_effort *effort, contest_table *table) {
    solver own[SOLVERS];
    contestant contestants[SOLVERS];
    double *truth = must_allocate(on->count, sizeof *truth);
    for (size_t i = 0; i < on->count; i++)
        truth[i] = first_root(on->c + i * ((size_t)on->degree + 1), on->degree, refine_here, 0);
    for (int k = 0; k < SOLVERS; k++) {
        own[k] = solvers[k];
        own[k].on = on;
        own[k].answer = must_allocate(on->count, sizeof *own[k].answer);
        contestants[k] = (contestant){.program = own[k].program, .solve = solve, .self = &own[k]};
    }
    contest_warm_up(contestants, SOLVERS, on->count, effort->budget);
    contest_row row[SOLVERS];
    for (int k = 0; k < SOLVERS; k++) {
        row[k] = (contest_row){.section = "first root",
                               .task = on->name,
                               .degree = on->degree,
                               .program = own[k].program,
                               .unit = "ns",
                               .count = contestants[k].count};
        judge(&own[k], truth, &row[k]);
    }
    contest_run(contestants, row, SOLVERS, effort->takes, 1e9, table);
    for (int k = 0; k < SOLVERS; k++) free(own[k].answer);
    free(truth);
}

void roots_first(const roots_effort *effort, contest_table *table) {
    static const char *const surfaces[] = {"sphere", "cusp",  "torus",      "tangle",
                                           "boy",    "barth", "barth-decic"};
    static const struct {
        const char *name;
        int degree;
    } grazing[] = {{"grazing-4", 4}, {"grazing-6", 6}, {"grazing-10", 10}};
    roots_set on;
    for (size_t i = 0; i < sizeof surfaces / sizeof *surfaces; i++) {
        roots_set_of_rays(&on, surfaces[i], effort->real);
        contend(&on, effort, table);
        roots_set_free(&on);
    }
    for (size_t i = 0; i < sizeof grazing / sizeof *grazing; i++) {
        roots_set_grazing(&on, grazing[i].name, grazing[i].degree, effort->real);
        contend(&on, effort, table);
        roots_set_free(&on);
    }
}
