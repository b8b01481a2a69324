/* roots_digits.c - see roots_digits.h.
 *
 * z 2^e in units of 10^-places is z 5^places 2^(e + places): products or quotients by powers of five, and a
 * shift.  Each quotient is rounded down, and it is known whether anything is left: so all of it is. */
#include "roots_digits.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "roots_limbs.h"

/* A magnitude with its sign; rest: it is rounded down. */
typedef struct number {
    uint64_t *limb;
    int length, negative, rest;
} number;

int roots_digits_bits(int digits) { return (int)ceil(digits * 3.3219280948873626) + 8; }

/* ---- arithmetic ---- */

/* |z + add| for a small number, with room for `more` bits. */
static int take(algsurf_integer z, int add, long long more, number *a) {
    int length = abs(z.length);
    *a = (number){malloc(((size_t)length + (size_t)(more / 64) + 4) * sizeof *a->limb), length, z.length < 0,
                  0};
    if (!a->limb) return 0;
    if (length) memcpy(a->limb, z.limbs, (size_t)length * sizeof *a->limb);
    while (a->length > 0 && !a->limb[a->length - 1]) a->length--;
    const uint64_t by = (uint64_t)abs(add);
    if (by == 0) return 1;
    if (a->length == 0) a->negative = add < 0;
    if ((add < 0) == a->negative) {
        a->length = roots_limbs_times(a->limb, a->length, 1, (uint32_t)by);
    } else if (a->length == 1 && a->limb[0] < by) {
        a->limb[0] = by - a->limb[0];
        a->negative = !a->negative;
    } else {
        int i = 0, borrow = a->limb[0] < by;
        a->limb[0] -= by;
        while (borrow) borrow = a->limb[++i]-- == 0;
        while (a->length > 0 && !a->limb[a->length - 1]) a->length--;
    }
    return 1;
}

/* a / by; returns what is left. */
static uint32_t divide(number *a, uint32_t by) {
    uint64_t left = 0;
    for (int i = a->length - 1; i >= 0; i--) {
        uint64_t high = left << 32 | a->limb[i] >> 32, low = (high % by) << 32 | (a->limb[i] & UINT32_MAX);
        a->limb[i] = (high / by) << 32 | low / by;
        left = low % by;
    }
    while (a->length > 0 && !a->limb[a->length - 1]) a->length--;
    return (uint32_t)left;
}

static void shift_down(number *a, long long bits) {
    const int limbs = bits / 64 < a->length ? (int)(bits / 64) : a->length, rest = (int)(bits % 64);
    for (int i = 0; i < limbs; i++) a->rest |= a->limb[i] != 0;
    if (limbs < a->length && rest) a->rest |= (a->limb[limbs] << (64 - rest)) != 0;
    for (int i = limbs; i < a->length; i++) {
        uint64_t above = i + 1 < a->length && rest ? a->limb[i + 1] << (64 - rest) : 0;
        a->limb[i - limbs] = a->limb[i] >> rest | above;
    }
    a->length -= limbs;
    while (a->length > 0 && !a->limb[a->length - 1]) a->length--;
}

/* a 2^exponent in units of 10^-places, rounded down. */
static void scale(number *a, long long exponent, long long places) {
    const long long shift = exponent + places;
    enum { CHUNK = 13 }; /* 5^13 < 2^32 */
    if (shift > 0) a->length = a->length ? roots_limbs_shift_up(a->limb, a->length, shift) : 0;
    for (long long left = llabs(places); left > 0 && a->length > 0; left -= CHUNK) {
        uint32_t factor = 1;
        for (int i = 0; i < CHUNK && i < left; i++) factor *= 5;
        if (places > 0)
            a->length = roots_limbs_times(a->limb, a->length, factor, 0);
        else
            a->rest |= divide(a, factor) != 0;
    }
    if (shift < 0) shift_down(a, -shift);
}

/* ---- text ---- */

/* The digits of a; loses it. */
static char *digits_of(number *a) {
    const size_t room = (size_t)a->length * 20 + 10;
    char *text = malloc(room), *at = text + room;
    if (!text) return NULL;
    *--at = '\0';
    while (a->length > 0) {
        uint32_t nine = divide(a, 1000000000);
        for (int i = 0; i < 9; i++, nine /= 10) *--at = (char)('0' + nine % 10);
    }
    at += strspn(at, "0");
    memmove(text, at, strlen(at) + 1);
    return text;
}

