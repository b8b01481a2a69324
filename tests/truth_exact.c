/* truth_exact.c - the exact walk over the real polynomials of the corpus, against the certified answers.
 *
 *     truth_exact DATA_FOLDER
 *
 * For every polynomial: as many real roots as there are, in order, with their multiplicities, each in its
 * enclosure, which is a double or two neighbours. */
#include "poly_corpus.h"

#include "roots/exact_walk.h"

static int violations;
static long roots, multiple;

static void wrong(const poly_case *p, const char *what, int i) {
    violations++;
    printf("WRONG %s (%s, %s): root %d, %s\n", p->id, p->family, p->label, i, what);
}

/* The real roots in order. */
static int by_value(const void *a, const void *b) {
    const poly_root *const *x = a, *const *y = b;
    double dx = (*x)->re_hi, dy = (*y)->re_hi, ex = (*x)->re_lo, ey = (*y)->re_lo;
    return dx != dy ? (dx > dy) - (dx < dy) : (ex > ey) - (ex < ey);
}

static void judge(const poly_case *p) {
    static uint64_t block[512];
    const poly_root *real[ALGSURF_MAX_DEGREE];
    double c[ALGSURF_MAX_DEGREE + 1];
    int expected = 0, count = 0, found;
    for (int k = 0; k <= p->degree; k++) c[k] = p->c[k].re;
    for (int k = 0; k < p->distinct; k++)
        if (strpbrk(p->root[k].flags, "RZ")) real[expected++] = p->root + k;
    if (expected != p->distinct_real) wrong(p, "the corpus's flags", -1);
    qsort(real, (size_t)expected, sizeof *real, by_value);
    algsurf_memory m;
    algsurf_exact_walk walk;
    algsurf_exact_root r;
    algsurf_zpoly q;
    algsurf_memory_begin(&m, block, 512, (size_t)1 << 30);
    algsurf_memory_mark begin = algsurf_memory_here(&m);
    const int least = algsurf_zpoly_least_bit(c, 1, p->degree, 0);
    if (!algsurf_zpoly_from_doubles(&m, c, 1, p->degree, 0, least, &q) ||
        !algsurf_exact_begin(&walk, &m, &q, 0, -HUGE_VAL, HUGE_VAL, 1, NULL)) {
        wrong(p, "no memory", 0);
        return;
    }
    for (; (found = algsurf_exact_next(&walk, &r)) == ALGSURF_EXACT_ROOT; count++) {
        if (count >= expected) continue;
        const poly_root *truth = real[count];
        if (!poly_corpus_between(r.lo, truth->re_hi, truth->re_lo, r.hi)) wrong(p, "enclosure", count);
        if (r.multiplicity != truth->multiplicity) wrong(p, "multiplicity", count);
        if (r.lo != r.hi && nextafter(r.lo, HUGE_VAL) != r.hi) wrong(p, "width", count);
        roots++;
        multiple += r.multiplicity > 1;
    }
    if (found != ALGSURF_EXACT_END || count != expected) wrong(p, "the number of roots", count);
    algsurf_exact_end(&walk);
    algsurf_memory_release(&m, begin);
}

int main(int argc, char **argv) {
    int polynomials = 0;
    poly_corpus corpus = poly_corpus_read(truth_folder(argc, argv));
    for (size_t i = 0; i < corpus.count; i++) {
        if (!corpus.poly[i].real) continue;
        judge(&corpus.poly[i]);
        polynomials++;
    }
    printf("%d real polynomials, %ld roots, %ld of them multiple\n%d violations\n", polynomials, roots,
           multiple, violations);
    int poor = roots < 1400 || multiple < 70;
    if (poor) printf("WRONG: too few cases\n");
    poly_corpus_free(&corpus);
    return violations > 0 || poor;
}
