/* test_allroots_properties.c - algsurf_complex_roots on random polynomials whose roots are known exactly.
 *
 * Products of linear factors with roots in doubles, multiplied out in rational arithmetic: simple roots,
 * multiplicities to 8, clusters 1e-1 .. 1e-12 wide, conjugate pairs, magnitudes far apart; solved as they
 * are where the coefficients are doubles, and with radii that cover the rounding where they are not.
 * Catches: a disc too small for its root, a residual that belongs to another point, radii that are left
 * out, a box whose count is wrong, boxes that meet or are not conjugate, a scale that is lost.
 * Also: roots beyond the range of double, zeros with a sign.
 * (Seen to fail with the discs a tenth of their size, discs that touch kept apart, the radii dropped from the
 * residual of either refinement, boxes or their mirror images not joined.)
 */
#include "algsurf/algsurf.h"
#include "allroots_case.h"
#include "unit.h"

static uint64_t seed = 20240917;

/* A number with few bits, so that products stay exact. */
static double dyadic(int bits) {
    int size = 1 << bits;
    return ldexp(random_int(&seed, 2 * size + 1) - size, -random_int(&seed, bits + 1));
}

static allroots_case random_case(int most, int bits, int real) {
    static const int multiplicities[] = {1, 1, 1, 1, 2, 3, 4, 8};
    allroots_case p = {.n = 0};
    int n = 1 + random_int(&seed, most);
    while (p.n < n) {
        double re = dyadic(bits), im = random_int(&seed, 3) == 0 ? 0 : dyadic(bits);
        int m = multiplicities[random_int(&seed, 8)];
        if (p.n + 2 * m > CASE_MAX) break;
        case_add(&p, re, im, m);
        if (real && im != 0) case_add(&p, re, -im, m);
        if (random_int(&seed, 4) == 0 && !real) /* a close neighbour, 1e-1 .. 1e-12 away */
            case_add(&p, re + ldexp(1, -3 - random_int(&seed, 37)), im, 1);
    }
    return p;
}

static void verdict(const allroots_case *p, const char *what, algsurf_status status,
                    const algsurf_complex_root *e, int count) {
    if (status == ALGSURF_OK) {
        const char *wrong = case_wrong(p, e, count);
        if (!wrong) return;
        case_print(p, e, count);
        fail_msg("%s: %s (seed %llu)", what, wrong, (unsigned long long)seed);
    }
    case_print(p, e, 0);
    fail_msg("%s: %s (seed %llu)", what, algsurf_status_text(status), (unsigned long long)seed);
}

TEST(test_exact_products) {
    int solved = 0, boxes = 0, roots = 0;
    for (int round = 0; round < 3000; round++) {
        allroots_case p = random_case(12, 1 + random_int(&seed, 10), round % 2);
        case_expand(&p, dyadic(3) + 0.0625);
        if (!p.exact) continue;
        algsurf_complex_root e[CASE_MAX];
        int count = 0;
        algsurf_status status = algsurf_complex_roots(p.c, NULL, p.n, e, &count);
        verdict(&p, "exact product", status, e, count);
        int real = 1;
        for (int k = 0; k <= p.n; k++) real = real && p.c[k].im == 0;
        if (real && !case_mirrored(e, count)) {
            case_print(&p, e, count);
            fail_msg("boxes that are not conjugate");
        }
        solved++, boxes += count;
        for (int i = 0; i < p.n; i++) {
            int first = 1;
            for (int j = 0; j < i; j++)
                first = first && memcmp(&p.root[i], &p.root[j], sizeof p.root[i]) != 0;
            roots += first;
        }
    }
    assert_true(solved > 1250);
    assert_true(boxes > 0.9 * roots); /* one box for everything would be true, and no use */
}

/* Coefficients rounded, with radii that say so: the exact product is one of the polynomials meant. */
TEST(test_rounded_products) {
    int boxes = 0, roots = 0;
    for (int round = 0; round < 750; round++) {
        allroots_case p = random_case(20, 20, 0);
        case_expand(&p, 1.0);
        algsurf_complex_root e[CASE_MAX];
        int count = 0;
        algsurf_status status = algsurf_complex_roots(p.c, p.r, p.n, e, &count);
        verdict(&p, "rounded product", status, e, count);
        boxes += count, roots += p.n;
    }
    assert_true(boxes > roots / 8);
}

/* Centre and radii drawn about an exact product; the wider the radii, the wider the boxes. */
TEST(test_members) {
    int boxes = 0;
    for (int round = 0; round < 750; round++) {
        allroots_case p = random_case(8, 6, 0);
        case_expand(&p, 1.0);
        double scale = ldexp(1, -2 - random_int(&seed, 40));
        for (int k = 0; k <= p.n; k++) {
            double dr = scale * random_unit(&seed), di = scale * random_unit(&seed);
            double slack = DBL_EPSILON * (fabs(p.c[k].re) + fabs(p.c[k].im) + scale);
            p.c[k].re += dr;
            p.c[k].im += di;
            p.r[k] += hypot(dr, di) + slack;
        }
        algsurf_complex_root e[CASE_MAX];
        int count = 0;
        algsurf_status status = algsurf_complex_roots(p.c, p.r, p.n, e, &count);
        verdict(&p, "member of a wide polynomial", status, e, count);
        boxes += count > 1;
    }
    assert_true(boxes > 250);
}

