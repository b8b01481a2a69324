/* number.c - reading a number exactly, whatever the locale.
 *
 * A decimal fraction is kept in limbs of nine digits and multiplied or divided by powers of two
 * until it lies in [1/2, 1); multiplying on then shifts its bits out at the front, as in schoolbook
 * change of base.  Division by 2^9 is exact in this base, because 2^9 divides 10^9.  Nothing is
 * rounded: 104 bits come out, and one more that tells whether anything is left, so that ties are
 * seen as ties.  Digits after the 800th only matter by being there: a double, or the midpoint of
 * two, has at most 767 significant digits.
 */
#include "../base/arithmetic.h"
#include "number.h"

#include <stdint.h>

enum {
    DIGITS = 800,        /* kept exactly */
    DECIMAL_LIMIT = 400, /* |decimal exponent| beyond this is out of range */
    HEAD = 48,           /* limbs that multiplication may add in front: DECIMAL_LIMIT / 9 + 1 */
    TAIL = 160,          /* limbs that division may add behind: log2(10^DECIMAL_LIMIT) / 9 + 1 */
    LIMBS = HEAD + (DIGITS + 17) / 9 + TAIL,
    HEX_CHUNK = 13 /* hexadecimal digits in 52 bits */
};

static const uint32_t base = 1000000000;
static const long long saturated = 1000000000000; /* an exponent that no number of digits makes up for */

/* base^point times the fraction 0.limb[begin] limb[begin+1] ... limb[end-1]. */
typedef struct fraction {
    uint32_t limb[LIMBS];
    int begin, end, point;
} fraction;

/* f 2^bits, 1 <= bits <= 29, without what moves before the point: that is returned. */
static uint32_t shift_left(fraction *f, int bits) {
    uint64_t carry = 0;
    for (int i = f->end - 1; i >= f->begin; i--) {
        carry += (uint64_t)f->limb[i] << bits;
        f->limb[i] = (uint32_t)(carry % base);
        carry /= base;
    }
    while (f->end > f->begin && f->limb[f->end - 1] == 0) f->end--;
    return (uint32_t)carry;
}

/* f 2^-9; leading zeros are dropped. */
static void shift_right_9(fraction *f) {
    uint64_t rest = 0;
    for (int i = f->begin; i < f->end; i++) {
        uint64_t t = rest * base + f->limb[i];
        f->limb[i] = (uint32_t)(t >> 9);
        rest = t & 511;
    }
    if (rest) f->limb[f->end++] = (uint32_t)(rest * base >> 9);
    while (f->limb[f->begin] == 0) f->begin++, f->point--;
}

/* Brings f > 0 into [1/2, 1); returns e, f was 2^e times that. */
static int normalise(fraction *f) {
    int e = 0;
    for (; f->point > 0; e += 9) shift_right_9(f);
    for (; f->point < 0; e -= 29) {
        uint32_t carry = shift_left(f, 29);
        if (carry) f->limb[--f->begin] = carry, f->point++;
    }
    for (; f->limb[f->begin] < base / 2; e--) (void)shift_left(f, 1);
    return e;
}

/* Two chunks of 52 bits, and whether anything follows, as a double-double. */
static algsurf_dd join(uint64_t high, uint64_t low, int more) {
    return algsurf_fast_two_sum((double)high, ((double)low + (more ? 0.5 : 0.0)) * 0x1p-52);
}

static algsurf_i_number from_fraction(fraction *f) {
    int e = normalise(f);
    uint64_t chunk[2];
    for (int c = 0; c < 2; c++) {
        chunk[c] = (uint64_t)shift_left(f, 26) << 26;
        chunk[c] |= shift_left(f, 26);
    }
    return (algsurf_i_number){join(chunk[0], chunk[1], f->end > f->begin), e - 52};
}

/* Digits as read, without leading zeros: 0.d1 d2 d3 ... times radix^point. */
typedef struct digit_string {
    unsigned char digit[DIGITS + 1]; /* the last one for "more" */
    int count;
    int more; /* a digit that is not zero was left out */
    long long point;
} digit_string;

static int digit_of(char c, int radix) {
    if (c >= '0' && c <= '9') return c - '0';
    if (radix == 16 && c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (radix == 16 && c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

/* Reads digits and a point; returns the characters read, 0 if there is no digit. */
static size_t read_digits(const char *text, int radix, int keep, digit_string *s) {
    size_t at = 0;
    int point_seen = 0, digit_seen = 0;
    s->count = s->more = 0;
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
        if (s->count < keep) {
            s->digit[s->count++] = (unsigned char)d;
        } else {
            s->more |= d != 0;
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

static algsurf_i_reading read_hexadecimal(const char *text, size_t *length, algsurf_i_number *number) {
    digit_string s;
    long long exponent;
    size_t at = read_digits(text + 2, 16, 2 * HEX_CHUNK, &s);
    if (at == 0) return ALGSURF_I_NO_NUMBER;
    at += 2;
    at += read_exponent(text + at, 'p', &exponent);
    *length = at;
    *number = (algsurf_i_number){{0.0, 0.0}, 0};
    exponent += 4 * s.point;
    if (s.count == 0 || exponent < -4000) return ALGSURF_I_NUMBER;
    if (exponent > 2000) return ALGSURF_I_NUMBER_TOO_LARGE;
    uint64_t chunk[2] = {0, 0};
    for (int i = 0; i < 2 * HEX_CHUNK; i++) {
        uint64_t *c = &chunk[i / HEX_CHUNK];
        *c = 16 * *c + (i < s.count ? s.digit[i] : 0u);
    }
    *number = (algsurf_i_number){join(chunk[0], chunk[1], s.more), (int)exponent - 4 * HEX_CHUNK};
    return ALGSURF_I_NUMBER;
}

static algsurf_i_reading read_decimal(const char *text, size_t *length, algsurf_i_number *number) {
    digit_string s;
    long long exponent;
    size_t at = read_digits(text, 10, DIGITS, &s);
    if (at == 0) return ALGSURF_I_NO_NUMBER;
    at += read_exponent(text + at, 'e', &exponent);
    *length = at;
    *number = (algsurf_i_number){{0.0, 0.0}, 0};
    exponent += s.point;
    if (s.count == 0 || exponent < -DECIMAL_LIMIT) return ALGSURF_I_NUMBER;
    if (exponent > DECIMAL_LIMIT) return ALGSURF_I_NUMBER_TOO_LARGE;
    if (s.more) s.digit[s.count++] = 1;
    /* Limbs begin at multiples of nine digits from the point; C rounds quotients towards 0. */
    fraction f = {.begin = HEAD, .point = (int)(exponent > 0 ? (exponent + 8) / 9 : exponent / 9)};
    int pad = 9 * f.point - (int)exponent, size = pad + s.count;
    f.end = HEAD + (size + 8) / 9;
    for (int i = 0; i < 9 * (f.end - HEAD); i++) {
        uint32_t *limb = &f.limb[HEAD + i / 9];
        *limb = 10 * *limb + (i >= pad && i < size ? s.digit[i - pad] : 0u);
    }
    *number = from_fraction(&f);
    return ALGSURF_I_NUMBER;
}

algsurf_i_reading algsurf_i_read_number(const char *text, size_t *length, algsurf_i_number *number) {
    if (text[0] == '0' && (text[1] == 'x' || text[1] == 'X')) {
        algsurf_i_reading hexadecimal = read_hexadecimal(text, length, number);
        if (hexadecimal != ALGSURF_I_NO_NUMBER) return hexadecimal;
    }
    return read_decimal(text, length, number);
}
