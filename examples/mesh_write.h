/* mesh_write.h - meshes as files that others read: STL, PLY, OBJ, glTF. */
#ifndef MESH_WRITE_H
#define MESH_WRITE_H
#include "mesh_data.h"

typedef enum mesh_format {
    MESH_STL, /* binary: triangles with corners and normals of their own */
    MESH_PLY, /* binary: points with normals and colours */
    MESH_OBJ, /* text: points with normals */
    MESH_GLB  /* glTF 2.0, binary: points with normals, a colour for each side */
} mesh_format;

/* Takes bytes in order; 0 ends the writing. */
typedef int mesh_put(const void *bytes, size_t count, void *data);

/* Are all coordinates in the range of floats, and do floats tell an eighth of a step there? */
int mesh_fits_floats(const mesh *m, double step);

/* Numbers are floats in all of them: of a mesh that fits them.  An open surface has one side in the colour
 * `outside` and the other one in `inside`, where the format can tell; of a closed one, what closes it is
 * `inside`.  A normal that there is not is 0, 0, 1.
 *   outside, inside  red, green, blue in linear light
 * Returns 0 if `put` did, or there is no memory. */
int mesh_write(const mesh *m, mesh_format format, const double outside[3], const double inside[3],
               mesh_put *put, void *data);

/* By the ending of a name: .stl, .ply, .obj, .glb; 0: none of them. */
int mesh_format_of(const char *path, mesh_format *format);

#endif
