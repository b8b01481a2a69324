/* render_heatmap.c - see render_heatmap.h. */
#include "render_heatmap.h"

#include <stdlib.h>
#include <string.h>

#include "render_legend.h"

enum { NO_CHORD = -1, LEFT_OPEN = -2 }; /* in place of a cost */

/* The bounded tier leaves a ray uncertain exactly where the certified tier would go to integers. */
static int cost_of(const algsurf_surface *surface, const algsurf_extent *extent, const algsurf_ray *ray,
                   const algsurf_intersect_options *asked) {
    algsurf_observer observer = {.size = sizeof observer};
    algsurf_intersect_options how = *asked;
    algsurf_hit hit;
    how.tier = ALGSURF_TIER_BOUNDED;
    how.undecided_as = ALGSURF_AS_UNDECIDED;
    how.observer = &observer;
    if (algsurf_intersect_first(surface, extent, ray, &how, &hit) != ALGSURF_OK ||
        hit.state == ALGSURF_UNDECIDED)
        return LEFT_OPEN;
    return observer.cells > 0 ? (int)(observer.cells + observer.evaluations) : NO_CHORD;
}

/* Costs of all pixels, row by row. */
static int *count_costs(const render_options *options, const algsurf_surface *surface,
                        const algsurf_extent *extent, const algsurf_camera *camera, int first, int rows,
                        progress *bar) {
    int width = options->view.width, height = options->view.height;
    int *costs = malloc((size_t)width * (size_t)rows * sizeof *costs), *at = costs;
    if (!costs) cli_no_memory();
    for (int y = 0; y < rows; y++) {
        for (int x = 0; x < width; x++) {
            algsurf_ray ray;
            algsurf_status status = algsurf_camera_ray(camera, width, height, x + 0.5, first + y + 0.5, &ray);
            *at++ = status == ALGSURF_OK ? cost_of(surface, extent, &ray, &options->intersect) : LEFT_OPEN;
        }
        (void)progress_rows(y + 1, rows, bar);
    }
    return costs;
}

render_heatmap render_make_heatmap(const render_options *options, const algsurf_surface *surface,
                                   const algsurf_extent *extent, const algsurf_camera *camera,
                                   progress *bar) {
    int first = options->row_begin, width = options->view.width;
    int rows = (options->row_end > 0 ? options->row_end : options->view.height) - first;
    int *costs = count_costs(options, surface, extent, camera, first, rows, bar);
    render_legend legend = {.top = 1};
    for (size_t i = 0; i < (size_t)width * (size_t)rows; i++) {
        if (costs[i] > legend.top) legend.top = costs[i];
        legend.left_open += costs[i] == LEFT_OPEN;
    }
    render_heatmap map = {width > LEGEND_WIDTH ? width : LEGEND_WIDTH, rows + LEGEND_HEIGHT, NULL};
    size_t bytes = 3 * (size_t)map.width * (size_t)map.height;
    map.pixels = malloc(bytes);
    if (!map.pixels) cli_no_memory();
    memset(map.pixels, 255, bytes);
    for (int y = 0; y < rows; y++)
        for (int x = 0; x < width; x++) {
            int cost = costs[(size_t)y * (size_t)width + (size_t)x];
            legend_colour colour = cost == NO_CHORD    ? legend_no_chord
                                   : cost == LEFT_OPEN ? legend_left_open
                                                       : legend_cost(cost, legend.top);
            memcpy(map.pixels + 3 * ((size_t)y * (size_t)map.width + (size_t)x), colour.rgb, 3);
        }
    render_draw_legend(&legend, map.pixels, map.width, rows);
    free(costs);
    return map;
}
