/* tiles_template.h - tiles of pixels: which are empty, which see one sheet of the surface.
 *
 * The rays of a tile share one polynomial in depth (surface/beam.h).  Its terms in xi and eta up to the third
 * order are kept; the others become a radius, `rest`, those beyond the fourth by a bound of their row.  LANES
 * tiles of a row are searched side by side; none of them depends on its neighbours.
 *
 * Chords.  Points of two rays of a tile at one depth are at most
 *     d = sqrt(h_u^2 + h_v^2) (1 + |alpha|)
 * apart, if one of the rays is the middle one.  So each ray's chord is inside that of the middle ray with an
 * extent larger by d in each direction, and holds that of the middle ray with an extent smaller by d.  Planes
 * are moved by d likewise.
 *
 * Range.  From the cut to the tile's chords on, the third order belongs to the rest, too (search_template.h).
 *
 * First cell.  Where the tile's rays are known to have no root up to a depth `from`, they may have one right
 * behind it, where the sign of a coefficient is undecided.  So the first cell begins a little before: 1 or 16
 * times as far as rays are apart leaves a tenth more pixels to leaves than 4 times.
 *
 * Empty: the cells from the first depth to the last have no variation of sign, so that no ray of the tile has
 * a root on its chord.
 *
 * Sheet: cells without a variation, then one with one variation: along each ray one root in it, none before.
 * The middle ray's root and its series in xi and eta, by implicit differentiation, tell where to look; what
 * they say is a guess.  Proved is a narrower cell [low,high]: the signs at its ends are sure and differ, and
 * all differences b_k - b_(k+1) have one sign, whatever the coefficients, with a size of m > 0 at least.
 * Hence P is monotone between, and |dP/dz| >= steep = n m / (high - low).  All chords reach beyond
 * [low,high], by the smaller extent.
 *
 * Near.  Newton's method ends at a depth z, with a value V that doubles find for P at the point of the line
 * of sight there.  P on the ray itself differs from V by V's rounding, and by what the view's noise makes of
 * P between ray and line, which is in `rounding`: by E in all.  So where |V| + E <= ALGSURF_I_NEAR steep, the
 * ray's root is within ALGSURF_I_NEAR of z.  E may be half of that, or it is no sheet; |V| the other half,
 * `enough`.  V's rounding is bounded for |x|, |y|, |z| <= 1; the terms of P are at most r^n times as large
 * where these are below r.
 *
 * Differences of the rest.  Over the tile's depths they are at most 2 max rest; n times that bounds the
 * derivative, and so in a part of a share s of these depths differences are at most 2 s max rest.  Rounding
 * has no derivative: it counts twice in full.
 *
 * All of space.  A sheet is the first one if no ray has a root between the eye and the depth -1, and an empty
 * tile is empty if none has one beyond 1 either: what is proved as for a pixel, from ranges of the
 * coefficients of all rays (search_template.h).  The range is not cut by planes here: what they do at the
 * depths beyond is not looked at. */
#ifndef ALGSURF_TILES_TEMPLATE_H
#define ALGSURF_TILES_TEMPLATE_H
#include "../roots/beyond_template.h"
#include "rows.h"
#include "sight_template.h"
#include "search_template.h"

#define ORDER ALGSURF_I_BEAM_ORDER
#define LEAST_WIDTH 0x1p-12 /* of a sheet's cell about its middle ray's root */
#define BEFORE 4            /* of what rays are apart: see First cell */
#define SLACK 0x1p-22       /* of the ends of chords, whose error is far below it */

/* LANES tiles of a size.  Places of depths are those in [-1,1] as parts of its length, multiples of 2^-40. */
typedef struct tile_packet {
    lanes t[TERMS][BEAM_DEGREE + 1]; /* Bernstein coefficients over [-1,1] */
    lanes lo, hi;                    /* places: all chords are between */
    lanes from;                      /* place: no root is before */
    lanes least, most;               /* places: each chord reaches from least to most; most < least: none */
    lanes rest, rounding;            /* bounds, of each coefficient, on the terms left out and the errors; */
    lanes unsure;                    /* of P at a ray's point, on what doubles find: see Near */
    lanes x, u;                      /* the first pixel, the middle ray */
    double y, v, hu, hv;             /* the same for all; half sizes */
    mask open;
} tile_packet;

/* ---- making tiles ---- */

