/* allroots.c - all roots of one polynomial: doubles as integers, the order of the steps, solvers.
 *
 * A coefficient is m 2^e with integers m and e: a power of two times p(2^unit y) has integers for
 * coefficients, without any rounding.  What doubles propose is proved and made narrow by discs.c; where roots
 * stay together, the polynomial may have multiple ones, which never part: with exact real coefficients p is a
 * constant times prod f_k^k, where the squarefree f_k holds the roots of multiplicity k, once each (Yun 1976,
 * poly/multiplicity.c), and each f_k is solved by itself.  The boxes of all factors together hold all roots,
 * and are joined where they meet. */
#include "../base/arithmetic.h"
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/fpenv.h"
#include "../base/options.h"
#include "../poly/degree.h"
#include "discs.h"
#include "impl.h"

#define OWN_WORDS ((size_t)(15 << 10) / sizeof(uint64_t)) /* on the stack */
#define FIRST_SWEEPS 4                                    /* before multiple roots are looked for */
#define RADII_SWEEPS 64                                   /* what radii allow to know is known by then */

/* The polynomial in doubles, without exact zeros at either end, and what is made of it. */
typedef struct problem {
    const algsurf_complex *c;
    const double *r;             /* or null */
    const algsurf_integer *z[2]; /* in place of c; z[1] may be null */
    int low, high;               /* from c[low] to c[high] */
    int real;                    /* coefficients and their radii */
    int unit, least;             /* integer k is coefficient low + k times 2^(k unit - least) */
    algsurf_memory *m;
    algsurf_i_answer answer;
    int proposed, moved;
} problem;

static algsurf_status read_input(const algsurf_complex *c, const double *r, int degree, int real_radii,
                                 problem *s) {
    *s = (problem){.c = c, .high = -1, .low = degree, .real = 1};
    for (int k = 0; k <= degree; k++) {
        if (!isfinite(c[k].re) || !isfinite(c[k].im) || (r && !isfinite(r[k]))) return ALGSURF_E_NOT_FINITE;
        if (r && r[k] < 0) return ALGSURF_E_ARGUMENT;
        if (r && r[k] > 0) s->r = r;
        if (c[k].im != 0 || (r && r[k] > 0 && !real_radii)) s->real = 0;
        if (c[k].re == 0 && c[k].im == 0 && (!r || r[k] == 0)) continue;
        if (s->low > k) s->low = k;
        s->high = k;
    }
    return s->high < 0 ? ALGSURF_E_ZERO : ALGSURF_OK;
}

/* |c| and its radius, at least. */
static double extent(const problem *s, int k) {
    const algsurf_complex c = s->c[s->low + k];
    return fmax(fmax(fabs(c.re), fabs(c.im)), s->r ? s->r[s->low + k] : 0);
}

/* A unit of the variable in which the first and the last coefficient balance, so that integers are short; the
 * least exponent of all coefficients, and the bits of the largest. */
static int choose_unit(problem *s) {
    int n = s->high - s->low, end = INT_MIN, e;
    s->unit = n > 0 ? (int)lround((double)(ilogb(extent(s, 0)) - ilogb(extent(s, n))) / n) : 0;
    s->least = INT_MAX;
    for (int k = 0; k <= n; k++) {
        const double part[2] = {s->c[s->low + k].re, s->c[s->low + k].im};
        for (int i = 0; i < 2; i++) {
            algsurf_limb odd = algsurf_z_odd_part(part[i], &e);
            if (!odd) continue;
            e += k * s->unit;
            s->least = e < s->least ? e : s->least;
            e += algsurf_limb_bits(odd);
            end = e > end ? e : end;
        }
    }
    if (end == INT_MIN) s->least = end = 0; /* radii alone */
    return end - s->least;
}

static algsurf_scaled scaled_double(double x, double y, int64_t exponent) {
    int e;
    double most = fmax(fabs(x), fabs(y));
    if (most == 0) return algsurf_i_scaled_of(0, 0, 0);
    (void)frexp(most, &e);
    return algsurf_i_scaled_of(ldexp(x, -e), ldexp(y, -e), exponent + e);
}

