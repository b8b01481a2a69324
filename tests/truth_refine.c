/* truth_refine.c - isolated and refined real roots of the corpus, against the certified answers.
 *
 *     truth_refine DATA_FOLDER
 *
 * Every real polynomial is isolated on the whole line, and on a finite interval, where doubles isolate and
 * leave wide brackets.  The default method takes each bracket, keeps its root and ends within two units in
 * the last place, in at most 1.5 times the time of the isolation (less than a third, measured).  Catches:
 * signs believed although rounding, overflow or underflow made them: 201 brackets of the finite intervals
 * were refused and 232 ended beside their root when plain values decided.
 */
#include "poly_corpus.h"

enum { REPEAT = 5 };

static int violations, brackets;
static double isolation, refinement; /* seconds */

static void wrong(const poly_case *p, const char *what, const algsurf_bracket *b,
                  const algsurf_refined_root *r) {
    violations++;
    printf("WRONG %s (%s, %s): %s, [%a,%a] -> [%a,%a]\n", p->id, p->family, p->label, what, b->lo, b->hi,
           r->lo, r->hi);
}

static int is_real(const poly_root *root) { return strpbrk(root->flags, "RZ") != NULL; }

/* Distinct real roots in [lo,hi]. */
static int roots_in(const poly_case *p, double lo, double hi) {
    int count = 0;
    for (int k = 0; k < p->distinct; k++)
        count += is_real(p->root + k) && poly_corpus_between(lo, p->root[k].re_hi, p->root[k].re_lo, hi);
    return count;
}

static void judge_bracket(const poly_case *p, const algsurf_bracket *b, algsurf_status status,
                          const algsurf_refined_root *r) {
    brackets++;
    if (status != ALGSURF_OK || !r->converged) {
        wrong(p, "refused", b, r);
        return;
    }
    int two_ulps = nextafter(nextafter(r->lo, HUGE_VAL), HUGE_VAL) >= r->hi;
    if (!(b->lo <= r->lo && r->lo <= r->root && r->root <= r->hi && r->hi <= b->hi))
        wrong(p, "not within its bracket", b, r);
    if (roots_in(p, r->lo, r->hi) == 0) wrong(p, "beside the root", b, r);
    if (!two_ulps) wrong(p, "wide", b, r);
    if (r->residual == 0 && roots_in(p, r->root, r->root) == 0) wrong(p, "zero, and no root", b, r);
}

static double seconds(void) { return (double)clock() / CLOCKS_PER_SEC; }

static void judge(const poly_case *p, double lo, double hi) {
    algsurf_bracket b[ALGSURF_MAX_DEGREE];
    algsurf_refined_root r[ALGSURF_MAX_DEGREE];
    algsurf_status status[ALGSURF_MAX_DEGREE];
    double c[ALGSURF_MAX_DEGREE + 1], begin = seconds();
    int count = 0;
    for (int k = 0; k <= p->degree; k++) c[k] = p->c[k].re;
    for (int i = 0; i < REPEAT; i++)
        if (algsurf_isolate_all(c, NULL, p->degree, lo, hi, NULL, b, ALGSURF_MAX_DEGREE, &count) !=
            ALGSURF_OK)
            abort();
    double between = seconds();
    for (int i = 0; i < REPEAT; i++)
        for (int j = 0; j < count; j++)
            if (b[j].kind == ALGSURF_BRACKET_ISOLATED)
                status[j] = algsurf_refine_poly(c, NULL, p->degree, b[j].lo, b[j].hi, NULL, r + j);
    isolation += between - begin;
    refinement += seconds() - between;
    for (int j = 0; j < count; j++)
        if (b[j].kind == ALGSURF_BRACKET_ISOLATED) judge_bracket(p, b + j, status[j], r + j);
}

/* A finite interval that holds the real roots that doubles hold, with no root at its ends. */
static double reach(const poly_case *p) {
    double farthest = 0;
    for (int k = 0; k < p->distinct; k++)
        if (is_real(p->root + k)) farthest = fmax(farthest, fabs(p->root[k].re_hi));
    return fmin(fmax(1.3 * farthest, DBL_MIN), DBL_MAX);
}

int main(int argc, char **argv) {
    poly_corpus corpus = poly_corpus_read(truth_folder(argc, argv));
    for (size_t i = 0; i < corpus.count; i++) {
        const poly_case *p = corpus.poly + i;
        if (!p->real) continue;
        judge(p, -HUGE_VAL, HUGE_VAL);
        judge(p, -reach(p), reach(p));
    }
    poly_corpus_free(&corpus);
    printf("%d brackets, refined in %.2f times the time of their isolation\n%d violations\n", brackets,
           refinement / isolation, violations);
    int poor = brackets < 2400 || refinement > 1.5 * isolation;
    if (poor) printf("WRONG: too few brackets, or too slow\n");
    return violations > 0 || poor;
}
