/* kernel_template.h - the code for packets of rays, as one kernel. */
#ifndef ALGSURF_RAYS_KERNEL_TEMPLATE_H
#define ALGSURF_RAYS_KERNEL_TEMPLATE_H
#include "kernel.h"
#if LANES > 4
#define MOST_DEGREE ALGSURF_MAX_WIDE_DEGREE
#endif
#include "packet_template.h"

const algsurf_i_rays_kernel KERNEL(algsurf_i_rays) = {.solve = solve_rays,
                                                      .of_one = LANES > 2 ? coefficients_of_one : NULL};

#endif
