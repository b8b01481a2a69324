/* surfaces.h - the surfaces that a benchmark measures: those of its options --surface, or its usual ones. */
#ifndef SURFACES_H
#define SURFACES_H
#include "catalogue.h"
#include "cli.h"

enum { SURFACES_ROOM = 64 };

typedef struct surface_list {
    int most; /* of them, at most SURFACES_ROOM; one more ends the program */
    int count;
    const catalogue_entry *entry[SURFACES_ROOM];
} surface_list;

/* Adds a surface, at the end. */
void surfaces_add(surface_list *list, const catalogue_entry *entry);

/* Adds those of the catalogue with these names. */
void surfaces_add_named(surface_list *list, const char *const *names, size_t count);

/* A setter of an option "--surface NAME": adds it to the surface_list. */
void surfaces_set(const cli_option *option, const char *value, void *field);

#endif
