/* allroots_case.h - polynomials built from their roots, and the verdict on boxes that claim to hold them.
 *
 * The roots are doubles and the coefficients are multiplied out exactly; a case whose coefficients are not
 * doubles is either dropped or solved with radii that cover the rounding.
 */
#ifndef ALLROOTS_CASE_H
#define ALLROOTS_CASE_H
#include <float.h>

#include "algsurf/allroots.h"
#include "exact.h"

enum { CASE_MAX = 64 };

typedef struct allroots_case {
    int n;
    algsurf_complex root[CASE_MAX]; /* with repetitions */
    algsurf_complex c[CASE_MAX + 1];
    double r[CASE_MAX + 1]; /* bound on the rounding of c */
    int exact;              /* all r are 0 */
} allroots_case;

static inline void case_add(allroots_case *p, double re, double im, int multiplicity) {
    for (; multiplicity > 0 && p->n < CASE_MAX; multiplicity--) p->root[p->n++] = (algsurf_complex){re, im};
}

/* Rounded to a double; *off grows by a bound on the error. */
static inline double case_round(const mpq_t q, double *off) {
    mpq_t back;
    double x = mpq_get_d(q);
    mpq_init(back), mpq_set_d(back, x);
    if (!mpq_equal(back, q)) *off += DBL_EPSILON * fabs(x) + DBL_TRUE_MIN; /* mpq_get_d truncates */
    mpq_clear(back);
    return x;
}

/* c = lead times the product of (X - root), lead a double. */
static inline void case_expand(allroots_case *p, double lead) {
    mpq_t re[CASE_MAX + 1], im[CASE_MAX + 1], a, b, t;
    mpq_inits(a, b, t, NULL);
    for (int k = 0; k <= p->n; k++) mpq_inits(re[k], im[k], NULL);
    mpq_set_d(re[0], lead);
    for (int i = 0; i < p->n; i++) {
        mpq_set_d(a, p->root[i].re), mpq_set_d(b, p->root[i].im);
        for (int k = i + 1; k >= 0; k--) { /* c_k = c_(k-1) - root c_k */
            mpq_t x, y;
            mpq_inits(x, y, NULL);
            mpq_mul(x, re[k], a), mpq_mul(t, im[k], b), mpq_sub(x, x, t);
            mpq_mul(y, re[k], b), mpq_mul(t, im[k], a), mpq_add(y, y, t);
            mpq_neg(x, x), mpq_neg(y, y);
            if (k > 0) mpq_add(x, x, re[k - 1]), mpq_add(y, y, im[k - 1]);
            mpq_swap(re[k], x), mpq_swap(im[k], y);
            mpq_clears(x, y, NULL);
        }
    }
    p->exact = 1;
    for (int k = 0; k <= p->n; k++) {
        p->r[k] = 0;
        p->c[k].re = case_round(re[k], &p->r[k]);
        p->c[k].im = case_round(im[k], &p->r[k]);
        if (p->r[k] > 0) p->exact = 0;
        mpq_clears(re[k], im[k], NULL);
    }
    mpq_clears(a, b, t, NULL);
}

static inline int case_meet(algsurf_cinterval a, algsurf_cinterval b) {
    return a.re.lo <= b.re.hi && b.re.lo <= a.re.hi && a.im.lo <= b.im.hi && b.im.lo <= a.im.hi;
}

static inline int case_in(algsurf_complex z, algsurf_cinterval box) {
    return box.re.lo <= z.re && z.re <= box.re.hi && box.im.lo <= z.im && z.im <= box.im.hi;
}

/* What is wrong with the boxes of a polynomial of degree n, whatever its roots; null: nothing. */
static inline const char *case_boxes_wrong(int n, const algsurf_complex_root *e, int count) {
    int sum = 0;
    for (int i = 0; i < count; i++) {
        if (e[i].multiplicity < 1) return "a multiplicity below 1";
        if (!case_in(e[i].root, e[i].box)) return "a value outside of its box";
        if (!isfinite(e[i].root.re) || !isfinite(e[i].root.im)) return "a value that is not finite";
        if (e[i].real && (e[i].box.im.lo != 0 || e[i].box.im.hi != 0)) return "real, but not on the axis";
        for (int j = 0; j < i; j++)
            if (case_meet(e[i].box, e[j].box)) return "two boxes meet";
        sum += e[i].multiplicity;
    }
    return sum == n ? NULL : "multiplicities that do not add up to the degree";
}

/* The same, and each box must hold as many of the roots as it says. */
static inline const char *case_wrong(const allroots_case *p, const algsurf_complex_root *e, int count) {
    const char *what = case_boxes_wrong(p->n, e, count);
    for (int i = 0; !what && i < count; i++) {
        int inside = 0;
        for (int k = 0; k < p->n; k++) inside += case_in(p->root[k], e[i].box);
        if (inside != e[i].multiplicity) what = "a box that does not hold as many roots as it says";
    }
    return what;
}

/* Of a real polynomial: are the boxes each other's images in the axis? */
static inline int case_mirrored(const algsurf_complex_root *e, int count) {
    for (int i = 0; i < count; i++) {
        int images = 0;
        for (int j = 0; j < count; j++)
            images += e[i].box.re.lo == e[j].box.re.lo && e[i].box.re.hi == e[j].box.re.hi &&
                      e[i].box.im.lo == -e[j].box.im.hi && e[i].box.im.hi == -e[j].box.im.lo &&
                      e[i].multiplicity == e[j].multiplicity && e[i].root.re == e[j].root.re &&
                      e[i].root.im == -e[j].root.im;
        if (images != 1) return 0;
    }
    return 1;
}

/* Boxes for people, with hexadecimal numbers that read back exactly. */
static inline void case_print(const allroots_case *p, const algsurf_complex_root *e, int count) {
    for (int k = 0; k < p->n; k++) fprintf(stderr, "root %a %+a i\n", p->root[k].re, p->root[k].im);
    for (int k = 0; k <= p->n; k++)
        fprintf(stderr, "c[%d] = %a %+a i, r %a\n", k, p->c[k].re, p->c[k].im, p->r[k]);
    for (int i = 0; i < count; i++)
        fprintf(stderr, "box [%a, %a] + [%a, %a] i, multiplicity %d\n", e[i].box.re.lo, e[i].box.re.hi,
                e[i].box.im.lo, e[i].box.im.hi, e[i].multiplicity);
}

#endif
