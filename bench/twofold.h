/* twofold.h - double-double: Dekker, A floating-point technique for extending the available precision, 1971,
 * with the error bounds of Joldes, Muller, Popescu, Tight and rigorous error bounds for basic building blocks
 * of double-word arithmetic, 2017: 3 u^2 for a sum, 7 u^2 for a product, u = 2^-53.
 */
#ifndef TWOFOLD_H
#define TWOFOLD_H
#include <math.h>

typedef struct twofold {
    double hi, lo;
} twofold;

static inline twofold sum(double a, double b) {
    double s = a + b, part = s - a;
    return (twofold){s, (a - (s - part)) + (b - part)};
}

static inline twofold add(twofold a, twofold b) {
    twofold s = sum(a.hi, b.hi), t = sum(a.lo, b.lo);
    s = sum(s.hi, s.lo + t.hi);
    return sum(s.hi, s.lo + t.lo);
}

static inline twofold multiply(twofold a, twofold b) {
    double p = a.hi * b.hi, e = fma(a.hi, b.hi, -p);
    return sum(p, e + (a.hi * b.lo + a.lo * b.hi));
}

static inline twofold twice(double a) { return (twofold){a, 0}; }

#endif
