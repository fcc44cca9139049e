/* SPDX-License-Identifier: MIT */
/* Lines and points over the vertices of a scene's models, with the depth of the faces that they lie
 * on. docs/extras/lines.md. */
#ifndef FXL_LINES_H
#define FXL_LINES_H

#include "fixel/render.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What became of the lines of the instances in sight. Each is counted once:
 * in == backfacing + outside + refused + drawn. */
typedef struct {
    uint32_t in;         /* lines of instances that the sphere test keeps */
    uint32_t backfacing; /* they name faces, and none of these faces the eye */
    uint32_t outside;    /* the clipper left nothing */
    uint32_t refused;    /* an end outside FXL_SCREEN_COORDINATE_MAX */
    uint32_t drawn;      /* one may still cover no pixel */
    uint32_t clipped;    /* of those drawn: cut by a plane */
} fxl_line_counters;

/* What is drawn over the faces of a band. Members are internal. */
typedef struct fxl_overdraw {
    FXL_ALIGN_8 fxl_shader shader;
    /* With a depth buffer: draws over a part of a band whose opaque faces are there. */
    void (*draw_over)(const fxl_renderer *renderer, fxl_workspace *workspace, const fxl_band *band);
    /* Without one: draws a record of the display list. Null: there are none. */
    void (*draw_record)(fxl_workspace *workspace, const fxl_screen_polygon *record,
                        const fxl_band *band);
} fxl_overdraw;

/* The lines of a renderer, which the caller owns. The counters may be read: of a frame they are
 * whole once the first band of the frame was drawn in the renderer's own workspace. Other members
 * are internal. */
typedef struct {
    fxl_overdraw overdraw;
    fxl_line_set set;
    fxl_line_counters counters;
    uint32_t frame; /* whose counters these are */
} fxl_lines;

/* Checks the lines of a scene. Requires a checked scene and tables as long as their counts; fault
 * may be null.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ALIGNMENT: line_map is not aligned to 4 bytes, or lines to 2.
 * FXL_E_COUNT: the count is out of its range, or line_map does not go from 0 up to it.
 * FXL_E_INDEX: a vertex or a face that the model does not have.
 * FXL_E_RANGE: a width is out of its range.
 * FXL_E_RESERVED: a reserved field is not 0.
 * With each of these statuses: *fault written. On FXL_OK *fault is untouched. */
fxl_status fxl_lines_check(const fxl_line_set *set, const fxl_scene *scene, fxl_scene_fault *fault);

/* Attaches the lines of a set to a renderer, or, where set is null, detaches them. Without a depth
 * buffer they come after the faces of their instance. With one they come after all faces that are
 * not blended, and a pixel of a line is drawn where its depth is not below the one that is kept
 * there; a line that names faces has the depth of the nearest of those that face the eye.
 * The set is copied into *lines, to which the renderer keeps a pointer; its tables are not. What else
 * is attached, before or after, does not matter. A line takes 32 bytes of a display list
 * without a depth buffer. With one the display list has no lines: each band reads the scene, and
 * fxl_frame_release_scene is refused. The next frame must begin anew; where set is null and there are
 * none, a frame that has begun stays.
 * Its pixels are exact given its ends on the screen, which have the errors of a vertex, and where
 * they are clipped those of fxl_line_by_codes. The depth of a line that names no face is off by less
 * than 2^-27 of itself, given the ends.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: the renderer has no target.
 * FXL_E_ALIGNMENT: lines is not aligned to 8 bytes.
 * The statuses of fxl_lines_check.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_attach_lines(fxl_renderer *renderer, fxl_lines *lines, const fxl_line_set *set);

/* A line of the world, or, where both ends are the same, a point. */
typedef struct {
    fxl_point from, to; /* within FXL_COORDINATE_MAX */
    uint8_t colour;     /* palette index */
    uint8_t width;      /* pixels, 1..FXL_LINE_WIDTH_MAX */
} fxl_world_line;

/* Draws a line of the world into a band over what is there: after fxl_frame_draw or
 * fxl_frame_draw_with, whose workspace it takes; null is the renderer's own. With a depth buffer a
 * pixel is drawn, and its depth kept, where it is not below the one that is kept there. Lines of a
 * band are not counted. Requires that the band is the one that was drawn last in this workspace.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: no frame begun, or a band whose pixels are not the target's.
 * FXL_E_RANGE: a band that is not of this screen; a coordinate or the width is out of its range.
 * FXL_E_ALIGNMENT: a target of 16 bits a pixel, and pixels or a palette at an odd address.
 * FXL_E_CAPACITY: the depth buffer holds only a part of the band.
 * With each of these statuses: band untouched; counted in refused_calls of the workspace. */
fxl_status fxl_frame_draw_line(fxl_renderer *renderer, fxl_workspace *workspace,
                               const fxl_world_line *line, const fxl_band *band);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_lines_reasons[];

#ifdef __cplusplus
}
#endif

#endif
