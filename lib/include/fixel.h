/* SPDX-License-Identifier: MIT */
/* Fixel: a fixed-point 3-D renderer for microcontrollers.
 *
 * The laws, which SPEC.md states whole:
 *   - x right, y up, z forward, left-handed; screen y down; pixel centres at .5
 *   - world units 16.16 within +-8191; unit vectors 2.30; angles 2^32 a turn
 *   - coverage by non-zero winding at pixel centres, ties top-left
 *   - objects are drawn by layer, then far to near, then by number
 *   - the caller owns all memory; integers only; no heap; no hidden state
 *   - the same input gives the same frame, bit for bit, on every core
 *   - input outside its range is refused with a status and changes nothing
 * Not promised: that far-to-near order hides what it should (convex objects
 * that are well apart, it does); anything about input that breaks a stated
 * requirement of a function that returns no status.
 */
#ifndef FIXEL_H
#define FIXEL_H

#include "fixel/angle.h"
#include "fixel/beam.h"
#include "fixel/box.h"
#include "fixel/camera.h"
#include "fixel/clip.h"
#include "fixel/clip_view.h"
#include "fixel/clip_once.h"
#include "fixel/clip_record.h"
#include "fixel/clipper.h"
#include "fixel/clipper_room.h"
#include "fixel/cull.h"
#include "fixel/fill.h"
#include "fixel/format.h"
#include "fixel/frustum.h"
#include "fixel/half_space.h"
#include "fixel/hidden.h"
#include "fixel/lens.h"
#include "fixel/light.h"
#include "fixel/line.h"
#include "fixel/list.h"
#include "fixel/normalised.h"
#include "fixel/order.h"
#include "fixel/outcode.h"
#include "fixel/placed.h"
#include "fixel/plane.h"
#include "fixel/project.h"
#include "fixel/record.h"
#include "fixel/render.h"
#include "fixel/scan.h"
#include "fixel/scan_box.h"
#include "fixel/scene.h"
#include "fixel/span_buffer.h"
#include "fixel/sphere.h"
#include "fixel/split.h"
#include "fixel/status.h"
#include "fixel/transform.h"
#include "fixel/tree.h"
#include "fixel/triangle.h"
#include "fixel/view.h"
#include "fixel/viewer.h"
#include "fixel/wire.h"

#endif
