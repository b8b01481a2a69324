/* thin_template.h - what is thin beside rays: points without width, lines without sheets, needles narrower
 * than a pixel.
 *
 * Such a thing is a critical point of P beside the ray, at which P is 0 or has the other sign.  So:
 * 1. From the places where |P| is least along the ray, before its hit (dips_template.h), Newton's method on
 *    P's gradient, with the exact second derivatives: in the directions in which P is curved towards 0
 *    (eigenvectors, with P's sign) and which need a step of MOST_PIXELS at most.  Where P is like a power of
 *    the distance, r^m, a step goes 1/(m-1) of the way, and P is (m-1)/m of the gradient times the step: so
 *    the whole way is known, and gone if that makes P TIMES as small as the step does.  Along one direction
 *    that is not curved, as of a line, on to where the pixel's middle column or row passes: so a line is one
 *    pixel wide.  A step s leads P down by s times the gradient at most, else nothing is found.
 * 2. Thin, if that ends in the pixel, within the chord, where P is 0, but for rounding, or has the other
 * sign. It is an outline, and not thin,
 * - if P has a gradient there, larger than what it is curved explains;
 * - if P has the other sign, too, as far behind that point as the ray is before it: the edge of something
 *   wide, as where y^2 + x^3 = 0 is seen from x > 0;
 * - if P is curved the other way in another direction, a NARROW-th as much at least: a cone, whose inside is
 *   wide next to its tip;
 * - if P is 0 and stays so in two directions: a double sheet, which rays beside this one hit.
 *
 * P is evaluated in the caller's axes: so that its terms vanish, and their roundings with them, about lines
 * and points that are at the origin or on an axis.  Higher powers elsewhere drown in their rounding.
 *
 * That proves nothing.  What is shown as thin is an aid to the eye; what is shown as hit is proved elsewhere.
 */
#ifndef ALGSURF_THIN_TEMPLATE_H
#define ALGSURF_THIN_TEMPLATE_H
#include "points_template.h"
#include "sight_template.h"

#define MOST_PIXELS 4 /* of a step */
#define ASTRAY 8      /* pixels from the ray, on the way */
#define NARROW 16
#define FLAT 0x1p-46 /* what is less curved than so much of the most curved direction */
#define TIMES 10
#define SMALL 0x1p-28      /* beside the diagonal: its square is far below FLAT */
#define TO_ONE_SIDE 0x1p-7 /* pixels: so that what is in the middle between pixels is in one of them */
#define NEWTON_ROUNDS 60   /* along a curved valley of fourth order a round goes a third of the way */

/* ---- P about a point ---- */

/* P's Taylor expansion about LANES points, up to the second order; the sum of the sizes of its terms there.
 */
typedef struct expansion {
    lanes v, x, y, z, xx, xy, yy, xz, yz, zz, size;
} expansion;

INLINE void add_row_of_x(const double *c, int length, lanes x, lanes y, expansion *p) {
    lanes v = all_lanes(0), d = v, dd = v, size = v;
    for (int i = length - 1; i >= 0; i--) {
        dd = dd * x + d;
        d = d * x + v;
        v = v * x + c[i];
        size = size * absolute(x) + fabs(c[i]);
    }
    p->yy = p->yy * y + p->y;
    p->xy = p->xy * y + p->x;
    p->y = p->y * y + p->v;
    p->xx = p->xx * y + dd;
    p->x = p->x * y + d;
    p->v = p->v * y + v;
    p->size = p->size * absolute(y) + size;
}

static expansion expand_about(const algsurf_surface *s, const lanes at[3]) {
    const lanes z = at[2], zero = all_lanes(0);
    const expansion nothing = {zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero};
    expansion p = nothing;
    for (int k = s->level_count - 1; k >= 0; k--) {
        const algsurf_row *row = s->rows + s->levels[k].first;
        expansion q = nothing;
        for (int j = s->levels[k].count - 1; j >= 0; j--)
            add_row_of_x(s->coef + row[j].first, row[j].length, at[0], at[1], &q);
        p.zz = p.zz * z + p.z;
        p.xz = p.xz * z + p.x;
        p.yz = p.yz * z + p.y;
        p.z = p.z * z + p.v;
        p.v = p.v * z + q.v;
        p.x = p.x * z + q.x, p.y = p.y * z + q.y;
        p.xx = p.xx * z + q.xx, p.xy = p.xy * z + q.xy, p.yy = p.yy * z + q.yy;
        p.size = p.size * absolute(z) + q.size;
    }
    return p;
}

