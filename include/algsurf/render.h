/* algsurf/render.h - a picture of one surface.
 *
 * A scene is one surface, one extent, one camera, one material, lights, a background: no more.  Its members
 * are private, so that later versions can add some.  A picture is the same, byte for byte, for any number of
 * threads and any split into rows, with spatial coherence and without.
 */
#ifndef ALGSURF_RENDER_H
#define ALGSURF_RENDER_H
#include <stdint.h>

#include "algsurf/camera.h"
#include "algsurf/intersect.h"
#include "algsurf/shade.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What is shown, and how. */
typedef struct algsurf_scene algsurf_scene;

/* How points of the surface are lit. */
typedef enum algsurf_quality {
    ALGSURF_QUALITY_PREVIEW = 0,  /* no lights (algsurf_shade_preview) */
    ALGSURF_QUALITY_STANDARD = 1, /* lights shine from their middles, no shadows */
    ALGSURF_QUALITY_FULL = 2      /* shadows of lights, and of the light from all around */
} algsurf_quality;

/* What the iteration for the roots of a ray starts with, in complex space. */
typedef enum algsurf_coherence {
    ALGSURF_COHERENCE_NONE = 0,      /* start values of its own */
    ALGSURF_COHERENCE_NEIGHBOURS = 1 /* the roots of the pixel above, or of the sample before */
} algsurf_coherence;

/* A scene showing a surface with defaults: extent all of space, a pinhole camera at (4,3,2.5) looking
 * at the origin with z up and a field of view of 30 degrees, a blue outside and an amber inside, white
 * background, standard quality, 1 sample a pixel, certified tier, real space, coherence by neighbours (for
 * complex space).  Until lights are set there is one wide light that moves with camera and extent: above and
 * to the left of what is shown, on the viewer's side, 16 radii from its centre (all of space: the radius that
 * fills the picture at the origin).  algsurf_scene_get_lighting() returns the light in use.  The surface is
 * borrowed: it must outlive the scene.
 * Errors: E_ARGUMENT, E_NO_MEMORY.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_scene_create(const algsurf_surface *surface, algsurf_scene **scene);

/* Releases a scene, not its surface; null is allowed.  Since 1.0. */
ALGSURF_API void algsurf_scene_free(algsurf_scene *scene);

