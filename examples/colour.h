/* colour.h - colours by name or by number, as style sheets write them: "teal", "#08f", "#0088ff". */
#ifndef COLOUR_H
#define COLOUR_H
#include <stdint.h>

#include "cli.h"

typedef struct css_colour {
    uint8_t srgb[3]; /* red, green, blue */
    int given;
} css_colour;

/* Returns 0 when the text is no colour; capitals are as small letters. */
int colour_read(const char *text, css_colour *c);

/* A setter for a colour. */
void colour_set(const cli_option *option, const char *value, void *field);

/* As the library takes colours: in linear light. */
void colour_of(const css_colour *c, double rgb[3]);

#endif
