/* cli_text.h - text of a user's, shown back: UTF-8, a character for each character, nothing that moves the
 * cursor or turns the line around. */
#ifndef CLI_TEXT_H
#define CLI_TEXT_H
#include <stddef.h>
#include <stdio.h>

/* Fit to be quoted in one line: shortened, with a replacement for what cannot be shown. */
typedef struct cli_quoted {
    char text[64];
} cli_quoted;
cli_quoted cli_quote(const char *text);

/* The first `length` bytes, to be freed; ends the program if there is no memory. */
char *cli_copy(const char *text, size_t length);

/* The column, from 1, of the character that begins so many bytes into the text. */
size_t cli_column(const char *text, size_t offset);

/* Two lines: the text, or the part of it that fits, and marks below `length` bytes of it, one at least. */
void cli_point_at(FILE *file, const char *text, size_t offset, size_t length);

#endif
