/* walk_dd.c - the walk in double-double, for what double cannot decide. */
#include <math.h>

#include "isolate_impl.h"

#define NUMBER algsurf_dd
#define UNIT ALGSURF_DD_U
#define CLUSTERS 1
#define FLOOR (WHOLE >> 57) /* near the width at which the signs in a cell are all rounding */
#define WALK algsurf_i_walk_dd
#define WALK_BEGIN algsurf_i_walk_begin_dd
#define WALK_NEXT algsurf_i_walk_next_dd

static inline algsurf_dd num_add(algsurf_dd a, algsurf_dd b) { return algsurf_dd_add(a, b); }
static inline algsurf_dd num_mul(algsurf_dd a, algsurf_dd b) { return algsurf_dd_mul(a, b); }
static inline algsurf_dd num_mul_d(algsurf_dd a, double b) { return algsurf_dd_mul_d(a, b); }
static inline algsurf_dd num_ratio(algsurf_dd a, int m) { return algsurf_dd_div(a, algsurf_dd_from(m)); }
static inline algsurf_dd num_quotient(int64_t a, int64_t b) {
    return algsurf_dd_div(algsurf_i_dd_from_int(a), algsurf_i_dd_from_int(b));
}
static inline algsurf_dd num_from(double a) { return algsurf_dd_from(a); }
static inline algsurf_dd num_from_dd(algsurf_dd a) { return a; }
static inline double num_hi(algsurf_dd a) { return a.hi; }

#include "walk_template.h"
