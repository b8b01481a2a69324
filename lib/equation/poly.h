/* poly.h - polynomials in x, y, z with double-double coefficients of unlimited range, for
 * the equation parser: the values its expressions take.
 *
 * A coefficient is (v + d) 2^(256 e) with |d| <= err: a double-double, a bound on its error, and an
 * exponent of its own, so that 1e200*1e200*1e-300 is what it should be.  A coefficient that its
 * bound cannot tell from zero is zero: p^2 - p - 1 vanishes for the golden ratio p.
 */
#ifndef ALGSURF_EQUATION_POLY_H
#define ALGSURF_EQUATION_POLY_H
#include <stddef.h>

#include "algsurf/status.h"
#include "../base/eft.h"

/* (v +- err) 2^(256 e) x^i y^j z^k, key = i + 2^7 j + 2^14 k, i + j + k <= 64: keys of products add. */
typedef struct monomial {
    algsurf_dd v;
    double err;
    int e, key;
} monomial;

/* Monomials by increasing key, none zero; the zero polynomial has none. */
typedef struct tripoly {
    monomial *m;
    size_t count;
} tripoly;

/* Of x, y, z: 0, 1, 2. */
static inline int algsurf_i_key_of(int variable) { return 1 << 7 * variable; }
static inline int algsurf_i_exponent(int key, int variable) { return key >> 7 * variable & 127; }

/* v 2^exponent times the monomial of the key; err as a part of v. */
monomial algsurf_i_monomial_make(algsurf_dd v, double err, int exponent, int key);

/* The coefficient rounded once to double: subnormal, infinite or zero as need be. */
double algsurf_i_monomial_round(const monomial *m);

/* Functions below that return a status fail with E_NO_MEMORY, or with E_RANGE when an exponent e
 * leaves +-2^20; then *out is untouched.  *out may not be an operand. */
algsurf_status algsurf_i_tripoly_make(monomial m, tripoly *out);
void algsurf_i_tripoly_free(tripoly *p);
int algsurf_i_tripoly_degree(const tripoly *p);      /* total; 0 for the zero polynomial */
size_t algsurf_i_tripoly_most_terms(int degree);     /* of that degree */
int algsurf_i_tripoly_is_constant(const tripoly *p); /* the zero polynomial is */
algsurf_status algsurf_i_tripoly_add(const tripoly *a, const tripoly *b, tripoly *out);

/* The degrees of a and b must add up to at most 64.  Cost: O(log) of the smaller number of monomials, for
 * each pair of monomials. */
algsurf_status algsurf_i_tripoly_multiply(const tripoly *a, const tripoly *b, tripoly *out);

/* base^n, 0 <= n <= 64, and the degree at most 64, by the binomial theorem for the first monomial and the
 * rest: each power of the rest is made once, and for independent monomials they are as large as the result
 * all together. */
algsurf_status algsurf_i_tripoly_raise(const tripoly *base, int n, tripoly *out);

/* a / b in place, b a constant, not zero. */
algsurf_status algsurf_i_tripoly_divide(tripoly *a, const monomial *b);

/* *m *= by; the range is not checked. */
void algsurf_i_monomial_multiply(monomial *m, const monomial *by);

/* number.c.  The longest number at the start of text, without sign: digits with an optional point and an
 * optional exponent, decimal (e) or hexadecimal (0x, p).  *m becomes it, right to 2^-104, or without an error
 * if it is a double; the double next to it is what strtod returns in the "C" locale, as long as that is
 * normal. Below 10^-400 or 2^-4000: zero.  Beyond 10^400 or 2^2000: another number that is too large for a
 * double. Returns how many characters were read, 0 if there is no number.  Cost: linear in them. */
size_t algsurf_i_read_number(const char *text, monomial *m);

/* The square root of a constant >= 0. */
monomial algsurf_i_monomial_sqrt(monomial m);

/* sine.c.  sin(m + quarters pi/2), m a constant with |m| <= the limit, in radians, 0 <= quarters <= 3; and
 * pi. */
#define ALGSURF_I_SINE_LIMIT 100
monomial algsurf_i_monomial_sine(const monomial *m, int quarters);
monomial algsurf_i_monomial_pi(void);

/* A sum of many polynomials: partial sums whose lengths at least halve from one to the next, so that
 * each monomial is copied O(log) times.  A polynomial has less than 2^16 monomials: 16 parts that are
 * not zero, one that is, and a new one are the most there can be. */
enum { ALGSURF_I_SUM_PARTS = 18 };
typedef struct algsurf_i_sum {
    tripoly part[ALGSURF_I_SUM_PARTS];
    int parts;
} algsurf_i_sum;

/* Adds p and takes it over, also on failure. */
algsurf_status algsurf_i_sum_add(algsurf_i_sum *sum, tripoly p);
/* Moves the total to *out unless there was a failure already; the sum is empty then in any case. */
algsurf_status algsurf_i_sum_finish(algsurf_i_sum *sum, algsurf_status status, tripoly *out);

/* ---- values: value.c.  Polynomials that know how they were made.
 *
 * Multiplying by (x+y+z+1)^32 term by term is 6545 steps for each term of the other factor; multiplying 32
 * times by x+y+z+1 is 128.  So a value with many more terms than its text has keeps its factors and summands.
 */
typedef struct value {
    tripoly p;
    struct algsurf_i_way *way; /* how it was made; null: by nothing shorter */
} value;

void algsurf_i_value_free(value *v);
void algsurf_i_value_negate(value *v);

/* Functions below fail as those above do; what they change is to be freed then, too. */

/* *left *= right, which is taken over.  Cost: at most the steps by which right was made of constants and
 * variables, exponents counted as repetitions, times the terms of the results. */
algsurf_status algsurf_i_value_multiply(value *left, value *right);

/* *v /= b, not zero, or v^n, n >= 0. */
algsurf_status algsurf_i_value_divide(value *v, const monomial *b);
algsurf_status algsurf_i_value_raise(value *v, int n);

/* *v becomes the sum of c[i] v^i, 0 <= i <= n; the c are constants, zero or not. */
algsurf_status algsurf_i_value_compose(value *v, const monomial *c, int n);

/* A sum of many values, all 0 at first. */
typedef struct value_sum {
    algsurf_i_sum plain;       /* of values without a way */
    struct algsurf_i_way *way; /* of the others */
} value_sum;

/* Adds v and takes it over. */
algsurf_status algsurf_i_value_sum_add(value_sum *sum, value *v);

/* Moves the total to *out unless there was a failure already; the sum is empty then in any case. */
algsurf_status algsurf_i_value_sum_finish(value_sum *sum, algsurf_status status, value *out);

#endif
