/* SPDX-License-Identifier: MIT */
/* The scene of two cubes with their edges as lines, for tests of lines. */
#ifndef LINE_SCENE_H
#define LINE_SCENE_H

#include "frame_bands.h"
#include "tiny_frames.h"
#include "fixel/lines.h"

enum {
    WIDTH = 48,
    HEIGHT = 36,
    BACKGROUND = 0,
    LINE = 200, /* colours from here on are of lines */
    EDGES = 12,
    PIXELS = WIDTH * HEIGHT,
    NEAR = 1 << 14, /* of the lens */
    FAR_BY_NEAR = 400 /* but where a test has another */
};

extern tiny_scene *tiny;
extern fxl_renderer renderer;
extern fxl_lines attached;
extern fxl_line lines[2 * EDGES + 16];
extern uint32_t line_map[3];
extern fxl_line_set set;
extern uint64_t memory[4096];
extern uint64_t cells[FXL_DEPTH_BYTES(WIDTH, HEIGHT, 32) / 8];
extern uint16_t palette[256];
extern uint8_t frame[PIXELS];
extern int32_t far_by_near; /* of the lens of config_of */

/* The targets of a palette with a depth buffer. */
extern const fxl_target *const depths[2];

/* The eye of a band that has lines of the world alone. */
extern const fxl_pose ahead;

/* The twelve edges of both cubes, each with its two faces, and a colour of its own. */
void make_edges(uint8_t width);

/* The same edges, which name no faces. */
void make_free_edges(uint8_t width);

/* With a depth buffer for the whole screen, where the target has one. */
fxl_config config_of(const fxl_target *target);

void start_with(const fxl_config *config, uint32_t memory_size);

/* The same for a target, with the lines attached or without. */
void start(const fxl_target *target, bool has_lines);

void draw(const fxl_pose *pose, uint8_t *to);

/* Begins a frame and draws all of it into one band. */
void begin_band(const fxl_pose *pose);

static inline fxl_band whole_band(uint8_t *pixels)
{
    const fxl_band band = UNIT_BAND(pixels, WIDTH, 0, HEIGHT);
    return band;
}

/* The code that a depth buffer of 16 or 32 bits keeps for a pixel: of 32 bits, times 65536. */
static inline uint32_t cell_at(uint32_t bits, int32_t pixel)
{
    const void *first = &cells[1];
    return bits == 16 ? ((const uint16_t *)first)[pixel] : ((const uint32_t *)first)[pixel];
}

/* The code of a depth by SPEC.md, section 10.3, with the renderer's lens; and that of the straight line that it follows in the octave of another
 * depth. */
double exact_code(double depth);
double exact_code_beyond(double depth, double other);

/* A code of 16 or 32 bits is so much too small, beside the rounding of what the plane has. */
void expect_code(double most, uint32_t bits, uint32_t code);

#endif
