/* options.c - fuzzes the command line of the example program render: an argument a line.
 *
 * The parser ends the program for bad input; here exit, wrapped by the linker, comes back instead.  What it
 * had allocated by then is lost, so leaks are not looked for.
 */
#include <setjmp.h>

#include "cli_equation.h"
#include "fuzz.h"
#include "render_options.h"

enum { MOST_ARGUMENTS = 24 };

static jmp_buf back;
static int parsing; /* who else ends the program means it */

_Noreturn void __real_exit(int status);
_Noreturn void __wrap_exit(int status);
_Noreturn void __wrap_exit(int status) {
    if (parsing) longjmp(back, 256 + status);
    __real_exit(status);
}

static void check_options(const render_options *o) {
    fuzz_check(o->view.width >= 1 && o->view.width <= 65535 && o->view.height >= 1 &&
               o->view.height <= 65535);
    /* beside --list rows are not compared with a picture that is not drawn */
    fuzz_check(o->row_begin >= 0 && o->row_begin <= o->row_end);
    fuzz_check(o->list || o->row_end <= o->view.height);
    fuzz_check(o->antialias >= 1 && o->antialias <= 16 && o->threads >= 0 && o->threads <= 256);
    fuzz_check(o->a_second >= 0 && o->a_second <= 60 &&
               (o->a_second == 0 || o->list || o->sweep.pictures > 0));
    fuzz_check(o->view.fov >= 0 && o->view.fov < 180 && o->view.orthographic >= 0 &&
               isfinite(o->view.orthographic));
    fuzz_check(o->intersect.absolute_tolerance >= 0 && isfinite(o->intersect.absolute_tolerance));
    for (int i = 0; i < 3; i++) {
        fuzz_check(isfinite(o->view.eye.x[i]) && isfinite(o->view.look_at.x[i]) && isfinite(o->view.up.x[i]));
        fuzz_check(isfinite(o->view.centre.x[i]) && isfinite(o->view.extent.extent.size[i]));
    }
    for (size_t i = 0; i < o->surface.let_count; i++)
        fuzz_check(cli_is_constant_name(o->surface.lets[i].name) && o->surface.lets[i].value[0]);
}

/* From the options to the first camera, as render does it. */
static void check_camera(const render_options *o) {
    const catalogue_entry *entry = o->surface.name ? catalogue_find(o->surface.name) : NULL;
    view shown = view_make(&o->view, entry);
    algsurf_camera camera = view_camera(&shown, 0, 1);
    algsurf_ray ray;
    fuzz_check(camera.half_height > 0 && isfinite(camera.half_height));
    fuzz_check(algsurf_camera_ray(&camera, o->view.width, o->view.height, 0.5, 0.5, &ray) <= ALGSURF_OK);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static char *text; /* static: they must outlive the jump */
    static char program[] = "render", *argv[MOST_ARGUMENTS + 2];
    int argc = 0;
    text = fuzz_string(data, size);
    argv[argc++] = program;
    for (char *at = text; at && argc <= MOST_ARGUMENTS;) {
        argv[argc++] = at;
        at = strchr(at, '\n');
        if (at) *at++ = '\0';
    }
    argv[argc] = NULL;
    parsing = 1;
    int status = setjmp(back);
    if (status == 0) {
        render_options options = render_parse_options(argc, argv);
        check_options(&options);
        if (!options.list) check_camera(&options);
        if (!options.list && !options.surface.terms) algsurf_surface_free(cli_make_surface(&options.surface));
        free(options.default_output);
        cli_forget_surface(&options.surface);
    } else {
        fuzz_check(status == 256 + CLI_BAD_INPUT || status == 256);
    }
    parsing = 0;
    free(text);
    return 0;
}
