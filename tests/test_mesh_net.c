/* test_mesh_net.c - the net that separates inner from outer points of a lattice: a closed manifold, whatever
 * the signs.
 *
 * Catches: a face that two cells read differently, an ambiguous face that leaves four quads at an edge, a
 * sheet that is joined to another one or split, quads turned to the wrong side. */
#include "mesh_net.h"
#include "random.h"
#include "unit.h"

enum { MOST = 8, POINTS = MOST + 1, LAYER = POINTS * POINTS, QUADS = 3 * POINTS * LAYER };
static const uint64_t SEED = 20261128;

static uint64_t state;

static unsigned next_random(void) { return (unsigned)(random_bits(&state) >> 33); }

typedef struct net {
    mesh_quad quad[QUADS];
    size_t count;
    uint32_t sheets;
} net;

static mesh_table table;
static net made;

static int take(const mesh_quad *quad, void *data) {
    net *n = data;
    n->quad[n->count++] = *quad;
    return n->count < QUADS;
}

/* The quads of a lattice of n^3 cells; signs: bit 0 of each point. */
static void make_net(int n, unsigned char signs[POINTS][LAYER]) {
    mesh_slab slab[2] = {{0}, {0}};
    made.count = 0;
    made.sheets = 0;
    for (int s = 0; s < n; s++) {
        const unsigned char *layer[4];
        mesh_slab *now = &slab[s % 2];
        for (int k = 0; k < 4; k++) layer[k] = s - 1 + k >= 0 && s - 1 + k <= n ? signs[s - 1 + k] : NULL;
        assert_true(mesh_slab_fill(&table, n, n, layer, 1, now));
        now->base = made.sheets;
        made.sheets += now->sheets;
        assert_true(
            mesh_slab_quads(&table, n, n, layer + 1, 1, s > 0 ? &slab[1 - s % 2] : NULL, now, take, &made));
    }
    mesh_slab_free(&slab[0]);
    mesh_slab_free(&slab[1]);
}

/* The quad's corners anticlockwise as seen from outside. */
static void turn(const mesh_quad *q, int lower_inside, uint32_t corner[4]) {
    for (int k = 0; k < 4; k++) corner[k] = q->point[lower_inside ? k : 3 - k];
}

typedef struct edge {
    uint32_t from, to, face;
} edge;

static int compare(const void *a, const void *b) {
    const edge *p = a, *q = b;
    if (p->from != q->from) return p->from < q->from ? -1 : 1;
    return p->to < q->to ? -1 : p->to > q->to;
}

static const edge *find(const edge *edges, size_t count, uint32_t from, uint32_t to) {
    const edge key = {from, to, 0};
    return bsearch(&key, edges, count, sizeof key, compare);
}

/* How many quads have the sheet, and how many one meets going around it from one of them. */
static void check_around(uint32_t sheet, const edge *edges, size_t count, uint32_t corners[][4]) {
    size_t degree = 0, met = 0;
    const edge *first = edges;
    while (first < edges + count && first->from < sheet) first++;
    while (first + degree < edges + count && first[degree].from == sheet) degree++;
    assert_true(degree >= 3);
    uint32_t face = first->face;
    do { /* over the edge that comes in to the quad on its other side */
        int k = 0;
        while (corners[face][k] != sheet) k++;
        const edge *next = find(edges, count, sheet, corners[face][(k + 3) % 4]);
        assert_non_null(next);
        face = next->face;
        met++;
    } while (face != first->face && met <= degree);
    if (met != degree) fail_msg("sheet %u: %zu of %zu quads", sheet, met, degree);
}

