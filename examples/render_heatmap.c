/* render_heatmap.c - see render_heatmap.h. */
#include "render_heatmap.h"

#include <stdlib.h>
#include <string.h>

#include "render_legend.h"

enum { NO_CHORD = -1, LEFT_OPEN = -2 }; /* in place of a cost */
enum { WAYS = 3 };                      /* an algsurf_way in algsurf_picture.way; the rest is a tile's side */

static int is_decided_by_tile(uint8_t way) { return (way & WAYS) <= ALGSURF_WAY_SHEET; }

/* The bounded tier leaves a ray undecided exactly where the certified tier would go to integers. */
static int cost_of(const algsurf_surface *surface, const algsurf_extent *extent, const algsurf_ray *ray,
                   const render_options *options) {
    algsurf_observer observer = {.size = sizeof observer};
    algsurf_intersect_options how = options->intersect;
    algsurf_hit hit;
    how.tier = ALGSURF_TIER_BOUNDED;
    how.undecided_as = ALGSURF_AS_UNDECIDED;
    how.observer = &observer;
    how.planes = options->clip.plane;
    how.plane_count = options->clip.count;
    if (algsurf_intersect_first(surface, extent, ray, &how, &hit) != ALGSURF_OK ||
        hit.state == ALGSURF_STATE_UNDECIDED)
        return LEFT_OPEN;
    return observer.cells > 0 ? (int)(observer.cells + observer.evaluations) : NO_CHORD;
}

/* The picture that the map is of: its rows from `first` on. */
typedef struct shown {
    int width, first, rows;
    const uint8_t *pixels, *ways;
} shown;

/* Costs of the pixels that tiles do not decide, row by row. */
static int *count_costs(const render_options *options, const algsurf_surface *surface,
                        const algsurf_extent *extent, const algsurf_camera *camera, const shown *s,
                        progress *bar) {
    int width = s->width, height = options->view.height;
    int *costs = malloc((size_t)width * (size_t)s->rows * sizeof *costs), *at = costs;
    const uint8_t *way = s->ways;
    if (!costs) cli_no_memory();
    for (int y = 0; y < s->rows; y++) {
        for (int x = 0; x < width; x++, at++) {
            algsurf_ray ray;
            if (is_decided_by_tile(*way++)) continue;
            algsurf_status status =
                algsurf_camera_ray(camera, width, height, x + 0.5, s->first + y + 0.5, &ray);
            *at = status == ALGSURF_OK ? cost_of(surface, extent, &ray, options) : LEFT_OPEN;
        }
        (void)progress_rows(y + 1, s->rows, bar);
    }
    return costs;
}

static render_legend sum_up(const int *costs, const uint8_t *ways, size_t count) {
    render_legend legend = {.top = 1};
    for (size_t i = 0; i < count; i++) {
        if (is_decided_by_tile(ways[i])) continue;
        if (costs[i] > legend.top) legend.top = costs[i];
        legend.left_open += costs[i] == LEFT_OPEN;
    }
    return legend;
}

static legend_colour darker(legend_colour colour, double share) {
    for (int k = 0; k < 3; k++) colour.rgb[k] = (uint8_t)(share * colour.rgb[k]);
    return colour;
}

/* How bright the picture is in the middle of a tile, as far as that was drawn. */
static double light_of(const shown *s, int x, int y, int side) {
    x += side / 2 - x % side;
    y += side / 2 - (s->first + y) % side;
    x = x < s->width ? x : s->width - 1;
    y = y < 0 ? 0 : y < s->rows ? y : s->rows - 1;
    const uint8_t *pixel = s->pixels + 3 * ((size_t)y * (size_t)s->width + (size_t)x);
    return (0.3 * pixel[0] + 0.6 * pixel[1] + 0.1 * pixel[2]) / 255;
}

/* A pixel of a tile that decides it. */
static legend_colour tile_colour(const shown *s, int x, int y, uint8_t way) {
    int side = way & ~WAYS, edge = x % side == 0 || (s->first + y) % side == 0;
    if ((way & WAYS) == ALGSURF_WAY_EMPTY) return edge ? darker(legend_empty, 0.88) : legend_empty;
    return darker(legend_sheet, (0.4 + 0.6 * light_of(s, x, y, side)) * (edge ? 0.8 : 1));
}

static legend_colour cost_colour(int cost, int top) {
    return cost == NO_CHORD ? legend_no_chord : cost == LEFT_OPEN ? legend_left_open : legend_cost(cost, top);
}

render_heatmap render_make_heatmap(const render_options *options, const algsurf_surface *surface,
                                   const algsurf_extent *extent, const algsurf_camera *camera,
                                   const uint8_t *pixels, const uint8_t *ways, progress *bar) {
    int first = options->row_begin, width = options->view.width;
    int rows = (options->row_end > 0 ? options->row_end : options->view.height) - first;
    const shown s = {width, first, rows, pixels, ways};
    int *costs = count_costs(options, surface, extent, camera, &s, bar);
    const render_legend legend = sum_up(costs, ways, (size_t)width * (size_t)rows);
    render_heatmap map = {width > LEGEND_WIDTH ? width : LEGEND_WIDTH, rows + LEGEND_HEIGHT, NULL};
    size_t bytes = 3 * (size_t)map.width * (size_t)map.height;
    map.pixels = malloc(bytes);
    if (!map.pixels) cli_no_memory();
    memset(map.pixels, 255, bytes);
    for (int y = 0; y < rows; y++)
        for (int x = 0; x < width; x++) {
            size_t i = (size_t)y * (size_t)width + (size_t)x;
            legend_colour colour = is_decided_by_tile(ways[i]) ? tile_colour(&s, x, y, ways[i])
                                                               : cost_colour(costs[i], legend.top);
            memcpy(map.pixels + 3 * ((size_t)y * (size_t)map.width + (size_t)x), colour.rgb, 3);
        }
    render_draw_legend(&legend, map.pixels, map.width, rows);
    free(costs);
    return map;
}
