/* roots.c - fuzzes algsurf_complex_roots and its kin: "FLAGS BOX COEFFICIENT COEFFICIENT ...".
 *
 * FLAGS: 1: coefficients are pairs re im; 2: each is followed by a radius; 4: real ones go through the call
 * for real polynomials.  BOX is the box to look at where there are many.  A box must hold as many roots as it
 * says, counted exactly (exact_winding.h) in the box widened by next to nothing.  The same roots to 100 bits
 * are in these boxes.
 */
#include <stdio.h> /* before gmp.h */
#include <string.h>

#include <gmp.h>

#include "algsurf/batch.h"
#include "algsurf/intersect.h"
#include "allroots_case.h"
#include "exact_winding.h"
#include "fuzz.h"

enum { COMPLEX = 1, RADII = 2, REAL_CALL = 4, TOP = 24, ALL_BOXES = 6, JUDGED = 10, MOST_BITS = 12000 };

typedef struct question {
    int flags, which, degree;
    algsurf_complex c[TOP + 1];
    double r[TOP + 1];
} question;

static question read_question(fuzz_numbers *in) {
    question q = {.flags = fuzz_whole(in, 0, 7), .which = fuzz_whole(in, 0, TOP), .degree = -1};
    while (q.degree < TOP && (q.degree < 0 || fuzz_left(in) > 0)) {
        q.degree++;
        q.c[q.degree].re = fuzz_finite(in);
        if (q.flags & COMPLEX) q.c[q.degree].im = fuzz_finite(in);
        if (q.flags & RADII) q.r[q.degree] = fabs(fuzz_finite(in));
    }
    return q;
}

static int is_real(const question *q) {
    for (int k = 0; k <= q->degree; k++)
        if (q->c[k].im != 0) return 0;
    return 1;
}

static algsurf_status solve(const question *q, algsurf_complex_root *roots, int *count) {
    const double *r = q->flags & RADII ? q->r : NULL;
    double c[TOP + 1];
    if (!(q->flags & REAL_CALL) || !is_real(q))
        return algsurf_complex_roots(q->c, r, q->degree, roots, count);
    for (int k = 0; k <= q->degree; k++) c[k] = q->c[k].re;
    return algsurf_complex_roots_of_real(c, r, q->degree, roots, count);
}

/* Between two disjoint boxes, the distance along the axis that parts them. */
static double gap(algsurf_cinterval a, algsurf_cinterval b) {
    double x = fmax(b.re.lo - a.re.hi, a.re.lo - b.re.hi), y = fmax(b.im.lo - a.im.hi, a.im.lo - b.im.hi);
    return fmax(x, y);
}

/* By how little a box is widened, as a power of two: far less than to the next one, and than its last bits.
 */
static int margin_of(const algsurf_complex_root *e, int count, int i) {
    algsurf_cinterval box = e[i].box;
    double size = fmax(fmax(fabs(box.re.lo), fabs(box.re.hi)), fmax(fabs(box.im.lo), fabs(box.im.hi)));
    int margin = (size > 0 ? ilogb(size) : 0) - 80;
    for (int j = 0; j < count; j++) {
        int apart = j != i ? ilogb(fmin(gap(box, e[j].box), 0x1p1023)) - 4 : margin;
        if (apart < margin) margin = apart;
    }
    return margin;
}

static void check_form(const question *q, const algsurf_complex_root *e, int count) {
    int sum = 0, degree = q->degree;
    while (degree > 0 && q->c[degree].re == 0 && q->c[degree].im == 0) degree--;
    for (int i = 0; i < count; i++) {
        const algsurf_cinterval b = e[i].box;
        fuzz_check(e[i].multiplicity >= 1);
        sum += e[i].multiplicity;
        fuzz_check(b.re.lo <= e[i].root.re && e[i].root.re <= b.re.hi && isfinite(e[i].root.re));
        fuzz_check(b.im.lo <= e[i].root.im && e[i].root.im <= b.im.hi && isfinite(e[i].root.im));
        fuzz_check(!e[i].real || (b.im.lo == 0 && b.im.hi == 0));
        for (int j = 0; j < i; j++) fuzz_check(gap(b, e[j].box) > 0);
    }
    fuzz_check(sum == degree);
}

