/* colours.h - what is lit, checked, and the colours of points, by every kernel; linear light as bytes. */
#ifndef ALGSURF_PICTURE_COLOURS_H
#define ALGSURF_PICTURE_COLOURS_H
#include "../beams/rows.h"
#include "algsurf/shade.h"

/* An algsurf_lighting, checked, as colours are computed from it. */
typedef struct algsurf_i_colour_job {
    algsurf_material material;
    double richer[2][3]; /* of outside, inside: what their shade has more of */
    int light_count;
    double light[ALGSURF_MAX_LIGHTS][3]; /* their middles, from the centre, in the radius */
    double light_colour[ALGSURF_MAX_LIGHTS][3];
    algsurf_i_look_frame frame;
    double up[3], forward[3];
    int bounded, preview;
    const uint8_t *curve; /* of sRGB, where bytes are asked for */
} algsurf_i_colour_job;

/* In floats, twice as many at once. */
typedef struct algsurf_i_colour_kernel {
    /* colour[3 i ..] of entry i, as algsurf_shade; or, where colour is null, bytes[i], red + 256 green +
     * 65536 blue.  visible: null or light_count + 1 for each entry. */
    void (*colours)(const algsurf_i_colour_job *job, const algsurf_i_looks *looks, int count,
                    const double *visible, float *colour, uint32_t *bytes);
    /* Sets marks[i] to 1 where bytes[i] is further than the limit from others[i]. */
    void (*mark_bytes)(const uint8_t *bytes, const uint8_t *others, int count, int limit, uint8_t *marks);
} algsurf_i_colour_kernel;

ALGSURF_KERNEL_TABLES(colour);

#define ALGSURF_MAX_LIGHT_SAMPLES 64 /* along one edge */

/* Each: OK, E_ARGUMENT (null, out of range) or E_NOT_FINITE. */
algsurf_status algsurf_i_colour_check(const double colour[3]);
algsurf_status algsurf_i_material_read(const algsurf_material *given, algsurf_material *material);
algsurf_status algsurf_i_lights_check(const algsurf_light *lights, size_t count);

/* Where sample (a, b) of a light is, in its edges from its middle. */
void algsurf_i_light_place(const algsurf_light *light, int a, int b, double place[2]);

/* For a checked lighting, without its curve. */
void algsurf_i_colour_prepare(const algsurf_lighting *lighting, int preview, algsurf_i_colour_job *job);

/* Of entry i of `looks`. */
void algsurf_i_set_look(const algsurf_i_look_frame *frame, const double position[3], const double normal[3],
                        const double direction[3], int i, const algsurf_i_looks *looks);

/* ---- srgb.c: from linear light to the bytes of sRGB (IEC 61966-2-1) ---- */

#define SRGB_STEPS 4096 /* of linear light, from 0 to 1: next to black one is 0.8 of a byte */

/* The byte of each step. */
void algsurf_i_srgb_curve(uint8_t curve[SRGB_STEPS]);

/* The step of 0 <= light <= 1.  The casts round where C computes with more than floats. */
static inline int algsurf_i_srgb_step(float light) {
    return (int)(float)((float)((SRGB_STEPS - 1) * light) + 0.5f);
}

/* The byte of 0 <= light <= 1. */
static inline uint8_t algsurf_i_byte_of(const uint8_t curve[SRGB_STEPS], double light) {
    return curve[algsurf_i_srgb_step((float)light)];
}

#endif