/* Magnitudes spread over hundreds of binades: the wide way of evaluating. */
TEST(test_far_apart) {
    int alone = 0, roots = 0;
    for (int round = 0; round < 750; round++) {
        allroots_case p = {.n = 0};
        int n = 2 + random_int(&seed, 10), reach = 10 + random_int(&seed, 90);
        for (int i = 0; i < n; i++)
            case_add(&p, random_wide(&seed, -reach, reach),
                     random_int(&seed, 2) ? random_wide(&seed, -reach, reach) : 0, 1);
        case_expand(&p, 1.0);
        int in_range = 1;
        for (int k = 0; k <= p.n; k++)
            in_range =
                in_range && hypot(p.c[k].re, p.c[k].im) > 0x1p-1000 && hypot(p.c[k].re, p.c[k].im) < 0x1p1000;
        if (!in_range) continue;
        algsurf_complex_root e[CASE_MAX];
        int count = 0;
        algsurf_status status = algsurf_complex_roots(p.c, p.r, p.n, e, &count);
        verdict(&p, "roots far apart", status, e, count);
        alone += count, roots += p.n;
    }
    assert_true(roots > 2500 && alone > 0.98 * roots);
}

/* Pellet: if |c_k| R^k is larger than all other terms together, k roots are below R in magnitude.  Boxes that
 * are certainly below, or beyond, may not hold more roots than that. */
static void judge_circles(const double *c, int n, const algsurf_complex_root *e, int count, int *circles) {
    for (int k = 0; k <= n; k++) {
        int least = -1000, most = 1000, below = 0, beyond = 0;
        for (int j = 0; j <= n;
             j++) { /* 64 2^(e_j + 1 + j s) < 2^(e_k + k s) for the exponents s in least..most */
            int over = ilogb(c[j]) - ilogb(c[k]) + 8;
            while (j < k && least <= most && over > (k - j) * least) least++;
            while (j > k && least <= most && over > (k - j) * most) most--;
        }
        if (least > most) continue;
        ++*circles;
        for (int i = 0; i < count; i++) {
            double inner = ldexp(1, least), outer = ldexp(1, most);
            algsurf_interval m = algsurf_cinterval_abs(e[i].box);
            if (m.hi < inner) below += e[i].multiplicity;
            if (m.lo > outer) beyond += e[i].multiplicity;
        }
        if (below > k || beyond > n - k)
            fail_msg("%d roots below 2^%d, %d beyond 2^%d, of %d and %d", below, least, beyond, most, k,
                     n - k);
    }
}

/* Coefficients from 2^-1000 to 2^1000, or only these two: a root out of the range of double, or several too
 * small for the unit, are no reason to lose the others. */
TEST(test_spread) {
    int most = 0, circles = 0, boxes = 0;
    for (int round = 0; round < 400; round++) {
        int n = round % 3 ? ALGSURF_MAX_DEGREE : 2 + random_int(&seed, 30), count;
        int range = 700 + 100 * random_int(&seed, 4), extreme = round % 2;
        double c[ALGSURF_MAX_DEGREE + 1];
        algsurf_complex_root e[ALGSURF_MAX_DEGREE];
        for (int k = 0; k <= n; k++) {
            int end = random_int(&seed, 2) ? range : -range;
            c[k] = random_wide(&seed, extreme ? end : -range, extreme ? end : range);
        }
        assert_ok(algsurf_complex_roots_of_real(c, NULL, n, e, &count));
        const char *what = case_boxes_wrong(n, e, count);
        if (what) fail_msg("%s, degree %d", what, n);
        judge_circles(c, n, e, count, &circles);
        boxes += count == n;
        for (int i = 0; i < count; i++) most = e[i].multiplicity > most ? e[i].multiplicity : most;
    }
    if (most > 8 || boxes < 330 || circles < 1000)
        fail_msg("%d in one box, %d isolated, %d circles", most, boxes, circles);
}

static int negative_zero(double x) { return x == 0 && signbit(x); }

