/* expansion.h - exact sums and products of doubles, for the sign of a polynomial at a point.
 *
 * An expansion is an unevaluated sum of doubles that do not overlap, of increasing magnitude; its sign
 * is that of the last.  Addition and multiplication are exact as long as no product leaves the range
 * in which two_prod is exact and the components fit; `exact` turns 0 when one did.
 * Source: Shewchuk, Adaptive precision floating-point arithmetic, 1997, grow-expansion with
 * elimination of zeros.
 */
#ifndef ALGSURF_EFT_EXPANSION_H
#define ALGSURF_EFT_EXPANSION_H

/* 2098 bits lie between the largest and the least double: 64 components of 53 bits hold most sums,
 * sparse ones take more. */
#define ALGSURF_EXPANSION_SIZE 192

typedef struct algsurf_i_expansion {
    int count, exact;
    double x[ALGSURF_EXPANSION_SIZE];
} algsurf_i_expansion;

#define ALGSURF_SIGN_UNKNOWN 2

void algsurf_i_expansion_set(algsurf_i_expansion *e, double a);
void algsurf_i_expansion_add_double(algsurf_i_expansion *e, double a);
void algsurf_i_expansion_add(algsurf_i_expansion *e, const algsurf_i_expansion *f);
void algsurf_i_expansion_add_product(algsurf_i_expansion *e, double a, double b);
/* e = e f; e and f are different objects. */
void algsurf_i_expansion_multiply(algsurf_i_expansion *e, const algsurf_i_expansion *f);
/* -1, 0, +1, or ALGSURF_SIGN_UNKNOWN. */
int algsurf_i_expansion_sign(const algsurf_i_expansion *e);

#endif
