/* cli_equation.h - an equation of the command line, its constants, and what is said of mistakes in them. */
#ifndef CLI_EQUATION_H
#define CLI_EQUATION_H
#include "cli_surface.h"

/* The surface of an equation with the options' constants, and one more before them if its name is not null.
 * Ends the program, in a line that says where and why, if there is none, or if a constant plays no part. */
algsurf_surface *cli_read_equation(const cli_surface *choice, const char *text, const char *name,
                                   double value);

/* Is it a name that a constant may have? */
int cli_is_constant_name(const char *name);

/* Are these the same names, with a Greek letter as itself in one, as a command of LaTeX in the other? */
int cli_is_same_name(const char *a, const char *b);

#endif
