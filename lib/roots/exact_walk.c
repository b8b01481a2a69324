/* exact_walk.c - the exact walk: cells from left to right, roots as they come.
 *
 * A piece is half open: a root at its left end is its own, one at its right end belongs to the next piece.
 * The same holds for the cells of a piece: b_0 = 0 shows a root at the left end, as many times as there are
 * leading zeros, and it is reported before the open cell is looked at, where zeros do not count.
 * At most n cells wait, since variations of disjoint cells add up to at most n. */
#include "../base/arithmetic.h"
#include "exact_walk.h"

/* Halvings before it is tried: a gcd costs about as much as one of them, a step to a cluster as three.  Discs
 * about all roots cost as many as it takes to get so far, from degree 32 on, since numbers grow by a bit a
 * degree with each.  Where numbers are long from the start, a piece costs as much as discs that doubles
 * nearly have: these are tried before the second one. */
enum { ASK_AFTER = 5, ZOOM_AFTER = 2, LIST_AFTER = 24, LIST_DEGREE = 32 };
enum { LONG_WIDTH = 16, LONG_DEGREE = 128, FEW_SWEEPS = 8 };

int algsurf_exact_begin(algsurf_exact_walk *walk, algsurf_memory *m, const algsurf_zpoly *p, int unit,
                        double lo, double hi, int refine, const algsurf_i_watch *watch) {
    *walk = (algsurf_exact_walk){.memory = m, .p = *p, .unit = unit, .lo = lo, .hi = hi, .refine = refine};
    walk->begin = algsurf_memory_here(m);
    walk->cells = (algsurf_exact_cells){.memory = m, .watch = watch, .unit = unit};
    walk->cells.waiting = algsurf_i_take(m, (size_t)(p->degree + 1) * sizeof *walk->cells.waiting);
    int done = walk->cells.waiting && algsurf_exact_pieces_begin(&walk->pieces, m, p, unit, lo, hi);
    walk->bottom = walk->top = algsurf_memory_here(m);
    return done;
}

void algsurf_exact_end(algsurf_exact_walk *walk) { algsurf_memory_release(walk->memory, walk->begin); }

/* What the walk isolates the roots of: p, or the part that has them once. */
static const algsurf_zpoly *walked(const algsurf_exact_walk *walk) {
    return walk->parts ? walk->s : &walk->p;
}

/* Is p squarefree?  If not, the walk begins again with what is.  -1: no memory; 1: it begins again. */
static int ask_for_squares(algsurf_exact_walk *walk) {
    algsurf_memory *m = walk->memory;
    int degree, parts = 0;
    walk->asked = 1;
    if (!algsurf_zpoly_gcd_degree(m, &walk->p, NULL, 2, &degree)) return -1;
    if (degree == 0) return 0;
    algsurf_memory_release(m, walk->bottom);
    walk->s = algsurf_i_take(m, (size_t)(walk->p.degree + 1) * sizeof *walk->s);
    if (!walk->s || !algsurf_zpoly_multiplicities(m, &walk->p, walk->s, &parts)) return -1;
    walk->parts = parts;
    walk->bottom = walk->top = algsurf_memory_here(m);
    walk->cells.active = walk->cells.count = 0;
    walk->skip = walk->given;
    algsurf_exact_pieces_again(&walk->pieces);
    return 1;
}

/* ---- all roots at once ---- */

/* All roots as a list, if discs have them after `sweeps` of these, and next the one that the walk has come
 * to: -1: no memory; 1: the list goes on.  Those that are left of lo, or have been given, are passed over
 * here as far as their places show it. */
static int list_roots(algsurf_exact_walk *walk, int sweeps) {
    const algsurf_zpoly *f = walked(walk);
    algsurf_memory_mark mark = algsurf_memory_here(walk->memory);
    algsurf_i_root_on_axis *all = algsurf_i_take(walk->memory, (size_t)f->degree * sizeof *all);
    if (!all || !algsurf_i_roots_on_axis(walk->memory, f, sweeps, all, &walk->list_length)) return -1;
    if (walk->list_length < 0) {
        algsurf_memory_release(walk->memory, mark);
        return 0;
    }
    walk->listed = all;
    walk->skip = walk->given;
    for (; walk->next < walk->list_length; walk->next++) {
        const algsurf_i_root_on_axis *at = walk->listed + walk->next;
        int inside = algsurf_z_round_down(at->a, at->width, walk->unit - at->r) >= walk->lo;
        int left = algsurf_z_round_up(at->b ? at->b : at->a, at->width, walk->unit - at->r) < walk->lo;
        if (!left && (!inside || walk->skip == 0)) break;
        walk->skip -= inside;
    }
    walk->top = algsurf_memory_here(walk->memory);
    return 1;
}

