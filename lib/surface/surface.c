/* surface.c - making a surface: merging terms, the natural unit and scale, the nested layout.
 *
 * Terms are sorted by exponents and equal ones added.  Let A_k = sum |a| over the terms of total
 * degree k, n the degree.  In units of length 2^unit the sums become A_k 2^(unit k): the unit is the
 * one in which no lower sum exceeds the highest, up to rounding the unit to a power of two,
 *     2^unit ~ rho = max over k < n of (A_k / A_n)^(1/(n-k)),
 * the same balance as Fujiwara's bound for the roots of a polynomial in one variable (1916): the
 * interesting part of the surface is then a few units large, whatever units the caller has.
 * See impl.h for the layout.
 */
#include "../base/arithmetic.h"
#include "impl.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../base/fpenv.h"
#include "../base/options.h"
#include "../base/elementary.h"
#include "../base/integer.h"

/* A term and its place in the input: sorting with it is stable, whatever qsort does. */
typedef struct placed_term {
    algsurf_term term;
    size_t place;
} placed_term;

static int compare_terms(const void *left, const void *right) {
    const placed_term *a = left, *b = right;
    if (a->term.k != b->term.k) return b->term.k - a->term.k; /* exponents are not negative */
    if (a->term.j != b->term.j) return b->term.j - a->term.j;
    if (a->term.i != b->term.i) return b->term.i - a->term.i;
    return (a->place > b->place) - (a->place < b->place);
}

static algsurf_status check_terms(const algsurf_term *terms, size_t count) {
    for (size_t t = 0; t < count; t++) {
        if (terms[t].i < 0 || terms[t].j < 0 || terms[t].k < 0) return ALGSURF_E_ARGUMENT;
        if (!isfinite(terms[t].a)) return ALGSURF_E_NOT_FINITE;
    }
    return ALGSURF_OK;
}

/* Adds equal terms of a sorted array in place, drops zeros; *count becomes what is left. */
static algsurf_status merge_terms(placed_term *sorted, size_t *count) {
    size_t kept = 0;
    for (size_t t = 0; t < *count;) {
        algsurf_term sum = sorted[t].term;
        for (t++; t < *count; t++) {
            const algsurf_term *next = &sorted[t].term;
            if (next->i != sum.i || next->j != sum.j || next->k != sum.k) break;
            sum.a += next->a;
        }
        if (!isfinite(sum.a)) return ALGSURF_E_RANGE;
        if (sum.a == 0) continue;
        if (sum.i > ALGSURF_MAX_DEGREE || sum.j > ALGSURF_MAX_DEGREE || sum.k > ALGSURF_MAX_DEGREE ||
            sum.i + sum.j + sum.k > ALGSURF_MAX_DEGREE)
            return ALGSURF_E_DEGREE;
        sorted[kept++].term = sum;
    }
    *count = kept;
    return kept ? ALGSURF_OK : ALGSURF_E_ZERO;
}

static algsurf_status store_terms(algsurf_surface *s, const algsurf_term *terms, size_t count) {
    if (count > SIZE_MAX / sizeof(placed_term)) return ALGSURF_E_NO_MEMORY;
    placed_term *sorted = malloc(count * sizeof *sorted);
    if (!sorted) return ALGSURF_E_NO_MEMORY;
    for (size_t t = 0; t < count; t++) sorted[t] = (placed_term){terms[t], t};
    qsort(sorted, count, sizeof *sorted, compare_terms);
    algsurf_status status = merge_terms(sorted, &count);
    if (status == ALGSURF_OK) {
        s->terms = malloc(count * sizeof *s->terms);
        if (!s->terms) status = ALGSURF_E_NO_MEMORY;
    }
    for (size_t t = 0; status == ALGSURF_OK && t < count; t++) {
        const algsurf_term *term = &sorted[t].term;
        int degree = term->i + term->j + term->k;
        s->terms[t] = *term;
        if (s->degree < degree) s->degree = degree;
    }
    s->term_count = count;
    free(sorted);
    return status;
}

