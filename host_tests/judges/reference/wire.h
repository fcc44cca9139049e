/* SPDX-License-Identifier: MIT */
/* Wireframes (docs/extras/wire.md), in double. */
#ifndef REF_WIRE_H
#define REF_WIRE_H

#include "reference/order.h"
#include "reference/scene.h"

typedef struct {
    ref_screen_point from, to;
    uint8_t colour;
} ref_screen_line;

typedef struct {
    ref_screen_line *lines;
    size_t count, capacity;
} ref_wire;

/* Computes the lines of a frame, in their order. Returns false where memory is short. A record
 * of zeroes is empty. */
bool ref_wire_frame(ref_wire *wire, const ref_scene *scene, const ref_lens *lens,
                    const ref_pose *pose);
void ref_wire_close(ref_wire *wire);

/* Draws a line over a band. */
void ref_wire_line(const ref_screen_line *line, const ref_band *band);

/* Tells whether a line that is moved by at most d pixels, along or across, may cover the pixel
 * or may leave it uncovered. */
bool ref_wire_is_near(const ref_screen_line *line, int column, int row, double d);

/* --- lines and points of models (docs/extras/lines.md) ----------------------------------------- */

/* Reads those of an image. Returns true also where it has none, false where they are not usable. */
bool ref_lines_read(const uint8_t *bytes, ref_scene *scene);

/* What a line is looked at by. */
typedef struct {
    const ref_scene *scene;
    const ref_camera *camera;
    const ref_lens *lens;
    const ref_view_frustum *frustum;
    const ref_lattice_point *eye;
    bool keeps_doubt;
} ref_line_view;

/* Sets the outline of a line's pixels, its colour and its depth. drawn->instance is that of the
 * line. Returns false where nothing of it can be drawn. */
bool ref_line_find(const ref_line_view *view, const ref_line *line, ref_drawn *drawn);

/* 1 / z of a line at a point of the screen, or of a face. */
double ref_drawn_nearness(const ref_drawn *drawn, const ref_lens *lens, double x, double y);

/* The most that it may be for the library. On a small face codes are linear (docs/extras/lines.md,
 * section 3.2): beside it they are above those of its plane beyond the face's octaves. */
double ref_drawn_nearness_most(const ref_drawn *drawn, const ref_lens *lens, double x, double y);

/* By how much of itself the library's nearness of what was drawn may be off there. The plane of a small
 * face goes through corners that are rounded on the screen (docs/accuracy.md, section 5.1.1): at a
 * pixel beside the face a line has more of that error than the face has anywhere. */
double ref_drawn_slack(const ref_drawn *drawn, const ref_lens *lens, double x, double y);

/* Whether a line lies on the face of another polygon: where both are as near, the line is seen. */
bool ref_lies_on(const ref_drawn *line, const ref_drawn *face);

#endif
