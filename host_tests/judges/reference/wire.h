/* SPDX-License-Identifier: MIT */
/* Wireframes (docs/extras/wire.md), in double. */
#ifndef REF_WIRE_H
#define REF_WIRE_H

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

#endif
