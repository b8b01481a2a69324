/* first_roots.c - fuzzes algsurf_first_roots_batch: "DEGREE", then "LO HI COEFFICIENT ..." for each
 * polynomial.
 *
 * A state is judged by a Sturm chain and must be that of algsurf_isolate_first; the root must be the chain's
 * first; all kernels, and each polynomial alone, must give the same bits.
 */
#include <float.h>

#include "algsurf/intersect.h"
#include "algsurf/isolate.h"
#include "algsurf/batch.h"
#include "exact_roots.h"
#include "fuzz.h"

enum { MOST = 5, TOP = 22, MOST_BITS = 20000 };

static double c[TOP + 1][MOST], lo[MOST], hi[MOST];

typedef struct answers {
    unsigned char state[MOST];
    double root[MOST];
} answers;

static algsurf_real_batch batch_of(int degree, size_t first, size_t count) {
    return (algsurf_real_batch){.size = sizeof(algsurf_real_batch),
                                .count = count,
                                .degree = degree,
                                .coefficients = {c[0] + first, MOST, 1},
                                .lo = lo + first,
                                .hi = hi + first,
                                .interval_step = 1};
}

/* The zero polynomial is refused, and the status says so. */
static int is_zero(int degree, int i) {
    int zero = 1;
    for (int k = 0; k <= degree; k++) zero = zero && c[k][i] == 0;
    return zero;
}

static void solve(int degree, size_t first, size_t count, const char *kernel, answers *to) {
    const algsurf_real_batch packet = batch_of(degree, first, count);
    const algsurf_batch_options options = {.size = sizeof options, .kernel = kernel};
    algsurf_status wanted = ALGSURF_OK;
    for (size_t i = first; i < first + count; i++)
        if (is_zero(degree, (int)i)) wanted = ALGSURF_E_ZERO;
    fuzz_check(algsurf_first_roots_batch(&packet, &options, to->state, to->root) == wanted);
}

static void check_bits(const answers *a, size_t at, const answers *b, size_t count) {
    fuzz_check(memcmp(a->state + at, b->state, count) == 0);
    fuzz_check(memcmp(a->root + at, b->root, count * sizeof *a->root) == 0);
}

static void check_one(int degree, int i, int state, double root) {
    double one[TOP + 1];
    algsurf_bracket b = {0};
    int found = 0;
    for (int k = 0; k <= degree; k++) one[k] = c[k][i];
    if (is_zero(degree, i)) {
        fuzz_check(state == ALGSURF_FIRST_ROOT_REFUSED && root == (double)INFINITY);
        return;
    }
    algsurf_status status = algsurf_isolate_first(one, NULL, degree, lo[i], hi[i], NULL, &b, &found);
    int subnormal = b.lo >= -DBL_MIN && b.hi <= DBL_MIN; /* a packet may tell such a root from 0 */
    if (status == ALGSURF_OK || !subnormal)
        fuzz_check(state == (status != ALGSURF_OK ? ALGSURF_FIRST_ROOT_UNDECIDED : found));
    if (state == ALGSURF_FIRST_ROOT_NONE) fuzz_check(root == (double)INFINITY);
    if (state != ALGSURF_FIRST_ROOT_NONE) fuzz_check(lo[i] <= root && root <= hi[i]);
    if (fuzz_span(one, degree + 1) * degree > MOST_BITS) return;
    exact_sturm s = exact_sturm_of_doubles(one, degree);
    int roots = exact_count_roots(&s, lo[i], hi[i]);
    if (state != ALGSURF_FIRST_ROOT_UNDECIDED && (roots > 0) != state)
        exact_print_doubles("c", one, degree + 1);
    if (state != ALGSURF_FIRST_ROOT_UNDECIDED) fuzz_check((roots > 0) == state);
    if (state == ALGSURF_FIRST_ROOT_FOUND) {
        double exact = exact_root(&s, lo[i], hi[i], 0), error = fabs(root - exact);
        if (!(error <= 1e-12 * (hi[i] - lo[i]) + 0x1p-51 * fabs(exact)))
            exact_print_doubles("c", one, degree + 1);
        fuzz_check(error <= 1e-12 * (hi[i] - lo[i]) + 0x1p-51 * fabs(exact));
    }
    exact_sturm_clear(&s);
}

/* All roots, by every kernel, are those of single calls. */
static void check_all_roots(int degree, int count) {
    static algsurf_real_root found[MOST * TOP], one[TOP];
    const char *kernel;
    int counts[MOST], room = degree > 0 ? degree : 1;
    const algsurf_real_batch packet = batch_of(degree, 0, (size_t)count);
    for (int j = 0; (kernel = algsurf_kernel_name(j)); j++) {
        const algsurf_batch_options options = {.size = sizeof options, .kernel = kernel};
        algsurf_status first = ALGSURF_OK, all = algsurf_real_roots_batch(&packet, &options, found, counts);
        for (int i = 0; i < count; i++) {
            double p[TOP + 1];
            int roots = 0;
            for (int k = 0; k <= degree; k++) p[k] = c[k][i];
            algsurf_status status = algsurf_real_roots(p, degree, lo[i], hi[i], one, TOP, &roots);
            fuzz_check(status == ALGSURF_OK || status == ALGSURF_E_ZERO);
            fuzz_check(counts[i] == (status < 0 ? (int)status : roots));
            if (first == ALGSURF_OK) first = status;
            for (int k = 0; k < roots; k++)
                fuzz_check(memcmp(&one[k], &found[i * room + k], sizeof one[k]) == 0);
        }
        fuzz_check(all == first);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_numbers in = fuzz_numbers_of(data, size);
    int degree = fuzz_whole(&in, 0, TOP), count = 0;
    while (count < MOST && (count == 0 || fuzz_left(&in) > 0)) {
        double a = fuzz_finite(&in), b = fuzz_finite(&in);
        lo[count] = fmin(a, b), hi[count] = fmax(a, b);
        if (lo[count] == hi[count]) lo[count] = 0, hi[count] = 1;
        for (int k = 0; k <= degree; k++) c[k][count] = fuzz_finite(&in);
        count++;
    }
    answers all, other;
    solve(degree, 0, (size_t)count, NULL, &all);
    const char *kernel;
    for (int i = 0; (kernel = algsurf_kernel_name(i)); i++) {
        solve(degree, 0, (size_t)count, kernel, &other);
        check_bits(&all, 0, &other, (size_t)count);
    }
    for (int i = 0; i < count; i++) {
        solve(degree, (size_t)i, 1, NULL, &other);
        check_bits(&all, (size_t)i, &other, 1);
        check_one(degree, i, all.state[i], all.root[i]);
    }
    check_all_roots(degree, count);
    return 0;
}
