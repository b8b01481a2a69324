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

int algsurf_i_parse_constant(parser *p, algsurf_i_monomial m, size_t offset, algsurf_i_value *out) {
    *out = (algsurf_i_value){{NULL, 0}, NULL};
    return algsurf_i_parse_computed(p, algsurf_i_tripoly_make(m, &out->p), offset);
}

int algsurf_i_parse_value(parser *p, algsurf_dd v, double err, int exponent, int key, algsurf_i_value *out) {
    return algsurf_i_parse_constant(p, algsurf_i_monomial_make(v, err, exponent, key), p->at, out);
}

int algsurf_i_parse_multiply(parser *p, size_t offset, algsurf_i_value *left, algsurf_i_value *right) {
    if (algsurf_i_tripoly_degree(&left->p) + algsurf_i_tripoly_degree(&right->p) <= ALGSURF_MAX_DEGREE)
        return algsurf_i_parse_computed(p, algsurf_i_value_multiply(left, right), offset);
    algsurf_i_value_free(left);
    algsurf_i_value_free(right);
    return algsurf_i_parse_fail(p, ALGSURF_E_DEGREE, offset, "the degree of this product is above 64");
}

int algsurf_i_parse_divide(parser *p, size_t offset, size_t divisor, algsurf_i_value *left,
                           algsurf_i_value *right) {
    int ok;
    if (!algsurf_i_tripoly_is_constant(&right->p)) {
        ok = algsurf_i_parse_refuse(p, divisor,
                                    "not a polynomial: division by x, y or z; multiply both sides by it");
    } else if (right->p.count == 0) {
        ok = algsurf_i_parse_refuse(p, divisor, "division by zero");
    } else {
        ok = algsurf_i_parse_computed(p, algsurf_i_value_divide(left, right->p.m), offset);
    }
    algsurf_i_value_free(right);
    if (!ok) algsurf_i_value_free(left);
    return ok;
}

int algsurf_i_parse_whole(const algsurf_i_value *value, int *n) {
    *n = 0;
    if (value->p.count == 0) return 1;
    if (!algsurf_i_tripoly_is_constant(&value->p) || value->p.m[0].e < -1) return 0;
    double nearest = rint(algsurf_i_monomial_round(value->p.m));
    if (!(fabs(nearest) <= 1000)) return 0;
    algsurf_i_monomial m = value->p.m[0];
    double shift = ldexp(1.0, 256 * m.e);
    double rest = fabs(algsurf_dd_add_d(algsurf_dd_scale(m.v, shift), -nearest).hi);
    *n = (int)nearest;
    return rest <= m.err * shift;
}

int algsurf_i_parse_raise(parser *p, size_t offset, size_t exponent, algsurf_i_value *base, int n) {
    algsurf_i_value one;
    int constant = algsurf_i_tripoly_is_constant(&base->p), ok = 0;
    if (n > 0 && algsurf_i_tripoly_degree(&base->p) * n > ALGSURF_MAX_DEGREE) {
        (void)algsurf_i_parse_fail(p, ALGSURF_E_DEGREE, offset, "the degree of this power is above 64");
    } else if (abs(n) > ALGSURF_I_EXPONENT_LIMIT) {
        (void)algsurf_i_parse_refuse(p, exponent, "expected an exponent up to 64");
    } else if (n < 0 && !constant) {
        (void)algsurf_i_parse_refuse(p, exponent, "not a polynomial: x, y or z to a negative power");
    } else {
        ok = algsurf_i_parse_computed(p, algsurf_i_value_raise(base, abs(n)), offset);
    }
    if (ok && n >= 0) return 1;
    if (ok && algsurf_i_parse_value(p, algsurf_dd_from(1.0), 0.0, 0, 0, &one)) {
        ok = algsurf_i_parse_divide(p, offset, offset, &one, base);
        *base = one;
        return ok;
    }
    algsurf_i_value_free(base);
    return 0;
}
