/* test_masks.c - which pixels show the surface: pictures full of nodes and silhouettes, 1024x768, in the
 * tiers bounded and certified, at random pixels against exact arithmetic (exact_pixel.h).
 *
 * Half of the pixels are taken from outlines, where a neighbour shows something else.  Wrong is a miss where
 * the ray of the pixel has a root inside the extent, a hit where it has none (roots within ROOM rounding
 * errors of t at an end of the extent may count or not), and a hit elsewhere than at the first root.  In the
 * certified tier no pixel is undecided; in the bounded one they are counted, and a wrong one is one of those.
 *
 * Breaks tried, each caught: two variations of sign counted as none, the right half of a cell first, a check
 * of the cuts that show no root left out, rays a twentieth of a pixel aside, undecided rays dropped.  Not
 * caught: signs used within their error; test_render_exact aims at those.
 *
 *     test_masks [pixels [views [seed]]]     pixels a picture, views a surface; default: 300 and 3, and
 *                                            of each picture ROWS rows only
 */
#include "catalogue.h"
#include "exact_pixel.h"
#include "scenes.h"

enum { WIDTH = 1024, HEIGHT = 768, ROWS = 24, ROOM = 16, TIERS = 2 };

static int pixels = 300, views = 3, whole = 0;
static uint64_t first_seed = 20261122;

static const int tiers[TIERS] = {ALGSURF_TIER_BOUNDED, ALGSURF_TIER_CERTIFIED};

typedef struct view {
    const char *name;
    int number, row_begin, row_end;
    algsurf_surface *surface;
    algsurf_term *terms;
    int term_count;
    algsurf_extent extent;
    algsurf_camera camera;
    double distance; /* of the eye from the extent's centre */
} view;

static struct { long checked, outlines, hits, misses, ends, undecided, rays, excused, wrong; } seen;

static double hits[TIERS][WIDTH * HEIGHT];
static uint8_t bytes[3 * WIDTH * HEIGHT], is_excused[WIDTH * HEIGHT]; /* of one view, bounded tier */

static void set_surface(view *v, const char *equation) {
    v->surface = surface_of(equation);
    v->term_count = (int)algsurf_surface_term_count(v->surface);
    v->terms = unit_keep(calloc((size_t)v->term_count, sizeof *v->terms), free);
    assert_ok(algsurf_surface_terms(v->surface, v->terms));
}

/* From a random side, 1.1 to 8 radii away; the picture is as high as the extent, or as a hundredth of it. */
static void set_camera(view *v, uint64_t *seed) {
    double eye[3], at[3], length = 0, radius = v->extent.size[0], far = radius * random_between(seed, 1.1, 8);
    const double up[3] = {random_unit(seed), random_unit(seed), 1};
    for (int i = 0; i < 3; i++) {
        eye[i] = random_unit(seed);
        at[i] = v->extent.centre[i] + 0.4 * radius * random_unit(seed);
        length += eye[i] * eye[i];
    }
    for (int i = 0; i < 3; i++) eye[i] = v->extent.centre[i] + far * eye[i] / sqrt(length);
    double tangent = radius / far * pow(10, v->number % 2 ? random_between(seed, -2, 0) : 0);
    assert_ok(algsurf_camera_pinhole(eye, at, up, 2 * atan(tangent) * 57.29577951308232, &v->camera));
    v->distance = far;
}

static void draw(const view *v, int tier) {
    const algsurf_intersect_options how = {.size = sizeof how, .tier = tiers[tier]};
    const algsurf_render_options o = {
        .size = sizeof o, .width = WIDTH, .height = HEIGHT, .row_begin = v->row_begin, .row_end = v->row_end};
    const algsurf_picture planes = {.size = sizeof planes, .pixels = bytes, .t = hits[tier]};
    algsurf_render_stats stats = {.size = sizeof stats};
    algsurf_scene *scene = scene_of(v->surface, &v->extent, &v->camera, &how);
    assert_ok(algsurf_scene_set_lights(scene, NULL, 0));
    assert_ok(algsurf_render(scene, &o, &planes, &stats));
    seen.undecided += (long)stats.undecided, seen.rays += (long)stats.rays;
    if (stats.undecided >
        (tiers[tier] == ALGSURF_TIER_CERTIFIED ? 0 : stats.rays / (random_salt ? 400 : 4000))) {
        seen.wrong++;
        fprintf(stderr, "%s, view %d, tier %d: %ld pixels undecided\n", v->name, v->number, (int)tiers[tier],
                (long)stats.undecided);
    }
}

static void complain(const view *v, int tier, int x, int row, const algsurf_ray *ray,
                     const exact_answer *answer, const char *what) {
    double t = hits[tier][(row - v->row_begin) * WIDTH + x];
    seen.wrong++;
    fprintf(stderr, "%s, view %d (seed %#llx), tier %d: %s at pixel (%d,%d); t = %a = %.17g; exact:", v->name,
            v->number, (unsigned long long)first_seed, (int)tiers[tier], what, x, row, t, t);
    for (int i = 0; i < answer->count; i++) fprintf(stderr, " %.17g", answer->t[i]);
    fprintf(stderr, "%s%s\nhalf height %a\n", answer->sure ? "" : ", none for sure",
            answer->clustered ? ", clustered" : "", v->camera.half_height);
    exact_print_doubles("eye", v->camera.eye, 3), exact_print_doubles("right", v->camera.right, 3);
    exact_print_doubles("up", v->camera.up, 3), exact_print_doubles("forward", v->camera.forward, 3);
    exact_print_doubles("ray direction", ray->direction, 3);
}

