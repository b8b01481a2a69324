/* extremes.h - what the parts of the benchmark extremes share: rays and surfaces at the edges of what doubles
 * can say, in sweeps towards each edge; where a ray first meets the surface, to more digits than a double
 * has; answers judged.
 *
 * All but the report is used by the test of the same name, too, which judges with exact arithmetic.
 */
#ifndef EXTREMES_H
#define EXTREMES_H
#include "algsurf/algsurf.h"
#include "measure.h"

/* ---- scenes ---- */

/* A surface inside an extent, and rays: those of a packet.  The doubles are exact. */
typedef struct scene {
    algsurf_surface *surface;
    algsurf_term *terms;
    size_t term_count;
    algsurf_extent extent;
    size_t count;
    algsurf_ray *ray;
    algsurf_ray_packet packet; /* the same rays */
    unsigned char *expected;   /* an algsurf_hit_state that is known from how the ray was made; UNDECIDED: it
                                  is not */
} scene;

typedef struct sweep {
    const char *name, *title, *quantity; /* quantity: what is swept, and its unit */
    const double *values;
    int points, variants; /* scenes for each value */
    void (*make)(int variant, double value, measure_random *random, scene *s);
} sweep;

enum { SWEEPS = 8 };
extern const sweep sweeps[SWEEPS];

/* The scene of one value and variant, with `count` rays; the same for the same arguments. */
void scene_make(const sweep *from, int point, int variant, size_t count, int seed, scene *s);
void scene_free(scene *s);

/* ---- the makers of scenes, and what they share ---- */

/* Each fills surface, extent, rays, and what is known of them; the room for the rays is there. */
void make_distance(int variant, double value, measure_random *random, scene *s);
void make_scale(int variant, double value, measure_random *random, scene *s);
void make_gap(int variant, double value, measure_random *random, scene *s);
void make_degree(int variant, double value, measure_random *random, scene *s);
void make_singular(int variant, double value, measure_random *random, scene *s);
void make_extent(int variant, double value, measure_random *random, scene *s);
void make_spread(int variant, double value, measure_random *random, scene *s);
void make_leading(int variant, double value, measure_random *random, scene *s);

/* The surface of an equation, its coefficient of x^i y^j z^k times s_0^-i s_1^-j s_2^-k size, rounded:
 * stretched by s_0, s_1, s_2 along the axes. */
void set_equation(scene *s, const char *equation);
void set_stretched(scene *s, const char *equation, const double stretch[3], double size);
void set_terms(scene *s, const algsurf_term *terms, size_t count);

/* Uniform on the unit sphere; in the unit ball. */
void random_direction(measure_random *random, double w[3]);
void random_in_ball(measure_random *random, double x[3]);

/* Ray i starts at the eye, t from 0 on; towards a target, with a direction of unit length, rounded. */
void set_ray(scene *s, size_t i, const double eye[3], const double direction[3]);
void set_look(scene *s, size_t i, const double eye[3], const double target[3]);

/* ---- the truth ---- */

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

/* ---- what was found out ---- */

enum { MOST_POINTS = 16 };

/* All rays of one value of a sweep, asked in one manner. */
typedef struct finding {
    size_t rays, hits, undecided;   /* hits: of the truth */
    double error_median, error_max; /* of t, in units of u kappa |t|; NaN: there is none */
    double ns, ns_min, ns_max;      /* a ray */
} finding;

typedef struct record {
    const sweep *sweep;
    finding finding[MOST_POINTS][MANNERS];
} record;

/* A table of each; extremes.csv of all and extremes_NAME.svg of each, unless the folder is null. */
void report(const record *records, size_t count, const char *folder);

#endif
