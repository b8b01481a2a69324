/* allroots.c - all roots of one polynomial: doubles as integers, the order of the steps, solvers.
 *
 * A coefficient is m 2^e with integers m and e: a power of two times p(2^unit y) has integers for
 * coefficients, without any rounding.  What doubles propose is proved and made narrow by discs.c.  Where that
 * leaves roots open, or doubles find nothing but the rounding of p, the polynomial may have multiple ones,
 * which never part; a gcd modulo a prime tells.  Then factors that have none are solved, one after the other
 * (factors.c).  The boxes of all factors together hold all roots, and are joined where they meet. */
#include "../base/arithmetic.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/fpenv.h"
#include "../base/options.h"
#include "../poly/value.h"
#include "discs.h"

#define OWN_WORDS ((size_t)(15 << 10) / sizeof(uint64_t)) /* on the stack */
#define RADII_SWEEPS 64                                   /* what radii allow to know is known by then */

/* A polynomial, without exact zeros at either end, and what is made of it. */
typedef struct problem {
    const double *part[2], *r;   /* coefficient k is part[0][k step] + i part[1][k step]; may be null */
    const algsurf_integer *z[2]; /* in place of the parts; z[1] may be null */
    int step, low, high;         /* from coefficient low to high */
    int real;                    /* coefficients and their radii */
    int unit, least;             /* integer k is coefficient low + k times 2^(k unit - least) */
    algsurf_memory *m;
    algsurf_i_answer answer;
} problem;

/* ---- doubles ---- */

static double entry(const problem *s, int i, int k) { return s->part[i] ? s->part[i][k * s->step] : 0; }

/* |c| and its radius, at least. */
static double extent(const problem *s, int k) {
    return fmax(fmax(fabs(entry(s, 0, k)), fabs(entry(s, 1, k))), s->r ? s->r[k] : 0);
}

static algsurf_status read_doubles(problem *s, int degree) {
    int known = 1, complex = 0, turned = 1; /* turned: i times real ones, which have the same roots */
    algsurf_status status = algsurf_i_check_polynomial(s->part[0], s->step, s->r, degree);
    if (status != ALGSURF_OK) return status;
    s->low = degree, s->high = -1;
    for (int k = 0; k <= degree; k++) {
        double x = entry(s, 0, k), y = entry(s, 1, k), r = s->r ? s->r[k] : 0;
        known = known && r == 0, complex = complex || y != 0, turned = turned && x == 0;
        if (x == 0 && y == 0 && r == 0) continue;
        if (s->low > k) s->low = k;
        s->high = k;
    }
    if (s->high < 0) return ALGSURF_E_ZERO;
    if (known) s->r = NULL;
    turned = turned && known;
    s->real = turned || (!complex && (known || !s->part[1]));
    if (turned) s->part[0] = s->part[1];
    if (turned || !complex) s->part[1] = NULL;
    return ALGSURF_OK;
}

static algsurf_scaled scaled_double(double x, double y, int64_t exponent) {
    int e;
    double most = fmax(fabs(x), fabs(y));
    if (most == 0) return scaled_none();
    (void)frexp(most, &e);
    return scaled_of(ldexp(x, -e), ldexp(y, -e), exponent + e);
}

/* In a unit of the variable in which the first and the last coefficient balance, so that integers are short.
 */
static int take_doubles(problem *s, algsurf_i_integers *z) {
    const int n = s->high - s->low;
    algsurf_zpoly p[2];
    s->unit = n > 0 ? (int)lround((double)(ilogb(extent(s, s->low)) - ilogb(extent(s, s->high))) / n) : 0;
    s->least = ALGSURF_Z_NO_BIT;
    for (int i = 0; i < 2 && s->part[i]; i++) {
        int least = algsurf_zpoly_least_bit(s->part[i] + s->low * s->step, s->step, n, s->unit);
        s->least = least < s->least ? least : s->least;
    }
    if (s->least == ALGSURF_Z_NO_BIT) s->least = 0; /* radii alone */
    for (int i = 0; i < 2 && s->part[i]; i++) {
        const double *c = s->part[i] + s->low * s->step;
        if (!algsurf_zpoly_from_doubles(s->m, c, s->step, n, s->unit, s->least, p + i)) return 0;
        p[i].degree = n; /* radii may have more coefficients */
    }
    if (!algsurf_i_make_integers(s->m, p, s->part[1] ? p + 1 : NULL, z)) return 0;
    if (!s->r) return 1;
    algsurf_scaled *radius = algsurf_i_take(s->m, (size_t)(n + 1) * sizeof *radius);
    if (!radius) return 0;
    for (int k = 0; k <= n; k++) {
        radius[k] = scaled_double(s->r[s->low + k], 0, (int64_t)k * s->unit - s->least);
        z->size[k] = sum(z->size[k], radius[k]);
    }
    z->radius = radius;
    return 1;
}

