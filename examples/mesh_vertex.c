/* mesh_vertex.c - see mesh_vertex.h. */
#include "mesh_vertex.h"

#include <math.h>
#include <string.h>

enum { STEPS = 4 };               /* Newton's, from within a cell */
static const double SMOOTH = 0.9; /* a cosine to the mean normal: the mean of the crossings is near enough */
static const double TURN = 0.5;   /* a cosine: sharp */
static const double SMALL = 0.05; /* of the largest eigenvalue: no direction to move in */
static const double BESIDE = 15.0 / 16; /* of a cell: how far the vertex of a cut or a wedge may leave it, */
static const double BACK = 1.0 / 256;   /* less this part of the way, so that no other cell has it, too */

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* ---- least squares ---- */

/* One rotation that makes a[p][q] zero, unless it is nothing beside the others; v gathers the eigenvectors as
 * columns. */
static void rotate(double a[3][3], double v[3][3], int p, int q) {
    if (fabs(a[p][q]) <= 0x1p-50 * (fabs(a[p][p]) + fabs(a[q][q]))) return;
    const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    const double t = copysign(1, theta) / (fabs(theta) + sqrt(theta * theta + 1)), c = 1 / sqrt(t * t + 1),
                 s = t * c;
    for (int k = 0; k < 3; k++) {
        const double kp = a[k][p], kq = a[k][q], vp = v[k][p], vq = v[k][q];
        a[k][p] = c * kp - s * kq, a[k][q] = s * kp + c * kq;
        v[k][p] = c * vp - s * vq, v[k][q] = s * vp + c * vq;
    }
    for (int k = 0; k < 3; k++) {
        const double pk = a[p][k], qk = a[q][k];
        a[p][k] = c * pk - s * qk, a[q][k] = s * pk + c * qk;
    }
}

/* The shortest x that makes a x - b small, a symmetric; by Jacobi's method, eigenvalues below SMALL of the
 * largest one left out. */
static void solve(double a[3][3], const double b[3], double x[3]) {
    double v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int sweep = 0; sweep < 6; sweep++) rotate(a, v, 0, 1), rotate(a, v, 0, 2), rotate(a, v, 1, 2);
    const double largest = fmax(a[0][0], fmax(a[1][1], a[2][2]));
    for (int k = 0; k < 3; k++) x[k] = 0;
    for (int e = 0; e < 3; e++) {
        if (!(a[e][e] > SMALL * largest)) continue;
        const double along = (v[0][e] * b[0] + v[1][e] * b[1] + v[2][e] * b[2]) / a[e][e];
        for (int k = 0; k < 3; k++) x[k] += along * v[k][e];
    }
}

/* Adds a plane n . x = d to the normal equations. */
static void add_plane(double a[3][3], double b[3], const double n[3], double d) {
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) a[i][k] += n[i] * n[k];
        b[i] += n[i] * d;
    }
}

static void clamp(double x[3], const double low[3], const double high[3]) {
    for (int k = 0; k < 3; k++) x[k] = fmin(fmax(x[k], low[k]), high[k]);
}

/* ---- the sheet ---- */

typedef struct sheet {
    const mesh_crossing *crossing;
    int count;
    unsigned parts; /* those that are crossed, a bit each */
    double mean[3];
    double spread; /* the least cosine between a normal of the surface and their mean */
} sheet;

static sheet look_at(const mesh_crossing *crossing, int count, double normal[3]) {
    sheet s = {.crossing = crossing, .count = count, .spread = 1};
    for (int k = 0; k < 3; k++) normal[k] = 0;
    for (int i = 0; i < count; i++) {
        s.parts |= 1u << crossing[i].part;
        for (int k = 0; k < 3; k++) {
            s.mean[k] += crossing[i].at[k] / count;
            if (crossing[i].part == MESH_SURFACE) normal[k] += crossing[i].normal[k];
        }
    }
    const double length = mesh_length(normal);
    for (int i = 0; i < count; i++)
        if (crossing[i].part == MESH_SURFACE)
            s.spread = fmin(s.spread, length > 0 ? dot(normal, crossing[i].normal) / length : 0);
    return s;
}

