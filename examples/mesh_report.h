/* mesh_report.h - what was made, and what the lattice cannot show: lines on standard error. */
#ifndef MESH_REPORT_H
#define MESH_REPORT_H
#include "mesh_measure.h"

/* turned: its inner side is that of P > 0. */
void mesh_report(const mesh *m, const mesh_measures *of, int turned);

/* Tells of points and lines without width, by a small picture in which they are marked; needs the camera. */
void mesh_report_thin(const algsurf_surface *surface, const algsurf_extent *extent,
                      const algsurf_plane *planes, size_t count, const algsurf_camera *camera, int threads);

#endif