/* digits 10^-places as people write it; exact: without zeros at the end. */
static char *written(const char *digits, int negative, long long places, int exact) {
    if (!*digits) digits = "0", places = 0;
    const long long length = (long long)strlen(digits), first = length - 1 - places;
    long long kept = length, padding = 0;
    while (exact && kept > 1 && digits[kept - 1] == '0') kept--;
    const int plain = places >= 0 && first > -6;
    if (plain && kept < first + 1) padding = first + 1 - kept;
    char *text = malloc((size_t)(length + padding) + 40), *at = text;
    if (!text) return NULL;
    if (negative) *at++ = '-';
    if (!plain) {
        *at++ = digits[0];
        if (kept > 1) at += sprintf(at, ".%.*s", (int)kept - 1, digits + 1);
        sprintf(at, "e%+lld", first);
        return text;
    }
    if (first < 0) {
        at += sprintf(at, "0.");
        for (long long i = -1; i > first; i--) *at++ = '0';
    }
    for (long long i = 0; i < kept + padding; i++) {
        if (first >= 0 && i == first + 1) *at++ = '.';
        *at++ = i < kept ? digits[i] : '0';
    }
    *at = '\0';
    return text;
}

/* (z + add) 2^exponent as a multiple of 10^-places: the nearest one, or the next one below (-1), above (1).
 */
static char *decimal(algsurf_integer z, int add, int exponent, long long places, int direction, int exact) {
    long long more = llabs(places) * 7 / 3 + llabs(exponent + places) + 64;
    number a;
    if (!take(z, add, more, &a)) return NULL;
    scale(&a, exponent + (direction == 0), places); /* twice that, to take the half of it */
    const int up = direction == 0 ? a.length > 0 && a.limb[0] % 2 : a.rest && (direction > 0) != a.negative;
    if (up) a.length = roots_limbs_times(a.limb, a.length, 1, 1), a.rest = 1;
    if (direction == 0) shift_down(&a, 1);
    exact = exact && !a.rest;
    char *digits = digits_of(&a), *text = digits ? written(digits, a.negative, places, exact) : NULL;
    free(a.limb);
    free(digits);
    return text;
}

static double log10_of(algsurf_integer z, int exponent) {
    int off = 0, length = abs(z.length), down;
    while (length > 0 && !z.limbs[length - 1]) length--;
    if (length == 0) return -HUGE_VAL;
    down = roots_limbs_bits(z.limbs, length);
    return log10(roots_limbs_double(z.limbs, length, down, &off)) +
           (down + (double)exponent) * 0.3010299956639812;
}

/* The exponent of the first digit of a number that is not 0: what its logarithm says, or one less. */
static long long first_place(algsurf_integer z, int exponent) {
    const long long place = (long long)floor(log10_of(z, exponent) + 0x1p-20);
    const algsurf_integer size = {z.limbs, abs(z.length)};
    char *units = decimal(size, 0, exponent, -place, -1, 0);
    const int none = units && strcmp(units, "0") == 0;
    free(units);
    return place - none;
}

static int write_part(algsurf_integer z, const algsurf_precise_root *r, long long places, roots_decimals *d) {
    const int radius = z.length == 0 && r->real ? 0 : r->radius;
    d->value = decimal(z, 0, r->exponent, places, 0, radius == 0);
    d->lo = decimal(z, -radius, r->exponent, places, -1, radius == 0);
    d->hi = decimal(z, radius, r->exponent, places, 1, radius == 0);
    return d->value && d->lo && d->hi;
}

int roots_digits(const algsurf_precise_root *root, int digits, roots_decimals *re, roots_decimals *im) {
    double x = log10_of(root->re, root->exponent), y = log10_of(root->im, root->exponent);
    const algsurf_integer *larger = x > y ? &root->re : &root->im;
    long long places = isfinite(fmax(x, y)) ? digits - 1 - first_place(*larger, root->exponent) : digits;
    *re = *im = (roots_decimals){NULL, NULL, NULL};
    return write_part(root->re, root, places, re) && write_part(root->im, root, places, im);
}

void roots_digits_free(roots_decimals *d) {
    free(d->value);
    free(d->lo);
    free(d->hi);
}
