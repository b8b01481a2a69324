/* verified_roots_report.h - what verified_roots found out: a table, numbers as CSV, charts. */
#ifndef VERIFIED_ROOTS_REPORT_H
#define VERIFIED_ROOTS_REPORT_H
#include <stddef.h>

/* One solver and start on one family of polynomials. */
typedef struct row {
    char family[24];
    const char *solver, *start;
    int degree, cluster; /* cluster 0: a family without */
    double gap;
    size_t polynomials;
    double complete, simple; /* per cent */
    double ulps50, ulps99;   /* NaN: no box was verified */
    double widest;           /* of a polynomial's verified boxes, real or imaginary part: median */
    double us;
} row;

void report_table(const row *rows, int count, int seed, int tsv);

/* verified_roots.csv, verified_roots_degree.svg, verified_roots_cluster.svg. */
void report_files(const row *rows, int count, const char *folder);

#endif
