/* render_sweep_view.c - see render_sweep_view.h.
 *
 * The extent is a ball about the extents that fit the single surfaces.  The camera is fitted to all of them
 * at once: a point lies on one of several surfaces where the product of their polynomials is 0.  Each
 * polynomial is divided by its largest coefficient first, so that products stay in range.  A polynomial that
 * is there already, or is the same but for a factor, is left out: its square would be singular everywhere.
 */
#include "render_sweep_view.h"

#include <math.h>
#include <stdlib.h>

#include "fit.h"

static void must(algsurf_status status) {
    if (status == ALGSURF_E_NO_MEMORY) cli_no_memory();
    if (status != ALGSURF_OK) cli_fail(CLI_BROKEN, "fitting the view: %s", algsurf_status_text(status));
}

/* ---- one extent ---- */

/* To three digits, as it is told and read again. */
static double to_three_digits(double x) {
    char text[32];
    snprintf(text, sizeof text, "%.3g", x);
    return strtod(text, NULL);
}

/* A ball about two balls, to three digits; one of them if it holds the other. */
static algsurf_extent ball_about(const algsurf_extent *a, const algsurf_extent *b) {
    double way[3], moved = 0;
    for (int i = 0; i < 3; i++) way[i] = b->centre[i] - a->centre[i];
    double apart = hypot(hypot(way[0], way[1]), way[2]), radius = (apart + a->size[0] + b->size[0]) / 2;
    if (apart + b->size[0] <= a->size[0]) return *a;
    if (apart + a->size[0] <= b->size[0]) return *b;
    algsurf_extent ball = {.kind = ALGSURF_EXTENT_SPHERE};
    for (int i = 0; i < 3; i++) {
        double exact = a->centre[i] + (radius - a->size[0]) / apart * way[i];
        ball.centre[i] = to_three_digits(fabs(exact) < 1e-3 * radius ? 0 : exact);
        moved += fabs(ball.centre[i] - exact);
    }
    ball.size[0] = to_three_digits(1.01 * (radius + moved));
    return ball;
}

/* Of what fits each surface; told as the options that repeat it. */
static void choose_extent(view_options *options, algsurf_surface *const *surface, int count) {
    algsurf_extent all;
    for (int i = 0; i < count; i++) {
        view one;
        fit_choice choice;
        must(fit_choose(&one, options, surface[i], 1, 0, &choice));
        all = i == 0 ? one.extent : ball_about(&all, &one.extent);
    }
    const double *c = all.centre;
    if (c[0] != 0 || c[1] != 0 || c[2] != 0)
        cli_complain("chosen: --extent sphere:%.15g --centre %.15g,%.15g,%.15g", all.size[0], c[0], c[1],
                     c[2]);
    else
        cli_complain("chosen: --extent sphere:%.15g", all.size[0]);
    options->extent = (cli_extent){all, 1};
    options->centre = (cli_vector){{c[0], c[1], c[2]}, 1};
}

/* ---- one surface ---- */

enum { HIGHEST = 24 }; /* degree of a product: above, choosing a view takes longer than drawing */

typedef struct polynomial {
    algsurf_term *terms;
    size_t count;
} polynomial;

/* The terms of a surface, the largest 1 or -1; null terms when there is no memory. */
static polynomial polynomial_of(const algsurf_surface *surface) {
    size_t count = algsurf_surface_term_count(surface);
    polynomial p = {calloc(count + 1, sizeof *p.terms), count};
    double largest = 0;
    if (!p.terms) return p;
    (void)algsurf_surface_terms(surface, p.terms);
    for (size_t i = 0; i < count; i++)
        if (fabs(p.terms[i].a) > fabs(largest)) largest = p.terms[i].a;
    for (size_t i = 0; i < count; i++) p.terms[i].a /= largest;
    return p;
}

/* Terms are sorted, algsurf_surface_terms, and roundings may differ. */
static int is_same(const polynomial *p, const polynomial *q) {
    if (p->count != q->count) return 0;
    for (size_t i = 0; i < p->count; i++) {
        const algsurf_term *s = &p->terms[i], *t = &q->terms[i];
        if (s->i != t->i || s->j != t->j || s->k != t->k || fabs(s->a - t->a) > 1e-12) return 0;
    }
    return 1;
}

static algsurf_status multiply(const polynomial *p, const polynomial *q, algsurf_surface **product) {
    algsurf_term *terms = calloc(p->count * q->count + 1, sizeof *terms), *to = terms;
    if (!terms) return ALGSURF_E_NO_MEMORY;
    for (size_t i = 0; i < p->count; i++)
        for (size_t j = 0; j < q->count; j++) {
            const algsurf_term *s = &p->terms[i], *t = &q->terms[j];
            *to++ = (algsurf_term){s->i + t->i, s->j + t->j, s->k + t->k, s->a * t->a};
        }
    algsurf_status status = algsurf_surface_from_terms(terms, p->count * q->count, product);
    free(terms);
    return status;
}

/* Multiplies *all by the surface of number n, unless it is one of those before. */
static algsurf_status add(algsurf_surface *const *surface, int n, algsurf_surface **all) {
    polynomial p = polynomial_of(surface[n]), q = polynomial_of(*all);
    algsurf_surface *product = NULL;
    algsurf_status status = p.terms && q.terms ? ALGSURF_OK : ALGSURF_E_NO_MEMORY;
    int there = 0;
    for (int i = 0; i < n && status == ALGSURF_OK && !there; i++) {
        polynomial before = polynomial_of(surface[i]);
        if (!before.terms) status = ALGSURF_E_NO_MEMORY;
        if (before.terms) there = is_same(&p, &before);
        free(before.terms);
    }
    if (status == ALGSURF_OK && !there) status = multiply(&p, &q, &product);
    free(p.terms);
    free(q.terms);
    if (!product) return status;
    algsurf_surface_free(*all);
    *all = product;
    return status;
}

/* All surfaces as one, of those for which the degree does not become too high; to be freed. */
static algsurf_status unite(algsurf_surface *const *surface, int count, algsurf_surface **all) {
    algsurf_status status = algsurf_surface_with_error(surface[0], 0, all);
    for (int n = 1; n < count && status == ALGSURF_OK; n++)
        if (algsurf_surface_degree(*all) + algsurf_surface_degree(surface[n]) <= HIGHEST)
            status = add(surface, n, all);
    return status;
}

void render_sweep_view(view *v, const view_options *asked, algsurf_surface *const *surface, int count,
                       int extent_only) {
    view_options options = *asked;
    algsurf_surface *all = NULL;
    if (!asked->extent.given && !asked->centre.given) choose_extent(&options, surface, count);
    must(unite(surface, count, &all));
    fit_view(v, &options, all, extent_only, 0);
    algsurf_surface_free(all);
}
