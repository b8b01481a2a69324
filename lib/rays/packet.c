/* packet.c - first hits and occlusion of many rays: checked, solved by the packet code, and what that leaves
 * undecided one by one.
 *
 * The packet code (packet_template.h) reads the caller's arrays and writes the answers it is sure of; of the
 * others it writes ALGSURF_LANE_UNDECIDED as state.  Those rays go on to intersect.c, and so do all rays of
 * calls that the packet code is not made for.  No answer depends on what else is in a packet, so a ray has
 * the same bits alone as in company; and packets that are no arrays of doubles, or have bad rays in them, go
 * piece by piece. */
#include "../base/arithmetic.h"
#include <math.h>

#include "../base/fpenv.h"
#include "intersect_impl.h"
#include "../base/options.h"
#include "../surface/impl.h"

const char *algsurf_kernel_name(int index) {
    const algsurf_i_kernel *kernel = algsurf_i_kernel_at(index);
    return kernel ? kernel->name : NULL;
}

enum { PIECE = 32 };

/* Some rays of a packet as doubles, side by side; those that are refused are not active. */
typedef struct piece {
    double number[8][PIECE];
    unsigned char active[PIECE];
    signed char side[PIECE]; /* of the answers */
} piece;

/* A number of an array of doubles or floats, one of which is null; where both are, what is meant by that. */
static double number_at(const double *doubles, const float *floats, ptrdiff_t at, double otherwise) {
    return doubles ? doubles[at] : floats ? floats[at] : otherwise;
}

static algsurf_ray ray_of(const algsurf_ray_packet *rays, size_t i) {
    const ptrdiff_t at = (ptrdiff_t)i * (rays->step ? rays->step : 1);
    algsurf_ray ray;
    for (int k = 0; k < 3; k++) {
        ray.origin[k] = number_at(rays->origin[k], rays->float_origin[k], at, 0);
        ray.direction[k] = number_at(rays->direction[k], rays->float_direction[k], at, 0);
    }
    ray.t_min = number_at(rays->t_min, rays->float_t_min, at, 0);
    ray.t_max = number_at(rays->t_max, rays->float_t_max, at, INFINITY);
    return ray;
}

static int is_active(const algsurf_ray_packet *rays, size_t i) { return !rays->active || rays->active[i]; }

/* Can the packet code read the arrays, and are all rays certainly good ones?  Without branches. */
static int all_good(const algsurf_ray_packet *rays) {
    int good = (rays->step == 0 || rays->step == 1) && rays->origin[0];
    if (!good) return 0;
    for (size_t i = 0; i < rays->count; i++) {
        double size = 0, zero = 0;
        for (int k = 0; k < 3; k++) {
            zero += 0 * rays->origin[k][i] + 0 * rays->direction[k][i]; /* NaN unless both are finite */
            size += fabs(rays->direction[k][i]);
        }
        good &= (zero == 0) & (size > 0);
        if (rays->t_min) good &= rays->t_min[i] == rays->t_min[i];
        if (rays->t_max) good &= rays->t_max[i] == rays->t_max[i];
    }
    return good;
}

/* Doubles or floats, not both, and no origin or direction is missing. */
static int has_arrays(const algsurf_ray_packet *rays) {
    int doubles = 0, floats = 0;
    for (int k = 0; k < 3; k++) {
        doubles += (rays->origin[k] != NULL) + (rays->direction[k] != NULL);
        floats += (rays->float_origin[k] != NULL) + (rays->float_direction[k] != NULL);
    }
    return rays->count == 0 || (doubles == 6 && !floats && !rays->float_t_min && !rays->float_t_max) ||
           (floats == 6 && !doubles && !rays->t_min && !rays->t_max);
}

static const algsurf_i_rays_kernel *packet_code(const algsurf_i_query *q) {
    int narrow = q->kernel->index == ALGSURF_AVX512 && q->surface->degree > ALGSURF_MAX_WIDE_DEGREE;
    return algsurf_i_rays_kernel_for(narrow ? algsurf_i_kernel_at(1) : q->kernel);
}

/* The states of active rays; of certain hits everything. */
static void solve_together(const algsurf_i_query *q, const algsurf_ray_packet *rays, int any,
                           const algsurf_hit_packet *hits) {
    if (!q->fits_lanes || q->has_method) {
        for (size_t i = 0; i < rays->count; i++)
            if (is_active(rays, i)) hits->state[i] = ALGSURF_LANE_UNDECIDED;
        return;
    }
    algsurf_i_rays_job job = q->job;
    job.rays = rays;
    job.any = any;
    packet_code(q)->solve(&job, hits);
}

