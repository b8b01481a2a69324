/* parse.c - from an expression as text to a polynomial: recursive descent that computes.
 *
 *     sum      = product { ("+" | "-") product }
 *     product  = signed { "*" signed | "/" signed | power }        the last: implicit multiplication
 *     signed   = { "+" | "-" } power
 *     power    = primary [ "^" signed | superscript { superscript } | "<sup>" sum "</sup>" ]
 *     primary  = number | name | bracket | ("sqrt" | "sin" | "cos") bracket | root-sign primary
 *              | ("sin" | "cos") primary                         behind that, no factor and no * / ^
 *              | "\sqrt" argument | "\frac" argument argument
 *              | ("T" | "U" | "P") "_" index bracket
 *     argument = bracket | digit                                   a bracket ( or {
 *     bracket  = "(" sum ")" | "[" sum "]" | "{" sum "}"
 *
 * The signs are those of read.h.  Every expression's value is a polynomial (poly.h); what
 * must be constant, divisors, exponents, arguments of roots, is seen from its value.  Depth is counted, so
 * text cannot exhaust the stack.  A name is as long as it can be; one that is no constant is a product of
 * what it consists of, letter by letter: variables, constants, pi.  A number never stands right of an
 * implicit multiplication: x 2 could be a slip for x^2 as well as a product.
 */
#include "../base/arithmetic.h"
#include "parse.h"

#include <math.h>

int algsurf_i_parse_peek(parser *p) {
    p->at += algsurf_i_blanks(p->text + p->at);
    p->token = algsurf_i_token_at(p->text + p->at);
    return p->token.kind;
}

static int peek(parser *p) { return algsurf_i_parse_peek(p); }
static void take(parser *p) { algsurf_i_parse_take(p); }

static int parse_signed(parser *p);
static int parse_primary(parser *p);

int algsurf_i_parse_nested(parser *p, size_t offset, int (*part)(parser *)) {
    if (++p->depth > ALGSURF_I_DEPTH_LIMIT)
        return algsurf_i_parse_refuse(p, offset, "nested deeper than 100");
    int ok = part(p);
    p->depth--;
    return ok;
}

static const char *expected_closing(char closing) {
    return closing == ')'   ? "expected an operator or ')'"
           : closing == ']' ? "expected an operator or ']'"
                            : "expected an operator or '}'";
}

int algsurf_i_parse_inside(parser *p) {
    char closing = algsurf_i_closing(p->token.kind);
    take(p);
    if (!algsurf_i_parse_sum(p)) return 0;
    if (peek(p) != closing) return algsurf_i_parse_refuse_here(p, expected_closing(closing));
    take(p);
    return 1;
}

static int parse_bracket(parser *p) {
    if (!algsurf_i_closing(peek(p))) return algsurf_i_parse_refuse(p, p->at, "expected '('");
    return algsurf_i_parse_nested(p, p->at, algsurf_i_parse_inside);
}

/* The root of the operand that stands here. */
static int parse_root_of(parser *p, int (*operand)(parser *)) {
    (void)peek(p);
    size_t offset = p->at;
    return operand(p) && algsurf_i_parse_root(p, offset);
}

static int parse_root_sign(parser *p) {
    take(p);
    return parse_root_of(p, parse_primary);
}

/* What a command of LaTeX applies to: a bracket, or a digit, since \frac12 is 1/2. */
static int parse_argument(parser *p) {
    int c = peek(p);
    if (c == '{' || c == '(') return parse_bracket(p);
    if (c < '0' || c > '9')
        return algsurf_i_parse_refuse_here(p, "expected '{' or a digit behind the command");
    take(p);
    return algsurf_i_parse_double(p, c - '0', 0);
}

static int parse_latex_sqrt(parser *p) {
    take(p);
    if (peek(p) == '[') return algsurf_i_parse_refuse(p, p->at, "of roots, only square roots are known");
    return parse_root_of(p, parse_argument);
}

static int parse_fraction(parser *p) {
    size_t offset = p->at;
    take(p);
    if (!parse_argument(p)) return 0;
    (void)peek(p);
    size_t divisor = p->at;
    return parse_argument(p) && algsurf_i_parse_divide(p, offset, divisor);
}

/* Does a product with a variable stand here, as in sin x or sin ax?  p->token is seen. */
static int variable_follows(parser *p) {
    algsurf_i_names *names = &p->names;
    const algsurf_constant *constant;
    if (p->token.kind != ALGSURF_I_TOKEN_LETTER) return 0;
    if (algsurf_i_names_read(names, p->text + p->at) != ALGSURF_OK || algsurf_i_names_whole(names)) return 0;
    for (size_t i = 0, factor; i < names->count; i += factor) {
        factor = algsurf_i_names_factor(names, i, &constant);
        if (factor == 0) return 0;
        if (!constant && algsurf_i_variable(names->letter[i].code)) return 1;
    }
    return 0;
}

