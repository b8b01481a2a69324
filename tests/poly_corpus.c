/* poly_corpus.c - the two tables into polynomials; the exact test for a root in a box. */
#include "poly_corpus.h"

enum { ID, FAMILY, LABEL, FIELD, DEGREE = 5, DISTINCT, DISTINCT_REAL, COEFFS, POLY_COLUMNS };
enum { ROOT_ID, MULT = 2, FLAGS, RE_HI = 6, RE_LO, IM_HI, IM_LO, KAPPA, ACOND, SEP, ROOT_COLUMNS };

static void *room_for(size_t count, size_t size) {
    void *p = calloc(count, size);
    if (!p) truth_give_up("no memory", "");
    return p;
}

/* degree+1 items `re,im` */
static void read_coefficients(const char *text, int degree, algsurf_complex *c) {
    for (int k = 0; k <= degree; k++) {
        char *end;
        c[k].re = strtod(text, &end);
        if (end == text || *end != ',') truth_give_up("not a coefficient", text);
        text = end + 1;
        c[k].im = strtod(text, &end);
        if (end == text || *end != (k < degree ? ' ' : '\0')) truth_give_up("not a coefficient", text);
        text = end + 1;
    }
}

static poly_root read_root(const truth_table *t, size_t row) {
#define NUMBER(column) truth_number(truth_cell(t, row, column))
    return (poly_root){NUMBER(RE_HI), NUMBER(RE_LO),     NUMBER(IM_HI),
                       NUMBER(IM_LO), (int)NUMBER(MULT), truth_cell(t, row, FLAGS),
                       NUMBER(KAPPA), NUMBER(ACOND),     NUMBER(SEP)};
#undef NUMBER
}

/* The rows of a polynomial's roots stand together, in the order of the polynomials. */
static size_t read_roots(poly_corpus *corpus, poly_case *p, size_t row) {
    int sum = 0;
    p->root = corpus->root + row;
    for (int i = 0; i < p->distinct; i++, row++) {
        if (row >= corpus->roots.rows || strcmp(truth_cell(&corpus->roots, row, ROOT_ID), p->id) != 0)
            truth_give_up("roots are missing", p->id);
        corpus->root[row] = read_root(&corpus->roots, row);
        sum += corpus->root[row].multiplicity;
    }
    if (sum != p->degree) truth_give_up("multiplicities do not add up", p->id);
    return row;
}

poly_corpus poly_corpus_read(const char *folder) {
    poly_corpus corpus = {.polys = truth_read(folder, "polys.tsv", POLY_COLUMNS),
                          .roots = truth_read(folder, "poly_roots.tsv", ROOT_COLUMNS)};
    const truth_table *t = &corpus.polys;
    size_t coefficients = 0, row = 0;
    corpus.count = t->rows;
    for (size_t i = 0; i < t->rows; i++) coefficients += (size_t)truth_number(truth_cell(t, i, DEGREE)) + 1;
    corpus.poly = room_for(t->rows, sizeof *corpus.poly);
    corpus.c = room_for(coefficients, sizeof *corpus.c);
    corpus.root = room_for(corpus.roots.rows, sizeof *corpus.root);
    algsurf_complex *c = corpus.c;
    for (size_t i = 0; i < t->rows; i++) {
        poly_case *p = corpus.poly + i;
        p->id = truth_cell(t, i, ID), p->family = truth_cell(t, i, FAMILY),
        p->label = truth_cell(t, i, LABEL);
        p->real = truth_cell(t, i, FIELD)[0] == 'R';
        p->degree = (int)truth_number(truth_cell(t, i, DEGREE));
        p->distinct = (int)truth_number(truth_cell(t, i, DISTINCT));
        p->distinct_real = (int)truth_number(truth_cell(t, i, DISTINCT_REAL));
        read_coefficients(truth_cell(t, i, COEFFS), p->degree, c);
        p->c = c;
        c += p->degree + 1;
        row = read_roots(&corpus, p, row);
    }
    if (row != corpus.roots.rows)
        truth_give_up("roots without a polynomial", truth_cell(&corpus.roots, row, ROOT_ID));
    return corpus;
}

void poly_corpus_free(poly_corpus *corpus) {
    free(corpus->poly);
    free(corpus->c);
    free(corpus->root);
    truth_free(&corpus->polys);
    truth_free(&corpus->roots);
    *corpus = (poly_corpus){0};
}

int poly_corpus_between(double lo, double part_hi, double part_lo, double hi) {
    return (lo < part_hi || (lo == part_hi && part_lo >= 0)) &&
           (hi > part_hi || (hi == part_hi && part_lo <= 0));
}

int poly_root_in(const poly_root *root, algsurf_cinterval box) {
    return poly_corpus_between(box.re.lo, root->re_hi, root->re_lo, box.re.hi) &&
           poly_corpus_between(box.im.lo, root->im_hi, root->im_lo, box.im.hi);
}

int poly_roots_in(const poly_case *p, algsurf_cinterval box) {
    int count = 0;
    for (int i = 0; i < p->distinct; i++) count += poly_root_in(p->root + i, box);
    return count;
}
