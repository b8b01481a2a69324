/* value.c - see poly.h.
 *
 * The weight of a value is the number of terms that a polynomial is multiplied by, one after the other, when
 * it is multiplied by the value as it was made: of a polynomial its terms, of a sum or a product the sum of
 * the weights, of a power the weight of its base times the exponent, of a series that and as many more.  It
 * is at most twice the number of constants and variables in the text times the exponents about each; these
 * are at most 64 together, since a base that is constant has one term, and weight 1.  A way is kept only
 * while it is lighter than the terms, and where it matters: equations as people write them are multiplied
 * term by term.
 */
#include "../base/arithmetic.h"
#include "poly.h"

#include <stdlib.h>
#include <string.h>

enum { FEW_TERMS = 32 }; /* not worth a way */

/* The sum of the parts, their product raised to the power, or a series in the only part; then times a
 * monomial. */
typedef struct algsurf_i_way {
    int is_sum, power;
    monomial scale, *series; /* coefficients up to the power; null: no series */
    size_t weight, count, capacity;
    value *part;        /* those with a way have no polynomial */
    algsurf_i_sum made; /* of parts with a way, as long as there may be more */
} way;

static size_t weight_of(const value *v) { return v->way ? v->way->weight : v->p.count; }

static void way_free(way *w) {
    for (size_t i = 0; w && i < w->count; i++) algsurf_i_value_free(&w->part[i]);
    if (w) free(w->part), free(w->series);
    free(w);
}

void algsurf_i_value_free(value *v) {
    algsurf_i_tripoly_free(&v->p);
    way_free(v->way);
    v->way = NULL;
}

void algsurf_i_value_negate(value *v) {
    for (size_t t = 0; t < v->p.count; t++) v->p.m[t].v = algsurf_dd_neg(v->p.m[t].v);
    if (v->way) v->way->scale.v = algsurf_dd_neg(v->way->scale.v);
}

static const monomial one = {{1.0, 0.0}, 0.0, 0, 0};

/* Appends the value to the parts of *w, which is made if it is null, and takes it over; times: how often a
 * polynomial is multiplied by it. */
static algsurf_status remember(way **w, int is_sum, value *v, int times) {
    if (!*w) {
        *w = calloc(1, sizeof **w);
        if (*w) (*w)->is_sum = is_sum, (*w)->power = times, (*w)->scale = one;
    }
    if (*w && (*w)->count == (*w)->capacity) {
        size_t capacity = 2 * (*w)->capacity + 2;
        value *part = realloc((*w)->part, capacity * sizeof *part);
        if (part) (*w)->part = part, (*w)->capacity = capacity;
    }
    if (!*w || (*w)->count == (*w)->capacity) {
        algsurf_i_value_free(v);
        return ALGSURF_E_NO_MEMORY;
    }
    (*w)->weight += weight_of(v) * (size_t)times;
    if (v->way) algsurf_i_tripoly_free(&v->p);
    (*w)->part[(*w)->count++] = *v;
    *v = (value){{NULL, 0}, NULL};
    return ALGSURF_OK;
}

/* Forgets the way of a value where it is no shorter. */
static void weigh(value *v) {
    if (v->p.count > FEW_TERMS && v->p.count > weight_of(v)) return;
    way_free(v->way);
    v->way = NULL;
}

static algsurf_status by_way(const way *w, const tripoly *a, tripoly *out);

/* a times the value as it was made. */
static algsurf_status times(const tripoly *a, const value *v, tripoly *out) {
    return v->way ? by_way(v->way, a, out) : algsurf_i_tripoly_multiply(a, &v->p, out);
}

/* By Horner's rule. */
static algsurf_status by_series(const way *w, const tripoly *a, tripoly *out) {
    tripoly last = {NULL, 0};
    algsurf_status status = ALGSURF_OK;
    for (int i = w->power; status == ALGSURF_OK && i >= 0; i--) {
        tripoly next = {NULL, 0}, term = {NULL, 0}, c = {&w->series[i], w->series[i].v.hi != 0};
        if (last.count > 0) status = times(&last, &w->part[0], &next);
        algsurf_i_tripoly_free(&last);
        if (status == ALGSURF_OK) status = algsurf_i_tripoly_multiply(a, &c, &term);
        if (status == ALGSURF_OK && next.count > 0) status = algsurf_i_tripoly_add(&next, &term, &last);
        if (status == ALGSURF_OK && next.count == 0) last = term, term = (tripoly){NULL, 0};
        algsurf_i_tripoly_free(&next);
        algsurf_i_tripoly_free(&term);
    }
    if (status == ALGSURF_OK) *out = last;
    return status;
}

static algsurf_status by_way(const way *w, const tripoly *a, tripoly *out) {
    monomial scale = w->scale;
    tripoly by = {&scale, 1}, last, next;
    algsurf_i_sum sum = {.parts = 0};
    algsurf_status status = algsurf_i_tripoly_multiply(a, &by, &last);
    if (status != ALGSURF_OK) return status;
    if (w->series) {
        status = by_series(w, &last, out);
        algsurf_i_tripoly_free(&last);
        return status;
    }
    for (size_t i = 0; status == ALGSURF_OK && i < w->count * (size_t)w->power; i++) {
        status = times(&last, &w->part[i % w->count], &next);
        if (status != ALGSURF_OK) break;
        if (w->is_sum) {
            status = algsurf_i_sum_add(&sum, next);
        } else {
            algsurf_i_tripoly_free(&last);
            last = next;
        }
    }
    if (w->is_sum || status != ALGSURF_OK) algsurf_i_tripoly_free(&last);
    if (w->is_sum) return algsurf_i_sum_finish(&sum, status, out);
    if (status == ALGSURF_OK) *out = last;
    return status;
}

