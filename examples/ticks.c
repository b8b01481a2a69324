/* ticks.c - see ticks.h.  A number on an axis is a whole number of steps, so that its digits are exact. */
#include "ticks.h"

#include <math.h>
#include <string.h>

enum { MOST_PLAIN = 6, MOST_ZEROS = 3 }; /* digits before the point, zeros behind it: without an exponent */

tick_step ticks_step(double least) {
    static const int digits[] = {1, 2, 5};
    int exponent = (int)floor(log10(least) + 1e-9);
    double unit = pow(10, exponent);
    for (int i = 0; i < 3; i++)
        if (digits[i] * unit >= least * (1 - 1e-9)) return (tick_step){digits[i], exponent};
    return (tick_step){1, exponent + 1};
}

double ticks_size(tick_step step) { return step.digit * pow(10, step.exponent); }

static char *put_whole(char *out, long long n) {
    char digits[20]; /* as many as 2^63 has, and one more */
    int count = 0;
    do {
        digits[count++] = (char)('0' + n % 10);
    } while (n /= 10);
    while (count > 0) *out++ = digits[--count];
    *out = '\0';
    return out;
}

static char *put_zeros(char *out, int count) {
    while (count-- > 0) *out++ = '0';
    *out = '\0';
    return out;
}

/* Puts a point behind so many digits. */
static void put_point(char *digits, int before) {
    size_t length = strlen(digits + before);
    if (length == 0) return;
    memmove(digits + before + 1, digits + before, length + 1);
    digits[before] = '.';
}

void ticks_text(tick_step step, long long k, char text[TICKS_TEXT]) {
    long long n = (k < 0 ? -k : k) * step.digit;
    int exponent = step.exponent;
    char *out = text;
    if (k < 0) *out++ = '-';
    if (n == 0) exponent = 0;
    for (; n != 0 && n % 10 == 0; n /= 10) exponent++;
    char *end = put_whole(out, n);
    int before = (int)(end - out) + exponent; /* digits before the point */
    if (before > MOST_PLAIN || before < -MOST_ZEROS) {
        end += end - out > 1; /* for the point */
        put_point(out, 1);
        *end++ = 'e';
        if (before < 1) *end++ = '-';
        put_whole(end, before < 1 ? 1 - before : before - 1);
    } else if (exponent >= 0) {
        put_zeros(end, exponent);
    } else if (before > 0) {
        put_point(out, before);
    } else {
        memmove(out - before + 1, out, (size_t)(end - out) + 1);
        memset(out, '0', (size_t)(1 - before));
        put_point(out, 1);
    }
}
