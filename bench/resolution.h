/* resolution.h - what the benchmark resolution measures: one surface, one width of the picture. */
#ifndef RESOLUTION_H
#define RESOLUTION_H
#include "catalogue.h"

enum { MOST_WIDTHS = 16, MOST_TAKES = 64, MOST_SHOWN = 7 }; /* surfaces: colours that plot.h has */

typedef struct measured {
    int width, height;
    int takes;                  /* pictures that were timed */
    double ns[3];               /* for each ray: median, least, most */
    double by_rows, by_singles; /* shares of the rays: solved with their rows, by themselves */
} measured;

typedef struct record {
    const catalogue_entry *entry;
    measured at[MOST_WIDTHS];
} record;

typedef struct report {
    const record *records;
    int surfaces, widths; /* each record has so many */
} report;

/* The table on standard output. */
void report_print(const report *r, int tsv);

/* resolution.csv, resolution.svg; ends the program when they cannot be written. */
void report_write(const report *r, const char *folder);

#endif
