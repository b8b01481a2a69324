/* thin.c - is what a pixel's ray misses thin?
 *
 * A pixel is looked at in a box of rays twice as wide and high, as far as the rays of its neighbours.  The
 * box is cut into columns and these in depth, until P is proved to have a sign in a cell (thin_box.h), or the
 * cell is as short as its column is wide.  Cells without a sign that touch hang together in groups; any
 * connected part of the surface in the box is in one of them.  A group is left alone
 * - if it is a sheet: P grows throughout in one direction along the view, or in two across it, 45 degrees
 *   apart.  In the first case each ray meets it once.  In the second, with a point where P > 0 all of the
 *   wedge between these directions has P > 0, at the same depth and as far as the group reaches, and the
 *   opposite wedge of a point where P < 0 has P < 0: the surface is an outline there, with angles of 45
 *   degrees at least on both sides, and nothing narrow;
 * - if it reaches what the pixel's ray hits;
 * - where it is the edge of what a neighbour sees.  The pixel's ray has P of one sign; columns where P
 *   surely has the other one, in the group's range of depths, are inside.  Inside columns that hang together
 *   with a corner of the box, where a diagonal neighbour's ray passes, account for cells of the group up to
 *   NEAR columns from them, at depths where they are inside.  (A straight outline that touches the pixel, but
 *   does not reach its middle, has a corner of the box inside.)
 * - where it hangs together with what a neighbour's ray hits: in the half of the pixel on that neighbour's
 *   side, and a column beyond.  An outline that does not reach the pixel's middle is in such halves, also
 *   where P is a square, so that nothing is inside, or where sheets meet in a cusp, too close for a column
 *   between them.  A line that goes on from there to the other side of the pixel is not.
 * What is left in the pixel itself, and cannot be proved empty in columns SHARPER times as narrow, is thin.
 *
 * Nothing is lost.  Where P is 0 and its gradient too, no cell has a sign and none grows; where moreover P
 * does not change its sign, nothing is inside.  So an isolated point, and each pixel that a double line
 * without sheets passes, is thin, unless it hangs together with what the ray sees, or is within half a
 * pixel's width of what a neighbour sees at that depth, or on the side of neighbours that see what it hangs
 * together with.  Nothing passes between pixels: boxes overlap, and are closed, and neighbours' rays are
 * solved for each pixel that asks.
 *
 * Where the work is bounded (MOST_CELLS, MOST_LOOKS), what is not looked at counts as without a sign. */
#include "../base/arithmetic.h"
#include "thin.h"

#include <math.h>
#include <stdint.h>

#include "thin_box.h"

#define FINEST 8  /* columns in each direction that a box is cut to at last; the pixel has the inner 4 */
#define NEAR 2    /* columns */
#define SHARPER 4 /* times */
#define ROUNDING 0x1p-30 /* of a place where a ray meets the surface, and more */
#define MOST_CELLS 12    /* of a column; outlines have 4 */
#define MOST_LOOKS 256   /* at parts of a column; outlines take 30 */

/* A part of a column: without a sign, or inside. */
typedef struct cell {
    int column, group; /* group: another cell of it, or this one, which stands for it; -1: inside */
    double from, to;   /* places: parts of the box's depths */
    unsigned growth;   /* of one that stands for a group: of all */
} cell;

typedef struct search {
    algsurf_i_solid box;
    unsigned inside; /* the sign of P that the pixel's ray does not have; 0: unknown */
    int across;      /* columns in each direction */
    double shortest; /* part of a column */
    double longest;  /* cell without a sign */
    int begin[FINEST * FINEST], end[FINEST * FINEST]; /* of a column's cells */
    int count;
    cell cells[FINEST * FINEST * MOST_CELLS];
} search;

/* ---- cells ---- */

static int is_sheet(unsigned growth) {
    unsigned across = growth & ALGSURF_I_ACROSS;
    unsigned turned = across << 2 | across >> (ALGSURF_I_DIRECTIONS - 2); /* by 45 degrees */
    return (growth & ALGSURF_I_ALONG) || (across & turned);
}

