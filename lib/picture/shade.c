/* shade.c - what is lit, from where and how: checks, and what kernels need to know of it. */
#include "../base/arithmetic.h"
#include "colours.h"

#include "../base/fpenv.h"
#include "../base/options.h"
#include "../base/vec.h"

#define LEAST_ROUGHNESS 0x1p-10 /* its square is far from the smallest floats */
#define BRIGHTEST 1000
#define SHORTEST_RADIUS 0x1p-1000 /* one over it is a double */
#define UNIT_SLACK 1e-6
#define FARTHEST_LIGHT 0x1p40 /* in radii; one farther away is brought here */

ALGSURF_KERNEL_CHOICE(colour)

/* Each of them from 0 to high: OK, E_ARGUMENT or E_NOT_FINITE. */
static algsurf_status check_range(const double *x, int count, double high) {
    for (int i = 0; i < count; i++)
        if (!isfinite(x[i])) return ALGSURF_E_NOT_FINITE;
    for (int i = 0; i < count; i++)
        if (!(x[i] >= 0 && x[i] <= high)) return ALGSURF_E_ARGUMENT;
    return ALGSURF_OK;
}

algsurf_status algsurf_i_colour_check(const double colour[3]) {
    return colour ? check_range(colour, 3, 1) : ALGSURF_E_ARGUMENT;
}

algsurf_status algsurf_i_material_read(const algsurf_material *given, algsurf_material *m) {
    algsurf_status status = algsurf_options_read(m, sizeof *m, given);
    if (status != ALGSURF_OK) return status;
    const double weights[] = {m->diffuse, m->ambient, m->fill, m->specular, m->roughness, m->haze};
    status = algsurf_i_colour_check(m->outside);
    if (status == ALGSURF_OK) status = algsurf_i_colour_check(m->inside);
    if (status == ALGSURF_OK) status = check_range(weights, 6, 1);
    return status == ALGSURF_OK && m->roughness == 0 ? ALGSURF_E_ARGUMENT : status;
}

static int samples_are_good(int u, int v) {
    return (u == 0 && v == 0) ||
           (u >= 1 && u <= ALGSURF_MAX_LIGHT_SAMPLES && v >= 1 && v <= ALGSURF_MAX_LIGHT_SAMPLES);
}

static algsurf_status check_light(const algsurf_light *light) {
    if (!light || !samples_are_good(light->samples_u, light->samples_v)) return ALGSURF_E_ARGUMENT;
    if (light->kind != ALGSURF_LIGHT_AREA || !algsurf_are_zero(light->reserved, 8)) return ALGSURF_E_ARGUMENT;
    if (!algsurf_is_finite3(light->position) || !algsurf_is_finite3(light->edge_u) ||
        !algsurf_is_finite3(light->edge_v))
        return ALGSURF_E_NOT_FINITE;
    return check_range(light->colour, 3, BRIGHTEST);
}

algsurf_status algsurf_i_lights_check(const algsurf_light *lights, size_t count) {
    if (count > ALGSURF_MAX_LIGHTS || (count > 0 && !lights)) return ALGSURF_E_ARGUMENT;
    algsurf_status status = ALGSURF_OK;
    for (size_t l = 0; status == ALGSURF_OK && l < count; l++) status = check_light(&lights[l]);
    return status;
}

void algsurf_i_light_place(const algsurf_light *light, int a, int b, double place[2]) {
    place[0] = light->samples_u > 1 ? (double)a / (light->samples_u - 1) - 0.5 : 0;
    place[1] = light->samples_v > 1 ? (double)b / (light->samples_v - 1) - 0.5 : 0;
}

/* What the shade of a base colour has more of than the colour itself: of what is more in it than on the
 * average. */
static void set_richer(const double base[3], double richer[3]) {
    double luminance = 0.2126 * base[0] + 0.7152 * base[1] + 0.0722 * base[2];
    for (int i = 0; i < 3; i++) {
        double more = luminance > 0 ? base[i] / luminance - 1 : 0;
        richer[i] = 0.8 * (more < 3 ? more : 3);
    }
}

/* A light's middle, from the centre, in the radius.  The half keeps sums in the range of double. */
static void place_light(const algsurf_light *light, const algsurf_lighting *lighting, double per_radius,
                        double place[3]) {
    double half[3];
    for (int i = 0; i < 3; i++) half[i] = 0.5 * light->position[i] - 0.5 * lighting->centre[i];
    double most = algsurf_max_abs(half), scale = 2 * per_radius;
    int near = most * scale <= FARTHEST_LIGHT;
    for (int i = 0; i < 3; i++) place[i] = near ? half[i] * scale : half[i] / most * FARTHEST_LIGHT;
}

