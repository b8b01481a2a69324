/* shortest.c - see shortest.h.
 *
 * Raffaello Giulietti, The Schubfach way to render doubles (2020).  Of a double c 2^q all that reads back as
 * the double lies between the middles to its neighbours, (4c-2) 2^(q-2) and (4c+2) 2^(q-2); at a power of two
 * the lower one is (4c-1) 2^(q-2).  With k so that 10^k is at most the width of that interval, and 10^(k+1)
 * is more, it holds a multiple of 10^k, and at most one of 10^(k+1).  The quotients of the double and of the
 * ends by 10^k are taken with two bits behind the point and a third that tells whether anything is left
 * (rounding to odd): that 128 bits of the power suffice is section 9 there. */
#include "shortest.h"

#include <string.h>

/* ---- powers of ten ---- */

enum { LIMBS = 20, HALVES = 2 * LIMBS }; /* 10^324 has 1077 bits; 2^1279 / 10^292 has 310 */

/* The 128 bits from the first 1 of a, in halves of limbs, the most significant last; up if bits are left. */
static void take_top(const uint32_t *a, int sticky, uint64_t *high, uint64_t *low) {
    int top = HALVES - 1, shift = 0;
    while (!a[top]) top--;
    while (!(a[top] << shift >> 31)) shift++;
    uint32_t part[5] = {0};
    for (int i = 0; i < 5 && top - i >= 0; i++) part[i] = a[top - i];
    for (int i = 0; i < 4; i++) part[i] = shift ? part[i] << shift | part[i + 1] >> (32 - shift) : part[i];
    sticky |= (uint32_t)(part[4] << shift) != 0;
    for (int i = top - 5; i >= 0; i--) sticky |= a[i] != 0;
    *high = (uint64_t)part[0] << 32 | part[1];
    *low = ((uint64_t)part[2] << 32 | part[3]) + (sticky != 0);
    *high += sticky && *low == 0;
}

void shortest_fill(shortest_powers *powers) {
    uint32_t up[HALVES] = {1}, down[HALVES] = {0};
    down[HALVES - 1] = 1u << 31;
    for (int k = 0; k <= SHORTEST_MOST; k++) {
        take_top(up, 0, &powers->high[k - SHORTEST_LEAST], &powers->low[k - SHORTEST_LEAST]);
        uint64_t carry = 0;
        for (int i = 0; i < HALVES; i++, carry >>= 32) {
            carry += 10 * (uint64_t)up[i];
            up[i] = (uint32_t)carry;
        }
    }
    for (int k = -1; k >= SHORTEST_LEAST; k--) { /* a quotient's floor by 10 is that by all tens at once */
        uint64_t rest = 0;
        for (int i = HALVES - 1; i >= 0; i--, rest %= 10) {
            rest = rest << 32 | down[i];
            down[i] = (uint32_t)(rest / 10);
        }
        take_top(down, 1, &powers->high[k - SHORTEST_LEAST], &powers->low[k - SHORTEST_LEAST]);
    }
}

/* ---- the digits ---- */

/* The upper 64 bits of a b, and the lower ones; no integer has to have more, which on 32-bit machines none
 * has. */
static uint64_t product(uint64_t a, uint64_t b, uint64_t *low) {
    const uint64_t half = 0xffffffffu;
    uint64_t al = a & half, ah = a >> 32, bl = b & half, bh = b >> 32;
    uint64_t middle = ah * bl + (al * bl >> 32), other = al * bh + (middle & half);
    *low = a * b;
    return ah * bh + (middle >> 32) + (other >> 32);
}

/* The upper 64 bits of the product, the last one set if anything is below. */
static uint64_t round_to_odd(uint64_t high, uint64_t low, uint64_t c) {
    uint64_t below, sum, carried = product(low, c, &below), top = product(high, c, &sum);
    sum += carried;
    top += sum < carried;
    return top | (sum > 1);
}

/* floor(log10(2^q)), or of 3/4 2^q; floor(log2(10^k)): right for all exponents here. */
static int tens_of(int q, int closer) { return (q * 1262611 - (closer ? 524031 : 0)) >> 22; }
static int twos_of(int k) { return (k * 1741647) >> 19; }

typedef struct decimal {
    uint64_t digits;
    int exponent;
} decimal;

