/* truth_zeros.c - the seed's root finder against polynomials whose roots are certified.
 *
 *     truth_zeros DATA_FOLDER
 *
 * Every polynomial of truth/polys.tsv is given to algsurf_paper_zeros with the cold start and with start
 * values on the unit circle.  A verified box must hold a root; one that is unique, exactly one, a simple one;
 * a complete answer, every root once.  How many simple roots are verified is printed for each family and may
 * not fall below a floor; boxes of well-conditioned roots must be as narrow as doubles allow.
 *
 * Prints a table for each start, a line for each violation, and fails if there is one.  Catches: a defect
 * without its rounding error, or in plain double (boxes too wide), an inclusion that is not one, a double
 * root called unique, two boxes on one root called complete, a failing cold start that is hidden.
 */
#include "allroots_case.h"
#include "poly_corpus.h"

enum { COLD, CIRCLE, STARTS, FAMILIES = 32 };
static const char *const start_name[STARTS] = {"cold start 0 + i", "unit circle"};

/* Percent of a family's simple roots that must be verified; a family that is not listed has no floor.
 * Chebyshev and Legendre polynomials are even or odd: the imaginary axis holds the cold start for ever. */
static const struct {
    const char *family;
    int floor[STARTS];
} required[] = {{"quad", {95, 95}},           {"cubic", {95, 95}},        {"wilkinson", {90, 90}},
                {"chebyshev", {0, 95}},       {"legendre", {0, 95}},      {"hermite_laguerre", {40, 95}},
                {"mignotte", {75, 85}},       {"unity", {15, 85}},        {"kirrinnis", {30, 70}},
                {"multiple", {95, 95}},       {"cluster", {90, 90}},      {"scale", {60, 60}},
                {"denormal", {85, 85}},       {"extreme", {50, 50}},      {"leadtiny", {95, 95}},
                {"zeroroots", {95, 95}},      {"sparse", {95, 95}},       {"random_real", {95, 95}},
                {"random_complex", {95, 95}}, {"raycomplex", {100, 100}}, {"axis", {75, 95}},
                {"linear", {100, 100}},       {"circle", {90, 95}},       {"nearreal", {95, 95}},
                {"series", {60, 95}},         {"jenkins_traub", {90, 90}}};

typedef struct tally {
    const char *family;
    int polynomials, simple, found, converged, complete, doubled;
} tally;

static tally tallies[STARTS][FAMILIES];
static double widths[STARTS][8192];
static int narrow_count[STARTS], violations;

static tally *tally_of(int start, const char *family) {
    tally *y = tallies[start];
    while (y->family && strcmp(y->family, family) != 0) y++;
    y->family = family;
    return y;
}

static void wrong(int start, const poly_case *p, int i, const char *what, const algsurf_paper_zero *z) {
    violations++;
    printf("WRONG %s %s %s, %s: %s, root %d: %a %a in [%a,%a] x [%a,%a]\n", p->id, p->family, p->label,
           start_name[start], what, i, z->root.re, z->root.im, z->box.re.lo, z->box.re.hi, z->box.im.lo,
           z->box.im.hi);
}

/* Half the larger side, relative to the root, of boxes around roots of a condition below 1000.  (A root that
 * did not converge may still be verified, from afar, in a wider box.) */
static void note_width(int start, const poly_root *root, algsurf_cinterval box) {
    double size = hypot(root->re_hi, root->im_hi);
    double side = fmax(box.re.hi - box.re.lo, box.im.hi - box.im.lo);
    if (root->kappa < 1000 && size > 1e-290 && size < 1e290)
        widths[start][narrow_count[start]++] = 0.5 * side / size;
}

static void judge_box(int start, const poly_case *p, int i, const algsurf_paper_zero *z) {
    int held = poly_roots_in(p, z->box), multiple = 0;
    if (!case_in(z->root, z->box)) wrong(start, p, i, "value outside the box", z);
    if (!z->verified) {
        if (z->unique) wrong(start, p, i, "unique without proof", z);
        return;
    }
    for (int k = 0; k < p->distinct; k++)
        if (poly_root_in(p->root + k, z->box)) {
            multiple |= p->root[k].multiplicity > 1;
            if (z->converged) note_width(start, p->root + k, z->box);
        }
    if (held == 0) wrong(start, p, i, "no root in a verified box", z);
    if (z->unique && (held != 1 || multiple)) wrong(start, p, i, "not the only, simple root", z);
}