static int make_integers(problem *s, algsurf_i_integers *z) {
    int n = s->high - s->low, w = algsurf_z_width(choose_unit(s));
    *z = (algsurf_i_integers){.p = {.real = s->real}};
    int complex = 0, turned = 1; /* turned: i times a real polynomial, which has the same roots */
    for (int k = 0; k <= n; k++) {
        complex = complex || s->c[s->low + k].im != 0;
        turned = turned && s->c[s->low + k].re == 0 && !s->r;
    }
    if (turned) complex = 0, z->p.real = s->real = 1;
    if (!algsurf_zpoly_new(s->m, n, w, &z->p.re)) return 0;
    if (complex && !algsurf_zpoly_new(s->m, n, w, &z->p.im)) return 0;
    for (int k = 0; k <= n; k++) {
        algsurf_complex c = s->c[s->low + k];
        algsurf_z_add_double(algsurf_zpoly_at(&z->p.re, k), w, turned ? c.im : c.re, k * s->unit - s->least);
        if (complex) algsurf_z_add_double(algsurf_zpoly_at(&z->p.im, k), w, c.im, k * s->unit - s->least);
    }
    if (!algsurf_i_make_heads(s->m, z)) return 0;
    if (!s->r) return 1;
    for (int k = 0; k <= n; k++) {
        z->radius[k] = scaled_double(s->r[s->low + k], 0, (int64_t)k * s->unit - s->least);
        z->size[k] = algsurf_i_scaled_join(z->size[k], z->radius[k], 1);
    }
    z->p.radius = z->radius;
    return 1;
}

/* The leading coefficient is not 0 by its radius. */
static int has_lead(const algsurf_i_integers *z) {
    int n = z->p.re.degree;
    algsurf_scaled size = algsurf_i_scaled_size(z->head[n]);
    size.re *= 1 - 0x1p-30;
    return !z->p.radius || algsurf_i_scaled_less(z->radius[n], size);
}

/* ---- integers ---- */

static int is_good(const algsurf_integer *z) {
    if (z->length < -ALGSURF_MAX_LIMBS || z->length > ALGSURF_MAX_LIMBS) return 0;
    return z->length == 0 || z->limbs;
}

static int is_none(const algsurf_integer *z) {
    return z->length == 0 || algsurf_z_length(z->limbs, abs(z->length)) == 0;
}

static algsurf_status read_integers(const algsurf_integer *re, const algsurf_integer *im, int degree,
                                    problem *s) {
    algsurf_status status = algsurf_i_check_degree(degree);
    if (status != ALGSURF_OK) return status;
    *s = (problem){.z = {re, im}, .high = -1, .low = degree, .real = 1};
    int turned = im != NULL; /* i times real ones have the same roots */
    for (int k = 0; k <= degree; k++) {
        if (!is_good(re + k) || (im && !is_good(im + k))) return ALGSURF_E_ARGUMENT;
        turned = turned && is_none(re + k);
    }
    if (turned) s->z[0] = im, s->z[1] = NULL;
    for (int i = 0; i < 2; i++)
        for (int k = 0; s->z[i] && k <= degree; k++) {
            if (is_none(s->z[i] + k)) continue;
            if (i) s->real = 0;
            if (s->low > k) s->low = k;
            if (s->high < k) s->high = k;
        }
    return s->high < 0 ? ALGSURF_E_ZERO : ALGSURF_OK;
}

static int copy_integers(problem *s, const algsurf_integer *z, int w, algsurf_zpoly *p) {
    if (!algsurf_zpoly_new(s->m, s->high - s->low, w, p)) return 0;
    for (int k = s->low; k <= s->high; k++) {
        algsurf_limb *a = algsurf_zpoly_at(p, k - s->low);
        if (z[k].length) memcpy(a, z[k].limbs, (size_t)abs(z[k].length) * sizeof *a);
        if (z[k].length < 0) algsurf_z_negate(a, w);
    }
    return 1;
}

static int take_integers(problem *s, algsurf_i_integers *z) {
    int longest = 0;
    for (int i = 0; i < 2; i++)
        for (int k = s->low; s->z[i] && k <= s->high; k++)
            if (abs(s->z[i][k].length) > longest) longest = abs(s->z[i][k].length);
    *z = (algsurf_i_integers){.p = {.real = s->real}};
    return copy_integers(s, s->z[0], longest + 1, &z->p.re) &&
           (s->real || copy_integers(s, s->z[1], longest + 1, &z->p.im)) && algsurf_i_make_heads(s->m, z);
}

/* ---- all ---- */

/* The roots but 0, from start values or null. */
static int solve(problem *s, algsurf_i_integers *z, const algsurf_scaled *given) {
    algsurf_i_discs d;
    int open, n = z->p.re.degree;
    algsurf_scaled *at = algsurf_i_take(s->m, (size_t)n * sizeof *at);
    if (!at || !algsurf_i_propose(s->m, z, given, at, &s->proposed)) return 0;
    if (!algsurf_i_discs_begin(&d, s->m, &z->p, at)) return 0;
    if (!algsurf_i_discs_run(&d, s->r ? RADII_SWEEPS : FIRST_SWEEPS, &open)) return 0;
    s->answer.unit = s->unit, s->answer.real = !z->p.im.c;
    if (open && !s->r) {
        if (!algsurf_i_solve_factors(s->m, &z->p, &s->answer, &s->proposed, &s->moved)) return 0;
        if (s->answer.count > 0) return 1;
        if (!algsurf_i_discs_run(&d, ALGSURF_I_MOST_SWEEPS, &open)) return 0;
    }
    if (!algsurf_i_deliver(&d, 1, &s->answer)) return 0;
    s->moved += d.moved;
    return 1;
}

