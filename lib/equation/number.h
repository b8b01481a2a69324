/* number.h - reading a number exactly, whatever the locale. */
#ifndef ALGSURF_EQUATION_NUMBER_H
#define ALGSURF_EQUATION_NUMBER_H
#include <stddef.h>

#include "../base/eft.h"

/* v 2^exponent, v >= 0, v.hi the nearest double to v. */
typedef struct algsurf_i_number {
    algsurf_dd v;
    int exponent;
} algsurf_i_number;

typedef enum algsurf_i_reading {
    ALGSURF_I_NO_NUMBER,
    ALGSURF_I_NUMBER,
    ALGSURF_I_NUMBER_TOO_LARGE /* beyond 10^400 or 2^2000 */
} algsurf_i_reading;

/* The longest number at the start of text, without sign: digits with an optional point and an
 * optional exponent, decimal (e) or hexadecimal (0x, p).  v.hi is what strtod returns in the "C"
 * locale, as long as that is normal, v itself is right to 2^-104.  Below 10^-400 or 2^-4000: zero.
 * *length becomes the number of characters read.  Cost: linear in it. */
algsurf_i_reading algsurf_i_read_number(const char *text, size_t *length, algsurf_i_number *number);

#endif
