/* residue.c - integers and polynomials modulo primes of 62 bits.
 *
 * Montgomery, Modular multiplication without trial division, 1985.  The primes are p = 2^62 - c, largest
 * first, with c below 2^13 in the table: R = 2^64 = 4 c and R^2 = 16 c^2 modulo p need no division.  62 bits
 * leave room for three products before a reduction: 3 p^2 < p R.
 */
#include "../base/arithmetic.h"
#include "residue.h"

#include <stddef.h>

#define TOP ((algsurf_limb)1 << 62)

/* 2^62 - c is prime for these c and for no other c below the last. */
static const uint16_t below[] = {
    57,   87,   117,  143,  153,  167,  171,  195,  203,  273,  287,  317,  443,  483,  495,  575,
    581,  603,  633,  663,  765,  773,  777,  791,  813,  831,  923,  981,  993,  1001, 1007, 1017,
    1197, 1241, 1293, 1353, 1433, 1515, 1553, 1575, 1581, 1595, 1617, 1673, 1697, 1701, 1703, 1823,
    1881, 1911, 1923, 2043, 2073, 2103, 2141, 2187, 2217, 2247, 2285, 2351, 2367, 2375, 2397, 2421,
    2511, 2541, 2583, 2661, 2675, 2753, 2777, 2793, 2861, 2891, 2927, 3023, 3041, 3221, 3251, 3255,
    3257, 3263, 3317, 3377, 3521, 3537, 3545, 3551, 3563, 3671, 3705, 3767, 3797, 3803, 3873, 3933,
    4163, 4247, 4275, 4301, 4377, 4403, 4485, 4557, 4595, 4641, 4661, 4707, 4781, 4815, 4821, 4857,
    4881, 4917, 4941, 4971, 4991, 4997, 5003, 5055, 5103, 5133, 5153, 5265, 5355, 5393, 5445, 5465};
#define TABLE ((int)(sizeof below / sizeof *below))

/* Constants for the odd number 2^62 - c, c < 2^28. */
static algsurf_prime modulus(algsurf_limb c, int index) {
    algsurf_limb p = TOP - c, inverse = 3 * p ^ 2; /* right modulo 2^5; each step doubles the bits */
    for (int i = 0; i < 4; i++) inverse *= 2 - p * inverse;
    return (algsurf_prime){p, 0 - inverse, 4 * c, 16 * c * c, index};
}

algsurf_limb algsurf_residue_power(algsurf_limb a, algsurf_limb e, const algsurf_prime *m) {
    algsurf_limb r = m->one;
    for (; e; e >>= 1, a = algsurf_residue_times(a, a, m))
        if (e & 1) r = algsurf_residue_times(r, a, m);
    return r;
}

/* Kaliski's almost inverse (1995), all zeros of a difference at once.  u and v are odd; throughout
 * a r = -u 2^k and a s = v 2^k modulo p up to one common sign, and u s + v r = p keeps r and s below p.  At
 * the end u = v = 1, so that 1/a = +-s 2^-k.  Selections instead of branches: they could not be predicted. */
algsurf_limb algsurf_residue_inverse(algsurf_limb a, const algsurf_prime *m) {
    int k = algsurf_limb_trailing(a), negative = 0;
    algsurf_limb u = m->p, v = a >> k, r = 0, s = 1;
    while (u != v) {
        int swap = u < v;
        algsurf_limb difference = swap ? v - u : u - v, least = swap ? u : v, sum = r + s;
        int zeros = algsurf_limb_trailing(difference);
        s = (swap ? r : s) << zeros;
        r = sum;
        u = difference >> zeros, v = least;
        negative ^= swap;
        k += zeros;
    }
    int up = 128 - k; /* 1/a R^2 = s 2^up, where r + s = p <= 2^(k+1): 60 <= k <= 124 */
    if (up > 60) s = algsurf_residue_times(s, algsurf_residue_times((algsurf_limb)1 << 30, m->square, m), m);
    up -= up > 60 ? 30 : 0;
    s = algsurf_residue_times(s, algsurf_residue_times((algsurf_limb)1 << up, m->square, m), m);
    return negative ? m->p - s : s;
}

/* Is a^d, squared s - 1 times, ever what it must be for a prime p = 1 + d 2^s? */
static int passes(algsurf_limb base, algsurf_limb d, int s, const algsurf_prime *m) {
    algsurf_limb minus_one = m->p - m->one;
    algsurf_limb x = algsurf_residue_power(algsurf_residue_times(base, m->square, m), d, m);
    if (x == m->one || x == minus_one) return 1;
    for (int i = 1; i < s; i++) {
        x = algsurf_residue_times(x, x, m);
        if (x == minus_one) return 1;
    }
    return 0;
}