/* What a real polynomial's boxes on the axis hold, by the number of distinct real roots. */
static void check_real_roots(const question *q, const algsurf_complex_root *e, int count) {
    double c[TOP + 1];
    for (int k = 0; k <= q->degree; k++) c[k] = q->c[k].re;
    exact_sturm s = exact_sturm_of_doubles(c, q->degree);
    int outside = exact_count_roots(&s, -INFINITY, INFINITY);
    for (int i = 0; i < count; i++) {
        algsurf_cinterval b = e[i].box;
        if (b.im.lo > 0 || b.im.hi < 0) continue;
        int inside = exact_count_roots(&s, b.re.lo, b.re.hi);
        outside -= inside;
        fuzz_check(inside <= e[i].multiplicity);
        if (e[i].real) fuzz_check(inside >= 1);
    }
    fuzz_check(outside == 0);
    exact_sturm_clear(&s);
}

static int is_bounded(algsurf_cinterval box) {
    return isfinite(box.re.lo) && isfinite(box.re.hi) && isfinite(box.im.lo) && isfinite(box.im.hi);
}

static void check_boxes(const question *q, const algsurf_complex *c, const algsurf_complex_root *e,
                        int count) {
    exact_complex_poly p = exact_complex_of(c, q->degree);
    for (int i = 0; i < count; i++) {
        if (q->degree > ALL_BOXES && i != q->which % count) continue;
        if (!is_bounded(e[i].box)) continue;
        int roots = exact_roots_in_box(&p, e[i].box, margin_of(e, count, i));
        if (roots >= 0 && roots != e[i].multiplicity)
            fprintf(stderr, "box %d [%a, %a] + i [%a, %a]: %d roots, not %d\n", i, e[i].box.re.lo,
                    e[i].box.re.hi, e[i].box.im.lo, e[i].box.im.hi, roots, e[i].multiplicity);
        fuzz_check(roots < 0 || roots == e[i].multiplicity);
    }
    exact_complex_clear(&p);
}

/* A polynomial of the set, at the ends of its radii: upwards or downwards. */
static void member(const question *q, int up, algsurf_complex *c) {
    for (int k = 0; k <= q->degree; k++) {
        c[k] = q->c[k];
        double end = c[k].re + (up ? q->r[k] : -q->r[k]);
        if (q->r[k] > 0 && isfinite(end)) c[k].re = nextafter(end, c[k].re);
    }
}

/* A packet of three copies, by every kernel, has the answers of the single call. */
static void check_packet(const question *q, algsurf_status status, const algsurf_complex_root *e, int count) {
    enum { COPIES = 3 };
    static double re[TOP + 1][COPIES], im[TOP + 1][COPIES], r[TOP + 1][COPIES];
    static algsurf_complex_root found[COPIES * TOP];
    const char *kernel;
    int counts[COPIES], real = q->flags & REAL_CALL && is_real(q);
    for (int k = 0; k <= q->degree; k++)
        for (int i = 0; i < COPIES; i++) re[k][i] = q->c[k].re, im[k][i] = q->c[k].im, r[k][i] = q->r[k];
    const algsurf_complex_batch packet = {.size = sizeof packet,
                                          .count = COPIES,
                                          .degree = q->degree,
                                          .re = {re[0], COPIES, 1},
                                          .im = {real ? NULL : im[0], COPIES, 1},
                                          .radii = {q->flags & RADII ? r[0] : NULL, COPIES, 1}};
    for (int j = 0; q->degree > 0 && (kernel = algsurf_kernel_name(j)); j++) {
        const algsurf_batch_options options = {.size = sizeof options, .kernel = kernel};
        fuzz_check(algsurf_complex_roots_batch(&packet, &options, found, counts) == status);
        for (int i = 0; i < COPIES; i++) {
            fuzz_check(counts[i] == (status < 0 ? (int)status : count));
            if (status == ALGSURF_OK)
                fuzz_check(memcmp(found + i * q->degree, e, (size_t)count * sizeof *e) == 0);
        }
    }
}

/* ---- the same roots, to more bits ---- */

/* The least bit of a number that is not 0. */
static int least_bit(double x) { return x == 0 ? INT_MAX : ilogb(x) - 52; }

