/* lattice.h - points of the unit square for the samples of a pixel: where soft shadows look.
 *
 * The 16 pixels of a tile of 4 x 4 share one lattice of rank 1, 16 N points for N a pixel, dealt out so that
 * pixels side by side have points far apart (Bayer's matrix): what is left of noise is as fine as pixels are,
 * and there are no bands.  Each tile's lattice is moved by a hash of where the tile is in the picture: so
 * points do not depend on slices.  (Cranley, Patterson 1976; the generator is near 2^32 / golden ratio^2.)
 * Points themselves are found side by side (lattice_template.h). */
#ifndef ALGSURF_LATTICE_H
#define ALGSURF_LATTICE_H
#include <stdint.h>

/* What the points are for; each has lattices of its own. */
enum { ALGSURF_I_FOR_AMBIENT = 0, ALGSURF_I_FOR_LIGHT = 1 }; /* that, or more: of light 0, 1 ... */

enum { ALGSURF_I_LATTICE_STEP = 16 }; /* from a sample's point to its next one */

/* A sample of a pixel of the picture. */
typedef struct algsurf_i_sample {
    int x, y;          /* the pixel */
    int number, count; /* the sample, from 0, of so many */
} algsurf_i_sample;

/* The sample's points in their lattice: its first one is this number, and how far the lattice is moved, in
 * units of 2^-32. */
typedef struct algsurf_i_lattice {
    double number, across, up;
} algsurf_i_lattice;

/* For `each` points of a sample. */
algsurf_i_lattice algsurf_i_lattice_of(const algsurf_i_sample *sample, int purpose, int each);

#endif