/* The row's extent, larger by so much in each direction, and planes further away; returns whether something
 * is left of the extent. */
INLINE int widen_extent(algsurf_i_row_job *job, double by) {
    int directions = job->extent->kind == ALGSURF_EXTENT_SPHERE ? 1 : 3, some = 1;
    for (int i = 0; i < directions; i++) {
        job->extent_size[i] += by;
        some &= job->extent_size[i] > 0;
    }
    job->plane_room += by;
    return some;
}

/* Depths of the chords, but for what is far before `from`.  Closes tiles without any. */
INLINE void clip_tiles(const algsurf_i_tile_job *job, lanes from, tile_packet *g) {
    const algsurf_i_view *view = job->row->view;
    algsurf_i_row_job wide = *job->row, narrow = *job->row;
    double apart = sqrt(g->hu * g->hu + g->hv * g->hv) * (1 + fabs(view->alpha)) + 0x1p-30;
    const sight s = {.u = g->u,
                     .v = all_lanes(g->v),
                     .a = view->alpha * g->u + view->beta[0],
                     .b = all_lanes(view->alpha * g->v + view->beta[1])};
    (void)widen_extent(&wide, apart);
    if (wide.extent->kind == ALGSURF_EXTENT_ALL) wide.plane_count = 0;
    chord c = chord_of(&wide, &s);
    lanes slack = 4 * c.blur + SLACK;
    g->open &= less(c.near - slack, c.far + slack);
    lanes lo = larger(smaller(c.near, c.far) - slack, all_lanes(job->row->near - SLACK));
    lo = larger(lo, from - BEFORE * apart);
    lanes hi = larger(c.near, c.far) + slack;
    g->lo = larger(floor40(0.5 * lo + 0.5), all_lanes(0));
    g->from = 0.5 * from + 0.5;
    g->hi = smaller(-floor40(-0.5 * hi - 0.5), all_lanes(1));
    g->open &= less(g->lo, g->hi);
    g->least = all_lanes(2);
    g->most = all_lanes(-2);
    if (!widen_extent(&narrow, -apart)) return;
    c = chord_of(&narrow, &s);
    slack = 4 * c.blur + SLACK;
    mask sure = ~c.undecided & less(c.near, c.far);
    lanes near = larger(c.near + slack, all_lanes(job->row->near + SLACK));
    g->least = choose(sure, 0.5 * near + 0.5, g->least);
    g->most = choose(sure, 0.5 * (c.far - slack) + 0.5, g->most);
}

INLINE void expand_tiles_n(const algsurf_i_tile_job *job, tile_packet *g, int n) {
    const algsurf_i_beam_row *row = job->beam;
    const algsurf_i_view *view = job->row->view;
    lanes rest = all_lanes(0), reach = absolute(g->u) + fabs(g->hu);
    lanes x = reach + fabs(view->alpha) * reach + (fabs(view->beta[0]) + view->noise);
    lanes radius = all_lanes(0), further = radius;
    for (int k = 0; k <= n; k++) {
        lanes sum = all_lanes(0);
        for (int j = 0; j <= n; j++) {
            const double *c = row->c + (k * (n + 1) + j) * (n + 1);
            lanes p[BEAM_DEGREE + 1];
            double power = 1;
            for (int i = 0; i + j <= n; i++) p[i] = all_lanes(c[i]);
            shift_levels(p, n - j, g->u, (n <= ORDER ? n : ORDER + 1) - j);
            for (int i = 0; i + j <= n && i + j <= ORDER; i++) {
                lanes term = power * p[i];
                if (i + j <= 3)
                    g->t[term_at[i][j]][k] = term;
                else
                    sum += absolute(term);
                power *= g->hu;
            }
        }
        rest = larger(rest, sum);
        for (int i = 0; i <= 3; i++)
            for (int j = 0; i + j <= 3; j++)
                if (i + j > n) g->t[term_at[i][j]][k] = all_lanes(0);
    }
    for (int i = n; i >= 0; i--) radius = radius * x + row->radius[i];
    for (int i = n; i >= 0; i--) further = further * reach + row->beyond[i];
    g->rest = (rest + further) * (1 + 0x1p-20);
    g->rounding = radius * (1 + 0x1p-20);
    const double across = fabs(g->v) + fabs(g->hv);
    const double y = across + fabs(view->alpha) * across + fabs(view->beta[1]) + view->noise;
    const lanes most = larger(x, all_lanes(fmax(y, 1)));
    g->unsure = all_lanes(job->noise);
    for (int i = 0; i < n; i++) g->unsure *= most;
    g->unsure += g->rounding;
}

