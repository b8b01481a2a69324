/* far_template.h - rays without ends, or with far ones: the pieces that LANES of them are searched in.
 *
 * What Bernstein coefficients over a piece tell of what is beyond its ends: roots/beyond_template.h.  P's
 * degree along a ray is that in the coordinates that change.
 *
 * Pieces.  The innermost one is about the ray's point nearest to the origin of space, where the surface's
 * unit balances P's terms.  Those before and behind end 8 times as far from that point each, so that on each
 * of them the terms of P are of one size, however far it is.  They are searched in their order, from the one
 * before which there is nothing, or where the ray begins, to the first hit, or to the one behind which there
 * is nothing, or the ray ends.  Their ends are places like any other: where a root is too near to one, the
 * ray is undecided.  How long the innermost one is decides about the time alone.
 *
 * A ray that goes on with another piece waits until there are LANES such rays. */
#ifndef ALGSURF_FAR_TEMPLATE_H
#define ALGSURF_FAR_TEMPLATE_H
#include "../roots/beyond_template.h"
#include "../surface/impl.h"
#include "chord_template.h"
#include "powers_template.h"

#define LONG 8         /* half a chord, in sizes of the surface: longer ones go by pieces */
#define MOST_PIECES 16 /* on either side */

typedef struct far_rays {
    lanes first, last;   /* the rays' ends */
    lanes centre, reach; /* of the innermost piece */
    lanes piece;         /* 0: that one; 1, 2, .. those behind; -1, -2, .. those before */
    lanes degree;        /* P's along the ray, at most */
    mask far, looking;   /* lanes that go by pieces; those that still look for the first one */
    beyond is;           /* the piece that was searched last; lost: there is no end of them */
} far_rays;

/* The end of piece i, where i + 1 begins. */
INLINE lanes end_of_piece(const far_rays *f, lanes i) {
    mask before = less(i, all_lanes(0));
    lanes steps = 3 * choose(before, -1 - i, i) + (0x1p52 + 1023); /* 8^i, by its exponent */
    lanes length = f->reach * (lanes)((words)steps << 52);
    return choose(before, f->centre - length, f->centre + length);
}

INLINE void set_piece(const far_rays *f, ray_lanes *r) {
    r->near = choose(f->far, larger(f->first, end_of_piece(f, f->piece - 1)), r->near);
    r->far = choose(f->far, smaller(f->last, end_of_piece(f, f->piece)), r->far);
}

/* The longest of: what is in a ball of the surface's size; half the way to the ball's point farthest from the
 * ray's; and twice as far as where the ray begins or ends, if that is beyond. */
APART void begin_pieces(const algsurf_i_rays_job *job, const places *w, ray_lanes *r, far_rays *f) {
    const algsurf_surface *s = job->surface;
    const lanes *d = r->direction, size = all_lanes(s->spread * s->spread);
    lanes square = dot(d, d), x[3];
    f->first = r->near;
    f->last = r->far;
    f->centre = -dot(r->origin, d) / square;
    f->piece = all_lanes(0);
    f->looking = f->far;
    for (int i = 0; i < 3; i++) x[i] = along(r->origin[i], all_lanes(0), f->centre, d[i]);
    lanes away = dot(x, x);
    f->reach = root(larger(size - away, 0.25 * (size + away)) / square);
    f->reach = larger(f->reach, 2 * larger(f->first - f->centre, f->centre - f->last));
    f->degree = all_lanes(s->degree);
    for (int l = 0; l < w->count; l++) f->degree[l] = s->degree_in[changing(job, w, l)];
    set_piece(f, r);
}

/* Sets r to the first piece of lanes that are long. */
INLINE void begin_far(const algsurf_i_rays_job *job, const places *w, ray_lanes *r, far_rays *f) {
    f->far = r->open & ~less(0.5 * r->far - 0.5 * r->near, all_lanes(LONG * job->surface->spread));
    if (any(f->far)) begin_pieces(job, w, r, f);
}

/* What the coefficients of degree n tell, over the pieces that have been searched. */
APART beyond look_out(const lanes *b, const lanes *e, int n, int own, const far_rays *f) {
    beyond is = look_beyond(b, e, n, own, f->degree);
    is.lost &= at_most(absolute(f->piece), all_lanes(0));
    return is;
}

