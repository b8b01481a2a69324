/* lift.c - rational numbers with one denominator, from their images modulo primes.
 *
 * Chinese remainders in mixed radix (Garner 1959): x = v_0 + p_0 (v_1 + p_1 (v_2 + ...)), 0 <= v_j < p_j; a
 * new image adds a digit and changes no other, one limb for each number.  Only a guess makes integers of
 * them, one number at a time.
 *
 * Fractions (Wang 1981): Euclid's algorithm for the product M of the primes and x yields remainders
 * r_i = +-t_i x mod M with t_i r_(i-1) <= M.  If x = n/d with n, d < sqrt(M/2), then n/d = r_i/t_i for the
 * first r_i below that bound.  Both are asked to be below sqrt(M 2^-SPARE): then a random x has such a
 * fraction with a probability of about 2^-SPARE, and a guess is rarely wrong.  The denominator is carried
 * along: with the right D, D x mod M is small for the numbers that follow.
 *
 * Lehmer's form of the algorithm (Knuth, 4.5.2, algorithm L): quotients come from the leading 62 bits as long
 * as they are certain, and some 30 bits of them change the long numbers at once.
 */
#include "../base/arithmetic.h"
#include "lift.h"

#include <string.h>

#define SPARE 12

struct algsurf_image {
    algsurf_image *before;
    algsurf_prime prime;
    algsurf_limb digit[];
};

void algsurf_lift_begin(algsurf_lift *lift, algsurf_memory *m, int count) {
    *lift = (algsurf_lift){m, algsurf_memory_here(m), NULL, count, 0};
}

void algsurf_lift_forget(algsurf_lift *lift) {
    algsurf_memory_release(lift->memory, lift->start);
    lift->last = NULL;
    lift->primes = 0;
}

/* All primes are between 2^61 and 2^62: below twice any other. */
static algsurf_limb reduced(algsurf_limb x, const algsurf_prime *m) { return x >= m->p ? x - m->p : x; }

/* The image's prime modulo m, in Montgomery's form. */
static algsurf_limb radix(const algsurf_image *image, const algsurf_prime *m) {
    return algsurf_residue_times(reduced(image->prime.p, m), m->square, m);
}

algsurf_limb algsurf_lift_modulus(const algsurf_lift *lift, const algsurf_prime *m) {
    algsurf_limb product = m->one;
    for (const algsurf_image *i = lift->last; i; i = i->before)
        product = algsurf_residue_times(product, radix(i, m), m);
    return product;
}

int algsurf_lift_add(algsurf_lift *lift, const algsurf_limb *x, algsurf_limb inverse,
                     const algsurf_prime *m) {
    size_t count = (size_t)lift->count, head = (sizeof(algsurf_image) + 7) / 8;
    algsurf_image *image = (algsurf_image *)(void *)algsurf_memory_take(lift->memory, head + count);
    if (!image) return 0;
    memset(image->digit, 0, count * sizeof *image->digit);
    for (const algsurf_image *i = lift->last; i; i = i->before) { /* the value so far, modulo m: Horner */
        algsurf_limb step = radix(i, m);
        for (size_t k = 0; k < count; k++)
            image->digit[k] =
                reduced(algsurf_residue_times(image->digit[k], step, m) + reduced(i->digit[k], m), m);
    }
    for (size_t k = 0; k < count; k++)
        image->digit[k] = algsurf_residue_times(algsurf_residue_minus(x[k], image->digit[k], m), inverse, m);
    image->before = lift->last;
    image->prime = *m;
    lift->last = image;
    lift->primes++;
    return 1;
}

/* Euclid's algorithm: two remainders r (zeros above `length`) and their factors t. */
typedef struct row {
    algsurf_limb *r, *t;
    int length, t_length;
} row;

/* What a guess works with; all numbers are magnitudes of at most `limbs` limbs, zeros above. */
typedef struct workshop {
    const algsurf_lift *lift;
    int limbs, bits; /* of the modulus */
    algsurf_limb *modulus, *value, *denominator, *product, *quotient, *room;
    int denominator_length;
    row old, now;
} workshop;

static int bits_of(const algsurf_limb *a, int length) {
    return length ? 64 * (length - 1) + algsurf_limb_bits(a[length - 1]) : 0;
}

/* The 62 bits of a remainder below the bit `top`. */
static int64_t leading(const workshop *w, const row *x, int top) {
    return (int64_t)(algsurf_z_window(x->r, w->limbs + 2, top - 62) & (((algsurf_limb)1 << 62) - 1));
}

/* Algorithm L on the leading bits: f = (a b; c d), a d - b c = +-1, such that (a b; c d) (old, now) are later
 * remainders; |c|, |d| < 2^cap, cap <= 31.  Returns 0 when no quotient is certain. */
