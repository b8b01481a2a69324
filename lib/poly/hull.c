/* hull.c - the upper hull of points given from left to right: Andrew's monotone chain, 1979. */
#include "../base/arithmetic.h"
#include "hull.h"

#include <math.h>

int algsurf_i_upper_hull(const double *height, int first, int last, int *corner) {
    int count = 0;
    for (int k = first; k <= last; k++) {
        if (isinf(height[k])) continue;
        for (; count >= 2; count--) { /* drop corners that lie on or under the line to the new point */
            int a = corner[count - 2], b = corner[count - 1];
            if ((height[b] - height[a]) * (k - a) > (height[k] - height[a]) * (b - a)) break;
        }
        corner[count++] = k;
    }
    return count;
}