static void store_hit(const algsurf_hit_packet *hits, size_t i, const algsurf_hit *hit) {
    hits->state[i] = (unsigned char)hit->state;
    if (hits->reason) hits->reason[i] = (signed char)hit->reason;
    if (hits->multiplicity) hits->multiplicity[i] = hit->multiplicity;
    if (hits->side) hits->side[i] = (signed char)hit->side;
    if (hits->t) hits->t[i] = hit->t;
    if (hits->t_lo) hits->t_lo[i] = hit->t_lo;
    if (hits->t_hi) hits->t_hi[i] = hit->t_hi;
    for (int k = 0; k < 3; k++) {
        if (hits->position[k]) hits->position[k][i] = hit->position[k];
        if (hits->normal[k]) hits->normal[k][i] = hit->normal[k];
    }
}

/* Lanes have answered for Q. */
static ALGSURF_NOINLINE void answer_for_power(const algsurf_i_query *q, const algsurf_ray_packet *rays,
                                              const algsurf_hit_packet *hits) {
    for (size_t i = 0; i < rays->count; i++) {
        if (!is_active(rays, i) || hits->state[i] == ALGSURF_LANE_UNDECIDED) continue;
        algsurf_hit hit = {.multiplicity = hits->multiplicity ? hits->multiplicity[i] : 0,
                           .side = hits->side ? hits->side[i] : 0};
        for (int k = 0; k < 3; k++) hit.normal[k] = hits->normal[k] ? hits->normal[k][i] : 0;
        algsurf_i_hit_of_power(q, &hit);
        if (hits->multiplicity) hits->multiplicity[i] = hit.multiplicity;
        if (hits->side) hits->side[i] = (signed char)hit.side;
        for (int k = 0; k < 3; k++)
            if (hits->normal[k]) hits->normal[k][i] = hit.normal[k];
    }
}

static int lacks_normal(const algsurf_hit_packet *hits, size_t i) {
    int open = 0;
    for (int k = 0; k < 3; k++) open |= hits->normal[k] && isnan(hits->normal[k][i]);
    return open && hits->state[i] == ALGSURF_STATE_HIT;
}

/* The rays, and the normals, that packets leave undecided, one by one. */
static ALGSURF_NOINLINE algsurf_status finish(const algsurf_i_query *q, const algsurf_ray_packet *rays,
                                              int any, const algsurf_hit_packet *hits, uint64_t *exact) {
    algsurf_status status = ALGSURF_OK, one;
    for (size_t i = 0; i < rays->count; i++) {
        const int left = hits->state[i] == ALGSURF_LANE_UNDECIDED;
        if (!is_active(rays, i)) continue;
        if (hits->reason) hits->reason[i] = ALGSURF_OK;
        if (!left && !lacks_normal(hits, i)) continue;
        const algsurf_ray ray = ray_of(rays, i);
        algsurf_hit hit = {.state = ALGSURF_STATE_UNDECIDED};
        if (!left) {
            (void)algsurf_i_first_hit(q, &ray, 0, &hit, NULL);
            for (int k = 0; k < 3; k++)
                if (hits->normal[k]) hits->normal[k][i] = hit.normal[k];
            continue;
        }
        if (!any) /* so it stays without memory */
            algsurf_i_set_undecided(&ray, ray.t_min, ray.t_max, ALGSURF_UNDECIDED_RANGE, &hit);
        one = any ? algsurf_i_occluded(q, &ray, 1, &hit.state)
                  : algsurf_i_first_hit(q, &ray, !q->has_method, &hit, exact);
        if (one != ALGSURF_OK) status = one;
        store_hit(hits, i, &hit);
    }
    return status;
}

/* Rays that are good doubles, side by side. */
static algsurf_status answer(const algsurf_i_query *q, const algsurf_ray_packet *rays, int any,
                             const algsurf_hit_packet *hits, uint64_t *exact) {
    solve_together(q, rays, any, hits);
    if (q->power > 1 && !any) answer_for_power(q, rays, hits);
    return finish(q, rays, any, hits, exact);
}

/* ---- packets that are no such arrays, have bad rays, or do not ask for the sides that are needed ---- */

static int needs_sides(const algsurf_i_query *q, const algsurf_hit_packet *hits) {
    return q->power % 2 == 0 && !hits->side && (hits->normal[0] || hits->normal[1] || hits->normal[2]);
}