/* What is wrong with t, +inf for a miss; null if nothing.  Roots before a sure one are those at an end of the
 * extent, and what t is off by is far less than what the roots are apart, or they are one for the eye. */
static const char *judge(const view *v, const exact_answer *answer, double t) {
    if (isinf(t)) return answer->sure ? "a miss for a hit" : NULL;
    if (answer->count == 0) return "a hit for a miss";
    for (int i = 0; i < answer->count; i++)
        if (fabs(t - answer->t[i]) <= 0x1p-20 * v->extent.size[0] || answer->clustered) return NULL;
    return "not the first root";
}

static void check_pixel(const view *v, int x, int row) {
    algsurf_ray ray = pixel_ray(&v->camera, WIDTH, HEIGHT, x + 0.5, row + 0.5);
    double reach = v->distance + v->extent.size[0];
    exact_answer answer = exact_first_root(v->terms, v->term_count, algsurf_surface_degree(v->surface),
                                           &v->extent, &ray, ROOM * 0x1p-53 * reach);
    seen.checked++, seen.hits += answer.sure, seen.misses += answer.count == 0;
    seen.ends += answer.count > answer.sure;
    for (int tier = 0; tier < TIERS; tier++) {
        const char *wrong = judge(v, &answer, hits[tier][(row - v->row_begin) * WIDTH + x]);
        if (!wrong) continue;
        const algsurf_intersect_options how = {.size = sizeof how, .tier = tiers[tier]};
        algsurf_hit hit = first_hit_of(v->surface, &v->extent, &ray, &how);
        uint8_t *before = &is_excused[(row - v->row_begin) * WIDTH + x];
        if (hit.state == ALGSURF_STATE_UNDECIDED && tiers[tier] == ALGSURF_TIER_BOUNDED)
            seen.excused += !*before, *before = 1;
        else
            complain(v, tier, x, row, &ray, &answer, wrong);
    }
}

/* Does the pixel show something else than its neighbour does? */
static int differ(const view *v, double t, double other) {
    if (isinf(t) || isinf(other)) return (isinf(t) != 0) != (isinf(other) != 0);
    return fabs(t - other) > 0.05 * v->extent.size[0];
}

static int is_outline(const view *v, int x, int row) {
    const double *t = hits[0] + (row - v->row_begin) * WIDTH + x;
    return (x > 0 && differ(v, t[0], t[-1])) || (x < WIDTH - 1 && differ(v, t[0], t[1])) ||
           (row > v->row_begin && differ(v, t[0], t[-WIDTH])) ||
           (row < v->row_end - 1 && differ(v, t[0], t[WIDTH]));
}

static void check_view(view *v, uint64_t *seed) {
    long excused = seen.excused, undecided = seen.undecided, wrong = seen.wrong;
    memset(is_excused, 0, sizeof is_excused);
    set_camera(v, seed);
    v->row_begin = whole ? 0 : random_int(seed, HEIGHT - ROWS);
    v->row_end = whole ? HEIGHT : v->row_begin + ROWS;
    for (int tier = 0; tier < TIERS; tier++) draw(v, tier);
    for (int done = 0, tries = 0; done < pixels && seen.wrong < wrong + 3; tries++) {
        int x = random_int(seed, WIDTH);
        int row = v->row_begin + random_int(seed, v->row_end - v->row_begin);
        int outline = is_outline(v, x, row);
        if (done % 2 && !outline && tries < 1000 * pixels) continue;
        check_pixel(v, x, row);
        seen.outlines += outline;
        done++;
    }
    if (seen.excused - excused > seen.undecided - undecided) {
        seen.wrong++;
        fprintf(stderr, "%s, view %d: more pixels undecided than the pictures say\n", v->name, v->number);
    }
}

static void check_surface(const char *name, const char *equation, const algsurf_extent *extent) {
    view v = {.name = name, .extent = *extent};
    uint64_t seed = first_seed;
    memset(&seen, 0, sizeof seen);
    set_surface(&v, equation);
    for (v.number = 0; v.number < views; v.number++) check_view(&v, &seed);
    printf(
        "%s: %ld pixels checked, %ld on outlines, %ld hits, %ld misses, %ld at an end; %ld of %ld undecided, "
        "%ld excused, %ld wrong\n",
        name, seen.checked, seen.outlines, seen.hits, seen.misses, seen.ends, seen.undecided, seen.rays,
        seen.excused, seen.wrong);
    assert_int_equal(seen.wrong, 0);
    if (whole) return;
    assert_often(seen.outlines * 3 > seen.checked);
    assert_often(seen.hits * 5 > seen.checked && seen.misses * 20 > seen.checked);
}

static void check_named(const char *name) {
    const catalogue_entry *entry = catalogue_find(name);
    check_surface(entry->name, entry->equation, &entry->extent);
}

TEST(test_barth_decic) { check_named("barth-decic"); }

TEST(test_labs_septic) { check_named("labs"); }

/* T16(x) + T16(y) + T16(z) + 1 = 0: 1344 nodes in the cube of half size 1 (Chmutov 1992). */
TEST(test_chmutov_16) {
#define T16(v) "(2(2(2(2" v "^2-1)^2-1)^2-1)^2-1)"
    const algsurf_extent ball = {.kind = ALGSURF_EXTENT_SPHERE, .size = {1.75}};
    check_surface("chmutov-16", T16("x") "+" T16("y") "+" T16("z") "+ 1", &ball);
#undef T16
}

int main(int count, char **arguments) {
    whole = count > 1;
    if (count > 1) pixels = atoi(arguments[1]);
    if (count > 2) views = atoi(arguments[2]);
    if (count > 3) first_seed = strtoull(arguments[3], NULL, 0);
    return unit_run("masks");
}
