/* roots_sets.c - see roots.h: the polynomials. */
#include <math.h>
#include <stdlib.h>

#include "cli.h"
#include "measure.h"
#include "must.h"
#include "rays.h"
#include "roots.h"

static void open(roots_set *s, const char *name, int degree, int complex, size_t count) {
    size_t all = count * ((size_t)degree + 1);
    *s = (roots_set){.name = name, .degree = degree, .count = count};
    s->c = must_allocate(all, sizeof *s->c);
    s->im = complex ? must_allocate(all, sizeof *s->im) : NULL;
}

algsurf_table roots_set_rows(const roots_set *s, const double *c, size_t begin) {
    ptrdiff_t row = s->degree + 1;
    return (algsurf_table){c ? c + (ptrdiff_t)begin * row : NULL, 1, row};
}

void roots_set_of_rays(roots_set *set, const char *surface, size_t count) {
    const catalogue_entry *entry = catalogue_find(surface);
    open(set, surface, entry->degree, 0, count);
    rays_polynomials(entry, 1, count, set->c);
}

void roots_set_at_random(roots_set *set, const char *name, int degree, int complex, size_t count) {
    measure_random random = {(uint64_t)degree};
    open(set, name, degree, complex, count);
    for (size_t i = 0; i < count * ((size_t)degree + 1); i++) {
        set->c[i] = measure_uniform(&random, -1, 1);
        if (complex) set->im[i] = measure_uniform(&random, -1, 1);
    }
}

/* Multiplies p, of the degree, by q_0 + q_1 t + t^2. */
static void times_quadratic(double *p, int degree, double q0, double q1) {
    for (int k = degree + 2; k >= 0; k--) {
        double below = k >= 2 ? p[k - 2] : 0, next = k >= 1 && k <= degree + 1 ? p[k - 1] : 0;
        p[k] = below + q1 * next + q0 * (k <= degree ? p[k] : 0);
    }
}

void roots_set_grazing(roots_set *set, const char *name, int degree, size_t count) {
    measure_random random = {(uint64_t)(100 + degree)};
    open(set, name, degree, 0, count);
    for (size_t i = 0; i < count; i++) {
        double *p = set->c + i * ((size_t)degree + 1), a = measure_uniform(&random, -0.9, 0.9);
        double e = pow(10, measure_uniform(&random, -7, -2));
        p[0] = 1;
        times_quadratic(p, 0, a * a + (measure_bits(&random) & 1 ? -e * e : e * e), -2 * a);
        for (int d = 2; d < degree; d += 2) {
            double x = measure_uniform(&random, -1.5, 1.5), y = measure_uniform(&random, 0.3, 1.5);
            times_quadratic(p, d, x * x + y * y, -2 * x);
        }
    }
}

void roots_set_free(roots_set *set) {
    free(set->c);
    free(set->im);
}
