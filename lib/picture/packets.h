/* packets.h - rays side by side: a picture's geometry, and the rows that are solved by it.
 *
 * All rays of a picture share a view (view.c); those of a row are pixels of one job.  Rays whose answer is
 * open then, and those of scenes without a view, go in packets of their own. */
#ifndef ALGSURF_PACKETS_H
#define ALGSURF_PACKETS_H
#include "kernel.h"
#include "line.h"
#include "shadow_kernel.h"
#include "tally.h"

typedef struct algsurf_i_picture algsurf_i_picture; /* impl.h */
typedef struct algsurf_i_worker algsurf_i_worker;   /* there, too */

/* What packets need to know of a picture. */
typedef struct algsurf_i_packets {
    algsurf_i_frame_form frame;
    int orthographic;
    double origin[2], per_slope, pixel; /* u = origin[0] + per_slope (x - width/2) pixel; v likewise */
    double near;                        /* depth of the eye */
    double extent_size[3], tolerance;   /* in the view's unit */
    /* the planes that cut something off, in the axes of the view and in those of the caller */
    algsurf_i_cut_plane view_planes[ALGSURF_MAX_CLIP_PLANES], planes[ALGSURF_MAX_CLIP_PLANES];
    int plane_count;
    double thin_side, thin_large; /* as in algsurf_i_row_job */
    double *beams;            /* in a tiled picture: algsurf_i_beam_expand's g */
    algsurf_i_fan *fans;      /* where shadows are drawn: of each light; or null */
    algsurf_i_taylor *taylor; /* there: for single rays; or null */
    /* complex space: as in algsurf_i_complex_job */
    algsurf_i_sector_edges sector;
    double imaginary[ALGSURF_MAX_DEGREE + 1];
    int top;
} algsurf_i_packets;

/* Fills a picture's packets, but for the frame's arrays; 0 if this scene is not one for them. */
int algsurf_i_packets_geometry(const algsurf_i_picture *picture, algsurf_i_packets *packets);

/* The pixels of a row whose rays may meet what is shown: begin <= x < end; all others surely miss it. */
void algsurf_i_packets_range(const algsurf_i_row_job *job, int width, int *begin, int *end);

/* What the jobs of all rows have in common; the offset is that of the pixels' left edges. */
algsurf_i_row_job algsurf_i_any_row(const algsurf_i_picture *picture);

/* The row's job, without its form's coefficients. */
void algsurf_i_make_row(const algsurf_i_picture *picture, double y, double sx, algsurf_i_row_form *form,
                        algsurf_i_row_job *job);

/* The row's form and job, through offset sx in each pixel, y from the top; and the pixels whose rays may meet
 * what is shown.  0: there are none, or they reach beyond the bounds of forms. */
int algsurf_i_begin_row(const algsurf_i_picture *picture, double y, double sx, algsurf_i_row_form *form,
                        algsurf_i_row_job *job, int *begin, int *end);

/* Are there forms for tiles as small as pixels, and all rays of a row within their bounds? */
int algsurf_i_has_cells(const algsurf_i_picture *picture, double y);

/* The pixels between two heights, counted from the top, whose rays are within the bounds of forms, and so are
 * those of `margin` pixels beside them, and of one above and below. */
void algsurf_i_range_within_bounds(const algsurf_i_picture *picture, double top, double bottom, int margin,
                                   int *begin, int *end);

/* The rays of undecided samples, begin <= x < end, as packets: their points go to the line. */
algsurf_status algsurf_i_solve_undecided(const algsurf_i_picture *picture, double y, double sx, int begin,
                                         int end, algsurf_i_line *line, algsurf_i_tally *tally);

/* The points of a row seen through offset (sx,sy) in each pixel. */
algsurf_status algsurf_i_render_packets(const algsurf_i_picture *picture, int row, double sx, double sy,
                                        algsurf_i_worker *worker, algsurf_i_tally *tally);

/* The same where there is no frame: each pixel's own ray. */
algsurf_status algsurf_i_render_rays(const algsurf_i_picture *picture, int row, double sx, double sy,
                                     algsurf_i_line *line, algsurf_i_tally *tally);

#endif
