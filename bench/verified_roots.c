/* verified_roots.c - what it costs to enclose all complex roots of a polynomial, and how narrow the boxes
 * are: verified_roots --help.
 *
 * Side by side the algorithm of Sanjuan-Estrada, Casado, Garcia (Rendering (complex) algebraic surfaces,
 * section 2) and the library's robust solver, each from its cold start and from the roots of a neighbouring
 * ray (spatial coherence, section 3 there).  No answer is timed that has not been checked before, against the
 * polynomial and against the other solver's; a contradiction ends the program without a table.
 */
#include <math.h>
#include <stdlib.h>

#include "must.h"
#include "results.h"
#include "verified_roots.h"

enum { POLYS = 400, QUICK_POLYS = 40, FEWER = 4 };

typedef struct bench_options {
    const char *output;
    int polys, seed, tsv, quick;
} bench_options;

#define FIELD(member) offsetof(bench_options, member)

static const cli_option options_table[] = {
    {"--polys", "N", "polynomials for each surface and each random degree, default 400", cli_set_int,
     FIELD(polys), 1, 100000},
    {"--seed", "S", "of the random pixels and coefficients, default 1", cli_set_int, FIELD(seed), 0,
     1000000000},
    {"--format", "text|tsv", "to be read by people (default) or programs", cli_set_choice, FIELD(tsv), 0, 0},
    {"--output", "FOLDER",
     "also measures random polynomials of more degrees, and clusters, a quarter as many of\n"
     "each; all numbers as CSV and charts as SVG go there; made if there is none",
     cli_set_text, FIELD(output), 0, 0},
    {"--quick", NULL, "a tenth of the polynomials", cli_set_flag, FIELD(quick), 0, 0},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "verified_roots",
    .synopsis = "[options]",
    .about = "Encloses all complex roots of polynomials, with the robust solver and with the\n"
             "algorithm of Sanjuan-Estrada, Casado, Garcia; checks the answers, then prints how many\n"
             "roots were verified, how wide the boxes are, and how long it took.  Answers that\n"
             "contradict each other or the polynomial: one line on standard error, no table, exit\n"
             "status 1.",
    .options = options_table,
};

/* ---- the solvers ---- */

/* One polynomial at hand, and room for the answers. */
typedef struct work {
    algsurf_complex_solver *solver;
    const polynomial *p;
    const algsurf_complex *start;
    algsurf_status status;
    int complete, count;
    algsurf_paper_zero zeros[ALGSURF_MAX_DEGREE];
    algsurf_complex_root boxes[ALGSURF_MAX_DEGREE];
} work;

static void solve_paper(void *data) {
    work *w = data;
    w->status = algsurf_paper_zeros(w->p->c, NULL, w->p->degree, w->start, NULL, w->zeros, &w->complete);
}

static void solve_robust(void *data) {
    work *w = data;
    w->status = algsurf_complex_solver_run(w->solver, w->p->c, NULL, w->p->degree, w->start, w->boxes,
                                           &w->count, NULL);
}

static void read_paper(const work *w, answer *a) {
    *a = (answer){.complete = w->complete, .count = w->p->degree};
    for (int i = 0; i < a->count; i++) {
        const algsurf_paper_zero *zero = &w->zeros[i];
        a->root[i] = (answer_root){zero->box, zero->root, zero->verified, zero->verified && zero->unique};
    }
}

static void read_robust(const work *w, answer *a) {
    *a = (answer){.complete = 1, .count = w->count};
    for (int i = 0; i < a->count; i++) {
        const algsurf_complex_root *e = &w->boxes[i];
        a->root[i] = (answer_root){e->box, e->root, e->multiplicity, e->multiplicity == 1};
    }
}

typedef struct method {
    const char *solver, *start;
    int near; /* starts from the neighbour's roots, where there are any */
    void (*solve)(void *work);
    void (*read)(const work *w, answer *a);
} method;

enum { METHODS = 4 };

/* The first one's answers, being complete, are what the others' are compared with. */
static const method methods[METHODS] = {{"robust", "cold", 0, solve_robust, read_robust},
                                        {"robust", "near", 1, solve_robust, read_robust},
                                        {"paper", "cold", 0, solve_paper, read_paper},
                                        {"paper", "near", 1, solve_paper, read_paper}};

static void prepare(work *w, const method *m, const polynomial *p) {
    w->p = p;
    w->start = m->near && p->has_near ? p->near : NULL;
}

