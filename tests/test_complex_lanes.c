/* test_complex_lanes.c - the proofs of complex roots in lanes, judged by arithmetic without rounding.
 *
 * The judge.  Numbers have so many bits here that sums and products are exact.  From a disc's centre Newton's
 * method finds a point z; the disc about it of radius n |p/p'|, with p and p' exact, holds a root (Laguerre).
 * If it lies in the disc that is claimed to hold a root, the claim is true; as discs are disjoint and as many
 * as roots, each holds exactly one then.  A root claimed to be real must have an imaginary part below that
 * radius; what is said of the root that is seen is compared with all roots.
 *
 * Breaks tried, each caught by the test named:
 *   n or the spread left out of the radius, 3 for 2^-3 in the proof of disjointness    discs_hold_their_roots
 *   the guards of the coefficients left out                                            wild_ones_are_left
 *   one edge of the sector taken for the other one                                     seen_root
 *   a rival overlooked                                                                 equal_magnitudes
 *   a twin taken for any root                                                          two_mirrors
 *   a lane that moves on when it is done                                               lanes_do_not_mix
 *   the last step without doubled precision                                            settled_alike
 *   what underflows in the square of a value left out                                  squares_that_underflow
 */
#include "simd/baseline.h"

#include "complex/lanes_template.h"
#include "exact_complex.h"
#include "unit.h"

static polynomials in_lanes(const problem p[LANES]) {
    polynomials q = {.real = 1, .spread = all_lanes(0)};
    for (int l = 0; l < LANES; l++) {
        q.real &= p[l].real;
        q.spread[l] = p[l].spread;
        for (int k = 0; k <= p[0].n; k++) q.re[k][l] = p[l].re[k], q.im[k][l] = p[l].im[k];
    }
    return q;
}

static void solve(const polynomials *q, int n, double stop, roots *r) {
    mask all = at_most(all_lanes(0), all_lanes(0));
    for (int i = 0; i < n; i++) r->x[i] = r->y[i] = all_lanes(0);
    set_start(q, n, all, r->x, r->y);
    (void)iterate(q, n, all, stop, r->x, r->y);
    prove(q, n, r);
}

/* The claims about lane l; the roots, as doubles, go to x and y. */
static void judge(const problem *p, const roots *r, int l, double *x, double *y) {
    point z, centre;
    init(&z), init(&centre);
    for (int i = 0; i < p->n; i++) {
        double radius = find_root(p, r->x[i][l], r->y[i][l], FOUND * r->radius[i][l], &z);
        x[i] = mpf_get_d(z.re), y[i] = mpf_get_d(z.im);
        if (p->real && fabs(r->y[i][l]) <= r->radius[i][l]) assert_true(fabs(y[i]) <= radius);
        mpf_set_d(centre.re, -r->x[i][l]), mpf_set_d(centre.im, -r->y[i][l]);
        add(&z, &centre);
        if (!(magnitude(&z) * (1 + 0x1p-50) + radius <= r->radius[i][l])) {
            print_error("degree %d, root %d at (%a,%a), disc %a, root found %a away in %a\n", p->n, i,
                        r->x[i][l], r->y[i][l], r->radius[i][l], magnitude(&z), radius);
            for (int k = 0; k <= p->n; k++) print_error("  %a %a\n", p->re[k], p->im[k]);
            fail();
        }
    }
    clear(&z), clear(&centre);
}

/* ---- cases ---- */

static void add_spread(problem *p) {
    p->which = below(p->n + 1);
    p->spread = ldexp(1, -20 - below(40));
    p->change = below(2) ? p->spread : -p->spread;
}

/* Random polynomials of all kinds: every claim is true, and most are claimed of kinds that are not hopeless.
 */
TEST(discs_hold_their_roots) {
    int proved[KINDS] = {0}, tried[KINDS] = {0};
    for (int round = 0; round < 1500; round++) {
        problem p[LANES];
        int n = 1 + below(MOST), kind = round % KINDS, real = below(2), blurred = below(3) == 0;
        double x[MOST], y[MOST];
        roots r;
        for (int l = 0; l < LANES; l++) {
            p[l] = random_problem(n, kind, real);
            if (blurred) add_spread(p + l);
        }
        polynomials q = in_lanes(p);
        solve(&q, n, below(2) ? NEAR_STOP : FAR_STOP, &r);
        for (int l = 0; l < LANES; l++) {
            tried[kind] += !blurred;
            if (!(bits(r.apart) >> l & 1)) continue;
            proved[kind] += !blurred;
            judge(p + l, &r, l, x, y);
        }
    }
    assert_true(proved[PLAIN] * 20 >= tried[PLAIN] * 19);
    assert_true(proved[INTEGERS] * 20 >= tried[INTEGERS] * 19);
    assert_true(proved[CLUSTERED] * 4 >= tried[CLUSTERED] && proved[CLUSTERED] < tried[CLUSTERED]);
    assert_often(proved[SPARSE] * 4 >= tried[SPARSE]);
}