/* ---- deciding them ---- */

/* Over the chords of the tiles. */
INLINE void range_of(const tile_packet *g, beam *r, int n) {
    lanes from = choose(g->open, g->lo, all_lanes(0)), to = choose(g->open, g->hi, all_lanes(1));
    for (int k = 0; k <= n; k++) r->rest[k] = g->rest;
    for (int i = 0; i < TERMS; i++) {
        lanes part[BEAM_DEGREE + 1];
        cut_part(g->t[i], part, n, from, to);
        for (int k = 0; k <= n; k++) {
            if (i < LOW_TERMS)
                r->t[i][k] = part[k];
            else
                r->rest[k] += absolute(part[k]);
        }
    }
}

#define SERIES_ROUNDS 4

/* Of the first m+1 coefficients, m <= 3. */
INLINE lanes difference(const lanes *b, int m) {
    if (m == 3) return b[3] - b[0] - 3 * (b[2] - b[1]);
    return m == 2 ? b[2] - b[1] - (b[1] - b[0]) : b[1] - b[0];
}

/* A polynomial about a point: a[m] is its derivative m over m!, m <= order <= 3: of the coefficients that de
 * Casteljau's scheme leaves when it has come down to degree m, their difference m, C(n,m) times. */
INLINE void taylor_at(const lanes *w, int n, lanes x, int order, lanes a[4]) {
    lanes b[BEAM_DEGREE + 1], rest = 1 - x;
    double choices = 1; /* C(n,left) */
    for (int j = 0; j <= n; j++) b[j] = w[j];
    for (int m = 0; m < 4; m++) a[m] = all_lanes(0);
    UNROLLED
    for (int left = n; left > 0; left--) {
        if (left <= order) a[left] = choices * difference(b, left);
        choices *= left / (n - left + 1.0);
        UNROLLED
        for (int j = 0; j < left; j++) b[j] = rest * b[j] + x * b[j + 1];
    }
    a[0] = b[0];
}

/* The third order's terms at a place of all depths. */
INLINE void third_at(const tile_packet *g, lanes x, lanes c[TERMS - T30], int n) {
    lanes rest = 1 - x, power = all_lanes(1);
    double binomial = 1;
    for (int i = T30; i < TERMS; i++) c[i - T30] = g->t[i][0];
    for (int k = 1; k <= n; k++) {
        binomial = binomial * (n - k + 1) / k;
        power *= x;
        for (int i = T30; i < TERMS; i++) c[i - T30] = c[i - T30] * rest + g->t[i][k] * (binomial * power);
    }
}

/* The middle ray's root: Newton's method between p and q, where P has different signs. */
INLINE lanes middle_root(const beam *whole, lanes x, lanes p, lanes q, words side, int n) {
    for (int round = 0; round < SERIES_ROUNDS; round++) {
        jet f = jet_at(whole->t[T00], n, x);
        mask before = ~negative((words)f.f ^ side);
        p = choose(before, x, p);
        q = choose(before, q, x);
        lanes next = x - f.f / f.slope;
        x = choose(less(p, next) & less(next, q), next, 0.5 * (p + q));
    }
    return x;
}