/* Takes *by, a value of one term, into the way of the product, which is that of *of. */
static void take_scale(value *product, value *of, const monomial *by) {
    product->way = of->way;
    of->way = NULL;
    if (product->way) algsurf_i_monomial_multiply(&product->way->scale, by);
}

/* Takes both factors into the way of the product. */
static algsurf_status take_factors(value *product, value *left, value *right) {
    if (left->way && !left->way->is_sum && !left->way->series && left->way->power == 1) {
        product->way = left->way;
        left->way = NULL;
    } else {
        algsurf_status status = remember(&product->way, 0, left, 1);
        if (status != ALGSURF_OK) return status;
    }
    return remember(&product->way, 0, right, 1);
}

algsurf_status algsurf_i_value_multiply(value *left, value *right) {
    const tripoly *a = &left->p, *b = &right->p;
    size_t most = algsurf_i_tripoly_most_terms(algsurf_i_tripoly_degree(a) + algsurf_i_tripoly_degree(b));
    int direct = !right->way || a->count * b->count <= weight_of(right) * most;
    value product = {{NULL, 0}, NULL};
    algsurf_status status =
        direct ? algsurf_i_tripoly_multiply(a, b, &product.p) : by_way(right->way, a, &product.p);
    if (status == ALGSURF_OK && b->count == 1) {
        take_scale(&product, left, b->m);
    } else if (status == ALGSURF_OK && a->count == 1) {
        take_scale(&product, right, a->m);
    } else if (status == ALGSURF_OK && product.p.count > FEW_TERMS) {
        status = take_factors(&product, left, right);
    }
    weigh(&product);
    algsurf_i_value_free(left);
    algsurf_i_value_free(right);
    *left = product;
    return status;
}

algsurf_status algsurf_i_value_divide(value *v, const monomial *b) {
    monomial scale = one;
    tripoly inverse = {&scale, 1};
    algsurf_status status = algsurf_i_tripoly_divide(&v->p, b);
    if (status == ALGSURF_OK && v->way) status = algsurf_i_tripoly_divide(&inverse, b);
    if (status == ALGSURF_OK && v->way) algsurf_i_monomial_multiply(&v->way->scale, &scale);
    return status;
}

algsurf_status algsurf_i_value_raise(value *v, int n) {
    value power = {{NULL, 0}, NULL};
    monomial factor = one;
    tripoly unit = {&factor, 1};
    algsurf_status status = ALGSURF_OK;
    if (n == 1) return ALGSURF_OK;
    if (!v->way || n == 0) status = algsurf_i_tripoly_raise(&v->p, n, &power.p);
    if (status == ALGSURF_OK && n > 0) status = remember(&power.way, 0, v, n);
    if (status == ALGSURF_OK && !power.p.m) status = by_way(power.way, &unit, &power.p);
    weigh(&power);
    algsurf_i_value_free(v);
    *v = power;
    return status;
}

algsurf_status algsurf_i_value_compose(value *v, const monomial *c, int n) {
    value composed = {{NULL, 0}, NULL};
    monomial factor = one;
    tripoly unit = {&factor, 1};
    size_t bytes = ((size_t)n + 1) * sizeof *c;
    algsurf_status status = remember(&composed.way, 0, v, n);
    if (status == ALGSURF_OK && !(composed.way->series = malloc(bytes))) status = ALGSURF_E_NO_MEMORY;
    if (status == ALGSURF_OK) {
        memcpy(composed.way->series, c, bytes);
        composed.way->weight += (size_t)n + 1;
        status = by_way(composed.way, &unit, &composed.p);
    }
    weigh(&composed);
    *v = composed;
    return status;
}

algsurf_status algsurf_i_value_sum_add(value_sum *sum, value *v) {
    tripoly p = v->p;
    v->p = (tripoly){NULL, 0};
    if (!v->way) return algsurf_i_sum_add(&sum->plain, p);
    algsurf_status status = remember(&sum->way, 1, v, 1);
    if (status == ALGSURF_OK) return algsurf_i_sum_add(&sum->way->made, p);
    algsurf_i_tripoly_free(&p);
    return status;
}

algsurf_status algsurf_i_value_sum_finish(value_sum *sum, algsurf_status status, value *out) {
    value plain = {{NULL, 0}, NULL}, total = {{NULL, 0}, sum->way};
    tripoly made = {NULL, 0};
    status = algsurf_i_sum_finish(&sum->plain, status, &plain.p);
    if (total.way) status = algsurf_i_sum_finish(&total.way->made, status, &made);
    if (status == ALGSURF_OK) status = algsurf_i_tripoly_add(&plain.p, &made, &total.p);
    if (status == ALGSURF_OK && total.way) status = remember(&total.way, 1, &plain, 1);
    weigh(&total);
    algsurf_i_value_free(&plain);
    algsurf_i_tripoly_free(&made);
    sum->way = NULL;
    *out = total;
    return status;
}
