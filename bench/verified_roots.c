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
#include <string.h>

#include "cli.h"
#include "verified_roots_check.h"

typedef struct bench_options {
    const char *extra; /* a plain argument, which this program does not take */
    int polys, seed, tsv;
} bench_options;

static void set_choice(const cli_option *option, const char *value, void *field) {
    *(int *)field = cli_choice(option, value);
}

#define FIELD(member) offsetof(bench_options, member)

static const cli_option options_table[] = {
    {"--polys", "N", "polynomials for each surface and each random degree, default 400", cli_set_int,
     FIELD(polys), 1, 100000},
    {"--seed", "S", "of the random pixels and coefficients, default 1", cli_set_int, FIELD(seed), 0,
     1000000000},
    {"--format", "text|tsv", "to be read by people (default) or programs", set_choice, FIELD(tsv), 0, 0},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    "verified_roots", "[options]",
    "Encloses all complex roots of polynomials, with the robust solver and with the algorithm of\n"
    "Sanjuan-Estrada, Casado, Garcia; checks the answers, then prints how many roots were verified, how\n"
    "wide the boxes are, and how long it took.  Answers that contradict each other or the polynomial:\n"
    "one line on standard error, no table, exit status 1.",
    options_table, FIELD(extra)};

static const char legend[] =
    "Boxes proved to enclose all complex roots of a polynomial, and what they cost.\n"
    "  surface    along rays of random pixels of its view in the catalogue, re-centred, the chord inside\n"
    "             its extent scaled to [-1,1]; random-N: coefficients uniform in [-1,1] x [-1,1] i.\n"
    "             Coefficients count as exact.\n"
    "  solver     robust: algsurf_root_solver_run; paper: algsurf_cpoly_zeros\n"
    "  start      cold: its own (robust), 0 + i (paper); near: the roots of the ray a pixel to the left\n"
    "  complete%  polynomials with all roots in verified boxes that are disjoint\n"
    "  simple%    roots verified to be simple and alone in their box, each counted once\n"
    "  ulps50%    width of verified boxes, median: real or imaginary part, whichever is wider, in units\n"
    "             in the last place of that part of the value (of the other part if the box straddles\n"
    "             an axis; a part that is exact counts 0)\n"
    "  ulps99%    the width that 99 of 100 boxes do not exceed\n"
    "  us50%      CPU time for all roots of a polynomial, microseconds, median\n";

/* ---- the solvers ---- */

/* One polynomial at hand, and room for the answers. */
typedef struct work {
    algsurf_root_solver *solver;
    const polynomial *p;
    const algsurf_complex *start;
    algsurf_status status;
    int complete, count;
    algsurf_cpoly_zero zeros[ALGSURF_MAX_DEGREE];
    algsurf_enclosure boxes[ALGSURF_MAX_DEGREE];
} work;

static void solve_paper(void *data) {
    work *w = data;
    w->status = algsurf_cpoly_zeros(w->p->c, NULL, w->p->degree, w->start, NULL, w->zeros, &w->complete);
}

static void solve_robust(void *data) {
    work *w = data;
    w->status =
        algsurf_root_solver_run(w->solver, w->p->c, NULL, w->p->degree, w->start, w->boxes, &w->count, NULL);
}

static void read_paper(const work *w, answer *a) {
    *a = (answer){.complete = w->complete, .count = w->p->degree};
    for (int i = 0; i < a->count; i++) {
        const algsurf_cpoly_zero *zero = &w->zeros[i];
        a->root[i] = (answer_root){zero->box, zero->value, zero->verified, zero->verified && zero->unique};
    }
}

