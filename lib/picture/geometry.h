/* geometry.h - a picture's geometry: all its rays share a view (scene_view.c), those of a row are pixels of
 * one job. */
#ifndef ALGSURF_GEOMETRY_H
#define ALGSURF_GEOMETRY_H
#include "../beams/rows.h"
#include "../beams/segments.h"

typedef struct algsurf_i_picture algsurf_i_picture; /* impl.h */

/* What kernels need to know of a picture. */
typedef struct algsurf_i_geometry {
    algsurf_i_frame_form frame;
    int orthographic, degree;           /* P's along the rays, at most */
    double origin[2], per_slope, pixel; /* u = origin[0] + per_slope (x - width/2) pixel; v likewise */
    double near;                        /* depth of the eye */
    double extent_size[3], tolerance;   /* in the view's unit */
    /* the planes that cut something off, in the axes of the view and in those of the caller */
    algsurf_i_cut_plane view_planes[ALGSURF_MAX_CLIP_PLANES], planes[ALGSURF_MAX_CLIP_PLANES];
    int plane_count;
    double thin_side, thin_bends[ALGSURF_MAX_VIEW_DEGREE + 1]; /* as in algsurf_i_row_job */
    double *beams;            /* in a tiled picture: algsurf_i_beam_expand's g */
    algsurf_i_taylor *taylor; /* where shadows are drawn; or null */
    /* complex space: as in algsurf_i_complex_job */
    algsurf_i_sector_edges sector;
    double imaginary[ALGSURF_MAX_DEGREE + 1];
    int top;
} algsurf_i_geometry;

/* Fills a picture's geometry, but for the frame's arrays; 0 if this scene is not one for them. */
int algsurf_i_find_geometry(const algsurf_i_picture *picture, algsurf_i_geometry *geometry);

/* What the jobs of all rows have in common; the offset is that of the pixels' left edges. */
algsurf_i_row_job algsurf_i_any_row(const algsurf_i_picture *picture);

/* The job of the row y from the top, through offset sx in each pixel, without its form's coefficients. */
void algsurf_i_make_row(const algsurf_i_picture *picture, double y, double sx, algsurf_i_row_form *form,
                        algsurf_i_row_job *job);

/* The pixels begin <= x < end, multiples of `step`, all of whose rays between two heights, counted in pixels
 * from the top, are within the bounds of forms; the last `step` pixels may reach beyond the picture.  Returns
 * 1 if the rays of all others surely miss what is shown. */
int algsurf_i_pixels_within_bounds(const algsurf_i_picture *picture, double top, double bottom, int step,
                                   int *begin, int *end);

#endif