/* Boxes that end at 0, where rounding outward is from below: +0. */
TEST(test_zero_ends) {
    int ends = 0;
    for (int round = 0; round < 4000; round++) {
        algsurf_complex c[8];
        algsurf_complex_root e[8];
        int n = 1 + random_int(&seed, 7), count;
        for (int k = 0; k <= n; k++) {
            c[k] = (algsurf_complex){random_int(&seed, 7) - 3, random_int(&seed, 7) - 3};
            if (round % 4 == 0) c[k].im = 0;
        }
        if (round % 16 == 1) c[n].re *= 0x1p600, c[n].im *= 0x1p600;
        if (round % 2) c[0].re *= DBL_TRUE_MIN * 16, c[0].im *= DBL_TRUE_MIN * 16;
        algsurf_paper_zero zero[8];
        int complete;
        if (algsurf_paper_zeros(c, NULL, n, NULL, NULL, zero, &complete) == ALGSURF_OK)
            for (int i = 0; i < n; i++)
                if (negative_zero(zero[i].box.re.lo) || negative_zero(zero[i].box.re.hi) ||
                    negative_zero(zero[i].box.im.lo) || negative_zero(zero[i].box.im.hi) ||
                    negative_zero(zero[i].root.re) || negative_zero(zero[i].root.im))
                    fail_msg("-0 in a box of algsurf_paper_zeros");
        if (algsurf_complex_roots(c, NULL, n, e, &count) != ALGSURF_OK) continue;
        for (int i = 0; i < count; i++) {
            algsurf_interval re = e[i].box.re, im = e[i].box.im;
            ends += re.lo == 0 || re.hi == 0 || im.lo == 0 || im.hi == 0;
            if (negative_zero(re.lo) || negative_zero(re.hi) || negative_zero(im.lo) ||
                negative_zero(im.hi) || negative_zero(e[i].root.re) || negative_zero(e[i].root.im))
                fail_msg("[%a, %a] + [%a, %a] i", re.lo, re.hi, im.lo, im.hi);
        }
    }
    assert_true(ends > 100);
}

/* The product of (X - box), times the leading coefficient, encloses the coefficients. */
static void check_reconstruction(const allroots_case *p, const algsurf_complex_root *e, int count) {
    const algsurf_cinterval zero = {{0, 0}, {0, 0}};
    algsurf_cinterval q[CASE_MAX + 2] = {zero};
    int n = 0;
    q[0] = (algsurf_cinterval){{p->c[p->n].re, p->c[p->n].re}, {p->c[p->n].im, p->c[p->n].im}};
    for (int i = 0; i < count; i++)
        for (int m = 0; m < e[i].multiplicity; m++) {
            n++;
            for (int k = n; k >= 0; k--)
                q[k] = algsurf_cinterval_sub(k > 0 ? q[k - 1] : zero, algsurf_cinterval_mul(q[k], e[i].box));
        }
    for (int k = 0; k <= p->n; k++)
        if (!case_in(p->c[k], q[k])) {
            case_print(p, e, count);
            fail_msg("coefficient %d is not enclosed", k);
        }
}

TEST(test_reconstruction) {
    for (int round = 0; round < 400; round++) {
        allroots_case p = {.n = 1 + random_int(&seed, 16)};
        for (int k = 0; k <= p.n; k++)
            p.c[k] = (algsurf_complex){random_wide(&seed, -8, 8), round % 2 ? random_wide(&seed, -8, 8) : 0};
        algsurf_complex_root e[CASE_MAX];
        int count = 0;
        assert_ok(algsurf_complex_roots(p.c, NULL, p.n, e, &count));
        assert_null(case_boxes_wrong(p.n, e, count));
        check_reconstruction(&p, e, count);
    }
}

/* Multiplying the value or the variable by a power of two changes nothing but exponents, as long as
 * coefficients are between 2^-300 and 2^300. */
TEST(test_scaling) {
    for (int round = 0; round < 600; round++) {
        allroots_case p = {.n = 1 + random_int(&seed, 12)}, q;
        for (int k = 0; k <= p.n; k++)
            p.c[k] = (algsurf_complex){random_unit(&seed), round % 2 ? random_unit(&seed) : 0};
        q = p;
        int value = random_int(&seed, 201) - 100, variable = random_int(&seed, 25) - 12;
        for (int k = 0; k <= p.n; k++) {
            q.c[k].re = ldexp(p.c[k].re, value - k * variable);
            q.c[k].im = ldexp(p.c[k].im, value - k * variable);
        }
        algsurf_complex_root e[CASE_MAX], f[CASE_MAX];
        int count = 0, count_scaled = 0;
        assert_ok(algsurf_complex_roots(p.c, NULL, p.n, e, &count));
        assert_ok(algsurf_complex_roots(q.c, NULL, p.n, f, &count_scaled));
        assert_int_equal(count, count_scaled);
        for (int i = 0; i < count; i++) {
            const algsurf_interval *a = &e[i].box.re, *b = &f[i].box.re;
            if (ldexp(a->lo, variable) != b->lo || ldexp(a->hi, variable) != b->hi ||
                ldexp(e[i].box.im.lo, variable) != f[i].box.im.lo ||
                ldexp(e[i].box.im.hi, variable) != f[i].box.im.hi) {
                case_print(&p, e, count), case_print(&q, f, count);
                fail_msg("scaling the variable by 2^%d, the value by 2^%d changes digits", variable, value);
            }
        }
    }
}
