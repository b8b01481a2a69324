/* roots_line.c - the real roots on the whole line, isolated and counted, of polynomials with integer
 * coefficients whose number of real roots is known.
 *
 * All coefficients are doubles, exactly.  An orthogonal polynomial has as many different real roots as its
 * degree; x^n - 2 (a x - 1)^2 (Mignotte) has two about 1/a, sqrt(8) a^(-1-n/2) apart, and one far out on
 * each side, n being even; x^n - a has two.  This library must find as many; if not there is no table.  Of
 * random polynomials, and those along rays, the number is that of the library's integers. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "measure.h"
#include "must.h"
#include "rays.h"
#include "roots.h"
#include "roots_others.h"

enum { MOST_DEGREE = 256, MOST_MEMBERS = 64 };

/* Polynomials of a kind. */
typedef struct family {
    const char *name;
    size_t count;
    int degree[MOST_MEMBERS], real[MOST_MEMBERS]; /* different real roots */
    double *c[MOST_MEMBERS];
} family;

typedef struct solver {
    const char *program;
    other_line *find;
    const family *on;
    int *answer;
} solver;

/* ---- this library ---- */

static int isolate_here(const double *c, int degree) {
    algsurf_bracket b[MOST_DEGREE];
    int count;
    return algsurf_isolate_all(c, NULL, degree, -INFINITY, INFINITY, NULL, b, MOST_DEGREE, &count) ==
                   ALGSURF_OK
               ? count
               : -1;
}

static int refine_here(const double *c, int degree) {
    algsurf_real_root r[MOST_DEGREE];
    int count;
    return algsurf_real_roots(c, degree, -INFINITY, INFINITY, r, MOST_DEGREE, &count) == ALGSURF_OK ? count
                                                                                                    : -1;
}

static int count_here(const double *c, int degree) {
    int count;
    return algsurf_count_roots(c, NULL, degree, -INFINITY, INFINITY, &count) == ALGSURF_OK ? count : -1;
}

static int complex_here(const double *c, int degree) {
    algsurf_complex_root e[ALGSURF_MAX_DEGREE];
    int count, real = 0;
    if (degree > ALGSURF_MAX_DEGREE ||
        algsurf_complex_roots_of_real(c, NULL, degree, e, &count) != ALGSURF_OK)
        return -1;
    for (int i = 0; i < count; i++) real += e[i].real;
    return real;
}

static void solve(void *self, size_t begin, size_t end) {
    const solver *s = self;
    for (size_t i = begin; i < end; i++) s->answer[i] = s->find(s->on->c[i], s->on->degree[i]);
}

/* ---- the polynomials ---- */

static double *add(family *f, int degree, int real) {
    double *c = f->c[f->count] = must_allocate((size_t)degree + 1, sizeof *c);
    f->degree[f->count] = degree;
    f->real[f->count++] = real;
    return c;
}

/* (x-1) (x-2) .. (x-n) */
static void set_wilkinson(double *c, int n) {
    c[0] = 1;
    for (int r = 1; r <= n; r++)
        for (int k = r; k >= 0; k--) c[k] = (k > 0 ? c[k - 1] : 0) - (k < r ? r * c[k] : 0);
}

/* By p_(k+1) = a x p_k - b_k p_(k-1). */
static void recur(double *c, int n, double first, double a, double b, double growth) {
    double before[MOST_DEGREE + 1] = {1}, p[MOST_DEGREE + 1] = {0, first};
    for (int m = 1; m < n; m++) {
        double next[MOST_DEGREE + 1];
        for (int k = 0; k <= m + 1; k++)
            next[k] = (k > 0 ? a * p[k - 1] : 0) - (b + growth * m) * (k < m ? before[k] : 0);
        memcpy(before, p, sizeof before);
        memcpy(p, next, sizeof(double) * (size_t)(m + 2));
    }
    memcpy(c, p, sizeof(double) * (size_t)(n + 1));
}

