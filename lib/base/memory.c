/* memory.c - blocks of words, each at least twice the one before, until the limit is near. */
#include "arithmetic.h"
#include "memory.h"

#include <stdlib.h>

struct algsurf_memory_block {
    algsurf_memory_block *before;
    size_t bytes; /* all of it, with this head */
};

#define SMALLEST_BLOCK ((size_t)64 << 10) /* bytes */

algsurf_memory_mark algsurf_memory_begin(algsurf_memory *m, uint64_t *block, size_t words, size_t limit) {
    m->at = block;
    m->end = block ? block + words : block;
    m->last = NULL;
    m->allocated = 0;
    m->limit = limit;
    return algsurf_memory_here(m);
}

/* A block for `needed` bytes: doubled sizes make the number of blocks logarithmic; when the limit or the
 * system refuse that much, what is needed. */
static algsurf_memory_block *new_block(const algsurf_memory *m, size_t needed, size_t *bytes) {
    size_t left = m->limit > m->allocated ? m->limit - m->allocated : 0;
    if (needed > left) return NULL;
    *bytes = m->last && m->last->bytes <= SIZE_MAX / 2 ? 2 * m->last->bytes : SMALLEST_BLOCK;
    if (*bytes > left) *bytes = left;
    algsurf_memory_block *block = *bytes > needed ? malloc(*bytes) : NULL;
    if (block) return block;
    *bytes = needed;
    return malloc(needed);
}

static int grow(algsurf_memory *m, size_t words) {
    size_t bytes;
    if (words > (SIZE_MAX - sizeof(algsurf_memory_block)) / sizeof(uint64_t)) return 0;
    algsurf_memory_block *block = new_block(m, sizeof *block + words * sizeof(uint64_t), &bytes);
    if (!block) return 0;
    block->before = m->last;
    block->bytes = bytes;
    m->last = block;
    m->allocated += bytes;
    m->at = (uint64_t *)(void *)(block + 1);
    m->end = m->at + (bytes - sizeof *block) / sizeof(uint64_t);
    return 1;
}

uint64_t *algsurf_memory_take(algsurf_memory *m, size_t words) {
    if ((!m->at || (size_t)(m->end - m->at) < words) && !grow(m, words)) return NULL;
    uint64_t *taken = m->at;
    m->at += words;
    return taken;
}

algsurf_memory_mark algsurf_memory_here(const algsurf_memory *m) {
    return (algsurf_memory_mark){m->at, m->end, m->last};
}

void algsurf_memory_release(algsurf_memory *m, algsurf_memory_mark mark) {
    while (m->last != mark.last) {
        algsurf_memory_block *block = m->last;
        m->last = block->before;
        m->allocated -= block->bytes;
        free(block);
    }
    m->at = mark.at;
    m->end = mark.end;
}
