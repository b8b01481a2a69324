/* render_space.h - the options of render about complex space, and those about sweeps. */
#ifndef RENDER_SPACE_H
#define RENDER_SPACE_H
#include "cli_surface.h"

enum { RENDER_MOST_PICTURES = 9999 }; /* of a sweep: their names have four digits */

/* What --sweep changes from picture to picture. */
typedef struct render_sweep {
    enum { SWEEP_NONE, SWEEP_TURN, SWEEP_DELTA, SWEEP_IMAG, SWEEP_LET } kind;
    int pictures;    /* 0: one picture, no sweep */
    int k;           /* of SWEEP_IMAG: the coefficient */
    char name[64];   /* of SWEEP_LET: the constant */
    double from, to; /* but for SWEEP_TURN: the first and the last picture's */
} render_sweep;

typedef struct render_space {
    int is_complex; /* 0: real space */
    algsurf_sector sector;
    double imaginary[ALGSURF_MAX_DEGREE + 1];
    int imaginary_given[ALGSURF_MAX_DEGREE + 1];
    algsurf_coherence coherence;
    const char *sigma, *delta, *coherent; /* the options' names; null: not given */
    const char *real_only;                /* an option given that only real space has */
} render_space;

/* Setters for the fields above. */
void render_set_sigma(const cli_option *option, const char *value, void *field);     /* render_space */
void render_set_delta(const cli_option *option, const char *value, void *field);     /* render_space */
void render_set_imaginary(const cli_option *option, const char *value, void *field); /* render_space */
void render_set_coherence(const cli_option *option, const char *value, void *field); /* render_space */
void render_set_sweep(const cli_option *option, const char *value, void *field);     /* render_sweep */

/* What the sweep sets in picture number `picture`, from 0: not for SWEEP_TURN. */
double render_sweep_value(const render_sweep *sweep, int picture);

/* Settles which space it is and fills in the defaults; ends the program when options do not go together. */
void render_check_space(render_space *space, const render_sweep *sweep);

/* Ends the program when an imaginary part is for a coefficient that the surface does not have. */
void render_check_degree(const render_space *space, const render_sweep *sweep, int degree);

/* The complex space of picture number `picture`, from 0; imaginary: room for its imaginary parts. */
algsurf_complex_space render_space_of(const render_space *space, const render_sweep *sweep, int picture,
                                      double imaginary[ALGSURF_MAX_DEGREE + 1]);

#endif
