/* kernels.h - the code of this room, for every kernel. */
#ifndef ALGSURF_BEAMS_KERNELS_H
#define ALGSURF_BEAMS_KERNELS_H
#include "rows.h"
#include "segments.h"

typedef struct algsurf_i_beams_kernel {
    /* depth[i], state[i] of pixel i of those: the first root along its ray.  dips: receives those; or null.
     */
    void (*solve_pixels)(const algsurf_i_row_job *job, const algsurf_i_pixels *pixels, double *depth,
                         uint8_t *state, algsurf_i_dips *dips);
    /* Finds out which tiles are empty or sheets.  The others become the job's tiles, or, of the least size,
     * are leaves. */
    void (*search_tiles)(algsurf_i_tile_job *job);
    /* Entry i of points from depth[i] at pixel[i], which is on its sheet, if there are sheets: after Newton
     * steps on P itself, t along the unit ray from the eye, position, unit normal (0 at a singular point),
     * unit direction, in the caller's units; looks.  Position and direction, normal, looks may be null: they
     * are not asked for.  sure[i]: the root was found; returns whether all were. */
    int (*points)(const algsurf_i_point_job *job, const int *pixel, const double *depth, int count,
                  const algsurf_i_sheets *sheets, uint8_t *sure, const algsurf_i_points *points);
    /* What is thin beside a ray, found from dip i of those that are kept: its depth, HUGE_VAL if there is
     * nothing; and the direction of a line, a unit vector in the caller's axes, 0 of a point. */
    void (*find_thin)(const algsurf_i_point_job *job, algsurf_i_dips *dips, double *depth,
                      double *const along[3]);
    /* The pixels begin .. end-1 of a row in complex space; returns how many corrections of roots it took. */
    uint64_t (*solve_complex)(const algsurf_i_complex_job *job, int begin, int end);
    /* points in complex space: entry i from the root re[i], im[i], whose own derivative and gradient tell the
     * normal. */
    int (*complex_points)(const algsurf_i_complex_job *job, const algsurf_surface *surface, const int *pixel,
                          const double *re, const double *im, int count, uint8_t *sure,
                          const algsurf_i_points *points);
    /* ---- rays from points ---- */
    /* Points from `first` on, lifted by `height`, and by what a far hit may be off. */
    void (*lift)(const algsurf_i_points *points, int first, int count, double height,
                 algsurf_i_starts *starts);
    /* P about the points, for all jobs of a picture. */
    void (*expand)(const algsurf_i_shadow_job *job, const algsurf_i_starts *starts, algsurf_i_solids *solids);
    /* Rays from `from` on, `rays` of them, of each start: adds those that are not hidden to *seen; what is
     * below the point's tangent plane counts as seen: shading knows how the point lies.  Undecided ones are
     * appended.  solids: null where nothing is known of rays. */
    void (*see_rays)(const algsurf_i_shadow_job *job, const algsurf_i_starts *starts,
                     const algsurf_i_solids *solids, int from, int rays, algsurf_i_undecided *undecided);
} algsurf_i_beams_kernel;

ALGSURF_KERNEL_TABLES(beams);

#endif