/* An answer that was refused is one without roots. */
static void solve(work *w, const method *m, const polynomial *p, answer *a) {
    prepare(w, m, p);
    m->solve(w);
    if (w->status == ALGSURF_OK)
        m->read(w, a);
    else
        *a = (answer){0};
}

/* ---- what is told of an answer ---- */

typedef struct tally {
    size_t polynomials, complete, roots, simple, boxes;
    double *width;   /* of each box, ulps */
    double *widest;  /* of each polynomial: its widest box's larger part */
    double *seconds; /* for each polynomial */
} tally;

/* The width of one part of a box in ulps of its value, or of the other part's value where the box holds
 * an axis: the place of the last digit is then set by the size of the root, not by how small that part is. */
static double width_in_ulps(algsurf_interval part, double value, double other) {
    double width = algsurf_interval_width(part), size = fabs(value);
    if (width == 0) return 0;
    if (part.lo <= 0 && part.hi >= 0) size = fmax(size, fabs(other));
    return width / (nextafter(size, INFINITY) - size);
}

static double box_in_ulps(const answer_root *root) {
    algsurf_complex z = root->value;
    return fmax(width_in_ulps(root->box.re, z.re, z.im), width_in_ulps(root->box.im, z.im, z.re));
}

static void count_answer(tally *t, const polynomial *p, const answer *a) {
    double *widest = &t->widest[t->polynomials++];
    t->complete += (size_t)a->complete;
    t->roots += (size_t)p->degree;
    t->simple += (size_t)simple_roots(a);
    for (int i = 0; i < a->count; i++) {
        const answer_root *root = &a->root[i];
        if (root->multiplicity == 0) continue;
        t->width[t->boxes++] = box_in_ulps(root);
        *widest =
            fmax(*widest, fmax(algsurf_interval_width(root->box.re), algsurf_interval_width(root->box.im)));
    }
}

/* ---- a family of polynomials ---- */

typedef struct family {
    const char *name;
    int degree, has_near, seed, count;
    const polynomial *p;
    int cluster; /* roots of each polynomial in a cluster; 0: none on purpose */
    double gap;  /* between them */
} family;

/* Ends the program in one line that says which polynomial it was. */
static _Noreturn void contradict(const family *f, const polynomial *p, const method *m, const char *what) {
    fprintf(stderr, "%s: seed %d, %s, %s, %s: %s:", program.name, f->seed, f->name, m->solver, m->start,
            what);
    for (int k = 0; k <= p->degree; k++) fprintf(stderr, " %a,%a", p->c[k].re, p->c[k].im);
    fputc('\n', stderr);
    exit(CLI_BROKEN);
}

/* Solves, checks and counts one polynomial with each method. */
static void judge(work *w, const family *f, const polynomial *p, tally *tallies) {
    answer reference, a;
    for (int m = 0; m < METHODS; m++) {
        if (methods[m].near && !f->has_near) continue;
        solve(w, &methods[m], p, &a);
        if (m == 0) reference = a;
        const char *what = contradiction(p, &a);
        if (!what && reference.complete) what = contradiction_between(&a, &reference);
        if (what) contradict(f, p, &methods[m], what);
        count_answer(&tallies[m], p, &a);
    }
}

static void clock_all(work *w, const family *f, tally *tallies) {
    for (int i = 0; i < f->count; i++)
        for (int m = 0; m < METHODS; m++) {
            if (methods[m].near && !f->has_near) continue;
            prepare(w, &methods[m], &f->p[i]);
            tallies[m].seconds[i] = measure_call(methods[m].solve, w);
        }
}

/* Rounded down: only what is complete is 100. */
static double percent(size_t part, size_t whole) { return floor(1e4 * (double)part / (double)whole) / 1e2; }

static void fill_row(row *r, const family *f, const method *m, tally *t) {
    *r = (row){.degree = f->degree,
               .cluster = f->cluster,
               .gap = f->gap,
               .polynomials = t->polynomials,
               .solver = m->solver,
               .start = m->start,
               .complete = percent(t->complete, t->polynomials),
               .simple = percent(t->simple, t->roots),
               .ulps50 = measure_quantile(t->width, t->boxes, 0.5),
               .ulps99 = measure_quantile(t->width, t->boxes, 0.99),
               .widest = measure_quantile(t->widest, t->polynomials, 0.5),
               .us = 1e6 * measure_quantile(t->seconds, t->polynomials, 0.5)};
    snprintf(r->family, sizeof r->family, "%s", f->name);
}

/* ---- the run ---- */

