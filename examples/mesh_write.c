/* mesh_write.c - see mesh_write.h.  Everything binary is little-endian. */
#include "mesh_write.h"

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "cli.h" /* CLI_FORMAT */

/* ---- bytes ---- */

typedef struct writer {
    mesh_put *put;
    void *data;
    int failed;
    size_t filled;
    uint8_t buffer[1 << 14];
} writer;

static void flush(writer *w) {
    if (w->filled > 0 && !w->failed) w->failed = !w->put(w->buffer, w->filled, w->data);
    w->filled = 0;
}

static void byte(writer *w, unsigned value) {
    if (w->filled == sizeof w->buffer) flush(w);
    w->buffer[w->filled++] = (uint8_t)value;
}

static void text(writer *w, const char *format, ...) CLI_FORMAT(2, 3);
static void text(writer *w, const char *format, ...) {
    char line[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    for (const char *c = line; *c; c++) byte(w, (unsigned char)*c);
}

static void whole(writer *w, uint32_t value) {
    for (int b = 0; b < 32; b += 8) byte(w, value >> b & 0xff);
}

static void number(writer *w, float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    whole(w, bits);
}

static void place(writer *w, const double x[3]) {
    for (int k = 0; k < 3; k++) number(w, (float)x[k]);
}

/* The normal of a point; of unit length, as glTF demands, where there is none, too. */
static const float *normal_of(const mesh *m, size_t point) {
    static const float any[3] = {0, 0, 1};
    const float *n = m->normal[point];
    return n[0] == 0 && n[1] == 0 && n[2] == 0 ? any : n;
}

static void direction(writer *w, const float n[3], float sign) {
    for (int k = 0; k < 3; k++) number(w, sign * n[k]);
}

/* ---- formats ---- */

static void write_stl(writer *w, const mesh *m) {
    char head[81];
    snprintf(head, sizeof head, "%-80s", "libalgsurf: binary STL"); /* must not begin with "solid" */
    text(w, "%s", head);
    whole(w, (uint32_t)m->triangles);
    for (size_t i = 0; i < m->triangles; i++) {
        double n[3], at[3][3]; /* as the file has them: the normal of a sliver depends on that */
        const mesh rounded = {.at = at};
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 3; k++) at[c][k] = (double)(float)m->at[m->corner[i][c]][k];
        mesh_normal(&rounded, (const uint32_t[3]){0, 1, 2}, n);
        const double length = mesh_length(n);
        for (int k = 0; k < 3; k++) number(w, length > 0 ? (float)(n[k] / length) : 0);
        for (int k = 0; k < 3; k++) place(w, m->at[m->corner[i][k]]);
        byte(w, 0);
        byte(w, 0);
    }
}

static void write_ply(writer *w, const mesh *m, uint8_t colour[2][3]) {
    static const char *const properties[] = {"x", "y", "z", "nx", "ny", "nz"};
    text(w, "ply\nformat binary_little_endian 1.0\ncomment libalgsurf\nelement vertex %zu\n", m->points);
    for (int k = 0; k < 6; k++) text(w, "property float %s\n", properties[k]);
    text(w,
         "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face %zu\n"
         "property list uchar int vertex_indices\nend_header\n",
         m->triangles);
    for (size_t i = 0; i < m->points; i++) {
        place(w, m->at[i]);
        direction(w, normal_of(m, i), 1);
        for (int k = 0; k < 3; k++) byte(w, colour[m->kind[i] == MESH_CLOSING][k]);
    }
    for (size_t i = 0; i < m->triangles; i++) {
        byte(w, 3);
        for (int k = 0; k < 3; k++) whole(w, m->corner[i][k]);
    }
}

