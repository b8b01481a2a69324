/* peers.h - what the parts of the comparison of pictures with other software share. */
#ifndef PEERS_H
#define PEERS_H
#include "contest.h"

/* Where the programs are; null: not here. */
typedef struct peers_programs {
    const char *povray, *surf;
    const char *work; /* a folder to work in */
} peers_programs;

/* Draws the surfaces, a list that ends with a null, in so many takes. */
void peers_pictures(const char *const *surfaces, int takes, const peers_programs *programs,
                    contest_table *table);

#endif