INLINE lanes slope_of(const expansion *p) { return root(p->x * p->x + (p->y * p->y + p->z * p->z)); }

/* At least the largest second derivative, at most 3^(1/2) times as much. */
INLINE lanes bend_of(const expansion *p) {
    return root(4 * (p->xx * p->xx + p->yy * p->yy + p->zz * p->zz) +
                2 * (p->xy * p->xy + p->xz * p->xz + p->yz * p->yz));
}

/* Jacobi's rotation that makes a_pq zero, in the lanes where it is not small, which are returned; v[i]
 * becomes the i-th eigenvector. */
INLINE mask rotate(lanes a[3][3], lanes v[3][3], int p, int q) {
    lanes zero = all_lanes(0), one = all_lanes(1);
    mask some = less(SMALL * (absolute(a[p][p]) + absolute(a[q][q])), absolute(a[p][q]));
    if (!any(some)) return some;
    lanes ratio = 0.5 * (a[q][q] - a[p][p]) / choose(some, a[p][q], one);
    lanes t = 1 / (absolute(ratio) + root(ratio * ratio + 1));
    t = choose(some, choose(less(ratio, zero), -t, t), zero);
    lanes c = 1 / root(t * t + 1), s = t * c;
    for (int k = 0; k < 3; k++) {
        lanes x = a[k][p], y = a[k][q];
        a[k][p] = c * x - s * y;
        a[k][q] = s * x + c * y;
    }
    for (int k = 0; k < 3; k++) {
        lanes x = a[p][k], y = a[q][k], e = v[p][k], f = v[q][k];
        a[p][k] = c * x - s * y;
        a[q][k] = s * x + c * y;
        v[p][k] = c * e - s * f;
        v[q][k] = s * e + c * f;
    }
    return some;
}

/* The second derivatives' eigenvalues and eigenvectors. */
static void find_axes(const expansion *p, lanes l[3], lanes v[3][3]) {
    lanes a[3][3] = {{2 * p->xx, p->xy, p->xz}, {p->xy, 2 * p->yy, p->yz}, {p->xz, p->yz, 2 * p->zz}};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) v[i][k] = all_lanes(i == k);
    for (int sweep = 0; sweep < 5; sweep++) {
        mask turned = rotate(a, v, 0, 1);
        turned |= rotate(a, v, 0, 2);
        turned |= rotate(a, v, 1, 2);
        if (!any(turned)) break;
    }
    for (int i = 0; i < 3; i++) l[i] = a[i][i];
}

/* ---- beside a ray ---- */

/* A packet of rays. */
typedef struct beside {
    const algsurf_i_point_job *job;
    sight s;
    lanes near, far; /* depths of the chord */
} beside;

INLINE lanes rounding_of(const beside *b, const expansion *p) {
    return 16 * (b->job->surface->degree + 1) * 0x1p-53 * p->size;
}

/* Of a value of P that counts as 0: with what directions that count as flat add. */
INLINE lanes error_of(const beside *b, const expansion *p, lanes pixel) {
    return rounding_of(b, p) + FLAT * pixel * pixel * bend_of(p);
}

/* A vector in the view's axes. */
INLINE void turn_to_view(const algsurf_i_view *view, const lanes v[3], lanes part[3]) {
    for (int k = 0; k < 3; k++) {
        part[k] = all_lanes(0);
        for (int i = 0; i < 3; i++) part[k] += v[i] * view->axis[k][i];
    }
}

/* Where a point is viewed: in pixels from the ray, to the right and up; its depth; a pixel's size there. */
typedef struct viewed {
    lanes across[2], depth, pixel;
} viewed;

