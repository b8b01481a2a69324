/* roots_line.c - see roots_line.h.
 *
 * A line's numbers are exact.  Times one power of five, one of two, and the least common multiple of the
 * denominators, they are integers; where these fit doubles, doubles it is.
 *
 * Of doubles, too, all real roots come from one call, unless a tolerance asks for less. */
#include "roots_line.h"

#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "roots_limbs.h"

static void complain(roots_complaint *why, const char *format, ...) CLI_FORMAT(2, 3);
static void complain(roots_complaint *why, const char *format, ...) {
    va_list values;
    va_start(values, format);
    vsnprintf(why->text, sizeof why->text, format, values);
    va_end(values);
}

/* ---- a line becomes a polynomial ---- */

static int expected_numbers(int k, const char *got, roots_complaint *why) {
    complain(why, "coefficient %d: expected a number, a fraction as 1/3, or re,im, got '%s'%s", k,
             cli_quote(got).text, strpbrk(got, "^*") ? "; t^2 - 2 is given as -2 0 1" : "");
    return 0;
}

/* The parts of a coefficient. */
static int read_parts(int k, const char *field, roots_fraction *part, roots_complaint *why) {
    const char *end = roots_fraction_read(field, &part[0]);
    (void)roots_fraction_read("0", &part[1]);
    if (end && *end == ',') end = roots_fraction_read(end + 1, &part[1]);
    if (!end || *end) return expected_numbers(k, field, why);
    if (part[0].under.count && part[1].under.count) return 1;
    complain(why, "coefficient %d: the denominator is 0 in '%s'", k, cli_quote(field).text);
    return 0;
}

static int round_fractions(int k, const char *field, double *parts, roots_complaint *why) {
    roots_fraction f[2];
    if (!read_parts(k, field, f, why)) return 0;
    for (int i = 0; i < 2; i++) parts[i] = roots_fraction_double(&f[i]);
    if (isfinite(parts[0]) && isfinite(parts[1])) return 1;
    complain(why, "coefficient %d: '%s' is too large, or too long, to be rounded", k, cli_quote(field).text);
    return 0;
}

static int parse_rounded(char *const *field, roots_polynomial *p, roots_complaint *why) {
    for (int k = 0; k <= p->degree; k++) {
        double parts[2] = {0, 0};
        if (strchr(field[k], '/')) {
            if (!round_fractions(k, field[k], parts, why)) return 0;
        } else if (!cli_numbers(field[k], ',', 1, parts) && !cli_numbers(field[k], ',', 2, parts)) {
            return expected_numbers(k, field[k], why);
        }
        p->c[k] = (algsurf_complex){parts[0], parts[1]};
        if (parts[1] != 0) p->real = 0;
    }
    while (p->degree > 0 && p->c[p->degree].re == 0 && p->c[p->degree].im == 0) p->degree--;
    return 1;
}

