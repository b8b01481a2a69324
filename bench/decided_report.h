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
    double beside;              /* of the other edition, median; NaN: there is none */
    double ratio;               /* its time of a ray in units of this edition's, median of the rays */
    size_t undecided, wrong;    /* rays that it leaves undecided, or answers wrongly */
} finding;

/* beside: what the other edition is called; null: there is none. */
void report_table(const finding *f, size_t count, const char *beside);

/* decided.csv and decided.svg. */
void report_files(const finding *f, size_t count, const char *beside, const char *folder);

#endif
