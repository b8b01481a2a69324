/* plot_label.h - the numbers beside points. */
#ifndef PLOT_LABEL_H
#define PLOT_LABEL_H
#include "plot_draw.h"

/* Those of series number `index` of a chart, in the frame's coordinates. */
void plot_put_numbers(FILE *out, const plot *p, size_t index, const plot_frame *f);

#endif
