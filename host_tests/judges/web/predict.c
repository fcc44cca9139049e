/* SPDX-License-Identifier: MIT */
/* What the library does in a frame, counted, as a WebAssembly module, for the site's page. It imports nothing; its host
 * (tools/templates/counter.mjs) writes a scene image and the settings of a board into the module's memory. */
#include <stdlib.h>

#include "frames/input.h"
#include "predict/counts.h"
#include "predict/frame.h"
#include "predict/shares.h"

#define EXPORTED(name) __attribute__((export_name(name)))

static session run;
static uint32_t settings[PREDICT_SETTINGS];
static fxl_pose pose;
static uint8_t *bytes, *pixels;

/* What the host reads, as words of 32 bits: each text is null, or what is wrong. */
static struct {
    const char *no_room, *wrong;
    uint32_t count; /* of counts */
    const char *const *names;
    const predict_counts *counts; /* of the last frame: doubles */
    uint32_t *settings;           /* in the order of predict/frame.h: written before open */
    fxl_pose *pose;               /* written before count */
} told;

static const char *const names[] = {
#define X(name) #name,
    PREDICT_COUNTS(X)
#undef X
};

/* Before open: where the host writes the scene image; null: there is not enough memory. */
EXPORTED("scene") uint8_t *scene_room(size_t size)
{
    told.count = sizeof names / sizeof *names;
    told.names = names;
    told.counts = &counted;
    told.settings = settings;
    told.pose = &pose;
    bytes = malloc(size + 1);
    return bytes;
}

EXPORTED("told") const void *what_is_told(void)
{
    return &told;
}

/* Opens the scene for a board with the settings. A module opens one. */
EXPORTED("open") void open_scene(size_t size)
{
    told.wrong = session_open_bytes(&run, bytes, size);
    if (told.wrong != NULL) {
        return;
    }
    const uint32_t taken = taken_bytes(&run.image);
    told.no_room = predict_no_room(&run.image, settings, taken);
    if (told.no_room == NULL) {
        pixels = session_memory((size_t)run.image.lens.width * run.image.lens.height * 2u);
        told.wrong = predict_set_up(&run, settings, taken);
    }
}

/* Counts frame `number` from the pose. */
EXPORTED("count") void count_frame(uint32_t number)
{
    const fxl_status status = predict_frame(&run, &pose, number, settings, pixels);
    told.wrong = status == FXL_OK ? NULL : fxl_status_text(status);
}

/* The host sees a trap. */
void give_up(const char *why)
{
    (void)why;
    __builtin_trap();
}