/* The leading coefficient is not 0, by its radius and some more. */
static int has_lead(const algsurf_i_integers *z) {
    int n = z->re.degree;
    algsurf_scaled size = size_of(z->head[n]);
    return !z->radius || less(z->radius[n], by(size, 1 - 0x1p-30));
}

/* ---- integers ---- */

static int is_none(const algsurf_integer *z) { return algsurf_z_length(z->limbs, abs(z->length)) == 0; }

static algsurf_status read_integers(problem *s, int degree) {
    algsurf_status re = algsurf_zpoly_check(s->z[0], degree),
                   im = s->z[1] ? algsurf_zpoly_check(s->z[1], degree) : ALGSURF_E_ZERO;
    if (re != ALGSURF_OK && re != ALGSURF_E_ZERO) return re;
    if (im != ALGSURF_OK && (im != ALGSURF_E_ZERO || re != ALGSURF_OK)) return im;
    s->real = re != ALGSURF_OK || im != ALGSURF_OK;
    if (re != ALGSURF_OK) s->z[0] = s->z[1]; /* i times real ones, which have the same roots */
    if (s->real) s->z[1] = NULL;
    for (s->low = 0; is_none(s->z[0] + s->low) && (s->real || is_none(s->z[1] + s->low));) s->low++;
    for (s->high = degree; is_none(s->z[0] + s->high) && (s->real || is_none(s->z[1] + s->high));) s->high--;
    return ALGSURF_OK;
}

static int take_integers(problem *s, algsurf_i_integers *z) {
    algsurf_zpoly p[2];
    for (int i = 0; i < 2 && s->z[i]; i++)
        if (!algsurf_zpoly_from_integers(s->m, s->z[i] + s->low, s->high - s->low, p + i)) return 0;
    return algsurf_i_make_integers(s->m, p, s->real ? NULL : p + 1, z);
}

/* ---- all ---- */

/* A root may be real. */
static int meets_axis(const algsurf_i_discs *d) {
    for (int i = 0; i < d->n; i++)
        if (!less(d->root[i].disc, by(d->root[i].z.above, 0.5))) return 1;
    return 0;
}

/* The roots but 0, from start values or null.  Where doubles do not come to rest there may be multiple ones.
 */
static int solve(problem *s, algsurf_i_integers *z, const algsurf_scaled *given) {
    algsurf_i_discs d;
    int open = 1;
    if (!algsurf_i_discs_begin(&d, s->m, z, given, &s->answer.proposed)) return 0;
    if ((s->r || d.settled) && !algsurf_i_discs_run(&d, s->r ? RADII_SWEEPS : 0, &open)) return 0;
    s->answer.unit = s->unit;
    if (!s->r && (open || (z->im.c && meets_axis(&d)))) {
        if (!algsurf_i_solve_factors(s->m, z, &s->answer)) return 0;
        if (s->answer.count > 0) return 1;
        if (open && algsurf_i_is_in_squares(z)
                ? !algsurf_i_discs_separate(&d, s->m, z, ALGSURF_I_MOST_SWEEPS, &open, &s->answer.proposed)
                : !algsurf_i_discs_run(&d, ALGSURF_I_MOST_SWEEPS, &open))
            return 0;
    }
    return algsurf_i_deliver(&d, &s->answer);
}

static algsurf_status take_and_solve(problem *s, const algsurf_complex *start) {
    algsurf_i_integers z;
    int n = s->high - s->low;
    algsurf_scaled *given = NULL;
    if (!(s->z[0] ? take_integers(s, &z) : take_doubles(s, &z))) return ALGSURF_E_NO_MEMORY;
    z.real = s->real;
    if (!has_lead(&z)) return ALGSURF_E_RANGE;
    if (start && !(given = algsurf_i_take(s->m, (size_t)n * sizeof *given))) return ALGSURF_E_NO_MEMORY;
    for (int i = 0; given && i < n; i++) { /* what is no number is 0: it keeps its own start value */
        int finite = isfinite(start[i].re) && isfinite(start[i].im);
        given[i] = finite ? scaled_double(start[i].re, start[i].im, -s->unit) : scaled_none();
    }
    return n == 0 || solve(s, &z, given) ? ALGSURF_OK : ALGSURF_E_NO_MEMORY;
}

/* All boxes, the root 0 among them; *again: those of different factors meet, which narrower ones need not. */
static algsurf_status find_boxes(problem *s, const algsurf_complex *start, int *again) {
    algsurf_i_answer *a = &s->answer;
    const int pressed = *again;
    a->count = a->factors = *again = 0, a->pressed = pressed;
    algsurf_status status = take_and_solve(s, start);
    if (status != ALGSURF_OK || a->precise) return status;
    if (s->low > 0) a->roots[a->count++] = (algsurf_complex_root){.multiplicity = s->low, .real = 1};
    const int found = a->count;
    a->count = algsurf_i_join_boxes(a->roots, found, s->real);
    *again = a->count < found && a->factors > 1 && !pressed;
    return ALGSURF_OK;
}

