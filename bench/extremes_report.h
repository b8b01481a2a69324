/* extremes_report.h - what `extremes` found out: tables, and files of them with charts. */
#ifndef EXTREMES_REPORT_H
#define EXTREMES_REPORT_H
#include "extremes_truth.h"

enum { MOST_POINTS = 16 };

/* All rays of one value of a sweep, asked in one manner. */
typedef struct finding {
    size_t rays, hits, undecided;   /* hits: of the truth */
    double error_median, error_max; /* of t, in units of u kappa |t|; NaN: there is none */
    double ns, ns_min, ns_max;      /* a ray */
} finding;

typedef struct record {
    const sweep *sweep;
    finding finding[MOST_POINTS][MANNERS];
} record;

void report_table(const record *r);

/* extremes.csv of all, extremes_NAME.svg of each. */
void report_files(const record *records, size_t count, const char *folder);

#endif
