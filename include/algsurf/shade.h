/* algsurf/shade.h - the colour of a point of a surface.
 *
 * Colours are red, green, blue in linear light: 0 is none, 1 all that a screen can show.  The bytes of a
 * picture, and those of "#2a80e0", are sRGB, which is another scale: algsurf_srgb_encode() and
 * algsurf_srgb_decode() convert from one to the other.
 *     Both sides of a surface are lit alike: the normal is turned towards the viewer, and the side decides
 * between two colours.
 */
#ifndef ALGSURF_SHADE_H
#define ALGSURF_SHADE_H
#include <stddef.h>

#include "algsurf/ray.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Largest number of lights of a scene. */
#define ALGSURF_MAX_LIGHTS 16

/* How a surface reflects light.  Every number is from 0 to 1; roughness is not 0.  Unlike in options, 0 is
 * not a default here: to change one member, copy *lighting.material as algsurf_scene_get_lighting() gives it,
 * change the copy and set that.  (A new scene has diffuse 0.72, ambient 0.135, fill 0.135, specular 0.32,
 * roughness 0.2, haze 0.2.) */
typedef struct algsurf_material {
    size_t size;       /* sizeof(algsurf_material) */
    double outside[3]; /* colour where P grows towards the viewer (P > 0 in front) */
    double inside[3];  /* colour of the other side */
    double diffuse;    /* weight of the lights */
    double ambient;    /* weight of light from all around, of which more comes from above */
    double fill;       /* weight of light from the eye, which no shadow takes away */
    double specular;   /* of the highlight; 1: its middle is white */
    double roughness;  /* how wide the highlight is: 0.1 is small and sharp, 0.5 covers half of a ball */
    double haze;       /* how much of its shading the farthest point loses; 1: all of it */
} algsurf_material;

/* The shapes of a light. */
typedef enum algsurf_light_kind {
    ALGSURF_LIGHT_AREA = 0 /* a point or a parallelogram */
} algsurf_light_kind;

/* A light: a point, or the parallelogram position + p edge_u + q edge_v, |p|, |q| <= 1/2.  Shadows are
 * computed from samples_u x samples_v of its points: p = a / (samples_u - 1) - 1/2 for a = 0, 1, ...,
 * samples_u - 1 (p = 0 if samples_u is 1), and q likewise.  If both numbers are 0, full quality takes some 32
 * points of the light for each pixel, different ones for the next pixel, so that shadows have soft edges.
 * Members that an initialiser leaves out are 0: {.position = ..., .colour = ..., .samples_u = 1,
 * .samples_v = 1} is a point light. */
typedef struct algsurf_light {
    double position[3];          /* of its middle, finite */
    double colour[3];            /* each from 0 to 1000; the weights of the default material are made for 1 */
    double edge_u[3], edge_v[3]; /* of the parallelogram, finite */
    int samples_u, samples_v;    /* 1..64 each; 1, 1 is a point light; or 0, 0 */
    int kind;                    /* an algsurf_light_kind */
    double reserved[8];          /* 0: numbers that later kinds may need */
} algsurf_light;

/* All that a colour depends on besides the point.  algsurf_scene_get_lighting() fills it for a scene. */
typedef struct algsurf_lighting {
    size_t size;                      /* sizeof(algsurf_lighting) */
    const algsurf_material *material; /* borrowed */
    const algsurf_light *lights;      /* borrowed; may be null if there are none */
    size_t light_count;               /* at most ALGSURF_MAX_LIGHTS */
    double up[3], forward[3]; /* unit vectors: which way is up in the picture, and away from the viewer */
    double centre[3], radius; /* a ball about what is shown, radius > 0 */
    int bounded; /* 1: nothing is shown outside the ball.  0: something may be; in the formula below z is
                    then constant, and so is O if `visible` is null */
} algsurf_lighting;

/* Position of sample (a,b) of a light, 0 <= a < samples_u, 0 <= b < samples_v.
 * Errors: E_ARGUMENT (also a colour out of range, an unknown kind, and a light with 0, 0 samples),
 * E_NOT_FINITE (the light, or the position overflows).  Since 1.0. */
ALGSURF_API algsurf_status algsurf_light_sample(const algsurf_light *light, int a, int b, double position[3]);

