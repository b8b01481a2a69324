/* options.h - reading a caller's struct that starts with its own size, and numbers with a range.
 *
 * Such a struct may be newer than the library: larger, and accepted if the part unknown here is all 0, hence
 * asks for defaults.  A smaller one is refused: no release has had one, for this is the first.  One above
 * ALGSURF_I_LARGEST_STRUCT is refused unread: its size was never set.
 */
#ifndef ALGSURF_OPTIONS_H
#define ALGSURF_OPTIONS_H
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "algsurf/status.h"

#define ALGSURF_I_LARGEST_STRUCT 4096 /* bytes */

/* Is the size that *given begins with one of a struct that holds known_size bytes? */
static inline int algsurf_options_fit(const void *given, size_t known_size) {
    size_t size;
    memcpy(&size, given, sizeof size);
    return size >= known_size && size <= ALGSURF_I_LARGEST_STRUCT;
}

/* Copies *given, a struct whose first member is its size, into the `known_size` bytes at `known`,
 * whose own size member then is known_size.  Returns OK; E_ARGUMENT (null), or E_SIZE when the size does not
 * fit or the unknown tail is not zero: then `known` is untouched. */
static inline algsurf_status algsurf_options_read(void *known, size_t known_size, const void *given) {
    size_t size;
    if (!given) return ALGSURF_E_ARGUMENT;
    memcpy(&size, given, sizeof size);
    if (!algsurf_options_fit(given, known_size)) return ALGSURF_E_SIZE;
    for (size_t i = known_size; i < size; i++)
        if (((const unsigned char *)given)[i] != 0) return ALGSURF_E_SIZE;
    memcpy(known, given, known_size);
    memcpy(known, &known_size, sizeof known_size);
    return ALGSURF_OK;
}

/* Copies the `known_size` bytes at `known` into *given, whose size fits: the size stays, what is
 * unknown here becomes 0. */
static inline void algsurf_options_write(void *given, const void *known, size_t known_size) {
    size_t size;
    memcpy(&size, given, sizeof size);
    memset(given, 0, size);
    memcpy(given, known, known_size);
    memcpy(given, &size, sizeof size);
}

/* OK, or E_NOT_FINITE; else E_ARGUMENT: it is not in its range. */
static inline algsurf_status algsurf_i_check_number(double x, int in_range) {
    if (!isfinite(x)) return ALGSURF_E_NOT_FINITE;
    return in_range ? ALGSURF_OK : ALGSURF_E_ARGUMENT;
}

/* An interval whose ends may be infinite: OK; E_NOT_FINITE for NaN, E_ARGUMENT for lo > hi. */
static inline algsurf_status algsurf_i_check_interval(double lo, double hi) {
    if (isnan(lo) || isnan(hi)) return ALGSURF_E_NOT_FINITE;
    return lo <= hi ? ALGSURF_OK : ALGSURF_E_ARGUMENT;
}

#endif
