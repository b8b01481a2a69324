/* accuracy_report.h - what accuracy found out: tables, charts, and advice. */
#ifndef ACCURACY_REPORT_H
#define ACCURACY_REPORT_H
#include "accuracy_ways.h"

enum { TOLERANCES = 16, MAX_REPEAT = 20, METHODS = 4, TIERS = 2, LINES = METHODS * TIERS + 2 * TIERS };

/* Falling; the last is 0: all that a double can tell. */
extern const double accuracy_tolerances[TOLERANCES];

/* A way, method and tier, with every tolerance. */
typedef struct line {
    setting setting; /* its tolerance plays no part */
    verdict verdict[TOLERANCES];
    size_t taken;                           /* times: entries of the following, each sorted */
    double seconds[TOLERANCES][MAX_REPEAT]; /* a ray */
    int settled;                            /* index as ways_settled tells; -1: not looked for */
} line;

typedef struct record {
    const catalogue_entry *entry;
    size_t rays, hits, open;
    double worst; /* error of the reference */
    line line[LINES];
} record;

/* Nanoseconds a ray: share 0 is the shortest time taken, 0.5 the median, 1 the longest. */
double line_ns(const line *l, int tolerance, double share);

/* The line of that setting. */
const line *record_line(const record *r, way w, int method, int tier);

void report_table(const record *r);
void report_advice(const record *records, int count);

/* accuracy.csv of all, accuracy_NAME.svg of each. */
void report_files(const record *records, int count, const char *folder);

#endif