/* The next one of the list: 1, 0; -1 without memory.  Its roots are simple: signs alternate, from that at
 * -infinity. */
static int next_listed(algsurf_exact_walk *walk, algsurf_exact_root *root) {
    if (walk->next == walk->list_length) return 0;
    const algsurf_zpoly *f = walked(walk);
    const algsurf_i_root_on_axis *at = walk->listed + walk->next;
    int negative = algsurf_z_negative(algsurf_zpoly_at(f, f->degree), f->width);
    walk->before = (f->degree + walk->next++ + negative) % 2 ? -1 : 1;
    root->place = (algsurf_exact_place){f, at->a, at->b, at->width, at->r};
    return algsurf_exact_refine_place(walk, root) ? 1 : -1;
}

/* ---- what is known of a root ---- */

/* The multiplicity of the only root of s[0] at a place: above i if s[i] has it. */
static int find_multiplicity(algsurf_exact_walk *walk, const algsurf_exact_place *place, int *multiplicity) {
    *multiplicity = 1;
    for (int i = 1; i < walk->parts; i++) {
        int at_a, at_b;
        if (!algsurf_exact_signs(walk->memory, walk->s + i, place, &at_a, &at_b)) return 0;
        if (place->b ? at_a == at_b : at_a != 0) break;
        *multiplicity = i + 1;
    }
    return 1;
}

/* The sign of p just before a root of multiplicity m at a point: that of its m-th derivative there, times
 * (-1)^m. */
static int find_sign_before(algsurf_exact_walk *walk, const algsurf_exact_place *place, int multiplicity,
                            int *sign) {
    algsurf_zpoly d = walk->p;
    if (place->b) return algsurf_exact_signs(walk->memory, &walk->p, place, sign, NULL);
    for (int i = 0; i < multiplicity; i++)
        if (!algsurf_zpoly_derivative(walk->memory, &d, &d)) return 0;
    if (!algsurf_exact_signs(walk->memory, &d, place, sign, NULL)) return 0;
    if (multiplicity % 2) *sign = -*sign;
    return 1;
}

/* Multiplicity and sign of a root whose place is known; 0: no memory. */
static int complete(algsurf_exact_walk *walk, algsurf_exact_root *root) {
    return (root->multiplicity > 0 || find_multiplicity(walk, &root->place, &root->multiplicity)) &&
           (root->sign_before != 0 ||
            find_sign_before(walk, &root->place, root->multiplicity, &root->sign_before));
}

/* The root at the end a of a place. */
static void set_point(const algsurf_exact_walk *walk, const algsurf_exact_place *place,
                      algsurf_exact_root *root) {
    root->place = (algsurf_exact_place){walked(walk), place->a, NULL, place->width, place->r};
    algsurf_exact_set_hull(walk, root);
}

/* The root at the cell's left end. */
static int root_at_left(algsurf_exact_walk *walk, algsurf_exact_root *root) {
    algsurf_exact_cell *cell = &walk->cells.cell;
    algsurf_exact_place whole;
    int zeros = 0;
    cell->left_done = 1;
    while (algsurf_exact_sign(cell, zeros) == 0) zeros++;
    if (!algsurf_exact_cell_place(walk->memory, &walk->cells, cell, &whole)) return 0;
    set_point(walk, &whole, root);
    if (walk->parts) return 1;
    int after = algsurf_exact_sign(cell, zeros);
    root->multiplicity = zeros;
    root->sign_before = zeros % 2 ? -after : after;
    return 1;
}