void algsurf_i_colour_prepare(const algsurf_lighting *lighting, int preview, algsurf_i_colour_job *job) {
    *job = (algsurf_i_colour_job){.material = *lighting->material,
                                  .light_count = preview ? 0 : (int)lighting->light_count,
                                  .frame.per_radius = 1 / fmax(lighting->radius, SHORTEST_RADIUS),
                                  .bounded = lighting->bounded,
                                  .preview = preview};
    job->material.roughness = fmax(job->material.roughness, LEAST_ROUGHNESS);
    set_richer(job->material.outside, job->richer[0]);
    set_richer(job->material.inside, job->richer[1]);
    for (int i = 0; i < 3; i++) {
        job->up[i] = lighting->up[i];
        job->forward[i] = lighting->forward[i];
        job->frame.centre[i] = lighting->centre[i];
    }
    for (int l = 0; l < job->light_count; l++) {
        const algsurf_light *light = &lighting->lights[l];
        place_light(light, lighting, job->frame.per_radius, job->light[l]);
        for (int i = 0; i < 3; i++) job->light_colour[l][i] = light->colour[i];
    }
}

void algsurf_i_set_look(const algsurf_i_look_frame *frame, const double position[3], const double normal[3],
                        const double direction[3], int i, const algsurf_i_looks *looks) {
    for (int k = 0; k < 3; k++) {
        looks->place[k][i] = (float)((position[k] - frame->centre[k]) * frame->per_radius);
        looks->normal[k][i] = (float)normal[k];
        looks->direction[k][i] = (float)direction[k];
    }
}

/* ---- the public functions ---- */

ALGSURF_I_ENTRY(algsurf_status, light_sample, (const algsurf_light *light, int a, int b, double position[3]),
                (light, a, b, position)) {
    double place[2], made[3];
    algsurf_status status = check_light(light);
    if (status != ALGSURF_OK) return status;
    if (!position || a < 0 || b < 0 || a >= light->samples_u || b >= light->samples_v)
        return ALGSURF_E_ARGUMENT;
    algsurf_i_light_place(light, a, b, place);
    for (int i = 0; i < 3; i++)
        made[i] = light->position[i] + place[0] * light->edge_u[i] + place[1] * light->edge_v[i];
    if (!algsurf_is_finite3(made)) return ALGSURF_E_NOT_FINITE;
    for (int i = 0; i < 3; i++) position[i] = made[i];
    return ALGSURF_OK;
}

static int is_unit(const double v[3]) { return fabs(algsurf_dot(v, v) - 1) <= UNIT_SLACK; }

/* known, material: the caller's, as far as they are known here. */
static algsurf_status read_lighting(const algsurf_lighting *given, algsurf_lighting *known,
                                    algsurf_material *material) {
    algsurf_status status = algsurf_options_read(known, sizeof *known, given);
    if (status == ALGSURF_OK) status = algsurf_i_material_read(known->material, material);
    if (status == ALGSURF_OK) status = algsurf_i_lights_check(known->lights, known->light_count);
    if (status != ALGSURF_OK) return status;
    known->material = material;
    if (!algsurf_is_finite3(known->up) || !algsurf_is_finite3(known->forward) ||
        !algsurf_is_finite3(known->centre) || !isfinite(known->radius))
        return ALGSURF_E_NOT_FINITE;
    return is_unit(known->up) && is_unit(known->forward) && known->radius > 0 ? ALGSURF_OK
                                                                              : ALGSURF_E_ARGUMENT;
}

/* A point, by the code of pictures. */
static ALGSURF_NOINLINE algsurf_status shade(const algsurf_lighting *given, int preview,
                                             const double *visible, const double point[3],
                                             const double normal[3], const double direction[3],
                                             double colour[3]) {
    algsurf_lighting lighting;
    algsurf_material material;
    algsurf_i_colour_job job;
    float place[3], facing[3], along[3], shown[3];
    const algsurf_i_looks looks = {
        {place, place + 1, place + 2}, {facing, facing + 1, facing + 2}, {along, along + 1, along + 2}};
    if (!point || !normal || !direction || !colour) return ALGSURF_E_ARGUMENT;
    if (!algsurf_is_finite3(point) || !algsurf_is_finite3(normal) || !algsurf_is_finite3(direction))
        return ALGSURF_E_NOT_FINITE;
    if (!is_unit(direction) || (algsurf_max_abs(normal) > 0 && !is_unit(normal))) return ALGSURF_E_ARGUMENT;
    algsurf_status status = read_lighting(given, &lighting, &material);
    if (status != ALGSURF_OK) return status;
    if (visible) status = check_range(visible, (int)lighting.light_count + 1, 1);
    if (status != ALGSURF_OK) return status;
    algsurf_i_colour_prepare(&lighting, preview, &job);
    algsurf_i_set_look(&job.frame, point, normal, direction, 0, &looks);
    algsurf_i_colour_baseline.colours(&job, &looks, 1, visible, shown, NULL);
    for (int k = 0; k < 3; k++) colour[k] = shown[k];
    return ALGSURF_OK;
}

algsurf_status algsurf_shade(const algsurf_lighting *lighting, const double *visible, const double point[3],
                             const double normal[3], const double direction[3], double colour[3]) {
    algsurf_status status;
    ALGSURF_STANDARD(status = shade(lighting, 0, visible, point, normal, direction, colour));
    return status;
}

algsurf_status algsurf_shade_preview(const algsurf_lighting *lighting, const double point[3],
                                     const double normal[3], const double direction[3], double colour[3]) {
    algsurf_status status;
    ALGSURF_STANDARD(status = shade(lighting, 1, NULL, point, normal, direction, colour));
    return status;
}