static void integer_of(double x, int least, mpz_t whole, algsurf_integer *z) {
    mpz_set_d(whole, x == 0 ? 0 : scalbn(x, -least_bit(x)));
    if (x != 0) mpz_mul_2exp(whole, whole, (mp_bitcnt_t)(least_bit(x) - least));
    *z = (algsurf_integer){mpz_limbs_read(whole), mpz_sgn(whole) * (int)mpz_size(whole)};
}

/* Is the part of a root in the interval, up to roundings? */
static int is_near(const algsurf_integer *z, int exponent, algsurf_interval in) {
    long e;
    mpz_t whole;
    mpz_init(whole);
    mpz_import(whole, (size_t)abs(z->length), -1, sizeof *z->limbs, 0, 0, z->limbs);
    if (z->length < 0) mpz_neg(whole, whole);
    double x = mpz_get_d_2exp(&e, whole), pad = fmax(0x1p-50 * fmax(fabs(in.lo), fabs(in.hi)), 0x1p-1070);
    e += exponent;
    x = ldexp(x, e > 1100 ? 1100 : e < -1200 ? -1200 : (int)e);
    mpz_clear(whole);
    return in.lo - pad <= x && x <= in.hi + pad;
}

static void check_precise(const question *q, const algsurf_complex_root *e, int count) {
    mpz_t whole[2][TOP + 1];
    algsurf_integer c[2][TOP + 1];
    algsurf_precise_roots *roots = NULL;
    int least = INT_MAX, sum = 0, degree = q->degree;
    for (int k = 0; k <= q->degree; k++) {
        if (least_bit(q->c[k].re) < least) least = least_bit(q->c[k].re);
        if (least_bit(q->c[k].im) < least) least = least_bit(q->c[k].im);
    }
    for (int k = 0; k <= q->degree; k++) {
        mpz_inits(whole[0][k], whole[1][k], NULL);
        integer_of(q->c[k].re, least, whole[0][k], c[0] + k);
        integer_of(q->c[k].im, least, whole[1][k], c[1] + k);
    }
    while (degree > 0 && q->c[degree].re == 0 && q->c[degree].im == 0) degree--;
    fuzz_check(algsurf_precise_roots_create(c[0], is_real(q) ? NULL : c[1], q->degree, 100, 0, &roots) ==
               ALGSURF_OK);
    for (int i = 0; i < count; i++) {
        int inside = 0, different = 0, real = 0;
        algsurf_precise_root r;
        for (int j = 0; algsurf_precise_roots_get(roots, j, &r) == ALGSURF_OK; j++) {
            if (i == 0) sum += r.multiplicity;
            if (!is_near(&r.re, r.exponent, e[i].box.re) || !is_near(&r.im, r.exponent, e[i].box.im))
                continue;
            inside += r.multiplicity, different++, real += r.real;
        }
        fuzz_check(inside >= e[i].multiplicity);
        if (different == 1) fuzz_check(inside == e[i].multiplicity && real == e[i].real);
    }
    fuzz_check(count == 0 || sum == degree);
    algsurf_precise_roots_free(roots);
    for (int k = 0; k <= q->degree; k++) mpz_clears(whole[0][k], whole[1][k], NULL);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_numbers in = fuzz_numbers_of(data, size);
    question q = read_question(&in);
    algsurf_complex_root e[TOP + 1];
    int count = -77;
    algsurf_status status = solve(&q, e, &count);
    check_packet(&q, status, e, count);
    if (status < 0) {
        fuzz_check(count == -77);
        fuzz_check(status == ALGSURF_E_ZERO || status == ALGSURF_E_RANGE);
        return 0;
    }
    fuzz_check(status == ALGSURF_OK && count >= 0);
    check_form(&q, e, count);
    int exact = !(q.flags & RADII);
    if (exact && is_real(&q)) fuzz_check(case_mirrored(e, count));
    if (q.degree > JUDGED || fuzz_span(&q.c[0].re, 2 * q.degree + 2) * q.degree > MOST_BITS) return 0;
    if (exact && is_real(&q)) check_real_roots(&q, e, count);
    check_boxes(&q, q.c, e, count);
    if (exact) check_precise(&q, e, count);
    algsurf_complex c[TOP + 1];
    for (int up = 0; !exact && up < 2; up++) {
        member(&q, up, c);
        check_boxes(&q, c, e, count);
    }
    return 0;
}