static algsurf_status solve_doubles(problem *s, const algsurf_complex *start) {
    algsurf_i_integers z;
    int n = s->high - s->low;
    algsurf_scaled *given = NULL;
    if (!make_integers(s, &z)) return ALGSURF_E_NO_MEMORY;
    if (!has_lead(&z)) return ALGSURF_E_RANGE;
    if (start && !(given = algsurf_i_take(s->m, (size_t)n * sizeof *given))) return ALGSURF_E_NO_MEMORY;
    for (int i = 0; given && i < n; i++) { /* what is no number is 0: it keeps its own start value */
        int finite = isfinite(start[i].re) && isfinite(start[i].im);
        given[i] = finite ? scaled_double(start[i].re, start[i].im, -s->unit) : algsurf_i_scaled_none();
    }
    return n == 0 || solve(s, &z, given) ? ALGSURF_OK : ALGSURF_E_NO_MEMORY;
}

static algsurf_status solve_integers(problem *s) {
    algsurf_i_integers z;
    return take_integers(s, &z) && (s->high == s->low || solve(s, &z, NULL)) ? ALGSURF_OK
                                                                             : ALGSURF_E_NO_MEMORY;
}

/* With memory for all that is taken. */
static algsurf_status solve_all(problem *s, const algsurf_complex *start, size_t limit,
                                algsurf_complex_root *roots, int *count) {
    uint64_t own[OWN_WORDS];
    algsurf_memory m;
    algsurf_memory_begin(&m, own, OWN_WORDS, limit);
    algsurf_memory_mark mark = algsurf_memory_here(&m);
    algsurf_i_answer *a = &s->answer;
    s->m = &m;
    a->roots = algsurf_i_take(&m, (size_t)(s->high + 1) * sizeof *a->roots);
    algsurf_status status = ALGSURF_E_NO_MEMORY;
    if (a->roots) status = s->c ? solve_doubles(s, start) : solve_integers(s);
    if (status == ALGSURF_OK && roots) {
        if (s->low > 0) a->roots[a->count++] = (algsurf_complex_root){.multiplicity = s->low, .real = 1};
        *count = algsurf_i_join_boxes(a->roots, a->count, s->real);
        memcpy(roots, a->roots, (size_t)*count * sizeof *roots);
    }
    algsurf_memory_release(&m, mark);
    return status;
}

algsurf_status algsurf_i_all_roots(const algsurf_complex *c, const double *r, int degree, int real_radii,
                                   const algsurf_complex *start, algsurf_complex_root *roots, int *count,
                                   algsurf_complex_solver_stats *stats) {
    problem s;
    if (!c || degree < 0) return ALGSURF_E_ARGUMENT;
    algsurf_status status = read_input(c, r, degree, real_radii, &s);
    if (status == ALGSURF_OK) status = solve_all(&s, start, ALGSURF_I_COMPLEX_MEMORY, roots, count);
    if (status == ALGSURF_OK && stats) stats->iterations = s.proposed, stats->retries = s.moved;
    return status;
}

algsurf_status algsurf_complex_roots_integers(const algsurf_integer *re, const algsurf_integer *im,
                                              int degree, algsurf_complex_root *roots, int *count) {
    problem s;
    if (!re || !roots || !count) return ALGSURF_E_ARGUMENT;
    algsurf_status status = read_integers(re, im, degree, &s);
    if (status != ALGSURF_OK) return status;
    ALGSURF_STANDARD(status = solve_all(&s, NULL, ALGSURF_I_COMPLEX_MEMORY, roots, count));
    return status;
}

algsurf_status algsurf_i_find_precise_roots(const algsurf_integer *re, const algsurf_integer *im, int degree,
                                            size_t limit, algsurf_precise_roots *roots, int *at_zero) {
    problem s;
    algsurf_status status = read_integers(re, im, degree, &s);
    if (status != ALGSURF_OK) return status;
    s.answer.precise = roots;
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
    algsurf_status status;
    ALGSURF_STANDARD(status = algsurf_i_all_roots(c, r, degree, 0, start, roots, count, &known));
    if (status >= ALGSURF_OK && stats) algsurf_options_write(stats, &known, sizeof known);
    return status;
}