/* With memory for all that is taken. */
static algsurf_status solve_all(problem *s, const algsurf_complex *start, size_t limit,
                                algsurf_complex_root *roots, int *count) {
    uint64_t own[OWN_WORDS];
    algsurf_memory m;
    algsurf_memory_mark mark = algsurf_memory_begin(&m, own, OWN_WORDS, limit);
    algsurf_i_answer *a = &s->answer;
    int again = 0;
    s->m = &m;
    a->roots = algsurf_i_take(&m, (size_t)((s->real ? 1 : 3) * s->high + 1) * sizeof *a->roots);
    algsurf_memory_mark empty = algsurf_memory_here(&m);
    algsurf_status status = a->roots ? find_boxes(s, start, &again) : ALGSURF_E_NO_MEMORY;
    if (again) algsurf_memory_release(&m, empty), status = find_boxes(s, start, &again);
    if (status == ALGSURF_OK && roots) {
        *count = a->count;
        memcpy(roots, a->roots, (size_t)*count * sizeof *roots);
    }
    algsurf_memory_release(&m, mark);
    return status;
}

algsurf_status algsurf_i_all_roots(const double *re, const double *im, int step, const double *r, int degree,
                                   const algsurf_complex *start, algsurf_complex_root *roots, int *count,
                                   algsurf_complex_solver_stats *stats) {
    problem s = {.part = {re, im}, .step = step, .r = r};
    algsurf_status status = read_doubles(&s, degree);
    if (status == ALGSURF_OK) status = solve_all(&s, start, ALGSURF_I_COMPLEX_MEMORY, roots, count);
    if (status == ALGSURF_OK && stats) stats->iterations = s.answer.proposed, stats->retries = s.answer.moved;
    return status;
}

algsurf_status algsurf_complex_roots_integers(const algsurf_integer *re, const algsurf_integer *im,
                                              int degree, algsurf_complex_root *roots, int *count) {
    problem s = {.z = {re, im}};
    if (!re || !roots || !count) return ALGSURF_E_ARGUMENT;
    algsurf_status status = read_integers(&s, degree);
    if (status != ALGSURF_OK) return status;
    ALGSURF_STANDARD(status = solve_all(&s, NULL, ALGSURF_I_COMPLEX_MEMORY, roots, count));
    return status;
}

algsurf_status algsurf_i_find_precise_roots(const algsurf_integer *re, const algsurf_integer *im, int degree,
                                            size_t limit, algsurf_precise_roots *roots, int *at_zero) {
    problem s = {.z = {re, im}, .answer = {.precise = roots}};
    algsurf_status status = read_integers(&s, degree);
    if (status != ALGSURF_OK) return status;
    *at_zero = s.low;
    return solve_all(&s, NULL, limit, NULL, NULL);
}

/* ---- solvers ---- */

struct algsurf_complex_solver {
    int max_degree;
};

algsurf_status algsurf_complex_solver_create(int max_degree, algsurf_complex_solver **solver) {
    if (!solver || max_degree < 1) return ALGSURF_E_ARGUMENT;
    if (max_degree > ALGSURF_MAX_POLY_DEGREE) return ALGSURF_E_DEGREE;
    algsurf_complex_solver *s = malloc(sizeof *s);
    if (!s) return ALGSURF_E_NO_MEMORY;
    s->max_degree = max_degree;
    *solver = s;
    return ALGSURF_OK;
}

void algsurf_complex_solver_free(algsurf_complex_solver *solver) { free(solver); }

algsurf_status algsurf_complex_solver_run(algsurf_complex_solver *solver, const algsurf_complex *c,
                                          const double *r, int degree, const algsurf_complex *start,
                                          algsurf_complex_root *roots, int *count,
                                          algsurf_complex_solver_stats *stats) {
    algsurf_complex_solver_stats known = {0};
    if (!solver || !roots || !count) return ALGSURF_E_ARGUMENT;
    if (stats && !algsurf_options_fit(stats, sizeof *stats)) return ALGSURF_E_SIZE;
    if (degree > solver->max_degree) return ALGSURF_E_DEGREE;
    if (!c) return ALGSURF_E_ARGUMENT;
    algsurf_status status;
    ALGSURF_STANDARD(status = algsurf_i_all_roots(&c->re, &c->im, 2, r, degree, start, roots, count, &known));
    if (status >= ALGSURF_OK && stats) algsurf_options_write(stats, &known, sizeof known);
    return status;
}
