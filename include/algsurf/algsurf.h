/* algsurf/algsurf.h - the whole public interface of libalgsurf. */
#ifndef ALGSURF_ALGSURF_H
#define ALGSURF_ALGSURF_H
#include "algsurf/status.h"
#include "algsurf/interval.h"
#include "algsurf/poly.h"
#include "algsurf/isolate.h"
#include "algsurf/refine.h"
#include "algsurf/packet.h"
#include "algsurf/allroots.h"
#include "algsurf/select.h"
#include "algsurf/surface.h"
#include "algsurf/ray.h"
#include "algsurf/expand.h"
#include "algsurf/intersect.h"
#include "algsurf/camera.h"
#include "algsurf/shade.h"
#include "algsurf/render.h"
#endif
