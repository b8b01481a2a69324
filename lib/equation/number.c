/* number.c - reading a number exactly, whatever the locale.
 *
 * Digits and powers of ten are integers.  A quotient of integers, of at least 106 bits, and whether anything
 * is left tell the 104 bits that are kept and one more, so that ties are seen as ties.  Digits after the
 * 800th only matter by being there: a double, or the midpoint of two, has at most 767 significant digits.
 */
#include "../base/arithmetic.h"
#include "read.h"

#include "../base/integer.h"

enum {
    DIGITS = 800,        /* kept exactly */
    DECIMAL_LIMIT = 400, /* |decimal exponent| beyond this is out of range */
    BITS = 106,          /* of the quotient, at least */
    LIMBS = (10 * (DECIMAL_LIMIT + DIGITS + 1) / 3 + BITS) / 64 + 3 /* 10 < 2^(10/3) */
};

static const long long saturated = 1000000000000; /* an exponent that no number of digits makes up for */

/* A magnitude. */
typedef struct whole {
    algsurf_limb limb[LIMBS];
    int length;
} whole;

/* Digits as read, without leading zeros: 0.d1 d2 d3 ... times radix^point. */
typedef struct digit_string {
    unsigned char digit[DIGITS + 1]; /* the last one stands for all digits that are left out */
    int count;
    long long point;
} digit_string;

static int digit_of(char c, int radix) {
    if (c >= '0' && c <= '9') return c - '0';
    if (radix == 16 && c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (radix == 16 && c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

/* Reads digits and a point; returns the characters read, 0 if there is no digit. */
static size_t read_digits(const char *text, int radix, digit_string *s) {
    size_t at = 0;
    int point_seen = 0, digit_seen = 0;
    s->count = 0;
    s->point = 0;
    for (;; at++) {
        if (text[at] == '.' && !point_seen) {
            point_seen = 1;
            continue;
        }
        int d = digit_of(text[at], radix);
        if (d < 0) break;
        digit_seen = 1;
        int leading_zero = s->count == 0 && d == 0;
        if (leading_zero && point_seen) s->point--;
        if (!leading_zero && !point_seen) s->point++;
        if (leading_zero) continue;
        if (s->count < DIGITS) {
            s->digit[s->count++] = (unsigned char)d;
        } else if (d) {
            s->digit[DIGITS] = 1, s->count = DIGITS + 1;
        }
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

/* a radix^power, plus the number that the next `power` digits are, if there are any. */
static void append(whole *a, int radix, long long power, const unsigned char *digit) {
    while (power > 0) {
        algsurf_limb factor = 1, plus = 0;
        for (; power > 0 && factor <= UINT64_MAX / 16 / 16; power--) {
            factor *= (algsurf_limb)radix;
            if (digit) plus = plus * (algsurf_limb)radix + *digit++;
        }
        a->length = algsurf_z_extend(a->limb, a->length, factor, plus);
    }
}

/* above/below 2^exponent. */
static algsurf_i_number quotient(whole *above, const whole *below, long long exponent) {
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
    return (algsurf_i_number){v, (int)exponent - up + from + 52};
}

static algsurf_i_reading read(const char *text, int radix, size_t *length, algsurf_i_number *number) {
    digit_string s;
    long long exponent;
    size_t prefix = radix == 16 ? 2 : 0, at = read_digits(text + prefix, radix, &s);
    if (at == 0) return ALGSURF_I_NO_NUMBER;
    at += prefix;
    *length = at + read_exponent(text + at, radix == 16 ? 'p' : 'e', &exponent);
    *number = (algsurf_i_number){{0.0, 0.0}, 0};
    long long size = exponent + (radix == 16 ? 4 : 1) * s.point; /* the number is less than 2^ or 10^ that */
    if (s.count == 0 || size < (radix == 16 ? -4000 : -DECIMAL_LIMIT)) return ALGSURF_I_NUMBER;
    if (size > (radix == 16 ? 2000 : DECIMAL_LIMIT)) return ALGSURF_I_NUMBER_TOO_LARGE;
    whole above = {{0}, 0}, below = {{1}, 1};
    append(&above, radix, s.count, s.digit);
    if (radix == 10) {
        append(&above, 10, size - s.count, NULL);
        append(&below, 10, s.count - size, NULL);
    }
    *number = quotient(&above, &below, radix == 16 ? size - 4LL * s.count : 0);
    return ALGSURF_I_NUMBER;
}

algsurf_i_reading algsurf_i_read_number(const char *text, size_t *length, algsurf_i_number *number) {
    if (text[0] == '0' && (text[1] == 'x' || text[1] == 'X')) {
        algsurf_i_reading hexadecimal = read(text, 16, length, number);
        if (hexadecimal != ALGSURF_I_NO_NUMBER) return hexadecimal;
    }
    return read(text, 10, length, number);
}