/* Each edge once in each direction, each sheet a disc of quads.  Returns Euler's number. */
static long check_manifold(int n, unsigned char signs[POINTS][LAYER]) {
    static edge edges[4 * QUADS];
    static uint32_t corners[QUADS][4];
    size_t count = 0;
    size_t at = 0; /* the quad of each crossed edge, in their order */
    for (int k = 0; k < n; k++)
        for (int j = 0; j < n; j++)
            for (int i = 0; i < n; i++) {
                const unsigned char *low = signs[k], *high = signs[k + 1];
                const int p = j * (n + 1) + i, here = low[p];
                const int next[3] = {low[p + 1], low[p + n + 1], high[p]};
                for (int axis = 0; axis < 3; axis++) {
                    if (here == next[axis]) continue;
                    assert_true(at < made.count && made.quad[at].axis == axis && made.quad[at].at[0] == i &&
                                made.quad[at].at[1] == j);
                    turn(&made.quad[at], here, corners[at]);
                    at++;
                }
            }
    assert_int_equal(at, made.count);
    for (size_t q = 0; q < made.count; q++)
        for (int k = 0; k < 4; k++)
            edges[count++] = (edge){corners[q][k], corners[q][(k + 1) % 4], (uint32_t)q};
    qsort(edges, count, sizeof *edges, compare);
    for (size_t i = 0; i < count; i++) {
        if (i > 0 && compare(&edges[i - 1], &edges[i]) == 0)
            fail_msg("edge %u to %u: twice; seed %llu", edges[i].from, edges[i].to, (unsigned long long)SEED);
        if (!find(edges, count, edges[i].to, edges[i].from))
            fail_msg("edge %u to %u: one side; seed %llu", edges[i].from, edges[i].to,
                     (unsigned long long)SEED);
    }
    for (uint32_t sheet = 0; sheet < made.sheets; sheet++) check_around(sheet, edges, count, corners);
    return (long)made.sheets - (long)count / 2 + (long)made.count;
}

/* Signs in the interior, 1 with a probability in percent; the border is outside. */
static void fill(int n, unsigned char signs[POINTS][LAYER], unsigned percent) {
    memset(signs, 0, POINTS * LAYER);
    for (int k = 1; k < n; k++)
        for (int j = 1; j < n; j++)
            for (int i = 1; i < n; i++) signs[k][j * (n + 1) + i] = next_random() % 100 < percent;
}

static unsigned char signs[POINTS][LAYER];

TEST(test_each_cell) { /* each of the 256 cells, in the middle of outer points */
    mesh_table_make(&table);
    for (int inside = 0; inside < 256; inside++) {
        memset(signs, 0, sizeof signs);
        for (int c = 0; c < 8; c++)
            signs[1 + (c >> 2)][(1 + (c >> 1 & 1)) * 4 + 1 + (c & 1)] = inside >> c & 1;
        make_net(3, signs);
        (void)check_manifold(3, signs);
    }
}

TEST(test_pairs_of_cells) { /* all of 12 points, so that each ambiguous face meets each other */
    mesh_table_make(&table);
    for (int axis = 0; axis < 3; axis++)
        for (int inside = 0; inside < 4096; inside++) {
            memset(signs, 0, sizeof signs);
            for (int c = 0; c < 12; c++) {
                int at[3] = {1 + c % 2, 1 + c / 2 % 2, 1};
                at[2] += c / 4;
                const int x = at[axis], y = at[(axis + 1) % 3], z = at[(axis + 2) % 3];
                signs[z][y * 5 + x] = inside >> c & 1;
            }
            make_net(4, signs);
            (void)check_manifold(4, signs);
        }
}

TEST(test_random_signs) {
    mesh_table_make(&table);
    state = SEED;
    for (int round = 0; round < 3000; round++) {
        const int n = 3 + (int)(next_random() % (MOST - 2));
        fill(n, signs, 10 + next_random() % 81);
        make_net(n, signs);
        (void)check_manifold(n, signs);
    }
}

TEST(test_known_shapes) {
    mesh_table_make(&table);
    memset(signs, 0, sizeof signs);
    signs[2][2 * 9 + 2] = 1;
    make_net(8, signs);
    assert_int_equal(check_manifold(8, signs), 2); /* a ball */
    signs[3][3 * 9 + 3] = 1;
    make_net(8, signs);
    assert_int_equal(check_manifold(8, signs), 4); /* two that meet in a point are two */
    memset(signs, 0, sizeof signs);
    for (int j = 2; j <= 4; j++)
        for (int i = 2; i <= 4; i++) signs[3][j * 9 + i] = i != 3 || j != 3;
    make_net(8, signs);
    assert_int_equal(check_manifold(8, signs), 0); /* a ring */
}