static void write_obj(writer *w, const mesh *m) {
    text(w, "# libalgsurf\n");
    for (size_t i = 0; i < m->points; i++)
        text(w, "v %.9g %.9g %.9g\n", m->at[i][0], m->at[i][1], m->at[i][2]);
    for (size_t i = 0; i < m->points; i++) {
        const float *n = normal_of(m, i);
        text(w, "vn %.5g %.5g %.5g\n", (double)n[0], (double)n[1], (double)n[2]);
    }
    for (size_t i = 0; i < m->triangles; i++) {
        const uint32_t *t = m->corner[i];
        text(w, "f %" PRIu64 "//%" PRIu64 " %" PRIu64 "//%" PRIu64 " %" PRIu64 "//%" PRIu64 "\n",
             (uint64_t)t[0] + 1, (uint64_t)t[0] + 1, (uint64_t)t[1] + 1, (uint64_t)t[1] + 1,
             (uint64_t)t[2] + 1, (uint64_t)t[2] + 1);
    }
}

/* ---- glTF ---- */

enum { ROOM = 4096 }; /* more than the description takes */

/* The binary part: positions, normals, of an open surface those of its back, and one or two lists of
 * triangles; of an open surface the second one is the first one turned around. */
typedef struct gltf {
    const mesh *m;
    int two_sided;
    int normals; /* how many arrays of them */
    int lists, first_list;
    size_t triangles[2];
    size_t offset; /* of what is described next */
    char json[ROOM];
    size_t length;
} gltf;

static void describe(gltf *g, const char *format, ...) CLI_FORMAT(2, 3);
static void describe(gltf *g, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const int added = vsnprintf(g->json + g->length, ROOM - g->length, format, arguments);
    va_end(arguments);
    g->length += (size_t)added;
}

static void describe_parts(gltf *g, const double *const colour[2]) {
    describe(g, "{\"asset\":{\"version\":\"2.0\",\"generator\":\"libalgsurf\"},\"scene\":0,"
                "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[");
    for (int i = 0; i < g->lists; i++)
        describe(g, "%s{\"attributes\":{\"POSITION\":0,\"NORMAL\":%d},\"indices\":%d,\"material\":%d}",
                 i ? "," : "", 1 + (g->two_sided && i), 1 + g->normals + i, i);
    describe(g, "]}],\"materials\":[");
    for (int i = 0; i < g->lists; i++) {
        const double *c = colour[g->first_list + i];
        describe(g,
                 "%s{\"pbrMetallicRoughness\":{\"baseColorFactor\":[%.4f,%.4f,%.4f,1],"
                 "\"metallicFactor\":0,\"roughnessFactor\":0.5}}",
                 i ? "," : "", c[0], c[1], c[2]);
    }
    describe(g, "],");
}

static void describe_view(gltf *g, size_t bytes, int target) {
    describe(g, "%s{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu,\"target\":%d}", g->offset ? "," : "",
             g->offset, bytes, target);
    g->offset += bytes;
}

static void describe_arrays(gltf *g) {
    const mesh *m = g->m;
    float low[3], high[3];
    for (int k = 0; k < 3; k++) low[k] = INFINITY, high[k] = -INFINITY;
    for (size_t i = 0; i < m->points; i++)
        for (int k = 0; k < 3; k++) {
            low[k] = fminf(low[k], (float)m->at[i][k]);
            high[k] = fmaxf(high[k], (float)m->at[i][k]);
        }
    describe(g, "\"bufferViews\":[");
    for (int i = 0; i <= g->normals; i++) describe_view(g, 12 * m->points, 34962);
    for (int i = 0; i < g->lists; i++) describe_view(g, 12 * g->triangles[g->first_list + i], 34963);
    describe(g, "],\"buffers\":[{\"byteLength\":%zu}],\"accessors\":[", g->offset);
    describe(g,
             "{\"bufferView\":0,\"componentType\":5126,\"count\":%zu,\"type\":\"VEC3\","
             "\"min\":[%.9g,%.9g,%.9g],\"max\":[%.9g,%.9g,%.9g]}",
             m->points, (double)low[0], (double)low[1], (double)low[2], (double)high[0], (double)high[1],
             (double)high[2]);
    for (int i = 1; i <= g->normals; i++)
        describe(g, ",{\"bufferView\":%d,\"componentType\":5126,\"count\":%zu,\"type\":\"VEC3\"}", i,
                 m->points);
    for (int i = 0; i < g->lists; i++)
        describe(g, ",{\"bufferView\":%d,\"componentType\":5125,\"count\":%zu,\"type\":\"SCALAR\"}",
                 1 + g->normals + i, 3 * g->triangles[g->first_list + i]);
    describe(g, "]}");
}

