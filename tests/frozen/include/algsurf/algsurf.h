/* algsurf/algsurf.h - the whole public interface of libalgsurf.
 *
 * Binary compatibility.  A program compiled against 1.0 runs with every later 1.x:
 *   functions      stay, with their parameters and what they promise; new ones are marked "Since";
 *   sized structs  those whose first member is their size may grow at the end.  Callers set size to sizeof
 *                  and what they do not use to 0, where 0 is allowed, as {.size = sizeof options, ...} does.
 *                  A size that is none of a release before the library's is E_ARGUMENT, unless it is larger
 *                  and what the library does not know is 0.  What an older caller's struct lacks is 0, the
 *                  default.  Structs that receive counts need only their size set;
 *   other structs  never change: algsurf_complex, _interval, _cinterval, _table, _integer; _real_root,
 *                  _bracket, _refined_root, _complex_root, _cpoly_zero; _term, _constant, _parse_error;
 *                  _ray, _extent, _hit, _sector; _camera, _light.  Enumerations in structs are int;
 *   algsurf_cell   is made by the library only, and may grow at its end;
 *   handles        (a surface, a scene, a solver) are opaque;
 *   numbers        of statuses and enumerators stay, and new ones may come: an unknown negative status is a
 *                  refusal, an unknown positive one is undecided or stopped early.
 * The last digits of approximate values, the width of enclosures, the colours of pixels and what is undecided
 * may change with a version, within what is guaranteed.  The rules that keep this are in lib/algsurf.map.
 */
#ifndef ALGSURF_ALGSURF_H
#define ALGSURF_ALGSURF_H
#include "algsurf/status.h"
#include "algsurf/interval.h"
#include "algsurf/poly.h"
#include "algsurf/observe.h"
#include "algsurf/isolate.h"
#include "algsurf/refine.h"
#include "algsurf/allroots.h"
#include "algsurf/batch.h"
#include "algsurf/select.h"
#include "algsurf/surface.h"
#include "algsurf/ray.h"
#include "algsurf/expand.h"
#include "algsurf/intersect.h"
#include "algsurf/camera.h"
#include "algsurf/shade.h"
#include "algsurf/render.h"
#endif
