/* truth_polys.c - all complex roots of the corpus's polynomials, against the certified answers.
 *
 *     truth_polys DATA_FOLDER
 *
 * For every polynomial the boxes are disjoint, hold as many roots as they say, and all roots; a real
 * polynomial has conjugate boxes; of a root that is alone it is said to be real exactly if it is.  A solver
 * that only says "somewhere" is no use either: roots that stand alone are alone in their box, and unless
 * ill-conditioned it is a few units in the last place wide. Catches: a disc that is too small, a step after
 * which the residual is not bounded anew, a box rounded inward, a root lost or counted twice, a cluster that
 * takes its neighbours along.  (Seen to fail with the discs a tenth of their size and with the ends of boxes
 * rounded inward.)
 */
#include "allroots_case.h"
#include "poly_corpus.h"

enum { WIDTHS = 64 };

static struct {
    int violations;
    long separated, alone;          /* roots that stand alone; those alone in their box */
    long widths, width[WIDTHS + 1]; /* of the parts of those: how many are so many ulps wide */
} tally;

static void wrong(const poly_case *p, const char *what) {
    tally.violations++;
    printf("WRONG %s (%s, %s): %s\n", p->id, p->family, p->label, what);
}

static void judge_boxes(const poly_case *p, const algsurf_complex_root *e, int count) {
    const char *what = case_boxes_wrong(p->degree, e, count);
    if (what) wrong(p, what);
    if (p->real && !case_mirrored(e, count)) wrong(p, "a real polynomial, and boxes that are not conjugate");
    for (int i = 0; i < count; i++) {
        int inside = 0, different = 0, reals = 0;
        for (int k = 0; k < p->distinct; k++) {
            if (!poly_root_in(&p->root[k], e[i].box)) continue;
            inside += p->root[k].multiplicity, different++;
            reals += strpbrk(p->root[k].flags, "RZ") != NULL;
        }
        if (inside != e[i].multiplicity) wrong(p, "a box does not hold as many roots as it says");
        if (different == 1 && e[i].real != reals) wrong(p, "real, or not, other than is said");
    }
}

/* Width in units in the last place of the root's part; parts that overflow or underflow do not count. */
static void measure(algsurf_interval part, double at) {
    if (!(fabs(at) < HUGE_VAL && fabs(at) > 0x1p-1000)) return;
    double ulps = (part.hi - part.lo) / ldexp(1, ilogb(at) - 52);
    tally.widths++;
    tally.width[ulps < WIDTHS ? (int)ceil(ulps) : WIDTHS]++;
}

static void judge_root(const poly_case *p, const poly_root *root, const algsurf_complex_root *e, int count) {
    const algsurf_complex_root *at = NULL;
    for (int i = 0; i < count; i++)
        if (poly_root_in(root, e[i].box)) at = &e[i];
    if (!at) {
        wrong(p, "a root is in no box");
        return;
    }
    int simple = root->multiplicity == 1, alone = at->multiplicity == 1;
    if (p->real && simple && alone && strchr(root->flags, 'R') && !at->real)
        wrong(p, "a real root, isolated, that is not said to be real");
    if (!simple || !(root->sep > 1e-6 * hypot(root->re_hi, root->im_hi))) return;
    tally.separated++;
    tally.alone += alone;
    if (!alone || root->kappa > 1e12) return;
    measure(at->box.re, root->re_hi);
    measure(at->box.im, root->im_hi);
}

static void judge(const poly_case *p) {
    algsurf_complex_root e[ALGSURF_MAX_DEGREE], again[ALGSURF_MAX_DEGREE];
    double real[ALGSURF_MAX_DEGREE + 1];
    int count = -1, count_again = -1;
    clock_t start = clock();
    algsurf_status status = algsurf_complex_roots(p->c, NULL, p->degree, e, &count);
    double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    if (status != ALGSURF_OK) {
        wrong(p, algsurf_status_text(status));
        return;
    }
    if (seconds > 1) wrong(p, "more than a second");
    judge_boxes(p, e, count);
    for (int k = 0; k < p->distinct; k++) judge_root(p, &p->root[k], e, count);
    if (!p->real) return;
    for (int k = 0; k <= p->degree; k++) real[k] = p->c[k].re;
    if (algsurf_complex_roots_of_real(real, NULL, p->degree, again, &count_again) != ALGSURF_OK ||
        count_again != count)
        wrong(p, "as a real polynomial it has other roots");
    for (int i = 0; i < count && count_again == count; i++)
        if (memcmp(&e[i].box, &again[i].box, sizeof e[i].box) != 0)
            wrong(p, "as a real polynomial it has other boxes");
}

/* The smallest number of ulps that holds the share of all widths. */
static int quantile(double share) {
    long below = 0;
    for (int w = 0; w <= WIDTHS; w++) {
        below += tally.width[w];
        if ((double)below >= share * (double)tally.widths) return w;
    }
    return WIDTHS;
}

int main(int argc, char **argv) {
    poly_corpus corpus = poly_corpus_read(truth_folder(argc, argv));
    for (size_t i = 0; i < corpus.count; i++) judge(&corpus.poly[i]);
    double alone = (double)tally.alone / (double)tally.separated;
    int median = quantile(0.5), most = quantile(0.99);
    printf("%zu polynomials, %ld roots that stand alone, %.2f %% of them alone in their box, widths %d ulp "
           "(median), %d ulp (99 %%)\n",
           corpus.count, tally.separated, 100 * alone, median, most);
    printf("%d violations\n", tally.violations);
    int poor = tally.separated < 5000 || alone < 0.99 || median > 2 || most > 4;
    if (poor) printf("WRONG: not as good as promised\n");
    poly_corpus_free(&corpus);
    return tally.violations > 0 || poor;
}