/* Values near 2^-537, of points next to roots: their squares are among the last numbers above 0. */
TEST(squares_that_underflow) {
    int proved = 0;
    for (int round = 0; round < 2000; round++) {
        problem p[LANES];
        roots r;
        double x, y;
        for (int l = 0; l < LANES; l++) {
            const int lead = -200 - below(100), off = -530 - below(12);
            p[l] = (problem){.n = 1, .real = round % 2};
            p[l].re[1] = ldexp(1 + fabs(uniform()), lead), p[l].re[0] = ldexp(uniform(), off - below(40));
            if (!p[l].real) p[l].im[1] = ldexp(uniform(), lead), p[l].im[0] = ldexp(uniform(), off);
            r.x[0][l] = ldexp(uniform(), off - lead), r.y[0][l] = ldexp(uniform(), off - lead - below(8));
        }
        polynomials q = in_lanes(p);
        prove(&q, 1, &r);
        for (int l = 0; l < LANES; l++) {
            if (!(bits(r.apart) >> l & 1)) continue;
            proved++;
            judge(p + l, &r, l, &x, &y);
        }
    }
    assert_true(proved > 100);
}

/* Exponents, zeros and multiple roots at which lanes without a guard have lied: nothing is claimed. */
TEST(wild_ones_are_left) {
    static const struct {
        int n;
        double c[5];
    } cases[] = {{2, {0, 0, 1}},           {3, {0, 0, 1, 1}},
                 {2, {1, 2, 1}},           {4, {0, 0, 0, 0, 1}},
                 {2, {1, 1, 0}},           {2, {0x1p-1000, 0, 0x1p1000}},
                 {2, {NAN, 1, 1}},         {2, {1, INFINITY, 1}},
                 {1, {0x1p500, 0x1p-500}}, {3, {0x1p-700, 0x1p-1050, 0x1p-1050, 0x1p-300}}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        problem p[LANES] = {{.n = cases[i].n, .real = 1}, {.n = cases[i].n, .real = 1}};
        roots r;
        memcpy(p[0].re, cases[i].c, sizeof cases[i].c);
        memcpy(p[1].re, cases[i].c, sizeof cases[i].c);
        polynomials q = in_lanes(p);
        solve(&q, cases[i].n, FAR_STOP, &r);
        assert_int_equal(bits(r.apart), 0);
    }
}

/* In the sector and the range by more than `by`. */
static int inside(const algsurf_sector *sector, double x, double y, double lo, double hi, double by) {
    double m = hypot(x, y), arg = atan2(fabs(y), x);
    int open = sector->sigma == 0 || arg >= sector->sigma + by;
    int end = sector->sigma + sector->delta >= 3.14159265358979 || arg <= sector->sigma + sector->delta - by;
    return open && end && m >= lo + by && m <= hi - by;
}

/* What is seen of random polynomials, by all their roots. */
TEST(seen_root) {
    int ones = 0, nones = 0, twins = 0, tried = 0;
    for (int round = 0; round < 600; round++) {
        problem p[LANES];
        int n = 1 + below(8), real = below(4) > 0;
        roots r;
        for (int l = 0; l < LANES; l++) p[l] = random_problem(n, PLAIN, real);
        polynomials q = in_lanes(p);
        solve(&q, n, NEAR_STOP, &r);
        algsurf_sector sector = {below(2) ? 0 : 1.5 * fabs(uniform()), 1.5 * fabs(uniform())};
        algsurf_i_sector_edges edges;
        if (below(4) == 0) sector.delta = 3.141592653589793 - sector.sigma;
        assert_true(algsurf_i_sector_edges_of(&sector, &edges));
        const window w = {&edges, 2 * uniform(), all_lanes(fabs(uniform())), all_lanes(1 + fabs(uniform())),
                          all_lanes(0x1p-40)};
        seen s = find_seen(&q, n, &r, &w);
        const seen found = s;
        settle(&q, n, &s);
        for (int l = 0; l < LANES; l++) {
            double x[MOST], y[MOST], least = HUGE_VAL;
            tried++;
            if (!(bits(r.apart) >> l & 1)) {
                assert_true(bits(found.undecided) >> l & 1);
                continue;
            }
            judge(p + l, &r, l, x, y);
            for (int i = 0; i < n; i++)
                if (inside(&sector, x[i] - w.from, y[i], w.lo[l], w.hi[l], 1e-9))
                    least = fmin(least, hypot(x[i] - w.from, y[i]));
            if (bits(s.undecided) >> l & 1) continue;
            if (!(bits(s.one) >> l & 1)) {
                assert_true(least == HUGE_VAL);
                nones++;
                continue;
            }
            double at = hypot(s.x[l] - w.from, s.y[l]);
            assert_true(inside(&sector, s.x[l] - w.from, s.y[l], w.lo[l], w.hi[l], -1e-9));
            if (inside(&sector, s.x[l] - w.from, s.y[l], w.lo[l], w.hi[l], 1e-9))
                assert_true(fabs(at - least) <= 1e-12);
            assert_true((bits(s.real) >> l & 1) == (s.y[l] == 0));
            ones++;
            twins += real && s.y[l] != 0;
        }
    }
    assert_true(ones > tried / 4 && nones > tried / 10 && twins > tried / 20);
    assert_true(ones + nones > tried * 9 / 10);
}

