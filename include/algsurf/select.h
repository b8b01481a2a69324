/* algsurf/select.h - the root that is seen in complex space: least magnitude in a range of arguments.
 *
 * In complex space a ray shows, of all roots t of its polynomial, the one of least magnitude |t| whose
 * argument lies in [sigma, sigma + delta] or in the conjugate range [-sigma - delta, -sigma].  Real
 * space is sigma = 0, delta = 0, since positive real roots have argument exactly 0; with a small delta roots
 * near the real axis count, too.
 * Source: Sanjuan-Estrada, Casado, Garcia, section 4.
 */
#ifndef ALGSURF_SELECT_H
#define ALGSURF_SELECT_H
#include "algsurf/allroots.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Arguments in radians, sigma .. sigma + delta, ends included: 0 <= sigma, 0 <= delta, sigma + delta <= pi.
 * What is said to be in the sector has its argument there, or in the conjugate range.
 * The sum is exact, not rounded.  Since pi is not a double, a sum that rounds to the double nearest to pi,
 * 0x1.921fb54442d18p+1, or to the next larger one, counts as pi; a larger sum is refused. */
typedef struct algsurf_sector {
    double sigma, delta; /* where the range begins, and how wide it is */
} algsurf_sector;

/* What is known of the root that is seen. */
typedef enum algsurf_selected {
    ALGSURF_SELECTED_NONE = 0,     /* no root is in the sector and in [lo,hi]: verified */
    ALGSURF_SELECTED_ONE = 1,      /* the root at `index` is, and no smaller one can be: verified */
    ALGSURF_SELECTED_UNDECIDED = 2 /* the root at `index` is the least that may be in both */
} algsurf_selected;

/* Are the roots of a box in the sector?  The root 0 has argument 0; roots proved real have exactly 0 or pi.
 *   holds  1: each is in the sector or in its conjugate; 0: none is; 2: undecided
 * Errors: E_ARGUMENT (null, sector out of range), E_NOT_FINITE (sector).  Cost: about 100 ns.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_sector_holds(const algsurf_sector *sector,
                                                const algsurf_complex_root *root, int *holds);

/* The root of least magnitude among those in the sector with lo <= |t| <= hi.
 *   roots, count  as algsurf_complex_roots gives them
 *   lo, hi        magnitudes that count; 0 <= lo <= hi, hi may be infinite
 *   selected      an algsurf_selected
 *   index         that of the root; untouched if NONE
 * Nothing is assumed of the polynomial: if the magnitudes of two boxes overlap, it is undecided which root is
 * smaller, also for boxes that are mirror images of each other.
 * Errors: E_ARGUMENT, E_NOT_FINITE (sector, NaN as lo or hi).  Cost: O(count), about 100 ns for each root
 * whose argument has to be computed.
 * Since 1.0. */
ALGSURF_API algsurf_status algsurf_select(const algsurf_complex_root *roots, int count,
                                          const algsurf_sector *sector, double lo, double hi, int *selected,
                                          int *index);

/* The same for the roots of one polynomial with real coefficients, all of them, as
 * algsurf_complex_roots_of_real gives them (or algsurf_complex_roots without radii): there a box off the real
 * axis and its mirror image hold conjugates, which are equally large.  Errors, cost: as above.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_select_of_real(const algsurf_complex_root *roots, int count,
                                                  const algsurf_sector *sector, double lo, double hi,
                                                  int *selected, int *index);

#ifdef __cplusplus
}
#endif
#endif
