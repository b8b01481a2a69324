/* interval_poly_template.h - the range of a polynomial over an interval of any kind: see interval_poly.c. The
 * includer defines RANGE, the type, OP(name), its operations, and ENCLOSE, the name of the function made. */

static algsurf_status ENCLOSE(const RANGE *c, int degree, RANGE x, int centred, RANGE *result) {
    if (!c || !result || degree < 0 || degree > ALGSURF_MAX_POLY_DEGREE || !OP(valid)(x))
        return ALGSURF_E_ARGUMENT;
    for (int i = 0; i <= degree; i++)
        if (!OP(valid)(c[i])) return ALGSURF_E_ARGUMENT;
    RANGE m = OP(point)(OP(mid)(x)), y = c[degree], at_m = y, slope = {0};
    for (int i = degree - 1; i >= 0; i--) {
        y = OP(add)(OP(mul)(y, x), c[i]);
        if (!centred) continue;
        slope = OP(add)(OP(mul)(slope, x), at_m);
        at_m = OP(add)(OP(mul)(at_m, m), c[i]);
    }
    *result = centred ? OP(meet)(y, OP(add)(at_m, OP(mul)(slope, OP(sub)(x, m)))) : y;
    return ALGSURF_OK;
}