/* Does a factor begin with this token, other than a number? */
static int begins_factor(int c) {
    return (c >= ALGSURF_I_TOKEN_ROOT && c <= ALGSURF_I_TOKEN_COSINE) || algsurf_i_closing(c);
}

static int begins_operand(const parser *p, int c) {
    return algsurf_i_number_follows(p->text + p->at) || begins_factor(c) || c == ALGSURF_I_TOKEN_QUARTERS;
}

/* Does the product go on behind a factor?  c: the token there. */
static int product_goes_on(const parser *p, int c) {
    return begins_operand(p, c) || c == '*' || c == '/' || c == '^' || c == ALGSURF_I_TOKEN_SUPERSCRIPT ||
           c == ALGSURF_I_TOKEN_RAISED;
}

/* What a sine without brackets is of, as in \cos\frac{2\pi}{5} or sin a.  Readers differ about what belongs
 * to it when the product goes on: sin pi/5, \sin\frac{\pi}{5}x.  Hence only one thing alone is taken. */
static int parse_bare_argument(parser *p) {
    static const char BRACKETS[] = "what sin or cos is of needs brackets here: sin(pi/5)";
    size_t offset = p->at;
    int c = p->token.kind;
    if (c == '^' || c == ALGSURF_I_TOKEN_SUPERSCRIPT)
        return algsurf_i_parse_refuse(p, offset, "an exponent behind sin or cos: write sin(a)^2");
    if (!begins_operand(p, c)) return algsurf_i_parse_refuse_here(p, BRACKETS);
    if (!algsurf_i_parse_nested(p, offset, parse_primary)) return 0;
    return !product_goes_on(p, peek(p)) || algsurf_i_parse_refuse(p, offset, BRACKETS);
}

/* sin (quarters 0) or cos (1), of `length` bytes, and what stands behind it. */
static int parse_sine(parser *p, size_t length, int quarters) {
    size_t offset = p->at;
    p->at += length;
    int bracket = algsurf_i_closing(peek(p)) != '\0';
    if (variable_follows(p)) return algsurf_i_parse_refuse(p, offset, ALGSURF_I_NOT_POLYNOMIAL);
    return (bracket ? parse_bracket(p) : parse_bare_argument(p)) && algsurf_i_parse_sine(p, offset, quarters);
}

static int make_pi(parser *p) { return algsurf_i_parse_monomial(p, algsurf_i_monomial_pi(), p->at); }

/* The value of a name, at place, that is read. */
static int parse_constant(parser *p, const algsurf_constant *constant, size_t place) {
    if (isnan(constant->value)) return algsurf_i_parse_defined(p, (const void *)constant, place);
    return algsurf_i_parse_double(p, constant->value, 0);
}

/* The next factor of the product that a name is. */
static int parse_letters(parser *p) {
    const algsurf_constant *constant;
    const algsurf_i_name_letter *letter = p->names.letter + p->letter;
    size_t letters = algsurf_i_names_factor(&p->names, p->letter, &constant), place = p->at;
    p->letter += letters;
    p->at += letter[letters].at - letter->at;
    if (constant) return parse_constant(p, constant, place);
    char variable = algsurf_i_variable(letter->code);
    if (!variable) return make_pi(p);
    return algsurf_i_parse_double(p, 1, algsurf_i_key_of(variable - 'x'));
}

static int parse_name(parser *p) {
    if (p->at < p->letters_end) return parse_letters(p);
    const char *name = p->text + p->at;
    algsurf_i_names *names = &p->names;
    const algsurf_constant *constant;
    if (!algsurf_i_parse_computed(p, algsurf_i_names_read(names, name), p->at)) return 0;
    size_t length = names->letter[names->count].at;
    constant = algsurf_i_names_whole(names);
    if (constant) {
        p->at += length;
        return parse_constant(p, constant, p->at - length);
    }
    int function = algsurf_i_listed("sin cos sqrt Sin Cos Sqrt", name, length);
    if (function % 3) return parse_sine(p, length, function % 3 - 1);
    if (function) return p->at += length, parse_root_of(p, parse_bracket);
    algsurf_i_series_head head;
    if (algsurf_i_series_follows(name, &head)) return algsurf_i_parse_series(p, &head);
    for (size_t i = 0, letters; i < names->count; i += letters) {
        if (algsurf_i_series_follows(name + names->letter[i].at, &head)) {
            length = names->letter[i].at;
            break;
        }
        letters = algsurf_i_names_factor(names, i, &constant);
        if (letters == 0) return algsurf_i_refuse_name(p, length, names->letter[i].at);
    }
    p->letter = 0;
    p->letters_end = p->at + length;
    return parse_letters(p);
}

