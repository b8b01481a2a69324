#include <stddef.h>
#include <stdint.h>
#define ALGSURF_VERSION_MAJOR 1
#define ALGSURF_VERSION_MINOR 0
#define ALGSURF_VERSION_PATCH 0
#define ALGSURF_VERSION (ALGSURF_VERSION_MAJOR * 10000 + ALGSURF_VERSION_MINOR * 100 + ALGSURF_VERSION_PATCH)
#define ALGSURF_API __attribute__((visibility("default")))
#define ALGSURF_STATUS_LIST(X) \
    X(ALGSURF_E_ARGUMENT, -1, "an argument is null, or out of its range") \
    X(ALGSURF_E_NOT_FINITE, -2, "a number is not finite") \
    X(ALGSURF_E_NO_MEMORY, -3, "out of memory") \
    X(ALGSURF_E_DEGREE, -4, "degree above the limit") \
    X(ALGSURF_E_SYNTAX, -5, "text is not a polynomial equation in x, y, z") \
    X(ALGSURF_E_ZERO, -6, "polynomial is identically zero") \
    X(ALGSURF_E_RANGE, -7, "overflow, or no result") \
    X(ALGSURF_E_THREAD, -8, "a lock could not be made") \
    X(ALGSURF_E_BUILD, -9, "this build of the library does not compute as its proofs need") \
    X(ALGSURF_E_NAME, -10, "a name in the equation has no value") \
    X(ALGSURF_E_SIZE, -11, "a struct's size is not set, or it asks for what this version does not know") \
    X(ALGSURF_E_CAPACITY, -12, "no room for the whole answer") \
    X(ALGSURF_OK, 0, "done") \
    X(ALGSURF_UNDECIDED_MULTIPLE, 1, "a multiple root, or roots too close to be told apart") \
    X(ALGSURF_UNDECIDED_END, 2, "a root at, or too close to, an end of the interval") \
    X(ALGSURF_UNDECIDED_ZERO, 3, "the polynomial vanishes, or cannot be told from zero") \
    X(ALGSURF_UNDECIDED_RANGE, 4, "overflow or underflow hides the answer") \
    X(ALGSURF_NOT_CONVERGED, 5, "the iteration limit was reached") \
    X(ALGSURF_CANCELLED, 6, "cancelled by the caller") \
    X(ALGSURF_NOT_VERIFIED, 7, "an inclusion could not be verified")
typedef enum algsurf_status {
#define ALGSURF_STATUS_ENUM(name,number,text) name = number,
    ALGSURF_STATUS_LIST(ALGSURF_STATUS_ENUM)
#undef ALGSURF_STATUS_ENUM
} algsurf_status;
ALGSURF_API const char *algsurf_status_name(algsurf_status status);
ALGSURF_API const char *algsurf_version(void);
ALGSURF_API int algsurf_version_number(void);
typedef struct algsurf_complex {
    double re, im;
} algsurf_complex;
typedef struct algsurf_interval {
    double lo, hi;
} algsurf_interval;
typedef struct algsurf_cinterval {
    algsurf_interval re, im;
} algsurf_cinterval;
ALGSURF_API algsurf_interval algsurf_interval_sub(algsurf_interval a, algsurf_interval b);
ALGSURF_API int algsurf_interval_contains(algsurf_interval a, double x);
typedef struct algsurf_table {
    const double *at;
    ptrdiff_t power, polynomial;
} algsurf_table;
typedef enum algsurf_engine {
    ALGSURF_ENGINE_NONE = 0,
    ALGSURF_ENGINE_DOUBLES = 1,
    ALGSURF_ENGINE_INTEGERS = 2
} algsurf_engine;
typedef struct algsurf_cell {
    double lo, hi;
    int variations;
    int engine;
    int degree;
    const signed char *signs;
} algsurf_cell;
typedef void (*algsurf_cell_observer)(const algsurf_cell *cell, void *data);
typedef void (*algsurf_point_observer)(double t, double value, int engine, void *data);
typedef struct algsurf_observer {
    size_t size;
    algsurf_cell_observer on_cell;
    algsurf_point_observer on_point;
    void *data;
    size_t cells;
    size_t evaluations;
    int engine;
} algsurf_observer;
typedef struct algsurf_bracket {
    double lo, hi;
    int kind;
    int sign;
    int multiplicity;
    int status;
} algsurf_bracket;
typedef struct algsurf_isolate_options {
    size_t size;
    algsurf_observer *observer;
} algsurf_isolate_options;
ALGSURF_API algsurf_status algsurf_isolate_first(const double *c, const double *r, int degree, double lo,
                                                 double hi, const algsurf_isolate_options *options,
                                                 algsurf_bracket *bracket, int *found);