static int leading_steps(int64_t x, int64_t y, int cap, int64_t f[4]) {
    int64_t a = 1, b = 0, c = 0, d = 1, most = (int64_t)1 << cap;
    while (y + c != 0 && y + d != 0) {
        int64_t q = (x + a) / (y + c);
        if (q != (x + b) / (y + d) || q >= most) break;
        int64_t next_c = a - q * c, next_d = b - q * d, next_y = x - q * y;
        if (next_c <= -most || next_c >= most || next_d <= -most || next_d >= most) break;
        a = c, b = d, x = y;
        c = next_c, d = next_d, y = next_y;
    }
    f[0] = a, f[1] = b, f[2] = c, f[3] = d;
    return b != 0;
}

/* r += x f without signs but that of f; nothing is carried out of n limbs. */
static void add_multiple(algsurf_limb *r, const algsurf_limb *x, int n, int64_t f) {
    if (f < 0)
        (void)algsurf_z_sub_row(r, x, n, (algsurf_limb)-f);
    else
        (void)algsurf_z_add_row(r, x, n, (algsurf_limb)f);
}

/* (u, v) becomes (a u + b v, c u + d v), of n limbs each, none negative; room for both. */
static void combine(algsurf_limb *u, algsurf_limb *v, int n, const int64_t f[4], algsurf_limb *room) {
    size_t bytes = (size_t)n * sizeof *u;
    memcpy(room, u, bytes), memcpy(room + n, v, bytes);
    memset(u, 0, bytes), memset(v, 0, bytes);
    add_multiple(u, room, n, f[0]), add_multiple(u, room + n, n, f[1]);
    add_multiple(v, room, n, f[2]), add_multiple(v, room + n, n, f[3]);
}

/* One exact step. */
static void divide_step(workshop *w) {
    int length = w->old.length - w->now.length + 1;
    algsurf_z_divide(w->quotient, w->old.r, w->old.length, w->now.r, w->now.length, w->room);
    for (int i = 0; i < algsurf_z_length(w->quotient, length); i++)
        algsurf_z_add_product(w->old.t, w->limbs + 1, w->now.t, w->limbs + 1, w->quotient[i], i);
    w->old.length = algsurf_z_length(w->old.r, w->now.length);
    w->old.t_length = algsurf_z_length(w->old.t, w->limbs + 1);
    row old = w->old;
    w->old = w->now, w->now = old;
}

/* Several steps at once, while the older remainder stays at or above 2^goal: old = |d| old' + |b| now' gives
 * old' > 2^(bits - 1) / (|b| + |d|) >= 2^(bits - 2 - cap). */
static int lehmer_step(workshop *w, int goal) {
    int top = bits_of(w->old.r, w->old.length), cap = top - goal - 2, n = w->old.length;
    int64_t f[4];
    if (cap < 2 || top < 62) return 0;
    if (!leading_steps(leading(w, &w->old, top), leading(w, &w->now, top), cap < 31 ? cap : 31, f)) return 0;
    combine(w->old.r, w->now.r, n, f, w->room);
    w->old.length = algsurf_z_length(w->old.r, n);
    w->now.length = algsurf_z_length(w->now.r, n);
    n = w->now.t_length + 1; /* the signs of t alternate: sizes are kept */
    for (int i = 0; i < 4; i++) f[i] = f[i] < 0 ? -f[i] : f[i];
    combine(w->old.t, w->now.t, n, f, w->room);
    w->old.t_length = algsurf_z_length(w->old.t, n);
    w->now.t_length = algsurf_z_length(w->now.t, n);
    return 1;
}

/* The fraction of w->product, its denominator in w->now.t; 0 when there is none. */
static int find_fraction(workshop *w) {
    size_t room = (size_t)w->limbs + 2, bytes = room * sizeof(algsurf_limb);
    int goal = (w->bits - SPARE) / 2;
    memset(w->old.t, 0, bytes), memset(w->now.t, 0, bytes);
    memcpy(w->old.r, w->modulus, bytes), memcpy(w->now.r, w->product, bytes);
    w->now.t[0] = 1;
    w->old.t_length = 0, w->now.t_length = 1;
    w->old.length = w->limbs, w->now.length = algsurf_z_length(w->now.r, w->limbs);
    while (bits_of(w->now.r, w->now.length) > goal)
        if (!lehmer_step(w, goal)) divide_step(w);
    return bits_of(w->now.t, w->now.t_length) <= goal;
}

/* r += a b for magnitudes; r has na + nb + 1 limbs at least, a has a zero above its na limbs. */
static void add_magnitudes(algsurf_limb *r, const algsurf_limb *a, int na, const algsurf_limb *b, int nb) {
    for (int i = 0; i < nb; i++) algsurf_z_add_product(r, na + nb + 1, a, na + 1, b[i], i);
}

