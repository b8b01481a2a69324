/* test_memory_stack.c - the stack of words for exact arithmetic.
 *
 * Breaks caught: words handed out twice, a block that is not freed (the sanitizer's run) or freed too early
 * (its words change), a limit that is passed, a size that overflows. */
#include "exact.h"

#include "base/memory.h"
#include "unit.h"

#define SEED 20240611u
#define LIMIT ((size_t)1 << 24)
#define DEPTH 64

typedef struct piece {
    uint64_t *at, value;
    size_t words;
    algsurf_memory_mark before;
} piece;

static void check_piece(const piece *p, int round) {
    for (size_t i = 0; i < p->words; i++)
        if (p->at[i] != p->value + i) fail_msg("seed %u, round %d: a word has changed", SEED, round);
}

/* Pieces are taken and given back at random; each keeps what was written to it. */
TEST(test_pieces_keep_their_words) {
    uint64_t seed = SEED, first[300];
    algsurf_memory m;
    algsurf_memory_begin(&m, first, 300, LIMIT);
    algsurf_memory_mark start = algsurf_memory_here(&m);
    piece pieces[DEPTH];
    int depth = 0, grown = 0, emptied = 0;
    for (int round = 0; round < 20000; round++) {
        if (depth < DEPTH && random_int(&seed, 2)) {
            piece *p = pieces + depth++;
            size_t most = random_int(&seed, 20) ? 100 : 30000;
            size_t before = m.allocated;
            p->before = algsurf_memory_here(&m);
            p->words = (size_t)random_int(&seed, (int)most);
            p->at = algsurf_memory_take(&m, p->words);
            assert_non_null(p->at);
            assert_int_equal((uintptr_t)p->at % sizeof(uint64_t), 0);
            p->value = random_bits(&seed);
            for (size_t i = 0; i < p->words; i++) p->at[i] = p->value + i;
            grown += m.allocated > before;
        } else if (depth > 0) {
            int keep = depth - 1 - random_int(&seed, depth < 4 ? depth : 4);
            for (int i = keep; i < depth; i++) check_piece(pieces + i, round);
            algsurf_memory_release(&m, pieces[keep].before);
            depth = keep;
            emptied += depth == 0;
            if (depth == 0) assert_int_equal(m.allocated, 0);
        }
        assert_true(m.allocated <= LIMIT);
    }
    for (int i = 0; i < depth; i++) check_piece(pieces + i, -1);
    algsurf_memory_release(&m, start);
    assert_int_equal(m.allocated, 0);
    assert_null(m.last);
    assert_ptr_equal(m.at, first);
    assert_true(grown > 100 && emptied > 100);
}

/* The first block is used up before anything is allocated; blocks double. */
TEST(test_blocks) {
    uint64_t first[10];
    algsurf_memory m;
    algsurf_memory_begin(&m, first, 10, LIMIT);
    algsurf_memory_mark start = algsurf_memory_here(&m);
    assert_ptr_equal(algsurf_memory_take(&m, 4), first);
    assert_ptr_equal(algsurf_memory_take(&m, 6), first + 4);
    assert_non_null(algsurf_memory_take(&m, 0));
    assert_int_equal(m.allocated, 0);
    assert_non_null(algsurf_memory_take(&m, 1));
    assert_true(m.allocated >= 64 << 10);
    int blocks = 0;
    for (size_t before = m.allocated; blocks < 5;) {
        assert_non_null(algsurf_memory_take(&m, 100));
        if (m.allocated == before) continue;
        assert_true(m.allocated - before > before / 2);
        before = m.allocated;
        blocks++;
    }
    algsurf_memory_release(&m, start);
    assert_int_equal(m.allocated, 0);
}

/* All that the limit allows can be taken, and no more; then it is as before. */
TEST(test_limit) {
    static const size_t limits[] = {0, 8, 4096, 100000, 1 << 20};
    for (size_t l = 0; l < sizeof limits / sizeof *limits; l++)
        for (size_t words = 1; words < 20000; words = 3 * words + 1) {
            uint64_t first[3];
            size_t count = 0;
            algsurf_memory m;
            algsurf_memory_begin(&m, first, 3, limits[l]);
            algsurf_memory_mark start = algsurf_memory_here(&m);
            while (algsurf_memory_take(&m, words)) count += words;
            assert_true(m.allocated <= limits[l]);
            assert_true(count * 8 <= limits[l] + sizeof first);
            if (words == 1 && limits[l] >= 4096) assert_true(count * 8 > limits[l] / 10 * 9);
            assert_null(algsurf_memory_take(&m, words)); /* still */
            algsurf_memory_release(&m, start);
            assert_int_equal(m.allocated, 0);
            assert_non_null(algsurf_memory_take(&m, 3));
        }
}

TEST(test_no_first_block_and_sizes_beyond) {
    algsurf_memory m;
    algsurf_memory_begin(&m, NULL, 0, LIMIT);
    algsurf_memory_mark start = algsurf_memory_here(&m);
    assert_non_null(algsurf_memory_take(&m, 0));
    assert_non_null(algsurf_memory_take(&m, 10));
    assert_null(algsurf_memory_take(&m, SIZE_MAX));
    assert_null(algsurf_memory_take(&m, SIZE_MAX / 8));
    assert_null(algsurf_memory_take(&m, SIZE_MAX / 8 + 2));
    assert_non_null(algsurf_memory_take(&m, 10));
    algsurf_memory_release(&m, start);
    assert_int_equal(m.allocated, 0);
}