static int read_all_parts(char *const *field, roots_polynomial *p, roots_complaint *why) {
    for (int k = 0; k <= p->degree; k++) {
        if (!read_parts(k, field[k], p->part + 2 * k, why)) return 0;
        if (p->part[2 * k + 1].over.count) p->real = 0;
    }
    while (p->degree > 0 && !p->part[2 * p->degree].over.count && !p->part[2 * p->degree + 1].over.count)
        p->degree--;
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

/* What makes integers of all parts: they are multiplied by common 5^-fives 2^-twos. */
typedef struct multiplier {
    long long fives, twos;
    uint64_t common[ROOTS_MOST_LIMBS];
    int length;
} multiplier;

static int find_multiplier(roots_polynomial *p, multiplier *by, roots_complaint *why) {
    *by = (multiplier){.fives = LLONG_MAX, .twos = LLONG_MAX, .common = {1}, .length = 1};
    for (int i = 0; i < 2 * (p->degree + 1); i++) {
        roots_fraction *f = p->part + i;
        if (!f->over.count) continue;
        by->length = roots_fraction_common(f, by->common, by->length);
        if (!by->length) {
            complain(why, "coefficient %d: the common denominator has more than %d decimals", i / 2,
                     3 * ROOTS_MOST_BITS / 10);
            return 0;
        }
        if (f->over.fives < by->fives) by->fives = f->over.fives;
        if (f->over.twos < by->twos) by->twos = f->over.twos;
    }
    return 1;
}

/* Their lengths have signs. */
static int to_integers(roots_polynomial *p, algsurf_integer *z, roots_complaint *why) {
    multiplier by;
    int parts = 2 * (p->degree + 1);
    long long bits = 0;
    if (!find_multiplier(p, &by, why)) return 0;
    for (int i = 0; i < parts; i++) {
        long long more = roots_fraction_bits(p->part + i, by.fives, by.twos, by.common, by.length);
        if (more > bits) bits = more;
    }
    if (bits > ROOTS_MOST_BITS) {
        complain(why, "about %lld decimals from the first digit to the last%s, the limit is %d",
                 3 * bits / 10, by.length == 1 && *by.common == 1 ? "" : ", by the common denominator",
                 3 * ROOTS_MOST_BITS / 10);
        return 0;
    }
    size_t width = (size_t)bits / 64 + 4;
    if (!room_for(p, width * (size_t)parts)) cli_no_memory();
    for (int i = 0; i < parts; i++) {
        const roots_fraction *f = p->part + i;
        uint64_t *limbs = p->limbs + width * (size_t)i;
        int length =
            f->over.count ? roots_fraction_limbs(f, by.fives, by.twos, by.common, by.length, limbs) : 0;
        z[i] = (algsurf_integer){limbs, f->over.negative ? -length : length};
    }
    return 1;
}

/* z 2^-down, nearly: sets *off. */
static double to_double(const algsurf_integer *z, int down, int *off) {
    double magnitude = roots_limbs_double(z->limbs, abs(z->length), down, off);
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
        p->c[k] =
            (algsurf_complex){to_double(z + 2 * k, down, &p->off), to_double(z + 2 * k + 1, down, &p->off)};
    }
}

static int parse_exactly(char *const *field, roots_polynomial *p, roots_complaint *why) {
    algsurf_integer z[2 * ROOTS_MAX_FIELDS];
    if (!read_all_parts(field, p, why) || !to_integers(p, z, why)) return 0;
    to_doubles(z, p);
    for (int k = 0; k <= p->degree; k++) p->integer[k] = z[2 * k], p->imaginary[k] = z[2 * k + 1];
    return 1;
}

int roots_parse(char *const *field, int count, int rounded, roots_polynomial *p, roots_complaint *why) {
    if (count > ROOTS_MAX_FIELDS) {
        complain(why, "degree %d, the limit is %d", count - 1, ALGSURF_MAX_POLY_DEGREE);
        return 0;
    }
    p->degree = count - 1;
    p->real = 1;
    p->off = 0;
    return rounded ? parse_rounded(field, p, why) : parse_exactly(field, p, why);
}

/* ---- a polynomial becomes its roots ---- */

static int refused(algsurf_status status, roots_complaint *why) {
    complain(why, "%s", algsurf_status_text(status));
    return -1;
}

static void real_parts(const roots_polynomial *p, double *c) {
    for (int k = 0; k <= p->degree; k++) c[k] = p->c[k].re;
}

int roots_all(const roots_polynomial *p, roots_row *rows, roots_complaint *why) {
    algsurf_complex_root e[ALGSURF_MAX_POLY_DEGREE];
    double c[ROOTS_MAX_FIELDS];
    int count;
    real_parts(p, c);
    algsurf_status status = p->off ? algsurf_complex_roots_integers(p->integer, p->real ? NULL : p->imaginary,
                                                                    p->degree, e, &count)
                            : p->real ? algsurf_complex_roots_of_real(c, NULL, p->degree, e, &count)
                                      : algsurf_complex_roots(p->c, NULL, p->degree, e, &count);
    if (status < 0) return refused(status, why);
    for (int i = 0; i < count; i++) rows[i] = (roots_row){e[i].root, e[i].box, e[i].multiplicity};
    return count;
}

