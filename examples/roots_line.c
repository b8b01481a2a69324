/* roots_line.c - see roots_line.h.
 *
 * A line's numbers are exact.  Times one power of ten, and one of two, they are integers; where these fit
 * doubles, doubles it is.  Where not, real roots are those of the integers, and complex ones those of all
 * polynomials as near to the doubles as the integers are.
 *
 * From doubles, the real roots are isolated and refined, with proof. */
#include "roots_line.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

/* ---- a line becomes a polynomial ---- */

enum { MOST_BITS = 1 << 15 }; /* of an integer: 9800 decimals from the first digit of a line to its last */

static int expected_numbers(size_t line, int k, const char *got) {
    cli_complain("line %zu: coefficient %d: expected finite numbers, re or re,im, got '%s'", line, k,
                 cli_quote(got).text);
    return 0;
}

static int parse_rounded(size_t line, char *const *field, roots_polynomial *p) {
    for (int k = 0; k <= p->degree; k++) {
        double parts[2] = {0, 0};
        if (!cli_numbers(field[k], ',', 1, parts) && !cli_numbers(field[k], ',', 2, parts))
            return expected_numbers(line, k, field[k]);
        p->c[k] = (algsurf_complex){parts[0], parts[1]};
        if (parts[1] != 0) p->real = 0;
    }
    while (p->degree > 0 && p->c[p->degree].re == 0 && p->c[p->degree].im == 0) p->degree--;
    return 1;
}

static int read_parts(size_t line, char *const *field, roots_polynomial *p) {
    for (int k = 0; k <= p->degree; k++) {
        roots_decimal *re = p->part + 2 * k, *im = re + 1;
        const char *end = roots_decimal_read(field[k], re);
        im->count = 0;
        if (end && *end == ',') end = roots_decimal_read(end + 1, im);
        if (!end || *end) return expected_numbers(line, k, field[k]);
        if (im->count) p->real = 0;
    }
    while (p->degree > 0 && !p->part[2 * p->degree].count && !p->part[2 * p->degree + 1].count) p->degree--;
    return 1;
}

static int room_for(roots_polynomial *p, size_t limbs) {
    if (limbs <= p->capacity) return 1;
    free(p->limbs);
    p->capacity = 0;
    p->limbs = malloc(limbs * sizeof *p->limbs);
    if (!p->limbs) return 0;
    p->capacity = limbs;
    return 1;
}

/* The parts times the least powers of five and of two that make integers of them; lengths have signs. */
static int to_integers(size_t line, roots_polynomial *p, algsurf_integer *z) {
    int parts = 2 * (p->degree + 1);
    long long fives = LLONG_MAX, twos = LLONG_MAX, bits = 0;
    for (int i = 0; i < parts; i++) {
        const roots_decimal *d = p->part + i;
        if (d->count && d->fives < fives) fives = d->fives;
        if (d->count && d->twos < twos) twos = d->twos;
    }
    for (int i = 0; i < parts; i++) {
        long long more = roots_decimal_bits(p->part + i, fives, twos);
        if (more > bits) bits = more;
    }
    if (bits > MOST_BITS) {
        cli_complain("line %zu: about %lld decimals from the first digit to the last, the limit is %d", line,
                     3 * bits / 10, 3 * MOST_BITS / 10);
        return 0;
    }
    size_t width = (size_t)bits / 64 + 2;
    if (!room_for(p, width * (size_t)parts)) cli_no_memory();
    for (int i = 0; i < parts; i++) {
        uint64_t *limbs = p->limbs + width * (size_t)i;
        int length = roots_decimal_limbs(p->part + i, fives, twos, limbs);
        z[i] = (algsurf_integer){limbs, p->part[i].negative ? -length : length};
    }
    return 1;
}

/* z 2^-down, nearly. */
static double to_double(const algsurf_integer *z, int down, double *radius) {
    double magnitude = roots_limbs_double(z->limbs, abs(z->length), down, radius);
    return z->length < 0 ? -magnitude : magnitude;
}

/* The integers times a power of two that takes the largest and the least as far from 1, but the largest not
 * beyond 2^1000. */
static void to_doubles(const algsurf_integer *z, roots_polynomial *p) {
    int most = 0, least = INT_MAX;
    for (int i = 0; i < 2 * (p->degree + 1); i++) {
        int bits = z[i].length ? roots_limbs_bits(z[i].limbs, abs(z[i].length)) : 0;
        if (bits > most) most = bits;
        if (bits && bits < least) least = bits;
    }
    int down = most - least > 2000 ? most - 1000 : most > 0 ? (most + least) / 2 : 0;
    for (int k = 0; k <= p->degree; k++) {
        double re, im; /* how far they are off */
        p->c[k] = (algsurf_complex){to_double(z + 2 * k, down, &re), to_double(z + 2 * k + 1, down, &im)};
        p->r[k] = re > 0 && im > 0 ? 1.5 * fmax(re, im) : re + im; /* |re + i im| <= 1.5 of the larger one */
        if (p->r[k] > 0) p->off = 1;
    }
}

