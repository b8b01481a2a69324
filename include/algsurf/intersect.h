/* algsurf/intersect.h - where a ray meets a surface: first hit, all hits, occluded or not. */
#ifndef ALGSURF_INTERSECT_H
#define ALGSURF_INTERSECT_H
#include "algsurf/observe.h"
#include "algsurf/ray.h"
#include "algsurf/refine.h"
#include "algsurf/select.h"
#include "algsurf/surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How much is known about an answer, and what it may cost.  Answers are about the exact problem: the
 * polynomial whose coefficients are the doubles given, the line origin + t direction of the doubles given,
 * the closed ball or box of the doubles given, and the closed half spaces of planes; both ends of the ray
 * belong to it. */
typedef enum algsurf_tier {
    /* Every ray is decided: a hit, with its multiplicity, or a miss.  Doubles decide where their error bounds
     * allow it, integers decide the rest: rays that touch, roots closer than any double can separate, roots
     * at an end of the ray, on the extent's surface or on a cutting plane, rays in the surface.  A ray is
     * undecided only if coefficients are known up to an error (algsurf_surface_with_error) and the answer is
     * not the same for all of them, or not shown to be: where roots may be at the ends of what is looked at,
     * where the ray may lie in the surface, and where it is nearly parallel to a cutting plane. */
    ALGSURF_TIER_CERTIFIED = 0,
    /* Doubles with error bounds only: what they leave open is undecided.  For programs that need a limit on
     * the time of every ray. */
    ALGSURF_TIER_BOUNDED = 1
} algsurf_tier;

/* What an undecided place is reported as. */
typedef enum algsurf_undecided_as {
    ALGSURF_AS_UNDECIDED = 0, /* as what it is: ALGSURF_STATE_UNDECIDED */
    ALGSURF_AS_HIT = 1,       /* as a hit, not verified; its `reason` still tells why */
    ALGSURF_AS_MISS = 2       /* not at all: a later hit is the first, or the ray misses; not verified */
} algsurf_undecided_as;

/* What is known of a hit. */
typedef enum algsurf_hit_state {
    ALGSURF_STATE_MISS = 0,      /* no point of the surface on the ray: verified, but see undecided_as */
    ALGSURF_STATE_HIT = 1,       /* a point of the surface, and the first: verified, but see undecided_as */
    ALGSURF_STATE_UNDECIDED = 2, /* not decided: coefficients known to an error only, or the bounded tier */
    ALGSURF_STATE_THIN = 3,   /* in pictures only: the ray passes something thin (algsurf_scene_set_thin) */
    ALGSURF_STATE_REFUSED = 4 /* in packets only: a bad ray; its `reason` is the error */
} algsurf_hit_state;

/* Where a ray meets a surface.  For a miss, t, t_lo and t_hi are +inf, and the vectors are 0. */
typedef struct algsurf_hit {
    int state;        /* an algsurf_hit_state */
    int reason;       /* an algsurf_status: OK; why it is undecided (positive), or refused (negative) */
    int multiplicity; /* of the root t: 1 where the ray crosses a smooth sheet, 2 where it touches one, ...; 0
                         where the ray lies in the surface, for a miss, and for an undecided place */
    int side; /* hit: the sign of P just before it on the ray, -1 or 1; 0 with multiplicity 0.  Miss: the sign
                 of P on the ray in the extent (in a ball twice as large, where the surface itself is that of
                 the extent), behind all hits that the option `side` skips; 0 if the ray has no part there,
                 or rounding hides the sign.  Undecided: 0.  In complex space: 0 */
    double t; /* approximate, along the ray as given; undecided: a point of that place */
    double t_lo, t_hi;  /* encloses: the hit is in [t_lo, t_hi], and no hit is before t_lo.  If integers
                           decided, both are t, or they are neighbouring doubles.  If doubles decided, the
                           interval is as a rule some 100 units in the last place wide (the effect of
                           rounding P), else it is the one that isolates the hit.  Doubles decide simple
                           roots, and, where P = c Q^k, simple roots of Q.  Coefficients that are known
                           up to an error widen it.  Undecided: there may be a hit in it, or none */
    double position[3]; /* origin + t direction; finite: at most the largest double in size */
    double normal[3];   /* the gradient of P at the position, unit length, its direction to 10^-4 degrees,
                           however P's terms cancel.  At a singular point, or so near to one that 2^-50 of
                           the position's size, or of the surface's where that is larger, changes the
                           direction, it is the normal at a point shortly before it on the ray.  All 0 if
                           that has none (a ray in the surface), or without memory */
} algsurf_hit;