/* Its series about x: what makes sum T_ij(z) xi^i eta^j vanish, order by order. */
INLINE void series_n(const tile_packet *g, const beam *whole, lanes x, lanes z[ALGSURF_I_SERIES], int n) {
    lanes f[4], fx[4], fy[4], fxx[4], fxy[4], fyy[4], c[TERMS - T30];
    taylor_at(whole->t[T00], n, x, 3, f);
    taylor_at(whole->t[T10], n, x, 2, fx);
    taylor_at(whole->t[T01], n, x, 2, fy);
    taylor_at(whole->t[T20], n, x, 1, fxx);
    taylor_at(whole->t[T11], n, x, 1, fxy);
    taylor_at(whole->t[T02], n, x, 1, fyy);
    third_at(g, g->lo + x * (g->hi - g->lo), c, n);
    lanes inverse = -1 / f[1], a = fx[0] * inverse, b = fy[0] * inverse;
    z[0] = x + f[0] * inverse;
    z[1] = a;
    z[2] = b;
    lanes aa = z[3] = (fxx[0] + fx[1] * a + f[2] * a * a) * inverse;
    lanes ab = z[4] = (fxy[0] + fx[1] * b + fy[1] * a + 2 * f[2] * a * b) * inverse;
    lanes bb = z[5] = (fyy[0] + fy[1] * b + f[2] * b * b) * inverse;
    lanes by_x = fx[1] + 2 * f[2] * a, by_y = fy[1] + 2 * f[2] * b; /* what a second order in z adds to */
    lanes u = fx[2] + f[3] * a, v = fy[2] + f[3] * b;
    z[6] = (c[0] + fxx[1] * a + u * a * a + by_x * aa) * inverse;
    z[7] = (c[1] + fxx[1] * b + fxy[1] * a + 2 * u * a * b + v * a * a + by_x * ab + by_y * aa) * inverse;
    z[8] = (c[2] + fyy[1] * a + fxy[1] * b + 2 * v * a * b + u * b * b + by_x * bb + by_y * ab) * inverse;
    z[9] = (c[3] + fyy[1] * b + v * b * b + by_y * bb) * inverse;
}

/* Do all chords hold that part of the range? */
INLINE mask in_chords(const tile_packet *g, lanes from, lanes to) {
    lanes length = g->hi - g->lo;
    return at_most(g->least, g->lo + from * length) & at_most(g->lo + to * length, g->most);
}

/* Is that a sheet?  Narrows [p,q] to its cell; steep: n m / (high - low). */
INLINE mask is_sheet_n(const tile_packet *g, const beam *whole, const lanes *z, lanes *p, lanes *q,
                       lanes *steep, int n) {
    beam part;
    cell c;
    lanes first = absolute(z[1]) + absolute(z[2]);
    lanes reach = 1.25 * first + 2 * (absolute(z[3]) + absolute(z[4]) + absolute(z[5])) + LEAST_WIDTH;
    lanes from = larger(floor40(z[0] - reach), *p), to = smaller(floor40(z[0] + reach), *q);
    lanes length = g->hi - g->lo;
    mask sound = less(from + 0x1p-20, to) & in_chords(g, from, to);
    *p = from = choose(sound, from, all_lanes(0));
    *q = to = choose(sound, to, all_lanes(1));
    for (int i = 0; i < LOW_TERMS; i++) cut_part(whole->t[i], part.t[i], n, from, to);
    cut_part(whole->rest, part.rest, n, from, to);
    cell_of(&part, g->rounding, &c, n);
    sound &= less(c.e[0], c.w[0]) & less(c.e[n], -c.w[n]);
    lanes m = all_lanes(HUGE_VAL), rest = whole->rest[0];
    for (int k = 1; k <= n; k++) rest = larger(rest, whole->rest[k]);
    rest = 2 * ((to - from) * rest + g->rounding);
    for (int k = 0; k < n; k++) {
        lanes spread = rest;
        for (int i = 1; i < LOW_TERMS; i++)
            spread += (i == T20 || i == T02 ? 0.5 : 1) * absolute(part.t[i][k] - part.t[i][k + 1]);
        m = smaller(m, c.w[k] - c.w[k + 1] - spread);
    }
    *steep = n * m / (2 * (to - from) * length) * (1 - 0x1p-20);
    return sound & less((2 / ALGSURF_I_NEAR) * g->unsure, *steep);
}

/* ---- recording them ---- */

/* A tile of the job's size: the places from x on. */
static void record(algsurf_i_tile_job *job, const algsurf_i_tile *tile, int x) {
    int first = x / ALGSURF_I_LEAF, size = job->size / ALGSURF_I_LEAF;
    int row = (job->y - job->from_y) / ALGSURF_I_LEAF, end = row + size;
    int end_x = first + size < job->stride ? first + size : job->stride;
    job->tiles[job->tile_count++] = *tile;
    for (; row < end; row++)
        for (int i = first; i < end_x; i++) job->cell[row * job->stride + i] = job->tile_count;
}

/* Of a place between lo and hi. */
INLINE double depth_at(const tile_packet *g, int l, double place) {
    return 2 * (g->lo[l] + place * (g->hi[l] - g->lo[l])) - 1;
}

