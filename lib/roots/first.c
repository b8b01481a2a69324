/* first.c - first or all roots of many polynomials: solved side by side, and what stays undecided one by one;
 * and the first root of a single one.
 *
 * The packet code (first_template.h, all_template.h) writes the answers it is sure of, and
 * ALGSURF_LANE_UNDECIDED as state, or -1 as count, of the others.  Those are decided alone (line.c,
 * isolate.c), which also tells why a polynomial is refused.  To packets bad polynomials and intervals are
 * unsound, like intervals with an infinite end (centred_template.h).  On the whole line eight polynomials
 * share a call for the boxes that each would ask for by itself. */
#include "../base/arithmetic.h"
#include "algsurf/batch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "algsurf/isolate.h"
#include "../base/fpenv.h"
#include "../base/options.h"
#include "../complex/boxes.h"
#include "../poly/value.h"
#include "line.h"
#include "polys.h"

static double begin_of(const algsurf_real_batch *p, size_t i) {
    return p->lo ? p->lo[(ptrdiff_t)i * p->interval_step] : -HUGE_VAL;
}

static double end_of(const algsurf_real_batch *p, size_t i) {
    return p->hi ? p->hi[(ptrdiff_t)i * p->interval_step] : HUGE_VAL;
}

/* c, r: room for the coefficients and, if there are any, radii. */
static algsurf_i_coefficients read_one(const algsurf_real_batch *p, size_t i, double *c, double *r) {
    algsurf_i_table_row(&p->coefficients, p->degree, i, c, 1);
    if (p->radii.at) algsurf_i_table_row(&p->radii, p->degree, i, r, 1);
    return (algsurf_i_coefficients){c, p->radii.at ? r : NULL, p->degree};
}

/* A job without answers, and who does it. */
static algsurf_status read_batch(algsurf_i_polys_job *job, const algsurf_i_kernel **kernel,
                                 const algsurf_real_batch *batch, const algsurf_batch_options *options) {
    algsurf_batch_options o = {.size = sizeof o};
    *job = (algsurf_i_polys_job){.state = NULL};
    algsurf_status status = algsurf_options_read(&job->p, sizeof job->p, batch);
    if (status == ALGSURF_OK && options) status = algsurf_options_read(&o, sizeof o, options);
    const double tolerance = job->tolerance = o.relative_tolerance;
    if (status == ALGSURF_OK) status = algsurf_i_check_number(tolerance, tolerance >= 0 && tolerance < 1);
    if (status == ALGSURF_OK) status = algsurf_i_check_degree(job->p.degree);
    if (status != ALGSURF_OK) return status;
    *kernel = algsurf_i_kernel_find(o.kernel);
    return *kernel && (job->p.count == 0 || job->p.coefficients.at) ? ALGSURF_OK : ALGSURF_E_ARGUMENT;
}

/* The middle of a place; of an infinite one an end that is finite, or 0. */
static double point_of(const algsurf_bracket *b) {
    if (isfinite(b->lo) && isfinite(b->hi)) return 0.5 * b->lo + 0.5 * b->hi;
    return isfinite(b->lo) ? b->lo : isfinite(b->hi) ? b->hi : 0;
}

/* Roots of one exact polynomial; boxes: all of its roots, or null. */
static ALGSURF_NOINLINE algsurf_status find_alone(const algsurf_real_batch *polys, size_t i, int wanted,
                                                  const algsurf_complex_root *boxes, algsurf_real_root *roots,
                                                  int *count) {
    double c[ALGSURF_MAX_POLY_DEGREE + 1];
    algsurf_i_line line = {
        .lo = begin_of(polys, i), .hi = end_of(polys, i), .wanted = wanted, .refined = 1, .boxes = boxes};
    line.p = read_one(polys, i, c, NULL);
    algsurf_status status = algsurf_i_check_interval(line.lo, line.hi);
    if (status == ALGSURF_OK) status = algsurf_i_check_coefficients(&line.p);
    return status == ALGSURF_OK ? algsurf_i_line_solve(&line, roots, count) : status;
}

