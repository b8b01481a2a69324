/* view.h - the frame and row forms of the expansion: one polynomial for all rays of a picture.
 *
 * A view gives each ray by two numbers (u, v), where it meets the plane across the line of sight through
 * the centre of what is shown, and each point of it by its depth z behind that plane.  They are measured in
 * units of the view's size, so that what is shown lies in |x|, |y|, |z| <= 1 whatever the distance of the
 * eye:
 *     X = centre + size (x axis[0] + y axis[1] + z axis[2])
 *     x = u + z (alpha u + beta[0]),  y = v + z (alpha v + beta[1])
 * alpha is the inverse of the eye's distance, 0 for parallel rays; beta is 0 when the eye looks at the
 * centre.  P is brought to (x, y, z) once a frame; once a row v is fixed; and for a few neighbouring pixels
 * the range of depth that they have in common leaves n+1 polynomials in u: the Bernstein coefficients.
 */
#ifndef ALGSURF_EXPAND_VIEW_H
#define ALGSURF_EXPAND_VIEW_H
#include "impl.h"

#define ALGSURF_MAX_VIEW_DEGREE 24 /* beyond it a frame costs more than the rays of a small picture */

typedef struct algsurf_i_view {
    double centre[3], axis[3][3], size; /* natural units; the axes are taken as they are */
    double alpha, beta[2];
    double noise; /* bound on the distance, in each of x, y, z, of a ray from the one it stands for */
} algsurf_i_view;

/* 2^scale P = sum q_ijk x^i y^j z^k. */
typedef struct algsurf_i_frame_form {
    int degree;
    algsurf_i_view view;
    double *q;     /* (degree+1)^3: q_ijk at (i (degree+1) + j) (degree+1) + k */
    double *basis; /* (degree+1)^2: Bernstein coefficient j of z^k over [-1,1] at j (degree+1) + k */
    /* With Q_ijk = |q_ijk|; where the surface's coefficients have an error, its magnitudes in their stead: */
    double *sizes;      /* (degree+1)^2: sum_k Q_ijk at i (degree+1) + j */
    double *along;      /* (degree+1)^2: sum_k k Q_ijk */
    double spread;      /* relative error of the surface's coefficients */
    double value_error; /* bound on that of P in doubles, anywhere in |x|, |y|, |z| <= 1 */
    double error;       /* bound on the polynomial's error for |x|, |y|, |z| <= 4, but for u |q_ijk| each */
} algsurf_i_frame_form;

/* Fills the arrays of a frame of degree at most ALGSURF_MAX_VIEW_DEGREE with the help of `memory`, of
 * algsurf_i_frame_memory(degree) bytes.  Returns 0 when values would leave the range of double.  Cost:
 * O(degree^6 / 180) operations in double-double. */
size_t algsurf_i_frame_memory(int degree);
int algsurf_i_frame_expand(const algsurf_surface *s, algsurf_i_frame_form *frame, void *memory);

#define ALGSURF_ROW_STRIDE (ALGSURF_MAX_VIEW_DEGREE + 8)

/* P for one v: sum c_km z^k u^m. */
typedef struct algsurf_i_row_form {
    int degree, stride; /* stride: a multiple of 8, at least degree+1 */
    double v;
    double c[(ALGSURF_MAX_VIEW_DEGREE + 1) * ALGSURF_ROW_STRIDE]; /* c_km at k stride + m; 0 for m > degree */
    /* Bernstein coefficients over any part of -1 <= z <= 1, made from it by Horner's rule in u and a change of
     * basis (beams/pixels_template.h), are off by at most sum radius[i] x^i, x = |u| + |alpha u| + |beta[0]|, for x <= 4 */
    double radius[ALGSURF_MAX_VIEW_DEGREE + 1];
} algsurf_i_row_form;

/* For |v| + |alpha v + beta[1]| <= 4.  Cost: some 2 degree^3 operations. */
void algsurf_i_row_expand(const algsurf_i_frame_form *frame, double v, algsurf_i_row_form *row);

/* radius[i]: the share of x^i in a bound on the error of a coefficient that q_ijk x^i y^j z^k reaches with
 * each (i + j) + all roundings; y = |v| + |slope| + noise at most. */
void algsurf_i_view_radius(const algsurf_i_frame_form *frame, double y, int each, int all, double *radius);

#endif
