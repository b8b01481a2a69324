/* beam.h - the beam form of the expansion: P along all rays of a tile of the picture at once.
 *
 * A view's ray (u,v) has P as a polynomial in its depth z (view.h).  For the rays near (u_c,v_c),
 *     u = u_c + h_u xi,  v = v_c + h_v eta,  |xi|, |eta| <= 1,
 * each of its Bernstein coefficients over -1 <= z <= 1 is a polynomial in xi and eta,
 *     b_k = sum over i + j <= n of T_k,ij xi^i eta^j:
 * what holds for all xi and eta holds for each ray of the tile.  P is brought to (u,v,z) once a frame, to a
 * tile's v once for a row of tiles; the tiles of such a row are made side by side (beams/tiles_template.h).
 */
#ifndef ALGSURF_SURFACE_BEAM_H
#define ALGSURF_SURFACE_BEAM_H
#include "view.h"

#define ALGSURF_I_BEAM_ORDER 4     /* terms beyond it in xi and eta are known by a bound of their row only */
#define ALGSURF_MAX_BEAM_DEGREE 12 /* beyond it tiles cost more than they save */

/* For a row of tiles: b_k = sum c_kji u^i eta^j. */
typedef struct algsurf_i_beam_row {
    int degree;
    double v, h, hu; /* v_c, h_v, |h_u| */
    double *c;       /* (degree+1)^3: c_kji at (k (degree+1) + j) (degree+1) + i */
    /* The T_k,ij beyond the fourth order of a tile with |u_c| <= U add up to sum beyond[i] U^i at most, for
     * each k. */
    double beyond[ALGSURF_MAX_BEAM_DEGREE + 1];
    /* All T of a tile, in each cell that it is cut to (beam.c), are off by so little together that each of
     * its rays' coefficients is off by at most sum radius[i] x^i, x = U + |alpha| U + |beta[0]| for the
     * tile's largest |u| = U, x <= 4. */
    double radius[ALGSURF_MAX_VIEW_DEGREE + 1];
} algsurf_i_beam_row;

/* P in (u,v,z): g_kij at (i (degree+1) + j) (degree+1) + k of the (degree+1)^3 entries of g, with
 * b_k = sum g_kij u^i v^j.  Cost: some degree^4 operations. */
void algsurf_i_beam_expand(const algsurf_i_frame_form *frame, double *g);

/* The row of tiles about v, |eta| <= 1 for |v' - v| <= |h|, for (|v| + |h|) (1 + |alpha|) + |beta[1]| <= 4;
 * hu: their |h_u|.  `memory` has room for (degree+1)^2 doubles.  Cost: some degree^4 / 3 operations. */
void algsurf_i_beam_row_expand(const algsurf_i_frame_form *frame, const double *g, double v, double h,
                               double hu, double *memory, algsurf_i_beam_row *row);

#endif