static void judge(int start, const poly_case *p, const algsurf_paper_zero *z, int complete) {
    tally *y = tally_of(start, p->family);
    int verified = 0, touching = 0;
    y->polynomials++;
    y->complete += complete;
    for (int i = 0; i < p->degree; i++) {
        judge_box(start, p, i, z + i);
        y->converged += z[i].converged;
        verified += z[i].verified;
        for (int j = 0; j < i; j++) touching |= case_meet(z[i].box, z[j].box);
    }
    y->doubled += verified == p->degree && !complete;
    if (complete != (verified == p->degree && !touching))
        wrong(start, p, 0, "complete, or not, for no reason", z);
    for (int k = 0; k < p->distinct; k++) {
        int boxes = 0;
        for (int i = 0; i < p->degree; i++) boxes += z[i].verified && poly_root_in(p->root + k, z[i].box);
        y->simple += p->root[k].multiplicity == 1;
        y->found += p->root[k].multiplicity == 1 && boxes > 0;
        if (complete && boxes != 1) wrong(start, p, k, "complete, but not each root in a box of its own", z);
    }
}

static void solve(int start, const poly_case *p) {
    algsurf_complex from[ALGSURF_MAX_DEGREE];
    algsurf_paper_zero zeros[ALGSURF_MAX_DEGREE];
    int complete;
    for (int k = 0; k < p->degree; k++) from[k] = (algsurf_complex){cos(0.7 + 2.4 * k), sin(0.7 + 2.4 * k)};
    if (algsurf_paper_zeros(p->c, NULL, p->degree, start == COLD ? NULL : from, NULL, zeros, &complete) !=
        ALGSURF_OK) {
        violations++;
        printf("WRONG %s: refused\n", p->id);
        return;
    }
    judge(start, p, zeros, complete);
}

static int floor_of(int start, const char *family) {
    for (size_t i = 0; i < sizeof required / sizeof *required; i++)
        if (!strcmp(required[i].family, family)) return required[i].floor[start];
    return 0;
}

static void report(int start) {
    printf("\n%s\n%-17s polynomials complete  roots: simple verified  %%  floor  converged\n",
           start_name[start], "family");
    int doubled = 0;
    for (const tally *y = tallies[start]; y->family; y++) {
        double share = y->simple > 0 ? 100.0 * y->found / y->simple : 100;
        int least = floor_of(start, y->family);
        printf("%-17s %11d %8d %14d %8d %3.0f %5d %10d\n", y->family, y->polynomials, y->complete, y->simple,
               y->found, share, least, y->converged);
        doubled += y->doubled;
        if (share < least) {
            violations++;
            printf("WRONG %s: too few verified\n", y->family);
        }
    }
    printf("all verified, but two on one root: %d polynomials\n", doubled);
    violations += start == COLD && doubled == 0; /* there is such a case to tell */
}

static int by_size(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* A box of two neighbouring doubles has a relative radius of up to 2^-53; three: 2^-52. */
static void report_widths(int start) {
    int n = narrow_count[start];
    double *w = widths[start];
    qsort(w, (size_t)n, sizeof *w, by_size);
    double median = w[n / 2], most = w[n * 99 / 100];
    printf("relative radius, condition < 1000, %d roots: median %.2g, 99 %% %.2g, largest %.2g\n", n, median,
           most, w[n - 1]);
    if (n < 2000 || median > 0x1p-53 || most > 0x1p-52 || w[n - 1] > 0x1p-51) {
        violations++;
        printf("WRONG: boxes too wide\n");
    }
}

/* The even and odd ones: not one may pass for complete. */
static void expect_failures(void) {
    static const char *const families[] = {"chebyshev", "legendre"};
    for (int i = 0; i < 2; i++)
        if (tally_of(COLD, families[i])->complete > 0) {
            violations++;
            printf("WRONG %s: the cold start cannot have worked\n", families[i]);
        }
}

int main(int argc, char **argv) {
    poly_corpus corpus = poly_corpus_read(truth_folder(argc, argv));
    for (int start = 0; start < STARTS; start++) {
        for (size_t i = 0; i < corpus.count; i++) solve(start, corpus.poly + i);
        report(start);
        report_widths(start);
    }
    expect_failures();
    poly_corpus_free(&corpus);
    printf("\n%d violations\n", violations);
    return violations != 0;
}