/* What the choice of unit and scale needs to know of the terms of one total degree. */
typedef struct degree_summary {
    int top;    /* largest e with some |a| in [2^(e-1), 2^e); INT_MIN: no terms */
    int low;    /* smallest exponent of a last non-zero bit */
    double sum; /* sum of |a| 2^-top */
} degree_summary;

static void summarise(const algsurf_surface *s, degree_summary of[ALGSURF_MAX_DEGREE + 1]) {
    for (int d = 0; d <= s->degree; d++) of[d] = (degree_summary){INT_MIN, INT_MAX, 0.0};
    for (size_t t = 0; t < s->term_count; t++) {
        const algsurf_term *term = &s->terms[t];
        degree_summary *d = &of[term->i + term->j + term->k];
        int e, low;
        (void)algsurf_z_odd_part(term->a, &low);
        (void)frexp(term->a, &e);
        if (d->top < e) d->top = e;
        if (d->low > low) d->low = low;
    }
    for (size_t t = 0; t < s->term_count; t++) {
        const algsurf_term *term = &s->terms[t];
        degree_summary *d = &of[term->i + term->j + term->k];
        d->sum += ldexp(fabs(term->a), -d->top);
    }
}

/* The nearest integer to log2(rho), 0 when there are no lower terms. */
static int balanced_unit(const degree_summary *of, int n) {
    double highest = algsurf_i_log2(of[n].sum), largest = -HUGE_VAL;
    for (int k = 0; k < n; k++) {
        if (of[k].top == INT_MIN) continue;
        largest = fmax(largest, (of[k].top - of[n].top + (algsurf_i_log2(of[k].sum) - highest)) / (n - k));
    }
    return largest > -HUGE_VAL ? (int)lrint(largest) : 0;
}

/* The scale that brings the largest coefficient into [1/2, 1). */
static int scale_for(const degree_summary *of, int n, int unit) {
    int top = INT_MIN;
    for (int k = 0; k <= n; k++)
        if (of[k].top != INT_MIN && of[k].top + unit * k > top) top = of[k].top + unit * k;
    return -top;
}

/* Does some coefficient have bits below 2^-1074 in this unit? */
static int loses_bits(const degree_summary *of, int n, int unit) {
    int scale = scale_for(of, n, unit);
    for (int k = 0; k <= n; k++)
        if (of[k].top != INT_MIN && of[k].low + unit * k + scale < -1074) return 1;
    return 0;
}

/* The balanced unit, or if that loses bits the nearest one towards 0 that does not, if any. */
static void choose_unit(algsurf_surface *s) {
    degree_summary of[ALGSURF_MAX_DEGREE + 1];
    summarise(s, of);
    int balanced = balanced_unit(of, s->degree), unit = balanced;
    while (unit != 0 && loses_bits(of, s->degree, unit)) unit -= (unit > 0) - (unit < 0);
    if (loses_bits(of, s->degree, unit)) unit = balanced;
    s->unit = unit;
    s->scale = scale_for(of, s->degree, unit);
    s->inexact = loses_bits(of, s->degree, unit);
}

/* Levels and rows.  Terms are read backwards, in increasing order of exponents, so that the last one
 * seen of a level or row tells its length. */
static algsurf_status lay_out_rows(algsurf_surface *s, size_t *coef_count) {
    s->level_count = s->terms[0].k + 1;
    s->levels = calloc((size_t)s->level_count, sizeof *s->levels);
    if (!s->levels) return ALGSURF_E_NO_MEMORY;
    for (size_t t = s->term_count; t-- > 0;) s->levels[s->terms[t].k].count = s->terms[t].j + 1;
    size_t row_count = 0;
    for (int k = 0; k < s->level_count; k++) {
        s->levels[k].first = row_count;
        row_count += (size_t)s->levels[k].count;
    }
    s->rows = calloc(row_count, sizeof *s->rows);
    if (!s->rows) return ALGSURF_E_NO_MEMORY;
    for (size_t t = s->term_count; t-- > 0;) {
        const algsurf_term *term = &s->terms[t];
        s->rows[s->levels[term->k].first + (size_t)term->j].length = term->i + 1;
    }
    *coef_count = 0;
    for (size_t r = 0; r < row_count; r++) {
        s->rows[r].first = *coef_count;
        *coef_count += (size_t)s->rows[r].length;
    }
    return ALGSURF_OK;
}

