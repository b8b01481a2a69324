/* povray.c - polynomials as POV-Ray has them; see parse.h.
 *
 * Source: POV-Ray 3.7 Reference, 2.4.3, Infinite Solid Primitives: poly, cubic, quartic, quadric.  The
 * coefficients of poly come by falling powers of x, then of y, then of z.
 */
#include "../base/arithmetic.h"
#include "parse.h"

static const char SOLIDS[] = "poly quadric cubic quartic";
enum { POLY = 1, QUADRIC, CUBIC, QUARTIC };

/* Takes what stands between coefficients. */
static void take_separators(parser *p) {
    while (algsurf_i_parse_peek(p) == ',' || p->text[p->at] == '<' || p->text[p->at] == '>')
        algsurf_i_parse_take(p);
}

/* The order of a poly. */
static int read_order(parser *p, int *order) {
    size_t at = (algsurf_i_parse_peek(p), p->at);
    *order = 0;
    for (; p->text[p->at] >= '0' && p->text[p->at] <= '9' && *order <= ALGSURF_MAX_DEGREE; p->at++)
        *order = 10 * *order + (p->text[p->at] - '0');
    if (*order >= 1 && *order <= ALGSURF_MAX_DEGREE) return 1;
    return algsurf_i_parse_refuse(p, at, "expected the order of poly, from 1 to 64");
}

/* One value for the sum of a coefficient, which is a constant, times a monomial. */
static int read_coefficient(parser *p, int key) {
    size_t at = (algsurf_i_parse_peek(p), p->at);
    if (algsurf_i_parse_peek(p) == '}')
        return algsurf_i_parse_refuse(p, at, "too few coefficients: order n has (n+1)(n+2)(n+3)/6");
    if (!algsurf_i_parse_sum(p)) return 0;
    tripoly *c = &algsurf_i_parse_top(p)->p;
    if (!algsurf_i_tripoly_is_constant(c)) return algsurf_i_parse_refuse(p, at, "expected a constant");
    if (c->count) c->m[0].key = key;
    take_separators(p);
    return 1;
}

/* The exponents behind these in a poly, as a key. */
static int key_behind(int key, int order) {
    int i = algsurf_i_exponent(key, 0), j = algsurf_i_exponent(key, 1), k = algsurf_i_exponent(key, 2);
    if (k > 0) return key - algsurf_i_key_of(2);
    if (j > 0) return key - algsurf_i_key_of(1) + (order - i - j + 1) * algsurf_i_key_of(2);
    return key - 1 + (order - i + 1) * algsurf_i_key_of(1);
}

/* The sum of the coefficients times their monomials: of a quadric, else of all up to the order. */
static int read_coefficients(parser *p, int quadric, int order) {
    enum { X = 1, Y = X << 7, Z = Y << 7 };
    static const int keys[] = {2 * X, 2 * Y, 2 * Z, X + Y, X + Z, Y + Z, X, Y, Z, 0};
    value_sum sum = {.way = NULL};
    value total;
    algsurf_status status = ALGSURF_OK;
    int key = quadric ? keys[0] : order, n = 0, ok;
    take_separators(p);
    for (ok = read_coefficient(p, key); ok; ok = read_coefficient(p, key)) {
        p->values--;
        status = algsurf_i_value_sum_add(&sum, &p->value[p->values]);
        if (status != ALGSURF_OK || key == 0) break;
        key = quadric ? keys[++n] : key_behind(key, order);
    }
    status = algsurf_i_value_sum_finish(&sum, status, &total);
    if (!ok) return algsurf_i_value_free(&total), 0;
    p->value[p->values++] = total;
    return algsurf_i_parse_computed(p, status, p->at);
}

int algsurf_i_parse_povray(parser *p, int *is_one) {
    (void)algsurf_i_parse_peek(p);
    const char *name = p->text + p->at;
    size_t length = algsurf_i_name_length(name), width = length + algsurf_i_blanks(name + length);
    int kind = algsurf_i_listed(SOLIDS, name, length), order = kind == QUARTIC ? 4 : 3;
    *is_one = kind && name[width] == '{';
    if (!*is_one) return 1;
    p->at += width + 1;
    if (kind == POLY && !read_order(p, &order)) return 0;
    if (!read_coefficients(p, kind == QUADRIC, order)) return 0;
    length = algsurf_i_name_length(p->text + p->at);
    if (algsurf_i_listed("sturm", p->text + p->at, length)) p->at += length;
    if (algsurf_i_parse_peek(p) != '}')
        return algsurf_i_parse_refuse(p, p->at, "expected '}': too many coefficients, or something else");
    algsurf_i_parse_take(p);
    return 1;
}
