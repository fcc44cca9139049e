/* SPDX-License-Identifier: MIT */
/* The C library's memset over the whole frame: what filling a screen costs
 * without a renderer. It takes the first face's colour and draws nothing else,
 * so that it is a picture of W2 only. */
#include "contract/system.h"
#include "draw.h"

#include <string.h>

static uint8_t colour;

int draw_open(const fxl_scene_image *image)
{
    colour = image->scene.faces[0].material;
    return SYSTEM_EXIT_DONE;
}

bool draw_frame(const fxl_pose *pose, const fxl_band *band)
{
    (void)pose;
    memset(band->pixels, colour, (size_t)band->width * band->rows);
    return true;
}

uint32_t draw_memory(void)
{
    return 0;
}

const fxl_counters *draw_counters(void)
{
    static const fxl_counters none;
    return &none;
}
