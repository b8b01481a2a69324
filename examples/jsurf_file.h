/* jsurf_file.h - a surface and its view from a file of IMAGINARY's SURFER, name.jsurf.
 *
 * Such a file is a list of Java properties, a line "key=value" each.  Understood are surface_equation,
 * surface_parameter_NAME, scale_factor, rotation_matrix, transform_matrix, surface_transform_matrix,
 * camera_type, camera_fov_y, camera_height, front_material_color, back_material_color, background_color, and
 * light_status_N, light_position_N, light_color_N, light_intensity_N for N from 0 to 7; other keys
 * (materials' weights) are skipped. SURFER shows what lies in a ball about the origin, of
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

enum { JSURF_LIGHTS = 8 };

/* A point that shines: in the axes of the camera (right, up, towards the viewer), about the middle of the
 * ball, in its radii. */
typedef struct jsurf_light {
    int on, placed; /* status ON; has a position.  Only a light with both counts */
    double place[3], intensity;
    css_colour colour;
} jsurf_light;

typedef struct jsurf_file {
    char *equation; /* UTF-8 */
    jsurf_parameter *parameters;
    size_t parameter_count;
    double radius;         /* of the ball */
    double back[3], up[3]; /* unit vectors: from the origin to the eye, and upwards */
    int perspective;
    double fov, height; /* the camera's field of view in degrees; parallel: the picture's height in radii */
    css_colour front, inside, background;
    jsurf_light lights[JSURF_LIGHTS];
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
