/* render_look.h - the options of render about colours, background and light. */
#ifndef RENDER_LOOK_H
#define RENDER_LOOK_H
#include "cli.h"
#include "colour.h"
#include "jsurf_file.h"

typedef struct render_look {
    css_colour outside, inside, background, thin;
    int transparent;  /* 1: no background */
    int paper, usual; /* 1: the lights of the paper; no lights of a file */
    /* Where the light is: a point of space, or seen from the eye so many degrees to the right and above. */
    enum { LIGHT_DEFAULT, LIGHT_POINT, LIGHT_ANGLES, LIGHT_FILE } light;
    double place[3];                       /* of a light: the point, or both angles and 0 */
    jsurf_light file_lights[JSURF_LIGHTS]; /* the first ones, those of a file of SURFER */
    int file_light_count;
} render_look;

/* Setters for a render_look. */
void render_set_background(const cli_option *option, const char *value, void *field);
void render_set_light(const cli_option *option, const char *value, void *field);
void render_set_lights(const cli_option *option, const char *value, void *field);

/* Fills in the colours and lights that a file of SURFER has and the options do not. */
void render_look_follow(render_look *look, const jsurf_file *file);

/* The material in the colours that were asked for. */
void render_paint(const render_look *look, algsurf_material *material);

/* Sets background and light of a scene that has this camera and extent. */
algsurf_status render_light_scene(const render_look *look, const algsurf_camera *camera,
                                  const algsurf_extent *extent, algsurf_scene *scene);

#endif
