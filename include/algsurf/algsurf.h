/* algsurf/algsurf.h - the whole public interface of libalgsurf.
 *
 * Types of answers.  A single answer, also a member of a struct, is an int that holds a number of the
 * enumeration named beside it.  Arrays of answers have a byte for each, with the same numbers, to save
 * memory:
 *   a state, kind or sign    int              algsurf_hit, algsurf_occluded, algsurf_select, algsurf_bracket
 *   yes or no                int              found, meets, empty, unique, converged: 1 or 0
 *   states of many           unsigned char    algsurf_hit_packet, algsurf_occluded_packet, algsurf_picture,
 *                                             algsurf_first_roots_batch
 *   signs of many            signed char      algsurf_hit_packet.side, algsurf_cell.signs
 *   numbers of roots, hits   int              one or many; multiplicities, capacities, indices likewise
 *   numbers of other things  size_t           terms, planes, lights, rays, polynomials
 * Where a state says whether there is a root or a hit, 0 is no, 1 is yes, 2 is undecided, 4 is refused.
 *
 * Binary compatibility.  A program compiled against 1.0 runs with every later 1.x:
 *   functions      stay, with their parameters and what they promise; new ones are marked "Since";
 *   sized structs  those whose first member is their size may grow at the end.  Callers set size to sizeof
 *                  and what they do not use to 0, as {.size = sizeof options, ...} does: 0 is the default,
 *                  unless the member's comment requires a value.  What an older caller's struct lacks counts
 *                  as 0.  A newer caller's larger struct, of 4096 bytes at most, is taken if the bytes that
 *                  the library does not know are 0.  Every other size is E_SIZE.  Of _stats,
 *                  and of the _lighting that a scene fills, only the size is read, and bytes that the library
 *                  does not know become 0;
 *   other structs  never change: algsurf_complex, _interval, _cinterval, _table, _integer; _real_root,
 *                  _bracket, _refined_root, _complex_root, _precise_root, _paper_zero; _term, _constant,
 *                  _parse_error; _ray, _extent, _plane, _hit, _sector; _camera, _light.  Enumerations in
 *                  structs are int.  A camera or a light grows by new kinds, which may use its reserved
 *                  numbers;
 *   algsurf_cell   is made by the library only, and may grow at its end;
 *   handles        (a surface, a scene, a solver, precise roots) are opaque;
 *   numbers        of statuses and enumerators stay, and new ones may come: an unknown negative status is a
 *                  refusal, an unknown positive one means undecided or stopped early;
 *   limits         ALGSURF_MAX_DEGREE, _MAX_POLY_DEGREE and _MAX_LIGHTS stay: programs size arrays by them.
 *                  _MAX_CLIP_PLANES, _MAX_LIMBS and _MAX_ROOT_BITS may become larger.
 * The last digits of approximate values, the width of enclosures, the colours of pixels, what is undecided,
 * and how an answer was found (cells, tiles, ways, counts) may change with a version, within what is
 * guaranteed.  The rules that keep this are in lib/algsurf.map.
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
#include "algsurf/papers.h"
#include "algsurf/surface.h"
#include "algsurf/ray.h"
#include "algsurf/enclose.h"
#include "algsurf/expand.h"
#include "algsurf/intersect.h"
#include "algsurf/camera.h"
#include "algsurf/shade.h"
#include "algsurf/render.h"
#endif