static void set_chebyshev(double *c, int n) { recur(c, n, 1, 2, 1, 0); }
static void set_hermite(double *c, int n) { recur(c, n, 2, 2, 0, 2); }

static double binomial(int n, int k) {
    double b = 1;
    for (int i = 1; i <= k; i++) b = b * (n - k + i) / i;
    return b;
}

/* 2^n P_n = sum (-1)^k C(n,k) C(2n-2k,n) x^(n-2k) */
static void set_legendre(double *c, int n) {
    for (int k = 0; 2 * k <= n; k++)
        c[n - 2 * k] = (k % 2 ? -1 : 1) * binomial(n, k) * binomial(2 * n - 2 * k, n);
}

/* n! L_n = sum (-1)^k C(n,k) n!/k! x^k */
static void set_laguerre(double *c, int n) {
    double quotient = 1;
    for (int k = n; k >= 0; k--) {
        c[k] = (k % 2 ? -1 : 1) * binomial(n, k) * quotient;
        quotient *= k;
    }
}

static void set_mignotte(double *c, int n) {
    const double a = 1000; /* no power of two, which halving would meet */
    c[n] = 1;
    c[0] -= 2;
    c[1] += 4 * a;
    c[2] -= 2 * a * a;
}

static void set_power(double *c, int n) {
    c[n] = 1;
    c[0] = -(2 * n + 1);
}

static void open_family(family *f, const char *name, void set(double *c, int n), int from, int to, int step,
                        int real) {
    *f = (family){.name = name};
    for (int n = from; n <= to; n += step) set(add(f, n, real ? real : n), n);
}

static int count_exactly(const double *c, int degree) {
    algsurf_real_root r[MOST_DEGREE];
    algsurf_integer z[MOST_DEGREE + 1];
    int count, least = 0, exponent;
    for (int k = 0; k <= degree; k++)
        if (frexp(c[k], &exponent) != 0 && exponent - 53 < least) least = exponent - 53;
    uint64_t(*wide)[40] = must_allocate((size_t)degree + 1, sizeof *wide);
    for (int k = 0; k <= degree; k++) {
        double m = frexp(c[k], &exponent);
        uint64_t word = (uint64_t)ldexp(fabs(m), 53);
        int shift = word ? exponent - 53 - least : 0;
        if (shift / 64 + 2 > 40) cli_fail(CLI_BROKEN, "a coefficient is too far from another one");
        wide[k][shift / 64] = word << shift % 64;
        wide[k][shift / 64 + 1] = shift % 64 ? word >> (64 - shift % 64) : 0;
        z[k] = (algsurf_integer){wide[k], m < 0 ? -40 : 40};
    }
    algsurf_status status =
        algsurf_real_roots_integers(z, degree, -INFINITY, INFINITY, r, MOST_DEGREE, &count);
    if (status != ALGSURF_OK) cli_fail(CLI_BROKEN, "integers: %s", algsurf_status_text(status));
    free(wide);
    return count;
}

static void open_rays(family *f, const char *surface) {
    const catalogue_entry *entry = catalogue_find(surface);
    size_t stride = (size_t)entry->degree + 1;
    double *c = must_allocate(MOST_MEMBERS * stride, sizeof *c);
    *f = (family){.name = surface};
    rays_polynomials(entry, 3, MOST_MEMBERS, c);
    for (size_t i = 0; i < MOST_MEMBERS; i++)
        memcpy(add(f, entry->degree, count_exactly(c + i * stride, entry->degree)), c + i * stride,
               stride * sizeof *c);
    free(c);
}

static void open_random(family *f) {
    measure_random random = {4};
    *f = (family){.name = "random"};
    for (int n = 8; n <= 56; n += 4) {
        double *c = add(f, n, 0);
        for (int k = 0; k <= n; k++) c[k] = measure_uniform(&random, -1, 1);
        f->real[f->count - 1] = count_exactly(c, n);
    }
}

static void close_family(family *f) {
    for (size_t i = 0; i < f->count; i++) free(f->c[i]);
}

/* ---- the contest ---- */