static algsurf_hit_packet hits_from(const algsurf_hit_packet *hits, size_t first) {
    algsurf_hit_packet from = *hits;
    double **const numbers[] = {&from.t,       &from.t_lo,        &from.t_hi,
                                from.position, from.position + 1, from.position + 2,
                                from.normal,   from.normal + 1,   from.normal + 2};
    from.state += first;
    if (from.reason) from.reason += first;
    if (from.multiplicity) from.multiplicity += first;
    if (from.side) from.side += first;
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        if (*numbers[i]) *numbers[i] += first;
    return from;
}

/* The rays from `first` on that fit into a piece; the first error of a bad one goes to *status. */
static algsurf_ray_packet take_piece(const algsurf_ray_packet *rays, size_t first, piece *p,
                                     const algsurf_hit_packet *hits, algsurf_status *status) {
    double(*x)[PIECE] = p->number;
    const size_t count = rays->count - first < PIECE ? rays->count - first : PIECE;
    for (size_t i = 0; i < count; i++) {
        p->active[i] = is_active(rays, first + i) != 0;
        if (!p->active[i]) continue;
        const algsurf_ray ray = ray_of(rays, first + i);
        for (int k = 0; k < 3; k++) x[k][i] = ray.origin[k], x[3 + k][i] = ray.direction[k];
        x[6][i] = ray.t_min, x[7][i] = ray.t_max;
        algsurf_status bad = algsurf_i_ray_check(&ray);
        if (bad == ALGSURF_OK) continue;
        algsurf_hit refused;
        algsurf_i_set_miss(&refused, 0);
        refused.state = ALGSURF_STATE_REFUSED, refused.reason = bad;
        store_hit(hits, i, &refused);
        p->active[i] = 0;
        if (*status == ALGSURF_OK) *status = bad;
    }
    return (algsurf_ray_packet){
        sizeof *rays, count, {x[0], x[1], x[2]}, {x[3], x[4], x[5]}, x[6], x[7], p->active, 0, {NULL}, {NULL},
        NULL,         NULL};
}

static ALGSURF_NOINLINE algsurf_status answer_in_pieces(const algsurf_i_query *q,
                                                        const algsurf_ray_packet *rays, int any,
                                                        const algsurf_hit_packet *hits, uint64_t *exact) {
    algsurf_status status = ALGSURF_OK;
    piece p;
    for (size_t first = 0; first < rays->count; first += PIECE) {
        algsurf_hit_packet to = hits_from(hits, first);
        if (!to.side) to.side = p.side;
        const algsurf_ray_packet some = take_piece(rays, first, &p, &to, &status);
        algsurf_status one = answer(q, &some, any, &to, exact);
        if (status == ALGSURF_OK) status = one;
    }
    return status;
}

/* ---- the calls ---- */

algsurf_status algsurf_i_intersect_packet(const algsurf_surface *surface, const algsurf_extent *extent,
                                          const algsurf_ray_packet *given,
                                          const algsurf_intersect_options *options, int any,
                                          const algsurf_hit_packet *to, uint64_t *exact) {
    algsurf_i_query q;
    algsurf_ray_packet rays;
    algsurf_hit_packet hits;
    algsurf_status status = algsurf_options_read(&hits, sizeof hits, to);
    if (status == ALGSURF_OK && !surface) status = ALGSURF_E_ARGUMENT;
    if (status == ALGSURF_OK) status = algsurf_options_read(&rays, sizeof rays, given);
    if (status == ALGSURF_OK && !has_arrays(&rays)) status = ALGSURF_E_ARGUMENT;
    if (status == ALGSURF_OK) status = algsurf_i_query_read(&q, surface, extent, options);
    if (status != ALGSURF_OK) return status;
    if (q.options.observer || (rays.count && !hits.state)) return ALGSURF_E_ARGUMENT;
    return all_good(&rays) && !needs_sides(&q, &hits) ? answer(&q, &rays, any, &hits, exact)
                                                      : answer_in_pieces(&q, &rays, any, &hits, exact);
}

ALGSURF_I_ENTRY(algsurf_status, intersect_packet,
                (const algsurf_surface *surface, const algsurf_extent *extent, const algsurf_ray_packet *rays,
                 const algsurf_intersect_options *options, const algsurf_hit_packet *hits),
                (surface, extent, rays, options, hits)) {
    return algsurf_i_intersect_packet(surface, extent, rays, options, 0, hits, NULL);
}

ALGSURF_I_ENTRY(algsurf_status, occluded_packet,
                (const algsurf_surface *surface, const algsurf_extent *extent, const algsurf_ray_packet *rays,
                 const algsurf_intersect_options *options, unsigned char *state),
                (surface, extent, rays, options, state)) {
    const algsurf_hit_packet hits = {.size = sizeof hits, .state = state};
    return algsurf_i_intersect_packet(surface, extent, rays, options, 1, &hits, NULL);
}