/* The first root; room for all of them is allocated where the stack has none. */
static algsurf_status solve_exact(const algsurf_real_batch *polys, size_t i, int *found, double *where) {
    algsurf_real_root few[ALGSURF_MAX_DEGREE], *roots = few;
    if (polys->degree > ALGSURF_MAX_DEGREE) roots = malloc((size_t)polys->degree * sizeof *roots);
    if (!roots) return ALGSURF_E_NO_MEMORY;
    algsurf_status status = find_alone(polys, i, ALGSURF_I_FIRST, NULL, roots, found);
    if (status == ALGSURF_OK && *found) *where = roots->root;
    if (roots != few) free(roots);
    return status;
}

/* Of the set of polynomials within the radii the first place with roots, as narrow as they allow; positive
 * where it is undecided. */
static ALGSURF_NOINLINE algsurf_status solve_set(const algsurf_real_batch *polys, size_t i, int *found,
                                                 double *where) {
    double c[ALGSURF_MAX_POLY_DEGREE + 1], r[ALGSURF_MAX_POLY_DEGREE + 1];
    const algsurf_i_coefficients p = read_one(polys, i, c, r);
    algsurf_bracket b, narrow;
    int some = 0;
    algsurf_status status =
        algsurf_isolate_first(c, r, p.degree, begin_of(polys, i), end_of(polys, i), NULL, &b, found);
    if (status < 0 || !*found) return status;
    *where = point_of(&b);
    if (b.kind == ALGSURF_BRACKET_UNDECIDED) return status;
    status = algsurf_i_decide_ranges(&p, b.lo, b.hi, &narrow, 1, &some, NULL);
    if (some) *where = point_of(&narrow);
    return status;
}

/* One polynomial alone. */
static algsurf_status solve_alone(const algsurf_real_batch *polys, size_t i, unsigned char *state,
                                  double *root) {
    double where = HUGE_VAL;
    int found = 0;
    algsurf_status status = (polys->radii.at ? solve_set : solve_exact)(polys, i, &found, &where);
    state[i] = status > 0 || status == ALGSURF_E_NO_MEMORY ? ALGSURF_FIRST_ROOT_UNDECIDED
               : status < 0                                ? ALGSURF_FIRST_ROOT_REFUSED
               : found                                     ? ALGSURF_FIRST_ROOT_FOUND
                                                           : ALGSURF_FIRST_ROOT_NONE;
    if (root) root[i] = status < 0 ? HUGE_VAL : where;
    return status < 0 ? status : ALGSURF_OK;
}

static int has_kernel(const algsurf_real_batch *p) {
    return p->degree >= 1 && p->degree <= ALGSURF_MAX_POLYS_DEGREE && p->lo && p->hi;
}

static algsurf_status first_roots(const algsurf_real_batch *batch, const algsurf_batch_options *options,
                                  unsigned char *state, double *root) {
    algsurf_i_polys_job job;
    const algsurf_i_kernel *kernel;
    algsurf_status first = read_batch(&job, &kernel, batch, options);
    const algsurf_real_batch *p = &job.p;
    if (first != ALGSURF_OK || p->count == 0) return first;
    if (!state) return ALGSURF_E_ARGUMENT;
    job.state = state;
    job.root = root;
    if (has_kernel(p)) {
        if (!algsurf_i_roots_kernel_for(kernel)->solve(&job)) return ALGSURF_OK;
    } else {
        memset(state, ALGSURF_LANE_UNDECIDED, p->count);
    }
    const unsigned char *undecided = state, *end = state + p->count;
    while ((undecided = memchr(undecided, ALGSURF_LANE_UNDECIDED, (size_t)(end - undecided)))) {
        algsurf_status status = solve_alone(p, (size_t)(undecided - state), state, root);
        if (first == ALGSURF_OK) first = status;
        undecided++;
    }
    return first;
}

