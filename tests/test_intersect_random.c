/* test_intersect_random.c - random rays of random surfaces, every state judged by a Sturm chain.
 *
 * Breaks caught, each tried: a sign used inside its bound, an undecided cell taken for a hit, an interval
 * moved off its root, the final Newton step left out, the middle of the chord without its rounding error, a
 * first hit undecided that swallows the hit behind it, an ever-undecided tier; the isolating interval for
 * [t_lo,t_hi].
 */
#include "intersect_case.h"

#define SEED 41u

static intersect_case c;
static intersect_answer answer;

static void random_ray(uint64_t *seed, int bits) {
    double eye = random_int(seed, 4) ? 4 : 0;
    for (int i = 0; i < 3; i++) {
        c.ray.direction[i] = random_int(seed, 8) ? random_short(seed, bits) : 0;
        c.ray.origin[i] = random_short(seed, bits);
    }
    if (c.ray.direction[0] == 0 && c.ray.direction[1] == 0) c.ray.direction[2] = 1;
    for (int i = 0; i < 3; i++) c.ray.origin[i] -= eye * c.ray.direction[i];
    c.ray.t_min = random_int(seed, 3) ? 0 : -1;
    c.ray.t_max = random_int(seed, 3) ? eye + 4 : 1e4;
}

/* Is the polynomial along the ray zero? */
static int in_the_surface(void) {
    exact_sturm s = exact_sturm_along(c.terms, c.count, c.degree, &c.ray);
    int zero = s.count == 0;
    exact_sturm_clear(&s);
    return zero;
}

static void judge_family(int rounds, int most_degree, int bits, int small, int least_certain) {
    uint64_t seed = SEED;
    int done = 0, certain = 0, hits = 0, precise = 0, narrow = 0, measured = 0;
    for (int i = 0; i < rounds; i++) {
        if (i % 4 == 0 && !intersect_random(&c, &seed, 2 + random_int(&seed, most_degree - 1), small)) {
            i += 3;
            continue;
        }
        random_ray(&seed, bits);
        if (in_the_surface()) continue;
        intersect_judge(&c, NULL, &answer);
        done++, certain += answer.first.state != ALGSURF_STATE_UNDECIDED,
            hits += answer.first.state == ALGSURF_STATE_HIT;
        if (answer.first.state == ALGSURF_STATE_HIT && i % 8 == 0) {
            exact_line line = exact_line_of(c.terms, c.count, c.degree, &c.ray);
            exact_sturm s = exact_sturm_of(line.c, c.degree);
            double width = HUGE_VAL, error = intersect_error(&c, &line, &s, &answer.first, &width);
            measured++, precise += error < 8, narrow += width <= 6 * (5 * c.degree + 8) + 8;
            if (error > 1000) intersect_fail("far from the root", &c, &answer);
            exact_sturm_clear(&s), exact_line_clear(&line);
        }
    }
    if (hits * 5 < done || certain * 100 < done * least_certain || precise * 100 < measured * 99 ||
        narrow * 100 < measured * 97)
        fail_msg("seed %u: %d rays, %d certain, %d hits, of %d %d precise, %d in a narrow interval", SEED,
                 done, certain, hits, measured, precise, narrow);
}

TEST(test_low_degrees) { judge_family(2000, 5, 53, 0, 99); }

TEST(test_high_degrees) {
    judge_family(1250, 12, 16, 0, 97); /* some surfaces have coordinate planes as double factors */
}

TEST(test_high_degrees_all_bits) { judge_family(200, 12, 53, 0, 97); }

/* Tangencies, double factors, roots at ends, exact multiple roots. */
TEST(test_small_integers) { judge_family(1500, 6, 2, 1, 80); }
