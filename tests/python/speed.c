/* speed.c - what speed.py measures, by the library alone: seconds for the calls and batches named there.
 *     speed FILE CALLS ROWS     FILE: ROWS x 7 doubles, a polynomial of degree 6 a row; CALLS times the first
 * one */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "algsurf/algsurf.h"

enum { DEGREE = 6, TAKES = 3 };
static double *c;
static size_t calls, rows;

static double now(void) {
    struct timespec t;
    (void)timespec_get(&t, TIME_UTC);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void real_calls(void) {
    algsurf_real_root roots[DEGREE];
    int count;
    for (size_t i = 0; i < calls; i++)
        if (algsurf_real_roots(c, DEGREE, -INFINITY, INFINITY, roots, DEGREE, &count) != ALGSURF_OK) exit(1);
}

static void complex_calls(void) {
    algsurf_complex_root roots[DEGREE];
    int count;
    for (size_t i = 0; i < calls; i++)
        if (algsurf_complex_roots_of_real(c, NULL, DEGREE, roots, &count) != ALGSURF_OK) exit(1);
}

/* As a program would: room for the answers is part of it. */
static void real_batch_in(double lo, double hi) {
    const algsurf_real_batch batch = {.size = sizeof batch,
                                      .count = rows,
                                      .degree = DEGREE,
                                      .coefficients = {c, 1, DEGREE + 1},
                                      .lo = &lo,
                                      .hi = &hi};
    algsurf_real_root *roots = malloc(rows * DEGREE * sizeof *roots);
    int *count = malloc(rows * sizeof *count);
    if (!roots || !count || algsurf_real_roots_batch(&batch, NULL, roots, count) != ALGSURF_OK) exit(1);
    free(roots);
    free(count);
}

static void real_batch(void) { real_batch_in(-INFINITY, INFINITY); }
static void interval_batch(void) { real_batch_in(-1, 1); }

static void complex_batch(void) {
    const algsurf_complex_batch batch = {
        .size = sizeof batch, .count = rows, .degree = DEGREE, .re = {c, 1, DEGREE + 1}};
    algsurf_complex_root *roots = malloc(rows * DEGREE * sizeof *roots);
    int *count = malloc(rows * sizeof *count);
    if (!roots || !count || algsurf_complex_roots_batch(&batch, NULL, roots, count) != ALGSURF_OK) exit(1);
    free(roots);
    free(count);
}

int main(int argc, char **argv) {
    void (*const work[])(void) = {real_calls, complex_calls, real_batch, interval_batch, complex_batch};
    if (argc != 4) return 2;
    calls = strtoul(argv[2], NULL, 10), rows = strtoul(argv[3], NULL, 10);
    FILE *file = fopen(argv[1], "rb");
    c = malloc(rows * (DEGREE + 1) * sizeof *c);
    if (!file || !c || fread(c, (DEGREE + 1) * sizeof *c, rows, file) != rows) return 2;
    for (size_t w = 0; w < sizeof work / sizeof *work; w++) {
        double least = INFINITY;
        for (int i = 0; i < TAKES; i++) {
            const double begin = now();
            work[w]();
            least = fmin(least, now() - begin);
        }
        printf("%.9f\n", least);
    }
    fclose(file);
    free(c);
    return 0;
}
