/* interval_cases.h - operands and environments for the tests of intervals. */
#ifndef INTERVAL_CASES_H
#define INTERVAL_CASES_H
#include <float.h>
#include <string.h>

#include "algsurf/interval.h"
#include "environments.h"
#include "exact.h"

/* A finite double: zeros, small integers, whole range, subnormals, both rims of the range, near 1, and the
 * limits of the error-free product. */
static inline double case_double(uint64_t *seed) {
    static const int rims[] = {-1074, -1022, -1000, -969, -960, -537, 480, 995, 996, 1000, 1023};
    double x;
    switch (random_int(seed, 10)) {
    case 0:
        return 0.0;
    case 1:
        return (double)(random_int(seed, 41) - 20);
    case 2:
        x = random_wide(seed, -1074, 1023);
        break;
    case 3:
        x = random_wide(seed, -1074, -1018);
        break;
    case 4:
        x = random_wide(seed, 1015, 1023);
        break;
    case 5:
        x = ldexp(random_unit(seed), rims[random_int(seed, 11)]);
        break;
    case 6:
        return random_unit(seed) > 0 ? DBL_MAX : -DBL_MAX;
    case 7:
        return (random_unit(seed) > 0 ? 1 : -1) + 0x1p-52 * (random_int(seed, 9) - 4);
    default:
        x = random_wide(seed, -4, 4);
        break;
    }
    return fabs(x) < INFINITY ? x : DBL_MAX;
}

static inline algsurf_interval case_sorted(double a, double b) {
    return a < b ? (algsurf_interval){a, b} : (algsurf_interval){b, a};
}

/* An interval: points, thin ones, wide ones, with infinite ends. */
static inline algsurf_interval case_interval(uint64_t *seed) {
    double x = case_double(seed);
    algsurf_interval a = {x, x};
    int kind = random_int(seed, 8);
    if (kind == 1) a = case_sorted(x, nextafter(x, 0));
    if (kind > 1) a = case_sorted(x, case_double(seed));
    if (random_int(seed, 16) == 0) a.lo = -INFINITY;
    if (random_int(seed, 16) == 0) a.hi = INFINITY;
    return a;
}

/* Around 1, of any width up to the size. */
static inline algsurf_interval case_tame(uint64_t *seed) {
    double x = random_wide(seed, -2, 2), w = ldexp(random_unit(seed), -random_int(seed, 40));
    return random_int(seed, 5) ? case_sorted(x, x + w) : (algsurf_interval){x, x};
}

/* A double in the interval: an end, or between. */
static inline double case_inside(uint64_t *seed, algsurf_interval a) {
    double lo = isinf(a.lo) ? -DBL_MAX : a.lo, hi = isinf(a.hi) ? DBL_MAX : a.hi;
    int kind = random_int(seed, 4);
    if (kind < 2) return kind ? lo : hi;
    double t = fabs(random_unit(seed)), x = lo * (1 - t) + hi * t;
    return x < lo ? lo : x > hi ? hi : x;
}

/* Runs work(data) in each environment a host may have set, then check(data, its name) in the standard one. */
static inline void case_environments(void (*work)(void *), void (*check)(void *, const char *), void *data) {
    static const char *const names[] = {"nearest", "upward", "downward", "toward zero"};
    for (int i = 0; i < ENVIRONMENTS; i++) {
        environment_set(i);
        work(data);
        check(data, environment_unset(i) ? names[i % 4] : "mode not restored");
    }
}

#endif
