/* sturm.h - the number of real roots of a polynomial of one high term and a few low ones. */
#ifndef ALGSURF_STURM_H
#define ALGSURF_STURM_H

/* The number of distinct roots of c[0] + ... + c[degree] t^degree, c[0] and c[degree] not 0, between lo and
 * hi, each of these 0 or infinite.  Returns 0 where Sturm's chain is long, or without memory. */
int algsurf_i_count_by_sturm(const double *c, int degree, double lo, double hi, int *count);

/* The number of roots of degree 2 or 3 on the line, by the discriminant; -1 where its sign is not known. */
int algsurf_i_count_by_discriminant(const double *c, int degree);
#endif
