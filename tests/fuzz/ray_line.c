/* ray_line.c - fuzzes the lines of rays that examples/intersect.c reads, with all it does with them.
 *
 * The reader is not a file of its own, hence the whole program is taken in, under another name for main.
 */
#define main intersect_main
#include "../../examples/intersect.c"
#undef main
#include "fuzz.h"

static algsurf_surface *torus(void) {
    static algsurf_surface *surface;
    const char *equation = "(x^2 + y^2 + z^2 + 3)^2 = 16 (x^2 + y^2)";
    if (!surface) fuzz_check(algsurf_surface_from_equation(equation, NULL, 0, &surface, NULL) == ALGSURF_OK);
    return surface;
}

/* A line that parses must give a ray that the library takes. */
static void check_line(run *r, cli_line *line) {
    char *field[8];
    algsurf_ray ray;
    int fields = cli_split(line, field, 8);
    if ((fields != 6 && fields != 8) || !parse_ray(line->number, field, fields, &ray)) return;
    for (int i = 0; i < 3; i++) fuzz_check(isfinite(ray.origin[i]) && isfinite(ray.direction[i]));
    fuzz_check(!isnan(ray.t_min) && !isnan(ray.t_max));
    fuzz_check(meet(r, line->number, &ray));
}

static void take(run *r, const uint8_t *data, size_t size, void (*each)(run *, cli_line *)) {
    FILE *file = fmemopen((void *)(uintptr_t)data, size, "rb");
    cli_line line = {.number = 0};
    fuzz_check(file);
    while (cli_read_line(file, &line) == CLI_LINE_READ) each(r, &line);
    free(line.text);
    fclose(file);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2.5, 0, 0}};
    const algsurf_intersect_options how = {.size = sizeof how};
    algsurf_hit hits[5];
    run r = {.surface = torus(), .how = &how, .hits = hits, .capacity = 5};
    if (size == 0) return 0;
    take(&r, data, size, take_line);
    r.all = 1, r.extent = &ball;
    take(&r, data, size, check_line);
    free(r.out.row);
    (void)program, (void)take_lines;
    return 0;
}