/* The vertex by the tangent planes alone. */
static void fit_planes(const sheet *s, double x[3]) {
    double a[3][3] = {{0}}, b[3] = {0};
    for (int i = 0; i < s->count; i++) {
        double to[3];
        for (int k = 0; k < 3; k++) to[k] = s->crossing[i].at[k] - s->mean[k];
        add_plane(a, b, s->crossing[i].normal, dot(s->crossing[i].normal, to));
    }
    solve(a, b, x);
    for (int k = 0; k < 3; k++) x[k] += s->mean[k];
}

/* One step towards all parts of the sheet; a coordinate at an end of the cell stays where it would leave it.
 * Returns 0 at the end. */
static int step(const mesh_space *space, unsigned parts, const double low[3], const double high[3],
                double x[3]) {
    double before[3], most = 0;
    int held = 0;
    memcpy(before, x, sizeof before);
    for (int attempt = 0; attempt < 3; attempt++) {
        double a[3][3] = {{0}}, b[3] = {0}, move[3], normal[3], distance;
        int now_held = held;
        for (int part = 0; parts >> part; part++) {
            if (!(parts >> part & 1) || !mesh_space_part(space, part, x, &distance, normal)) continue;
            for (int k = 0; k < 3; k++)
                if (held >> k & 1) normal[k] = 0;
            add_plane(a, b, normal, -distance);
        }
        const double square = a[0][0] + a[1][1] + a[2][2];
        if ((parts & (parts - 1)) == 0) /* one part: b is along its normal */
            for (int k = 0; k < 3; k++) move[k] = square > SMALL ? b[k] / square : 0;
        else
            solve(a, b, move);
        for (int k = 0; k < 3; k++)
            if (x[k] + move[k] < low[k] || x[k] + move[k] > high[k]) now_held |= 1 << k;
        for (int k = 0; k < 3; k++) x[k] += move[k];
        clamp(x, low, high);
        if (now_held == held) break;
        held = now_held;
    }
    for (int k = 0; k < 3; k++) most = fmax(most, fabs(x[k] - before[k]));
    return most > 1e-12 * space->h;
}

/* The normal at the vertex; where the surface has none, or turns, that of the crossings. */
static void take_normal(const mesh_space *space, const sheet *s, const double mean[3], mesh_vertex *vertex) {
    double normal[3], distance;
    int part = 0;
    while (!(s->parts >> part & 1)) part++; /* the surface, if it is among them */
    const int smooth = part != MESH_SURFACE || s->spread > TURN;
    if (!smooth || !mesh_space_part(space, part, vertex->at, &distance, normal)) {
        const double length = mesh_length(mean);
        for (int k = 0; k < 3; k++) normal[k] = length > 0 ? mean[k] / length : 0;
    }
    for (int k = 0; k < 3; k++) vertex->normal[k] = (float)normal[k];
}

void mesh_vertex_place(const mesh_space *space, const mesh_crossing *crossing, int count,
                       const double from[3], const double to[3], mesh_vertex *vertex) {
    double mean[3], x[3], low[3], high[3];
    const sheet s = look_at(crossing, count, mean);
    const int one_part = (s.parts & (s.parts - 1)) == 0;
    memset(vertex, 0, sizeof *vertex);
    const int on_surface = (s.parts & 1u << MESH_SURFACE) != 0;
    vertex->sharp = on_surface && s.spread < TURN;
    vertex->kind = !on_surface ? MESH_CLOSING : !one_part || s.spread < SMOOTH ? MESH_FIXED : MESH_SMOOTH;
    for (int k = 0; k < 3; k++) {
        const double beside = one_part && !vertex->sharp ? 0 : BESIDE * space->h;
        low[k] = from[k] - beside;
        high[k] = to[k] + beside;
    }
    memcpy(x, s.mean, sizeof x);
    if (!one_part || s.spread < SMOOTH) fit_planes(&s, x);
    clamp(x, low, high);
    for (int i = 0; i < STEPS && step(space, s.parts, low, high, x); i++) {
    }
    for (int k = 0; k < 3; k++) {
        const double inside = fmin(fmax(x[k], from[k]), to[k]);
        vertex->at[k] = x[k] + BACK * (inside - x[k]);
    }
    take_normal(space, &s, mean, vertex);
}