/* Rows for one family; returns how many. */
static int run_family(work *w, const family *f, row *rows) {
    tally tallies[METHODS] = {{0}};
    size_t count = (size_t)f->count;
    int written = 0;
    for (int m = 0; m < METHODS; m++) {
        tallies[m].width = must_allocate(count * (size_t)f->degree, sizeof(double));
        tallies[m].widest = must_allocate(count, sizeof(double));
        tallies[m].seconds = must_allocate(count, sizeof(double));
    }
    for (int i = 0; i < f->count; i++) judge(w, f, &f->p[i], tallies);
    clock_all(w, f, tallies);
    for (int m = 0; m < METHODS; m++) {
        if (tallies[m].polynomials > 0) fill_row(&rows[written++], f, &methods[m], &tallies[m]);
        free(tallies[m].width);
        free(tallies[m].widest);
        free(tallies[m].seconds);
    }
    return written;
}

enum {
    RANDOM_FAMILIES = 3,
    DEGREES = 8,
    CLUSTER_DEGREE = 12,
    CLUSTER_MOST = 8,
    GAPS = 4,
    MAX_FAMILIES = 128
};
static const int random_degree[RANDOM_FAMILIES] = {16, 32, 64};
static const int degrees[DEGREES] = {4, 6, 10, 16, 24, 32, 48, 64};
static const double gaps[GAPS] = {1e-3, 1e-6, 1e-9, 0};

/* The families of the table: surfaces, random polynomials. */
static int run_usual(work *w, const bench_options *o, measure_random *seeds, polynomial *p, row *rows) {
    int count = 0;
    for (const catalogue_entry *entry = catalogue; entry->name; entry++) {
        measure_random random = {measure_bits(seeds)};
        if (entry->degree < 2 || catalogue_first_of(entry) != entry) continue;
        polynomials_of_rays(entry, &random, p, o->polys);
        family f = {entry->name, entry->degree, 1, o->seed, o->polys, p, 0, 0};
        count += run_family(w, &f, rows + count);
    }
    for (int i = 0; i < RANDOM_FAMILIES; i++) {
        measure_random random = {measure_bits(seeds)};
        char name[sizeof rows->family];
        snprintf(name, sizeof name, "random-%d", random_degree[i]);
        polynomials_at_random(random_degree[i], &random, p, o->polys);
        family f = {name, random_degree[i], 0, o->seed, o->polys, p, 0, 0};
        count += run_family(w, &f, rows + count);
    }
    return count;
}

/* Those of the charts: degrees, clusters. */
static int run_more(work *w, const bench_options *o, measure_random *seeds, polynomial *p, row *rows) {
    int count = 0, polys = (o->polys + FEWER - 1) / FEWER;
    char name[sizeof rows->family];
    for (int i = 0; i < DEGREES; i++) {
        measure_random random = {measure_bits(seeds)};
        snprintf(name, sizeof name, "degree-%d", degrees[i]);
        polynomials_with_neighbours(degrees[i], &random, p, polys);
        count += run_family(w, &(family){name, degrees[i], 1, o->seed, polys, p, 0, 0}, rows + count);
    }
    for (int i = 0; i < GAPS; i++)
        for (int k = 2; k <= CLUSTER_MOST; k++) {
            measure_random random = {measure_bits(seeds)};
            snprintf(name, sizeof name, "cluster-%d-%.0e", k, gaps[i]);
            polynomials_with_cluster(CLUSTER_DEGREE, k, gaps[i], &random, p, polys);
            count += run_family(w, &(family){name, CLUSTER_DEGREE, 0, o->seed, polys, p, k, gaps[i]},
                                rows + count);
        }
    return count;
}

int main(int argc, char **argv) {
    bench_options o = {.seed = 1};
    work *w = must_allocate(1, sizeof *w);
    results_begin(&program, argc, argv, &o, &o.output);
    if (o.polys == 0) o.polys = o.quick ? QUICK_POLYS : POLYS;
    polynomial *p = must_allocate((size_t)o.polys, sizeof *p);
    row *rows = must_allocate(MAX_FAMILIES * METHODS, sizeof *rows);
    if (algsurf_complex_solver_create(ALGSURF_MAX_DEGREE, &w->solver) != ALGSURF_OK) cli_no_memory();
    measure_random seeds = {(uint64_t)o.seed};
    int count = run_usual(w, &o, &seeds, p, rows);
    if (o.output) count += run_more(w, &o, &seeds, p, rows + count);
    report(rows, count, o.seed, o.tsv, o.output);
    algsurf_complex_solver_free(w->solver);
    free(rows);
    free(p);
    free(w);
    return 0;
}