/* Sets a part of the scene.  Setters copy their argument; a refused value leaves the scene as it was.  Not to
 * be called while the scene is being rendered.  Null means: extent, all of space; options, the defaults;
 * complex space, real space; background or thin colour, none; planes or lights, none if count is 0.  Any
 * other null is E_ARGUMENT; so are colours and weights out of range (shade.h), and a camera or a light that
 * camera.h and shade.h do not allow.
 * Errors: E_ARGUMENT, E_NOT_FINITE.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_scene_set_extent(algsurf_scene *scene, const algsurf_extent *extent);
ALGSURF_API algsurf_status algsurf_scene_set_camera(algsurf_scene *scene, const algsurf_camera *camera);
ALGSURF_API algsurf_status algsurf_scene_set_material(algsurf_scene *scene, const algsurf_material *material);
/* At most ALGSURF_MAX_LIGHTS.  With count 0 the scene has no light, not even the default one; lights may be
 * null then.
 * Errors: as above.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_scene_set_lights(algsurf_scene *scene, const algsurf_light *lights,
                                                    size_t count);
/* The colour where nothing is seen, in linear light (shade.h); null: there is no background, and a picture
 * with alpha is transparent there (algsurf_pixel_format).  Errors: as above.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_scene_set_background(algsurf_scene *scene, const double colour[3]);
/* Draws what is so thin that rays pass it by: isolated points, lines without sheets such as the handle of
 * Whitney's umbrella, needles, tips.  With a colour, in linear light, what is thin is a material of that
 * colour, lit like the surface, but without shadows: a line as the front of a tube, a point as one that faces
 * the viewer.  Null, the default: no thin part is drawn.
 *
 * An aid to the eye: what is drawn as thin is not proved to be there, nor what is not drawn to be absent.
 * What is drawn as a hit is proved as ever.
 *
 * Cells.  A sample stands for its cell: a square a pixel wide, with the sample in the middle.  The search is
 * for critical points of P in the cell where P is 0 or has another sign than along the sample's ray.  If the
 * ray hits something, they are looked for only as far as 4 cells' widths before the hit (an undecided place
 * is no hit here).  The search begins where |P| is least along the ray.  Not shown are edges and outlines of
 * what is wide: where P has the other sign behind the point, too, or is curved the other way in some
 * direction, or is 0 on a sheet.  So an isolated point is one cell, and a line is one cell wide; with n x n
 * samples both have soft edges.
 *
 * What falls short: P like a high power of the distance, about points that are not at the origin, drowns in
 * its rounding: (x-1)^12 + (y-1)^12 + z^12 may be lost; so may what is thinner than others within a cell.
 *
 * Nothing thin is drawn
 * - in complex space; with all of space as extent; by another method than the default; in degrees above 24;
 * - if the eye is almost at the centre of the extent, or more than some 10^7 radii away from it; if the
 *   eye is nearer than two radii: parts more than some 50 degrees off the direction of view;
 * - for numbers near the limits of double.
 *
 * Errors: E_ARGUMENT (null scene, colour out of range), E_NOT_FINITE.
 * Cost: 1 to 20 per cent of the picture's time, up to 35 with one sample a pixel in degree 10.
 * Source: Newton's method.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_scene_set_thin(algsurf_scene *scene, const double colour[3]);
/* The lighting of the scene, also if its light is the default one.  With it algsurf_shade() returns the
 * colours of the scene's pictures.
 *   lights    room for ALGSURF_MAX_LIGHTS
 *   lighting  its size set by the caller; it points to `lights` and to the scene's own material, hence is
 *             valid until the scene is changed or freed
 * Errors: E_ARGUMENT (null), E_SIZE.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_scene_get_lighting(const algsurf_scene *scene,
                                                  algsurf_light lights[ALGSURF_MAX_LIGHTS],
                                                  algsurf_lighting *lighting);
/* How points of the surface are lit.  Errors: E_ARGUMENT (null, unknown quality).  Since 1.0. */
ALGSURF_API algsurf_status algsurf_scene_set_quality(algsurf_scene *scene, algsurf_quality quality);
/* n x n samples a pixel, 1 <= n <= 16, on a regular grid.  Errors: E_ARGUMENT (null, n).  Since 1.0. */
ALGSURF_API algsurf_status algsurf_scene_set_antialias(algsurf_scene *scene, int n);
/* Which pixels get their n x n samples.
 *   threshold  0, the default: all pixels.  0 < threshold <= 1: those that show an edge by both of
 *              - their middle: it differs in a channel (0..255; alpha is one of them, even if it is not asked
 *                for) by more than 255 times the threshold from that of the pixel above, below, left or
 *                right; or it, or one of these four, shows something thin (algsurf_scene_set_thin);
 *              - their four samples in the corners: of these and the middle, some show the surface and others
 *                do not; or the corners' average differs from the middle in a channel by more than a quarter
 *                of that
 * Up to degree 12 a pixel is not chosen if it is proved that between its n x n samples there is no point of
 * the surface, or a single sheet.
 * A pixel that is not chosen shows one sample, that in the middle.  With n = 1, and with threshold 1 but for
 * what is thin, no pixel is chosen.  0.3 smooths outlines on a bright background, 0.1 most other edges too.
 *     Each pixel equals that of the picture with n x n samples or that of the picture with one sample, except
 * that one byte in millions may differ by one, and t in its last bits, and that something thin is not seen in
 * a pixel where neither its middle nor those of its four neighbours show any.  The picture does not depend on
 * slices or threads: for a slice, the rows above and below it are looked at, too.
 *
 * Errors: E_ARGUMENT (null, below 0, above 1), E_NOT_FINITE.
 * Cost: as a rule one and a half to two and a half times that of one sample a pixel, for 4 x 4 samples and
 * 0.1; about one per cent of the pixels are chosen.
 * Since 1.0. */
