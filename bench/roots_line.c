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

#include "must.h"
#include "rays.h"
#include "roots.h"

enum { MOST_DEGREE = 256, MEMBERS = 64 };

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

static void solve(const roots_solver *s, size_t begin, size_t end) {
    for (size_t i = begin; i < end; i++)
        s->count[i] = s->by.line(roots_set_at(s->on, s->on->c, i), s->on->degrees[i]);
}

/* ---- the polynomials ---- */

/* (x-1) (x-2) .. (x-n) */
static void set_wilkinson(double *c, int n) {
    c[0] = 1;
    for (int r = 1; r <= n; r++)
        for (int k = r; k >= 0; k--) c[k] = (k > 0 ? c[k - 1] : 0) - (k < r ? r * c[k] : 0);
}

/* p_(m+1) = ((a x + b) p_m - c p_(m-1)) / d, from 1. */
typedef struct recurrence {
    double a, b, c, d;
} recurrence;

static void recur(double *p, int n, recurrence step(int m)) {
    double before[MOST_DEGREE + 1] = {0}, next[MOST_DEGREE + 1];
    p[0] = 1;
    for (int m = 0; m < n; m++) {
        const recurrence r = step(m);
        for (int k = 0; k <= m + 1; k++)
            next[k] = ((k > 0 ? r.a * p[k - 1] : 0) + r.b * p[k] - r.c * before[k]) / r.d;
        memcpy(before, p, sizeof *p * (size_t)(m + 1));
        memcpy(p, next, sizeof *p * (size_t)(m + 2));
    }
}

static recurrence chebyshev(int m) { return (recurrence){m ? 2 : 1, 0, 1, 1}; }
static recurrence hermite(int m) { return (recurrence){2, 0, 2 * m, 1}; }
static recurrence legendre(int m) { return (recurrence){2 * (2 * m + 1), 0, 4 * m, m + 1}; } /* 2^n P_n */
static recurrence laguerre(int m) { return (recurrence){-1, 2 * m + 1, m * m, 1}; }          /* n! L_n */

static void set_chebyshev(double *c, int n) { recur(c, n, chebyshev); }
static void set_hermite(double *c, int n) { recur(c, n, hermite); }
static void set_legendre(double *c, int n) { recur(c, n, legendre); }
static void set_laguerre(double *c, int n) { recur(c, n, laguerre); }

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

/* Their numbers of roots are to be set. */
static void open_set(roots_set *on, const char *name, int degree, size_t count) {
    roots_set_open(on, name, degree, 0, count);
    on->degrees = must_allocate(count, sizeof *on->degrees);
    on->real = must_allocate(count, sizeof *on->real);
    for (size_t i = 0; i < count; i++) on->degrees[i] = degree;
}

static void open_rays(roots_set *on, const char *surface) {
    const catalogue_entry *entry = catalogue_find(surface);
    open_set(on, surface, entry->degree, MEMBERS);
    rays_polynomials(entry, 3, MEMBERS, on->c);
    for (size_t i = 0; i < MEMBERS; i++)
        on->real[i] = count_exactly(roots_set_at(on, on->c, i), entry->degree);
}

static void open_random(roots_set *on) {
    measure_random random = {4};
    open_set(on, "random", 56, 13);
    for (size_t i = 0; i < on->count; i++) {
        double *c = roots_set_at(on, on->c, i);
        on->degrees[i] = 8 + 4 * (int)i;
        for (int k = 0; k <= on->degrees[i]; k++) c[k] = measure_uniform(&random, -1, 1);
        on->real[i] = count_exactly(c, on->degrees[i]);
    }
}

/* ---- the contest ---- */

static const roots_solver isolators[] = {
    {.program = "algsurf", .solve = solve, .by.line = isolate_here, .proves = 1},
    {.program = "algsurf refined", .solve = solve, .by.line = refine_here, .proves = 1},
    {.program = "algsurf complex",
     .solve = solve,
     .by.line = complex_here,
     .proves = 1,
     .most_degree = ALGSURF_MAX_DEGREE},
#ifdef WITH_FLINT_ISOLATION
    {.program = "FLINT", .solve = solve, .by.line = by_flint_isolated},
#endif
#ifdef WITH_PARI
    {.program = "PARI refined", .solve = solve, .by.line = by_pari_isolated},
#endif
};

static const roots_solver counters[] = {
    {.program = "algsurf", .solve = solve, .by.line = count_here, .proves = 1},
#ifdef WITH_ARB
    {.program = "FLINT", .solve = solve, .by.line = by_flint_counted},
#endif
#ifdef WITH_PARI
    {.program = "PARI", .solve = solve, .by.line = by_pari_counted},
#endif
};

static void judge(const roots_solver *s, const roots_solver *first, contest_row *row) {
    (void)first; /* the numbers are known */
    for (size_t i = 0; i < row->count; i++) {
        int off = s->count[i] - s->on->real[i];
        row->missed += off < 0;
        row->extra += off > 0;
    }
}

/* In both, and the end of the set. */
static void contend(roots_set *on, const roots_effort *effort, contest_table *table) {
    static const roots_contest contests[2] = {
        {"isolated", "us", isolators, sizeof isolators / sizeof *isolators, judge, 1},
        {"counted", "us", counters, sizeof counters / sizeof *counters, judge, 1}};
    for (int k = 0; k < 2; k++) roots_contend(&contests[k], on, effort, table);
    roots_set_free(on);
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
    roots_set on;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        int count = (kinds[i].to - kinds[i].from) / kinds[i].step + 1;
        open_set(&on, kinds[i].name, kinds[i].to, (size_t)count);
        for (int k = 0; k < count; k++) {
            int n = on.degrees[k] = kinds[i].from + k * kinds[i].step;
            on.real[k] = kinds[i].real ? kinds[i].real : n;
            kinds[i].set(roots_set_at(&on, on.c, (size_t)k), n);
        }
        contend(&on, effort, table);
    }
    for (size_t i = 0; i < sizeof surfaces / sizeof *surfaces; i++) {
        open_rays(&on, surfaces[i]);
        contend(&on, effort, table);
    }
    open_random(&on);
    contend(&on, effort, table);
}