/* The colour of a point, as pictures of standard and full quality show it.  The formula is this version's; a
 * later one may shade otherwise, but calls and pictures alike.
 *   visible    null, as in standard quality: all lights reach the point.  Or light_count + 1 shares, 0..1:
 *              for each light the share of its points that nothing hides, and last the share of the
 *              directions around the point that are free
 *   point      on the surface
 *   normal     the unit normal grad P / |grad P|; 0 (a singular point) counts as a normal towards the viewer
 *   direction  of the view, from the viewer to the point, a unit vector
 *   colour     receives red, green, blue, each from 0 to 1
 * N is the normal, turned towards the viewer; V points to the viewer, L to a light's middle; all are unit
 * vectors (L is 0 for a light at the point).  nv = N.V, nl = N.L; q = (point - centre) / radius.
 * The light that arrives, in each channel:
 *     E = [diffuse sum_l colour_l K_l lambert(nl) + ambient (1 + 0.52 N.up) O + fill nv (0.35 + 0.65 O)]
 *         (1 - 0.35 (1 - nv)^3)
 *     lambert(x) = x for x >= 1/4, 0 for x <= -1/4, between them (x + 1/4)^2: light ends softly
 *     K_l = 0.15 + 0.85 visible_l, O likewise: no shadow is black.  With visible null K_l = 1, and
 *     O = 1 - 0.3 d, d = sqrt(max(0, (q.N)^2 + 1 - q.q)) - q.N within 0..2, how far it is along N to the
 *         end of the ball: what lies deep inside is darker (O = 1 if not bounded)
 * Of a base colour a, with luminance Y = 0.2126 red + 0.7152 green + 0.0722 blue, w = min(E, 1):
 *     c = a w (1 + (1 - w)^2 0.8 min(a/Y - 1, 3))    shade is richer in colour, not greyer (Y = 0: c = 0)
 *     c += (1 - c) S_l for each light l              its highlight,
 *         S_l = min(1, specular colour_l K_l g^2 min(1, 4 max(0, nl))),
 *         g = r h / (h - (1 - r) (nl + nv)^2), r = roughness^2, h = 2 + 2 L.V
 *     c += (a - c) haze z^2                          what is far: z = 1/2 + q.forward / 2 within 0..1
 *         (z = 1/2 if not bounded)
 * No c exceeds 1: for a <= 1 the factor of a w is at most 1 / w, and the later lines take weighted means.
 * It is computed in single precision, with +, -, *, / and square roots only: the same bits everywhere, and
 * within 1e-4 of the formula, nearly always 1e-5, for a roughness of 0.1 or more and lights at least a tenth
 * of the radius away.  A roughness below 2^-10 counts as that.
 * A pixel is made by algsurf_camera_ray, algsurf_intersect_first, algsurf_shade and algsurf_srgb_encode.
 * Errors: E_ARGUMENT (null; a number out of its range; a vector that is not a unit vector within 1e-6),
 * E_NOT_FINITE.  Cost: some 130 ns; pictures pay about 6 ns (AVX-512).
 * Source: Lambert; Blinn 1977 and Trowbridge, Reitz 1975 for the highlight.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_shade(const algsurf_lighting *lighting, const double *visible,
                                         const double point[3], const double normal[3],
                                         const double direction[3], double colour[3]);

/* The same in preview quality, without lights: E = 0.20 + 0.66 nv + 0.12 N.up, no highlight, haze 0.3
 * whatever the material says.  Errors: as above.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_shade_preview(const algsurf_lighting *lighting, const double point[3],
                                                 const double normal[3], const double direction[3],
                                                 double colour[3]);

/* The sRGB bytes of a colour, as pictures have them: a number below 0 counts as 0, one above 1 as 1; it is
 * rounded to one of 4096 steps of linear light, and that to the nearest byte.  Errors: E_ARGUMENT (null),
 * E_NOT_FINITE.
 * Source: IEC 61966-2-1.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_srgb_encode(const double colour[3], unsigned char bytes[3]);

/* The colour of sRGB bytes; encoding it gives the bytes back.  Errors: E_ARGUMENT (null).  Since 1.0. */
ALGSURF_API algsurf_status algsurf_srgb_decode(const unsigned char bytes[3], double colour[3]);

#ifdef __cplusplus
}
#endif
#endif