static void write_list(writer *w, const gltf *g, int list) {
    const int turned = g->two_sided && list == 1;
    for (size_t i = 0; i < g->m->triangles; i++) {
        const uint32_t *t = g->m->corner[i];
        if (!g->two_sided && g->m->closing[i] != list) continue;
        whole(w, t[0]);
        whole(w, t[turned ? 2 : 1]);
        whole(w, t[turned ? 1 : 2]);
    }
}

static void write_glb(writer *w, const mesh *m, const double *const colour[2]) {
    gltf g = {.m = m};
    for (size_t i = 0; i < m->triangles; i++) g.triangles[m->closing[i]]++;
    g.two_sided = g.triangles[1] == 0;
    if (g.two_sided) g.triangles[1] = g.triangles[0];
    g.normals = 1 + g.two_sided;
    g.first_list = g.triangles[0] == 0;
    g.lists = 2 - g.first_list;
    describe_parts(&g, colour);
    describe_arrays(&g);
    while (g.length % 4) describe(&g, " ");
    w->failed |= 28 + g.length + g.offset > UINT32_MAX;
    text(w, "glTF");
    whole(w, 2);
    whole(w, (uint32_t)(12 + 8 + g.length + 8 + g.offset));
    whole(w, (uint32_t)g.length);
    text(w, "JSON");
    for (size_t i = 0; i < g.length; i++) byte(w, (unsigned char)g.json[i]);
    whole(w, (uint32_t)g.offset);
    text(w, "BIN");
    byte(w, 0);
    for (size_t i = 0; i < m->points; i++) place(w, m->at[i]);
    for (size_t i = 0; i < m->points; i++) direction(w, normal_of(m, i), 1);
    for (size_t i = 0; i < m->points && g.two_sided; i++) direction(w, normal_of(m, i), -1);
    for (int i = 0; i < g.lists; i++) write_list(w, &g, g.first_list + i);
}

/* ---- all of them ---- */

int mesh_fits_floats(const mesh *m, double step) {
    double far = 0;
    for (size_t i = 0; i < m->points; i++)
        for (int k = 0; k < 3; k++) far = fmax(far, fabs(m->at[i][k]));
    return far + step < (double)FLT_MAX && (float)(far + step / 8) > (float)far;
}

int mesh_write(const mesh *m, mesh_format format, const double outside[3], const double inside[3],
               mesh_put *put, void *data) {
    const double *const colour[2] = {outside, inside};
    uint8_t srgb[2][3];
    writer w = {.put = put, .data = data};
    (void)algsurf_srgb_encode(outside, srgb[0]);
    (void)algsurf_srgb_encode(inside, srgb[1]);
    if (format == MESH_STL) write_stl(&w, m);
    if (format == MESH_PLY) write_ply(&w, m, srgb);
    if (format == MESH_OBJ) write_obj(&w, m);
    if (format == MESH_GLB) write_glb(&w, m, colour);
    flush(&w);
    return !w.failed;
}

int mesh_format_of(const char *path, mesh_format *format) {
    static const char *const endings[] = {".stl", ".ply", ".obj", ".glb"};
    const size_t length = strlen(path);
    for (int i = 0; i < 4; i++)
        if (length > 4 && strcmp(path + length - 4, endings[i]) == 0) {
            *format = (mesh_format)i;
            return 1;
        }
    return 0;
}
