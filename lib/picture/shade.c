/* shade.c - the colour of a point: ambient, Lambert's diffuse and Blinn's specular term.
 *
 * Blinn, Models of light reflection for computer synthesized pictures, 1977: the highlight is a power
 * of N.H, H half-way between the light and the viewer, in place of Phong's reflected ray.
 */
#include "../base/arithmetic.h"
#include "shade_impl.h"

#include "../base/fpenv.h"
#include "../base/options.h"
#include "../base/vec.h"
#include "../base/elementary.h"

#define PREVIEW_FAR 0.3 /* brightness at the far end of the extent; 1 at the near one */

algsurf_status algsurf_i_colour_check(const double colour[3]) {
    if (!colour) return ALGSURF_E_ARGUMENT;
    if (!algsurf_is_finite3(colour)) return ALGSURF_E_NOT_FINITE;
    return colour[0] >= 0 && colour[1] >= 0 && colour[2] >= 0 ? ALGSURF_OK : ALGSURF_E_ARGUMENT;
}

algsurf_status algsurf_i_material_read(const algsurf_material *given, algsurf_material *material) {
    if (!given || !algsurf_options_read(material, sizeof *material, given)) return ALGSURF_E_ARGUMENT;
    const double weights[3] = {material->ambient, material->diffuse, material->specular};
    algsurf_status status = algsurf_i_colour_check(material->outside);
    if (status == ALGSURF_OK) status = algsurf_i_colour_check(material->inside);
    if (status == ALGSURF_OK) status = algsurf_i_colour_check(weights);
    if (status != ALGSURF_OK) return status;
    if (!isfinite(material->shininess)) return ALGSURF_E_NOT_FINITE;
    return material->shininess > 0 ? ALGSURF_OK : ALGSURF_E_ARGUMENT;
}

algsurf_status algsurf_i_light_check(const algsurf_light *light) {
    if (!light || light->samples_u < 1 || light->samples_u > ALGSURF_MAX_LIGHT_SAMPLES ||
        light->samples_v < 1 || light->samples_v > ALGSURF_MAX_LIGHT_SAMPLES)
        return ALGSURF_E_ARGUMENT;
    if (!algsurf_is_finite3(light->position) || !algsurf_is_finite3(light->edge_u) ||
        !algsurf_is_finite3(light->edge_v))
        return ALGSURF_E_NOT_FINITE;
    return algsurf_i_colour_check(light->colour);
}

void algsurf_i_light_sample(const algsurf_light *light, int a, int b, double position[3]) {
    double u = light->samples_u > 1 ? (double)a / (light->samples_u - 1) - 0.5 : 0;
    double v = light->samples_v > 1 ? (double)b / (light->samples_v - 1) - 0.5 : 0;
    for (int i = 0; i < 3; i++)
        position[i] = light->position[i] + u * light->edge_u[i] + v * light->edge_v[i];
}

int algsurf_i_facing(const double normal[3], const double direction[3], double facing[3]) {
    double away = algsurf_dot(normal, direction);
    int singular = !(algsurf_max_abs(normal) > 0);
    for (int i = 0; i < 3; i++) facing[i] = singular ? -direction[i] : away > 0 ? -normal[i] : normal[i];
    return singular || !(away > 0);
}

/* Unit vectors from the point to a light's middle, and half-way from there to the viewer; 0 when they
 * have no direction. */
static void light_vectors(const algsurf_light *light, const double point[3], const double direction[3],
                          double to_light[3], double half_way[3]) {
    double sum[3];
    for (int i = 0; i < 3; i++) {
        half_way[i] = to_light[i] = 0;
        sum[i] = 0.5 * light->position[i] - 0.5 * point[i]; /* halves cannot overflow */
    }
    (void)algsurf_unit(sum, to_light);
    for (int i = 0; i < 3; i++) sum[i] = to_light[i] - direction[i];
    (void)algsurf_unit(sum, half_way);
}

void algsurf_i_shade(const algsurf_material *material, const algsurf_light *lights, int count,
                     const double *visible, const double point[3], const double normal[3],
                     const double direction[3], double colour[3]) {
    double n[3], to_light[3], half_way[3];
    const double *base = algsurf_i_facing(normal, direction, n) ? material->outside : material->inside;
    for (int i = 0; i < 3; i++) colour[i] = base[i] * material->ambient;
    for (int l = 0; l < count; l++) {
        light_vectors(&lights[l], point, direction, to_light, half_way);
        double share = visible ? visible[l] : 1.0, incidence = algsurf_dot(n, to_light);
        if (!(incidence > 0) || !(share > 0)) continue;
        double diffuse = share * material->diffuse * incidence;
        double specular = share * material->specular *
                          algsurf_i_pow(fmax(0, algsurf_dot(n, half_way)), material->shininess);
        for (int i = 0; i < 3; i++) colour[i] += lights[l].colour[i] * (diffuse * base[i] + specular);
    }
}