/* How rays are intersected. */
typedef struct algsurf_intersect_options {
    size_t size;        /* sizeof(algsurf_intersect_options) */
    int tier;           /* an algsurf_tier: how much is to be known about an answer */
    int method;         /* an algsurf_method: how brackets are refined */
    int max_iterations; /* of the refinement, >= 0; 0: 1000; at the limit the best point so far counts */
    double absolute_tolerance; /* wanted error of t, in the unit of t, >= 0; 0: full accuracy, by a last
                                  Newton step on P at the point itself */
    const char *kernel;        /* the SIMD code, by a name that algsurf_kernel_name gives; null: the fastest
                                  that runs here.  All of them give the same bits */
    int undecided_as;          /* an algsurf_undecided_as: what an undecided place is reported as */
    size_t max_memory; /* bytes that deciding one ray may allocate, 0: ALGSURF_DEFAULT_MEMORY; above that the
                          answer is E_NO_MEMORY */
    algsurf_observer *observer;  /* null: nobody watches; else it is told the cells and points of the one ray,
                                    as t along it.  Packets and pictures, where rays go side by side and by
                                    several threads, refuse it: E_ARGUMENT */
    const algsurf_plane *planes; /* what is shown is the part of the extent that all of these keep; null: all
                                    of it.  The guarantees stay the same, and a point on a plane is kept */
    size_t plane_count;          /* at most ALGSURF_MAX_CLIP_PLANES */
    int side; /* 0: all hits count.  -1, 1: only those before which P has this sign; others are skipped.  So a
                 ray that starts at a hit's position (which rounding puts on either side) needs no epsilon:
                 give the sign of normal . direction, the side it leaves to.  A ray that lies in the surface
                 has no such hit.  In pictures 0 is required */
} algsurf_intersect_options;

/* Enough for all but rays of high degree with numbers of hundreds of orders of magnitude. */
#define ALGSURF_DEFAULT_MEMORY ((size_t)1 << 30)

/* The SIMD code for packets and pictures that runs on this machine, the fastest first: "avx512" (8 rays side
 * by side), "avx2" (4), "baseline" (2).  All of them give the same bits.
 *   index  from 0 on
 * Returns a static string, or null when there are not that many.  Since 1.0. */
ALGSURF_API const char *algsurf_kernel_name(int index);

/* The first hit on the ray inside the extent, t in [t_min, t_max], both ends included.
 *   extent   null: all of space
 *   options  null: certified tier, default method, full accuracy
 * Guarantee: see algsurf_tier.  With absolute_tolerance 0, |t - exact| is within a few u S(X)/|p'(t)|,
 * u = 2^-53, S(X) the sum of |a x^i y^j z^k| over P's terms at the hit, and within one unit in the last place
 * where integers decided.  With a tolerance, the error may be larger by the tolerance, and by 2^-49 of the
 * length in t of the ray's part inside the extent.
 * Regula falsi, and any method that stops at the limit of iterations, promise less: t is in [t_lo, t_hi].  A
 * ray alone has the same bits as in a packet (algsurf_intersect_packet), with every kernel.
 * Returns OK also for a miss and for undecided: the state is in hit.
 * Errors: E_ARGUMENT (null, zero direction, bad extent or options, a plane with normal 0), E_NOT_FINITE
 * (origin, direction, NaN t, extent, planes, options), E_NO_MEMORY.
 * Cost: 0.2 to 1 microseconds for degrees 2 to 10.  A ray that integers decide: 5 to 200 microseconds for
 * degrees 2 to 10, and more where numbers are of very different sizes; integers allocate only beyond degree
 * 10 or so.  If P is exactly c Q^k, with coefficients of Q below 2^53 in a common unit, a ray takes the time
 * of Q, unless an observer watches it or `side` asks for a sign that P has nowhere.  42 KiB of stack.  Since
 * 1.0. */
ALGSURF_API algsurf_status algsurf_intersect_first(const algsurf_surface *surface,
                                                   const algsurf_extent *extent, const algsurf_ray *ray,
                                                   const algsurf_intersect_options *options,
                                                   algsurf_hit *hit);

