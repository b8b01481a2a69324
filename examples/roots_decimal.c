/* roots_decimal.c - see roots_decimal.h.  Schoolbook arithmetic: numbers in lines are short. */
#include "roots_decimal.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

/* ---- reading ---- */

static int value_of(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return 16;
}

/* The digits of d, and how many places they are before their unit: returns the text behind them, or null. */
static const char *read_digits(const char *text, roots_decimal *d, long long *places) {
    long long after_point = 0, trailing = 0; /* places behind the point; zeros since the last other digit */
    int seen = 0, point = 0;
    for (;; text++) {
        int digit = value_of(*text);
        if (digit >= d->radix && (*text != '.' || point++)) break;
        if (*text == '.') continue;
        seen = 1;
        after_point += point;
        trailing = digit ? 0 : trailing + 1;
        if (digit && !d->count) d->digits = text;
        if (d->count || digit) d->count++;
    }
    if (d->count) d->count -= (int)trailing;
    *places = trailing - after_point;
    return seen ? text : NULL;
}

/* An exponent, if there is one; returns the text behind it, or null if it is too large. */
static const char *read_exponent(const char *text, char letter, long long *exponent) {
    const char *at = text + 1;
    *exponent = 0;
    if (*text != letter && *text != letter - 'a' + 'A') return text;
    int negative = *at == '-';
    if (*at == '-' || *at == '+') at++;
    if (value_of(*at) >= 10) return text;
    for (; value_of(*at) < 10; at++) {
        *exponent = 10 * *exponent + value_of(*at);
        if (*exponent > 1000000000000) return NULL;
    }
    if (negative) *exponent = -*exponent;
    return at;
}

const char *roots_decimal_read(const char *text, roots_decimal *d) {
    long long places, exponent;
    *d = (roots_decimal){.radix = 10, .negative = *text == '-'};
    if (*text == '-' || *text == '+') text++;
    if (text[0] == '0' && (text[1] == 'x' || text[1] == 'X')) d->radix = 16, text += 2;
    if (!(text = read_digits(text, d, &places))) return NULL;
    if (!(text = read_exponent(text, d->radix == 10 ? 'e' : 'p', &exponent))) return NULL;
    d->fives = d->radix == 10 ? places + exponent : 0;
    d->twos = d->radix == 10 ? places + exponent : 4 * places + exponent;
    return text;
}

/* ---- integers ---- */

/* 10 < 2^(10/3), 5 < 2^(7/3). */
long long roots_decimal_bits(const roots_decimal *d, long long f, long long g) {
    long long digits = d->radix == 10 ? 10LL * d->count / 3 + 1 : 4LL * d->count;
    return d->count ? digits + 7 * (d->fives - f) / 3 + 1 + d->twos - g : 0;
}

/* a = a factor + add, in halves of limbs; returns the length. */
static int multiply(uint64_t *a, int length, uint32_t factor, uint32_t add) {
    uint64_t carry = add;
    for (int i = 0; i < length; i++) {
        uint64_t low = (a[i] & UINT32_MAX) * factor + carry, high = (a[i] >> 32) * factor + (low >> 32);
        a[i] = high << 32 | (low & UINT32_MAX);
        carry = high >> 32;
    }
    if (carry) a[length++] = carry;
    return length;
}

static int shift_up(uint64_t *a, int length, long long bits) {
    int limbs = (int)(bits / 64), rest = (int)(bits % 64);
    a[length] = 0;
    for (int i = length; i >= 0; i--) {
        uint64_t below = i > 0 && rest ? a[i - 1] >> (64 - rest) : 0;
        a[i + limbs] = a[i] << rest | below;
    }
    for (int i = 0; i < limbs; i++) a[i] = 0;
    length += limbs;
    return a[length] ? length + 1 : length;
}

int roots_decimal_limbs(const roots_decimal *d, long long f, long long g, uint64_t *limbs) {
    int length = 0, left = d->count;
    if (left == 0) return 0;
    uint32_t power = 1, chunk = 0;
    for (const char *at = d->digits; left > 0; at++) {
        if (*at == '.') continue;
        power *= (uint32_t)d->radix;
        chunk = chunk * (uint32_t)d->radix + (uint32_t)value_of(*at);
        left--;
        if (power < 1u << 28 && left > 0) continue; /* 16 power is less than 2^32 */
        length = multiply(limbs, length, power, chunk);
        power = 1, chunk = 0;
    }
    for (long long fives = d->fives - f; fives > 0; fives -= 13) {
        uint32_t factor = 1;
        for (int i = 0; i < 13 && i < fives; i++) factor *= 5; /* 5^13 < 2^32 */
        length = multiply(limbs, length, factor, 0);
    }
    return shift_up(limbs, length, d->twos - g);
}

/* ---- doubles ---- */

int roots_limbs_bits(const uint64_t *limbs, int length) {
    uint64_t top = limbs[length - 1], high = top >> 32;
    int e;
    (void)frexp((double)(high ? high : top), &e);
    return 64 * (length - 1) + (high ? 32 : 0) + e;
}

/* floor(a / 2^from) modulo 2^64, from >= 0. */
static uint64_t window(const uint64_t *a, int length, int from) {
    int i = from / 64, rest = from % 64;
    uint64_t low = i < length ? a[i] : 0, high = i + 1 < length ? a[i + 1] : 0;
    return rest ? low >> rest | high << (64 - rest) : low;
}

/* Is a divisible by 2^bits, bits >= 0? */
static int divisible(const uint64_t *a, int length, int bits) {
    for (int i = 0; i < length && i <= bits / 64; i++)
        if (i < bits / 64 ? a[i] : a[i] & (((uint64_t)1 << bits % 64) - 1)) return 0;
    return 1;
}

/* The last bit kept is that of a double: of 53, and not below 2^-1074. */
double roots_limbs_double(const uint64_t *limbs, int length, int down, int *off) {
    int drop = length ? roots_limbs_bits(limbs, length) - DBL_MANT_DIG : 0;
    if (drop < down - 1074) drop = down - 1074;
    if (drop <= 0) return ldexp(length ? (double)limbs[0] : 0, -down);
    if (divisible(limbs, length, drop)) return ldexp((double)window(limbs, length, drop), drop - down);
    *off = 1;
    return ldexp((double)((window(limbs, length, drop - 1) + 1) / 2), drop - down);
}
