/* tiles.c - the tiles of a band of rows, level by level.
 *
 * A band is ALGSURF_I_TILES rows of the whole picture, from a multiple of that on, and its tiles lie at
 * multiples of their size: so they are the same for each slice, thread and kernel.  Tiles that are neither
 * empty nor sheets (tiles_template.h) are halved in both directions; each level is searched row by row, since
 * the tiles of a row share what depends on v.  A beam is made anew on each level: what is left out of it is
 * of the fourth order in its size, and of the third of its ends.
 *
 * Tiles pay where pixels are many for what there is to be seen: an outline as long as the degree squared,
 * over pixels.  Pixels alone are as fast at FEW and faster beyond. */
#include "../base/arithmetic.h"
#include "impl.h"

#include <math.h>

#define LEVELS_ROWS (ALGSURF_I_TILES / ALGSURF_I_LEAF)
#define FEW 0.21 /* pixel's side, in the view's unit, times degree^2; measured from degree 4 to 10, */
#define FEW_MORE                                                                                             \
    0.5 /* where what is thin is looked for, in what they leave open; in all of space, where they            \
           spare the pixels a proof */

/* Tiles in a row of them that are to be searched. */
typedef struct tile_list {
    int count, *at;
    double *from;
} tile_list;

int algsurf_i_tiles_pay(const algsurf_i_picture *picture, const algsurf_i_geometry *p) {
    const algsurf_scene *scene = picture->scene;
    int n = scene->surface->degree, samples = picture->selective ? 1 : scene->antialias;
    double side = fabs(p->rays.du) * p->rays.pixel / samples;
    return !scene->complex && n <= ALGSURF_MAX_BEAM_DEGREE &&
           side * n * n <= (picture->thin || scene->extent.kind == ALGSURF_EXTENT_ALL ? FEW_MORE : FEW);
}

static void take_all(int size, int begin, int end, tile_list *list) {
    list->count = 0;
    for (int x = begin; x < end; x += size) {
        list->at[list->count] = x;
        list->from[list->count++] = -1;
    }
}

/* One of the two rows of tiles of that size that make up a row of larger ones. */
static void take_halves(const tile_list *large, int size, int width, tile_list *list) {
    list->count = 0;
    for (int i = 0; i < 2 * large->count; i++) {
        int x = large->at[i / 2] + i % 2 * size;
        if (x >= width) continue;
        list->at[list->count] = x;
        list->from[list->count++] = large->from[i / 2];
    }
}

/* Their places as those of empty tiles, until they are found to be others. */
static void set_empty(const algsurf_i_tile_job *job, const tile_list *list) {
    int side = job->size / ALGSURF_I_LEAF, row = (job->y - job->from_y) / ALGSURF_I_LEAF;
    for (int i = 0; i < list->count; i++) {
        int first = list->at[i] / ALGSURF_I_LEAF;
        int end = first + side < job->stride ? first + side : job->stride;
        for (int r = row; r < row + side; r++)
            for (int x = first; x < end; x++) job->cell[r * job->stride + x] = -job->size;
    }
}

/* Searches the tiles of a list, of which those not decided are left. */
static void search_list(const algsurf_i_picture *picture, algsurf_i_tiling *t, tile_list *list,
                        algsurf_i_tile_job *job) {
    const algsurf_i_geometry *p = picture->geometry;
    double half = 0.5 * job->size, h = -p->rays.du * (half * p->rays.pixel);
    double v = p->v0 + p->rays.du * ((0.5 * picture->height - (job->y + half)) * p->rays.pixel);
    algsurf_i_beam_row_expand(&p->frame, p->beams, v, h + copysign(ALGSURF_I_WIDER, h),
                              fabs(h) + ALGSURF_I_WIDER, t->square, &t->beam);
    set_empty(job, list);
    job->count = list->count;
    job->at = list->at;
    job->from = list->from;
    picture->code->search_tiles(job);
    list->count = job->count;
}

static void search_band(const algsurf_i_picture *picture, algsurf_i_tiling *t, algsurf_i_band *band) {
    const int places = algsurf_i_cells_across(picture) * LEVELS_ROWS;
    algsurf_render_stats *counts = &band->counts.stats;
    for (int i = 0; i < places; i++) band->cell[i] = -ALGSURF_I_TILES;
    algsurf_i_tile_job job = {.row = &picture->geometry->rays,
                              .beam = &t->beam,
                              .noise = picture->geometry->frame.value_error,
                              .cell = band->cell,
                              .stride = algsurf_i_cells_across(picture),
                              .from_y = band->number * ALGSURF_I_TILES,
                              .tiles = band->tiles};
    tile_list lists[2][LEVELS_ROWS];
    uint64_t all = 0, quartered = 0;
    for (int i = 0; i < 2 * LEVELS_ROWS; i++)
        lists[i / LEVELS_ROWS][i % LEVELS_ROWS] =
            (tile_list){0, t->at + i * job.stride, t->from + i * job.stride};
    job.size = ALGSURF_I_TILES;
    for (int level = 0; job.size >= ALGSURF_I_LEAF; level++, job.size /= 2) {
        int rows = ALGSURF_I_TILES / job.size;
        tile_list *list = lists[level % 2], *larger = lists[(level + 1) % 2];
        for (int r = 0; r < rows; r++) {
            job.y = job.from_y + r * job.size;
            if (level == 0)
                take_all(job.size, band->begin, band->end, &list[r]);
            else
                take_halves(&larger[r / 2], job.size, picture->width, &list[r]);
            if (job.y >= picture->height) list[r].count = 0;
            all += (uint64_t)list[r].count;
            if (list[r].count > 0) search_list(picture, t, &list[r], &job);
            if (job.size > ALGSURF_I_LEAF) quartered += (uint64_t)list[r].count;
        }
    }
    counts->tiles = all;
    counts->empty_tiles = all - quartered - (uint64_t)job.tile_count;
    for (int i = 0; i < job.tile_count; i++) counts->sheet_tiles += job.tiles[i].enough > 0;
    counts->leaf_tiles = (uint64_t)job.tile_count - counts->sheet_tiles;
}

const algsurf_i_band *algsurf_i_band_of(algsurf_i_worker *worker, int row) {
    const algsurf_i_picture *picture = worker->picture;
    int number = row / ALGSURF_I_TILES, top = number * ALGSURF_I_TILES;
    algsurf_i_band *band = &worker->tiling.band[number % 2];
    if (!picture->tiled) return NULL;
    if (band->number != number) {
        band->number = number;
        band->whole = algsurf_i_pixels_within_bounds(picture, top, top + ALGSURF_I_TILES, ALGSURF_I_TILES,
                                                     &band->begin, &band->end);
        band->counts = (algsurf_i_tally){.without_memory = 0};
        if (band->whole) search_band(picture, &worker->tiling, band);
    }
    return band->whole ? band : NULL;
}

void algsurf_i_count_tiles(algsurf_i_worker *worker, int row) {
    int number = row / ALGSURF_I_TILES;
    const algsurf_i_band *band = &worker->tiling.band[number % 2];
    if (row % ALGSURF_I_TILES != 0 && row != worker->picture->row_begin) return;
    if (band->number == number) algsurf_i_tally_add(worker->tally, &band->counts);
}
