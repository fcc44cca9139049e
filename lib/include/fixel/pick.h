/* SPDX-License-Identifier: MIT */
/* From the world to the screen and back: where a point of the world is on the screen, and which
 * instance and face is at a pixel. docs/extras/pick.md. */
#ifndef FXL_PICK_H
#define FXL_PICK_H

#include "fixel/render.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Where a point of the world is. */
enum {
    FXL_POINT_VISIBLE,    /* in the visible volume, on the screen */
    FXL_POINT_OFF_SCREEN, /* beyond a side of the screen, or beyond the far plane */
    FXL_POINT_NEAR,       /* nearer than the near plane, or behind the eye: not projected */
    FXL_POINT_BEYOND      /* projected, it is outside of FXL_SCREEN_COORDINATE_MAX */
};

/* A point of the world on the screen. */
typedef struct {
    fxl_screen_point at; /* pixels in 16.16; 0 for FXL_POINT_NEAR and FXL_POINT_BEYOND */
    fxl_q18_46 depth;    /* distance from the eye along forward; negative behind the eye */
    uint8_t place;       /* FXL_POINT_... */
} fxl_screen_place;

/* Finds where a point of the world is on the screen of a view: &renderer->frame.view, or another
 * with a pose. The pixel that holds it is (at.x >> 16, at.y >> 16). Faces that hide the point are
 * not looked for. The near and the far plane are those of the lens, moved inward by the inset.
 * Given the camera, `depth` is exact, and each coordinate is at most 0.52 units of 1/65536 pixel
 * from the exact one (docs/accuracy.md, section 1).
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: a view without a pose.
 * FXL_E_RANGE: a coordinate of the point outside of FXL_COORDINATE_MAX.
 * With each of these statuses: *place untouched. */
fxl_status fxl_find_on_screen(const fxl_view *view, const fxl_point *point,
                              fxl_screen_place *place);

/* The number that stands for no instance. Instances of a scene have lower ones. */
#define FXL_PICK_NONE 0xFFFFu

/* What is picked at a pixel. */
typedef struct {
    uint16_t instance; /* number in the scene, or FXL_PICK_NONE: nothing covers the pixel; in a
                          world, fxl_world_handle_at gives its handle */
    uint16_t face;     /* number within the model; 0 of a billboard, and without a face */
    uint8_t colour;    /* a palette index. Of a face: the colour after light and beams, in RGB565
                          after beams alone. Of a face with a surface: the face's own colour. Of a
                          billboard: that of the texel. 0 without a face */
} fxl_picked;

/* Finds what is shown at pixel (x, y) of the frame that was begun last: of the faces and billboards
 * that cover the pixel by the fill rule, the one that is in front as the renderer draws them, with
 * its order, its target and all that is attached to it. So with a depth buffer it is the nearest, and
 * by a tree the last in the tree's order. A hole is looked through: a texel of the key, or a pixel
 * that the stipple leaves out. Something that is blended is picked before what it covers. A line of
 * an outline is not picked: the face is, whose pixel it would be without outlines. Exact, with any
 * clipper and with light beams.
 *
 * The scene must be as it was when the frame began. By distance and without a depth buffer it costs
 * as much as drawing one row of the frame up to that face, near to far; else as much as one row. It
 * works in the renderer's workspace: no band of the frame may be drawn meanwhile, also not by
 * fxl_frame_draw_with. The frame stays, and its counters do.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: no frame begun, or it was released by fxl_frame_release_scene.
 * FXL_E_RANGE: a pixel outside of the screen.
 * With each of these statuses: *picked untouched; counted in refused_calls. */
fxl_status fxl_pick_face(fxl_renderer *renderer, uint16_t x, uint16_t y, fxl_picked *picked);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_pick_reasons[];

#ifdef __cplusplus
}
#endif

#endif