typedef enum algsurf_method {
    ALGSURF_METHOD_DEFAULT = 0,
    ALGSURF_METHOD_BRENT = 1,
    ALGSURF_METHOD_BISECTION = 2,
    ALGSURF_METHOD_REGULA_FALSI = 3
} algsurf_method;
typedef struct algsurf_refine_options {
    size_t size;
    int method;
    int max_iterations;
    double absolute_tolerance;
    algsurf_observer *observer;
} algsurf_refine_options;
typedef struct algsurf_refined_root {
    double root;
    double lo, hi;
    double residual;
    int evaluations;
    int iterations;
    int converged;
} algsurf_refined_root;
ALGSURF_API algsurf_status algsurf_refine_poly(const double *c, const double *r, int degree, double lo,
                                               double hi, const algsurf_refine_options *options,
                                               algsurf_refined_root *result);
typedef struct algsurf_complex_root {
    algsurf_cinterval box;
    algsurf_complex root;
    int multiplicity;
    int real;
} algsurf_complex_root;
ALGSURF_API algsurf_status algsurf_complex_roots_of_real(const double *c, const double *r, int degree,
                                                         algsurf_complex_root *roots, int *count);
typedef struct algsurf_batch_options {
    size_t size;
    const char *kernel;
    double relative_tolerance;
} algsurf_batch_options;
typedef struct algsurf_real_batch {
    size_t size;
    size_t count;
    int degree;
    algsurf_table coefficients;
    algsurf_table radii;
    const double *lo, *hi;
    ptrdiff_t interval_step;
} algsurf_real_batch;
typedef enum algsurf_first_root_state {
    ALGSURF_FIRST_ROOT_NONE = 0,
    ALGSURF_FIRST_ROOT_FOUND = 1,
    ALGSURF_FIRST_ROOT_UNDECIDED = 2,
    ALGSURF_FIRST_ROOT_REFUSED = 4
} algsurf_first_root_state;
ALGSURF_API algsurf_status algsurf_first_roots_batch(const algsurf_real_batch *batch,
                                                     const algsurf_batch_options *options,
                                                     unsigned char *state, double *root);
typedef struct algsurf_sector {
    double sigma, delta;
} algsurf_sector;
typedef struct algsurf_paper_options {
    size_t size;
    double relative_step;
    int max_steps;
    int max_inflations;
} algsurf_paper_options;
typedef struct algsurf_paper_zero {
    algsurf_cinterval box;
    algsurf_complex root;
    int verified;
    int unique;
    int converged;
    int steps, inflations;
} algsurf_paper_zero;
ALGSURF_API algsurf_status algsurf_paper_zeros(const algsurf_complex *p, const double *r, int degree,
                                               const algsurf_complex *start,
                                               const algsurf_paper_options *options,
                                               algsurf_paper_zero *zeros, int *complete);
typedef struct algsurf_surface algsurf_surface;
typedef struct algsurf_term {
    int i, j, k;
    double a;
} algsurf_term;
typedef struct algsurf_constant {
    const char *name;
    double value;
} algsurf_constant;
typedef struct algsurf_parse_error {
    size_t offset;
    size_t length;
    const char *message;
} algsurf_parse_error;
ALGSURF_API algsurf_status algsurf_surface_from_terms(const algsurf_term *terms, size_t count,
                                                      algsurf_surface **surface);
ALGSURF_API algsurf_status algsurf_surface_from_equation(const char *text, const algsurf_constant *constants,
                                                         size_t count, algsurf_surface **surface,
                                                         algsurf_parse_error *error);
