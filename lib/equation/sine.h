/* sine.h - sine and cosine of constants, for the equation parser. */
#ifndef ALGSURF_EQUATION_SINE_H
#define ALGSURF_EQUATION_SINE_H
#include "poly.h"

/* The largest argument, in radians. */
#define ALGSURF_I_SINE_LIMIT 100

/* sin(m + quarters pi/2), m a constant with |m| <= the limit, normalised (poly.h); 0 <= quarters
 * <= 3. */
algsurf_i_monomial algsurf_i_monomial_sine(const algsurf_i_monomial *m, int quarters);

/* pi to double-double. */
algsurf_i_monomial algsurf_i_monomial_pi(void);

#endif
