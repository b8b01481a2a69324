// roots_cypolynomial.cc - cyPolynomial (Yuksel, High-Performance Polynomial Root Finding for Graphics, 2022):
// Newton's method between critical points, found in the same way; degrees 2 to 10.
#include <cyPolynomial.h>

#include <cmath>

#include "roots_others.h"

static const double TOLERANCE = 1e-12;

namespace {
template <int N> double first(const double *c) {
    double root;
    return cy::PolynomialFirstRoot<N, double>(root, c, -1.0, 1.0, TOLERANCE) ? root : std::nan("");
}
template <int N> int all(const double *c, double *roots) {
    return cy::PolynomialRoots<N, double>(roots, c, -1.0, 1.0, TOLERANCE);
}
} // namespace

double by_cy_first(const double *c, int degree) {
    switch (degree) {
    case 2: return first<2>(c);
    case 3: return first<3>(c);
    case 4: return first<4>(c);
    case 6: return first<6>(c);
    case 8: return first<8>(c);
    case 10: return first<10>(c);
    default: return std::nan("");
    }
}

int by_cy_interval(const double *c, int degree, double *roots) {
    switch (degree) {
    case 2: return all<2>(c, roots);
    case 3: return all<3>(c, roots);
    case 4: return all<4>(c, roots);
    case 6: return all<6>(c, roots);
    case 8: return all<8>(c, roots);
    case 10: return all<10>(c, roots);
    default: return 0;
    }
}