ALGSURF_API void algsurf_surface_free(algsurf_surface *surface);
ALGSURF_API int algsurf_surface_degree(const algsurf_surface *surface);
ALGSURF_API size_t algsurf_surface_term_count(const algsurf_surface *surface);
ALGSURF_API algsurf_status algsurf_surface_value(const algsurf_surface *surface, const double point[3],
                                                 double *value, double *bound);
typedef struct algsurf_ray {
    double origin[3];
    double direction[3];
    double t_min, t_max;
} algsurf_ray;
typedef enum algsurf_extent_kind {
    ALGSURF_EXTENT_ALL = 0,
    ALGSURF_EXTENT_SPHERE = 1,
    ALGSURF_EXTENT_BOX = 2
} algsurf_extent_kind;
typedef struct algsurf_extent {
    int kind;
    double centre[3];
    double size[3];
} algsurf_extent;
typedef struct algsurf_plane {
    double normal[3];
    double offset;
} algsurf_plane;
typedef enum algsurf_tier {
    ALGSURF_TIER_CERTIFIED = 0,
    ALGSURF_TIER_BOUNDED = 1
} algsurf_tier;
typedef enum algsurf_undecided_as {
    ALGSURF_AS_UNDECIDED = 0,
    ALGSURF_AS_HIT = 1,
    ALGSURF_AS_MISS = 2
} algsurf_undecided_as;
typedef enum algsurf_hit_state {
    ALGSURF_STATE_MISS = 0,
    ALGSURF_STATE_HIT = 1,
    ALGSURF_STATE_UNDECIDED = 2,
    ALGSURF_STATE_THIN = 3,
    ALGSURF_STATE_REFUSED = 4
} algsurf_hit_state;
typedef struct algsurf_hit {
    int state;
    int reason;
    int multiplicity;
    int side;
    double t;
    double t_lo, t_hi;
    double position[3];
    double normal[3];
} algsurf_hit;
typedef struct algsurf_intersect_options {
    size_t size;
    int tier;
    int method;
    int max_iterations;
    double absolute_tolerance;
    const char *kernel;
    int undecided_as;
    size_t max_memory;
    algsurf_observer *observer;
    const algsurf_plane *planes;
    size_t plane_count;
    int side;
} algsurf_intersect_options;
ALGSURF_API algsurf_status algsurf_intersect_first(const algsurf_surface *surface,
                                                   const algsurf_extent *extent, const algsurf_ray *ray,
                                                   const algsurf_intersect_options *options,
                                                   algsurf_hit *hit);
ALGSURF_API algsurf_status algsurf_intersect_all(const algsurf_surface *surface, const algsurf_extent *extent,
                                                 const algsurf_ray *ray,
                                                 const algsurf_intersect_options *options, algsurf_hit *hits,
                                                 int capacity, int *count);
ALGSURF_API algsurf_status algsurf_occluded(const algsurf_surface *surface, const algsurf_extent *extent,
                                            const algsurf_ray *ray, const algsurf_intersect_options *options,
                                            int *state);
typedef struct algsurf_ray_packet {
    size_t size;
    size_t count;
    const double *origin[3], *direction[3];
    const double *t_min, *t_max;
    const unsigned char *active;
    ptrdiff_t step;
    const float *float_origin[3], *float_direction[3];
    const float *float_t_min, *float_t_max;
} algsurf_ray_packet;
typedef struct algsurf_hit_packet {
    size_t size;
    unsigned char *state;
    double *t, *t_lo, *t_hi;
    double *position[3], *normal[3];
    int *multiplicity;
    signed char *side, *reason;
} algsurf_hit_packet;
ALGSURF_API algsurf_status algsurf_intersect_packet(const algsurf_surface *surface,
                                                    const algsurf_extent *extent,
                                                    const algsurf_ray_packet *rays,
                                                    const algsurf_intersect_options *options,
                                                    const algsurf_hit_packet *hits);
ALGSURF_API algsurf_status algsurf_occluded_packet(const algsurf_surface *surface,
                                                   const algsurf_extent *extent,
                                                   const algsurf_ray_packet *rays,
                                                   const algsurf_intersect_options *options,
                                                   unsigned char *state);
