/* steps.c - see steps.h. */
#include "../base/arithmetic.h"
#include "steps.h"

#include <math.h>
#include <stdlib.h>

typedef algsurf_i_parser parser;

int algsurf_i_parse_fail(parser *p, algsurf_status status, size_t offset, const char *message) {
    p->status = status;
    p->error = (algsurf_parse_error){offset, 0, message};
    return 0;
}

int algsurf_i_parse_refuse(parser *p, size_t offset, const char *message) {
    return algsurf_i_parse_fail(p, ALGSURF_E_SYNTAX, offset, message);
}

int algsurf_i_parse_computed(parser *p, algsurf_status status, size_t offset) {
    if (status == ALGSURF_OK) return 1;
    return algsurf_i_parse_fail(p, status, offset,
                                status == ALGSURF_E_RANGE ? "a constant leaves the range of numbers" : NULL);
}

int algsurf_i_parse_value(parser *p, algsurf_dd v, double err, int exponent, int key,
                          algsurf_i_tripoly *out) {
    return algsurf_i_parse_computed(
        p, algsurf_i_tripoly_make(algsurf_i_monomial_make(v, err, exponent, key), out), p->at);
}

int algsurf_i_parse_multiply(parser *p, size_t offset, algsurf_i_tripoly *left, algsurf_i_tripoly *right) {
    algsurf_i_tripoly product = {NULL, 0};
    int fits = algsurf_i_tripoly_degree(left) + algsurf_i_tripoly_degree(right) <= ALGSURF_MAX_DEGREE;
    int ok =
        fits ? algsurf_i_parse_computed(p, algsurf_i_tripoly_multiply(left, right, &product), offset)
             : algsurf_i_parse_fail(p, ALGSURF_E_DEGREE, offset, "the degree of this product is above 64");
    algsurf_i_tripoly_free(left);
    algsurf_i_tripoly_free(right);
    *left = product;
    return ok;
}

int algsurf_i_parse_divide(parser *p, size_t offset, size_t divisor, algsurf_i_tripoly *left,
                           algsurf_i_tripoly *right) {
    int ok;
    if (!algsurf_i_tripoly_is_constant(right)) {
        ok = algsurf_i_parse_refuse(p, divisor,
                                    "not a polynomial: division by x, y or z; multiply both sides by it");
    } else if (right->count == 0) {
        ok = algsurf_i_parse_refuse(p, divisor, "division by zero");
    } else {
        ok = algsurf_i_parse_computed(p, algsurf_i_tripoly_divide(left, right->m), offset);
    }
    algsurf_i_tripoly_free(right);
    if (!ok) algsurf_i_tripoly_free(left);
    return ok;
}

int algsurf_i_parse_whole(const algsurf_i_tripoly *value, int *n) {
    *n = 0;
    if (value->count == 0) return 1;
    if (!algsurf_i_tripoly_is_constant(value) || value->m[0].e < -1) return 0;
    double nearest = rint(algsurf_i_monomial_round(value->m));
    if (!(fabs(nearest) <= 1000)) return 0;
    algsurf_i_monomial m = value->m[0];
    double shift = ldexp(1.0, 256 * m.e);
    double rest = fabs(algsurf_dd_add_d(algsurf_dd_scale(m.v, shift), -nearest).hi);
    *n = (int)nearest;
    return rest <= m.err * shift;
}

/* base^n, n >= 0, by repeated multiplication: for polynomials cheaper than squaring. */
static int repeat(parser *p, size_t offset, const algsurf_i_tripoly *base, int n, algsurf_i_tripoly *out) {
    algsurf_i_tripoly power;
    if (!algsurf_i_parse_value(p, algsurf_dd_from(1.0), 0.0, 0, 0, &power)) return 0;
    for (int i = 0; i < n; i++) {
        algsurf_i_tripoly next;
        int ok = algsurf_i_parse_computed(p, algsurf_i_tripoly_multiply(&power, base, &next), offset);
        algsurf_i_tripoly_free(&power);
        if (!ok) return 0;
        power = next;
    }
    *out = power;
    return 1;
}

int algsurf_i_parse_raise(parser *p, size_t offset, size_t exponent, const algsurf_i_tripoly *base, int n,
                          algsurf_i_tripoly *out) {
    int constant = algsurf_i_tripoly_is_constant(base);
    int degree = algsurf_i_tripoly_degree(base);
    if (n > 0 && degree * n > ALGSURF_MAX_DEGREE) {
        return algsurf_i_parse_fail(p, ALGSURF_E_DEGREE, offset, "the degree of this power is above 64");
    }
    if (abs(n) > ALGSURF_I_EXPONENT_LIMIT)
        return algsurf_i_parse_refuse(p, exponent, "expected an exponent up to 64");
    if (n >= 0) return repeat(p, offset, base, n, out);
    if (!constant)
        return algsurf_i_parse_refuse(p, exponent, "not a polynomial: x, y or z to a negative power");
    algsurf_i_tripoly power;
    if (!repeat(p, offset, base, -n, &power)) return 0;
    if (!algsurf_i_parse_value(p, algsurf_dd_from(1.0), 0.0, 0, 0, out)) {
        algsurf_i_tripoly_free(&power);
        return 0;
    }
    return algsurf_i_parse_divide(p, offset, offset, out, &power);
}
