/* fit_view.c - what a program tells of its choices: see fit.h. */
#include "fit.h"

static void tell(const view *v, const fit_choice *choice) {
    const double *c = v->extent.centre, *size = v->extent.size, *e = v->eye, *l = v->look_at, *u = v->up;
    char text[600];
    int at = 0;
    if (choice->extent && v->extent.kind == ALGSURF_EXTENT_BOX)
        at += snprintf(text + at, sizeof text - (size_t)at, " --extent box:%.15g,%.15g,%.15g", size[0],
                       size[1], size[2]);
    else if (choice->extent)
        at += snprintf(text + at, sizeof text - (size_t)at, " --extent sphere:%.15g", v->extent.size[0]);
    if (choice->extent && (c[0] != 0 || c[1] != 0 || c[2] != 0))
        at += snprintf(text + at, sizeof text - (size_t)at, " --centre %.15g,%.15g,%.15g", c[0], c[1], c[2]);
    if (choice->camera)
        at += snprintf(text + at, sizeof text - (size_t)at,
                       " --eye %.15g,%.15g,%.15g --look-at %.15g,%.15g,%.15g", e[0], e[1], e[2], l[0], l[1],
                       l[2]);
    if (choice->camera && choice->turned) /* the eye has been turned already */
        at += snprintf(text + at, sizeof text - (size_t)at, " --up %.15g,%.15g,%.15g --turn 0,0", u[0], u[1],
                       u[2]);
    if (choice->narrowed) snprintf(text + at, sizeof text - (size_t)at, " --fov %.15g", choice->fov);
    if (choice->extent || choice->camera) cli_complain("chosen:%s", text);
}

void fit_view(view *v, const view_options *options, const algsurf_surface *surface, int extent_only,
              int thin) {
    fit_choice choice;
    algsurf_status status = fit_choose(v, options, surface, extent_only, thin, &choice);
    if (status == ALGSURF_E_NO_MEMORY) cli_no_memory();
    if (status != ALGSURF_OK) {
        (void)view_camera(v, 0, 1); /* of a bad camera it tells which options make it */
        cli_fail(CLI_BROKEN, "fitting the view: %s", algsurf_status_text(status));
    }
    tell(v, &choice);
}