typedef struct algsurf_complex_space {
    size_t size;
    algsurf_sector sector;
    const double *imaginary;
    size_t imaginary_count;
} algsurf_complex_space;
ALGSURF_API algsurf_status algsurf_intersect_complex(const algsurf_surface *surface,
                                                     const algsurf_extent *extent, const algsurf_ray *ray,
                                                     const algsurf_complex_space *space,
                                                     const algsurf_complex *start, algsurf_complex *roots,
                                                     algsurf_hit *hit, algsurf_complex *root);
typedef struct algsurf_camera {
    double eye[3];
    double right[3], up[3], forward[3];
    double half_height;
    int kind;
    double reserved[8];
} algsurf_camera;
ALGSURF_API algsurf_status algsurf_camera_orthographic(const double eye[3], const double look_at[3],
                                                       const double up[3], double height,
                                                       algsurf_camera *camera);
#define ALGSURF_MAX_LIGHTS 16
typedef struct algsurf_material {
    size_t size;
    double outside[3];
    double inside[3];
    double diffuse;
    double ambient;
    double fill;
    double specular;
    double roughness;
    double haze;
} algsurf_material;
typedef enum algsurf_light_kind {
    ALGSURF_LIGHT_AREA = 0
} algsurf_light_kind;
typedef struct algsurf_light {
    double position[3];
    double colour[3];
    double edge_u[3], edge_v[3];
    int samples_u, samples_v;
    int kind;
    double reserved[8];
} algsurf_light;
typedef struct algsurf_lighting {
    size_t size;
    const algsurf_material *material;
    const algsurf_light *lights;
    size_t light_count;
    double up[3], forward[3];
    double centre[3], radius;
    int bounded;
} algsurf_lighting;
ALGSURF_API algsurf_status algsurf_shade(const algsurf_lighting *lighting, const double *visible,
                                         const double point[3], const double normal[3],
                                         const double direction[3], double colour[3]);
ALGSURF_API algsurf_status algsurf_shade_preview(const algsurf_lighting *lighting, const double point[3],
                                                 const double normal[3], const double direction[3],
                                                 double colour[3]);
ALGSURF_API algsurf_status algsurf_srgb_encode(const double colour[3], unsigned char bytes[3]);
ALGSURF_API algsurf_status algsurf_srgb_decode(const unsigned char bytes[3], double colour[3]);
typedef struct algsurf_scene algsurf_scene;
typedef enum algsurf_quality {
    ALGSURF_QUALITY_PREVIEW = 0,
    ALGSURF_QUALITY_STANDARD = 1,
    ALGSURF_QUALITY_FULL = 2
} algsurf_quality;
ALGSURF_API algsurf_status algsurf_scene_create(const algsurf_surface *surface, algsurf_scene **scene);
ALGSURF_API void algsurf_scene_free(algsurf_scene *scene);
ALGSURF_API algsurf_status algsurf_scene_set_extent(algsurf_scene *scene, const algsurf_extent *extent);
ALGSURF_API algsurf_status algsurf_scene_set_camera(algsurf_scene *scene, const algsurf_camera *camera);
ALGSURF_API algsurf_status algsurf_scene_set_material(algsurf_scene *scene, const algsurf_material *material);
ALGSURF_API algsurf_status algsurf_scene_set_lights(algsurf_scene *scene, const algsurf_light *lights,
                                                    size_t count);
ALGSURF_API algsurf_status algsurf_scene_set_background(algsurf_scene *scene, const double colour[3]);
ALGSURF_API algsurf_status algsurf_scene_get_lighting(const algsurf_scene *scene,
                                                  algsurf_light lights[ALGSURF_MAX_LIGHTS],
                                                  algsurf_lighting *lighting);
ALGSURF_API algsurf_status algsurf_scene_set_quality(algsurf_scene *scene, algsurf_quality quality);
ALGSURF_API algsurf_status algsurf_scene_set_clip(algsurf_scene *scene, const algsurf_plane *planes,
                                                  size_t count);
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
