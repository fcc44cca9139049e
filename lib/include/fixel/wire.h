/* SPDX-License-Identifier: MIT */
/* Wireframes: draws the edges of the faces that face the eye as lines, without removing hidden
 * ones. It is a separate path from a scene to a band, for inspection. It uses the line clippers
 * (D3, D4). And outlines over filled faces, which hide the edges behind them. */
#ifndef FXL_WIRE_H
#define FXL_WIRE_H

#include "fixel/line.h"
#include "fixel/lines.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The type of fxl_line_by_planes and fxl_line_by_codes. */
typedef bool (*fxl_wire_clipper)(fxl_clip_line *line, const fxl_volume *volume,
                                 uint32_t *intersections);

/* Counts of the band drawn last. They are the same for every band of a frame. */
typedef struct {
    uint32_t in;            /* edges of faces that face the eye, of visible instances */
    uint32_t outside;       /* edges of which the clipper left nothing */
    uint32_t refused;       /* edges with an end outside FXL_SCREEN_COORDINATE_MAX */
    uint32_t drawn;         /* edges drawn; one may still cover no pixel */
    uint32_t clipped;       /* of those drawn: cut by a plane */
    uint32_t intersections; /* intersections computed */
} fxl_wire_counters;

/* The caller owns the record. Its members are for reading only. */
typedef struct {
    const fxl_scene *scene;
    fxl_wire_clipper clipper;
    fxl_view view;
    fxl_volume volume;
    fxl_wire_counters counters;
    bool ready;
} fxl_wire;

/* Initialises a wireframe for a checked scene, a lens and one of the two line clippers.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: the lens is out of range.
 * With each of these statuses: *wire untouched. */
fxl_status fxl_wire_init(fxl_wire *wire, const fxl_scene *scene, const fxl_lens *lens,
                         fxl_wire_clipper clipper);

/* Begins a frame.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: the pose is beyond FXL_COORDINATE_MAX, or the centre or the scale of an instance's
 * placement is out of range.
 * FXL_E_PLACEMENT: an orientation is no rotation.
 * FXL_E_ORDER: no scene, or placements without a placement_code.
 * The frame begun before stays current if the scene has no placements. If it has placements, that
 * frame ends: drawing would read placements that are not checked, so
 * fxl_wire_draw answers FXL_E_ORDER until a frame begins. */
fxl_status fxl_wire_begin(fxl_wire *wire, const fxl_pose *pose);

/* Draws the frame's lines over a band that the caller has cleared: of palette indices, or of RGB565
 * if the band has a palette. Each line has its face's colour. The order is that of the scene: by
 * instance, face and edge. The pixels do not depend on the bands into which the caller divides the
 * frame. The ends of a line have the errors of a screen point, and where they are clipped those of
 * fxl_line_by_planes (docs/accuracy.md, section 1); its pixels are exact, given the ends.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: no frame begun.
 * FXL_E_RANGE: a band that is not of this screen.
 * FXL_E_ALIGNMENT: a band of RGB565 with pixels or a palette at an odd address.
 * With each of these statuses: band untouched. */
fxl_status fxl_wire_draw(fxl_wire *wire, const fxl_band *band);

/* Draws one line by the rule of docs/extras/wire.md. Exact, so a line has the same pixels in
 * either direction. Requires points within FXL_SCREEN_COORDINATE_MAX, and a band
 * of a screen of at most FXL_SCREEN_MAX by FXL_SCREEN_MAX pixels. */
void fxl_wire_line(const fxl_screen_point *start, const fxl_screen_point *end, uint8_t colour,
                   const fxl_band *band);

/* What draws outlines into a target with a depth buffer. A program that does not name it links none
 * of it. */
typedef struct fxl_outline_code fxl_outline_code;
extern const fxl_outline_code fxl_outlines_by_depth;

/* Colours of the palette, in which outlines are drawn. */
typedef struct {
    uint8_t line;       /* the colour of the outlines */
    uint8_t fill;       /* the colour of faces without a surface, if they do not keep theirs */
    bool keeps_colours; /* each face is filled with its own colour */
    /* &fxl_outlines_by_depth, of a target with a depth buffer; any other looks at none, and it may be
     * null. */
    const fxl_outline_code *code;
} fxl_outline_style;

/* The outlines of a renderer, which the caller owns. Members are internal. */
typedef struct {
    fxl_overdraw overdraw;
    fxl_outline_style style;
    uint16_t height;          /* of the screen */
    fxl_target target;        /* a copy of the renderer's, with outlines, if it has no depth */
    fxl_target_extras extras; /* of this copy */
} fxl_outlines;

/* Attaches outlines to a renderer, or, where style is null, detaches them. Faces are drawn with
 * their edges, so a face hides the edges behind it: for displays of 1 bit, or for a drawing. A face
 * with a surface shows it beneath its outline; a billboard has none. The pixels do not depend on
 * the bands.
 * Without a depth buffer faces come in the order of drawing, each drawn and then outlined. The pixels
 * of an outline are those of fxl_wire_line, after its ends were moved, by half a pixel at most, into
 * the rows that the polygon reaches. An edge both of whose ends are within 1/256 pixel of one side of
 * the screen, or beyond it, is not drawn: it is where the clipper cut. A cut at the near plane is
 * drawn.
 * With a depth buffer, which style->code draws into, each edge of a face that faces the eye is a
 * line of width 1 on that face, as of fxl_attach_lines; no cut is drawn. All are drawn after the
 * faces that are not blended. fxl_frame_release_scene is refused then.
 * The style is copied into *outlines, to which the renderer keeps a pointer. What else is
 * attached, before or after, does not matter. The next frame must begin anew.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: the renderer was never initialised.
 * FXL_E_ALIGNMENT: outlines is not aligned to 8 bytes.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_attach_outlines(fxl_renderer *renderer, fxl_outlines *outlines,
                               const fxl_outline_style *style);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_wire_reasons[];

#ifdef __cplusplus
}
#endif

#endif