ALGSURF_API algsurf_status algsurf_scene_set_antialias_threshold(algsurf_scene *scene, double threshold);
/* How the rays of the picture are intersected.  Options with planes are E_ARGUMENT; algsurf_scene_set_clip
 * sets planes, and this call leaves them as they are.  Errors: as algsurf_intersect_first for the options.
 * Since 1.0. */
ALGSURF_API algsurf_status algsurf_scene_set_intersect_options(algsurf_scene *scene,
                                                       const algsurf_intersect_options *options);

/* Cuts what is shown by planes: what lies beyond one of them is treated like what is outside the extent.  It
 * is not seen and casts no shadow; what lies on a plane is seen.  These planes replace those set before; a
 * new scene has none.
 *   planes  copied; null with count 0: no planes
 *   count   at most ALGSURF_MAX_CLIP_PLANES
 * Guarantee: in real space every ray is decided as algsurf_intersect_first decides it, with these planes in
 * its options; of those that it leaves undecided, as coefficients have an error, some may be decided.  In
 * complex space the parameters t at which a ray meets the extent and the planes are rounded: a root whose |t|
 * is within rounding of one of them may count, or not.
 * Errors: E_ARGUMENT (a null scene, null planes, too many, a normal that is 0), E_NOT_FINITE.
 * Cost: a picture cut by a plane costs about what the whole picture costs; none costs nothing.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_scene_set_clip(algsurf_scene *scene, const algsurf_plane *planes,
                                                  size_t count);

/* Shows complex space, as algsurf_intersect_complex defines it; the imaginary parts are copied, too.  Then
 * the options of intersection play no part, except the kernel, and full quality is drawn like standard
 * quality: which points of complex space belong to the surface depends on where the eye is, so shadows would
 * not be those of the surface shown.
 * Errors: as algsurf_intersect_complex for the space.  Cost: 70 ns a pixel in degree 4, 300 ns in degree 10,
 * with AVX-512; a ray that is undecided in its row costs one algsurf_intersect_complex.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_scene_set_complex_space(algsurf_scene *scene,
                                                           const algsurf_complex_space *space);
/* Whether the iteration for the roots of a ray in complex space starts with those of a neighbour: that leaves
 * some 40 per cent of the iterations, takes 20 to 40 per cent less time, and gives the same picture.  Source:
 * Sanjuan-Estrada, Casado, Garcia, section 3.  Errors: E_ARGUMENT (null, unknown coherence).  Since 1.0. */
ALGSURF_API algsurf_status algsurf_scene_set_coherence(algsurf_scene *scene, algsurf_coherence coherence);

/* Called on the thread that called algsurf_render, after each finished row of that thread and ten times a
 * second while it waits, with the number of rows done by all threads.  It must return; if it returns non-zero
 * the picture is cancelled: unfinished rows are abandoned.  In a picture that is not cancelled the last call
 * has rows_done = rows_total, the rows of the slice. */
typedef int (*algsurf_progress)(int rows_done, int rows_total, void *data);

/* Size and part of a picture, threads, and who is told. */
typedef struct algsurf_render_options {
    size_t size;               /* sizeof(algsurf_render_options) */
    int width, height;         /* of the whole picture, 1..65535 each */
    int row_begin, row_end;    /* the slice to draw, 0 <= row_begin < row_end <= height; both 0: all */
    int threads;               /* 0: as many as there are processors; at most 256; fewer are used when there
                                  are fewer rows, or when the system refuses to start more */
    algsurf_progress progress; /* null: none is called */
    void *progress_data;       /* the caller's, passed through */
} algsurf_render_options;

/* What a picture took.  Tiles, and which rays are decided with them, one by one or by integers, are this
 * version's. */
