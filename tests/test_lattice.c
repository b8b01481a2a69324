/* test_lattice.c - the points that soft shadows look at.
 *
 * Breaks tried, each caught by the test named:
 *   samples of a pixel that overlap, a pixel with another's points, a wrong count       tiles
 *   a shift by pixel instead of tile                                                    tiles
 *   a generator that leaves the square uneven                                           pixels
 *   one shift for all purposes or all rows of tiles, none across, none up               shifts
 *   pixels of a tile in the order of their rows                                         neighbours
 *   points rounded to the nearest unit, not brought back to the square, a quarter of a unit aside   tiles
 */
#include "lattice_reference.h"
#include "simd/baseline.h"

#include "beams/lattice_template.h"
#include "unit.h"

enum { MOST_POINTS = 16 * 512 };

/* Samples of a pixel, and points of each, as pictures have them: 32, or 16, for a pixel, rounded up. */
static const struct {
    int across, each;
} settings[] = {{1, 32}, {1, 16}, {2, 8}, {2, 4}, {3, 4}, {3, 2}, {4, 2}, {4, 1}, {5, 2}, {16, 1}};
enum { SETTINGS = sizeof settings / sizeof settings[0] };

/* The points of a tile of 4 x 4 pixels, pixel after pixel. */
typedef struct tile_points {
    int count;
    double p[MOST_POINTS], q[MOST_POINTS];
} tile_points;

/* As pictures find them, which is what integers say. */
static void find_points(const algsurf_i_sample *sample, int purpose, int each, double *p, double *q) {
    const algsurf_i_lattice lattice = algsurf_i_lattice_of(sample, purpose, each);
    const lanes across = all_lanes(lattice.across), up = all_lanes(lattice.up);
    lattice_points(sample, purpose, each, p, q);
    for (int i = 0; i < each; i++) {
        lanes x, y;
        find_lattice_points(all_lanes(lattice.number + ALGSURF_I_LATTICE_STEP * i), across, up,
                            ALGSURF_I_LATTICE_STEP * sample->count * each, &x, &y);
        assert_true(x[0] + 0.5 == p[i] && y[0] + 0.5 == q[i]);
    }
}

static void add_pixel(int x, int y, int setting, int purpose, tile_points *t) {
    int all = settings[setting].across * settings[setting].across, each = settings[setting].each;
    for (int s = 0; s < all; s++) {
        const algsurf_i_sample sample = {x, y, s, all};
        find_points(&sample, purpose, each, t->p + t->count, t->q + t->count);
        t->count += each;
    }
}

static void find_tile(int left, int top, int setting, int purpose, tile_points *t) {
    t->count = 0;
    for (int k = 0; k < 16; k++) add_pixel(left + k % 4, top + k / 4, setting, purpose, t);
}

/* Each column, 1/count wide, has one point, but for where the tile's shift is within a rounding of 2^-32. */
static void check_columns(const tile_points *t) {
    static int taken[MOST_POINTS];
    double shift = t->p[0] * t->count - floor(t->p[0] * t->count);
    memset(taken, 0, sizeof taken);
    for (int i = 0; i < t->count; i++) {
        double place = t->p[i] * t->count - shift, column = floor(place + 0.5);
        assert_true(t->p[i] >= 0 && t->p[i] < 1 && t->q[i] >= 0 && t->q[i] < 1);
        assert_true(fabs(place - column) <= t->count * 0x1p-31);
        int c = ((int)column + t->count) % t->count;
        assert_int_equal(taken[c]++, 0);
    }
}

/* In each square of a grid of 4 x 4 about as many. */
static void check_evenness(const tile_points *t) {
    int counts[16] = {0};
    for (int i = 0; i < t->count; i++) counts[(int)(4 * t->p[i]) + 4 * (int)(4 * t->q[i])]++;
    for (int k = 0; k < 16; k++)
        if (abs(counts[k] - t->count / 16) > 4) fail_msg("%d of %d", counts[k], t->count);
}

