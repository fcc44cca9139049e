/* SPDX-License-Identifier: MIT */
/* A board for the tests: CMock's mocks with callbacks that write down what the
 * walk did, and that fail where a test wants them to. */
#ifndef BOARD_DOUBLE_H
#define BOARD_DOUBLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fixel/types.h"
#include "scene_bytes.h"

#define FRAMES_MAX 8
#define NEVER      UINT32_MAX

typedef struct {
    /* What the test asks for. */
    const scene_bytes *scene; /* null: no store */
    size_t scene_size;        /* bytes of the partition */
    uint32_t frames_asked;
    bool live;
    uint32_t keys;                 /* that are held */
    const uint32_t *keys_of_frame; /* if not null: that are held, frame by frame */
    bool refuse_journal, refuse_display, refuse_close;
    uint32_t refuse_begin, refuse_flush, refuse_end; /* the how-manieth call, from 0 */
    uint64_t clock_step, flush_cost;
    uint32_t clock_backward; /* the how-manieth reading, from 0, is of an earlier time */
    /* What the walk did. */
    uint32_t announced, begun, flushes, ended, keys_read, clock_read, alive;
    bool display_is_open, display_was_opened, in_frame;
    uint64_t clock;
    fxl_pose poses[FRAMES_MAX];
    uint64_t instructions[FRAMES_MAX];
    fxl_counters counters[FRAMES_MAX];
    uint8_t pixels[FRAMES_MAX][SCENE_HEIGHT][SCENE_WIDTH];
    uint8_t times_covered[FRAMES_MAX][SCENE_HEIGHT];
    char text[1024];
} board_double;

extern board_double board;

/* A board that does all that is asked, with a scene. */
void board_double_begin(const scene_bytes *scene);

#endif
