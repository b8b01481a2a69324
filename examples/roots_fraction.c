/* roots_fraction.c - see roots_fraction.h. */
#include "roots_fraction.h"

#include <math.h>
#include <string.h>

#include "roots_limbs.h"

enum { ROOM = ROOTS_MOST_LIMBS };

const char *roots_fraction_read(const char *text, roots_fraction *f) {
    f->under = (roots_decimal){.digits = "1", .count = 1, .radix = 10};
    text = roots_decimal_read(text, &f->over);
    if (!text || *text != '/') return text;
    text = roots_decimal_read(text + 1, &f->under);
    f->over.negative ^= f->under.negative;
    f->over.fives -= f->under.fives;
    f->over.twos -= f->under.twos;
    return text;
}

static int is_whole(const roots_fraction *f) { return f->under.count == 1 && *f->under.digits == '1'; }

/* The digits below as an integer, times 5^fives; 0 if they are too long. */
static int limbs_under(const roots_fraction *f, long long fives, uint64_t *limbs) {
    const roots_decimal *d = &f->under;
    if (roots_decimal_bits(d, d->fives - fives, d->twos) > ROOTS_MOST_BITS) return 0;
    return roots_decimal_limbs(d, d->fives - fives, d->twos, limbs);
}

int roots_fraction_common(roots_fraction *f, uint64_t *common, int length) {
    uint64_t under[ROOM], shared[ROOM], multiple[ROOM], more[ROOM];
    int twos;
    f->under_bits = 1;
    if (is_whole(f)) return length;
    int count = limbs_under(f, 0, under);
    if (!count) return 0;
    count = roots_limbs_make_odd(under, count, &twos);
    f->over.twos -= twos;
    f->under_bits = roots_limbs_bits(under, count);
    memcpy(multiple, common, (size_t)length * sizeof *multiple);
    memcpy(shared, under, (size_t)count * sizeof *shared);
    int gcd = roots_limbs_gcd(multiple, length, shared, count);
    count = roots_limbs_quotient(under, count, shared, gcd, more);
    if (roots_limbs_bits(common, length) + roots_limbs_bits(more, count) > ROOTS_MOST_BITS) return 0;
    memcpy(multiple, common, (size_t)length * sizeof *multiple);
    return roots_limbs_product(multiple, length, more, count, common);
}

long long roots_fraction_bits(const roots_fraction *f, long long fives, long long twos,
                              const uint64_t *common, int length) {
    return f->over.count ? roots_decimal_bits(&f->over, fives, twos) + roots_limbs_bits(common, length) -
                               f->under_bits + 1
                         : 0;
}

int roots_fraction_limbs(const roots_fraction *f, long long fives, long long twos, const uint64_t *common,
                         int length, uint64_t *limbs) {
    uint64_t over[ROOM], under[ROOM], multiple[ROOM], factor[ROOM];
    int twos_under;
    if (length == 1 && *common == 1) return roots_decimal_limbs(&f->over, fives, twos, limbs);
    int count = roots_limbs_make_odd(under, limbs_under(f, 0, under), &twos_under);
    memcpy(multiple, common, (size_t)length * sizeof *multiple);
    int factors = roots_limbs_quotient(multiple, length, under, count, factor);
    count = roots_decimal_limbs(&f->over, fives, twos, over);
    return roots_limbs_product(over, count, factor, factors, limbs);
}

double roots_fraction_double(const roots_fraction *f) {
    uint64_t over[2 * ROOM], under[2 * ROOM];
    long long fives = f->over.fives;
    if (!f->over.count) return 0;
    int under_count = limbs_under(f, fives < 0 ? -fives : 0, under);
    if (!under_count || roots_decimal_bits(&f->over, fives < 0 ? fives : 0, f->over.twos) > ROOTS_MOST_BITS)
        return INFINITY;
    int count = roots_decimal_limbs(&f->over, fives < 0 ? fives : 0, f->over.twos, over);
    double magnitude = roots_limbs_ratio(over, count, under, under_count, f->over.twos);
    return f->over.negative ? -magnitude : magnitude;
}
