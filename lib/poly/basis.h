/* basis.h - the matrix from powers to Bernstein coefficients. */
#ifndef ALGSURF_BASIS_H
#define ALGSURF_BASIS_H

/* Coefficient j of v^k over [-1,1] in the Bernstein basis of degree n <= 64, at matrix[j (n+1) + k]; each is
 * rounded once, and at most 1 in magnitude. */
void algsurf_i_power_basis(double *matrix, int n);

#endif
