/* mesh_make.c - see mesh_make.h.
 *
 * The lattice is passed through from below in bands of slabs.  Kept are the crossings of all lines along z, a
 * few for each; the layers of a band, with their crossings along x and y; and what is made.
 */
#include "mesh_make.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mesh_balance.h"
#include "mesh_net.h"
#include "mesh_open.h"
#include "mesh_vertex.h"

enum { BAND = 16, LAYERS = BAND + 3 }; /* a slab looks at the layers beside its own two */

typedef struct layer {
    unsigned char *signs;
    mesh_row row[2]; /* along x, along y */
} layer;

/* A slab's part of the net, and of the mesh. */
typedef struct part {
    mesh_slab slab;
    mesh_vertex *vertex;
    size_t vertex_room;
    uint32_t (*corner)[3];
    unsigned char *closing;
    size_t triangles, room;
    mesh_doubt doubts[MESH_DOUBTS];
} part;

typedef struct maker {
    const mesh_options *options;
    algsurf_intersect_options how;
    mesh_space space;
    mesh_table *table;
    mesh_row *upright;      /* the lines along z, a row for each y */
    layer layer[LAYERS];    /* layer k is at k % LAYERS */
    part part[BAND + 1];    /* slab s is at s % (BAND + 1) */
    int first;              /* of what is done at once: rows, layers or slabs */
    algsurf_status *status; /* of each job */
    mesh *mesh;
} maker;

static part *part_of(maker *m, int slab) { return &m->part[slab % (BAND + 1)]; }
static layer *layer_of(maker *m, int k) { return &m->layer[k % LAYERS]; }

/* ---- jobs: crossings ---- */

static void trace_upright(int index, void *data) {
    maker *m = data;
    const int j = m->first + index;
    m->status[index] = mesh_row_trace(&m->space, 2, j, &m->how, &m->upright[j], NULL);
}

static void trace_layer(int index, void *data) {
    maker *m = data;
    const int k = m->first + index / 2, axis = index % 2;
    layer *l = layer_of(m, k);
    m->status[index] =
        mesh_row_trace(&m->space, axis, k, &m->how, &l->row[axis], axis == 0 ? l->signs : NULL);
}

/* ---- jobs: points ---- */

/* The crossing of an edge of a cell whose lowest corner is (i, j) in a layer. */
static mesh_crossing crossing_of(maker *m, int axis, int i, int j, int k) {
    const int point[3] = {i, j, k};
    const size_t nx = (size_t)m->space.cells[0] + 1, at = (size_t)j * nx + (size_t)i;
    const unsigned char *signs = layer_of(m, k)->signs;
    const int low = signs[at];
    const int high = axis == 2 ? layer_of(m, k + 1)->signs[at] : signs[at + (axis == 0 ? 1 : nx)];
    const mesh_row *row = axis == 2 ? &m->upright[j] : &layer_of(m, k)->row[axis];
    mesh_crossing crossing;
    mesh_row_crossing(&m->space, row, axis, point, low, high, &crossing);
    return crossing;
}

static void place_cell(maker *m, part *p, int s, uint32_t index) {
    const int nx = m->space.cells[0], i = (int)(index % (uint32_t)nx), j = (int)(index / (uint32_t)nx);
    const mesh_cell *cell = &p->slab.cells[index];
    const mesh_sheets *sheets = &m->table->sheets[cell->sheets];
    const int from[3] = {i, j, s};
    double low[3], high[3];
    mesh_crossing crossing[MESH_EDGES];
    for (int a = 0; a < 3; a++) {
        low[a] = m->space.point[a][from[a]] + MESH_MARGIN * m->space.h;
        high[a] = m->space.point[a][from[a] + 1] - MESH_MARGIN * m->space.h;
    }
    for (int sheet = 0; sheet < sheets->count; sheet++) {
        mesh_vertex *vertex = &p->vertex[cell->first + (uint32_t)sheet];
        int count = 0;
        for (int e = 0; e < MESH_EDGES; e++) {
            const int c = mesh_edge_corner(e);
            if (sheets->of[e] == sheet)
                crossing[count++] = crossing_of(m, e / 4, i + (c & 1), j + (c >> 1 & 1), s + (c >> 2));
        }
        mesh_vertex_place(&m->space, crossing, count, low, high, vertex);
        if (vertex->sharp) mesh_doubt_add(&p->doubts[MESH_SHARP], vertex->at);
    }
}

