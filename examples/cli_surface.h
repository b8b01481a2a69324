/* cli_surface.h - the surface on a command line: a name of the catalogue, an equation or a file of SURFER as
 * a plain argument, --equation TEXT, constants for it, or --terms FILE. */
#ifndef CLI_SURFACE_H
#define CLI_SURFACE_H
#include "cli.h"
#include "jsurf_file.h"

/* A constant of the equation, or a sum with x, y, z; its value is an expression in those before it. */
typedef struct cli_let {
    char *name, *value;
    int from_file; /* of SURFER: options come before it */
} cli_let;

typedef struct cli_surface {
    const char *name, *equation, *terms; /* exactly one of them is set */
    cli_let *lets;
    size_t let_count;
    jsurf_file *file; /* of SURFER, from which the equation is; null: from none */
    const char *path; /* of the file that is read; null: none is */
    int rounded;      /* --coefficients: answers allow for the rounding of the equation's */
} cli_surface;

void cli_set_let(const cli_option *option, const char *value, void *field); /* cli_surface */

/* clang-format off */
/* The rows of the option table for the member `surface` of a structure. */
#define CLI_SURFACE_OPTIONS(type)                                                                            \
    {"--equation", "TEXT", "the equation of the surface; the same as a plain argument", cli_set_text,        \
     offsetof(type, surface.equation), 0, 0},                                                                \
    {"--let", "A=VALUE",                                                                                     \
     "gives a letter of the equation a value: a number, or an expression such as\n"                          \
     "(1+sqrt(5))/2, in which letters given before may occur, and x, y, z, as in\n"                          \
     "w=y^2+z^2; repeatable, or A=1,B=2",                                                                    \
     cli_set_let, offsetof(type, surface), 0, 0},                                                            \
    {"--terms", "FILE", "reads the surface from a file, a line \"i j k a\" for each term a x^i y^j z^k",     \
     cli_set_text, offsetof(type, surface.terms), 0, 0},                                                     \
    {"--coefficients", "exact|rounded",                                                                      \
     "how to take coefficients that no double is equal to, as 0.1 and sqrt(2).\n"                            \
     "exact (default): the nearest doubles are the surface; all is proved for them.\n"                       \
     "rounded: all is proved for the equation as it is written; rays for which the\n"                        \
     "rounding matters are counted as undecided", cli_set_choice,                                            \
     offsetof(type, surface.rounded), 0, 0}
/* clang-format on */

/* Tells whether the plain argument is a name, an equation or a file, and reads the file; to be called when
 * the command line is read. */
void cli_settle_surface(cli_surface *choice);

/* Makes the surface that was asked for; ends the program when there is none. */
algsurf_surface *cli_make_surface(const cli_surface *choice);

/* The same with one constant more, before all others. */
algsurf_surface *cli_make_surface_with(const cli_surface *choice, const char *name, double value);

/* Releases what the options hold. */
void cli_forget_surface(cli_surface *choice);

#endif
