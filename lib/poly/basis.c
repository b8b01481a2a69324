/* basis.c - see basis.h.  Coefficient j of v^k is the mean of the products of k out of j factors +1 and n-j
 * factors -1: what x^k has in (1+x)^j (1-x)^(n-j), over C(n,k).  These are whole numbers, at most C(64,32) <
 * 2^61; the two conversions and the quotient round three times above 2^53, below once.
 *
 * -x for x turns row j into row n-j, and 1/x for x turns each row around, both up to signs: a quarter of the
 * matrix is computed. */
#include "../base/arithmetic.h"
#include "basis.h"

#include <stdint.h>

#include "algsurf/status.h"

/* a or -a; 0 has no sign. */
static double signed_by(int k, double a) { return k % 2 ? 0 - a : a; }

void algsurf_i_power_basis(double *matrix, int n) {
    int64_t ways[ALGSURF_MAX_DEGREE / 2 + 1] = {1}, g[ALGSURF_MAX_DEGREE / 2 + 1];
    const int half = n / 2;
    for (int a = 1; a <= n; a++)
        for (int k = a < half ? a : half; k >= 1; k--) ways[k] += ways[k - 1];
    for (int k = 0; k <= half; k++) g[k] = k % 2 ? -ways[k] : ways[k];
    for (int j = 0; j <= half; j++) {
        double *row = matrix + j * (n + 1), *mirrored = matrix + (n - j) * (n + 1);
        for (int k = 0; k <= half; k++) {
            row[k] = (double)g[k] / (double)ways[k];
            row[n - k] = signed_by(n - j, row[k]);
            mirrored[k] = signed_by(k, row[k]);
            mirrored[n - k] = signed_by(n - k, row[n - k]);
        }
        for (int k = 1; k <= half; k++) g[k] += g[k - 1]; /* over 1-x */
        for (int k = half; k >= 1; k--) g[k] += g[k - 1]; /* times 1+x */
    }
}
