/* roots_decimal.c - see roots_decimal.h. */
#include "roots_decimal.h"

#include <stddef.h>

#include "roots_limbs.h"

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
        length = roots_limbs_times(limbs, length, power, chunk);
        power = 1, chunk = 0;
    }
    for (long long fives = d->fives - f; fives > 0; fives -= 13) {
        uint32_t factor = 1;
        for (int i = 0; i < 13 && i < fives; i++) factor *= 5; /* 5^13 < 2^32 */
        length = roots_limbs_times(limbs, length, factor, 0);
    }
    return roots_limbs_shift_up(limbs, length, d->twos - g);
}
