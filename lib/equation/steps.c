/* steps.c - the operators of an equation; see parse.h. */
#include "../base/arithmetic.h"
#include <math.h>
#include <stdlib.h>

#include "parse.h"

enum { EXPONENT_LIMIT = 64 };

int algsurf_i_parse_computed(parser *p, algsurf_status status, size_t offset) {
    if (status == ALGSURF_OK) return 1;
    return algsurf_i_parse_fail(p, status, offset,
                                status == ALGSURF_E_RANGE ? "a constant leaves the range of numbers" : NULL);
}

int algsurf_i_parse_monomial(parser *p, monomial m, size_t offset) {
    value v = {{NULL, 0}, NULL};
    algsurf_status status = algsurf_i_tripoly_make(m, &v.p);
    p->value[p->values++] = v;
    return algsurf_i_parse_computed(p, status, offset);
}

int algsurf_i_parse_double(parser *p, double v, int key) {
    return algsurf_i_parse_monomial(p, algsurf_i_monomial_make(algsurf_dd_from(v), 0, 0, key), p->at);
}

int algsurf_i_parse_number(parser *p) {
    size_t at = p->at;
    monomial m;
    p->at += algsurf_i_read_number(p->text + at, &m);
    if (isfinite(algsurf_i_monomial_round(&m))) return algsurf_i_parse_monomial(p, m, at);
    return algsurf_i_parse_fail(p, ALGSURF_E_RANGE, at, "the number is too large for a double");
}

int algsurf_i_parse_subtract(parser *p, size_t offset) {
    value_sum difference = {.way = NULL};
    value *right = algsurf_i_parse_top(p), *left = right - 1;
    algsurf_i_value_negate(right);
    algsurf_status status = algsurf_i_value_sum_add(&difference, left);
    if (status == ALGSURF_OK) status = algsurf_i_value_sum_add(&difference, right);
    if (status == ALGSURF_OK) p->values--;
    return algsurf_i_parse_computed(p, algsurf_i_value_sum_finish(&difference, status, left), offset);
}

int algsurf_i_parse_multiply(parser *p, size_t offset) {
    value *right = algsurf_i_parse_top(p), *left = right - 1;
    if (algsurf_i_tripoly_degree(&left->p) + algsurf_i_tripoly_degree(&right->p) > ALGSURF_MAX_DEGREE)
        return algsurf_i_parse_fail(p, ALGSURF_E_DEGREE, offset, "the degree of this product is above 64");
    p->values--;
    return algsurf_i_parse_computed(p, algsurf_i_value_multiply(left, right), offset);
}

/* Is the last value a constant?  *m becomes it, and it leaves the stack. */
static int take_constant(parser *p, monomial *m) {
    value *v = algsurf_i_parse_top(p);
    int constant = algsurf_i_tripoly_is_constant(&v->p);
    *m = constant && v->p.count ? v->p.m[0] : (monomial){{0.0, 0.0}, 0.0, 0, 0};
    algsurf_i_value_free(v);
    p->values--;
    return constant;
}

int algsurf_i_parse_divide(parser *p, size_t offset, size_t divisor) {
    monomial m;
    int constant = take_constant(p, &m);
    if (constant && m.v.hi != 0)
        return algsurf_i_parse_computed(p, algsurf_i_value_divide(algsurf_i_parse_top(p), &m), offset);
    return algsurf_i_parse_refuse(
        p, divisor,
        constant ? "division by zero" : "not a polynomial: division by x, y or z; multiply both sides by it");
}

/* Is m, within its error bound, a whole number of magnitude up to 1000? */
static int is_whole(const monomial *m, int *n) {
    *n = 0;
    if (m->v.hi == 0) return 1;
    if (m->e < -1) return 0;
    double nearest = rint(algsurf_i_monomial_round(m));
    if (!(fabs(nearest) <= 1000)) return 0;
    double shift = ldexp(1.0, 256 * m->e);
    double rest = fabs(algsurf_dd_add_d(algsurf_dd_scale(m->v, shift), -nearest).hi);
    *n = (int)nearest;
    return rest <= m->err * shift;
}

int algsurf_i_parse_raise(parser *p, size_t offset, size_t place, int n) {
    value *base = algsurf_i_parse_top(p);
    if (n > 0 && algsurf_i_tripoly_degree(&base->p) * n > ALGSURF_MAX_DEGREE)
        return algsurf_i_parse_fail(p, ALGSURF_E_DEGREE, offset, "the degree of this power is above 64");
    if (abs(n) > EXPONENT_LIMIT) return algsurf_i_parse_refuse(p, place, "expected an exponent up to 64");
    if (n < 0 && !algsurf_i_tripoly_is_constant(&base->p))
        return algsurf_i_parse_refuse(p, place, "not a polynomial: x, y or z to a negative power");
    if (!algsurf_i_parse_computed(p, algsurf_i_value_raise(base, abs(n)), offset)) return 0;
    if (n >= 0) return 1;
    if (!algsurf_i_parse_double(p, 1, 0)) return 0;
    value one = base[1];
    base[1] = base[0], base[0] = one;
    return algsurf_i_parse_divide(p, offset, offset);
}

int algsurf_i_parse_power(parser *p, size_t offset, size_t place) {
    monomial m;
    int n, constant = take_constant(p, &m);
    if (constant && is_whole(&m, &n)) return algsurf_i_parse_raise(p, offset, place, n);
    int roots = algsurf_i_tripoly_is_constant(&algsurf_i_parse_top(p)->p);
    return algsurf_i_parse_refuse(
        p, place,
        !constant ? "not a polynomial: x, y or z in an exponent"
        : roots   ? "expected a whole number as exponent; a root of a constant is written sqrt(...)"
                  : "not a polynomial: expected a whole number from 0 to 64 as exponent");
}

int algsurf_i_parse_root(parser *p, size_t offset) {
    monomial m;
    if (!take_constant(p, &m))
        return algsurf_i_parse_refuse(p, offset, "not a polynomial: a root of x, y or z; square both sides");
    if (m.v.hi < 0) return algsurf_i_parse_refuse(p, offset, "the root of a negative number");
    return algsurf_i_parse_monomial(p, algsurf_i_monomial_sqrt(m), offset);
}

int algsurf_i_parse_sine(parser *p, size_t offset, int quarters) {
    monomial m;
    if (!take_constant(p, &m)) return algsurf_i_parse_refuse(p, offset, ALGSURF_I_NOT_POLYNOMIAL);
    if (m.e > 0 || (m.e == 0 && fabs(m.v.hi) > ALGSURF_I_SINE_LIMIT))
        return algsurf_i_parse_refuse(p, offset, "sin and cos take at most 100 radians");
    return algsurf_i_parse_monomial(p, algsurf_i_monomial_sine(&m, quarters), offset);
}
