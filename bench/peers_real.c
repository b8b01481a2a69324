/* peers_real.c - the first real root in [-1,1] of polynomials along rays, by this library and by others.
 *
 * What is right is what algsurf_isolate_first proves, refined as far as double goes; polynomials that it
 * leaves undecided judge nobody.  The library's packets must agree with it on every polynomial, and so must
 * Arb, which decides in exact arithmetic, on those it gets to; if not there is no table.  The others' answers
 * may be wrong: they are counted.
 */
#include <math.h>
#include <stdlib.h>

#include "algsurf/algsurf.h"
#include "cli.h"
#include "peers.h"
#include "peers_rays.h"
#include "peers_solver.h"

static const double TOLERANCE = 1e-12; /* asked for: half of the final bracket; the chord is 2 long */
static const double RIGHT = 1e-6;      /* an answer is right that is off by no more */

enum { PACKET = 1024, MOST_COLUMNS = ALGSURF_MAX_DEGREE + 1 };

typedef struct set {
    const char *name;
    int degree;
    size_t count;
    double *c;                    /* polynomial by polynomial */
    double *column[MOST_COLUMNS]; /* the same coefficients, power by power */
    double *lo, *hi;              /* -1 and 1 for each */
    double *truth;                /* the first root; NaN: none; infinite: open */
} set;

/* A contestant: one of the three is set, or none of them for the packets. */
typedef struct solver {
    const char *program;
    peer_first *first;
    peer_refine *refine;
    int proves; /* its answers must be right */
    const set *on;
    double *answer;
} solver;

static void must(algsurf_status status, const char *what) {
    if (status < 0) cli_fail(CLI_BROKEN, "%s: %s", what, algsurf_status_text(status));
}

/* ---- this library ---- */

static double refine_here(const double *c, int degree, double lo, double hi, double tolerance) {
    const algsurf_refine_options options = {.size = sizeof options, .tolerance = tolerance};
    algsurf_root root;
    must(algsurf_refine_poly(c, degree, lo, hi, &options, &root), "refinement");
    return root.root;
}

/* The first root, refined in that way; NaN: none; infinite: undecided. */
static double first_root(const double *c, int degree, peer_refine *refine, double tolerance) {
    algsurf_bracket bracket;
    int found;
    must(algsurf_isolate_first(c, NULL, degree, -1, 1, &bracket, &found), "isolation");
    if (!found) return NAN;
    if (bracket.kind == ALGSURF_ROOT_EXACT) return bracket.lo;
    if (bracket.kind == ALGSURF_ROOT_UNDECIDED) return INFINITY;
    return refine(c, degree, bracket.lo, bracket.hi, tolerance);
}

static void solve_packet(const solver *s, size_t begin, size_t end) {
    const double *column[MOST_COLUMNS];
    unsigned char state[PACKET];
    for (int k = 0; k <= s->on->degree; k++) column[k] = s->on->column[k] + begin;
    const algsurf_poly_packet packet = {.size = sizeof packet,
                                        .count = end - begin,
                                        .degree = s->on->degree,
                                        .c = column,
                                        .lo = s->on->lo,
                                        .hi = s->on->hi};
    must(algsurf_first_roots(&packet, NULL, state, s->answer + begin), "packet");
    for (size_t i = 0; i < packet.count; i++) /* +inf is none there */
        if (state[i] != ALGSURF_FIRST_ROOT_FOUND)
            s->answer[begin + i] = state[i] == ALGSURF_FIRST_ROOT_NONE ? NAN : INFINITY;
}

static void solve(void *self, size_t begin, size_t end) {
    const solver *s = self;
    size_t stride = (size_t)s->on->degree + 1;
    if (s->first)
        for (size_t i = begin; i < end; i++) s->answer[i] = s->first(s->on->c + i * stride, s->on->degree);
    else if (s->refine)
        for (size_t i = begin; i < end; i++)
            s->answer[i] = first_root(s->on->c + i * stride, s->on->degree, s->refine, TOLERANCE);
    else
        for (size_t i = begin; i < end; i += PACKET) solve_packet(s, i, end - i < PACKET ? end : i + PACKET);
}

/* ---- the polynomials ---- */

static double *numbers(size_t count) {
    double *memory = calloc(count, sizeof *memory);
    if (!memory) cli_no_memory();
    return memory;
}

