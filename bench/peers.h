/* peers.h - what the parts of the comparison of pictures with other software share. */
#ifndef PEERS_H
#define PEERS_H
#include <stdio.h>

#include "catalogue.h"
#include "contest.h"

/* Where the programs are; null: not here. */
typedef struct peers_programs {
    const char *povray, *surf;
    const char *work; /* a folder to work in */
} peers_programs;

/* Draws the surfaces, a list that ends with a null, in so many takes. */
void peers_pictures(const char *const *surfaces, int takes, const peers_programs *programs,
                    contest_table *table);

/* One surface in the view of all pictures (rays_camera), as this library, POV-Ray and surf are told of it. It
 * is moved so that its extent's centre is the origin. */
enum { PEERS_WIDTH = 1024, PEERS_HEIGHT = 768 };

typedef struct peers_scene {
    const char *name;
    int degree;
    double radius;
    double *cube;      /* of x^i y^j z^k at (i (degree + 1) + j) (degree + 1) + k */
    double axis[3][3]; /* of the view: right, up, towards the viewer */
    algsurf_surface *surface;
    algsurf_scene *scene;
} peers_scene;

/* Ends the program when it cannot. */
void peers_scene_open(peers_scene *s, const catalogue_entry *entry);
void peers_scene_close(peers_scene *s);

void peers_write_povray(const peers_scene *s, int sturm, FILE *file);

/* empty: an extent that no ray meets, to see what start and end of the program cost. */
void peers_write_surf(const peers_scene *s, int empty, const char *picture, FILE *file);

#endif
