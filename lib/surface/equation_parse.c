/* equation_parse.c - from an equation as text to a polynomial: recursive descent that computes.
 *
 *     equation = sum [ "=" sum ]
 *     sum      = product { ("+" | "-") product }
 *     product  = signed { "*" signed | "/" signed | power }        the last: implicit multiplication
 *     signed   = { "+" | "-" } power
 *     power    = primary [ "^" signed ]
 *     primary  = number | name | "(" sum ")" | "sqrt" "(" sum ")"
 *
 * Every expression's value is a polynomial (equation_poly.h); what must be constant, divisors,
 * exponents, arguments of sqrt, is seen from its value.  Depth is counted, so text cannot exhaust
 * the stack.  A name is as long as it can be; one that is no constant but made of x, y, z only is a
 * product of variables, xyz.  A number never stands right of an implicit multiplication: x 2 could
 * be a slip for x^2 as well as a product.
 */
#include "../base/arithmetic.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "equation_number.h"
#include "equation_parse.h"

enum { DEPTH_LIMIT = 200, EXPONENT_LIMIT = 64 };

typedef algsurf_i_parser parser;

static int fail(parser *p, algsurf_status status, size_t offset, const char *message) {
    p->status = status;
    p->error = (algsurf_parse_error){offset, message};
    return 0;
}

static int refuse(parser *p, size_t offset, const char *message) {
    return fail(p, ALGSURF_E_SYNTAX, offset, message);
}

/* Turns the outcome of arithmetic at an offset into 1 or 0. */
static int computed(parser *p, algsurf_status status, size_t offset) {
    if (status == ALGSURF_OK) return 1;
    return fail(p, status, offset,
                status == ALGSURF_E_RANGE ? "a constant leaves the range of numbers" : NULL);
}