/* Magnitudes that are equal but not those of conjugates stay open. */
TEST(equal_magnitudes) {
    const algsurf_sector whole = {0, 3.141592653589793};
    algsurf_i_sector_edges edges;
    problem p[LANES] = {{.n = 4, .real = 1}, {.n = 4, .real = 1}};
    roots r;
    /* lane 0: 3 +- 4i, 4 +- 3i; lane 1: 3 +- 4i, 6 +- 1i */
    const double one[5] = {625, -350, 98, -14, 1}, two[5] = {925, -522, 134, -18, 1};
    memcpy(p[0].re, one, sizeof one), memcpy(p[1].re, two, sizeof two);
    polynomials q = in_lanes(p);
    solve(&q, 4, FAR_STOP, &r);
    assert_int_equal(bits(r.apart), 3);
    assert_true(algsurf_i_sector_edges_of(&whole, &edges));
    const window w = {&edges, 0, all_lanes(0.5), all_lanes(100), all_lanes(0)};
    seen s = find_seen(&q, 4, &r, &w);
    assert_int_equal(bits(s.undecided), 1);
    assert_int_equal(bits(s.one), 2);
}

/* A disc whose mirror image meets two others: whose the conjugate is stays open.  With one of them moved
 * away, the other holds it. */
TEST(two_mirrors) {
    const algsurf_sector whole = {0, 3.141592653589793};
    algsurf_i_sector_edges edges;
    assert_true(algsurf_i_sector_edges_of(&whole, &edges));
    const polynomials q = {.real = 1};
    const window w = {&edges, 0, all_lanes(0.1), all_lanes(100), all_lanes(0)};
    roots r = {.x = {all_lanes(3), all_lanes(3.06), all_lanes(3.03)},
               .y = {all_lanes(1), all_lanes(-1), all_lanes(-1.055)},
               .radius = {all_lanes(0.05), all_lanes(0.02), all_lanes(0.02)},
               .apart = at_most(all_lanes(0), all_lanes(0))};
    r.x[2][1] = 20;
    seen s = find_seen(&q, 3, &r, &w);
    assert_int_equal(bits(s.undecided), 1);
    assert_int_equal(bits(s.one), 2);
}

/* A lane's bits are the same whoever its neighbours are. */
TEST(lanes_do_not_mix) {
    for (int round = 0; round < 200; round++) {
        int n = 1 + below(MOST), real = below(2);
        problem a = random_problem(n, PLAIN, real), p[2][LANES];
        roots r[2];
        for (int k = 0; k < 2; k++) {
            for (int l = 0; l < LANES; l++) p[k][l] = random_problem(n, below(KINDS), real);
            p[k][k * (LANES - 1)] = a;
            polynomials q = in_lanes(p[k]);
            solve(&q, n, NEAR_STOP, r + k);
        }
        for (int i = 0; i < n; i++) {
            assert_true(r[0].x[i][0] == r[1].x[i][LANES - 1] && r[0].y[i][0] == r[1].y[i][LANES - 1]);
            assert_true(r[0].radius[i][0] == r[1].radius[i][LANES - 1] ||
                        (isnan(r[0].radius[i][0]) && isnan(r[1].radius[i][LANES - 1])));
        }
    }
}

/* A root's value does not tell where the iteration began. */
TEST(settled_alike) {
    const algsurf_sector whole = {0, 3.141592653589793};
    algsurf_i_sector_edges edges;
    int both = 0;
    assert_true(algsurf_i_sector_edges_of(&whole, &edges));
    for (int round = 0; round < 400; round++) {
        int n = 1 + below(10), real = below(2);
        problem p[LANES];
        roots r[2];
        seen s[2];
        for (int l = 0; l < LANES; l++) p[l] = random_problem(n, PLAIN, real);
        polynomials q = in_lanes(p);
        const window w = {&edges, -0.5, all_lanes(0), all_lanes(100), all_lanes(0)};
        for (int k = 0; k < 2; k++) {
            solve(&q, n, k ? FAR_STOP : NEAR_STOP, r + k);
            s[k] = find_seen(&q, n, r + k, &w);
            settle(&q, n, s + k);
        }
        for (int l = 0; l < LANES; l++) {
            if (!(bits(s[0].one & s[1].one) >> l & 1)) continue;
            both++;
            assert_true(s[0].x[l] == s[1].x[l] && fabs(s[0].y[l]) == fabs(s[1].y[l]));
        }
    }
    assert_true(both > 400);
}
