/* SPDX-License-Identifier: MIT */
/* A frame as the walk draws it on a board with certain settings, counted. */
#ifndef PREDICT_FRAME_H
#define PREDICT_FRAME_H

#include "frames/session.h"

/* The settings of predict/main.c, in its order. */
enum {
    PREDICT_BAND,
    PREDICT_ORDER,
    PREDICT_LIST,
    PREDICT_CACHE,
    PREDICT_LIST_MOST,
    PREDICT_FRAMES,
    PREDICT_COLUMNS,
    PREDICT_ROWS,
    PREDICT_SETTINGS
};

/* What a board with these settings has no room for; or null. taken: taken_bytes of the image. */
const char *predict_no_room(const fxl_scene_image *image, const uint32_t settings[PREDICT_SETTINGS],
                               uint32_t taken);

/* The renderer as the walk sets it up. Null, or what is wrong. */
const char *predict_set_up(session *run, const uint32_t settings[PREDICT_SETTINGS], uint32_t taken);

/* Draws frame `number` from a pose into pixels, of which there are as many as the lens says, of two bytes each; `counted` then has
 * what the library did. */
fxl_status predict_frame(session *run, const fxl_pose *pose, uint32_t number,
                         const uint32_t settings[PREDICT_SETTINGS], uint8_t *pixels);

#endif
