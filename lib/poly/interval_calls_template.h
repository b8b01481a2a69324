/* interval_calls_template.h - the public calls that intervals of both kinds have.
 *
 * The includer defines RANGE, the type; POINT, that of its numbers; CALL(name), its calls without a prefix;
 * OP(name), its operations.
 *
 * The range of a polynomial.  Horner's scheme overestimates by the first order of the width.  The centred
 * form p(x) = p(m) + q(x) (x - m),   q = the quotient of p - p(m) by x - m, has an excess of the second order
 * (Krawczyk, Neumaier 1985): the coefficients of q are the intermediate results of Horner's scheme at the
 * point m, highest first, so both run together.  That is an identity of polynomials, good for complex ones
 * too, where the mean value theorem is not.  q(x) is a slope, about half as wide as the enclosure of p'(x) it
 * replaces.
 */

static algsurf_status divide(RANGE a, RANGE b, RANGE *result) {
    if (!result || !OP(valid)(a) || !OP(valid)(b)) return ALGSURF_E_ARGUMENT;
    if (OP(has_zero)(b)) return ALGSURF_E_RANGE;
    *result = OP(div)(a, b);
    return ALGSURF_OK;
}

static algsurf_status intersect(RANGE a, RANGE b, RANGE *result) {
    if (!result || !OP(valid)(a) || !OP(valid)(b)) return ALGSURF_E_ARGUMENT;
    RANGE both = OP(meet)(a, b);
    if (!OP(valid)(both)) return ALGSURF_E_RANGE;
    *result = both;
    return ALGSURF_OK;
}

static algsurf_status enclose(const RANGE *c, int degree, RANGE x, RANGE *result) {
    if (!c || !result || !OP(valid)(x)) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_check_degree(degree);
    if (status != ALGSURF_OK) return status;
    for (int i = 0; i <= degree; i++)
        if (!OP(valid)(c[i])) return ALGSURF_E_ARGUMENT;
    RANGE m = OP(point)(OP(mid)(x)), y = c[degree], at_m = y, slope = {0};
    const int centred = OP(width)(x) > 0; /* else x is a number, and the centred form Horner's */
    for (int i = degree - 1; i >= 0; i--) {
        y = OP(add)(OP(mul)(y, x), c[i]);
        if (!centred) continue;
        slope = OP(add)(OP(mul)(slope, x), at_m);
        at_m = OP(add)(OP(mul)(at_m, m), c[i]);
    }
    *result = centred ? OP(meet)(y, OP(add)(at_m, OP(mul)(slope, OP(sub)(x, m)))) : y;
    return ALGSURF_OK;
}

/* The name is expanded before ALGSURF_I_ENTRY joins it to others. */
#define PUBLIC(type, name, work, parameters, arguments)                                                      \
    ALGSURF_I_ENTRY(type, name, parameters, arguments) { return work arguments; }
#define PUBLIC_1(type, name) PUBLIC(type, CALL(name), OP(name), (RANGE a), (a))
#define PUBLIC_2(type, name) PUBLIC(type, CALL(name), OP(name), (RANGE a, RANGE b), (a, b))

PUBLIC_2(RANGE, add)
PUBLIC_2(RANGE, sub)
PUBLIC_2(RANGE, mul)
PUBLIC(algsurf_status, CALL(div), divide, (RANGE a, RANGE b, RANGE *result), (a, b, result))
PUBLIC_1(algsurf_interval, abs)
PUBLIC_2(RANGE, hull)
PUBLIC(algsurf_status, CALL(intersect), intersect, (RANGE a, RANGE b, RANGE *result), (a, b, result))
PUBLIC_1(double, width)
PUBLIC_1(POINT, mid)
PUBLIC(int, CALL(contains), OP(contains), (RANGE a, POINT x), (a, x))
PUBLIC_2(int, interior)
PUBLIC(algsurf_status, CALL(poly), enclose, (const RANGE *c, int degree, RANGE x, RANGE *result),
       (c, degree, x, result))
