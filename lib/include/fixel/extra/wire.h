/* SPDX-License-Identifier: MIT */
/* Wireframes: the outlines of the faces that face the eye, as lines. A way of its own from a
 * scene to a band, for looking at things; nothing is hidden. It shows D3 and D4. */
#ifndef FXL_WIRE_H
#define FXL_WIRE_H

#include "fixel/extra/clippers/line.h"
#include "fixel/scene.h"
#include "fixel/stage/view.h"

#ifdef __cplusplus
extern "C" {
#endif

/* fxl_line_by_planes, fxl_line_by_codes. */
typedef bool (*fxl_wire_clipper)(fxl_clip_line *line, const fxl_volume *volume,
                                 uint32_t *intersections);

/* Of the band drawn last; they are the same for every band of a frame. */
typedef struct {
    uint32_t in;            /* edges of faces that face the eye, of objects in sight */
    uint32_t outside;       /* nothing of the edge is left */
    uint32_t refused;       /* an end off FXL_SCREEN_COORDINATE_MAX */
    uint32_t drawn;         /* it may still cover no pixel */
    uint32_t clipped;       /* of those drawn: cut by a plane */
    uint32_t intersections; /* worked out */
} fxl_wire_counters;

/* The caller owns it. Members are for reading only. */
typedef struct {
    const fxl_scene *scene;
    fxl_wire_clipper clipper;
    fxl_view view;
    fxl_volume volume;
    fxl_wire_counters counters;
    bool ready;
} fxl_wire;

/* Ties a wireframe to a checked scene, a lens and one of the two line clippers.
 * FXL_E_ARGUMENT: untouched. */
fxl_status fxl_wire_init(fxl_wire *wire, const fxl_scene *scene, const fxl_lens *lens,
                         fxl_wire_clipper clipper);

/* Begins a frame. FXL_E_ARGUMENT, FXL_E_RANGE (pose): the frame before stays current. */
fxl_status fxl_wire_begin(fxl_wire *wire, const fxl_pose *pose);

/* Draws the frame's lines over a band that the caller has cleared, each in its face's colour,
 * by object, face and corner in the order of the scene. The pixels are the same whatever
 * bands a frame is cut into. FXL_E_ARGUMENT, FXL_E_ORDER (no frame begun), FXL_E_RANGE (a
 * band that is not of this screen): band untouched. */
fxl_status fxl_wire_draw(fxl_wire *wire, const fxl_band *band);

/* One line, by the rule of docs/extras/wire.md. Exact, so that it is the same walked either
 * way. Requires points within FXL_SCREEN_COORDINATE_MAX and a band within 0..FXL_SCREEN_MAX. */
void fxl_wire_line(const fxl_screen_point *from, const fxl_screen_point *to, uint8_t colour,
                   const fxl_band *band);

#ifdef __cplusplus
}
#endif

#endif