/* The next part of a column; what is like the last one becomes part of it. */
static void add_cell(search *s, int column, double from, double to, int is_inside, unsigned growth) {
    int room = s->count < s->begin[column] + MOST_CELLS;
    if (s->count > s->begin[column]) {
        cell *last = s->cells + s->count - 1;
        if (!room || (last->to == from && (last->group < 0) == is_inside)) {
            if (!is_inside || !room) last->group = s->count - 1;
            last->growth &= growth;
            last->to = to;
            return;
        }
    }
    s->cells[s->count] = (cell){column, is_inside ? -1 : s->count, from, to, growth};
    s->count++;
}

/* The parts of a dyadic walk through [0,1]. */
typedef struct walk {
    double from, length;
    int looks;
} walk;

static void go_on(walk *w) {
    w->from += w->length;
    while (w->from < 1 && fmod(w->from, 2 * w->length) == 0) w->length *= 2;
}

static void search_column(search *s, const algsurf_i_column *c, int column) {
    s->begin[column] = s->count;
    for (walk w = {0, 1, 0}; w.from < 1;) {
        algsurf_i_column part;
        double to = w.from + w.length;
        unsigned growth = 0, sign = algsurf_i_column_cut(&s->box, c, w.from, to, &part);
        int last = w.length <= s->shortest || ++w.looks >= MOST_LOOKS;
        if (!sign && (last || w.length <= s->longest)) {
            growth = algsurf_i_column_growth(&s->box, &part, w.length);
            if (!is_sheet(growth)) sign = algsurf_i_column_square_sign(&s->box, &part);
        }
        if (!sign && !last && !is_sheet(growth)) {
            w.length /= 2;
            continue;
        }
        if (!sign || sign == s->inside) add_cell(s, column, w.from, to, sign != 0, growth);
        go_on(&w);
    }
    s->end[column] = s->count;
}

static int is_in_pixel(const search *s, int column) {
    int n = s->across, i = column / n, j = column % n, first = n / 4, end = n - n / 4;
    return i >= first && i < end && j >= first && j < end;
}

/* Columns in the pixel or those beside it; returns whether one has a cell without a sign. */
static int search_columns(search *s, int in_pixel) {
    int n = s->across, found = 0;
    double half = 1.0 / n;
    for (int column = 0; column < n * n; column++) {
        algsurf_i_column c;
        if (is_in_pixel(s, column) != in_pixel) continue;
        algsurf_i_solid_column(&s->box, (2 * (column % n) + 1) * half - 1, (2 * (column / n) + 1) * half - 1,
                               half, &c);
        search_column(s, &c, column);
        for (int i = s->begin[column]; i < s->end[column]; i++) found |= s->cells[i].group >= 0;
    }
    return found;
}

/* ---- groups ---- */

static int group_of(const search *s, int i) {
    while (s->cells[i].group != i) i = s->cells[i].group;
    return i;
}

static void join_columns(search *s, int a, int b) {
    for (int i = s->begin[a]; i < s->end[a]; i++)
        for (int j = s->begin[b]; j < s->end[b]; j++) {
            const cell *p = s->cells + i, *q = s->cells + j;
            if (p->group < 0 || q->group < 0 || p->to < q->from || q->to < p->from) continue;
            int x = group_of(s, i), y = group_of(s, j);
            s->cells[x].growth &= s->cells[y].growth;
            s->cells[y].group = x;
        }
}

static void join_cells(search *s) {
    int n = s->across;
    for (int column = 0; column < n * n; column++) {
        if (column % n > 0) join_columns(s, column - 1, column);
        if (column >= n) join_columns(s, column - n, column);
    }
}

/* Is that a cell of a group that is not a sheet? */
static int is_open(const search *s, int i) {
    return s->cells[i].group >= 0 && !is_sheet(s->cells[group_of(s, i)].growth);
}

/* Finds the groups of an ever finer box, in the end those that are not sheets, from the place `from` to the
 * place `to`; returns 0 if none reaches into the pixel. */