static roots_row row_of(double value, double lo, double hi, int multiplicity) {
    return (roots_row){{value, 0}, {{lo, hi}, {0, 0}}, multiplicity};
}

/* Brackets, made only as narrow as is wanted. */
static int real_to_tolerance(const roots_polynomial *p, const roots_interval *where, double tolerance,
                             roots_row *rows, roots_complaint *why) {
    const algsurf_refine_options options = {.size = sizeof options, .absolute_tolerance = tolerance};
    double c[ROOTS_MAX_FIELDS];
    algsurf_bracket b[ROOTS_MAX_FIELDS];
    algsurf_refined_root root;
    int count;
    real_parts(p, c);
    algsurf_status status =
        algsurf_isolate_all(c, NULL, p->degree, where->lo, where->hi, NULL, b, ROOTS_MAX_FIELDS, &count);
    for (int i = 0; status >= 0 && i < count; i++) {
        rows[i] = row_of(b[i].lo, b[i].lo, b[i].lo, b[i].multiplicity);
        if (b[i].kind == ALGSURF_BRACKET_EXACT) continue;
        status = algsurf_refine_poly(c, NULL, p->degree, b[i].lo, b[i].hi, &options, &root);
        rows[i] = row_of(root.root, root.lo, root.hi, b[i].multiplicity);
    }
    return status < 0 ? refused(status, why) : count;
}

static int real_to_doubles(const roots_polynomial *p, const roots_interval *where, roots_row *rows,
                           roots_complaint *why) {
    double c[ROOTS_MAX_FIELDS];
    algsurf_real_root root[ROOTS_MAX_FIELDS];
    int count;
    real_parts(p, c);
    algsurf_status status =
        p->off ? algsurf_real_roots_integers(p->integer, p->degree, where->lo, where->hi, root,
                                             ROOTS_MAX_FIELDS, &count)
               : algsurf_real_roots(c, p->degree, where->lo, where->hi, root, ROOTS_MAX_FIELDS, &count);
    if (status < 0) return refused(status, why);
    for (int i = 0; i < count; i++)
        rows[i] = row_of(root[i].root, root[i].lo, root[i].hi, root[i].multiplicity);
    return count;
}

int roots_real(const roots_polynomial *p, const roots_interval *where, double tolerance, roots_row *rows,
               roots_complaint *why) {
    if (!p->real) {
        complain(why, "--real: all coefficients must be real");
        return -1;
    }
    return tolerance > 0 && !p->off ? real_to_tolerance(p, where, tolerance, rows, why)
                                    : real_to_doubles(p, where, rows, why);
}

/* How many real roots there are, and how many of all are below lo; -1 and a complaint. */
static int count_real(const roots_polynomial *p, const roots_interval *where, int *below,
                      roots_complaint *why) {
    roots_row rows[ROOTS_MAX_FIELDS];
    const roots_interval left = {-HUGE_VAL, where->lo, 1}, here = {where->lo, where->lo, 1};
    *below = 0;
    if (isfinite(where->lo)) {
        int to_lo = roots_real(p, &left, 0, rows, why), at_lo = roots_real(p, &here, 0, rows, why);
        if (to_lo < 0 || at_lo < 0) return -1;
        *below = to_lo - at_lo;
    }
    return roots_real(p, where, 0, rows, why);
}

int roots_precisely(const roots_polynomial *p, const roots_interval *where, int bits,
                    algsurf_precise_roots **roots, int *index, roots_complaint *why) {
    int wanted = ALGSURF_MAX_POLY_DEGREE, below = 0, count = 0;
    if (where->given && (wanted = count_real(p, where, &below, why)) < 0) return -1;
    algsurf_status status =
        algsurf_precise_roots_create(p->integer, p->real ? NULL : p->imaginary, p->degree, bits, 0, roots);
    if (status != ALGSURF_OK) return refused(status, why);
    for (int i = 0; i < algsurf_precise_roots_count(*roots) && count < wanted; i++) {
        algsurf_precise_root r;
        (void)algsurf_precise_roots_get(*roots, i, &r);
        if (where->given && (!r.real || below-- > 0)) continue;
        index[count++] = i;
    }
    return count;
}
