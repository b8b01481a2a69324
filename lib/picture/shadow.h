/* shadow.h - which share of each light reaches the points of a row. */
#ifndef ALGSURF_SHADOW_H
#define ALGSURF_SHADOW_H
#include "algsurf/shade.h"
#include "line.h"
#include "../beams/segments.h"
#include "tally.h"

typedef struct algsurf_i_picture algsurf_i_picture; /* impl.h */

/* The samples of a picture's lights, where shadows are drawn: those of light l from first[l] to first[l+1]-1;
 * none of a light whose points differ from pixel to pixel. */
typedef struct algsurf_i_samples {
    double *place[2]; /* in the light's edges from its middle */
    int first[ALGSURF_MAX_LIGHTS + 1];
} algsurf_i_samples;

/* Sets light_samples.first; then light_samples.place, for which there is room. */
void algsurf_i_count_samples(algsurf_i_picture *picture);
void algsurf_i_place_samples(algsurf_i_picture *picture);

/* What is known of shadow rays for all rows; memory as for algsurf_i_frame_expand. */
void algsurf_i_make_shadows(const algsurf_i_picture *picture, void *memory);

/* line->visible of a row's points: the share of each light's points that nothing hides, 1 where that adds
 * nothing to the colour whatever the share, and that of free directions.  The rays shot are added to the
 * tally. */
algsurf_status algsurf_i_render_shadows(const algsurf_i_picture *picture, int row, algsurf_i_line *line,
                                        algsurf_i_tally *tally);

#endif