INLINE viewed look_at(const beside *b, const lanes at[3]) {
    const algsurf_i_view *view = b->job->row->view;
    const lanes middle[2] = {b->s.u, b->s.v};
    const lanes from[3] = {at[0] - view->centre[0], at[1] - view->centre[1], at[2] - view->centre[2]};
    lanes place[3];
    viewed p;
    turn_to_view(view, from, place);
    for (int k = 0; k < 3; k++) place[k] *= 1 / view->size;
    lanes shrunk = 1 + view->alpha * place[2];
    p.depth = place[2];
    p.pixel = shrunk * (view->size * b->job->row->thin_side);
    for (int k = 0; k < 2; k++)
        p.across[k] =
            ((place[k] - place[2] * view->beta[k]) / shrunk - middle[k]) * (1 / b->job->row->thin_side);
    return p;
}

INLINE lanes value_at(const beside *b, const lanes at[3], const lanes step[3], lanes times) {
    lanes place[PAIR][3];
    for (int i = 0; i < 3; i++) place[0][i] = at[i] + times * step[i];
    return surface_jets(b->job->surface, place, 1).v[0];
}

/* Newton's step: see the head. */
typedef struct newton_step {
    lanes step[3], falls;        /* the gradient along it, times -1 */
    lanes taken;                 /* so many directions, */
    lanes left[3];               /* the least curved one, */
    mask is_line;                /* by far */
    lanes axis[3][3], curved[3]; /* directions, and how much P is curved away from 0 in them */
} newton_step;

INLINE newton_step step_of(const expansion *p, lanes sign, lanes pixel) {
    const lanes g[3] = {p->x, p->y, p->z}, zero = all_lanes(0);
    lanes l[3];
    newton_step n = {.step = {zero, zero, zero}, .falls = zero, .taken = zero};
    find_axes(p, l, n.axis);
    lanes least = FLAT * largest_size(l);
    for (int i = 0; i < 3; i++) {
        lanes slope = dot(g, n.axis[i]), curved = sign * l[i];
        mask take = less(least, curved) & at_most(absolute(slope), MOST_PIXELS * pixel * curved);
        lanes step = choose(take, -slope / choose(take, l[i], all_lanes(1)), zero);
        for (int k = 0; k < 3; k++) n.step[k] += step * n.axis[i][k];
        n.falls -= sign * slope * step;
        n.taken += choose(take, all_lanes(1), zero);
        n.curved[i] = curved;
    }
    mask first = at_most(absolute(l[0]), smaller(absolute(l[1]), absolute(l[2]))),
         second = at_most(absolute(l[1]), absolute(l[2]));
    for (int k = 0; k < 3; k++)
        n.left[k] = choose(first, n.axis[0][k], choose(second, n.axis[1][k], n.axis[2][k]));
    n.is_line =
        less(smaller(absolute(l[0]), smaller(absolute(l[1]), absolute(l[2]))), 0x1p-10 / FLAT * least);
    return n;
}

/* How many times the step: see the head. */
INLINE lanes lengthen(const beside *b, const newton_step *n, const lanes at[3], lanes value, mask on) {
    lanes one = all_lanes(1), share = value / n->falls;
    mask longer = on & less(all_lanes(0.55), share) & less(share, all_lanes(0.97));
    lanes times = choose(longer, share / (1 - share), one);
    if (!any(longer)) return one;
    lanes there = value_at(b, at, n->step, one), further = value_at(b, at, n->step, times);
    return choose(less(TIMES * absolute(further), absolute(there)), times, one);
}

/* Along the direction that is left, so many pixels at most, to where the pixel's middle column or row passes.
 */
INLINE void follow_line(const beside *b, const newton_step *n, lanes pixels, lanes at[3]) {
    lanes part[3];
    viewed p = look_at(b, at);
    turn_to_view(b->job->row->view, n->left, part);
    /* how far a step of one pixel goes across: in pixels */
    const lanes right = part[0] - b->s.a * part[2], up = part[1] - b->s.b * part[2];
    mask flat = at_most(absolute(up), absolute(right));
    lanes along = choose(flat, right, up), off = choose(flat, p.across[0], p.across[1]);
    mask slanted = less(absolute(off), pixels * absolute(along));
    lanes by = choose(slanted, off / choose(slanted, along, all_lanes(1)), all_lanes(0)) * p.pixel;
    for (int k = 0; k < 3; k++) at[k] -= by * n->left[k];
}

