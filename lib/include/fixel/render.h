/* SPDX-License-Identifier: MIT */
/* The frame loop (Listing 65.3, UpdateWorld): every stage, in order. */
#ifndef FXL_RENDER_H
#define FXL_RENDER_H

#include "fixel/clipper.h"
#include "fixel/order.h"
#include "fixel/scan.h"

/* A renderer: about 5 KB that the caller owns. Several may live at once; none
 * knows of another. Members are for reading only, but for the clipper. */
typedef struct {
    const fxl_scene *scene;
    fxl_order_entry *order; /* objects, then room for one model's faces */
    fxl_clipper clipper;    /* fxl_clip_by_view, or another set between two frames */
    bool ready;             /* a frame has begun */
    fxl_counters counters;
    fxl_view view;
    fxl_polygon polygon;
    fxl_clipper_work work;
    fxl_screen_polygon screen;
    fxl_scan scan;
} fxl_renderer;

/* Ties a renderer to a scene (checked by fxl_scene_open or fxl_scene_check), a
 * lens, and memory for the order of drawing: order_capacity entries, at least
 * scene->order_needed. Zeroes the counters.
 * FXL_E_ARGUMENT, FXL_E_CAPACITY: renderer untouched. */
fxl_status fxl_renderer_init(fxl_renderer *renderer, const fxl_scene *scene, const fxl_lens *lens,
                             fxl_order_entry *order, uint32_t order_capacity);

/* Begins a frame: camera, frustum, order of the objects; zeroes the counters
 * except refused_calls. Then draw the frame whole or in bands.
 * FXL_E_ARGUMENT, FXL_E_RANGE (pose): the frame before stays current; counted
 * in refused_calls. */
fxl_status fxl_frame_begin(fxl_renderer *renderer, const fxl_pose *pose);

/* Draws the frame's polygons over a band that the caller has cleared
 * (fxl_fill_band). The pixels are the same whatever bands a frame is cut into.
 * Polygons are counted by the band that holds row 0, so that a frame drawn in
 * bands counts each once.
 * FXL_E_ARGUMENT, FXL_E_ORDER (no frame begun), FXL_E_RANGE (a band that is
 * not of this screen): band untouched; counted in refused_calls. */
fxl_status fxl_frame_draw(fxl_renderer *renderer, const fxl_band *band);

#endif