/* Unit, scale and coefficients in them. */
static algsurf_status lay_out(algsurf_surface *s) {
    size_t coef_count;
    choose_unit(s);
    algsurf_status status = lay_out_rows(s, &coef_count);
    if (status != ALGSURF_OK) return status;
    s->coef = malloc(coef_count * sizeof *s->coef);
    if (!s->coef) return ALGSURF_E_NO_MEMORY;
    s->smallest = 1;
    s->stride[0] = s->stride[1] = s->stride[2] = 2;
    for (size_t c = 0; c < coef_count; c++) s->coef[c] = 0.0;
    for (size_t t = 0; t < s->term_count; t++) {
        const algsurf_term *term = &s->terms[t];
        const algsurf_row *row = &s->rows[s->levels[term->k].first + (size_t)term->j];
        double coef = ldexp(term->a, s->unit * (term->i + term->j + term->k) + s->scale);
        s->coef[row->first + (size_t)term->i] = coef;
        if (coef != 0 && fabs(coef) < s->smallest) s->smallest = fabs(coef);
        s->size += fabs(coef);
        if (term->i % 2) s->stride[0] = 1;
        if (term->j % 2) s->stride[1] = 1;
        if (term->k % 2) s->stride[2] = 1;
    }
    return ALGSURF_OK;
}

ALGSURF_NOINLINE algsurf_status algsurf_i_surface_make(const algsurf_term *terms, size_t count, double error,
                                                       double rounding, algsurf_surface **surface) {
    algsurf_surface *s = calloc(1, sizeof *s);
    if (!s) return ALGSURF_E_NO_MEMORY;
    s->error = error * (1 + 0x1p-20);
    s->rounding = rounding;
    algsurf_status status = store_terms(s, terms, count);
    if (status == ALGSURF_OK) status = lay_out(s);
    if (status == ALGSURF_OK && !algsurf_i_surface_set_tables(s)) status = ALGSURF_E_NO_MEMORY;
    if (status == ALGSURF_OK) status = algsurf_i_surface_find_power(s);
    if (status == ALGSURF_OK)
        *surface = s;
    else
        algsurf_surface_free(s);
    return status;
}

ALGSURF_I_ENTRY(algsurf_status, surface_from_terms,
                (const algsurf_term *terms, size_t count, algsurf_surface **surface),
                (terms, count, surface)) {
    if (!terms || count == 0 || !surface) return ALGSURF_E_ARGUMENT;
    algsurf_status status = check_terms(terms, count);
    return status == ALGSURF_OK ? algsurf_i_surface_make(terms, count, 0, 0, surface) : status;
}

ALGSURF_I_ENTRY(algsurf_status, surface_with_error,
                (const algsurf_surface *surface, double error, algsurf_surface **approximate),
                (surface, error, approximate)) {
    if (!surface || !approximate) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_check_number(error, error >= 0 && error < 1);
    if (status != ALGSURF_OK) return status;
    return algsurf_i_surface_make(surface->terms, surface->term_count, error, surface->rounding, approximate);
}

double algsurf_surface_rounding(const algsurf_surface *surface) { return surface ? surface->rounding : 0; }

void algsurf_surface_free(algsurf_surface *surface) {
    if (!surface) return;
    free(surface->terms);
    free(surface->levels);
    free(surface->rows);
    free(surface->coef);
    free(surface->tables);
    algsurf_surface_free(surface->root);
    free(surface);
}

int algsurf_surface_degree(const algsurf_surface *surface) { return surface ? surface->degree : -1; }

size_t algsurf_surface_term_count(const algsurf_surface *surface) {
    return surface ? surface->term_count : 0;
}

algsurf_status algsurf_surface_terms(const algsurf_surface *surface, algsurf_term *terms) {
    if (!surface || !terms) return ALGSURF_E_ARGUMENT;
    memcpy(terms, surface->terms, surface->term_count * sizeof *terms);
    return ALGSURF_OK;
}
