/* extremes_truth.h - where a ray first meets the surface, to more digits than a double has; answers judged.
 */
#ifndef EXTREMES_TRUTH_H
#define EXTREMES_TRUTH_H
#include "extremes_cases.h"

/* The first root, and the error that is to be expected of a double: with P = sum a x^i y^j z^k,
 *     S = sum |a x^i y^j z^k|,  kappa = 1 + S / |t P'(t)|  at the root,  u = 2^-53,  unit = u kappa |t|.
 * Coefficients that are off by a relative u move the root by u S / |P'(t)|, and rounding t by u |t|.  What
 * rounding the ray would do is not in it: far eyes are no excuse. */
typedef struct truth {
    int state;         /* an algsurf_hit_state; UNDECIDED: not known */
    double root, rest; /* the first root is their sum; if it is a hit */
    double unit;       /* infinite: the root is not known well enough to tell errors */
} truth;

typedef enum manner { MANNER_BOUNDED, MANNER_CERTIFIED, MANNER_PACKET, MANNERS } manner;
extern const char *const manner_names[MANNERS];

/* The first hits of all rays: one by one in a tier, or as a packet in the certified tier.  Returns 0 when the
 * library refuses one.  Of the answers: state, t, t_lo, t_hi. */
typedef struct answers {
    unsigned char *state;
    double *t, *t_lo, *t_hi;
} answers;
int scene_ask(const scene *s, manner m, const answers *a);

/* The truth of ray i as the benchmark knows it.  Whether there is a root: from how the ray was made, else
 * from answer i of the certified tier, and so the interval that holds it; where in that: Newton's method and
 * bisection in double-double. */
truth scene_truth(const scene *s, size_t i, const answers *certified);

typedef struct verdict {
    const char *wrong; /* what contradicts the truth; null: nothing */
    int undecided;
    double error; /* of t, in the truth's units; NaN: not told */
} verdict;

/* Judges answer i.  Wrong is a hit or miss that is none, a root outside of the interval that is said to
 * enclose it, an undecided interval that begins behind the first root. */
verdict judge(const truth *known, const answers *a, size_t i);

#endif
