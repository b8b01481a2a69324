/* exact_decimal.h - a number as it is written, exactly: the oracle of what reads lines. */
#ifndef EXACT_DECIMAL_H
#define EXACT_DECIMAL_H
#include <ctype.h>
#include <string.h>

#include "exact.h"

/* The number, decimal or hexadecimal, that a text begins with; returns 0 (q = 0) where its exponent is beyond
 * 20000. */
static inline int exact_decimal(mpq_t q, const char *text) {
    int negative = *text == '-', point = 0;
    text += *text == '-' || *text == '+';
    int hex = text[0] == '0' && (text[1] | 32) == 'x';
    if (hex) text += 2;
    char *digits = malloc(strlen(text) + 1), *end = digits;
    double exponent = 0; /* whatever its length */
    for (; *text == '.' || (hex ? isxdigit((unsigned char)*text) : isdigit((unsigned char)*text)); text++) {
        if (*text == '.') {
            point = 1;
        } else {
            *end++ = *text;
            exponent -= point * (hex ? 4 : 1);
        }
    }
    *end = '\0';
    if ((*text | 32) == (hex ? 'p' : 'e')) exponent += strtod(text + 1, NULL);
    mpq_set_ui(q, 0, 1);
    int fits = fabs(exponent) <= 20000;
    if (fits && mpz_set_str(mpq_numref(q), digits, hex ? 16 : 10) == 0) {
        mpz_t power;
        mpz_init(power);
        mpz_ui_pow_ui(power, hex ? 2 : 10, (unsigned long)fabs(exponent));
        if (exponent < 0)
            mpz_set(mpq_denref(q), power);
        else
            mpz_mul(mpq_numref(q), mpq_numref(q), power);
        mpz_clear(power);
        if (negative) mpq_neg(q, q);
        mpq_canonicalize(q);
    }
    free(digits);
    return fits;
}

/* The same of a number, or a quotient of two, which must not divide by 0. */
static inline int exact_fraction(mpq_t q, const char *text) {
    const char *slash = strpbrk(text, "/,");
    int fits = exact_decimal(q, text);
    if (slash && *slash == '/') {
        mpq_t under;
        mpq_init(under);
        fits = exact_decimal(under, slash + 1) && fits;
        if (fits) mpq_div(q, q, under);
        mpq_clear(under);
    }
    return fits;
}

/* Is x the double nearest to q, of two the even one? */
static inline int exact_is_nearest(double x, const mpq_t q) {
    mpq_t middle, other;
    int nearest = 1;
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    mpq_inits(middle, other, NULL);
    for (int side = -1; side <= 1; side += 2) {
        double next = nextafter(x, side < 0 ? -HUGE_VAL : HUGE_VAL);
        if (isinf(next)) continue;
        exact_set(middle, x);
        exact_set(other, next);
        mpq_add(middle, middle, other);
        mpq_div_2exp(middle, middle, 1);
        int beyond = mpq_cmp(q, middle) * side;
        if (beyond > 0 || (beyond == 0 && bits & 1)) nearest = 0;
    }
    mpq_clears(middle, other, NULL);
    return nearest;
}

#endif
