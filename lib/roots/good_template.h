/* good_template.h - checks the numbers of a batch: coefficients finite, lo < hi, radii not negative. */
#ifndef ALGSURF_GOOD_TEMPLATE_H
#define ALGSURF_GOOD_TEMPLATE_H
#include "centred_template.h"

/* The entries times 0 are 0, so they are finite. */
INLINE mask finite_entries(const algsurf_i_polys_job *job, size_t at, int count) {
    words zero = {0}; /* but for signs */
    for (int k = 0; k <= job->degree; k++) {
        zero |= (words)(0 * load_table(&job->c, k, at, count));
        if (job->r.at) zero |= (words)(0 * load_table(&job->r, k, at, count));
    }
    return at_most(absolute((lanes)zero), all_lanes(0));
}

static int good_polys(const algsurf_i_polys_job *job, size_t count) {
    mask good = ~no_lane();
    for (size_t at = 0; at < count; at += LANES) {
        int left = count - at < LANES ? (int)(count - at) : LANES;
        lanes lo, hi;
        load_interval(job, at, left, &lo, &hi);
        good &= less(lo, hi) & at_most(absolute(0 * lo + 0 * hi), all_lanes(0));
        good &= finite_entries(job, at, left);
        for (int k = 0; job->r.at && k <= job->degree; k++)
            good &= at_most(all_lanes(0), load_table(&job->r, k, at, left));
    }
    return bits(good) == (1u << LANES) - 1;
}

#endif
