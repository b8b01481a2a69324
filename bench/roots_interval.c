/* roots_interval.c - all real roots in [-1,1] of polynomials along rays, by this library and by others.
 *
 * What is right is what algsurf_real_roots proves; Arb, which decides in exact arithmetic, must agree with it
 * on those it gets to; if not there is no table.  The others' answers may be wrong: they are counted. */
#include <math.h>
#include <stdlib.h>

#include "cli.h"
#include "must.h"
#include "roots.h"
#include "roots_others.h"

static const double RIGHT = 1e-6; /* an answer is right that is off by no more */

/* A contestant: by one call each, or by packets of so many. */
typedef struct solver {
    const char *program;
    size_t packet;
    other_interval *find;
    int proves; /* its answers must be right */
    const roots_set *on;
    double *root;
    int *count;
} solver;

static int find_here(const double *c, int degree, double *roots) {
    algsurf_real_root found[ALGSURF_MAX_DEGREE];
    int count;
    algsurf_status status = algsurf_real_roots(c, degree, -1, 1, found, ALGSURF_MAX_DEGREE, &count);
    if (status != ALGSURF_OK) cli_fail(CLI_BROKEN, "real roots: %s", algsurf_status_text(status));
    for (int i = 0; i < count; i++) roots[i] = found[i].root;
    return count;
}

static void solve_packet(const solver *s, size_t begin, size_t end) {
    static algsurf_real_root found[ROOTS_AT_ONCE * ALGSURF_MAX_DEGREE];
    size_t n = (size_t)s->on->degree;
    const double lo = -1, hi = 1;
    const algsurf_real_batch packet = {.size = sizeof packet,
                                       .count = end - begin,
                                       .degree = s->on->degree,
                                       .coefficients = roots_set_rows(s->on, s->on->c, begin),
                                       .lo = &lo,
                                       .hi = &hi};
    algsurf_status status = algsurf_real_roots_batch(&packet, NULL, found, s->count + begin);
    if (status != ALGSURF_OK) cli_fail(CLI_BROKEN, "packet: %s", algsurf_status_text(status));
    for (size_t i = begin; i < end; i++)
        for (int k = 0; k < s->count[i]; k++)
            s->root[i * n + (size_t)k] = found[(i - begin) * n + (size_t)k].root;
}

static void solve(void *self, size_t begin, size_t end) {
    const solver *s = self;
    size_t n = (size_t)s->on->degree, step = s->packet ? s->packet : 1;
    for (size_t i = begin; i < end; i += step)
        if (s->packet)
            solve_packet(s, i, end - i < step ? end : i + step);
        else
            s->count[i] = s->find(s->on->c + i * (n + 1), s->on->degree, s->root + i * n);
}

/* ---- the contest ---- */

static const solver solvers[] = {
    {"algsurf", 0, find_here, 1, NULL, NULL, NULL},
    {"algsurf 1024 at once", ROOTS_AT_ONCE, NULL, 1, NULL, NULL, NULL},
    {"algsurf 8 at once", ROOTS_FEW, NULL, 1, NULL, NULL, NULL},
#ifdef WITH_CYPOLYNOMIAL
    {"cyPolynomial", 0, by_cy_interval, 0, NULL, NULL, NULL},
#endif
#ifdef WITH_GSL
    {"GSL", 0, by_gsl_interval, 0, NULL, NULL, NULL},
#endif
#ifdef WITH_PARI
    {"PARI", 0, by_pari_interval, 0, NULL, NULL, NULL},
#endif
#ifdef WITH_ARB
    {"Arb", 0, by_arb_interval, 1, NULL, NULL, NULL},
#endif
};

enum { SOLVERS = sizeof solvers / sizeof *solvers };

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

static void judge(const solver *s, const solver *truth, contest_row *row) {
    size_t n = (size_t)s->on->degree;
    for (size_t i = 0; i < row->count; i++)
        compare(truth->root + i * n, truth->count[i], s->root + i * n, s->count[i], row);
    if (s->packet && row->error > 0) cli_fail(CLI_BROKEN, "%s: packets and single calls differ", s->on->name);
    if (s->proves && row->missed + row->extra > 0)
        cli_fail(CLI_BROKEN, "%s: %s and algsurf contradict each other", s->on->name, s->program);
}

static void contend(const roots_set *on, const roots_effort *effort, contest_table *table) {
    solver own[SOLVERS];
    contestant contestants[SOLVERS];
    contest_row row[SOLVERS];
    for (int k = 0; k < SOLVERS; k++) {
        own[k] = solvers[k];
        own[k].on = on;
        own[k].root = must_allocate(on->count * (size_t)on->degree, sizeof *own[k].root);
        own[k].count = must_allocate(on->count, sizeof *own[k].count);
        contestants[k] = (contestant){.program = own[k].program, .solve = solve, .self = &own[k]};
    }
    contest_warm_up(contestants, 1, on->count, INFINITY); /* all of them, to judge by */
    contest_warm_up(contestants + 1, SOLVERS - 1, on->count, effort->budget);
    for (int k = 0; k < SOLVERS; k++) {
        row[k] = (contest_row){.section = "interval",
                               .task = on->name,
                               .degree = on->degree,
                               .program = own[k].program,
                               .unit = "ns",
                               .count = contestants[k].count};
        judge(&own[k], &own[0], &row[k]);
    }
    contest_run(contestants, row, SOLVERS, effort->takes, 1e9, table);
    for (int k = 0; k < SOLVERS; k++) {
        free(own[k].root);
        free(own[k].count);
    }
}

void roots_interval(const roots_effort *effort, contest_table *table) {
    static const char *const surfaces[] = {"sphere", "cusp", "tangle", "barth", "barth-decic"};
    for (size_t i = 0; i < sizeof surfaces / sizeof *surfaces; i++) {
        roots_set on;
        roots_set_of_rays(&on, surfaces[i], effort->real);
        contend(&on, effort, table);
        roots_set_free(&on);
    }
}
