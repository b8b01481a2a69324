/* shade_impl.h - checks of lights and materials, and colours without checks, for other files of this room. */
#ifndef ALGSURF_SHADE_IMPL_H
#define ALGSURF_SHADE_IMPL_H
#include "algsurf/shade.h"
#include "colours.h"

#define ALGSURF_MAX_LIGHT_SAMPLES 64 /* along one edge */

/* Each: OK, E_ARGUMENT (null, out of range) or E_NOT_FINITE. */
algsurf_status algsurf_i_colour_check(const double colour[3]);
algsurf_status algsurf_i_material_read(const algsurf_material *given, algsurf_material *material);
algsurf_status algsurf_i_lights_check(const algsurf_light *lights, int count);

/* Where sample (a, b) of a light is, in its edges from its middle. */
void algsurf_i_light_place(const algsurf_light *light, int a, int b, double place[2]);

/* For a checked lighting, without its curve. */
void algsurf_i_colour_prepare(const algsurf_lighting *lighting, int preview, algsurf_i_colour_job *job);

/* Of entry i of `looks`. */
void algsurf_i_set_look(const algsurf_i_look_frame *frame, const double position[3], const double normal[3],
                        const double direction[3], int i, const algsurf_i_looks *looks);

#endif