/* No two points are closer than a third of what a square grid's are. */
static void check_distances(const tile_points *t) {
    double least = 1;
    for (int i = 0; i < t->count; i++)
        for (int j = 0; j < i; j++) {
            double dp = fabs(t->p[i] - t->p[j]), dq = fabs(t->q[i] - t->q[j]);
            dp = fmin(dp, 1 - dp), dq = fmin(dq, 1 - dq);
            least = fmin(least, dp * dp + dq * dq);
        }
    if (!(least * t->count > 1.0 / 9)) fail_msg("%d points: %g", t->count, sqrt(least * t->count));
}

TEST(tiles) {
    static tile_points t;
    for (int s = 0; s < SETTINGS; s++)
        for (int k = 0; k < 12; k++) {
            find_tile(4 * (k * k * k), 4 * (11 - k), s, k % 3, &t);
            assert_int_equal(t.count, 16 * settings[s].across * settings[s].across * settings[s].each);
            check_columns(&t), check_evenness(&t);
            if (t.count <= 512) check_distances(&t);
        }
}

/* Also those of one pixel are spread out: in each half of the square, and each quarter's width. */
TEST(pixels) {
    static tile_points t;
    for (int s = 0; s < 2; s++)
        for (int k = 0; k < 64; k++) {
            t.count = 0;
            add_pixel(4096 + k % 8, 100 + k / 8, s, 1, &t);
            int left = 0, lower = 0, columns[4] = {0};
            for (int i = 0; i < t.count; i++)
                left += t.p[i] < 0.5, lower += t.q[i] < 0.5, columns[(int)(4 * t.p[i])]++;
            assert_in_range(left, t.count / 2 - 1, t.count / 2 + 1);
            assert_in_range(lower, t.count / 2 - 3, t.count / 2 + 3);
            for (int c = 0; c < 4; c++) assert_in_range(columns[c], t.count / 4 - 1, t.count / 4 + 1);
        }
}

static int same_points(const tile_points *a, const tile_points *b) {
    return memcmp(a->p, b->p, (size_t)a->count * sizeof *a->p) == 0 ||
           memcmp(a->q, b->q, (size_t)a->count * sizeof *a->q) == 0;
}

/* Tiles beside each other, and purposes, have other shifts, across and up; all of the square gets its turn.
 */
TEST(shifts) {
    static tile_points t[4];
    int columns[8] = {0}, rows[8] = {0};
    for (int y = 0; y < 80; y += 4)
        for (int x = 0; x < 80; x += 4) {
            find_tile(x, y, 0, 1, &t[0]), find_tile(x + 4, y, 0, 1, &t[1]);
            find_tile(x, y + 4, 0, 1, &t[2]), find_tile(x, y, 0, (x + y) % 3 == 0 ? 0 : 2, &t[3]);
            for (int k = 1; k < 4; k++) assert_false(same_points(&t[0], &t[k]));
            columns[(int)(8 * t[0].p[0])]++, rows[(int)(8 * t[0].q[0])]++;
        }
    for (int k = 0; k < 8; k++) {
        assert_in_range(columns[k], 25, 80);
        assert_in_range(rows[k], 25, 80);
    }
}

/* Neighbours in a row or column are far apart in the lattice's order: no pixel has the points next to
 * another's. */
TEST(neighbours) {
    static tile_points a, b;
    for (int k = 0; k < 32; k++) {
        int x = 40 + k % 4, y = 80 + k / 4 % 4, beside = k / 16;
        if ((beside ? x : y) % 4 == 3) continue; /* the next tile */
        a.count = b.count = 0;
        add_pixel(x, y, 0, 0, &a), add_pixel(x + beside, y + !beside, 0, 0, &b);
        double way = fabs(a.p[0] - b.p[0]) * 512;
        way = fmin(way, 512 - way);
        assert_true(way >= 1.5 && way <= 13);
    }
}