/* Boxes about all roots of some polynomials, side by side: their roots on the whole line are among them. */
enum { BLOCK = 8, LEAST_DEGREE = 3, MOST_DEGREE = 12 }; /* below: formulas; above, one alone fills lanes */
typedef struct box_block {
    algsurf_complex_root box[BLOCK * MOST_DEGREE];
    int found[BLOCK];
} box_block;

static int is_by_boxes(const algsurf_real_batch *p) {
    return p->degree >= LEAST_DEGREE && p->degree <= MOST_DEGREE &&
           (p->interval_step == 0 || (!p->lo && !p->hi)) && begin_of(p, 0) == -HUGE_VAL &&
           end_of(p, 0) == HUGE_VAL;
}

static void fill_block(const algsurf_real_batch *p, const algsurf_i_kernel *kernel, size_t first,
                       box_block *block) {
    const size_t left = p->count - first;
    const algsurf_table real = {NULL, 0, 0};
    algsurf_table c = p->coefficients;
    c.at += (ptrdiff_t)first * c.polynomial;
    algsurf_i_allroots_kernel_for(kernel)->many(&c, &real, p->degree, left < BLOCK ? left : BLOCK, block->box,
                                                block->found);
}

ALGSURF_I_ENTRY(algsurf_status, real_roots_batch,
                (const algsurf_real_batch *batch, const algsurf_batch_options *options,
                 algsurf_real_root *roots, int *count),
                (batch, options, roots, count)) {
    algsurf_i_polys_job job;
    const algsurf_i_kernel *kernel;
    algsurf_status first = read_batch(&job, &kernel, batch, options);
    const algsurf_real_batch *p = &job.p;
    if (first != ALGSURF_OK || p->count == 0) return first;
    if (!roots || !count || p->radii.at || job.tolerance != 0) return ALGSURF_E_ARGUMENT;
    job.roots = roots;
    job.found = count;
    box_block block;
    const int by_boxes = is_by_boxes(p), in_packets = has_kernel(p) && !by_boxes;
    if (in_packets) algsurf_i_roots_kernel_for(kernel)->solve_all(&job);
    for (size_t i = 0; i < p->count; i++) {
        if (in_packets && count[i] >= 0) continue;
        int room = p->degree > 0 ? p->degree : 1, found = 0;
        const size_t at = i % BLOCK;
        if (by_boxes && at == 0) fill_block(p, kernel, i, &block);
        const algsurf_complex_root *boxes =
            by_boxes && block.found[at] == p->degree ? block.box + at * (size_t)p->degree : NULL;
        algsurf_status status = find_alone(p, i, ALGSURF_I_ALL, boxes, roots + i * (size_t)room, &found);
        count[i] = status == ALGSURF_OK ? found : (int)status;
        if (first == ALGSURF_OK) first = status;
    }
    return first;
}

/* The batch of one. */
ALGSURF_I_ENTRY(algsurf_status, real_root_first,
                (const double *c, int degree, double lo, double hi, double *root, int *found),
                (c, degree, lo, hi, root, found)) {
    const algsurf_real_batch one = {
        .size = sizeof one, .count = 1, .degree = degree, .coefficients = {c, 1, 0}, .lo = &lo, .hi = &hi};
    unsigned char state;
    double where;
    if (!root || !found) return ALGSURF_E_ARGUMENT;
    algsurf_status status = first_roots(&one, NULL, &state, &where);
    if (status != ALGSURF_OK) return status;
    *found = state == ALGSURF_FIRST_ROOT_FOUND;
    if (*found) *root = where;
    return ALGSURF_OK;
}

ALGSURF_I_ENTRY(algsurf_status, first_roots_batch,
                (const algsurf_real_batch *batch, const algsurf_batch_options *options, unsigned char *state,
                 double *root),
                (batch, options, state, root)) {
    return first_roots(batch, options, state, root);
}