static const solver isolators[] = {
    {"algsurf", isolate_here, NULL, NULL},          {"algsurf refined", refine_here, NULL, NULL},
    {"algsurf complex", complex_here, NULL, NULL},
#ifdef WITH_FLINT_ISOLATION
    {"FLINT", by_flint_isolated, NULL, NULL},
#endif
#ifdef WITH_PARI
    {"PARI refined", by_pari_isolated, NULL, NULL},
#endif
};

static const solver counters[] = {
    {"algsurf", count_here, NULL, NULL},
#ifdef WITH_ARB
    {"FLINT", by_flint_counted, NULL, NULL},
#endif
#ifdef WITH_PARI
    {"PARI", by_pari_counted, NULL, NULL},
#endif
};

enum { MOST_SOLVERS = 5 };

static void judge(const solver *s, contest_row *row) {
    for (size_t i = 0; i < row->count; i++) {
        int off = s->answer[i] - s->on->real[i];
        row->missed += off < 0;
        row->extra += off > 0;
    }
    if (row->missed + row->extra > 0 && strncmp(s->program, "algsurf", 7) == 0)
        cli_fail(CLI_BROKEN, "%s: wrong numbers of roots by %s", s->on->name, s->program);
}

static void contend(const char *section, const solver *solvers, size_t count, const family *on,
                    const roots_effort *effort, contest_table *table) {
    solver own[MOST_SOLVERS];
    contestant contestants[MOST_SOLVERS];
    contest_row row[MOST_SOLVERS];
    size_t some = 0;
    for (size_t k = 0; k < count; k++) {
        if (solvers[k].find == complex_here && on->degree[on->count - 1] > ALGSURF_MAX_DEGREE) continue;
        own[some] = solvers[k];
        own[some].on = on;
        own[some].answer = must_allocate(on->count, sizeof *own[some].answer);
        contestants[some] = (contestant){.program = own[some].program, .solve = solve, .self = &own[some]};
        some++;
    }
    contest_warm_up(contestants, some, on->count, INFINITY);
    for (size_t k = 0; k < some; k++) {
        row[k] = (contest_row){.section = section,
                               .task = on->name,
                               .degree = on->degree[on->count - 1],
                               .program = own[k].program,
                               .unit = "us",
                               .count = contestants[k].count};
        judge(&own[k], &row[k]);
    }
    contest_run(contestants, row, some, effort->takes, 1e6, table);
    for (size_t k = 0; k < some; k++) free(own[k].answer);
}

static void both(family *f, const roots_effort *effort, contest_table *table) {
    contend("isolated", isolators, sizeof isolators / sizeof *isolators, f, effort, table);
    contend("counted", counters, sizeof counters / sizeof *counters, f, effort, table);
    close_family(f);
}

void roots_line(const roots_effort *effort, contest_table *table) {
    static const struct {
        const char *name;
        void (*set)(double *c, int n);
        int from, to, step, real; /* real 0: as many as the degree */
    } kinds[] = {{"Wilkinson", set_wilkinson, 6, 18, 2, 0}, {"Chebyshev", set_chebyshev, 8, 40, 4, 0},
                 {"Legendre", set_legendre, 6, 22, 2, 0},   {"Hermite", set_hermite, 6, 18, 2, 0},
                 {"Laguerre", set_laguerre, 4, 16, 2, 0},   {"Mignotte", set_mignotte, 8, 128, 24, 4},
                 {"x^n - a", set_power, 8, 128, 24, 2}};
    static const char *const surfaces[] = {"tangle", "barth", "barth-decic"};
    family f;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        open_family(&f, kinds[i].name, kinds[i].set, kinds[i].from, kinds[i].to, kinds[i].step,
                    kinds[i].real);
        both(&f, effort, table);
    }
    for (size_t i = 0; i < sizeof surfaces / sizeof *surfaces; i++) {
        open_rays(&f, surfaces[i]);
        both(&f, effort, table);
    }
    open_random(&f);
    both(&f, effort, table);
}
