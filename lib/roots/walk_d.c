/* walk_d.c - the walk in double: the path almost every polynomial takes. */
#include <math.h>

#include "isolate_impl.h"

#define NUMBER double
#define UNIT ALGSURF_U
#define CLUSTERS 0          /* they are left to double-double */
#define FLOOR (WHOLE >> 44) /* near the width at which the signs in a cell are all rounding */
#define WALK algsurf_i_walk_d
#define WALK_BEGIN algsurf_i_walk_begin_d
#define WALK_NEXT algsurf_i_walk_next_d

static inline double num_add(double a, double b) { return a + b; }
static inline double num_mul(double a, double b) { return a * b; }
static inline double num_mul_d(double a, double b) { return a * b; }
static inline double num_ratio(double a, int m) { return a / m; }
static inline double num_quotient(int64_t a, int64_t b) { return (double)a / (double)b; }
static inline double num_from(double a) { return a; }
static inline double num_from_dd(algsurf_dd a) { return a.hi; }
static inline double num_hi(double a) { return a; }

#include "walk_template.h"
