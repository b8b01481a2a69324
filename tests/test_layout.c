/* test_layout.c - what compiled callers rely on: the size of every public struct, where its members lie, and
 * the numbers of the enumerators, as released.  The values are part of the ABI: lines are added, never
 * changed. A struct that starts with its size may grow at its end (GROWS), a limit may become larger (LIMIT);
 * lib/algsurf.map says how. Breaks caught: a member added, moved or given another type, an enumerator
 * renumbered, a limit made smaller.  check_symbols demands that every struct of the headers is here. */
#include "algsurf/algsurf.h"
#include "unit.h"

typedef struct fact {
    const char *what;
    long long now, released;
    int may_grow;
} fact;

#define SIZE(type, bytes)                                                                                    \
    { "the size of " #type, (long long)sizeof(type), bytes, 0 }
#define GROWS(type, bytes)                                                                                   \
    { "the size of " #type, (long long)sizeof(type), bytes, 1 }
#define AT(type, member, bytes)                                                                              \
    { "the place of " #type "." #member, (long long)offsetof(type, member), bytes, 0 }
#define NUMBER(name, value)                                                                                  \
    { "the number of " #name, name, value, 0 }
#define LIMIT(name, value)                                                                                   \
    { "the limit " #name, name, value, 1 }

/* clang-format off */
static const fact structs[] = { /* in bytes; int has 32 bits, size_t, double and pointers have 64 */
    SIZE(algsurf_complex, 16),
    AT(algsurf_complex, re, 0), AT(algsurf_complex, im, 8),
    SIZE(algsurf_interval, 16),
    AT(algsurf_interval, lo, 0), AT(algsurf_interval, hi, 8),
    SIZE(algsurf_cinterval, 32),
    AT(algsurf_cinterval, re, 0), AT(algsurf_cinterval, im, 16),
    SIZE(algsurf_real_root, 32),
    AT(algsurf_real_root, root, 0), AT(algsurf_real_root, lo, 8), AT(algsurf_real_root, hi, 16),
    AT(algsurf_real_root, multiplicity, 24), AT(algsurf_real_root, sign, 28),
    SIZE(algsurf_integer, 16),
    AT(algsurf_integer, limbs, 0), AT(algsurf_integer, length, 8),
    SIZE(algsurf_bracket, 32),
    AT(algsurf_bracket, lo, 0), AT(algsurf_bracket, hi, 8), AT(algsurf_bracket, kind, 16),
    AT(algsurf_bracket, sign, 20), AT(algsurf_bracket, multiplicity, 24), AT(algsurf_bracket, status, 28),
    GROWS(algsurf_cell, 40),
    AT(algsurf_cell, lo, 0), AT(algsurf_cell, hi, 8), AT(algsurf_cell, variations, 16),
    AT(algsurf_cell, engine, 20), AT(algsurf_cell, degree, 24), AT(algsurf_cell, signs, 32),
    GROWS(algsurf_observer, 56),
    AT(algsurf_observer, size, 0), AT(algsurf_observer, on_cell, 8), AT(algsurf_observer, on_point, 16),
    AT(algsurf_observer, data, 24), AT(algsurf_observer, cells, 32),
    AT(algsurf_observer, evaluations, 40), AT(algsurf_observer, engine, 48),
    GROWS(algsurf_isolate_options, 16),
    AT(algsurf_isolate_options, size, 0), AT(algsurf_isolate_options, observer, 8),
    GROWS(algsurf_refine_options, 32),
    AT(algsurf_refine_options, size, 0), AT(algsurf_refine_options, method, 8),
    AT(algsurf_refine_options, max_iterations, 12), AT(algsurf_refine_options, absolute_tolerance, 16),
    AT(algsurf_refine_options, observer, 24),
    SIZE(algsurf_refined_root, 48),
    AT(algsurf_refined_root, root, 0), AT(algsurf_refined_root, lo, 8), AT(algsurf_refined_root, hi, 16),
    AT(algsurf_refined_root, residual, 24), AT(algsurf_refined_root, evaluations, 32), AT(algsurf_refined_root, iterations, 36),
    AT(algsurf_refined_root, converged, 40),
    SIZE(algsurf_table, 24),
    AT(algsurf_table, at, 0), AT(algsurf_table, power, 8), AT(algsurf_table, polynomial, 16),
    GROWS(algsurf_real_batch, 96),
    AT(algsurf_real_batch, size, 0), AT(algsurf_real_batch, count, 8),
    AT(algsurf_real_batch, degree, 16), AT(algsurf_real_batch, coefficients, 24), AT(algsurf_real_batch, radii, 48),
    AT(algsurf_real_batch, lo, 72), AT(algsurf_real_batch, hi, 80),
    AT(algsurf_real_batch, interval_step, 88),
    GROWS(algsurf_batch_options, 24),
    AT(algsurf_batch_options, size, 0), AT(algsurf_batch_options, kernel, 8),
    AT(algsurf_batch_options, relative_tolerance, 16),
    SIZE(algsurf_complex_root, 56),
    AT(algsurf_complex_root, box, 0), AT(algsurf_complex_root, root, 32),
    AT(algsurf_complex_root, multiplicity, 48), AT(algsurf_complex_root, real, 52),
    SIZE(algsurf_precise_root, 48),
    AT(algsurf_precise_root, re, 0), AT(algsurf_precise_root, im, 16),
    AT(algsurf_precise_root, exponent, 32), AT(algsurf_precise_root, radius, 36),
    AT(algsurf_precise_root, multiplicity, 40), AT(algsurf_precise_root, real, 44),
    GROWS(algsurf_complex_batch, 96),
    AT(algsurf_complex_batch, size, 0), AT(algsurf_complex_batch, count, 8),
    AT(algsurf_complex_batch, degree, 16), AT(algsurf_complex_batch, re, 24),
    AT(algsurf_complex_batch, im, 48), AT(algsurf_complex_batch, radii, 72),
    GROWS(algsurf_paper_options, 24),
    AT(algsurf_paper_options, size, 0), AT(algsurf_paper_options, relative_step, 8),
    AT(algsurf_paper_options, max_steps, 16), AT(algsurf_paper_options, max_inflations, 20),
    SIZE(algsurf_paper_zero, 72),
    AT(algsurf_paper_zero, box, 0), AT(algsurf_paper_zero, root, 32), AT(algsurf_paper_zero, verified, 48),
    AT(algsurf_paper_zero, unique, 52), AT(algsurf_paper_zero, converged, 56),
    AT(algsurf_paper_zero, steps, 60), AT(algsurf_paper_zero, inflations, 64),
    GROWS(algsurf_complex_solver_stats, 16), AT(algsurf_complex_solver_stats, size, 0),
    AT(algsurf_complex_solver_stats, iterations, 8), AT(algsurf_complex_solver_stats, retries, 12),
    SIZE(algsurf_sector, 16),
    AT(algsurf_sector, sigma, 0), AT(algsurf_sector, delta, 8),
    SIZE(algsurf_term, 24),
    AT(algsurf_term, i, 0), AT(algsurf_term, j, 4), AT(algsurf_term, k, 8), AT(algsurf_term, a, 16),
    SIZE(algsurf_constant, 16),
    AT(algsurf_constant, name, 0), AT(algsurf_constant, value, 8),
    SIZE(algsurf_parse_error, 24),
    AT(algsurf_parse_error, offset, 0), AT(algsurf_parse_error, length, 8),
    AT(algsurf_parse_error, message, 16),
    SIZE(algsurf_ray, 64),
    AT(algsurf_ray, origin, 0), AT(algsurf_ray, direction, 24), AT(algsurf_ray, t_min, 48),
    AT(algsurf_ray, t_max, 56),
    SIZE(algsurf_extent, 56),
    AT(algsurf_extent, kind, 0), AT(algsurf_extent, centre, 8), AT(algsurf_extent, size, 32),
    SIZE(algsurf_plane, 32),
    AT(algsurf_plane, normal, 0), AT(algsurf_plane, offset, 24),
    SIZE(algsurf_hit, 88),
    AT(algsurf_hit, state, 0), AT(algsurf_hit, reason, 4), AT(algsurf_hit, multiplicity, 8),
    AT(algsurf_hit, side, 12), AT(algsurf_hit, t, 16), AT(algsurf_hit, t_lo, 24), AT(algsurf_hit, t_hi, 32),
    AT(algsurf_hit, position, 40), AT(algsurf_hit, normal, 64),
    GROWS(algsurf_intersect_options, 88),
    AT(algsurf_intersect_options, size, 0), AT(algsurf_intersect_options, tier, 8),
    AT(algsurf_intersect_options, method, 12), AT(algsurf_intersect_options, max_iterations, 16),
    AT(algsurf_intersect_options, absolute_tolerance, 24), AT(algsurf_intersect_options, kernel, 32),
    AT(algsurf_intersect_options, undecided_as, 40), AT(algsurf_intersect_options, max_memory, 48),
    AT(algsurf_intersect_options, observer, 56), AT(algsurf_intersect_options, planes, 64),
    AT(algsurf_intersect_options, plane_count, 72), AT(algsurf_intersect_options, side, 80),
    GROWS(algsurf_ray_packet, 160),
    AT(algsurf_ray_packet, size, 0), AT(algsurf_ray_packet, count, 8), AT(algsurf_ray_packet, origin, 16),
    AT(algsurf_ray_packet, direction, 40), AT(algsurf_ray_packet, t_min, 64),
    AT(algsurf_ray_packet, t_max, 72), AT(algsurf_ray_packet, active, 80), AT(algsurf_ray_packet, step, 88),
    AT(algsurf_ray_packet, float_origin, 96), AT(algsurf_ray_packet, float_direction, 120),
    AT(algsurf_ray_packet, float_t_min, 144), AT(algsurf_ray_packet, float_t_max, 152),
    GROWS(algsurf_hit_packet, 112),
    AT(algsurf_hit_packet, size, 0), AT(algsurf_hit_packet, state, 8), AT(algsurf_hit_packet, t, 16),
    AT(algsurf_hit_packet, t_lo, 24), AT(algsurf_hit_packet, t_hi, 32),
    AT(algsurf_hit_packet, position, 40), AT(algsurf_hit_packet, normal, 64),
    AT(algsurf_hit_packet, multiplicity, 88), AT(algsurf_hit_packet, side, 96), AT(algsurf_hit_packet, reason, 104),
    GROWS(algsurf_complex_space, 40),
    AT(algsurf_complex_space, size, 0), AT(algsurf_complex_space, sector, 8),
    AT(algsurf_complex_space, imaginary, 24), AT(algsurf_complex_space, imaginary_count, 32),
    SIZE(algsurf_camera, 176),
    AT(algsurf_camera, eye, 0), AT(algsurf_camera, right, 24), AT(algsurf_camera, up, 48),
    AT(algsurf_camera, forward, 72), AT(algsurf_camera, half_height, 96),
    AT(algsurf_camera, kind, 104), AT(algsurf_camera, reserved, 112),
    GROWS(algsurf_material, 104), AT(algsurf_material, size, 0),
    AT(algsurf_material, outside, 8), AT(algsurf_material, inside, 32), AT(algsurf_material, diffuse, 56),
    AT(algsurf_material, ambient, 64), AT(algsurf_material, fill, 72), AT(algsurf_material, specular, 80),
    AT(algsurf_material, roughness, 88), AT(algsurf_material, haze, 96),
    SIZE(algsurf_light, 176),
    AT(algsurf_light, position, 0), AT(algsurf_light, colour, 24), AT(algsurf_light, edge_u, 48),
    AT(algsurf_light, edge_v, 72), AT(algsurf_light, samples_u, 96), AT(algsurf_light, samples_v, 100),
    AT(algsurf_light, kind, 104), AT(algsurf_light, reserved, 112),
    GROWS(algsurf_lighting, 120), AT(algsurf_lighting, size, 0),
    AT(algsurf_lighting, material, 8), AT(algsurf_lighting, lights, 16),
    AT(algsurf_lighting, light_count, 24), AT(algsurf_lighting, up, 32), AT(algsurf_lighting, forward, 56),
    AT(algsurf_lighting, centre, 80), AT(algsurf_lighting, radius, 104), AT(algsurf_lighting, bounded, 112),
    GROWS(algsurf_render_options, 48),
    AT(algsurf_render_options, size, 0), AT(algsurf_render_options, width, 8),
    AT(algsurf_render_options, height, 12), AT(algsurf_render_options, row_begin, 16),
    AT(algsurf_render_options, row_end, 20), AT(algsurf_render_options, threads, 24),
    AT(algsurf_render_options, progress, 32), AT(algsurf_render_options, progress_data, 40),
    GROWS(algsurf_picture, 64),
    AT(algsurf_picture, size, 0), AT(algsurf_picture, pixels, 8), AT(algsurf_picture, stride, 16),
    AT(algsurf_picture, format, 24), AT(algsurf_picture, t, 32), AT(algsurf_picture, normals, 40),
    AT(algsurf_picture, state, 48), AT(algsurf_picture, way, 56),
    GROWS(algsurf_render_stats, 184),
    AT(algsurf_render_stats, size, 0), AT(algsurf_render_stats, rays, 8),
    AT(algsurf_render_stats, hits, 16), AT(algsurf_render_stats, undecided, 24),
    AT(algsurf_render_stats, shadow_rays, 32), AT(algsurf_render_stats, solve_s, 40),
    AT(algsurf_render_stats, shade_s, 48), AT(algsurf_render_stats, total_s, 56),
    AT(algsurf_render_stats, threads, 64), AT(algsurf_render_stats, iterations, 72),
    AT(algsurf_render_stats, single_rays, 80), AT(algsurf_render_stats, expand_s, 88),
    AT(algsurf_render_stats, point_s, 96), AT(algsurf_render_stats, shadow_s, 104),
    AT(algsurf_render_stats, kernel, 112), AT(algsurf_render_stats, tiles, 120),
    AT(algsurf_render_stats, empty_tiles, 128), AT(algsurf_render_stats, sheet_tiles, 136),
    AT(algsurf_render_stats, leaf_tiles, 144), AT(algsurf_render_stats, empty_rays, 152),
    AT(algsurf_render_stats, sheet_rays, 160), AT(algsurf_render_stats, exact_rays, 168),
    AT(algsurf_render_stats, thin, 176),
};

static const fact numbers[] = { /* those of algsurf_status are in test_status.c */
    NUMBER(ALGSURF_BRACKET_ISOLATED, 0), NUMBER(ALGSURF_BRACKET_EXACT, 1), NUMBER(ALGSURF_BRACKET_UNDECIDED, 2),
    NUMBER(ALGSURF_METHOD_DEFAULT, 0), NUMBER(ALGSURF_METHOD_BRENT, 1), NUMBER(ALGSURF_METHOD_BISECTION, 2),
    NUMBER(ALGSURF_METHOD_REGULA_FALSI, 3),
    NUMBER(ALGSURF_ENGINE_NONE, 0), NUMBER(ALGSURF_ENGINE_DOUBLES, 1), NUMBER(ALGSURF_ENGINE_INTEGERS, 2),
    NUMBER(ALGSURF_SIGN_NEGATIVE, -1), NUMBER(ALGSURF_SIGN_ZERO, 0), NUMBER(ALGSURF_SIGN_POSITIVE, 1),
    NUMBER(ALGSURF_SIGN_UNDECIDED, 2),
    NUMBER(ALGSURF_FIRST_ROOT_NONE, 0), NUMBER(ALGSURF_FIRST_ROOT_FOUND, 1),
    NUMBER(ALGSURF_FIRST_ROOT_UNDECIDED, 2), NUMBER(ALGSURF_FIRST_ROOT_REFUSED, 4),
    NUMBER(ALGSURF_SELECTED_NONE, 0), NUMBER(ALGSURF_SELECTED_ONE, 1),
    NUMBER(ALGSURF_SELECTED_UNDECIDED, 2),
    NUMBER(ALGSURF_EXTENT_ALL, 0), NUMBER(ALGSURF_EXTENT_SPHERE, 1), NUMBER(ALGSURF_EXTENT_BOX, 2),
    NUMBER(ALGSURF_CAMERA_PINHOLE, 0), NUMBER(ALGSURF_CAMERA_ORTHOGRAPHIC, 1),
    NUMBER(ALGSURF_LIGHT_AREA, 0),
    NUMBER(ALGSURF_PART_ALL, 0), NUMBER(ALGSURF_PART_SINGULAR, 1),
    NUMBER(ALGSURF_TIER_CERTIFIED, 0), NUMBER(ALGSURF_TIER_BOUNDED, 1),
    NUMBER(ALGSURF_AS_UNDECIDED, 0), NUMBER(ALGSURF_AS_HIT, 1), NUMBER(ALGSURF_AS_MISS, 2),
    NUMBER(ALGSURF_STATE_MISS, 0), NUMBER(ALGSURF_STATE_HIT, 1), NUMBER(ALGSURF_STATE_UNDECIDED, 2), NUMBER(ALGSURF_STATE_THIN, 3), NUMBER(ALGSURF_STATE_REFUSED, 4),
    NUMBER(ALGSURF_RGB8, 0), NUMBER(ALGSURF_RGBA8, 1),
    NUMBER(ALGSURF_WAY_EMPTY, 0), NUMBER(ALGSURF_WAY_SHEET, 1), NUMBER(ALGSURF_WAY_ROW, 2),
    NUMBER(ALGSURF_WAY_SINGLE, 3),
    NUMBER(ALGSURF_QUALITY_PREVIEW, 0), NUMBER(ALGSURF_QUALITY_STANDARD, 1),
    NUMBER(ALGSURF_QUALITY_FULL, 2),
    NUMBER(ALGSURF_COHERENCE_NONE, 0), NUMBER(ALGSURF_COHERENCE_NEIGHBOURS, 1),
    NUMBER(ALGSURF_MAX_LIGHTS, 16), /* algsurf_scene_get_lighting may write as many */
    NUMBER(ALGSURF_MAX_DEGREE, 64), NUMBER(ALGSURF_MAX_POLY_DEGREE, 512), LIMIT(ALGSURF_MAX_LIMBS, 16384),
    LIMIT(ALGSURF_MAX_CLIP_PLANES, 8), LIMIT(ALGSURF_MAX_ROOT_BITS, 1000000),
};
/* clang-format on */

static void check(const fact *facts, size_t count) {
    int wrong = 0;
    for (size_t i = 0; i < count; i++) {
        const fact *f = &facts[i];
        if (f->may_grow ? f->now >= f->released : f->now == f->released) continue;
        print_error("%s is %lld, released with %lld\n", f->what, f->now, f->released);
        wrong++;
    }
    assert_int_equal(wrong, 0);
}

TEST(test_structs) {
    if (sizeof(int) != 4 || sizeof(size_t) != 8 || sizeof(double) != 8 || sizeof(void *) != 8) skip();
    check(structs, sizeof structs / sizeof structs[0]);
}

TEST(test_numbers) { check(numbers, sizeof numbers / sizeof numbers[0]); }
