/* roots_limbs.c - see roots_limbs.h. */
#include "roots_limbs.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* ---- one limb ---- */

static int last_limb(const uint64_t *a, int length) {
    while (length > 0 && !a[length - 1]) length--;
    return length;
}

int roots_limbs_times(uint64_t *a, int length, uint32_t factor, uint32_t add) {
    uint64_t carry = add;
    for (int i = 0; i < length; i++) {
        uint64_t low = (a[i] & UINT32_MAX) * factor + carry, high = (a[i] >> 32) * factor + (low >> 32);
        a[i] = high << 32 | (low & UINT32_MAX);
        carry = high >> 32;
    }
    if (carry) a[length++] = carry;
    return length;
}

/* The low limb of a b; the high one goes to *high. */
static uint64_t multiply(uint64_t a, uint64_t b, uint64_t *high) {
    uint64_t a0 = a & UINT32_MAX, a1 = a >> 32, b0 = b & UINT32_MAX, b1 = b >> 32;
    uint64_t low = a0 * b0, middle = a1 * b0 + (low >> 32), other = a0 * b1 + (middle & UINT32_MAX);
    *high = a1 * b1 + (middle >> 32) + (other >> 32);
    return other << 32 | (low & UINT32_MAX);
}

/* a += b factor, as many limbs as b has; returns the limb behind them. */
static uint64_t add_multiple(uint64_t *a, const uint64_t *b, int length, uint64_t factor) {
    uint64_t carry = 0, high;
    for (int i = 0; i < length; i++) {
        uint64_t low = multiply(b[i], factor, &high) + carry;
        a[i] += low;
        carry = high + (low < carry) + (a[i] < low);
    }
    return carry;
}

/* ---- shifts, bits ---- */

int roots_limbs_shift_up(uint64_t *a, int length, long long bits) {
    int limbs = (int)(bits / 64), rest = (int)(bits % 64);
    a[length] = 0;
    for (int i = length; i >= 0; i--) {
        uint64_t below = i > 0 && rest ? a[i - 1] >> (64 - rest) : 0;
        a[i + limbs] = a[i] << rest | below;
    }
    for (int i = 0; i < limbs; i++) a[i] = 0;
    return last_limb(a, length + limbs + 1);
}

/* floor(a / 2^from) modulo 2^64, from >= 0. */
static uint64_t window(const uint64_t *a, int length, int from) {
    int i = from / 64, rest = from % 64;
    uint64_t low = i < length ? a[i] : 0, high = i + 1 < length ? a[i + 1] : 0;
    return rest ? low >> rest | high << (64 - rest) : low;
}

int roots_limbs_make_odd(uint64_t *a, int length, int *twos) {
    int limbs = 0, rest = 0;
    while (!a[limbs]) limbs++;
    while (!(a[limbs] >> rest & 1)) rest++;
    *twos = 64 * limbs + rest;
    for (int i = 0; *twos && i < length - limbs; i++) a[i] = window(a, length, *twos + 64 * i);
    return last_limb(a, length - limbs);
}

int roots_limbs_bits(const uint64_t *a, int length) {
    uint64_t top = a[length - 1], high = top >> 32;
    int e;
    (void)frexp((double)(high ? high : top), &e);
    return 64 * (length - 1) + (high ? 32 : 0) + e;
}

/* ---- products, quotients ---- */

int roots_limbs_product(const uint64_t *a, int a_length, const uint64_t *b, int b_length, uint64_t *product) {
    memset(product, 0, (size_t)(a_length + b_length) * sizeof *product);
    for (int i = 0; i < a_length; i++) product[i + b_length] = add_multiple(product + i, b, b_length, a[i]);
    return last_limb(product, a_length + b_length);
}

/* Adds multiples of b, which is odd, to a until its lowest limb is 0, then its next one, so many of them, at
 * most a_length - b_length + 1; the factors go to `factor`, if that is wanted.  a has a limb more, which is
 * filled. */
static void clear_lowest(uint64_t *a, int a_length, const uint64_t *b, int b_length, int limbs,
                         uint64_t *factor) {
    uint64_t inverse = b[0]; /* of b modulo 2^3, then 2^6 .. 2^96 */
    for (int i = 0; i < 5; i++) inverse *= 2 - b[0] * inverse;
    a[a_length] = 0;
    for (int i = 0; i < limbs; i++) {
        uint64_t f = -(a[i] * inverse), carry = add_multiple(a + i, b, b_length, f);
        for (int k = i + b_length; carry && k <= a_length; k++) {
            a[k] += carry;
            carry = a[k] < carry;
        }
        if (factor) factor[i] = f;
    }
}

