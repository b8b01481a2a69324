/* solve_rays_template.h - the code for packets of rays, as one kernel. */
#ifndef ALGSURF_RAYS_SOLVE_RAYS_TEMPLATE_H
#define ALGSURF_RAYS_SOLVE_RAYS_TEMPLATE_H
#include "packets.h"
#if LANES > 4
#define MOST_DEGREE ALGSURF_MAX_WIDE_DEGREE
#endif
#include "packet_template.h"

const algsurf_i_rays_kernel KERNEL(algsurf_i_rays) = {.solve = solve_rays};

#endif