static int parse_primary(parser *p) {
    int c = peek(p);
    if (algsurf_i_number_follows(p->text + p->at)) return algsurf_i_parse_number(p);
    if (algsurf_i_closing(c)) return parse_bracket(p);
    switch (c) {
    case ALGSURF_I_TOKEN_LETTER:
        return parse_name(p);
    case ALGSURF_I_TOKEN_ROOT:
        return algsurf_i_parse_nested(p, p->at, parse_root_sign);
    case ALGSURF_I_TOKEN_SQRT:
        return parse_latex_sqrt(p);
    case ALGSURF_I_TOKEN_FRACTION:
        return algsurf_i_parse_nested(p, p->at, parse_fraction);
    case ALGSURF_I_TOKEN_SINE:
    case ALGSURF_I_TOKEN_COSINE:
        return parse_sine(p, p->token.width, c == ALGSURF_I_TOKEN_COSINE);
    case ALGSURF_I_TOKEN_PI:
        take(p);
        return make_pi(p);
    case ALGSURF_I_TOKEN_QUARTERS:
        take(p);
        return algsurf_i_parse_double(p, 0.25 * p->token.digit, 0);
    default:
        return algsurf_i_parse_refuse_here(p, "expected a number, x, y, z, a constant, sqrt or '('");
    }
}

/* The exponent behind '^', and the base raised to it. */
static int parse_exponent(parser *p) {
    size_t offset = p->at;
    take(p);
    (void)peek(p);
    size_t exponent_offset = p->at;
    return algsurf_i_parse_nested(p, offset, parse_signed) &&
           algsurf_i_parse_power(p, offset, exponent_offset);
}

/* Superscripts in a row, and the base raised to them. */
static int parse_superscripts(parser *p) {
    size_t offset = p->at;
    int n = 0;
    do {
        if (n <= ALGSURF_MAX_DEGREE) n = 10 * n + p->token.digit;
        take(p);
        p->token = algsurf_i_token_at(p->text + p->at);
    } while (p->token.kind == ALGSURF_I_TOKEN_SUPERSCRIPT);
    return algsurf_i_parse_raise(p, offset, offset, n);
}

/* An exponent of HTML, and the base raised to it. */
static int parse_raised(parser *p) {
    size_t offset = p->at;
    take(p);
    (void)peek(p);
    size_t exponent_offset = p->at;
    if (!algsurf_i_parse_nested(p, offset, algsurf_i_parse_sum)) return 0;
    if (peek(p) != ALGSURF_I_TOKEN_LOWERED)
        return algsurf_i_parse_refuse_here(p, "expected an operator or </sup>");
    take(p);
    return algsurf_i_parse_power(p, offset, exponent_offset);
}

static int parse_power(parser *p) {
    if (!parse_primary(p)) return 0;
    int c = peek(p);
    if (c == '^') return parse_exponent(p);
    if (c == ALGSURF_I_TOKEN_RAISED) return parse_raised(p);
    return c == ALGSURF_I_TOKEN_SUPERSCRIPT ? parse_superscripts(p) : 1;
}

static int parse_signed(parser *p) {
    int negative = 0;
    for (int c = peek(p); c == '+' || c == '-'; take(p), c = peek(p)) negative ^= c == '-';
    if (!parse_power(p)) return 0;
    if (negative) algsurf_i_value_negate(algsurf_i_parse_top(p));
    return 1;
}

static int parse_product(parser *p) {
    int ok = parse_signed(p);
    while (ok) {
        int c = peek(p), written = c == '*' || c == '/';
        size_t offset = p->at;
        if (!written && !begins_factor(c)) return 1;
        if (written) take(p), (void)peek(p);
        size_t operand = p->at;
        ok = (written ? parse_signed(p) : parse_power(p)) &&
             (c == '/' ? algsurf_i_parse_divide(p, offset, operand) : algsurf_i_parse_multiply(p, offset));
    }
    return 0;
}

int algsurf_i_parse_sum(parser *p) {
    value_sum sum = {.way = NULL};
    algsurf_status status = ALGSURF_OK;
    for (int sign = '+'; parse_product(p); take(p)) {
        value *product = algsurf_i_parse_top(p);
        if (sign == '-') algsurf_i_value_negate(product);
        status = algsurf_i_value_sum_add(&sum, product);
        sign = peek(p);
        if (status != ALGSURF_OK || (sign != '+' && sign != '-'))
            return algsurf_i_parse_computed(p, algsurf_i_value_sum_finish(&sum, status, product), p->at);
        p->values--;
    }
    value none;
    (void)algsurf_i_value_sum_finish(&sum, ALGSURF_E_SYNTAX, &none);
    algsurf_i_value_free(&none);
    return 0;
}
