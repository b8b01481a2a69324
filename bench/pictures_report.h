/* pictures_report.h - what pictures measured, as tables and charts. */
#ifndef PICTURES_REPORT_H
#define PICTURES_REPORT_H
#include "pictures_draw.h"

enum { MAX_REPEAT = 100, MAX_KERNELS = 8, MAX_MANNERS = 2 * MAX_KERNELS + 8 };

/* First the kernels, the fastest first, then their floors in the same order, then the others. */
typedef struct plan {
    manner manner[MAX_MANNERS];
    int kernels, count;
} plan;

typedef struct times {
    size_t count;
    int threads;
    double seconds[PARTS][MAX_REPEAT]; /* sorted, each by itself */
} times;

/* A surface, drawn in all of them. */
typedef struct result {
    const catalogue_entry *entry;
    size_t rays, hits;
    times times[MAX_MANNERS];
} result;

typedef struct report {
    const plan *plan;
    const result *results;
    int surfaces, width, height, repeat;
} report;

/* The tables on standard output. */
void report_print(const report *r, int tsv);

/* pictures.csv, pictures_floor.csv, pictures.svg; ends the program when they cannot be written. */
void report_write(const report *r, const char *folder);

#endif