/* Miller and Rabin's test; these bases decide every odd number below 2^64 (Sorenson, Webster 2015). */
static int is_prime(const algsurf_prime *m) {
    static const algsurf_limb bases[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
    int s = algsurf_limb_trailing(m->p - 1);
    for (size_t i = 0; i < sizeof bases / sizeof *bases; i++)
        if (!passes(bases[i], (m->p - 1) >> s, s, m)) return 0;
    return 1;
}

algsurf_prime algsurf_prime_first(void) { return modulus(below[0], 0); }

algsurf_prime algsurf_prime_next(const algsurf_prime *before) {
    int index = before->index + 1;
    if (index < TABLE) return modulus(below[index], index);
    algsurf_limb c = TOP - before->p;
    algsurf_prime next;
    do next = modulus(c += 2, index);
    while (!is_prime(&next));
    return next;
}

/* x becomes (x + a) / R: below 2^64 + p R over R, hence at most p. */
static inline algsurf_limb digest(algsurf_limb x, algsurf_limb a, const algsurf_prime *m) {
    unsigned char carry = 0;
    algsurf_limb high, low = algsurf_limb_add(a, x, &carry);
    (void)algsurf_limb_product(low * m->negative_inverse, m->p, low, 0, &high);
    return high + carry;
}

/* From x = sum a_i R^(i - w), a_i unsigned: a negative integer is less by R^w, that is x by 1. */
static algsurf_limb finish(algsurf_limb x, const algsurf_limb *a, int w, const algsurf_prime *m) {
    x = x >= m->p ? x - m->p : x;
    return algsurf_z_negative(a, w) ? algsurf_residue_minus(x, 1, m) : x;
}

/* Of n <= 4 integers side by side: each is a chain of dependent products, from the lowest limb on. */
static inline void residues(algsurf_limb *r, const algsurf_limb *a, int n, int w, const algsurf_prime *m) {
    algsurf_limb x[4] = {0};
    for (int i = 0; i < w; i++)
        for (int k = 0; k < n; k++) x[k] = digest(x[k], a[i + k * w], m);
    for (int k = 0; k < n; k++) r[k] = finish(x[k], a + k * w, w, m);
}

/* The last four may overlap the ones before. */
void algsurf_residues_of(algsurf_limb *r, const algsurf_limb *a, int count, int w, const algsurf_prime *m) {
    if (count < 4) residues(r, a, count, w, m);
    for (int k = 0; count >= 4 && k < count; k += 4) {
        int from = k + 4 <= count ? k : count - 4;
        residues(r + from, a + (size_t)from * (size_t)w, 4, w, m);
    }
}

void algsurf_residues_derive(algsurf_limb *r, const algsurf_limb *a, int n, const algsurf_prime *m) {
    for (int k = 1; k <= n; k++) r[k - 1] = algsurf_residue_times(a[k], (algsurf_limb)k, m);
}

/* (x a + y b + z c) / R, all six residues: the sum stays below 3 p^2 < p R. */
static inline algsurf_limb combine(algsurf_limb x, algsurf_limb a, algsurf_limb y, algsurf_limb b,
                                   algsurf_limb z, algsurf_limb c, const algsurf_prime *m) {
    algsurf_limb high, more, low = algsurf_limb_product(x, a, 0, 0, &high);
    low = algsurf_limb_product(y, b, low, 0, &more);
    high += more;
    low = algsurf_limb_product(z, c, low, 0, &more);
    return algsurf_residue_reduce(high + more, low, m);
}

/* One step for deg a = n + 1, deg b = n >= 1: a becomes l^2 a - (s x + t) b over constants, l = lc(b), and
 * loses two degrees at least. */
static void two_degrees(algsurf_limb *a, const algsurf_limb *b, int n, const algsurf_prime *m) {
    algsurf_limb lead = b[n], top = a[n + 1];
    algsurf_limb l2 = algsurf_residue_times(lead, lead, m), s = algsurf_residue_times(top, lead, m);
    algsurf_limb t = combine(a[n], lead, m->p - top, b[n - 1], 0, 0, m);
    s = s ? m->p - s : 0, t = t ? m->p - t : 0;
    for (int k = n - 1; k > 0; k--) a[k] = combine(a[k], l2, b[k - 1], s, b[k], t, m);
    a[0] = combine(a[0], l2, b[0], t, 0, 0, m);
}

/* For deg a = da >= deg b = db: a becomes l a - lc(a) x^(da - db) b over R. */
static void one_degree(algsurf_limb *a, int da, const algsurf_limb *b, int db, const algsurf_prime *m) {
    algsurf_limb lead = b[db], minus_top = m->p - a[da];
    for (int k = 0; k < da - db; k++) a[k] = algsurf_residue_times(a[k], lead, m);
    for (int k = 0; k < db; k++) a[da - db + k] = combine(a[da - db + k], lead, b[k], minus_top, 0, 0, m);
}

static int trim(const algsurf_limb *a, int n) {
    while (n >= 0 && a[n] == 0) n--;
    return n;
}

int algsurf_residues_gcd(algsurf_limb *a, int da, algsurf_limb *b, int db, algsurf_limb **gcd,
                         const algsurf_prime *m) {
    db = trim(b, db);
    while (db > 0) {
        while (da >= db) {
            int regular = da == db + 1;
            if (regular)
                two_degrees(a, b, db, m);
            else
                one_degree(a, da, b, db, m);
            da = trim(a, da - 1 - regular);
        }
        algsurf_limb *swap = a;
        a = b, b = swap;
        int degree = da;
        da = db, db = degree;
    }
    *gcd = db == 0 ? b : a; /* a constant, or a where b vanished */
    return db == 0 ? 0 : da;
}

void algsurf_residues_divide(algsurf_limb *a, int da, const algsurf_limb *b, int db, const algsurf_prime *m) {
    for (int k = da; k >= db; k--) {
        algsurf_limb minus = a[k] ? m->p - a[k] : 0;
        for (int i = 0; i < db; i++)
            a[k - db + i] =
                combine(b[i], minus, a[k - db + i], m->one, 0, 0, m); /* one / R = 1: a itself is added */
    }
}
