/* seed_bare.h - the bracket of the first root with nothing proved: what isolation costs at the least. */
#ifndef SEED_BARE_H
#define SEED_BARE_H

/* Of a polynomial's roots in [-1,1], the first: returns 1 and a bracket with different signs at its ends, or
 * 0: none seen.  Rounding is disregarded, and so are roots closer together than some 2^-40. */
int seed_bare_isolate(const double *c, int degree, double *lo, double *hi);

#endif
