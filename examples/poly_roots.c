/* poly_roots.c - the smallest program that uses libalgsurf on polynomials: all roots in an interval.
 *
 *     cc -O2 -I../include poly_roots.c $(find ../lib -name "*.c") -lm -pthread -o poly_roots
 */
#include <stdio.h>

#include "algsurf/algsurf.h"

int main(int argc, char **argv) {
    if (argc > 1) {
        fprintf(stderr, "%s: takes no arguments\n", argv[0]);
        return 2;
    }
    /* (t-1)(t-2)(t-3)(t^2-2), lowest degree first: three roots and sqrt(2) lie in [0, 4] */
    const double c[] = {12, -22, 6, 9, -6, 1};
    enum { DEGREE = sizeof c / sizeof *c - 1 };

    algsurf_bracket bracket[DEGREE];
    int count;
    algsurf_status status = algsurf_isolate_all(c, NULL, DEGREE, 0, 4, NULL, bracket, DEGREE, &count);
    if (status != ALGSURF_OK) {
        printf("not every root could be isolated: %s\n", algsurf_status_text(status));
        return 1;
    }
    for (int i = 0; i < count; i++) {
        algsurf_refined_root root = {.root = bracket[i].lo}; /* exact, when the bracket is a point */
        if (bracket[i].kind == ALGSURF_BRACKET_ISOLATED)
            algsurf_refine_poly(c, NULL, DEGREE, bracket[i].lo, bracket[i].hi, NULL, &root);
        printf("%.17g\n", root.root);
    }
    return 0;
}