static int find_groups(search *s, double side, double *from, double *to) {
    int found = 0;
    s->count = 0;
    s->shortest = 2 * side / (s->across * (s->box.to - s->box.from));
    s->longest = s->across == FINEST ? 0 : 1.0 / (s->across * s->across);
    if (!search_columns(s, 1)) return 0;
    (void)search_columns(s, 0);
    join_cells(s);
    *from = 1, *to = 0;
    for (int i = 0; i < s->count; i++) {
        if (!is_open(s, i)) continue;
        *from = fmin(*from, s->cells[i].from);
        *to = fmax(*to, s->cells[i].to);
        found |= is_in_pixel(s, s->cells[i].column);
    }
    return found;
}

/* ---- what neighbours see ---- */

/* Sets of the finest columns, a bit each. */
#define CORNERS 0x8100000000000081u
#define FIRST_COLUMNS 0x0101010101010101u
#define LAST_COLUMNS 0x8080808080808080u

static uint64_t widened(uint64_t columns) {
    columns |= (columns & ~LAST_COLUMNS) << 1 | (columns & ~FIRST_COLUMNS) >> 1;
    return columns | columns << FINEST | columns >> FINEST;
}

/* Of the inside columns those that hang together with a corner. */
static uint64_t seen_of(uint64_t inside) {
    uint64_t seen = inside & CORNERS, before = 0;
    while (seen != before) {
        before = seen;
        seen = widened(seen) & inside;
    }
    return seen;
}

/* Columns that are inside somewhere between two places. */
static uint64_t inside_between(const search *s, double from, double to) {
    uint64_t inside = 0;
    for (int i = 0; i < s->count; i++) {
        const cell *c = s->cells + i;
        if (c->group < 0 && c->from <= to && c->to >= from) inside |= (uint64_t)1 << c->column;
    }
    return inside;
}

/* The inside columns of a group that a neighbour sees. */
static uint64_t seen_beside(const search *s, int group) {
    double from = 1, to = 0;
    for (int i = 0; i < s->count; i++) {
        if (s->cells[i].group < 0 || group_of(s, i) != group) continue;
        from = fmin(from, s->cells[i].from);
        to = fmax(to, s->cells[i].to);
    }
    return seen_of(inside_between(s, from, to));
}

/* Is a cell without a sign at the edge of them? */
static int is_edge(const search *s, const cell *c, uint64_t seen) {
    uint64_t near = seen & inside_between(s, c->from, c->to);
    for (int i = 0; i < NEAR; i++) near = widened(near);
    return near >> c->column & 1;
}

static int reaches_end(const search *s, int group) {
    for (int i = 0; i < s->count; i++)
        if (s->cells[i].to == 1 && s->cells[i].group >= 0 && group_of(s, i) == group) return 1;
    return 0;
}

/* Does a neighbour's ray, i and j pixels away, pass through that column? */
static int passes(int column, int i, int j) {
    int x = 2 * (column % FINEST) + 1 - FINEST, y = 2 * (column / FINEST) + 1 - FINEST;
    int across = i == 0 ? x == 1 || x == -1 : i * x == FINEST - 1;
    return across && (j == 0 ? y == 1 || y == -1 : j * y == FINEST - 1);
}

/* The columns on a neighbour's side of the middle, and next to it. */
static uint64_t side_of(int i, int j) {
    uint64_t side = 0;
    for (int column = 0; column < FINEST * FINEST; column++) {
        int x = 2 * (column % FINEST) + 1 - FINEST, y = 2 * (column / FINEST) + 1 - FINEST;
        if (i * x + j * y >= -(i * i + j * j)) side |= (uint64_t)1 << column;
    }
    return side;
}

/* Does a neighbour's ray meet the group? */
static int meets(const search *s, int group, int i, int j, double depth) {
    double place = (depth - s->box.from) / (s->box.to - s->box.from);
    for (int k = 0; k < s->count; k++) {
        const cell *c = s->cells + k;
        if (c->group < 0 || !passes(c->column, i, j) || group_of(s, k) != group) continue;
        if (place >= c->from - ROUNDING && place <= c->to + ROUNDING) return 1;
    }
    return 0;
}

