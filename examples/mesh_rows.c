/* mesh_rows.c - see mesh_rows.h. */
#include "mesh_rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FIRST_ROOM = 64 }; /* for hits of a row */

void mesh_doubt_add(mesh_doubt *doubt, const double at[3]) {
    if (doubt->count++ == 0) memcpy(doubt->at, at, sizeof doubt->at);
}

void mesh_doubts_join(mesh_doubt *sum, const mesh_doubt *more) {
    for (int i = 0; i < MESH_DOUBTS; i++) {
        if (sum[i].count == 0) memcpy(sum[i].at, more[i].at, sizeof sum[i].at);
        sum[i].count += more[i].count;
    }
}

/* ---- one line ---- */

typedef struct line {
    const mesh_space *space;
    const algsurf_intersect_options *how;
    mesh_row *row;
    int axis;
    double x[3]; /* a point of it; x[axis] is free */
    double span[2];
    algsurf_ray ray;
    size_t first; /* its hits in the row */
} line;

static double *at(line *l, double t) {
    l->x[l->axis] = t;
    return l->x;
}

static int add(mesh_row *row, const algsurf_hit *hit) {
    if (row->count == row->room) {
        const size_t room = 2 * row->room;
        mesh_hit *hits = realloc(row->hits, room * sizeof *hits);
        if (!hits) return 0;
        row->hits = hits;
        row->room = room;
    }
    mesh_hit *to = &row->hits[row->count++];
    to->t = hit->t;
    to->side = (signed char)hit->side;
    for (int a = 0; a < 3; a++) to->normal[a] = (float)hit->normal[a];
    return 1;
}

/* Adds the crossings of the line, and counts what is special about them. */
static algsurf_status take_hits(line *l) {
    algsurf_hit hits[ALGSURF_MAX_DEGREE];
    int count = 0, next = 0;
    double end = -INFINITY; /* of the edge with the crossing before, which may be at both its ends */
    algsurf_status status = algsurf_intersect_all(l->space->surface, &l->space->extent, &l->ray, l->how, hits,
                                                  ALGSURF_MAX_DEGREE, &count);
    for (int i = 0; i < count && status >= 0; i++) {
        const algsurf_hit *hit = &hits[i];
        const int undecided = hit->state == ALGSURF_STATE_UNDECIDED;
        if (undecided) mesh_doubt_add(&l->row->doubts[MESH_UNDECIDED], hit->position);
        if (!undecided && hit->multiplicity % 2 == 0) {
            mesh_doubt_add(&l->row->doubts[MESH_TOUCHED], hit->position);
            continue;
        }
        if (hit->t <= end) mesh_doubt_add(&l->row->doubts[MESH_CROWDED], hit->position);
        while (next < l->space->cells[l->axis] && l->space->point[l->axis][next] <= hit->t) next++;
        end = l->space->point[l->axis][next];
        if (!add(l->row, hit)) return ALGSURF_E_NO_MEMORY;
    }
    return status < 0 ? status : ALGSURF_OK;
}

/* Is P negative at a point, as far as doubles tell? */
static int is_negative(line *l, double t) {
    double value = 0;
    (void)algsurf_surface_value(l->space->surface, at(l, t), &value, NULL);
    return value < 0;
}

/* The sign of P along a line without crossings: proved, unless the line lies in the surface, or touches it.
 */
static int is_negative_everywhere(line *l) {
    double value, bound;
    algsurf_hit hit;
    const double middle = l->span[0] + 0.5 * (l->span[1] - l->span[0]);
    if (algsurf_surface_value(l->space->surface, at(l, middle), &value, &bound) == ALGSURF_OK &&
        fabs(value) > bound)
        return value < 0;
    if (algsurf_intersect_first(l->space->surface, &l->space->extent, &l->ray, l->how, &hit) == ALGSURF_OK &&
        hit.side != 0)
        return hit.side < 0;
    return is_negative(l, middle);
}

/* The bits of the points of the line.  A crossing at a point counts as before it. */
static void take_signs(line *l, unsigned char *signs) {
    const int points = l->space->cells[l->axis] + 1;
    const double *point = l->space->point[l->axis];
    const mesh_hit *hit = l->row->hits + l->first;
    size_t left = l->row->count - l->first;
    int undecided = 0, negative = left > 0 ? hit->side < 0 : is_negative_everywhere(l);
    for (size_t i = 0; i < left; i++) undecided |= hit[i].side == 0;
    for (int i = 0; i < points; i++) {
        for (; left > 0 && hit->t <= point[i]; hit++, left--) negative = hit->side > 0;
        if (undecided) negative = is_negative(l, point[i]);
        if (point[i] >= l->span[0] && point[i] <= l->span[1])
            signs[i] = (unsigned char)(MESH_IN_EXTENT | (negative ? MESH_NEGATIVE : 0));
    }
}