typedef struct algsurf_render_stats {
    size_t size;          /* sizeof(algsurf_render_stats), set by the caller */
    uint64_t rays;        /* one for each sample of each pixel; with a threshold of antialiasing: one for the
                             middle of each pixel, and n x n more for each pixel chosen, or 4 where corners
                             were against it.  Counts are those of the rows drawn */
    uint64_t hits;        /* of them, ALGSURF_STATE_HIT */
    uint64_t undecided;   /* of all rays: ALGSURF_STATE_UNDECIDED; drawn like hits, not counted among them */
    uint64_t shadow_rays; /* rays from points of the surface, to samples of lights and around, that were
                             traced one by one, because they were not decided together with the others from
                             their point */
    double solve_s;       /* seconds spent in intersection, summed over threads */
    double shade_s;       /* seconds spent in shading, summed over threads */
    double total_s;       /* wall time, not summed */
    int threads;          /* used, the caller's among them */
    uint64_t iterations;  /* complex space: corrections of single roots, summed over all rays */
    uint64_t single_rays; /* rays solved one by one: those undecided in their row, or all */
    double expand_s;      /* seconds spent in transforming the surface to the view and its rows */
    double point_s;       /* seconds spent in positions and normals of hits found by packets */
    double shadow_s;      /* seconds spent in shadows, summed over threads, as the two above */
    const char *kernel;   /* the SIMD code's name (algsurf_kernel_name) */
    uint64_t tiles;       /* squares of 16, 8 or 4 pixels a side that were searched.  A tile is empty, or a
                             sheet (algsurf_way); of the others, larger ones were quartered, and those of 4
                             are leaves.  A band of 16 rows that several slices share is searched, and
                             counted, by each of them; else tiles are the same for any slices and threads */
    uint64_t empty_tiles; /* of the tiles */
    uint64_t sheet_tiles; /* of the tiles */
    uint64_t leaf_tiles;  /* of the tiles */
    uint64_t empty_rays;  /* of all rays: those in empty tiles */
    uint64_t sheet_rays;  /* of all rays: those whose hit is their tile's sheet */
    uint64_t exact_rays;  /* of the single rays: those that integers decided */
    uint64_t thin;        /* samples that show something thin (algsurf_scene_set_thin), be there a hit behind
                             it or not */
} algsurf_render_stats;

/* How the pixels of a picture lie in memory, 8 bits a channel. */
typedef enum algsurf_pixel_format {
    ALGSURF_RGB8 = 0, /* red, green, blue.  Without a background it is black */
    /* Red, green, blue, alpha.  With a background alpha is 255 throughout.  Without one it is the share of
     * the pixel's samples that are hits, undecided or thin, and the colour is the average of those alone,
     * not multiplied by alpha; both are 0 where nothing is seen. */
    ALGSURF_RGBA8 = 1
} algsurf_pixel_format;

/* How a ray of a picture was decided: by this version; another may decide it otherwise. */
typedef enum algsurf_way {
    ALGSURF_WAY_EMPTY = 0, /* with its tile: it is proved that no ray of the tile hits */
    ALGSURF_WAY_SHEET = 1, /* with its tile: it is proved in which interval the first root of each ray is, and
                              that it is the only one there; Newton's method finds it */
    ALGSURF_WAY_ROW = 2,   /* by its own polynomial, side by side with others of its row */
    ALGSURF_WAY_SINGLE = 3 /* by itself */
} algsurf_way;

/* Where a picture goes: arrays in the caller's memory, which do not overlap.  A null array is not asked for;
 * if pixels is null, nothing is shaded but what a threshold of antialiasing compares.  Each array has an
 * entry for each pixel of the rows drawn, top row first, from left to right.  Rows of pixels are stride bytes
 * apart; those of the other arrays follow each other without a gap.
 *     An array's bytes do not depend on which others are asked for.  t, normals and state are those of one
 * sample of the pixel: of the samples that show the surface, an undecided place or something thin, the one
 * with the least t (if several have it the first of these, the corners of the n x n before the others, and
 * both row by row).  The ray of sample (j,k) of n x n is that of algsurf_camera_ray at (x + (j+0.5)/n, y +
 * (k+0.5)/n).  n is 1 for a pixel that a threshold of antialiasing leaves with one sample. */
