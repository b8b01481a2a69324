/* operations_template.h - what the lanes of a kernel compute with: one function for each operation, which all
 * lanes do at once.  The includer has included avx512.h, avx2.h or baseline.h. */
#include "lanes.h"

#include "operations.h"

/* What all lanes say; NaN if they differ. */
static double common(lanes a) {
    for (int l = 1; l < LANES; l++)
        if (a[l] != a[0]) return NAN;
    return a[0];
}

static double sum(double a, double b) { return common(all_lanes(a) + all_lanes(b)); }
static double product(double a, double b) { return common(all_lanes(a) * all_lanes(b)); }
static double quotient(double a, double b) { return common(all_lanes(a) / all_lanes(b)); }
static double root_of(double a) { return common(root(all_lanes(a))); }
static double product_and_sum(double a, double b, double c) {
    return common(all_lanes(a) * all_lanes(b) + all_lanes(c));
}

static algsurf_dd two_sum(double a, double b) {
    lanes low, high = exact_sum(all_lanes(a), all_lanes(b), &low);
    return (algsurf_dd){common(high), common(low)};
}

static algsurf_dd two_product(double a, double b) {
    lanes low, high = exact_product(all_lanes(a), all_lanes(b), &low);
    return (algsurf_dd){common(high), common(low)};
}

const algsurf_i_operations KERNEL(algsurf_i_operations) = {
    sum, product, quotient, root_of, product_and_sum, NULL, two_sum, two_product};