/* ---- a row ---- */

algsurf_status mesh_row_trace(const mesh_space *space, int axis, int at_plane,
                              const algsurf_intersect_options *how, mesh_row *row, unsigned char *signs) {
    const int across = axis == 2 ? 1 : 2, along = 3 - axis - across, lines = space->cells[along] + 1;
    const size_t points = (size_t)space->cells[axis] + 1;
    algsurf_status status = ALGSURF_OK;
    line l = {.space = space, .how = how, .row = row, .axis = axis};
    memset(row->doubts, 0, sizeof row->doubts);
    row->count = 0;
    if (!row->start) row->start = malloc(((size_t)lines + 1) * sizeof *row->start);
    if (!row->hits) row->hits = malloc(FIRST_ROOM * sizeof *row->hits);
    if (!row->start || !row->hits) return ALGSURF_E_NO_MEMORY;
    if (row->room == 0) row->room = FIRST_ROOM;
    if (signs) memset(signs, 0, (size_t)lines * points);
    for (int i = 0; i < lines && status == ALGSURF_OK; i++) {
        int part[2];
        row->start[i] = l.first = row->count;
        l.x[across] = space->point[across][at_plane];
        l.x[along] = space->point[along][i];
        l.x[axis] = 0;
        if (!mesh_space_span(space, axis, l.x, l.span, part)) continue;
        l.ray = (algsurf_ray){.t_min = l.span[0], .t_max = l.span[1]};
        memcpy(l.ray.origin, l.x, sizeof l.x);
        l.ray.direction[axis] = 1; /* so that t is the coordinate */
        status = take_hits(&l);
        if (signs && status == ALGSURF_OK) take_signs(&l, signs + points * (size_t)i);
    }
    row->start[lines] = row->count;
    return status;
}

void mesh_row_free(mesh_row *row) {
    free(row->hits);
    free(row->start);
    memset(row, 0, sizeof *row);
}

/* ---- an edge ---- */

/* Is a crossing at a point after it, as the sign there tells?  Else it is before it, as in take_signs. */
static int is_after(const mesh_hit *hit, int bits) {
    return (bits & MESH_IN_EXTENT) && hit->side != 0 && (hit->side < 0) == (bits & MESH_NEGATIVE);
}

/* The crossing of an edge, the first one that is met from its inner end; null: there is none. */
static const mesh_hit *first_on(const mesh_hit *hits, size_t count, const double ends[2], int low, int high) {
    const mesh_hit *found = NULL;
    for (size_t i = 0; i < count && hits[i].t <= ends[1]; i++) {
        if (hits[i].t < ends[0] || (hits[i].t == ends[0] && !is_after(&hits[i], low))) continue;
        if (hits[i].t == ends[1] && is_after(&hits[i], high)) continue;
        found = &hits[i];
        if (low == MESH_INSIDE) break;
    }
    return found;
}

/* The same where rounding, or an undecided place, hides it: the nearest one. */
static const mesh_hit *nearest(const mesh_hit *hits, size_t count, double t) {
    const mesh_hit *found = NULL;
    for (size_t i = 0; i < count; i++)
        if (!found || fabs(hits[i].t - t) < fabs(found->t - t)) found = &hits[i];
    return found;
}

void mesh_row_crossing(const mesh_space *space, const mesh_row *row, int axis, const int point[3], int low,
                       int high, mesh_crossing *crossing) {
    const int index = axis == 0 ? point[1] : point[0], is_low = low == MESH_INSIDE;
    const double *ends = &space->point[axis][point[axis]], middle = 0.5 * (ends[0] + ends[1]);
    const mesh_hit *hits = row->hits + row->start[index];
    const size_t count = row->start[index + 1] - row->start[index];
    const mesh_hit *hit = first_on(hits, count, ends, low, high);
    const int leaves = !((is_low ? high : low) & MESH_IN_EXTENT);
    double span[2], unused;
    int part[2];
    for (int a = 0; a < 3; a++) crossing->at[a] = space->point[a][point[a]];
    crossing->part = MESH_SURFACE;
    if (leaves && !hit && mesh_space_span(space, axis, crossing->at, span, part)) {
        crossing->part = part[is_low];
        crossing->at[axis] = fmin(fmax(span[is_low], ends[0]), ends[1]);
        if (mesh_space_part(space, crossing->part, crossing->at, &unused, crossing->normal)) return;
    }
    if (!hit) hit = nearest(hits, count, middle);
    crossing->at[axis] = hit ? fmin(fmax(hit->t, ends[0]), ends[1]) : middle;
    for (int a = 0; a < 3; a++) crossing->normal[a] = hit ? (double)hit->normal[a] : 0;
}
