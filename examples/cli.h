/* cli.h - what the command lines of the example programs share.
 *
 * A program describes its options in a table; the table drives the parser and --help alike.  Every
 * function here that meets bad input prints one line, "program: what: why", and ends the program:
 * status 2 for bad input, 1 for a broken run (no memory, a file that cannot be read or written).
 */
#ifndef CLI_H
#define CLI_H
#include <stddef.h>
#include <stdio.h>

#include "algsurf/algsurf.h"
#include "cli_text.h"

enum { CLI_BROKEN = 1, CLI_BAD_INPUT = 2 };

#if defined(__MINGW_PRINTF_FORMAT) /* "printf" alone is Microsoft's there */
#define CLI_FORMAT(text, first) __attribute__((format(__MINGW_PRINTF_FORMAT, text, first)))
#elif defined(__GNUC__) || defined(__clang__)
#define CLI_FORMAT(text, first) __attribute__((format(printf, text, first)))
#else
#define CLI_FORMAT(text, first)
#endif

/* One line on standard error, and the end of the program; cli_complain only prints. */
_Noreturn void cli_fail(int status, const char *format, ...) CLI_FORMAT(2, 3);
void cli_complain(const char *format, ...) CLI_FORMAT(1, 2);
_Noreturn void cli_no_memory(void);

/* The end of the program, status 2: one line, then the text and a mark below `length` bytes of it. */
_Noreturn void cli_fail_in(const char *text, size_t offset, size_t length, const char *format, ...)
    CLI_FORMAT(4, 5);

/* ---- options ---- */

typedef struct cli_option {
    const char *name;     /* with its dashes; "": the row is a heading of --help, which is in `help` */
    const char *argument; /* what its value looks like; null: it takes none */
    const char *help;     /* may have several lines */
    void (*set)(const struct cli_option *self, const char *value, void *field);
    size_t offset; /* of the field in the program's own structure of options */
    int low, high; /* range of a whole number (cli_set_int) */
} cli_option;

typedef struct cli_program {
    const char *name, *synopsis, *about;
    const cli_option *options; /* ends with a row of zeros; --help and --version come by themselves */
    size_t positional;         /* offset of the const char * that receives the one plain argument */
    const char *examples;      /* commands, one a line, or null */
} cli_program;

/* A row of the table that is a heading. */
#define CLI_HEADING(text)                                                                                    \
    { "", NULL, text, NULL, 0, 0, 0 }

/* Reads the command line into the structure that the offsets are about.  What begins with a dash and a digit
 * is a plain argument; -h, -V and -o are short for --help, --version and --output. */
void cli_parse(const cli_program *program, int argc, char **argv, void *options);

/* The same for a program that takes any number of plain arguments: they become argv[1], argv[2] ...
 * Returns how many; `positional` plays no part. */
int cli_parse_files(const cli_program *program, int argc, char **argv, void *options);

/* Ends the program: "--name: expected ARGUMENT, got 'value'". */
_Noreturn void cli_expected(const cli_option *option, const char *value);

typedef struct cli_vector {
    double x[3];
    int given;
} cli_vector;

typedef struct cli_extent {
    algsurf_extent extent; /* its centre is not set: --centre is an option of its own */
    int given;
} cli_extent;

typedef struct cli_planes {
    algsurf_plane plane[ALGSURF_MAX_CLIP_PLANES];
    size_t count;
} cli_planes;

/* Setters: the type of the field is in the name or behind it. */
void cli_set_flag(const cli_option *option, const char *value, void *field);      /* int */
void cli_set_int(const cli_option *option, const char *value, void *field);       /* int, low..high */
void cli_set_text(const cli_option *option, const char *value, void *field);      /* const char * */
void cli_set_vector(const cli_option *option, const char *value, void *field);    /* cli_vector */
void cli_set_extent(const cli_option *option, const char *value, void *field);    /* cli_extent */
void cli_set_clip(const cli_option *option, const char *value, void *field);      /* cli_planes, adds one */
void cli_set_method(const cli_option *option, const char *value, void *field);    /* algsurf_method */
void cli_set_tier(const cli_option *option, const char *value, void *field);      /* algsurf_tier */
void cli_set_tolerance(const cli_option *option, const char *value, void *field); /* double */
void cli_set_choice(const cli_option *option, const char *value, void *field);    /* int, cli_choice */

/* Which of the words of an argument "one|two|three" the value is, from 0. */
int cli_choice(const cli_option *option, const char *value);

/* ---- numbers and lines ---- */

/* A number, decimal or hexadecimal, that takes all of the text; inf and nan are numbers here. */
int cli_number(const char *text, double *value);

/* count finite numbers, separated by one character each, that take all of the text. */
int cli_numbers(const char *text, char separator, int count, double *values);

/* A whole number in low..high that takes all of the text: digits only. */
int cli_whole(const char *text, int low, int high, int *value);

typedef struct cli_line {
    char *text; /* without its end, "\n" or "\r\n"; free it when done */
    size_t length, capacity;
    size_t number; /* from 1 */
} cli_line;

typedef enum cli_line_result {
    CLI_LINE_END,
    CLI_LINE_READ,
    CLI_LINE_TOO_LONG,
    CLI_LINE_NO_MEMORY
} cli_line_result;

/* The next line of a file, of at most 64 MiB. */
cli_line_result cli_read_line(FILE *file, cli_line *line);

/* Cuts a line, up to a '#', at blanks and tabs.  Returns the number of fields, of which the first
 * `capacity` are stored; -1 when the line holds a NUL byte. */
int cli_split(cli_line *line, char **fields, int capacity);

/* Ends the program unless everything printed has reached standard output. */
void cli_finish_output(void);

#endif
