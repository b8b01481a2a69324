/* basis.c - see basis.h.  Coefficient j of v^k is the mean of the products of k out of j factors +1 and n-j
 * factors -1: what x^k has in (1+x)^j (1-x)^(n-j), over C(n,k).  These are whole numbers, at most C(64,32) <
 * 2^61; the two conversions and the quotient round three times above 2^53, below once. */
#include "../base/arithmetic.h"
#include "basis.h"

#include <stdint.h>

#include "algsurf/status.h"

void algsurf_i_power_basis(double *matrix, int n) {
    int64_t ways[ALGSURF_MAX_DEGREE + 1] = {1}, g[ALGSURF_MAX_DEGREE + 1];
    for (int a = 1; a <= n; a++)
        for (int k = a; k >= 1; k--) ways[k] += ways[k - 1];
    for (int k = 0; k <= n; k++) g[k] = k % 2 ? -ways[k] : ways[k];
    for (int j = 0; j <= n; j++) {
        for (int k = 0; k <= n; k++) *matrix++ = (double)g[k] / (double)ways[k];
        for (int k = 1; k <= n && j < n; k++) g[k] += g[k - 1]; /* over 1-x */
        for (int k = n; k >= 1 && j < n; k--) g[k] += g[k - 1]; /* times 1+x */
    }
}