static decimal shortest(const shortest_powers *powers, uint64_t fraction, int biased) {
    uint64_t c = biased ? fraction | (uint64_t)1 << 52 : fraction;
    int q = (biased ? biased : 1) - 1075, closer = fraction == 0 && biased > 1, odd = c & 1;
    int k = tens_of(q, closer), h = q + twos_of(-k) + 1;
    uint64_t high = powers->high[-k - SHORTEST_LEAST], low = powers->low[-k - SHORTEST_LEAST];
    uint64_t value = round_to_odd(high, low, 4 * c << h);
    uint64_t least = round_to_odd(high, low, (4 * c - 2 + (uint64_t)closer) << h) + (uint64_t)odd;
    uint64_t most = round_to_odd(high, low, (4 * c + 2) << h) - (uint64_t)odd;
    uint64_t s = value / 4, tens = s / 10;
    if (s >= 10) {
        int below = least <= 40 * tens, above = 40 * tens + 40 <= most;
        if (below != above) return (decimal){tens + (uint64_t)above, k + 1};
    }
    int below = least <= 4 * s, above = 4 * s + 4 <= most;
    if (below != above) return (decimal){s + (uint64_t)above, k};
    uint64_t middle = 4 * s + 2;
    return (decimal){s + (value > middle || (value == middle && s % 2 == 1)), k};
}

/* ---- the text ---- */

static char *write_exponent(char *to, int e) {
    *to++ = 'e';
    *to++ = e < 0 ? '-' : '+';
    e = e < 0 ? -e : e;
    if (e >= 100) *to++ = (char)('0' + e / 100);
    *to++ = (char)('0' + e / 10 % 10);
    *to++ = (char)('0' + e % 10);
    return to;
}

static char *copy(char *to, const char *from, int count) {
    memcpy(to, from, (size_t)count);
    return to + count;
}

static char *zeros(char *to, int count) {
    memset(to, '0', (size_t)count);
    return to + count;
}

/* Digits d.ddd times 10^e, the point where %.17g has it. */
static char *write_digits(char *to, const char *digit, int count, int e) {
    if (e < -4 || e >= 17) {
        *to++ = *digit;
        if (count > 1) *to++ = '.';
        return write_exponent(copy(to, digit + 1, count - 1), e);
    }
    if (e < 0) return copy(zeros(copy(to, "0.", 2), -e - 1), digit, count);
    if (count <= e + 1) return zeros(copy(to, digit, count), e + 1 - count);
    to = copy(to, digit, e + 1);
    *to++ = '.';
    return copy(to, digit + e + 1, count - e - 1);
}

enum { MOST_DIGITS = 17 };

/* Four digits of n < 10000. */
static void write_four(char *to, unsigned n) {
    unsigned first = n / 100, last = n % 100;
    to[0] = (char)('0' + first / 10), to[1] = (char)('0' + first % 10);
    to[2] = (char)('0' + last / 10), to[3] = (char)('0' + last % 10);
}

/* The digits of 0 < n < 10^17 without zeros at the end, which raise the exponent, somewhere in the array;
 * returns the first one. */
static const char *digits_of(uint64_t n, int *exponent, int *count, char digit[MOST_DIGITS]) {
    uint64_t high = n / 100000000, top = high / 100000000;
    unsigned middle = (unsigned)(high - 100000000 * top), low = (unsigned)(n - 100000000 * high);
    int first = 0, last = MOST_DIGITS;
    digit[0] = (char)('0' + top);
    write_four(digit + 1, middle / 10000), write_four(digit + 5, middle % 10000);
    write_four(digit + 9, low / 10000), write_four(digit + 13, low % 10000);
    while (digit[last - 1] == '0') last--, ++*exponent;
    while (digit[first] == '0') first++;
    *count = last - first;
    return digit + first;
}

static int write_word(char *text, const char *word) {
    size_t length = strlen(word);
    memcpy(text, word, length);
    return (int)length;
}

int shortest_write(const shortest_powers *powers, double x, char *text) {
    uint64_t bits, fraction;
    char digit[MOST_DIGITS], *to = text;
    memcpy(&bits, &x, sizeof bits);
    fraction = bits & (((uint64_t)1 << 52) - 1);
    int biased = (int)(bits >> 52 & 0x7ff);
    if (biased == 0x7ff && fraction) return write_word(text, "nan");
    if (bits >> 63) *to++ = '-';
    if (biased == 0x7ff) return (int)(to - text) + write_word(to, "inf");
    if (!biased && !fraction) return (int)(to - text) + write_word(to, "0");
    decimal d = shortest(powers, fraction, biased);
    int count;
    const char *first = digits_of(d.digits, &d.exponent, &count, digit);
    return (int)(write_digits(to, first, count, d.exponent + count - 1) - text);
}