static void open_set(set *s, const char *name, size_t count) {
    const catalogue_entry *entry = catalogue_find(name);
    *s = (set){.name = name, .degree = entry->degree, .count = count};
    size_t stride = (size_t)s->degree + 1;
    s->c = numbers(count * stride);
    s->lo = numbers(count);
    s->hi = numbers(count);
    s->truth = numbers(count);
    peers_rays(entry, 1, count, s->c);
    for (size_t k = 0; k < stride; k++) {
        s->column[k] = numbers(count);
        for (size_t i = 0; i < count; i++) s->column[k][i] = s->c[i * stride + k];
    }
    for (size_t i = 0; i < count; i++) {
        s->lo[i] = -1;
        s->hi[i] = 1;
        s->truth[i] = first_root(s->c + i * stride, s->degree, refine_here, 0);
    }
}

static void close_set(set *s) {
    for (int k = 0; k <= s->degree; k++) free(s->column[k]);
    free(s->c);
    free(s->lo);
    free(s->hi);
    free(s->truth);
}

/* ---- the contest ---- */

static const solver solvers[] = {
    {"algsurf packets", NULL, NULL, 1, NULL, NULL},
    {"algsurf", NULL, refine_here, 1, NULL, NULL},
#ifdef WITH_BOOST
    {"isolated + TOMS 748", NULL, peer_toms748, 0, NULL, NULL},
#endif
#ifdef WITH_GSL
    {"isolated + GSL Brent", NULL, peer_gsl_brent, 0, NULL, NULL},
    {"GSL", peer_gsl_first, NULL, 0, NULL, NULL},
#endif
#ifdef WITH_PARI
    {"PARI", peer_pari_first, NULL, 0, NULL, NULL},
#endif
#ifdef WITH_ARB
    {"Arb", peer_arb_first, NULL, 1, NULL, NULL},
#endif
};

enum { SOLVERS = sizeof solvers / sizeof *solvers };

static void judge(const solver *s, size_t count, peers_row *row) {
    row->count = count;
    for (size_t i = 0; i < count; i++) {
        double truth = s->on->truth[i], answer = s->answer[i];
        size_t wrong = row->missed + row->extra;
        if (isinf(truth) || isinf(answer)) continue; /* too close to call, as it says */
        if (isnan(truth))
            row->extra += isnan(answer) == 0;
        else if (!(fabs(answer - truth) <= RIGHT))
            row->missed++;
        else
            row->error = fmax(row->error, fabs(answer - truth));
        if (s->proves && row->missed + row->extra > wrong)
            cli_fail(CLI_BROKEN, "%s, polynomial %zu: the first root is %.17g to %s, %.17g to algsurf",
                     s->on->name, i, answer, s->program, truth);
    }
}

static void contend(const set *on, const peers_effort *effort, peers_table *table) {
    solver own[SOLVERS];
    peers_contestant contestant[SOLVERS];
    for (int k = 0; k < SOLVERS; k++) {
        own[k] = solvers[k];
        own[k].on = on;
        own[k].answer = numbers(on->count);
        contestant[k] = (peers_contestant){.program = own[k].program, .solve = solve, .self = &own[k]};
    }
    peers_warm_up(contestant, SOLVERS, on->count, effort->budget);
    peers_row row[SOLVERS];
    for (int k = 0; k < SOLVERS; k++) {
        row[k] = (peers_row){.section = "first root",
                             .task = on->name,
                             .degree = on->degree,
                             .program = own[k].program,
                             .unit = "ns"};
        judge(&own[k], contestant[k].count, &row[k]);
    }
    peers_contend(contestant, SOLVERS, effort->takes);
    for (int k = 0; k < SOLVERS; k++) {
        peers_tell_time(&row[k], contestant[k].seconds, (size_t)effort->takes, 1e9);
        peers_add(table, &row[k]);
        free(own[k].answer);
    }
}

void peers_first_roots(const peers_effort *effort, peers_table *table) {
    static const char *const names[] = {"sphere", "whitney", "torus",      "tangle",
                                        "boy",    "barth",   "barth-decic"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        set on;
        open_set(&on, names[i], effort->real);
        contend(&on, effort, table);
        close_set(&on);
    }
}