/* The columns on the sides of neighbours whose rays meet the group. */
static uint64_t met_beside(const search *s, int group, const double depth[ALGSURF_I_NEIGHBOURS]) {
    uint64_t met = 0;
    for (int j = -1; j <= 1; j++)
        for (int i = -1; i <= 1; i++) {
            double at = depth[3 * (j + 1) + i + 1];
            if ((i || j) && at < HUGE_VAL && meets(s, group, i, j, at)) met |= side_of(i, j);
        }
    return met;
}

/* ---- what is left ---- */

/* Is P surely not 0 in a cell, over that column of it? */
static int is_empty(const search *s, const algsurf_i_column *c, const cell *whole) {
    double length = whole->to - whole->from;
    for (walk w = {0, 1, 0}; w.from < 1;) {
        algsurf_i_column part;
        double from = whole->from + w.from * length, to = fmin(from + w.length * length, 1);
        if (algsurf_i_column_cut(&s->box, c, from, to, &part) || algsurf_i_column_square_sign(&s->box, &part))
            go_on(&w);
        else if (w.length * length * SHARPER > s->shortest && ++w.looks < MOST_LOOKS)
            w.length /= 2;
        else
            return 0;
    }
    return 1;
}

/* Over all narrower columns of it? */
static int is_empty_sharper(const search *s, const cell *whole) {
    double half = 1.0 / (FINEST * SHARPER);
    int row = whole->column / FINEST * SHARPER, column = whole->column % FINEST * SHARPER;
    for (int i = 0; i < SHARPER; i++)
        for (int j = 0; j < SHARPER; j++) {
            algsurf_i_column c;
            algsurf_i_solid_column(&s->box, (2 * (column + j) + 1) * half - 1, (2 * (row + i) + 1) * half - 1,
                                   half, &c);
            if (!is_empty(s, &c, whole)) return 0;
        }
    return 1;
}

/* The first place of a group in the pixel, but for columns that are met, that is thin; 2: there is none. */
static double first_place(const search *s, int group, uint64_t met) {
    uint64_t seen = seen_beside(s, group);
    double first = 2;
    for (int i = 0; i < s->count; i++) {
        const cell *c = s->cells + i;
        double place = 0.5 * (c->from + c->to);
        if (c->group < 0 || group_of(s, i) != group || !is_in_pixel(s, c->column) || place >= first) continue;
        if (!(met >> c->column & 1) && !is_edge(s, c, seen) && !is_empty_sharper(s, c)) first = place;
    }
    return first;
}

/* The sign that P does not have on the middle ray's chord, before a hit; 0: unknown. */
static unsigned other_sign(const algsurf_i_thin_box *box, const algsurf_i_solid *s) {
    if (box->within > box->to) return 0;
    double value = algsurf_i_solid_middle(s, 0.5 * (box->within + 1));
    if (fabs(value) <= s->rounding) return 0;
    return value > 0 ? ALGSURF_I_NEGATIVE : ALGSURF_I_POSITIVE;
}

size_t algsurf_i_thin_memory(void) { return sizeof(search); }

int algsurf_i_is_thin(const algsurf_i_thin_box *box, void *memory, double *depth) {
    search *s = memory;
    double from = 0.5 * (box->from + 1), to = 0.5 * (box->to + 1), first = 2;
    double beside[ALGSURF_I_NEIGHBOURS];
    int ends_at_hit = box->ends_at_hit, looked = 0;
    algsurf_i_solid_expand(box, &s->box);
    s->inside = other_sign(box, &s->box);
    for (s->across = 1;; s->across *= 2) {
        algsurf_i_solid_narrow(&s->box, from, to);
        if (!find_groups(s, fabs(box->h), &from, &to)) return 0;
        if (s->across == FINEST) break;
        ends_at_hit &= to == 1;
    }
    for (int i = 0; i < s->count; i++) {
        if (s->cells[i].group != i || !is_open(s, i) || (ends_at_hit && reaches_end(s, i))) continue;
        double place = first_place(s, i, 0);
        if (place > 1) continue;
        if (!looked) box->look_beside(box->looker, beside);
        looked = 1;
        if (first_place(s, i, met_beside(s, i, beside)) <= 1) first = fmin(first, place);
    }
    *depth = s->box.from + first * (s->box.to - s->box.from);
    return first <= 1;
}