void algsurf_i_shade_preview(const algsurf_material *material, const double normal[3],
                             const double direction[3], double depth, double colour[3]) {
    double n[3], brightness = 1.0 - (1.0 - PREVIEW_FAR) * depth;
    const double *base = algsurf_i_facing(normal, direction, n) ? material->outside : material->inside;
    for (int i = 0; i < 3; i++) colour[i] = brightness * base[i];
}

/* ---- the public functions ---- */

static ALGSURF_NOINLINE algsurf_status checked_sample(const algsurf_light *light, int a, int b,
                                                      double position[3]) {
    algsurf_status status = algsurf_i_light_check(light);
    if (status != ALGSURF_OK) return status;
    if (!position || a < 0 || b < 0 || a >= light->samples_u || b >= light->samples_v)
        return ALGSURF_E_ARGUMENT;
    algsurf_i_light_sample(light, a, b, position);
    return ALGSURF_OK;
}

algsurf_status algsurf_light_sample(const algsurf_light *light, int a, int b, double position[3]) {
    algsurf_fpenv saved;
    algsurf_fpenv_enter(&saved);
    algsurf_status status = checked_sample(light, a, b, position);
    algsurf_fpenv_leave(&saved);
    return status;
}

static algsurf_status check_lights(const algsurf_light *lights, int count, const double *visible) {
    if (count < 0 || (count > 0 && !lights)) return ALGSURF_E_ARGUMENT;
    for (int l = 0; l < count; l++) {
        algsurf_status status = algsurf_i_light_check(&lights[l]);
        if (status != ALGSURF_OK) return status;
        if (visible && !(visible[l] >= 0 && visible[l] <= 1)) return ALGSURF_E_ARGUMENT;
    }
    return ALGSURF_OK;
}

static algsurf_status check_view(const algsurf_material *given, const double normal[3],
                                 const double direction[3], const double colour[3],
                                 algsurf_material *material) {
    if (!normal || !direction || !colour) return ALGSURF_E_ARGUMENT;
    if (!algsurf_is_finite3(normal) || !algsurf_is_finite3(direction)) return ALGSURF_E_NOT_FINITE;
    return algsurf_i_material_read(given, material);
}

static ALGSURF_NOINLINE algsurf_status checked_shade(const algsurf_material *material,
                                                     const algsurf_light *lights, int count,
                                                     const double *visible, const double point[3],
                                                     const double normal[3], const double direction[3],
                                                     double colour[3]) {
    if (!point) return ALGSURF_E_ARGUMENT;
    if (!algsurf_is_finite3(point)) return ALGSURF_E_NOT_FINITE;
    algsurf_material known;
    algsurf_status status = check_view(material, normal, direction, colour, &known);
    if (status == ALGSURF_OK) status = check_lights(lights, count, visible);
    if (status == ALGSURF_OK)
        algsurf_i_shade(&known, lights, count, visible, point, normal, direction, colour);
    return status;
}

algsurf_status algsurf_shade(const algsurf_material *material, const algsurf_light *lights, int count,
                             const double *visible, const double point[3], const double normal[3],
                             const double direction[3], double colour[3]) {
    algsurf_fpenv saved;
    algsurf_fpenv_enter(&saved);
    algsurf_status status = checked_shade(material, lights, count, visible, point, normal, direction, colour);
    algsurf_fpenv_leave(&saved);
    return status;
}

static ALGSURF_NOINLINE algsurf_status checked_preview(const algsurf_material *material,
                                                       const double normal[3], const double direction[3],
                                                       double depth, double colour[3]) {
    if (!(depth >= 0 && depth <= 1)) return ALGSURF_E_ARGUMENT;
    algsurf_material known;
    algsurf_status status = check_view(material, normal, direction, colour, &known);
    if (status == ALGSURF_OK) algsurf_i_shade_preview(&known, normal, direction, depth, colour);
    return status;
}

algsurf_status algsurf_shade_preview(const algsurf_material *material, const double normal[3],
                                     const double direction[3], double depth, double colour[3]) {
    algsurf_fpenv saved;
    algsurf_fpenv_enter(&saved);
    algsurf_status status = checked_preview(material, normal, direction, depth, colour);
    algsurf_fpenv_leave(&saved);
    return status;
}
