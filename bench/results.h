/* results.h - what benchmarks share of their command lines, and the folder that --output names with the files
 * in it. All of these end the program when they cannot do what they are for, and leave no half of a file. */
#ifndef RESULTS_H
#define RESULTS_H
#include <stdio.h>

#include "cli.h"

/* Reads a command line without plain arguments, and makes the folder, which is among the options, if one is
 * given; one that is there already will do. */
void results_begin(const cli_program *program, int argc, char **argv, void *options,
                   const char *const *folder);

/* A file in the folder, opened as fopen does; the end of one that was written. */
FILE *results_open(const char *folder, const char *name, const char *mode);
void results_finish(FILE *file, const char *folder, const char *name);

#endif
