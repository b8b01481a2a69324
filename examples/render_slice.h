/* render_slice.h - what a slice of a picture (--rows) says about itself, so that slices can be joined.
 *
 * A slice is a PPM with one line of comment behind its first: the size of the whole picture, the rows from A
 * to B-1, and digests of the job, of the rows' pixels and of their hits (0: none were written):
 *     # algsurf slice 1024x768 rows 0:384 job 89abcdef01234567 pixels 0123456789abcdef hits 0000000000000000
 * The job is all that the picture depends on, the library's version included; threads, kernel and coherence
 * are not part of it.  The digests are FNV-1a of 64 bits (Fowler, Noll, Vo), against accidents, not intent.
 */
#ifndef RENDER_SLICE_H
#define RENDER_SLICE_H
#include "render_options.h"

typedef struct render_slice {
    int width, height; /* of the whole picture */
    int begin, end;    /* its rows, 0 <= begin < end <= height */
    uint64_t job, pixels, hits;
} render_slice;

typedef struct render_slice_note {
    char text[160];
} render_slice_note;

/* The comment, without "# " and the end of the line; and back: 0 when the text is none. */
render_slice_note render_slice_write(const render_slice *slice);
int render_slice_read(const char *text, render_slice *slice);

/* space: null in real space. */
uint64_t render_job_digest(const render_options *options, const algsurf_surface *surface,
                           const algsurf_extent *extent, const algsurf_camera *camera,
                           const algsurf_complex_space *space);
uint64_t render_pixels_digest(const uint8_t *pixels, size_t bytes);
uint64_t render_hits_digest(const double *hits, size_t count);

#endif
