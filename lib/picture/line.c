/* line.c - the points of a row: those that kernels are to find, those that rays alone find, those that leave.
 */
#include "../base/arithmetic.h"
#include "impl.h"

/* So line->state tells of every point what it is. */
_Static_assert((int)ALGSURF_LANE_HIT == (int)ALGSURF_HIT, "both are the state of a pixel");

void algsurf_i_line_add(algsurf_i_worker *worker, int x, const algsurf_ray *ray, const algsurf_hit *hit) {
    algsurf_i_line *line = &worker->line;
    algsurf_render_stats *stats = &worker->tally->stats;
    const algsurf_i_points *points = &line->points;
    int i = line->count;
    line->state[x] = (uint8_t)hit->state;
    if (line->way) line->way[x] |= ALGSURF_WAY_SINGLE;
    stats->hits += hit->state == ALGSURF_HIT;
    stats->undecided += hit->state == ALGSURF_UNDECIDED;
    if (hit->state == ALGSURF_MISS) return;
    line->pixel[line->count++] = x;
    points->t[i] = hit->t;
    for (int k = 0; k < 3; k++) {
        points->position[k][i] = hit->position[k];
        points->normal[k][i] = hit->normal[k];
        points->direction[k][i] = ray->direction[k];
    }
    if (line->colours)
        algsurf_i_set_look(&line->colours->frame, hit->position, hit->normal, ray->direction, i,
                           &points->looks);
}

static void move_point(const algsurf_i_points *p, int from, int to) {
    p->t[to] = p->t[from];
    for (int k = 0; k < 3; k++) {
        p->position[k][to] = p->position[k][from];
        p->normal[k][to] = p->normal[k][from];
        p->direction[k][to] = p->direction[k][from];
        p->looks.place[k][to] = p->looks.place[k][from];
        p->looks.normal[k][to] = p->looks.normal[k][from];
        p->looks.direction[k][to] = p->looks.direction[k][from];
    }
}

int algsurf_i_drop_unsure(algsurf_i_line *line, int first) {
    int kept = first;
    for (int i = first; i < line->count; i++) {
        if (!line->sure[i]) {
            line->state[line->pixel[i]] = ALGSURF_LANE_UNDECIDED;
            continue;
        }
        if (kept < i) move_point(&line->points, i, kept);
        line->pixel[kept++] = line->pixel[i];
    }
    line->count = kept;
    return 1;
}

/* Shadows need to know places exactly. */
algsurf_i_points algsurf_i_points_to_find(const algsurf_i_worker *worker, int first) {
    const int shadows = worker->picture->shadows;
    const algsurf_i_points *p = &worker->line.points;
    algsurf_i_points found = {.t = p->t + first};
    for (int k = 0; k < 3; k++) {
        if (shadows) found.position[k] = p->position[k] + first;
        if (shadows) found.direction[k] = p->direction[k] + first;
        if (shadows || worker->picture->planes.normals) found.normal[k] = p->normal[k] + first;
        if (!worker->line.colours) continue;
        found.looks.place[k] = p->looks.place[k] + first;
        found.looks.normal[k] = p->looks.normal[k] + first;
        found.looks.direction[k] = p->looks.direction[k] + first;
    }
    return found;
}