/* Is P 0 on a sheet about a point where it is 0: after steps across the most curved direction, and back? */
static mask is_sheet(const beside *b, const newton_step *n, const lanes at[3], lanes sign, lanes pixel) {
    mask sheet = ~no_lane(), none_yet = sheet;
    lanes most = larger(larger(n->curved[0], n->curved[1]), n->curved[2]);
    for (int i = 0; i < 3; i++) {
        lanes to[3];
        for (int k = 0; k < 3; k++) to[k] = at[k] + 0.25 * pixel * n->axis[i][k];
        const expansion p = expand_about(b->job->surface, to);
        const newton_step back = step_of(&p, sign, pixel);
        mask is_most = none_yet & at_most(most, n->curved[i]);
        none_yet &= ~is_most;
        sheet &= is_most | at_most(absolute(value_at(b, to, back.step, all_lanes(1))), rounding_of(b, &p));
    }
    return sheet;
}

/* Is what was found, where P has that value, narrow, and no sheet or cone? */
INLINE mask is_narrow(const beside *b, const newton_step *n, const lanes at[3], lanes value, lanes error,
                      lanes sign, lanes pixel, mask open) {
    lanes zero = all_lanes(0), most = zero, back = zero, narrow = zero;
    for (int i = 0; i < 3; i++) {
        most = larger(most, n->curved[i]);
        back = larger(back, -n->curved[i]);
    }
    open &= at_most(NARROW * back, most);
    for (int i = 0; i < 3; i++)
        narrow +=
            choose(at_most(0x1p-8 * most, n->curved[i]) & at_most(-value, 2 * pixel * pixel * n->curved[i]),
                   all_lanes(1), zero);
    mask sheet = open & less(narrow, all_lanes(2));
    if (any(sheet & at_most(-error, value))) sheet &= less(value, -error) | is_sheet(b, n, at, sign, pixel);
    return open & ~sheet;
}

/* Where the second derivatives are no more than what rounding makes of them, n^2 / |X|^2 times P's: powers of
 * what vanishes there. */
INLINE mask is_shapeless(const beside *b, const expansion *p, const lanes at[3]) {
    const int n = b->job->surface->degree;
    return less(bend_of(p) * dot(at, at), 4.0 * n * n * rounding_of(b, p));
}

/* Is there something thin beside the rays at points of theirs?  Then it is at *depth, and a line goes along
 * that. */
static mask is_thin(const beside *b, const lanes start[3], mask open, lanes *depth, lanes along[3]) {
    const lanes zero = all_lanes(0);
    lanes at[3] = {start[0], start[1], start[2]};
    expansion p = expand_about(b->job->surface, at);
    const lanes first = absolute(p.v),
                side = choose(at_most(first, rounding_of(b, &p)), p.xx + p.yy + p.zz, p.v);
    const lanes sign = choose(less(side, zero), all_lanes(-1), all_lanes(1));
    lanes pixel = look_at(b, at).pixel, most = zero;
    mask found = no_lane(), settles = found;
    lanes settled = zero; /* so often */
    for (int round = 0; any(open) && round < NEWTON_ROUNDS; round++) {
        newton_step n = step_of(&p, sign, pixel);
        lanes value = sign * p.v, error = error_of(b, &p, pixel), moved = zero, to[3], behind[3];
        open &= at_most(value, n.falls + 2 * error);
        lanes times = lengthen(b, &n, at, value, open);
        for (int k = 0; k < 3; k++) to[k] = at[k] + times * n.step[k];
        const mask zero_here = open & at_most(absolute(value), error);
        if (any(zero_here)) { /* what leads away from there is rounding */
            const mask away = zero_here & less(8 * error, absolute(value_at(b, to, n.step, zero)));
            for (int k = 0; k < 3; k++) to[k] = choose(away, at[k], to[k]);
        }
        most = larger(most, n.taken);
        /* where tangents seem curved on the way, lines are followed at last, twice: or else it is a point */
        const mask at_last = settles & n.is_line;
        const mask is_line = less(all_lanes(1), n.taken) & less(most, all_lanes(3));
        follow_line(b, &n, choose(is_line, all_lanes(64), choose(at_last, all_lanes(4), zero)), to);
        for (int k = 0; k < 3; k++) {
            moved = larger(moved, absolute(to[k] - at[k]));
            at[k] = choose(open, to[k], at[k]);
        }
        p = expand_about(b->job->surface, at);
        const viewed s = look_at(b, at);
        lanes off = larger(absolute(s.across[0] + TO_ONE_SIDE), absolute(s.across[1] + TO_ONE_SIDE));
        open &= at_most(off, all_lanes(ASTRAY)) & ~is_shapeless(b, &p, at);
        error = 4 * error_of(b, &p, pixel);
        value = sign * p.v;
        mask ends = open & at_most(moved, 0x1p-9 * pixel) & at_most(value, 0x1p-10 * first + error);
        settles = ends & less(all_lanes(2), most) & less(settled, all_lanes(2));
        settled += choose(settles, all_lanes(1), zero);
        ends &= ~settles;
        open &= ~ends;
        ends &= at_most(off, all_lanes(0.5)) & at_most(b->near, s.depth) & at_most(s.depth, b->far) &
                at_most(pixel * slope_of(&p), 0x1p-4 * pixel * pixel * bend_of(&p) + error);
        if (!any(ends)) continue;
        for (int k = 0; k < 3; k++) behind[k] = at[k] - start[k];
        ends &= at_most(-0x1p-4 * first - error, sign * value_at(b, at, behind, all_lanes(1)));
        ends &= is_narrow(b, &n, at, value, error, sign, pixel, ends);
        *depth = choose(ends, s.depth, *depth);
        for (int k = 0; k < 3; k++)
            along[k] = choose(ends & (is_line | n.is_line), n.left[k], choose(ends, zero, along[k]));
        found |= ends;
    }
    return found;
}