/* Works on the cell until a root shows or the cells are used up: 1, 0; -1 without memory. */
static int search_cells(algsurf_exact_walk *walk, algsurf_exact_root *root) {
    int same = 0, before = 0; /* how often a cell kept its variations */
    while (walk->cells.active) {
        algsurf_exact_cell *cell = &walk->cells.cell;
        walk->top = algsurf_memory_here(walk->memory);
        if (algsurf_exact_begins_with_root(cell)) return root_at_left(walk, root) ? 1 : -1;
        int v = cell->variations;
        if (v == 0) {
            algsurf_exact_cells_next(&walk->cells);
            continue;
        }
        if (v == 1) {
            cell->variations = 0; /* when the walk comes back */
            return algsurf_exact_refine_cell(walk, walked(walk), root) ? 1 : -1;
        }
        if (!walk->asked && cell->depth >= ASK_AFTER) {
            int answer = ask_for_squares(walk);
            if (answer) return answer < 0 ? -1 : 0;
        }
        if (!walk->gave_up && cell->b.degree >= LIST_DEGREE && cell->depth >= LIST_AFTER) {
            int answer = list_roots(walk, ALGSURF_I_MOST_SWEEPS);
            walk->gave_up = !answer;
            if (answer) return answer < 0 ? -1 : next_listed(walk, root);
        }
        same = v == before ? same + 1 : 0;
        before = v;
        if (same >= ZOOM_AFTER && algsurf_exact_sign(cell, 0) && algsurf_exact_sign(cell, cell->b.degree)) {
            int done;
            if (!algsurf_exact_zoom(walk->memory, cell, v, &done)) return -1;
            same = done ? ZOOM_AFTER - 1 : 0;
            if (done && walk->cells.watch && !algsurf_exact_tell_cell(&walk->cells, cell)) return -1;
            if (done) continue;
        }
        if (!algsurf_exact_cells_halve(&walk->cells)) return -1;
    }
    return 0;
}

/* The root at u = 0 between the pieces of both sides. */
static int root_at_zero(algsurf_exact_walk *walk, algsurf_exact_root *root) {
    algsurf_limb *N = algsurf_memory_take(walk->memory, 1);
    if (!N) return 0;
    *N = 0;
    set_point(walk, &(algsurf_exact_place){.a = N, .width = 1}, root);
    while (algsurf_z_sign(algsurf_zpoly_at(&walk->p, root->multiplicity), walk->p.width) == 0)
        root->multiplicity++;
    return 1;
}

/* The next root of what is walked, wherever it is: 1, 0, -1. */
static int search(algsurf_exact_walk *walk, algsurf_exact_root *root) {
    for (;;) {
        *root = (algsurf_exact_root){.multiplicity = 0};
        if (walk->listed) return next_listed(walk, root);
        if (walk->cells.active) {
            int found = search_cells(walk, root);
            if (found) return found;
            continue;
        }
        algsurf_memory_release(walk->memory, walk->bottom);
        walk->top = walk->bottom;
        algsurf_exact_piece piece;
        int next = algsurf_exact_pieces_next(&walk->pieces, &piece);
        if (next == ALGSURF_EXACT_ZERO) return root_at_zero(walk, root) ? 1 : -1;
        if (next == ALGSURF_EXACT_NO_PIECE) return 0;
        if (++walk->opened == 2 && walk->p.degree >= LONG_DEGREE && walk->p.width >= LONG_WIDTH) {
            int answer = walk->asked ? 0 : ask_for_squares(walk);
            if (answer == 0) answer = list_roots(walk, FEW_SWEEPS);
            if (answer < 0) return -1;
            if (answer) {
                walk->opened = 1; /* it begins again, or there is a list */
                continue;
            }
        }
        if (!algsurf_exact_cells_open(&walk->cells, walked(walk), &piece)) return -1;
    }
}

/* Is the root in [lo,hi]: 1, 0, or -1 when it is beyond? */
static int is_wanted(const algsurf_exact_walk *walk, const algsurf_exact_root *root) {
    if (root->lo == root->hi) return root->t < walk->lo ? 0 : root->t > walk->hi ? -1 : 1;
    return root->hi <= walk->lo ? 0 : root->lo >= walk->hi ? -1 : 1;
}

/* A root that is not refined and whose place reaches beyond an end of [lo,hi]: it is, for once. */
static int see_which_side(algsurf_exact_walk *walk, algsurf_exact_root *root) {
    int inside = root->lo >= walk->lo && root->hi <= walk->hi;
    return walk->refine == ALGSURF_EXACT_REFINED || !root->place.b || inside ||
           algsurf_exact_to_doubles(walk, root);
}

int algsurf_exact_next(algsurf_exact_walk *walk, algsurf_exact_root *root) {
    for (;;) {
        algsurf_memory_release(walk->memory, walk->top);
        int found = search(walk, root);
        if (found <= 0) return found;
        if (!see_which_side(walk, root)) return ALGSURF_EXACT_NO_MEMORY;
        int wanted = is_wanted(walk, root);
        if (wanted < 0) return ALGSURF_EXACT_END;
        if (wanted == 0) continue;
        if (walk->skip > 0) {
            walk->skip--;
            continue;
        }
        walk->given++;
        return complete(walk, root) ? ALGSURF_EXACT_ROOT : ALGSURF_EXACT_NO_MEMORY;
    }
}
