/* decided_report.h - what `decided` found out: a table, a file of it, charts. */
#ifndef DECIDED_REPORT_H
#define DECIDED_REPORT_H
#include "decided_cases.h"

/* One surface and kind; times in microseconds a ray. */
typedef struct finding {
    const char *surface;
    int degree;
    kind kind;
    size_t rays, open;          /* open: what doubles leave to integers */
    double us, us_low, us_high; /* median; what 10 and 90 % of the rays do not exceed */
    double lanes;               /* of a clear ray by doubles alone, median; NaN: they do not decide it */
} finding;

void report_table(const finding *f, size_t count);

/* decided.csv and decided.svg. */
void report_files(const finding *f, size_t count, const char *folder);

#endif
