/* elementary.h - logarithm, power, sine and cosine whose bits are the same on every machine.
 *
 * libm's differ in the last bit from one system to the next, and that bit would decide start values, scales
 * and colours.  These are made of +, -, *, / and exact scalings only.  Their errors are below
 * 0.9 units in the last place (elementary.c, tests/test_elementary.c), where nothing else is said; a
 * subnormal result is rounded twice. */
#ifndef ALGSURF_ELEMENTARY_H
#define ALGSURF_ELEMENTARY_H

/* Of a positive, finite x. */
double algsurf_i_log2(double x);

/* 2^x, of any x: 0 or infinity where that is out of range. */
double algsurf_i_exp2(double x);

/* x^y, off by another |y log2 x| / 32 units; x >= 0 (infinity included), y finite and >= 0; 0^0 is 1.  NaN of
 * a NaN. */
double algsurf_i_pow(double x, double y);

/* Cosine and sine, |angle| <= 2^20; next to their zeros they may be off by 2^-100 |angle|, the share of pi
 * that is left out. */
void algsurf_i_circle(double angle, double point[2]);

#endif
