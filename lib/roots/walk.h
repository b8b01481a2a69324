/* walk.h - one polynomial's roots in an interval of the line, by doubles; and where none can be. */
#ifndef ALGSURF_WALK_H
#define ALGSURF_WALK_H
#include "algsurf/isolate.h"
#include "coefficients.h"
#include "watch.h"

/* Is no term of p much larger than c_0 for |t| <= size?  Then one piece will do. */
int algsurf_i_is_level(const algsurf_i_coefficients *p, double size);

/* Cut from [lo,hi] what is farther from 0, or nearer, than the sizes of the coefficients, which have no
 * radii, let roots be; c[0] and c[degree] are not 0.  Nothing is left where lo > hi.  p is not 0 at a new
 * end. */
void algsurf_i_cut_far(const algsurf_i_coefficients *p, double *lo, double *hi);
void algsurf_i_cut_near(const algsurf_i_coefficients *p, double *lo, double *hi);

/* A root of p, c[0] not 0, isolated or final: if its bracket holds 0, it keeps the side with the root,
 * without 0 itself unless that is an end that has no double between it and the other one.  Returns 0 where no
 * double is below the root. */
int algsurf_i_leave_zero(const algsurf_i_coefficients *p, algsurf_real_root *root);

/* A root, isolated or final: is it in [lo,hi]?  A bracket that an end lies inside is cut there: two
 * neighbours are not. */
int algsurf_i_is_inside(const algsurf_i_coefficients *p, double lo, double hi, algsurf_real_root *root);

/* Brackets of the roots of p in [lo,hi] in order, at most `most`, which may be as many as the degree says:
 * simple roots, ends of certain sign.  Returns 0 when something is left undecided, between the last bracket,
 * or lo, and hi.  level: of p and
 * [lo,hi].  watch: null, or who is told. */
int algsurf_i_walk(const algsurf_i_coefficients *p, double lo, double hi, int level, int most,
                   algsurf_bracket *b, int *count, const algsurf_i_watch *watch);

#endif
