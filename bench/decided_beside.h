/* decided_beside.h - the answers of another edition of the library, made by the script beside. */
#ifndef DECIDED_BESIDE_H
#define DECIDED_BESIDE_H
#include "beside.h"
#include "decided_cases.h"

/* A shared object of beside.c; ends the program when the file is none. */
const beside_edition *beside_load(const char *file);

/* That edition's copy of the example's surface; free it with its surface_free. */
algsurf_surface *beside_surface(const beside_edition *other, const example *e);

/* How many rays it leaves undecided, and of how many it says what is wrong. */
void beside_judge(const beside_edition *other, const example *e, const algsurf_surface *surface,
                  size_t *undecided, size_t *wrong);

#endif