/* The packet's; and those from powers, whose radii are less, if nodes do not show the degree of some lanes.
 */
APART void look_about(const algsurf_surface *s, const chord_line *line, const packet *k, mask which, int n,
                      int own, far_rays *f) {
    f->is = look_out(k->b, k->e, n, own, f);
    const mask lost = which & f->is.lost; /* these alone: a ray's answer does not hang on its neighbours */
    if (own || !any(lost)) return;
    packet again;
    coefficients_from_powers(s, line, n, again.b, again.e);
    const beyond more = look_out(again.b, again.e, n, 1, f);
    f->is.none_before |= lost & more.none_before;
    f->is.none_behind |= lost & more.none_behind;
    f->is.lost &= ~lost | more.lost;
}

/* Lanes for which the piece before, or the one behind, is to be searched. */
INLINE mask lanes_before(const ray_lanes *r, far_rays *f, mask which) {
    f->looking &= which & ~f->is.none_before & less(f->first, r->near);
    return f->looking;
}

INLINE mask lanes_behind(const ray_lanes *r, const far_rays *f, mask which) {
    return which & ~f->is.none_behind & less(r->far, f->last);
}

/* Lanes go on with another piece; those that there is no end of are undecided. */
INLINE mask go_on(far_rays *f, packet *k, mask before, mask behind) {
    mask going = before | behind;
    f->piece += choose(behind, all_lanes(1), all_lanes(0)) - choose(before, all_lanes(1), all_lanes(0));
    k->hit &= ~going;
    k->undecided |= going;
    going &= ~f->is.lost & at_most(absolute(f->piece), all_lanes(MOST_PIECES));
    k->undecided &= ~going;
    return going;
}

/* The same for first hits, after k has searched the pieces of `opened` lanes: the others are answered. */
APART mask next_pieces(const algsurf_i_rays_job *job, const ray_lanes *r, far_rays *f, const chord_line *line,
                       packet *k, mask opened, int n, int own) {
    mask which = f->far & opened;
    if (job->any) which &= ~k->hit;
    if (!any(which)) return which;
    look_about(job->surface, line, k, which, n, own, f);
    mask before = lanes_before(r, f, which);
    mask behind = lanes_behind(r, f, which & ~(before | k->hit | k->undecided));
    return go_on(f, k, before, behind);
}

/* ---- rays that wait for their next piece, until there are LANES of them ---- */

typedef struct waiting {
    int count;
    size_t ray[2 * LANES];
    double piece[2 * LANES], looking[2 * LANES];
} waiting;

APART void put(waiting *list, const places *w, const far_rays *f, unsigned which) {
    unsigned looking = bits(f->looking);
    for (int l = 0; l < w->count; l++) {
        if (!(which >> l & 1)) continue;
        list->ray[list->count] = w->ray[l];
        list->piece[list->count] = f->piece[l];
        list->looking[list->count++] = looking >> l & 1;
    }
}

/* The last ones: LANES, or as many as there are. */
APART void take(waiting *list, const algsurf_i_rays_job *job, places *w) {
    const double *const from[8] = {job->rays->origin[0],    job->rays->origin[1],    job->rays->origin[2],
                                   job->rays->direction[0], job->rays->direction[1], job->rays->direction[2],
                                   job->rays->t_min,        job->rays->t_max};
    w->listed = 1;
    w->count = list->count < LANES ? list->count : LANES;
    list->count -= w->count;
    for (int l = 0; l < w->count; l++) {
        w->ray[l] = list->ray[list->count + l];
        for (int i = 0; i < 8; i++) w->copy[i][l] = from[i] ? from[i][w->ray[l]] : 0;
    }
}

/* The pieces of those just taken. */
APART void resume(const waiting *list, const places *w, ray_lanes *r, far_rays *f) {
    lanes looking = all_lanes(0);
    for (int l = 0; l < w->count; l++) {
        f->piece[l] = list->piece[list->count + l];
        looking[l] = list->looking[list->count + l];
    }
    f->looking = less(all_lanes(0), looking);
    set_piece(f, r);
}

#endif
