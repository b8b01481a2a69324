/* jsurf_file.h - a surface and its view from a file of IMAGINARY's SURFER, name.jsurf.
 *
 * Such a file is a list of Java properties, a line "key=value" each.  Understood are surface_equation,
 * surface_parameter_NAME, scale_factor, rotation_matrix, transform_matrix, surface_transform_matrix,
 * camera_type, camera_fov_y, camera_height, front_material_color, back_material_color, background_color;
 * other keys (lights, materials' weights) are skipped. SURFER shows what lies in a ball about the origin, of
 * radius 10^scale_factor in the equation's coordinates, from the direction of the rotation's third column,
 * with its second one upwards.
 */
#ifndef JSURF_FILE_H
#define JSURF_FILE_H
#include <stddef.h>
#include <stdio.h>

#include "colour.h"

typedef struct jsurf_parameter {
    char *name, *value; /* a number, as it is written */
} jsurf_parameter;

typedef struct jsurf_file {
    char *equation; /* UTF-8 */
    jsurf_parameter *parameters;
    size_t parameter_count;
    double radius;         /* of the ball */
    double back[3], up[3]; /* unit vectors: from the origin to the eye, and upwards */
    int perspective;
    double fov, height; /* the camera's field of view in degrees; parallel: the picture's height in radii */
    css_colour front, inside, background;
} jsurf_file;

typedef struct jsurf_error {
    size_t line; /* from 1; 0: the file as a whole */
    int no_memory;
    char message[160]; /* one line, printable */
} jsurf_error;

/* Reads the file to its end.  Returns 0, *read to be released; -1 with *error filled and nothing to release.
 */
int jsurf_read(FILE *file, jsurf_file *read, jsurf_error *error);

void jsurf_release(jsurf_file *read);

/* Is it the name of such a file? */
int jsurf_is_name(const char *path);

#endif
