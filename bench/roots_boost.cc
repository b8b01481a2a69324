// roots_boost.cc - Boost's TOMS 748 (Alefeld, Potra, Shi 1995) on a bracket.
#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>

#include "roots_others.h"

double by_toms748(const double *c, int degree, double lo, double hi, double tolerance) {
    auto value = [c, degree](double x) {
        double sum = c[degree];
        for (int k = degree - 1; k >= 0; k--) sum = sum * x + c[k];
        return sum;
    };
    auto narrow = [tolerance](double a, double b) { return std::fabs(b - a) <= 2 * tolerance; };
    double at_lo = value(lo), at_hi = value(hi);
    if (at_lo == 0 || at_hi == 0 || (at_lo < 0) == (at_hi < 0)) // as computed, by rounding
        return at_lo == 0 ? lo : at_hi == 0 ? hi : 0.5 * (lo + hi);
    std::uintmax_t steps = 1000;
    auto bracket = boost::math::tools::toms748_solve(value, lo, hi, at_lo, at_hi, narrow, steps);
    return 0.5 * (bracket.first + bracket.second);
}
