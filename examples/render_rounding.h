/* render_rounding.h - a word of warning where rounded coefficients change the picture. */
#ifndef RENDER_ROUNDING_H
#define RENDER_ROUNDING_H
#include "view.h"

/* An equation's coefficients are rounded to doubles, and the picture is that of the doubles.  Where more than
 * one in twenty of the rays that meet the surface may see it a pixel or more away, or not at all, for the
 * equation as it is written, that is told on standard error.  Some rays find it out, in a few milliseconds.
 */
void render_tell_of_rounding(const algsurf_surface *surface, const view *shown);

#endif
