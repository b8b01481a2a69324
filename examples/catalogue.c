/* catalogue.c - see catalogue.h.
 *
 * Sources: Chuyeshov, Visualization of algebraic surfaces, 2005; Sanjuan-Estrada, Casado, Garcia,
 * Rendering (complex) algebraic surfaces; Apery, Models of the real projective plane, 1987 (Boy's
 * surface); Barth, Two projective surfaces with many nodes, 1996; Labs, A septic with 99 real nodes, 2006;
 * Chmutov, Examples of projective surfaces with many singularities, 1992.
 *
 * The golden ratio p = (1+sqrt(5))/2 comes in powers: p^2 = (3+sqrt(5))/2, p^4 = (7+3sqrt(5))/2,
 * 1+2p = 2+sqrt(5), 3+5p = (11+5sqrt(5))/2, 2-p = (3-sqrt(5))/2.
 *
 * Labs' septic has the real root a of 7a^3 + 7a + 1 = 0, -0.1401068549871247764542..., in 50 - 7a + 49a^2 and
 * -(56 + 384a + 84a^2)/49, -(196 - 24a + 224a^2)/49, -(196 - 24a + 196a^2)/49, -(56 - 8a + 56a^2)/49, written
 * to 20 decimals.  Chmutov's octic is T8(x) + T8(y) + T8(z) + 1, T8 Chebyshev's polynomial, with 144 nodes.
 */
#include "catalogue.h"

#include <string.h>

/* clang-format off */
#define BALL(radius) {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {radius, 0, 0}}
#define UP {0, 0, 1}
/* clang-format on */

#define TANGLE "x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8"

#define BARTH                                                                                                \
    "4((3+sqrt(5))/2*x^2 - y^2)((3+sqrt(5))/2*y^2 - z^2)((3+sqrt(5))/2*z^2 - x^2)"                           \
    " - (2+sqrt(5))(x^2+y^2+z^2-1)^2"

#define DECIC                                                                                                \
    "8(x^2 - (7+3sqrt(5))/2*y^2)(y^2 - (7+3sqrt(5))/2*z^2)(z^2 - (7+3sqrt(5))/2*x^2)"                        \
    "(x^4+y^4+z^4 - 2x^2 y^2 - 2x^2 z^2 - 2y^2 z^2)"                                                         \
    " + (11+5sqrt(5))/2*(x^2+y^2+z^2-1)^2 (x^2+y^2+z^2 - (3-sqrt(5))/2)^2"

#define BOY                                                                                                  \
    "64(1-z)^3 z^3 - 48(1-z)^2 z^2 (3x^2+3y^2+2z^2)"                                                         \
    " + 12(1-z)z(27(x^2+y^2)^2 - 24z^2 (x^2+y^2) + 36sqrt(2) y z (y^2-3x^2) + 4z^4)"                         \
    " + (9x^2+9y^2-2z^2)(-81(x^2+y^2)^2 - 72z^2 (x^2+y^2) + 108sqrt(2) x z (x^2-3y^2) + 4z^4)"

#define LABS                                                                                                 \
    "x(x^6 - 21x^4 y^2 + 35x^2 y^4 - 7y^6)"                                                                  \
    " + 7z((x^2+y^2)^3 - 8z^2 (x^2+y^2)^2 + 16z^4 (x^2+y^2)) - 64z^7"                                        \
    " - (z + 51.94261459481465076650)((z+1)(x^2+y^2) - 0.07852820149698521536z^3"                            \
    " - 4.15836059228801701763z^2 - 4.14714348896551232572z - 1.18816593807147873508)^2"

#define CHMUTOV "(2(2(2x^2-1)^2-1)^2-1) + (2(2(2y^2-1)^2-1)^2-1) + (2(2(2z^2-1)^2-1)^2-1) + 1"

/* Colours of both sides in linear light: equally light in grey, L* = 72, so that brightness tells of form
 * alone; the pairs differ for eyes without red or green receptors, too, but for TEAL, whose other side is
 * seldom seen. */
/* clang-format off */
#define BLUE {0.14, 0.46, 1.00}, {0.92, 0.36, 0.06}
#define VIOLET {0.46, 0.38, 0.95}, {0.71, 0.40, 0.04}
#define SLATE {0.32, 0.46, 0.65}, {0.96, 0.32, 0.14}
#define COPPER {0.96, 0.32, 0.14}, {0.32, 0.46, 0.65}
#define LEAF {0.27, 0.52, 0.12}, {0.71, 0.32, 0.79}
#define PLUM {0.71, 0.32, 0.79}, {0.27, 0.52, 0.12}
#define TEAL {0.07, 0.54, 0.55}, {0.99, 0.30, 0.20}

