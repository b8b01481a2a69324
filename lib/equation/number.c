/* number.c - reading a number exactly, whatever the locale.
 *
 * Digits and powers of ten are integers.  A quotient of integers, of at least 106 bits, and whether anything
 * is left tell the 104 bits that are kept and one more, so that ties are seen as ties.  Digits after the
 * 800th only matter by being there: a double, or the midpoint of two, has at most 767 significant digits.
 */
#include "../base/arithmetic.h"
#include "poly.h"

#include "../base/integer.h"

enum {
    DIGITS = 800,        /* kept exactly */
    DECIMAL_LIMIT = 400, /* |decimal exponent| beyond this is out of range */
    BITS = 106,          /* of the quotient, at least */
    TOO_LARGE = 4096,    /* the binary exponent of any number out of range */
    LIMBS = (10 * (DECIMAL_LIMIT + DIGITS + 1) / 3 + BITS) / 64 + 3 /* 10 < 2^(10/3) */
};

static const long long saturated = 1000000000000; /* an exponent that no number of digits makes up for */

/* A magnitude. */
typedef struct whole {
    algsurf_limb limb[LIMBS];
    int length;
} whole;

static int digit_of(char c, int radix) {
    if (c >= '0' && c <= '9') return c - '0';
    if (radix == 16 && c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (radix == 16 && c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

/* Reads digits and a point; returns the characters read, 0 if there is no digit.  *a becomes the integer of
 * the *count digits behind leading zeros, where one digit stands for all that are left out; what is read is
 * 0.a times radix^point. */
static size_t read_digits(const char *text, int radix, whole *a, int *count, long long *point) {
    size_t at = 0;
    int point_seen = 0, digit_seen = 0;
    for (;; at++) {
        if (text[at] == '.' && !point_seen) {
            point_seen = 1;
            continue;
        }
        int d = digit_of(text[at], radix);
        if (d < 0) break;
        digit_seen = 1;
        int leading_zero = *count == 0 && d == 0;
        if (leading_zero && point_seen) --*point;
        if (!leading_zero && !point_seen) ++*point;
        if (leading_zero || *count > DIGITS || (*count == DIGITS && d == 0)) continue;
        algsurf_limb digit = *count < DIGITS ? (algsurf_limb)d : 1;
        a->length = algsurf_z_extend(a->limb, a->length, (algsurf_limb)radix, digit);
        ++*count;
    }
    return digit_seen ? at : 0;
}

/* Reads an exponent that begins with the letter, if there is one; returns the characters read. */
static size_t read_exponent(const char *text, char letter, long long *exponent) {
    *exponent = 0;
    if (text[0] != letter && text[0] != letter - 'a' + 'A') return 0;
    size_t at = text[1] == '+' || text[1] == '-' ? 2 : 1;
    if (digit_of(text[at], 10) < 0) return 0;
    for (; digit_of(text[at], 10) >= 0; at++) {
        if (*exponent < saturated) *exponent = 10 * *exponent + digit_of(text[at], 10);
    }
    if (text[1] == '-') *exponent = -*exponent;
    return at;
}

/* a *= 10^power; nothing for power < 0. */
static void scale(whole *a, long long power) {
    while (power > 0) {
        algsurf_limb factor = 1;
        for (; power > 0 && factor <= UINT64_MAX / 16; power--) factor *= 10;
        a->length = algsurf_z_extend(a->limb, a->length, factor, 0);
    }
}

/* above/below 2^exponent. */
static monomial quotient(whole *above, const whole *below, long long exponent) {
    algsurf_limb q[LIMBS + 1] = {0}, room[LIMBS + 1];
    int nv = below->length, bits = algsurf_z_bits(below->limb, nv + 1);
    int up = bits + BITS - algsurf_z_bits(above->limb, above->length + 1);
    if (up < 0) up = 0;
    int nu = above->length + up / 64 + 1;
    algsurf_z_shift_up(above->limb, nu, up);
    algsurf_z_divide(q, above->limb, nu, below->limb, nv, room);
    int from = algsurf_z_bits(q, LIMBS) - 104;
    const algsurf_limb mask = ((algsurf_limb)1 << 52) - 1;
    double high = (double)(algsurf_z_window(q, LIMBS, from + 52) & mask);
    double low = (double)(algsurf_z_window(q, LIMBS, from) & mask);
    int more = algsurf_z_length(above->limb, nv) > 0 || algsurf_z_trailing(q, LIMBS) < from;
    algsurf_dd v = algsurf_fast_two_sum(high, (low + (more ? 0.5 : 0.0)) * 0x1p-52);
    return algsurf_i_monomial_make(v, v.lo == 0 ? 0.0 : ALGSURF_DD_U * v.hi, (int)exponent - up + from + 52,
                                   0);
}

static size_t read(const char *text, int radix, monomial *m) {
    whole above = {{0}, 0}, below = {{1}, 1};
    int count = 0;
    long long exponent, point = 0;
    size_t prefix = radix == 16 ? 2 : 0, at = read_digits(text + prefix, radix, &above, &count, &point);
    if (at == 0) return 0;
    at += prefix;
    at += read_exponent(text + at, radix == 16 ? 'p' : 'e', &exponent);
    long long size = exponent + (radix == 16 ? 4 : 1) * point; /* the number is less than 2^ or 10^ that */
    int zero = count == 0 || size < (radix == 16 ? -4000 : -DECIMAL_LIMIT);
    if (zero || size > (radix == 16 ? 2000 : DECIMAL_LIMIT)) {
        *m = algsurf_i_monomial_make(algsurf_dd_from(!zero), 0, zero ? 0 : TOO_LARGE, 0);
        return at;
    }
    if (radix == 10) {
        scale(&above, size - count);
        scale(&below, count - size);
    }
    *m = quotient(&above, &below, radix == 16 ? size - 4LL * count : 0);
    return at;
}

size_t algsurf_i_read_number(const char *text, monomial *m) {
    size_t hexadecimal = text[0] == '0' && (text[1] == 'x' || text[1] == 'X') ? read(text, 16, m) : 0;
    return hexadecimal ? hexadecimal : read(text, 10, m);
}
