/* decided_beside.c - see decided.h. */
#include "decided.h"

#include <dlfcn.h>
#include <math.h>
#include <stdlib.h>

#include "must.h"
#include "rays.h"

const beside_edition *beside_load(const char *file) {
    void *object = dlopen(file, RTLD_NOW | RTLD_LOCAL);
    const beside_edition *other = object ? dlsym(object, "beside") : NULL;
    if (!other) cli_fail(CLI_BAD_INPUT, "--beside: '%s' is not made by bench/beside", cli_quote(file).text);
    if (other->term_size != sizeof(algsurf_term) || other->extent_size != sizeof(algsurf_extent) ||
        other->ray_size != sizeof(algsurf_ray))
        cli_fail(CLI_BAD_INPUT, "--beside: '%s' has other rays, extents or terms", cli_quote(file).text);
    return other;
}

algsurf_surface *beside_surface(const beside_edition *other, const example *e) {
    size_t count;
    algsurf_term *terms = rays_terms(e->equation, &count);
    algsurf_surface *surface;
    if (other->surface_from_terms(terms, count, &surface) != ALGSURF_OK)
        cli_fail(CLI_BROKEN, "the other edition refuses the %s surface of degree %d", e->surface, e->degree);
    free(terms);
    return surface;
}

void beside_judge(const beside_edition *other, const example *e, const algsurf_surface *surface,
                  size_t *undecided, size_t *wrong) {
    *undecided = *wrong = 0;
    for (size_t i = 0; i < e->count; i++) {
        double t = NAN;
        beside_answer answer = other->first(surface, &e->extent, &e->ray[i], &t);
        if (answer == BESIDE_UNDECIDED)
            ++*undecided;
        else if (answer != BESIDE_HIT || !example_hit_at(e, i, t))
            ++*wrong;
    }
}