typedef struct algsurf_picture {
    size_t size;           /* sizeof(algsurf_picture) */
    unsigned char *pixels; /* sRGB bytes of the average of the samples' colours (algsurf_srgb_encode) */
    size_t stride;         /* bytes from one row of pixels to the next, at least those of a row, at most
                              PTRDIFF_MAX / the number of rows drawn; 0: those of a row */
    int format;            /* of the pixels, an algsurf_pixel_format */
    double *t;             /* t of the sample along its ray, which has a direction of unit length; complex
                              space: |t|; +inf where no sample shows anything.  The error of t is at most
                              what rounding of the ray, of t and of P can cause, plus 2^-36 of the extent's
                              radius (all of space: of what the picture shows about the origin) */
    float *normals;        /* x, y, z of the unit normal there, as algsurf_hit.normal, not turned towards the
                              viewer; all 0 if that is 0, and where no sample shows anything */
    unsigned char *state;  /* an algsurf_hit_state.  HIT; UNDECIDED: t and normal are those of the undecided
                              place; THIN: t is that of something thin beside the ray, as a rule right
                              to a pixel's width, and the normal is 0; MISS where no sample shows anything */
    unsigned char *way;    /* way & 3: the largest algsurf_way of the pixel's samples; way & ~3: the side, 16,
                              8 or 4, of the tile that the pixel is in, 0 if there are no tiles.  A tile's
                              first pixel is at multiples of its side in the whole picture */
} algsurf_picture;

/* Draws rows row_begin .. row_end-1 of the picture.
 *   picture  where to.  The rows drawn are rows 0 .. row_end-row_begin-1 of its arrays
 *   stats    null, or receives counts and times
 * Undecided samples are drawn as hits at that place and counted; an undecided shadow ray counts
 * as occluded.
 * Full quality, in real space: shadow rays start above the surface, by 1e-6 of the radius of what is shown.
 * With n x n samples a pixel, each sample traces one ray to each sample of a light; to a light with 0, 0
 * samples it traces 32/n^2 rays, rounded up.  16/n^2 rays, rounded up, go around: they end on a ball that
 * touches the surface at the point, on the viewer's side, and has half the radius of what is shown.  Rays
 * around, and rays to lights with 0, 0 samples, differ from pixel to pixel; they depend only on where the
 * pixel is in the whole picture.  These numbers, and how directions are chosen, are this version's.
 * Returns OK; CANCELLED (rows that were finished, which may be any, are valid, others untouched; stats counts
 * what was done.  Rays that lacked memory are counted as undecided: E_NO_MEMORY is not returned then).
 * Errors: E_ARGUMENT (null; an option, stride, or format out of range), E_NOT_FINITE (the picture or a
 * light leaves the range of double), E_NO_MEMORY (to draw at all: nothing is drawn; or to decide single rays:
 * these count as undecided, everything else is drawn, and stats is written), E_THREAD (a lock could not be
 * made).
 * Cost: real scenes with a bounded extent, the default method and a degree of at most 24 are drawn by
 * packets: 20 to 100 nanoseconds a sample for degrees 2 to 10, shading included; samples that packets leave
 * undecided, and all of other scenes, cost an intersection each.  Shadows: one ray for each light sample; up
 * to degree 7 the rays from a point to a light are decided together if possible, and up to degree 10 the
 * others share P's expansion about the point, 15 to 50 nanoseconds a ray.
 * t, normals and state: 1 to 4 nanoseconds a pixel.
 *     Up to degree 12, in pictures of many pixels, tiles of up to 16 x 16 pixels are proved, all at once, to
 * be empty or to see one sheet of the surface: there time grows with the outlines, not with the area.
 * Memory: some 200 bytes for each thread and pixel of a row, with tiles 300 more, with a threshold of
 * antialiasing 200 more, in complex space 32 more for each degree, allocated once.  58 KiB of stack.
 * Source: P in camera axes once a frame, by rows and by tiles; Descartes' rule on Bernstein coefficients for
 * neighbouring pixels, or tiles, side by side.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_render(const algsurf_scene *scene, const algsurf_render_options *options,
                                          const algsurf_picture *picture, algsurf_render_stats *stats);

#ifdef __cplusplus
}
#endif
#endif