static void place_slab(int index, void *data) {
    maker *m = data;
    const int s = m->first + index, *n = m->space.cells;
    const unsigned char *signs[4];
    part *p = part_of(m, s);
    for (int k = 0; k < 4; k++) {
        const int at = s - 1 + k;
        signs[k] = at >= 0 && at <= n[2] ? layer_of(m, at)->signs : NULL;
    }
    memset(p->doubts, 0, sizeof p->doubts);
    m->status[index] = ALGSURF_E_NO_MEMORY;
    if (!mesh_slab_fill(m->table, n[0], n[1], signs, MESH_INSIDE, &p->slab)) return;
    if (p->vertex_room < p->slab.sheets) {
        free(p->vertex);
        p->vertex_room = p->slab.sheets + p->slab.sheets / 4;
        p->vertex = malloc(p->vertex_room * sizeof *p->vertex);
        if (!p->vertex) {
            p->vertex_room = 0;
            return;
        }
    }
    for (size_t i = 0; i < p->slab.active_count; i++) place_cell(m, p, s, p->slab.active[i]);
    m->status[index] = ALGSURF_OK;
}

/* ---- jobs: triangles ---- */

typedef struct cutter {
    maker *maker;
    part *part;
    int slab;
} cutter;

/* Where the triangles of a quad, cut from corner `first` to the opposite one, meet the line of its edge, as a
 * coordinate along that; infinite where they fold.  u, v, w: the corners across the edge and along it. */
static double height(int first, const double u[4], const double v[4], const double w[4]) {
    const int a = first, b = (first + 1) % 4, c = (first + 2) % 4, d = (first + 3) % 4;
    const double abc = (u[b] - u[a]) * (v[c] - v[a]) - (u[c] - u[a]) * (v[b] - v[a]);
    const double acd = (u[c] - u[a]) * (v[d] - v[a]) - (u[d] - u[a]) * (v[c] - v[a]);
    if (!(abc > 0 && acd > 0)) return INFINITY;
    const int e = u[a] * v[c] - v[a] * u[c] <= 0 ? b : d; /* the line is at u = v = 0, beside a - c */
    const double ac = u[a] * v[c] - u[c] * v[a], ce = u[c] * v[e] - u[e] * v[c],
                 ea = u[e] * v[a] - u[a] * v[e];
    return (ac * w[e] + ce * w[a] + ea * w[c]) / (ac + ce + ea);
}

/* Which diagonal of a quad comes nearer to the crossing that it stands for: 0 or 1. */
static int better_diagonal(const mesh *made, const mesh_quad *quad, const mesh_crossing *crossing) {
    const int axis = quad->axis;
    double u[4], v[4], w[4], off[2];
    for (int k = 0; k < 4; k++) {
        const double *x = made->at[quad->point[k]], *c = crossing->at;
        u[k] = x[(axis + 1) % 3] - c[(axis + 1) % 3];
        v[k] = x[(axis + 2) % 3] - c[(axis + 2) % 3];
        w[k] = x[axis] - c[axis];
    }
    for (int k = 0; k < 2; k++) off[k] = fabs(height(k, u, v, w));
    return off[1] < off[0];
}

static int add_triangles(part *p, const uint32_t a[3], const uint32_t b[3], int closing) {
    if (p->triangles + 2 > p->room) {
        const size_t room = p->room ? 2 * p->room : 1024;
        void *corner = realloc(p->corner, room * sizeof *p->corner);
        if (corner) p->corner = corner;
        unsigned char *flags = realloc(p->closing, room);
        if (flags) p->closing = flags;
        if (!corner || !flags) return 0;
        p->room = room;
    }
    memcpy(p->corner[p->triangles], a, sizeof *p->corner);
    memcpy(p->corner[p->triangles + 1], b, sizeof *p->corner);
    p->closing[p->triangles] = p->closing[p->triangles + 1] = (unsigned char)closing;
    p->triangles += 2;
    return 1;
}

