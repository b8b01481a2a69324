/* basis.c - see basis.h.  Coefficient j of v^k is the mean of the products of k out of j factors +1 and n-j
 * factors -1.  The sums are whole numbers, at most C(64,32) < 2^61; the two conversions and the quotient
 * round three times above 2^53, below once. */
#include "../base/arithmetic.h"
#include "basis.h"

#include <stdint.h>

#include "algsurf/status.h"

void algsurf_i_power_basis(double *matrix, int n) {
    int64_t choose[ALGSURF_MAX_DEGREE + 1][ALGSURF_MAX_DEGREE + 1] = {{0}};
    for (int a = 0; a <= n; a++) {
        choose[a][0] = 1;
        for (int b = 1; b <= a; b++) choose[a][b] = choose[a - 1][b - 1] + choose[a - 1][b];
    }
    for (int j = 0; j <= n; j++)
        for (int k = 0; k <= n; k++) {
            int64_t sum = 0;
            for (int l = k > n - j ? k - n + j : 0; l <= j && l <= k; l++)
                sum += ((k - l) % 2 ? -1 : 1) * choose[j][l] * choose[n - j][k - l];
            matrix[j * (n + 1) + k] = (double)sum / (double)choose[n][k];
        }
}
