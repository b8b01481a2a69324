/* base/memory.h - memory for exact arithmetic: a stack of 64-bit words.
 *
 * The first block is the caller's, usually an array on its own stack; when that is used up, blocks are
 * allocated, and freed as soon as nothing in them is in use.  What is taken is given back in reverse order,
 * by a mark.  A limit bounds what is allocated. */
#ifndef ALGSURF_MEMORY_H
#define ALGSURF_MEMORY_H
#include <stddef.h>
#include <stdint.h>

typedef struct algsurf_memory_block algsurf_memory_block;

typedef struct algsurf_memory {
    uint64_t *at, *end;         /* what is free in the newest block */
    algsurf_memory_block *last; /* the allocated blocks, newest first; null: none */
    size_t allocated, limit;    /* bytes */
} algsurf_memory;

/* A state to return to. */
typedef struct algsurf_memory_mark {
    uint64_t *at, *end;
    algsurf_memory_block *last;
} algsurf_memory_mark;

/* A stack that begins with the caller's block of `words` words, and the mark of its beginning. */
algsurf_memory_mark algsurf_memory_begin(algsurf_memory *m, uint64_t *block, size_t words, size_t limit);

/* `words` >= 0 more words, not initialised; null when there is no memory, or the limit is reached. */
uint64_t *algsurf_memory_take(algsurf_memory *m, size_t words);

/* The same in bytes. */
static inline void *algsurf_i_take(algsurf_memory *m, size_t bytes) {
    return algsurf_memory_take(m, (bytes + sizeof(uint64_t) - 1) / sizeof(uint64_t));
}

algsurf_memory_mark algsurf_memory_here(const algsurf_memory *m);

/* Gives back everything taken since the mark; blocks that are empty then are freed.  Releasing to the mark of
 * the beginning frees all of them. */
void algsurf_memory_release(algsurf_memory *m, algsurf_memory_mark mark);
#endif
