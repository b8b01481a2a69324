/* fuzz.h - what the fuzz targets share: bytes to numbers, and the end of a run that found something.
 *
 * A target is LLVMFuzzerTestOneInput: libFuzzer calls it with inputs of its own, replay.c with those of the
 * corpus.  Inputs are text, also where they stand for numbers: decimal or hexadecimal floats, inf and nan,
 * separated by whatever is no number, so that the corpus can be read, written and explained.  Missing numbers
 * are 0.
 */
#ifndef FUZZ_H
#define FUZZ_H
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What libFuzzer calls; returns 0. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Ends the program: the input is a finding. */
#define fuzz_check(condition)                                                                                \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            fprintf(stderr, "%s:%d: not true: %s\n", __FILE__, __LINE__, #condition);                        \
            abort();                                                                                         \
        }                                                                                                    \
    } while (0)

/* The input as a string; to be freed.  NUL bytes in it end it for who reads on. */
static inline char *fuzz_string(const uint8_t *data, size_t size) {
    char *text = malloc(size + 1);
    fuzz_check(text);
    if (size > 0) memcpy(text, data, size);
    text[size] = '\0';
    return text;
}

/* The judges of isolate_case.h and intersect_case.h complain through cmocka, which says what is wrong outside
 * of its own tests only when told to. */
static inline void fuzz_loud_judges(void) { (void)setenv("CMOCKA_TEST_ABORT", "1", 1); }

enum { FUZZ_NUMBERS = 256 };

typedef struct fuzz_numbers {
    double x[FUZZ_NUMBERS];
    int count, at;
} fuzz_numbers;

static inline fuzz_numbers fuzz_numbers_of(const uint8_t *data, size_t size) {
    fuzz_numbers n = {.count = 0};
    char *text = fuzz_string(data, size), *end;
    for (char *at = text; *at && n.count < FUZZ_NUMBERS; at = end) {
        double x = strtod(at, &end);
        if (end == at)
            end++;
        else
            n.x[n.count++] = x;
    }
    free(text);
    return n;
}

static inline int fuzz_left(const fuzz_numbers *n) { return n->count - n->at; }

/* The next number, whatever it is. */
static inline double fuzz_any(fuzz_numbers *n) { return n->at < n->count ? n->x[n->at++] : 0; }

/* The next one, or 0 for what is not finite. */
static inline double fuzz_finite(fuzz_numbers *n) {
    double x = fuzz_any(n);
    return isfinite(x) ? x : 0;
}

/* The next one as a whole number in low..high: itself, or its remainder. */
static inline int fuzz_whole(fuzz_numbers *n, int low, int high) {
    return low + (int)fmod(floor(fabs(fuzz_finite(n) - low)), (double)(high - low) + 1);
}

/* The span of the exponents, in bits: what exact arithmetic has to carry. */
static inline int fuzz_span(const double *x, int count) {
    int low = 2000, high = -2000;
    for (int i = 0; i < count; i++) {
        int e;
        if (x[i] == 0 || !isfinite(x[i])) continue;
        (void)frexp(x[i], &e);
        low = e < low ? e : low, high = e > high ? e : high;
    }
    return high > low ? high - low : 0;
}

#endif
