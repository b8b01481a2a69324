/* view.h - what is shown, from where, in which colours: options, else the catalogue, else what frames the
 * extent. */
#ifndef VIEW_H
#define VIEW_H
#include "catalogue.h"
#include "cli.h"
#include "jsurf_file.h"

#define VIEW_ANTIALIAS 4   /* samples of a pixel each way, */
#define VIEW_THRESHOLD 0.1 /* where it differs by so much from a neighbour */

typedef struct view_options {
    int width, height; /* of the picture, in pixels; 0: not given */
    cli_vector eye, look_at, up;
    double fov, orthographic; /* 0: not given */
    double zoom;              /* 0: not given */
    double turn[2];           /* degrees about what is looked at, to the right and upwards */
    cli_extent extent;
    cli_vector centre;
} view_options;

/* Setters for the fields above. */
void view_set_size(const cli_option *option, const char *value, void *field); /* view_options */
void view_set_fov(const cli_option *option, const char *value, void *field);
void view_set_orthographic(const cli_option *option, const char *value, void *field);
void view_set_zoom(const cli_option *option, const char *value, void *field);
void view_set_turn(const cli_option *option, const char *value, void *field);

/* clang-format off */
/* The rows of the option table for the member `view` of a structure. */
#define VIEW_OPTIONS(type)                                                                                   \
    {"--size", "WxH", "width and height of the picture in pixels, default 1024x768", view_set_size,          \
     offsetof(type, view), 0, 0},                                                                            \
    {"--extent", "sphere:R|box:X,Y,Z",                                                                       \
     "shows only what lies in a ball of radius R, or in a box from -X,-Y,-Z to X,Y,Z.\n"                     \
     "Default for a named surface: what suits it; for an equation: all of the surface,\n"                    \
     "or, if it goes on for ever, what is near its singular points or the origin",                           \
     cli_set_extent, offsetof(type, view.extent), 0, 0},                                                     \
    {"--centre", "X,Y,Z", "the centre of that ball or box, default 0,0,0 (boy: 0,0,1)", cli_set_vector,      \
     offsetof(type, view.centre), 0, 0},                                                                     \
    {"--zoom", "TIMES",                                                                                      \
     "magnifies the picture: 2 shows all things twice as large, 0.5 half as large;\n"                        \
     "the camera stays where it is", view_set_zoom, offsetof(type, view.zoom), 0, 0},                        \
    {"--turn", "AZ,EL",                                                                                      \
     "moves the camera around the point it looks at: AZ degrees to the right, then\n"                        \
     "EL degrees up; default 0,0", view_set_turn, offsetof(type, view.turn), 0, 0},                          \
    {"--eye", "X,Y,Z", "where the camera stands; default: where the surface fills the picture",              \
     cli_set_vector, offsetof(type, view.eye), 0, 0},                                                        \
    {"--look-at", "X,Y,Z",                                                                                   \
     "the point in the middle of the picture; default: the middle of what is shown",                         \
     cli_set_vector, offsetof(type, view.look_at), 0, 0},                                                    \
    {"--up", "X,Y,Z", "the direction in space that is up in the picture, default 0,0,1", cli_set_vector,     \
     offsetof(type, view.up), 0, 0},                                                                         \
    {"--fov", "DEGREES",                                                                                     \
     "field of view: the angle between the bottom and the top of the picture, default\n"                     \
     "25; less magnifies, and the camera stays where it is", view_set_fov,                                   \
     offsetof(type, view.fov), 0, 0},                                                                        \
    {"--orthographic", "HEIGHT",                                                                             \
     "parallel projection instead of perspective; HEIGHT is the distance in space\n"                         \
     "between the bottom and the top of the picture",                                                        \
     view_set_orthographic, offsetof(type, view.orthographic), 0, 0}
/* clang-format on */

/* Fills in what a file of SURFER says of extent and camera and the options do not. */
void view_follow(view_options *options, const jsurf_file *file);

/* Fills the default size in; ends the program when options do not go together. */
void view_check(view_options *options);

typedef struct view {
    algsurf_extent extent;
    double eye[3], look_at[3], up[3];
    double axis[3];      /* that turns go about */
    double fov;          /* degrees, vertical */
    double orthographic; /* height of the picture in space; 0: a pinhole camera */
} view;

/* entry: the catalogue's, null for a surface without a name. */
view view_make(const view_options *options, const catalogue_entry *entry);

/* A view so many times larger; 0: as it is. */
void view_zoom(view *v, double times);

/* The camera of picture number `picture` (from 0) of a turn of `pictures` about the axis through
 * the point looked at. */
algsurf_status view_make_camera(const view *v, int picture, int pictures, algsurf_camera *camera);

/* The same, and the end of the program when there is no such camera. */
algsurf_camera view_camera(const view *v, int picture, int pictures);

/* The scene's material with the catalogue's colours; without a name (null) as it is. */
algsurf_material view_material(const algsurf_scene *scene, const catalogue_entry *entry);

#endif
