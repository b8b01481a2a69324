/* render_slice.c - see render_slice.h. */
#include "render_slice.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

enum { LARGEST = 65535 }; /* width, height: algsurf_render_options */

/* ---- the comment ---- */

render_slice_note render_slice_write(const render_slice *slice) {
    render_slice_note note;
    snprintf(note.text, sizeof note.text,
             "algsurf slice %dx%d rows %d:%d job %016" PRIx64 " pixels %016" PRIx64 " hits %016" PRIx64,
             slice->width, slice->height, slice->begin, slice->end, slice->job, slice->pixels, slice->hits);
    return note;
}

/* Only what would be written in the same way is accepted. */
int render_slice_read(const char *text, render_slice *slice) {
    render_slice s;
    if (sscanf(text,
               "algsurf slice %5dx%5d rows %5d:%5d job %16" SCNx64 " pixels %16" SCNx64 " hits %16" SCNx64,
               &s.width, &s.height, &s.begin, &s.end, &s.job, &s.pixels, &s.hits) != 7 ||
        strcmp(render_slice_write(&s).text, text) != 0)
        return 0;
    if (s.width < 1 || s.width > LARGEST || s.height > LARGEST || s.begin < 0 || s.begin >= s.end ||
        s.end > s.height)
        return 0;
    *slice = s;
    return 1;
}

/* ---- digests ---- */

static const uint64_t start = 0xcbf29ce484222325; /* FNV's offset basis */

static uint64_t add_byte(uint64_t digest, uint8_t byte) { return (digest ^ byte) * 0x100000001b3; }

static uint64_t add_text(uint64_t digest, const char *text) {
    do {
        digest = add_byte(digest, (uint8_t)*text);
    } while (*text++);
    return digest;
}

/* From the lowest byte up, as in a file of hits. */
static uint64_t add_numbers(uint64_t digest, const double *x, size_t count) {
    for (size_t i = 0; i < count; i++) {
        uint64_t bits;
        memcpy(&bits, &x[i], sizeof bits);
        for (int b = 0; b < 64; b += 8) digest = add_byte(digest, (uint8_t)(bits >> b));
    }
    return digest;
}

static uint64_t add_surface(uint64_t digest, const algsurf_surface *surface) {
    size_t count = algsurf_surface_term_count(surface);
    algsurf_term *terms = malloc(count * sizeof *terms);
    if (!terms || algsurf_surface_terms(surface, terms) != ALGSURF_OK) cli_no_memory();
    for (size_t i = 0; i < count; i++)
        digest = add_numbers(digest, (double[]){terms[i].i, terms[i].j, terms[i].k, terms[i].a}, 4);
    free(terms);
    return digest;
}

static uint64_t add_camera(uint64_t digest, const algsurf_camera *camera) {
    digest = add_numbers(digest, camera->eye, 3);
    digest = add_numbers(digest, camera->right, 3);
    digest = add_numbers(digest, camera->up, 3);
    digest = add_numbers(digest, camera->forward, 3);
    return add_numbers(digest, (double[]){camera->half_height, camera->kind}, 2);
}

static uint64_t add_look(uint64_t digest, const render_look *look) {
    const css_colour *const colours[] = {&look->outside, &look->inside, &look->background, &look->thin};
    for (int i = 0; i < 4; i++) {
        digest = add_byte(digest, (uint8_t)colours[i]->given);
        for (int k = 0; k < 3; k++) digest = add_byte(digest, colours[i]->srgb[k]);
    }
    digest = add_byte(add_byte(digest, (uint8_t)look->light), (uint8_t)look->paper);
    for (int l = 0; l < look->file_light_count; l++) {
        const jsurf_light *light = &look->file_lights[l];
        digest = add_numbers(digest, light->place, 3);
        digest = add_numbers(digest, &light->intensity, 1);
        for (int k = 0; k < 3; k++) digest = add_byte(digest, light->colour.srgb[k]);
    }
    return add_numbers(digest, look->place, 3);
}

uint64_t render_job_digest(const render_options *options, const algsurf_surface *surface,
                           const algsurf_extent *extent, const algsurf_camera *camera,
                           const algsurf_complex_space *space) {
    const cli_surface *given = &options->surface;
    const algsurf_intersect_options *intersect = &options->intersect;
    const double settings[] = {given->rounded,
                               (double)options->quality,
                               options->antialias,
                               options->antialias_threshold,
                               options->axes,
                               options->box,
                               options->thin,
                               (double)intersect->tier,
                               (double)intersect->method,
                               intersect->absolute_tolerance};
    uint64_t digest = add_text(start, algsurf_version());
    digest = add_text(digest, given->name ? given->name : given->equation ? given->equation : "");
    digest = add_surface(digest, surface);
    digest = add_numbers(digest, settings, sizeof settings / sizeof *settings);
    digest = add_look(digest, &options->look);
    digest = add_numbers(digest, extent->centre, 3);
    digest = add_numbers(digest, extent->size, 3); /* of a sphere, only the first is not 0 */
    digest = add_camera(digest, camera);
    for (size_t i = 0; i < options->clip.count; i++) {
        digest = add_numbers(digest, options->clip.plane[i].normal, 3);
        digest = add_numbers(digest, &options->clip.plane[i].offset, 1);
    }
    if (!space) return digest;
    digest = add_numbers(digest, (double[]){space->sector.sigma, space->sector.delta}, 2);
    return add_numbers(digest, space->imaginary, space->imaginary_count);
}

uint64_t render_pixels_digest(const uint8_t *pixels, size_t bytes) {
    uint64_t digest = start;
    for (size_t i = 0; i < bytes; i++) digest = add_byte(digest, pixels[i]);
    return digest;
}

uint64_t render_hits_digest(const double *hits, size_t count) { return add_numbers(start, hits, count); }