static void set_modulus(workshop *w) {
    w->modulus[0] = 1;
    w->limbs = 1;
    for (const algsurf_image *i = w->lift->last; i; i = i->before)
        w->limbs = algsurf_z_extend(w->modulus, w->limbs, i->prime.p, 0);
    w->bits = bits_of(w->modulus, w->limbs);
}

/* D times the k-th number modulo M, the residue of least size: its magnitude in w->product.  Returns whether
 * it is negative. */
static int multiple(workshop *w, int k) {
    const algsurf_image *i = w->lift->last;
    int n = w->limbs, d = w->denominator_length, length = 1;
    size_t bytes = ((size_t)n + 2) * sizeof(algsurf_limb);
    memset(w->value, 0, bytes);
    memset(w->product, 0, 2 * bytes);
    w->value[0] = i->digit[k];
    for (i = i->before; i; i = i->before)
        length = algsurf_z_extend(w->value, length, i->prime.p, i->digit[k]);
    if (d == 1 && w->denominator[0] == 1) {
        memcpy(w->product, w->value, bytes);
    } else {
        add_magnitudes(w->product, w->value, n, w->denominator, d);
        length = algsurf_z_length(w->product, n + d);
        if (length >= n) algsurf_z_divide(w->quotient, w->product, length, w->modulus, n, w->room);
    }
    memcpy(w->value, w->modulus, bytes);
    algsurf_z_sub(w->value, w->product, n + 1);
    int negative = algsurf_z_compare_magnitudes(w->product, algsurf_z_length(w->product, n), w->value,
                                                algsurf_z_length(w->value, n)) > 0;
    if (negative) memcpy(w->product, w->value, bytes);
    return negative;
}

static int is_small(const workshop *w, const algsurf_limb *a) {
    return bits_of(a, algsurf_z_length(a, w->limbs)) <= w->bits - SPARE;
}

/* The denominator of w->product joins D. */
static int enlarge(workshop *w) {
    int n = w->limbs;
    if (!find_fraction(w)) return 0;
    if (w->denominator_length + w->now.t_length > n + 1) return 0;
    memset(w->product, 0, (2 * (size_t)n + 4) * sizeof(algsurf_limb));
    add_magnitudes(w->product, w->denominator, w->denominator_length, w->now.t, w->now.t_length);
    if (w->product[n] || bits_of(w->product, algsurf_z_length(w->product, n)) > (w->bits - SPARE) / 2)
        return 0;
    memcpy(w->denominator, w->product, ((size_t)n + 2) * sizeof(algsurf_limb));
    w->denominator_length = algsurf_z_length(w->denominator, n);
    return 1;
}

/* No image's prime may divide D: nothing would follow from it. */
static int is_possible(const workshop *w) {
    for (const algsurf_image *i = w->lift->last; i; i = i->before) {
        algsurf_limb r;
        algsurf_residues_of(&r, w->denominator, 1, w->denominator_length + 1, &i->prime);
        if (r == 0) return 0;
    }
    return 1;
}

/* D is enlarged by the first number that needs it, then everything begins anew, mostly once. */
static int find_all(workshop *w, algsurf_zpoly *c) {
    for (int k = 0; k <= c->degree; k++) {
        int negative = multiple(w, k);
        if (is_small(w, w->product)) {
            algsurf_z_copy(algsurf_zpoly_at(c, k), c->width, w->product, w->limbs + 1);
            if (negative) algsurf_z_negate(algsurf_zpoly_at(c, k), c->width);
        } else {
            if (!enlarge(w)) return 0;
            k = -1;
        }
    }
    return is_possible(w);
}

static int open_workshop(workshop *w, const algsurf_lift *lift) {
    size_t room = (size_t)lift->primes + 3;
    algsurf_limb *at = algsurf_memory_take(lift->memory, 13 * room);
    if (!at) return 0;
    memset(at, 0, 13 * room * sizeof *at);
    *w = (workshop){.lift = lift, .modulus = at, .value = at + room, .denominator = at + 2 * room};
    w->old.r = at + 3 * room, w->old.t = at + 4 * room;
    w->now.r = at + 5 * room, w->now.t = at + 6 * room;
    w->product = at + 7 * room, w->quotient = at + 9 * room, w->room = at + 11 * room;
    w->denominator[0] = 1;
    w->denominator_length = 1;
    set_modulus(w);
    return 1;
}

int algsurf_lift_guess(algsurf_lift *lift, int *found, algsurf_zpoly *c) {
    workshop w;
    *found = 0;
    algsurf_memory_mark before = algsurf_memory_here(lift->memory);
    if (!algsurf_zpoly_new(lift->memory, lift->count - 1, lift->primes, c)) return 0;
    algsurf_memory_mark after = algsurf_memory_here(lift->memory);
    if (!open_workshop(&w, lift)) {
        algsurf_memory_release(lift->memory, before);
        return 0;
    }
    *found = find_all(&w, c);
    algsurf_memory_release(lift->memory, *found ? after : before);
    return 1;
}
