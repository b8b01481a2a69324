/* poly_corpus.h - the corpus's polynomials with all their roots, known beyond doubt (tests/data/truth:
 * polys.tsv, poly_roots.tsv).
 *
 * Reading ends the program with a message when the corpus cannot be read: a test without its data has failed.
 */
#ifndef POLY_CORPUS_H
#define POLY_CORPUS_H
#include "algsurf/interval.h"
#include "truth_corpus.h"

/* A distinct root.  Its parts are hi + lo to 2^-104, relative; lo is 0 exactly when the part is the double
 * hi, and else has the sign of part - hi, both barring underflow (|hi| > 1e-290).  A part beyond the range
 * of double has hi = +-inf. */
typedef struct poly_root {
    double re_hi, re_lo, im_hi, im_lo;
    int multiplicity;
    const char *flags;        /* letters: Z zero, R real, I imaginary, D diagonal, E exactly (re_hi, im_hi),
                                 o overflows, u underflows; - none */
    double kappa, acond, sep; /* relative condition, inf when multiple; absolute; distance to the next root */
} poly_root;

typedef struct poly_case {
    const char *id, *family, *label;
    int degree;                  /* 1..64 */
    int real;                    /* all imaginary parts are 0 */
    int distinct, distinct_real; /* roots */
    const algsurf_complex *c;    /* degree+1 coefficients, lowest first; the last is not 0 */
    const poly_root *root;       /* `distinct` of them; multiplicities add up to degree */
} poly_case;

typedef struct poly_corpus {
    size_t count;
    poly_case *poly;
    algsurf_complex *c;
    poly_root *root;
    truth_table polys, roots;
} poly_corpus;

/* The corpus in folder/truth. */
poly_corpus poly_corpus_read(const char *folder);
void poly_corpus_free(poly_corpus *corpus);

/* lo <= part_hi + part_lo <= hi, exactly.  Where part_lo has underflowed to 0 the part may be on either side
 * of part_hi, but then every interval with ends in double that holds it holds part_hi too: no false alarm. */
int poly_corpus_between(double lo, double part_hi, double part_lo, double hi);
/* Is the root in the box? */
int poly_root_in(const poly_root *root, algsurf_cinterval box);
/* How many of a polynomial's distinct roots are in the box. */
int poly_roots_in(const poly_case *p, algsurf_cinterval box);

#endif