/* All hits, in increasing t, each once with its multiplicity.  (A ray that lies in the surface has one hit,
 * where the part inside the extent begins.)
 *   hits, capacity  room for the answer; the surface's degree, at least 1, always suffices
 *   count           how many were written, undecided ones included
 * Guarantee: that of the first hit, for each; there is no hit outside the entries.  The first entry is the
 * hit of algsurf_intersect_first; its t, t_lo and t_hi may differ if one of the calls needed integers.
 * Errors: as above; E_CAPACITY: nothing is written.  Cost: 0.3 to 3 microseconds
 * for the first of them, for degrees 2 to 10, and about as much for each of the others, unless integers
 * decide.  42 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_intersect_all(const algsurf_surface *surface, const algsurf_extent *extent,
                                                 const algsurf_ray *ray,
                                                 const algsurf_intersect_options *options, algsurf_hit *hits,
                                                 int capacity, int *count);

/* Is there any hit?  Cheaper than the first hit, since no root is refined.  If P has different signs at the
 * two ends of the ray's part inside the extent, there is a hit; so the answer may be a hit although
 * algsurf_intersect_first leaves the first hit undecided.
 *   state  ALGSURF_STATE_HIT: occluded; ALGSURF_STATE_MISS: free; or ALGSURF_STATE_UNDECIDED
 * Errors: as above.  42 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_occluded(const algsurf_surface *surface, const algsurf_extent *extent,
                                            const algsurf_ray *ray, const algsurf_intersect_options *options,
                                            int *state);

/* A point beside a hit at which P has a given sign, so that a ray that starts there does not meet the hit
 * again.  For rays that are handed to other intersectors; this library's own calls take the option `side`.
 *   ray, hit  as given to algsurf_intersect_first, and as it returned them
 *   side      hit->side is the side that the ray comes from, -hit->side, as a rule, the one that it goes to
 *   start     the point: off the position along the normal (where that is 0: along the ray), by 2^-53 to
 *             2^-20 times the larger of |position| and a scale of the surface.  It is, as a rule, some 2^-40:
 *             far enough for doubles to decide rays from there
 * Guarantee: the sign of P at start is `side`: verified.  Returns OK; or NOT_VERIFIED if there is no such
 * point so near, as beyond a double root: start is untouched then.
 * Errors: E_ARGUMENT (null, side not -1 or 1, a hit whose state is not ALGSURF_STATE_HIT, bad ray),
 * E_NOT_FINITE.  Cost: as a rule that of four calls of algsurf_surface_value.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_hit_leave(const algsurf_surface *surface, const algsurf_ray *ray,
                                             const algsurf_hit *hit, int side, double start[3]);

/* Many rays, in arrays of doubles or of floats.  Ray i is origin[0..2][i step] + t direction[0..2][i step],
 * t_min[i step] <= t <= t_max[i step], with directions of any length.  Arrays of structs need no copy: the
 * pointers are to the members of the first struct, and step is the struct's size in numbers. */
typedef struct algsurf_ray_packet {
    size_t size;                            /* sizeof(algsurf_ray_packet) */
    size_t count;                           /* of rays; the arrays may be null when it is 0 */
    const double *origin[3], *direction[3]; /* x, y, z */
    const double *t_min, *t_max;            /* null: 0 for all, infinity for all */
    const unsigned char *active; /* null: all; active[i] = 0: ray i is skipped, its numbers may be any, and
                                    its entries in the answers stay as they are */
    ptrdiff_t step;              /* from one ray's numbers to the next one's, in numbers; 0: 1.  Not of
                                    `active`, nor of the answers */
    const float *float_origin[3], *float_direction[3]; /* rays in floats: then there is no double */
    const float *float_t_min, *float_t_max;            /* null: as above */
} algsurf_ray_packet;

/* Where the answers go: entry i of each array is that member of ray i's algsurf_hit.  A null array is not
 * asked for. */
typedef struct algsurf_hit_packet {
    size_t size;                     /* sizeof(algsurf_hit_packet) */
    unsigned char *state;            /* an algsurf_hit_state each; not null */
    double *t, *t_lo, *t_hi;         /* along the ray as given */
    double *position[3], *normal[3]; /* x, y, z */
    int *multiplicity;               /* as in algsurf_hit */
    signed char *side, *reason;      /* likewise; a reason is an algsurf_status */
} algsurf_hit_packet;