/* The factors f are such that a + b f is 0 modulo 2^(64 limbs): f is minus the quotient, which is
 * odd: its lowest limb is not 0. */
int roots_limbs_quotient(uint64_t *a, int a_length, const uint64_t *b, int b_length, uint64_t *quotient) {
    int limbs = a_length - b_length + 1;
    clear_lowest(a, a_length, b, b_length, limbs, quotient);
    for (int i = 0; i < limbs; i++) quotient[i] = ~quotient[i] + (i == 0);
    return last_limb(quotient, limbs);
}

static int is_less(const uint64_t *a, int a_length, const uint64_t *b, int b_length) {
    if (a_length != b_length) return a_length < b_length;
    for (int i = a_length - 1; i >= 0; i--)
        if (a[i] != b[i]) return a[i] < b[i];
    return 0;
}

/* a -= b <= a. */
static int subtract(uint64_t *a, int a_length, const uint64_t *b, int b_length) {
    uint64_t borrow = 0;
    for (int i = 0; i < a_length; i++) {
        uint64_t less = (i < b_length ? b[i] : 0) + borrow;
        borrow = less < borrow || a[i] < less;
        a[i] -= less;
    }
    return last_limb(a, a_length);
}

/* A multiple of b on a, and limbs that are 0 off, leave the gcd as it is: b is odd. */
int roots_limbs_gcd(uint64_t *a, int a_length, uint64_t *b, int b_length) {
    uint64_t *larger = a, *less = b;
    int twos;
    if (a_length > b_length) {
        int limbs = a_length - b_length;
        clear_lowest(a, a_length, b, b_length, limbs, NULL);
        larger = a + limbs;
        a_length = last_limb(larger, b_length + 1);
    }
    int larger_length = a_length, less_length = b_length;
    while (larger_length > 0) {
        larger_length = roots_limbs_make_odd(larger, larger_length, &twos);
        if (is_less(larger, larger_length, less, less_length)) {
            uint64_t *swap = larger;
            int swap_length = larger_length;
            larger = less, larger_length = less_length;
            less = swap, less_length = swap_length;
        }
        larger_length = subtract(larger, larger_length, less, less_length);
    }
    memmove(b, less, (size_t)less_length * sizeof *b);
    return less_length;
}

/* ---- doubles ---- */

/* Is a divisible by 2^bits, bits >= 0? */
static int divisible(const uint64_t *a, int length, int bits) {
    for (int i = 0; i < length && i <= bits / 64; i++)
        if (i < bits / 64 ? a[i] : a[i] & (((uint64_t)1 << bits % 64) - 1)) return 0;
    return 1;
}

/* The last bit kept is that of a double: of 53, and not below 2^-1074.  Between two doubles it is the even
 * one. */
double roots_limbs_double(const uint64_t *a, int length, int down, int *off) {
    int drop = length ? roots_limbs_bits(a, length) - DBL_MANT_DIG : 0;
    if (drop < down - 1074) drop = down - 1074;
    if (drop <= 0) return ldexp(length ? (double)a[0] : 0, -down);
    uint64_t kept = window(a, length, drop - 1); /* and a bit more */
    int up = kept & 1 && (kept & 2 || !divisible(a, length, drop - 1));
    if (!divisible(a, length, drop)) *off = 1;
    return ldexp((double)(kept / 2 + (uint64_t)up), drop - down);
}

/* With as many bits in a and b: a / b is between 1/2 and 2, so that 64 of its binary digits have all 53 of a
 * double, and more; a last bit stands for what is left. */
double roots_limbs_ratio(uint64_t *a, int a_length, uint64_t *b, int b_length, long long up) {
    int more = roots_limbs_bits(a, a_length) - roots_limbs_bits(b, b_length), off;
    uint64_t quotient = 0;
    if (more >= 0)
        b_length = roots_limbs_shift_up(b, b_length, more);
    else
        a_length = roots_limbs_shift_up(a, a_length, -more);
    for (int bit = 63; bit >= 0; bit--) {
        if (!is_less(a, a_length, b, b_length)) {
            quotient |= (uint64_t)1 << bit;
            a_length = subtract(a, a_length, b, b_length);
        }
        a_length = roots_limbs_shift_up(a, a_length, 1);
    }
    if (a_length) quotient |= 1;
    up += more - 63;
    const int far = 5000; /* beyond all doubles */
    return roots_limbs_double(&quotient, 1, up > far ? -far : up < -far ? far : (int)-up, &off);
}
