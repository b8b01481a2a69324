/* srgb.c - the bytes of sRGB; see colours.h.
 *
 * The curve is linear next to black and a power of 2.4 above it.  What it makes of the steps is stored, as no
 * libm may decide a byte: tests/test_srgb.c computes it again. */
#include "../base/arithmetic.h"
#include "colours.h"

#include "../base/elementary.h"
#include "../base/fpenv.h"
#include "../base/vec.h"

/* The first step of the bytes 1, 2 ... 255: 255 curve(step / 4095) >= byte - 1/2. */
static const uint16_t first_step[255] = {
    1,    2,    4,    5,    6,    7,    9,    10,   11,   12,   14,   15,   16,   18,   19,   21,   23,
    24,   26,   28,   30,   32,   34,   37,   39,   42,   44,   47,   49,   52,   55,   58,   61,   64,
    68,   71,   74,   78,   82,   85,   89,   93,   97,   102,  106,  110,  115,  119,  124,  129,  134,
    139,  144,  149,  154,  160,  165,  171,  177,  183,  189,  195,  201,  207,  214,  220,  227,  234,
    241,  248,  255,  262,  270,  277,  285,  293,  300,  308,  317,  325,  333,  342,  350,  359,  368,
    377,  386,  395,  405,  414,  424,  434,  444,  454,  464,  474,  485,  495,  506,  517,  528,  539,
    550,  562,  573,  585,  597,  609,  621,  633,  645,  658,  670,  683,  696,  709,  722,  736,  749,
    763,  777,  790,  805,  819,  833,  848,  862,  877,  892,  907,  922,  938,  953,  969,  985,  1001,
    1017, 1033, 1049, 1066, 1083, 1100, 1117, 1134, 1151, 1169, 1186, 1204, 1222, 1240, 1259, 1277, 1296,
    1314, 1333, 1352, 1372, 1391, 1410, 1430, 1450, 1470, 1490, 1510, 1531, 1552, 1572, 1593, 1615, 1636,
    1657, 1679, 1701, 1723, 1745, 1767, 1790, 1812, 1835, 1858, 1881, 1904, 1928, 1951, 1975, 1999, 2023,
    2048, 2072, 2097, 2122, 2146, 2172, 2197, 2222, 2248, 2274, 2300, 2326, 2352, 2379, 2406, 2433, 2460,
    2487, 2514, 2542, 2570, 2597, 2626, 2654, 2682, 2711, 2740, 2769, 2798, 2827, 2857, 2886, 2916, 2946,
    2977, 3007, 3038, 3068, 3099, 3130, 3162, 3193, 3225, 3257, 3289, 3321, 3354, 3386, 3419, 3452, 3485,
    3518, 3552, 3586, 3620, 3654, 3688, 3722, 3757, 3792, 3827, 3862, 3897, 3933, 3969, 4005, 4041, 4077,
};

/* The byte of a step, which is `byte` or more. */
static int byte_of_step(int step, int byte) {
    while (byte < 255 && first_step[byte] <= step) byte++;
    return byte;
}

void algsurf_i_srgb_curve(uint8_t curve[SRGB_STEPS]) {
    int byte = 0;
    for (int step = 0; step < SRGB_STEPS; step++) {
        byte = byte_of_step(step, byte);
        curve[step] = (uint8_t)byte;
    }
}

ALGSURF_I_ENTRY(algsurf_status, srgb_encode, (const double colour[3], unsigned char bytes[3]),
                (colour, bytes)) {
    if (!colour || !bytes) return ALGSURF_E_ARGUMENT;
    if (!algsurf_is_finite3(colour)) return ALGSURF_E_NOT_FINITE;
    for (int k = 0; k < 3; k++) {
        float light = colour[k] < 0 ? 0 : colour[k] > 1 ? 1 : (float)colour[k];
        bytes[k] = (unsigned char)byte_of_step(algsurf_i_srgb_step(light), 0);
    }
    return ALGSURF_OK;
}

ALGSURF_I_ENTRY(algsurf_status, srgb_decode, (const unsigned char bytes[3], double colour[3]),
                (bytes, colour)) {
    if (!colour || !bytes) return ALGSURF_E_ARGUMENT;
    for (int k = 0; k < 3; k++) {
        double shown = bytes[k] / 255.0;
        colour[k] = shown <= 0.04045 ? shown / 12.92 : algsurf_i_pow((shown + 0.055) / 1.055, 2.4);
    }
    return ALGSURF_OK;
}
