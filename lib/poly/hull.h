/* hull.h - Newton's polygon: where the magnitudes of a polynomial's roots are. */
#ifndef ALGSURF_POLY_HULL_H
#define ALGSURF_POLY_HULL_H

/* Corners of the upper convex hull of the points (k, height[k]), k = first .. last, where height[k] is
 * log2 |c_k|, -inf for a coefficient that is 0.  An edge from corner j to corner k stands for k - j roots
 * of magnitude about 2^((height[j] - height[k]) / (k - j)), up to a factor of the degree.
 *   corner  receives at most last - first + 1 indices, increasing; their number is returned. */
int algsurf_i_upper_hull(const double *height, int first, int last, int *corner);

#endif