static int cut_quad(const mesh_quad *quad, void *data) {
    const cutter *c = data;
    maker *m = c->maker;
    const int i = quad->at[0], j = quad->at[1];
    const size_t at = (size_t)j * ((size_t)m->space.cells[0] + 1) + (size_t)i;
    const mesh_crossing crossing = crossing_of(m, quad->axis, i, j, c->slab);
    const int closing = crossing.part != MESH_SURFACE;
    if (closing && !m->options->solid) return 1;
    const int d = better_diagonal(m->mesh, quad, &crossing);
    const int up = layer_of(m, c->slab)->signs[at] == MESH_INSIDE; /* the solid is at the lower end */
    const uint32_t *q = quad->point;
    const uint32_t a = q[d], b = q[d + 1], e = q[d + 2], f = q[(d + 3) % 4];
    const uint32_t one[2][3] = {{a, e, b}, {a, b, e}}, other[2][3] = {{a, f, e}, {a, e, f}};
    return add_triangles(c->part, one[up], other[up], closing);
}

static void cut_slab(int index, void *data) {
    maker *m = data;
    const int s = m->first + index;
    part *p = part_of(m, s);
    const unsigned char *const signs[2] = {layer_of(m, s)->signs, layer_of(m, s + 1)->signs};
    const mesh_slab *below = s > 0 ? &part_of(m, s - 1)->slab : NULL;
    cutter c = {m, p, s};
    p->triangles = 0;
    const int done = mesh_slab_quads(m->table, m->space.cells[0], m->space.cells[1], signs, MESH_INSIDE,
                                     below, &p->slab, cut_quad, &c);
    m->status[index] = done ? ALGSURF_OK : ALGSURF_E_NO_MEMORY;
}

/* ---- in order ---- */

static void run_here(void (*job)(int index, void *job_data), int count, void *job_data, void *data) {
    (void)data;
    for (int i = 0; i < count; i++) job(i, job_data);
}

/* Runs jobs; the first status that is not OK. */
static algsurf_status run(maker *m, void (*job)(int index, void *data), int first, int count) {
    m->first = first;
    (m->options->run ? m->options->run : run_here)(job, count, m, m->options->run_data);
    for (int i = 0; i < count; i++)
        if (m->status[i] != ALGSURF_OK) return m->status[i];
    return ALGSURF_OK;
}

static algsurf_status tell(const maker *m, int done) {
    if (!m->options->progress) return ALGSURF_OK;
    const int total = m->space.cells[1] + 2 * m->space.cells[2];
    return m->options->progress(done, total, m->options->progress_data) ? ALGSURF_CANCELLED : ALGSURF_OK;
}

/* Numbers the points of a band's slabs and adds them to the mesh. */
static algsurf_status gather_points(maker *m, int first, int count) {
    mesh *made = m->mesh;
    for (int s = first; s < first + count; s++) {
        part *p = part_of(m, s);
        if (made->points + p->slab.sheets > MESH_MOST_POINTS) return ALGSURF_E_CAPACITY;
        if (!mesh_reserve(made, made->points + p->slab.sheets, 0)) return ALGSURF_E_NO_MEMORY;
        p->slab.base = (uint32_t)made->points;
        for (uint32_t i = 0; i < p->slab.sheets; i++) {
            const mesh_vertex *v = &p->vertex[i];
            memcpy(made->at[made->points], v->at, sizeof v->at);
            memcpy(made->normal[made->points], v->normal, sizeof v->normal);
            made->kind[made->points++] = v->kind;
        }
        mesh_doubts_join(made->doubts, p->doubts);
    }
    return ALGSURF_OK;
}

static algsurf_status gather_triangles(maker *m, int first, int count) {
    mesh *made = m->mesh;
    for (int s = first; s < first + count; s++) {
        const part *p = part_of(m, s);
        if (!mesh_reserve(made, 0, made->triangles + p->triangles)) return ALGSURF_E_NO_MEMORY;
        if (p->triangles == 0) continue;
        memcpy(made->corner[made->triangles], p->corner, p->triangles * sizeof *p->corner);
        memcpy(made->closing + made->triangles, p->closing, p->triangles);
        made->triangles += p->triangles;
    }
    return ALGSURF_OK;
}

