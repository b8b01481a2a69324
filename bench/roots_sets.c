/* roots_sets.c - see roots.h: the polynomials, and the contest of those who solve them. */
#include <math.h>
#include <stdlib.h>

#include "cli.h"
#include "measure.h"
#include "must.h"
#include "rays.h"
#include "roots.h"

void roots_set_open(roots_set *set, const char *name, int degree, int complex, size_t count) {
    size_t all = count * ((size_t)degree + 1);
    *set = (roots_set){.name = name, .degree = degree, .count = count};
    set->c = must_allocate(all, sizeof *set->c);
    set->im = complex ? must_allocate(all, sizeof *set->im) : NULL;
}

double *roots_set_at(const roots_set *set, double *c, size_t i) {
    return c ? c + i * ((size_t)set->degree + 1) : NULL;
}

algsurf_table roots_set_rows(const roots_set *set, double *c, size_t begin) {
    return (algsurf_table){roots_set_at(set, c, begin), 1, set->degree + 1};
}

void roots_set_of_rays(roots_set *set, const char *surface, size_t count) {
    const catalogue_entry *entry = catalogue_find(surface);
    roots_set_open(set, surface, entry->degree, 0, count);
    rays_polynomials(entry, 1, count, set->c);
}

void roots_set_at_random(roots_set *set, const char *name, int degree, int complex, size_t count) {
    measure_random random = {(uint64_t)degree};
    roots_set_open(set, name, degree, complex, count);
    for (size_t i = 0; i < count * ((size_t)degree + 1); i++) {
        set->c[i] = measure_uniform(&random, -1, 1);
        if (complex) set->im[i] = measure_uniform(&random, -1, 1);
    }
}

/* Multiplies p, of the degree, by q_0 + q_1 t + t^2. */
static void times_quadratic(double *p, int degree, double q0, double q1) {
    for (int k = degree + 2; k >= 0; k--) {
        double below = k >= 2 ? p[k - 2] : 0, next = k >= 1 && k <= degree + 1 ? p[k - 1] : 0;
        p[k] = below + q1 * next + q0 * (k <= degree ? p[k] : 0);
    }
}

void roots_set_grazing(roots_set *set, const char *name, int degree, size_t count) {
    measure_random random = {(uint64_t)(100 + degree)};
    roots_set_open(set, name, degree, 0, count);
    for (size_t i = 0; i < count; i++) {
        double *p = roots_set_at(set, set->c, i), a = measure_uniform(&random, -0.9, 0.9);
        double e = pow(10, measure_uniform(&random, -7, -2));
        p[0] = 1;
        times_quadratic(p, 0, a * a + (measure_bits(&random) & 1 ? -e * e : e * e), -2 * a);
        for (int d = 2; d < degree; d += 2) {
            double x = measure_uniform(&random, -1.5, 1.5), y = measure_uniform(&random, 0.3, 1.5);
            times_quadratic(p, d, x * x + y * y, -2 * x);
        }
    }
}

void roots_set_free(roots_set *set) {
    free(set->c);
    free(set->im);
    free(set->degrees);
    free(set->real);
}

/* ---- the contest ---- */

static void solve(void *self, size_t begin, size_t end) {
    const roots_solver *s = self;
    const size_t step = s->packet ? s->packet : end - begin;
    for (size_t i = begin; i < end; i += step) s->solve(s, i, end - i < step ? end : i + step);
}

/* With room for its answers. */
static roots_solver enter(const roots_solver *entered, const roots_set *on) {
    const size_t all = on->count * (size_t)on->degree;
    roots_solver s = *entered;
    s.on = on;
    s.count = must_allocate(on->count, sizeof *s.count);
    s.real = must_allocate(all, sizeof *s.real);
    s.root = must_allocate(all, sizeof *s.root);
    s.box = must_allocate(all, sizeof *s.box);
    return s;
}

static void leave(roots_solver *s) {
    free(s->count);
    free(s->real);
    free(s->root);
    free(s->box);
}

void roots_contend(const roots_contest *contest, const roots_set *on, const roots_effort *effort,
                   contest_table *table) {
    roots_solver *own = must_allocate(contest->count, sizeof *own);
    contestant *contestants = must_allocate(contest->count, sizeof *contestants);
    size_t count = 0;
    for (const roots_solver *s = contest->solvers; s < contest->solvers + contest->count; s++) {
        if ((s->real_only && on->im) || (s->most_degree && on->degree > s->most_degree)) continue;
        own[count] = enter(s, on);
        contestants[count] = (contestant){.row = {.section = contest->section,
                                                  .task = on->name,
                                                  .degree = on->degree,
                                                  .program = s->program,
                                                  .unit = contest->unit},
                                          .solve = solve,
                                          .self = &own[count]};
        count++;
    }
    contest_warm_up(contestants, 1, on->count, INFINITY); /* all of them, to judge by */
    contest_warm_up(contestants + 1, count - 1, on->count, contest->whole ? INFINITY : effort->budget);
    for (size_t k = 0; k < count; k++) {
        contest->judge(&own[k], own, &contestants[k].row);
        roots_check(own[k].program, own[k].proves, &contestants[k].row);
    }
    contest_run(contestants, count, effort->takes, table);
    for (size_t k = 0; k < count; k++) leave(&own[k]);
    free(own);
    free(contestants);
}

void roots_check(const char *program, int proves, const contest_row *row) {
    if (proves && row->missed + row->extra > 0)
        cli_fail(CLI_BROKEN, "%s, %s: %s contradicts what is proved", row->section, row->task, program);
}