INLINE algsurf_i_tile tile_of(const algsurf_i_tile_job *job, const tile_packet *g, int l, double from,
                              double to) {
    double half = 0.5 * job->size;
    return (algsurf_i_tile){.x = g->x[l] + half,
                            .y = job->y + half,
                            .inverse = 1 / half,
                            .low = depth_at(g, l, from),
                            .high = depth_at(g, l, to)};
}

/* All of space: the tiles none of whose rays has a root before the range, or outside of it.  Where no root is
 * before `from`, both have been found before. */
APART mask outside(const algsurf_i_row_job *job, const tile_packet *g, const beam *whole, mask *before,
                   int n) {
    cell c;
    const mask known = less(all_lanes(0), g->from);
    cell_of(whole, g->rounding, &c, n);
    const beyond is = look_beyond(c.w, c.e, n, 1, all_lanes(job->degree));
    *before = is.none_before | less(all_lanes(0), g->lo) | known;
    return (is.none_behind & *before) | known;
}

/* Tells of each tile what it is, and returns those that are not decided: no ray has a root before p. */
INLINE mask decide_n(algsurf_i_tile_job *job, tile_packet *g, lanes *p, int n) {
    beam whole;
    expand_tiles_n(job, g, n);
    range_of(g, &whole, n);
    verdict v;
    search(&whole, g->rounding, g->open, n, &v);
    *p = v.p;
    if (job->row->extent->kind == ALGSURF_EXTENT_ALL) {
        mask before, none = outside(job->row, g, &whole, &before, n);
        v.one &= before;
        v.empty &= none;
        *p = choose(none, v.p, all_lanes(-HUGE_VAL));
    }
    mask sheets = g->open & v.one;
    if (any(sheets)) {
        lanes z[ALGSURF_I_SERIES], from = v.p, to = v.q, steep;
        series_n(g, &whole, middle_root(&whole, v.guess, from, to, v.side, n), z, n);
        sheets &= is_sheet_n(g, &whole, z, &from, &to, &steep, n);
        unsigned which = bits(sheets);
        for (int l = 0; l < LANES; l++) {
            if (!(which >> l & 1)) continue;
            algsurf_i_tile tile = tile_of(job, g, l, from[l], to[l]);
            tile.depth[0] = depth_at(g, l, z[0][l]);
            for (int i = 1; i < ALGSURF_I_SERIES; i++) tile.depth[i] = 2 * (g->hi[l] - g->lo[l]) * z[i][l];
            tile.enough = 0.5 * ALGSURF_I_NEAR * steep[l];
            record(job, &tile, (int)g->x[l]);
        }
    }
    return g->open & ~v.empty & ~sheets;
}

APART mask decide(algsurf_i_tile_job *job, tile_packet *g, lanes *p, int n) {
    mask open = no_lane();
    FOR_DEGREE(n, open = decide_n(job, g, p, N))
    return open;
}

/* The tiles from `first` on.  Those that are not decided become the first of the list, but for leaves. */
INLINE int search_packet(algsurf_i_tile_job *job, int first, int open_count) {
    const algsurf_i_row_job *row = job->row;
    const int count = job->count - first;
    double half = 0.5 * job->size;
    tile_packet g = {
        .y = job->y, .v = job->beam->v, .hu = copysign(job->beam->hu, row->du), .hv = job->beam->h};
    lanes p;
    g.x = load_some_integers(job->at + first, count);
    g.u = row->u0 + row->du * ((g.x + (half + row->offset)) * row->pixel);
    g.open = less(numbered(), all_lanes(count));
    lanes from = load_some(job->from + first, count);
    clip_tiles(job, from, &g);
    if (!any(g.open)) return open_count;
    unsigned open = bits(decide(job, &g, &p, job->beam->degree));
    for (int l = 0; l < LANES; l++) {
        if (!(open >> l & 1)) continue;
        if (job->size == ALGSURF_I_LEAF) {
            algsurf_i_tile leaf = tile_of(job, &g, l, p[l], 1);
            leaf.low = fmax(leaf.low, from[l]);
            record(job, &leaf, (int)g.x[l]);
        } else {
            job->at[open_count] = (int)g.x[l];
            job->from[open_count++] = fmax(from[l], depth_at(&g, l, p[l]));
        }
    }
    return open_count;
}

static void search_tiles(algsurf_i_tile_job *job) {
    int open = 0;
    for (int first = 0; first < job->count; first += LANES) open = search_packet(job, first, open);
    job->count = open;
}

#endif
