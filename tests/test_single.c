/* test_single.c - hits of one ray in one lane: the first has the bits of the packets, and all methods agree.
 *
 * Roots themselves are judged in test_intersect and its kin: the public calls go this way.
 */
#include "catalogue.h"
#include "rays/packets.h"
#include "scenes.h"

#define SEED 20261122u
enum { RAYS = 60 };

/* What a ray meets, by the packets; 0: they leave it undecided. */
static int first_of_packet(const algsurf_i_rays_job *job, algsurf_hit *hit) {
    uint8_t state = ALGSURF_LANE_MISS;
    signed char side = 0;
    const algsurf_hit_packet to = {.state = &state,
                                   .side = &side,
                                   .t = &hit->t,
                                   .t_lo = &hit->t_lo,
                                   .t_hi = &hit->t_hi,
                                   .position = {hit->position, hit->position + 1, hit->position + 2},
                                   .normal = {hit->normal, hit->normal + 1, hit->normal + 2}};
    memset(hit, 0, sizeof *hit);
    algsurf_i_rays_kernel_for(algsurf_i_kernel_find(NULL))->solve(job, &to);
    hit->state = state;
    hit->multiplicity = state == ALGSURF_LANE_HIT;
    hit->side = side;
    return state != ALGSURF_LANE_UNDECIDED;
}

/* By the code for single rays of every kernel: the same bits. */
static int all_of(const algsurf_i_rays_job *given, const algsurf_refine_options *how, int most,
                  algsurf_hit *hits) {
    algsurf_i_rays_job job = *given;
    algsurf_hit other[ALGSURF_MAX_DEGREE];
    const algsurf_i_kernel *kernel;
    int n = 0;
    for (int i = 0; (kernel = algsurf_i_kernel_at(i)); i++) {
        memset(other, 0, sizeof other);
        int count = algsurf_i_ray_kernel_for(kernel)->all(&job, how, most, i == 0 ? hits : other);
        if (i == 0) n = count;
        assert_int_equal(count, n);
        for (int k = 0; i > 0 && k < n; k++) {
            assert_memory_equal(&hits[k].t, &other[k].t, sizeof *hits - offsetof(algsurf_hit, t));
            assert_int_equal(hits[k].side, other[k].side);
        }
    }
    return n;
}

static void judge_ray(const catalogue_entry *entry, const algsurf_i_rays_job *job, int *decided) {
    algsurf_hit first, all[ALGSURF_MAX_DEGREE], other[ALGSURF_MAX_DEGREE];
    int n = all_of(job, NULL, entry->degree, all), known = first_of_packet(job, &first);
    if (n < 0) return;
    ++*decided;
    if (!known || n == 0) {
        assert_true(known && first.state == ALGSURF_STATE_MISS);
        return;
    }
    assert_memory_equal(&first, all, sizeof first);
    for (int i = 0; i < n; i++) {
        assert_true(all[i].t_lo <= all[i].t && all[i].t <= all[i].t_hi);
        if (i > 0) assert_true(all[i - 1].t < all[i].t && all[i - 1].t_hi <= all[i].t_hi);
    }
    for (int m = ALGSURF_METHOD_DEFAULT; m <= ALGSURF_METHOD_REGULA_FALSI; m++) {
        const algsurf_refine_options how = {sizeof how, (int)m, 0, 0, NULL};
        assert_int_equal(all_of(job, &how, entry->degree, other), n);
        for (int i = 0; i < n; i++) {
            assert_true(all[i].t_lo <= other[i].t_hi && other[i].t_lo <= all[i].t_hi);
            assert_true(m == ALGSURF_METHOD_REGULA_FALSI || /* which may stop early, see refine.h */
                        fabs(all[i].t - other[i].t) <= 1e-9 * fabs(all[i].t));
            assert_true(other[i].t_lo <= other[i].t && other[i].t <= other[i].t_hi);
        }
        assert_int_equal(all_of(job, &how, 1, other), 1);
    }
}

TEST(test_rays) {
    uint64_t random = SEED;
    for (const catalogue_entry *entry = catalogue; entry->name; entry++) {
        int decided = 0;
        algsurf_surface *s = surface_of(entry->equation);
        for (int i = 0; i < RAYS; i++) {
            double origin[3], direction[3], near = 0, far = INFINITY;
            for (int k = 0; k < 3; k++) {
                origin[k] = entry->extent.centre[k] + 3 * entry->extent.size[0] * random_unit(&random);
                direction[k] =
                    entry->extent.centre[k] - origin[k] + 0.5 * entry->extent.size[0] * random_unit(&random);
            }
            const algsurf_ray_packet rays = {.count = 1,
                                             .origin = {origin, origin + 1, origin + 2},
                                             .direction = {direction, direction + 1, direction + 2},
                                             .t_min = &near,
                                             .t_max = &far};
            const algsurf_i_rays_job job = {.surface = s, .extent = &entry->extent, .rays = &rays};
            judge_ray(entry, &job, &decided);
        }
        assert_true(decided > RAYS / 2);
    }
}