/* The first hit of each ray of a packet inside the extent, as algsurf_intersect_first returns it.
 *   rays     any number of them; they cost least if neighbours are similar
 *   options  as for one ray, without an observer.  With another method than the default, or a limit of
 *            iterations, the rays are solved one by one; a tolerance makes packets no faster
 *   hits     arrays that overlap neither each other nor those of the rays
 * Guarantee: every bit is that of the single call, whatever the kernel, and whatever else is in the packet.
 * Errors: those of the single call for extent and options, and E_ARGUMENT (null, an observer, doubles and
 * floats at once): nothing is written.  A bad ray is REFUSED, its reason the error of the single call, the
 * rest that of a miss.  E_NO_MEMORY: rays that lack memory are UNDECIDED, whatever undecided_as says, their
 * reason UNDECIDED_RANGE, [t_lo, t_hi] the whole ray.  In both cases all others are answered, and the first
 * such error is returned.
 * Cost: 0.05 to 0.4 microseconds a ray for degrees 2 to 10, in packets of 8 rays or more, with 4 or 8 of them
 * side by side (AVX2, AVX-512).  A ray that doubles leave undecided costs a single call besides.  An endless
 * ray is searched as far as the surface may reach, and is no slower than in an extent about the surface.
 * Packets with a step, floats or bad rays are copied piece by piece.
 * Source: values at Chebyshev's nodes, converted to the Bernstein basis; Descartes' rule; Newton's method;
 * all for several rays at once.  50 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_intersect_packet(const algsurf_surface *surface,
                                                    const algsurf_extent *extent,
                                                    const algsurf_ray_packet *rays,
                                                    const algsurf_intersect_options *options,
                                                    const algsurf_hit_packet *hits);

/* Is there any hit on each ray of a packet?  The answers are those of algsurf_occluded.
 *   state  receives an algsurf_hit_state for each active ray
 * Errors, guarantee: as above.  Cost: two thirds of the above.  50 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_occluded_packet(const algsurf_surface *surface,
                                                   const algsurf_extent *extent,
                                                   const algsurf_ray_packet *rays,
                                                   const algsurf_intersect_options *options,
                                                   unsigned char *state);

/* The visible part of complex space. */
typedef struct algsurf_complex_space {
    size_t size;             /* sizeof(algsurf_complex_space) */
    algsurf_sector sector;   /* of the arguments of t that count */
    const double *imaginary; /* imaginary[k], times i, is added to the coefficient of t^k for k less than
                                imaginary_count; 0 for k above the surface's degree.  Null with count 0:
                                nothing is added */
    size_t imaginary_count;  /* at most ALGSURF_MAX_DEGREE + 1 */
} algsurf_complex_space;

/* The first hit in complex space.  The polynomial along the ray, p(t) = P(origin + t direction)
 * + i sum_k imaginary[k] t^k, has degree-many complex roots t.  A root counts if its argument lies in the
 * sector and its magnitude in [t_min, t_max], the part of the ray inside the extent with t_min >= 0.  Of the
 * roots that count, the one of least magnitude is shown.
 *   extent null: all of space
 *   start  null, or degree-many start values for the roots t, for example those of a neighbouring ray: they
 *          change the time, not the answer
 *   roots  null, or room for degree-many roots t as found (approximate), which a neighbouring ray can start
 *          with; if fewer are found, the others are NaN, which as start values do nothing.  May be start
 *   hit    hit->t is |t|, position is origin + |t| direction, [t_lo,t_hi] encloses |t|.  normal is the unit
 *          normal of the surface that is shown, which consists of the points origin + |t| direction for all
 *          directions from that origin.  If t and p'(t) are real it has the direction of P's gradient.
 *          Otherwise it is Re(g / p'(t)), g the complex gradient of P at origin + t direction, corrected
 *          along the ray and normalised.  For a multiple root it is 0.  state UNDECIDED: it is open whether
 *          a root is in the sector and in range, or which one is the least; the hit is then the least root
 *          that may be the one
 *   root   the complex root t shown, NaN for a miss; may be null
 * There are no options: of algsurf_intersect_options only planes would play a part; algsurf_ray_clip gives
 * the part of the ray that they keep.  Pictures cut complex space, too (algsurf_scene_set_clip).
 * Errors: E_ARGUMENT (null, bad ray, extent, sector or imaginary parts; t_min < 0 is taken as 0),
 * E_NOT_FINITE, E_NO_MEMORY (the ray is then UNDECIDED).  Cost: that of algsurf_complex_roots, 2 to 10
 * microseconds for degrees 4 to 10.  34 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_intersect_complex(const algsurf_surface *surface,
                                                     const algsurf_extent *extent, const algsurf_ray *ray,
                                                     const algsurf_complex_space *space,
                                                     const algsurf_complex *start, algsurf_complex *roots,
                                                     algsurf_hit *hit, algsurf_complex *root);

#ifdef __cplusplus
}
#endif
#endif
