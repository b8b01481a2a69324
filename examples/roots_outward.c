/* roots_outward.c - see roots_outward.h.
 *
 * printf gives all digits of a double, which are 767 at most; they are cut, and the last one that is left is
 * increased where the number is to be larger.
 */
#include "roots_outward.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ALL = 780, KEPT = 17 };

typedef struct decimal {
    char digit[ALL + 8]; /* d.ddd: the point left out */
    int exponent;        /* of the first digit */
} decimal;

static decimal digits_of(double magnitude) {
    char text[ALL + 32];
    decimal d;
    snprintf(text, sizeof text, "%.*e", ALL, magnitude);
    d.digit[0] = text[0];
    memcpy(d.digit + 1, text + 2, ALL);
    d.digit[ALL + 1] = '\0';
    d.exponent = atoi(text + 2 + ALL + 1);
    return d;
}

/* Adds one to the last of the first n digits. */
static void increase(decimal *d, int n) {
    while (n > 0 && d->digit[n - 1] == '9') d->digit[--n] = '0';
    if (n > 0) {
        d->digit[n - 1]++;
        return;
    }
    memmove(d->digit + 1, d->digit, ALL);
    d->digit[0] = '1';
    d->exponent++;
}

/* Cuts behind the place of 10^place; away: to the next larger number, unless only zeros are cut off. */
static void round_at(decimal *d, int place, int away) {
    int n = d->exponent - place + 1;
    if (n > ALL) n = ALL;
    if (n < 0) n = 0;
    const char *cut = d->digit + n;
    int rest = cut[strspn(cut, "0")] != '\0';
    memset(d->digit + n, '0', (size_t)(ALL + 1 - n));
    if (!rest || !away) return;
    if (n == 0) { /* smaller than a unit of the place */
        d->digit[0] = '1';
        d->exponent = place;
    } else {
        increase(d, n);
    }
}

/* As %g has it, without zeros at the end. */
static int write_decimal(const decimal *d, int negative, char *text) {
    int count = ALL + 1, length = 0, e = d->exponent;
    while (count > 0 && d->digit[count - 1] == '0') count--;
    if (count == 0) return sprintf(text, "0");
    if (negative) text[length++] = '-';
    if (e < -5 || e >= KEPT) {
        length +=
            sprintf(text + length, "%c%s%.*s", d->digit[0], count > 1 ? "." : "", count - 1, d->digit + 1);
        return length + sprintf(text + length, "e%s%02d", e < 0 ? "-" : "+", abs(e));
    }
    if (e < 0) return length + sprintf(text + length, "0.%.*s%.*s", -1 - e, "0000", count, d->digit);
    if (count <= e + 1) return length + sprintf(text + length, "%.*s", e + 1, d->digit);
    return length + sprintf(text + length, "%.*s.%.*s", e + 1, d->digit, count - e - 1, d->digit + e + 1);
}

static int write_end(double x, int place, int upper, char *text) {
    if (isinf(x)) return sprintf(text, x < 0 ? "-inf" : "inf");
    if (x == 0) return sprintf(text, "0");
    decimal d = digits_of(fabs(x));
    round_at(&d, place, upper ? x > 0 : x < 0);
    return write_decimal(&d, x < 0, text);
}

/* The place of the first digit. */
static int place_of(double x) { return x > 0 ? (int)floor(log10(x)) : -400; }

void roots_outward(algsurf_interval x, char text[ROOTS_OUTWARD_ROOM]) {
    double width = x.hi - x.lo, largest = 0;
    if (isfinite(x.lo)) largest = fabs(x.lo);
    if (isfinite(x.hi)) largest = fmax(largest, fabs(x.hi));
    /* each end moves by less than a unit of the place: together by less than half the width */
    int place = isfinite(width) ? place_of(width / 4) : -400, least = place_of(largest) - KEPT + 1;
    if (place < least) place = least;
    int length = sprintf(text, "[");
    length += write_end(x.lo, place, 0, text + length);
    length += sprintf(text + length, ", ");
    length += write_end(x.hi, place, 1, text + length);
    sprintf(text + length, "]");
}