static int is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
static int is_digit(char c) { return c >= '0' && c <= '9'; }
static int is_name_part(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

size_t algsurf_i_name_length(const char *text) {
    size_t n = 0;
    if (is_letter(text[0])) {
        while (is_name_part(text[n])) n++;
    }
    return n;
}

/* The next character that is not blank; p->at is its place. */
static char peek(parser *p) {
    while (p->text[p->at] == ' ' || (p->text[p->at] >= '\t' && p->text[p->at] <= '\r')) p->at++;
    return p->text[p->at];
}

static int number_follows(const parser *p) {
    const char *c = p->text + p->at;
    return is_digit(c[0]) || (c[0] == '.' && is_digit(c[1]));
}

static int parse_sum(parser *p, algsurf_i_tripoly *out);
static int parse_signed(parser *p, algsurf_i_tripoly *out);

static int enter(parser *p, size_t offset) {
    return ++p->depth <= DEPTH_LIMIT || refuse(p, offset, "nested deeper than 200");
}

static int make_value(parser *p, algsurf_dd v, double err, int exponent, int key, algsurf_i_tripoly *out) {
    return computed(p, algsurf_i_tripoly_make(algsurf_i_monomial_make(v, err, exponent, key), out), p->at);
}

static int parse_number(parser *p, algsurf_i_tripoly *out) {
    size_t length, at = p->at;
    algsurf_i_number n;
    algsurf_i_reading reading = algsurf_i_read_number(p->text + at, &length, &n);
    if (reading == ALGSURF_I_NUMBER) {
        /* Exact when it fits a double, the rule for numbers people type. */
        double err = n.v.lo == 0 ? 0.0 : ALGSURF_DD_U * n.v.hi;
        algsurf_i_monomial m = algsurf_i_monomial_make(n.v, err, n.exponent, 0);
        if (isfinite(algsurf_i_monomial_round(&m))) {
            p->at += length;
            return computed(p, algsurf_i_tripoly_make(m, out), at);
        }
    }
    return fail(p, ALGSURF_E_RANGE, at, "the number is too large for a double");
}

static int parse_parenthesis(parser *p, algsurf_i_tripoly *out) {
    if (peek(p) != '(') return refuse(p, p->at, "expected '('");
    if (!enter(p, p->at)) return 0;
    p->at++;
    if (!parse_sum(p, out)) return 0;
    if (peek(p) != ')') {
        algsurf_i_tripoly_free(out);
        return refuse(p, p->at, "expected an operator or ')'");
    }
    p->at++;
    p->depth--;
    return 1;
}

static int parse_sqrt(parser *p, algsurf_i_tripoly *out) {
    algsurf_i_tripoly argument;
    p->at += strlen("sqrt");
    (void)peek(p);
    size_t offset = p->at;
    if (!parse_parenthesis(p, &argument)) return 0;
    int constant = algsurf_i_tripoly_is_constant(&argument);
    algsurf_i_monomial m = {{0.0, 0.0}, 0.0, 0, 0};
    if (constant && argument.count) m = argument.m[0];
    algsurf_i_tripoly_free(&argument);
    if (!constant) return refuse(p, offset, "expected a constant as the argument of sqrt");
    if (m.v.hi < 0) return refuse(p, offset, "the argument of sqrt is negative");
    return computed(p, algsurf_i_tripoly_make(algsurf_i_monomial_sqrt(m), out), offset);
}

static const algsurf_constant *find_constant(const parser *p, const char *name, size_t length) {
    size_t low = 0, high = p->constant_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        const char *candidate = p->constants[middle]->name;
        int order = strncmp(candidate, name, length);
        if (order == 0 && candidate[length] == '\0') return p->constants[middle];
        if (order < 0) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return NULL;
}

static int parse_name(parser *p, algsurf_i_tripoly *out) {
    const char *name = p->text + p->at;
    if (p->at >= p->letters_end) {
        size_t length = algsurf_i_name_length(name);
        const algsurf_constant *constant = find_constant(p, name, length);
        if (constant) {
            p->at += length;
            return make_value(p, algsurf_dd_from(constant->value), 0.0, 0, 0, out);
        }
        if (length == strlen("sqrt") && strncmp(name, "sqrt", length) == 0) return parse_sqrt(p, out);
        if (strspn(name, "xyz") < length) return refuse(p, p->at, "unknown name");
        p->letters_end = p->at + length;
    }
    p->at++;
    int key = *name == 'x' ? ALGSURF_I_KEY_X : *name == 'y' ? ALGSURF_I_KEY_Y : ALGSURF_I_KEY_Z;
    return make_value(p, algsurf_dd_from(1.0), 0.0, 0, key, out);
}

static int parse_primary(parser *p, algsurf_i_tripoly *out) {
    char c = peek(p);
    if (number_follows(p)) return parse_number(p, out);
    if (is_letter(c)) return parse_name(p, out);
    if (c == '(') return parse_parenthesis(p, out);
    return refuse(p, p->at, "expected a number, x, y, z, a constant, sqrt or '('");
}

/* *left *= right, which is freed. */
static int multiply(parser *p, size_t offset, algsurf_i_tripoly *left, algsurf_i_tripoly *right) {
    algsurf_i_tripoly product = {NULL, 0};
    int fits = algsurf_i_tripoly_degree(left) + algsurf_i_tripoly_degree(right) <= ALGSURF_MAX_DEGREE;
    int ok = fits ? computed(p, algsurf_i_tripoly_multiply(left, right, &product), offset)
                  : fail(p, ALGSURF_E_DEGREE, offset, "the degree of this product is above 64");
    algsurf_i_tripoly_free(left);
    algsurf_i_tripoly_free(right);
    *left = product;
    return ok;
}

/* *left /= right, which is freed; offsets are those of the operator and the divisor. */
static int divide(parser *p, size_t offset, size_t divisor, algsurf_i_tripoly *left,
                  algsurf_i_tripoly *right) {
    int ok;
    if (!algsurf_i_tripoly_is_constant(right)) {
        ok = refuse(p, divisor, "expected a constant divisor");
    } else if (right->count == 0) {
        ok = refuse(p, divisor, "division by zero");
    } else {
        ok = computed(p, algsurf_i_tripoly_divide(left, right->m), offset);
    }
    algsurf_i_tripoly_free(right);
    if (!ok) algsurf_i_tripoly_free(left);
    return ok;
}

/* Is the value, within its error bound, a whole number of magnitude up to 1000? */
static int whole_number(const algsurf_i_tripoly *value, int *n) {
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
    if (!make_value(p, algsurf_dd_from(1.0), 0.0, 0, 0, &power)) return 0;
    for (int i = 0; i < n; i++) {
        algsurf_i_tripoly next;
        int ok = computed(p, algsurf_i_tripoly_multiply(&power, base, &next), offset);
        algsurf_i_tripoly_free(&power);
        if (!ok) return 0;
        power = next;
    }
    *out = power;
    return 1;
}

/* base^n with all its conditions; offsets are those of the operator and the exponent. */
static int raise(parser *p, size_t offset, size_t exponent, const algsurf_i_tripoly *base, int n,
                 algsurf_i_tripoly *out) {
    int constant = algsurf_i_tripoly_is_constant(base);
    int degree = algsurf_i_tripoly_degree(base);
    if (n > 0 && degree * n > ALGSURF_MAX_DEGREE) {
        return fail(p, ALGSURF_E_DEGREE, offset, "the degree of this power is above 64");
    }
    if (abs(n) > EXPONENT_LIMIT) return refuse(p, exponent, "expected an exponent up to 64");
    if (n >= 0) return repeat(p, offset, base, n, out);
    if (!constant) return refuse(p, exponent, "expected an exponent that is not negative");
    algsurf_i_tripoly power;
    if (!repeat(p, offset, base, -n, &power)) return 0;
    if (!make_value(p, algsurf_dd_from(1.0), 0.0, 0, 0, out)) {
        algsurf_i_tripoly_free(&power);
        return 0;
    }
    return divide(p, offset, offset, out, &power);
}

static int parse_power(parser *p, algsurf_i_tripoly *out) {
    algsurf_i_tripoly base, exponent;
    if (!parse_primary(p, &base)) return 0;
    if (peek(p) != '^') {
        *out = base;
        return 1;
    }
    size_t offset = p->at++;
    (void)peek(p);
    size_t exponent_offset = p->at;
    int ok = enter(p, offset) && parse_signed(p, &exponent);
    if (ok) {
        int n, whole = whole_number(&exponent, &n);
        algsurf_i_tripoly_free(&exponent);
        p->depth--;
        ok = whole ? raise(p, offset, exponent_offset, &base, n, out)
                   : refuse(p, exponent_offset, "expected a constant whole number from 0 to 64 as exponent");
    }
    algsurf_i_tripoly_free(&base);
    return ok;
}

static int parse_signed(parser *p, algsurf_i_tripoly *out) {
    int negative = 0;
    for (char c = peek(p); c == '+' || c == '-'; p->at++, c = peek(p)) negative ^= c == '-';
    if (!parse_power(p, out)) return 0;
    if (negative) algsurf_i_tripoly_negate(out);
    return 1;
}

/* The next operator and operand of a product; *more becomes 0 when there is none. */
static int extend_product(parser *p, algsurf_i_tripoly *left, int *more) {
    algsurf_i_tripoly right;
    char c = peek(p);
    size_t offset = p->at;
    *more = 1;
    if (c == '*' || c == '/') {
        p->at++;
        (void)peek(p);
        size_t operand = p->at;
        if (!parse_signed(p, &right)) {
            algsurf_i_tripoly_free(left);
            return 0;
        }
        return c == '*' ? multiply(p, offset, left, &right) : divide(p, offset, operand, left, &right);
    }
    if (is_letter(c) || c == '(') {
        if (parse_power(p, &right)) return multiply(p, offset, left, &right);
        algsurf_i_tripoly_free(left);
        return 0;
    }
    *more = 0;
    return 1;
}

static int parse_product(parser *p, algsurf_i_tripoly *out) {
    algsurf_i_tripoly product;
    if (!parse_signed(p, &product)) return 0;
    for (int more = 1; more;) {
        if (!extend_product(p, &product, &more)) return 0;
    }
    *out = product;
    return 1;
}

static int parse_sum(parser *p, algsurf_i_tripoly *out) {
    algsurf_i_sum sum = {.parts = 0};
    for (char sign = '+';;) {
        algsurf_i_tripoly product;
        if (!parse_product(p, &product)) break;
        if (sign == '-') algsurf_i_tripoly_negate(&product);
        if (!computed(p, algsurf_i_sum_add(&sum, product), p->at)) break;
        sign = peek(p);
        if (sign != '+' && sign != '-') return computed(p, algsurf_i_sum_total(&sum, out), p->at);
        p->at++;
    }
    algsurf_i_sum_free(&sum);
    return 0;
}

/* The end of the text, after a whole equation. */
static int parse_end(parser *p, int equals_seen) {
    switch (peek(p)) {
    case '\0':
        return 1;
    case ')':
        return refuse(p, p->at, "')' without '('");
    case '=':
        return refuse(p, p->at, "a second '='");
    default:
        return refuse(p, p->at,
                      equals_seen ? "expected an operator or the end"
                                  : "expected an operator, '=' or the end");
    }
}

int algsurf_i_parse_equation(parser *p, algsurf_i_tripoly *out) {
    algsurf_i_tripoly left, right;
    if (!parse_sum(p, &left)) return 0;
    int equals = peek(p) == '=';
    if (equals) {
        size_t offset = p->at++;
        algsurf_i_tripoly difference = {NULL, 0};
        int ok = parse_sum(p, &right);
        if (ok) {
            algsurf_i_tripoly_negate(&right);
            ok = computed(p, algsurf_i_tripoly_add(&left, &right, &difference), offset);
            algsurf_i_tripoly_free(&right);
        }
        algsurf_i_tripoly_free(&left);
        if (!ok) return 0;
        left = difference;
    }
    if (!parse_end(p, equals)) {
        algsurf_i_tripoly_free(&left);
        return 0;
    }
    *out = left;
    return 1;
}