const catalogue_entry catalogue[] = {
    /* name, degree, equation, extent, eye, point looked at, up, field of view, colours outside, inside */
    {"sphere", 2, "x^2 + y^2 + z^2 - 1", BALL(1.2),
     {2.93, -3.60, 2.14}, {0, 0, 0}, UP, 25, BLUE},
    {"whitney", 3, "x^2 z + y^2", BALL(2),
     {5.263, -2.382, 1.736}, {0.382, 0.059, -0.705}, UP, 25, BLUE},
    {"steiner", 4, "x^2 y^2 + x^2 z^2 + y^2 z^2 + x y z", BALL(0.8),
     {1.03, -1.79, 1.17}, {-0.01, 0.02, 0.05}, UP, 25, COPPER},
    {"chair", 4, "(x^2+y^2+z^2 - 0.95*5^2)^2 - 0.8((z-5)^2 - 2x^2)((z+5)^2 - 2y^2)", BALL(6),
     {15.9, -18, 7}, {-0.05, -0.03, 0.03}, UP, 25, LEAF},
    {"tangle", 4, TANGLE, BALL(3.7),
     {6.12, -12.51, 7.19}, {-0.05, -0.16, -0.22}, UP, 25, TEAL},
    {"boy", 6, BOY, {ALGSURF_EXTENT_SPHERE, {0, 0, 1}, {1.9, 0, 0}},
     {-0.395, 0.884, -4.559}, {0.16, 0.051, 0.992}, {0, 1, 0}, 25, BLUE},
    {"barth", 6, BARTH, BALL(2),
     {8.33, -5.15, 0.52}, {0, 0, 0}, UP, 25, BLUE},
    {"barth-sextic", 6, BARTH, BALL(2),
     {8.33, -5.15, 0.52}, {0, 0, 0}, UP, 25, BLUE},
    {"tanglecube", 4, TANGLE, BALL(3.7),
     {12.05, -6.5, 8.77}, {0.15, 0.04, -0.16}, UP, 25, SLATE},
    {"barth-decic", 10, DECIC, BALL(2),
     {6.08, -6.08, 5.17}, {0, 0, 0}, UP, 25, BLUE},
    {"cusp", 3, "z^3 + x z + y", BALL(2),
     {-7.033, 2.384, 3.92}, {-0.171, 0.031, -0.296}, UP, 25, VIOLET},
    {"torus", 4, "(x^2+y^2+z^2 - 0.9^2 - 2.5^2)^2 - 4*2.5^2*(0.9^2 - z^2)", BALL(3.6),
     {5.43, -9.05, 6.76}, {0.12, -0.19, -0.33}, UP, 25, COPPER},
    {"pillow", 4, "x^4 + y^4 + z^4 - (x^2+y^2+z^2)", BALL(1.9),
     {4.03, -5.89, 3.24}, {0, -0.07, -0.12}, UP, 25, PLUM},
    {"lemniscate", 4, "(x^2+y^2+z^2)^2 - 2*2.7^2*(x^2 - y^2 - z^2)", BALL(4),
     {3.39, -12.35, 4.25}, {0.16, 0.02, -0.06}, UP, 25, VIOLET},
    {"bicube", 4, "x^4 + y^4 + z^4 - 1", BALL(1.5),
     {3.028, -4.582, 2.745}, {0, -0.041, -0.067}, UP, 25, SLATE},
    {"labs", 7, LABS, BALL(5),
     {16.35, -14.02, 8.86}, {0.14, -0.12, -0.41}, UP, 25, BLUE},
    {"chmutov", 8, CHMUTOV, BALL(1.75),
     {3.773, -5.558, 3.186}, {0.004, -0.074, -0.127}, UP, 25, SLATE},
    {.name = NULL}};
/* clang-format on */

const catalogue_entry *catalogue_find(const char *name) {
    for (const catalogue_entry *entry = catalogue; entry->name; entry++)
        if (strcmp(entry->name, name) == 0) return entry;
    return NULL;
}

const catalogue_entry *catalogue_first_of(const catalogue_entry *entry) {
    const catalogue_entry *first = catalogue;
    while (strcmp(first->equation, entry->equation) != 0) first++;
    return first;
}
