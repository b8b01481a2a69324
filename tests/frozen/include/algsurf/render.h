#ifndef ALGSURF_RENDER_H
#define ALGSURF_RENDER_H
#include <stdint.h>
#include "algsurf/camera.h"
#include "algsurf/intersect.h"
#include "algsurf/shade.h"
#ifdef __cplusplus
extern "C" {
#endif
typedef struct algsurf_scene algsurf_scene;
typedef enum algsurf_quality {
    ALGSURF_QUALITY_PREVIEW = 0,
    ALGSURF_QUALITY_STANDARD = 1,
    ALGSURF_QUALITY_FULL = 2
} algsurf_quality;
typedef enum algsurf_coherence {
    ALGSURF_COHERENCE_NONE = 0,
    ALGSURF_COHERENCE_NEIGHBOURS = 1
} algsurf_coherence;
ALGSURF_API algsurf_status algsurf_scene_create(const algsurf_surface *surface, algsurf_scene **scene);
ALGSURF_API void algsurf_scene_free(algsurf_scene *scene);
ALGSURF_API algsurf_status algsurf_scene_set_extent(algsurf_scene *scene, const algsurf_extent *extent);
ALGSURF_API algsurf_status algsurf_scene_set_camera(algsurf_scene *scene, const algsurf_camera *camera);
ALGSURF_API algsurf_status algsurf_scene_set_material(algsurf_scene *scene, const algsurf_material *material);
ALGSURF_API algsurf_status algsurf_scene_set_lights(algsurf_scene *scene, const algsurf_light *lights,
                                                    size_t count);
ALGSURF_API algsurf_status algsurf_scene_set_background(algsurf_scene *scene, const double colour[3]);
ALGSURF_API algsurf_status algsurf_scene_set_thin(algsurf_scene *scene, const double colour[3]);
ALGSURF_API algsurf_status algsurf_scene_get_lighting(const algsurf_scene *scene,
                                                  algsurf_light lights[ALGSURF_MAX_LIGHTS],
                                                  algsurf_lighting *lighting);
ALGSURF_API algsurf_status algsurf_scene_set_quality(algsurf_scene *scene, algsurf_quality quality);
ALGSURF_API algsurf_status algsurf_scene_set_antialias(algsurf_scene *scene, int n);
ALGSURF_API algsurf_status algsurf_scene_set_antialias_threshold(algsurf_scene *scene, double threshold);
ALGSURF_API algsurf_status algsurf_scene_set_intersect_options(algsurf_scene *scene,
                                                       const algsurf_intersect_options *options);
ALGSURF_API algsurf_status algsurf_scene_set_clip(algsurf_scene *scene, const algsurf_plane *planes,
                                                  size_t count);
ALGSURF_API algsurf_status algsurf_scene_set_complex_space(algsurf_scene *scene,
                                                           const algsurf_complex_space *space);
ALGSURF_API algsurf_status algsurf_scene_set_coherence(algsurf_scene *scene, algsurf_coherence coherence);
typedef int (*algsurf_progress)(int rows_done, int rows_total, void *data);
typedef struct algsurf_render_options {
    size_t size;
    int width, height;
    int row_begin, row_end;
    int threads;
    algsurf_progress progress;
    void *progress_data;
} algsurf_render_options;
typedef struct algsurf_render_stats {
    size_t size;
    uint64_t rays;
    uint64_t hits;
    uint64_t undecided;
    uint64_t shadow_rays;
    double solve_s;
    double shade_s;
    double total_s;
    int threads;
    uint64_t iterations;
    uint64_t single_rays;
    double expand_s;
    double point_s;
    double shadow_s;
    const char *kernel;
    uint64_t tiles;
    uint64_t empty_tiles;
    uint64_t sheet_tiles;
    uint64_t leaf_tiles;
    uint64_t empty_rays;
    uint64_t sheet_rays;
    uint64_t exact_rays;
    uint64_t thin;
} algsurf_render_stats;
typedef enum algsurf_pixel_format {
    ALGSURF_RGB8 = 0,
    ALGSURF_RGBA8 = 1
} algsurf_pixel_format;
typedef enum algsurf_way {
    ALGSURF_WAY_EMPTY = 0,
    ALGSURF_WAY_SHEET = 1,
    ALGSURF_WAY_ROW = 2,
    ALGSURF_WAY_SINGLE = 3
} algsurf_way;
typedef struct algsurf_picture {
    size_t size;
    unsigned char *pixels;
    size_t stride;
    int format;
    double *t;
    float *normals;
    unsigned char *state;
    unsigned char *way;
} algsurf_picture;
ALGSURF_API algsurf_status algsurf_render(const algsurf_scene *scene, const algsurf_render_options *options,
                                          const algsurf_picture *picture, algsurf_render_stats *stats);
#ifdef __cplusplus
}
#endif
#endif