/* Dips i, i+1 ..: their rays, and where those are; returns which there are. */
INLINE mask take_dips(const algsurf_i_point_job *points, const row_rays *rows, const algsurf_i_dips *dips,
                      int i, beside *b, lanes at[3]) {
    const int count = dips->count - i;
    const lanes pixel = load_some_integers(dips->at + i, count), z = load_some(dips->depth + i, count);
    const packet_rays ray = rays_of_packet(rows, pixel, z);
    mask open;
    b->job = points;
    b->s = sight_at(points->row, pixel);
    const chord c = clip(points->row, &b->s, all_lanes(points->row->near), &open);
    b->near = c.near, b->far = c.far;
    for (int k = 0; k < 3; k++) at[k] = ray.foot[k] + ray.z * ray.along[k];
    return open & less(numbered(), all_lanes(count));
}

/* Keeps the dips where P may be 0 in the pixel, and its gradient, too. */
static void keep_small(const algsurf_i_point_job *points, const row_rays *rows, algsurf_i_dips *dips) {
    int kept = 0;
    for (int i = 0; i < dips->count; i += LANES) {
        beside b;
        lanes at[3];
        mask open = take_dips(points, rows, dips, i, &b, at);
        const expansion p = expand_about(points->surface, at);
        const lanes pixel = look_at(&b, at).pixel;
        lanes value = absolute(p.v) - error_of(&b, &p, pixel), bend = bend_of(&p), slope = slope_of(&p);
        const unsigned which =
            bits(open & at_most(value, 0.5 * pixel * pixel * bend) & at_most(value, 0.5 * pixel * slope) &
                 at_most(slope, pixel * bend + rounding_of(&b, &p) / pixel));
        for (int l = 0; which >> l && l < LANES; l++) {
            if (!(which >> l & 1)) continue;
            dips->at[kept] = dips->at[i + l];
            dips->depth[kept++] = dips->depth[i + l];
        }
    }
    dips->count = kept;
}

/* See kernels.h. */
static void find_thin(const algsurf_i_point_job *points, algsurf_i_dips *dips, double *depth,
                      double *const along[3]) {
    const row_rays rows = rays_of_row(points);
    keep_small(points, &rows, dips);
    for (int i = 0; i < dips->count; i += LANES) {
        beside b;
        lanes at[3], z = all_lanes(0), line[3] = {z, z, z};
        mask open = take_dips(points, &rows, dips, i, &b, at), found = is_thin(&b, at, open, &z, line);
        store_some(depth + i, choose(found, z, all_lanes(HUGE_VAL)), dips->count - i);
        for (int k = 0; k < 3; k++) store_some(along[k] + i, line[k], dips->count - i);
    }
}

#endif