static void read_robust(const work *w, answer *a) {
    *a = (answer){.complete = 1, .count = w->count};
    for (int i = 0; i < a->count; i++) {
        const algsurf_enclosure *e = &w->boxes[i];
        a->root[i] = (answer_root){e->box, e->value, e->multiplicity, e->multiplicity == 1};
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
    t->polynomials++;
    t->complete += (size_t)a->complete;
    t->roots += (size_t)p->degree;
    t->simple += (size_t)simple_roots(a);
    for (int i = 0; i < a->count; i++)
        if (a->root[i].multiplicity > 0) t->width[t->boxes++] = box_in_ulps(&a->root[i]);
}

/* ---- a family of polynomials ---- */

typedef struct family {
    const char *name;
    int degree, has_near, seed, count;
    const polynomial *p;
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

/* ---- the table ---- */

enum { COLUMNS = 10, CELL = 24 };

static const struct column {
    const char *title;
    int width; /* negative: flush left */
} columns[COLUMNS] = {{"surface", -12}, {"degree", 6},  {"polynomials", 11}, {"solver", -6}, {"start", -5},
                      {"complete%", 9}, {"simple%", 8}, {"ulps50%", 9},      {"ulps99%", 9}, {"us50%", 9}};

typedef struct row {
    char cell[COLUMNS][CELL];
} row;

/* Rounded down: only what is complete is 100. */
static double percent(size_t part, size_t whole) { return floor(1e4 * (double)part / (double)whole) / 1e2; }

static void print_width(char *cell, const tally *t, double share) {
    if (t->boxes > 0)
        snprintf(cell, CELL, "%.3g", measure_quantile(t->width, t->boxes, share));
    else
        snprintf(cell, CELL, "-");
}

static void fill_row(row *r, const family *f, const method *m, tally *t) {
    measure_sort(t->width, t->boxes);
    measure_sort(t->seconds, t->polynomials);
    snprintf(r->cell[0], CELL, "%s", f->name);
    snprintf(r->cell[1], CELL, "%d", f->degree);
    snprintf(r->cell[2], CELL, "%zu", t->polynomials);
    snprintf(r->cell[3], CELL, "%s", m->solver);
    snprintf(r->cell[4], CELL, "%s", m->start);
    snprintf(r->cell[5], CELL, "%.2f", percent(t->complete, t->polynomials));
    snprintf(r->cell[6], CELL, "%.2f", percent(t->simple, t->roots));
    print_width(r->cell[7], t, 0.5);
    print_width(r->cell[8], t, 0.99);
    snprintf(r->cell[9], CELL, "%.2f", 1e6 * measure_quantile(t->seconds, t->polynomials, 0.5));
}

static void print_cell(int k, const char *text, int tsv) {
    if (tsv)
        printf("%s%s", k > 0 ? "\t" : "", text);
    else
        printf("%s%*s", k > 0 ? "  " : "", columns[k].width, text);
}

static void print_table(const bench_options *o, const row *rows, int count) {
    const char *mark = o->tsv ? "# " : "";
    char machine[512];
    measure_machine(machine, sizeof machine);
    for (const char *line = legend; *line; line += strcspn(line, "\n") + 1)
        printf("%s%.*s\n", mark, (int)strcspn(line, "\n"), line);
    printf("%smachine: %s\n%sseed: %d\n%s", mark, machine, mark, o->seed, o->tsv ? "#" : "\n");
    for (int k = 0; k < COLUMNS; k++) print_cell(k, columns[k].title, o->tsv);
    putchar('\n');
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < COLUMNS; k++) print_cell(k, rows[i].cell[k], o->tsv);
        putchar('\n');
    }
    cli_finish_output();
}

/* ---- the run ---- */

static void *allocate(size_t count, size_t size) {
    void *memory = calloc(count, size);
    if (!memory) cli_no_memory();
    return memory;
}

/* Rows for one family; returns how many. */
static int run_family(work *w, const family *f, row *rows) {
    tally tallies[METHODS] = {{0}};
    size_t count = (size_t)f->count;
    int written = 0;
    for (int m = 0; m < METHODS; m++) {
        tallies[m].width = allocate(count * (size_t)f->degree, sizeof(double));
        tallies[m].seconds = allocate(count, sizeof(double));
    }
    for (int i = 0; i < f->count; i++) judge(w, f, &f->p[i], tallies);
    clock_all(w, f, tallies);
    for (int m = 0; m < METHODS; m++) {
        if (tallies[m].polynomials > 0) fill_row(&rows[written++], f, &methods[m], &tallies[m]);
        free(tallies[m].width);
        free(tallies[m].seconds);
    }
    return written;
}

enum { RANDOM_FAMILIES = 3 };
static const int random_degree[RANDOM_FAMILIES] = {16, 32, 64};
static const char *const random_name[RANDOM_FAMILIES] = {"random-16", "random-32", "random-64"};

/* Room for the rows of all families. */
static row *allocate_rows(void) {
    size_t families = RANDOM_FAMILIES;
    for (const catalogue_entry *entry = catalogue; entry->name; entry++) families++;
    return allocate(families * METHODS, sizeof(row));
}

static int run_all(work *w, const bench_options *o, polynomial *p, row *rows) {
    measure_random seeds = {(uint64_t)o->seed};
    int count = 0;
    for (const catalogue_entry *entry = catalogue; entry->name; entry++) {
        measure_random random = {measure_bits(&seeds)};
        if (entry->degree < 2) continue;
        polynomials_of_rays(entry, &random, p, o->polys);
        count += run_family(w, &(family){entry->name, entry->degree, 1, o->seed, o->polys, p}, rows + count);
    }
    for (int i = 0; i < RANDOM_FAMILIES; i++) {
        measure_random random = {measure_bits(&seeds)};
        polynomials_at_random(random_degree[i], &random, p, o->polys);
        count +=
            run_family(w, &(family){random_name[i], random_degree[i], 0, o->seed, o->polys, p}, rows + count);
    }
    return count;
}

int main(int argc, char **argv) {
    bench_options o = {.polys = 400, .seed = 1};
    work *w = allocate(1, sizeof *w);
    cli_parse(&program, argc, argv, &o);
    if (o.extra) cli_fail(CLI_BAD_INPUT, "unexpected '%s'", cli_quote(o.extra).text);
    polynomial *p = allocate((size_t)o.polys, sizeof *p);
    row *rows = allocate_rows();
    if (algsurf_root_solver_create(ALGSURF_MAX_DEGREE, &w->solver) != ALGSURF_OK) cli_no_memory();
    print_table(&o, rows, run_all(w, &o, p, rows));
    algsurf_root_solver_free(w->solver);
    free(rows);
    free(p);
    free(w);
    return 0;
}