static algsurf_status trace_all_upright(maker *m) {
    const int rows = m->space.cells[1] + 1;
    algsurf_status status = ALGSURF_OK;
    for (int j = 0; j < rows && status == ALGSURF_OK; j += BAND) {
        status = run(m, trace_upright, j, j + BAND < rows ? BAND : rows - j);
        if (status == ALGSURF_OK) status = tell(m, j);
    }
    for (int j = 0; j < rows; j++) mesh_doubts_join(m->mesh->doubts, m->upright[j].doubts);
    return status;
}

/* Traces the layers from `first` on up to one before `end`. */
static algsurf_status trace_layers(maker *m, int first, int end) {
    const algsurf_status status = run(m, trace_layer, first, 2 * (end - first));
    for (int k = first; k < end; k++)
        for (int axis = 0; axis < 2; axis++)
            mesh_doubts_join(m->mesh->doubts, layer_of(m, k)->row[axis].doubts);
    return status;
}

static algsurf_status make_bands(maker *m) {
    const int slabs = m->space.cells[2];
    int traced = 0; /* layers */
    algsurf_status status = trace_all_upright(m);
    for (int s = 0; s < slabs && status == ALGSURF_OK; s += BAND) {
        const int count = s + BAND < slabs ? BAND : slabs - s;
        const int wanted = s + count + 2 < slabs + 1 ? s + count + 2 : slabs + 1;
        status = trace_layers(m, traced, wanted);
        traced = wanted;
        if (status == ALGSURF_OK) status = run(m, place_slab, s, count);
        if (status == ALGSURF_OK) status = gather_points(m, s, count);
        if (status == ALGSURF_OK) status = run(m, cut_slab, s, count);
        if (status == ALGSURF_OK) status = gather_triangles(m, s, count);
        if (status == ALGSURF_OK) status = tell(m, m->space.cells[1] + 2 * (s + count));
    }
    return status;
}

static algsurf_status prepare(maker *m) {
    const algsurf_status status = mesh_space_begin(&m->space, m->options->cells);
    const int *n = m->space.cells;
    if (status != ALGSURF_OK) return status;
    m->table = malloc(sizeof *m->table);
    m->status = malloc((2 * LAYERS) * sizeof *m->status);
    m->upright = calloc((size_t)n[1] + 1, sizeof *m->upright);
    if (!m->table || !m->status || !m->upright) return ALGSURF_E_NO_MEMORY;
    for (int k = 0; k < LAYERS; k++) {
        m->layer[k].signs = malloc(((size_t)n[0] + 1) * ((size_t)n[1] + 1));
        if (!m->layer[k].signs) return ALGSURF_E_NO_MEMORY;
    }
    mesh_table_make(m->table);
    return ALGSURF_OK;
}

static void release(maker *m) {
    for (int j = 0; m->upright && j <= m->space.cells[1]; j++) mesh_row_free(&m->upright[j]);
    for (int k = 0; k < LAYERS; k++) {
        free(m->layer[k].signs);
        for (int axis = 0; axis < 2; axis++) mesh_row_free(&m->layer[k].row[axis]);
    }
    for (int s = 0; s <= BAND; s++) {
        mesh_slab_free(&m->part[s].slab);
        free(m->part[s].vertex);
        free(m->part[s].corner);
        free(m->part[s].closing);
    }
    free(m->table);
    free(m->status);
    free(m->upright);
    mesh_space_end(&m->space);
}

algsurf_status mesh_make(const algsurf_surface *surface, const algsurf_extent *extent,
                         const mesh_options *options, mesh *made) {
    maker *m = calloc(1, sizeof *m);
    memset(made, 0, sizeof *made);
    if (!m) return ALGSURF_E_NO_MEMORY;
    m->options = options;
    m->mesh = made;
    m->how = (algsurf_intersect_options){
        .size = sizeof m->how, .planes = options->planes, .plane_count = options->plane_count};
    m->space.surface = surface;
    m->space.extent = *extent;
    m->space.planes = options->planes;
    m->space.plane_count = options->plane_count;
    algsurf_status status = prepare(m);
    if (status == ALGSURF_OK) status = make_bands(m);
    made->h = m->space.h;
    release(m);
    free(m);
    if (status == ALGSURF_OK && !options->on_surface &&
        !mesh_balance(made, surface, options->run, options->run_data))
        status = ALGSURF_E_NO_MEMORY;
    if (status == ALGSURF_OK && !options->solid && !mesh_open_tidy(made)) status = ALGSURF_E_NO_MEMORY;
    return status;
}
