/* zerofind_plot.h - the polynomial on the chord, its first bracket close up, and how the iterates converge.
 */
#ifndef ZEROFIND_PLOT_H
#define ZEROFIND_PLOT_H
#include <stdio.h>

#include "zerofind_solve.h"

typedef struct zerofind_words {
    const char *surface, *ray; /* as the reader knows them */
    int method;
    const char *t_label;
} zerofind_words;

/* Writes the plot as an SVG document.  Returns 0, or -1 for want of memory. */
int zerofind_plot(const zerofind *z, const zerofind_words *words, FILE *out);

#endif
