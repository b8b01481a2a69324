/* results.h - the folder that a benchmark's --output names, and the files in it.  All of these end the
 * program when they cannot do what they are for, and leave no half of a file. */
#ifndef RESULTS_H
#define RESULTS_H
#include <stdio.h>

#include "plot.h"

/* Makes the folder; one that is there already will do. */
void results_folder(const char *folder);

/* A file to be written, and its end. */
FILE *results_create(const char *folder, const char *name);
void results_finish(FILE *file, const char *folder, const char *name);

/* Charts, one below the other, as SVG. */
void results_plot(const plot *plots, size_t count, const char *folder, const char *name);

#endif