static int parse_exactly(size_t line, char *const *field, roots_polynomial *p) {
    algsurf_integer z[2 * ROOTS_MAX_FIELDS];
    if (!read_parts(line, field, p) || !to_integers(line, p, z)) return 0;
    to_doubles(z, p);
    for (int k = 0; k <= p->degree; k++) p->integer[k] = z[2 * k];
    return 1;
}

int roots_parse(size_t line, char *const *field, int count, int rounded, roots_polynomial *p) {
    if (count > ROOTS_MAX_FIELDS) {
        cli_complain("line %zu: degree %d, the limit is %d", line, count - 1, ALGSURF_MAX_POLY_DEGREE);
        return 0;
    }
    p->degree = count - 1;
    p->real = 1;
    p->off = 0;
    return rounded ? parse_rounded(line, field, p) : parse_exactly(line, field, p);
}

/* ---- a polynomial becomes its roots ---- */

static int refused(size_t line, algsurf_status status) {
    cli_complain("line %zu: %s", line, algsurf_status_text(status));
    return -1;
}

static void real_parts(const roots_polynomial *p, double *c) {
    for (int k = 0; k <= p->degree; k++) c[k] = p->c[k].re;
}

/* With radii, only algsurf_roots_real knows that the numbers they hide are real. */
int roots_all(size_t line, algsurf_root_solver *solver, const roots_polynomial *p, roots_row *rows) {
    algsurf_enclosure e[ALGSURF_MAX_POLY_DEGREE];
    double c[ROOTS_MAX_FIELDS];
    int count;
    real_parts(p, c);
    algsurf_status status =
        p->off && p->real && p->degree <= ALGSURF_MAX_DEGREE
            ? algsurf_roots_real(c, p->r, p->degree, e, &count)
            : algsurf_root_solver_run(solver, p->c, p->off ? p->r : NULL, p->degree, NULL, e, &count, NULL);
    if (status < 0) return refused(line, status);
    for (int i = 0; i < count; i++) rows[i] = (roots_row){e[i].value, e[i].box, e[i].multiplicity};
    return count;
}

/* A bracket made narrow. */
static roots_row refined(const double *c, int degree, const algsurf_bracket *b, double tolerance) {
    const algsurf_refine_options options = {.size = sizeof options, .tolerance = tolerance};
    algsurf_root root;
    if (algsurf_refine_poly(c, degree, b->lo, b->hi, &options, &root) == ALGSURF_E_NO_MEMORY) cli_no_memory();
    return (roots_row){{root.root, 0}, {{root.lo, root.hi}, {0, 0}}, b->multiplicity};
}

static roots_row exact(const algsurf_bracket *b) {
    return (roots_row){{b->lo, 0}, {{b->lo, b->lo}, {0, 0}}, b->multiplicity};
}

static int real_from_doubles(size_t line, const roots_polynomial *p, const roots_interval *where,
                             double tolerance, roots_row *rows) {
    double c[ROOTS_MAX_FIELDS];
    algsurf_bracket b[ROOTS_MAX_FIELDS];
    int count;
    real_parts(p, c);
    algsurf_status status =
        algsurf_isolate_all(c, NULL, p->degree, where->lo, where->hi, b, ROOTS_MAX_FIELDS, &count);
    if (status < 0) return refused(line, status);
    for (int i = 0; i < count; i++)
        rows[i] = b[i].kind == ALGSURF_ROOT_EXACT ? exact(&b[i]) : refined(c, p->degree, &b[i], tolerance);
    return count;
}

static int real_from_integers(size_t line, const roots_polynomial *p, const roots_interval *where,
                              roots_row *rows) {
    algsurf_real_root root[ROOTS_MAX_FIELDS];
    int count;
    algsurf_status status = algsurf_real_roots_integers(p->integer, p->degree, where->lo, where->hi, root,
                                                        ROOTS_MAX_FIELDS, &count);
    if (status < 0) return refused(line, status);
    for (int i = 0; i < count; i++) {
        const algsurf_real_root *t = root + i;
        rows[i] = (roots_row){{t->value, 0}, {{t->lo, t->hi}, {0, 0}}, t->multiplicity};
    }
    return count;
}

int roots_real(size_t line, const roots_polynomial *p, const roots_interval *where, double tolerance,
               roots_row *rows) {
    if (!p->real) {
        cli_complain("line %zu: not all coefficients are real, as --real needs it", line);
        return -1;
    }
    return p->off ? real_from_integers(line, p, where, rows)
                  : real_from_doubles(line, p, where, tolerance, rows);
}
