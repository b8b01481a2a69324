/* render_stats.h - what a picture took, as --stats writes it. */
#ifndef RENDER_STATS_H
#define RENDER_STATS_H
#include "output.h"
#include "render_options.h"

/* Lines "key<TAB>value", or one JSON object if the file's name ends in .json. */
void render_write_stats(output_set *set, const char *path, const render_options *options,
                        const algsurf_surface *surface, const algsurf_render_stats *stats);

#endif
