/* SPDX-License-Identifier: MIT */
/* predict SCENE.fxls BAND_BYTES ORDER_ENTRIES LIST_BYTES CACHE_ENTRIES LIST_MOST FRAMES COLUMNS ROWS
 *
 * Walks a scene's path as firmware/walk does on a board with these settings, and prints what the
 * library did in each frame, the boxes in which the frame differs from the one before, widened to
 * COLUMNS and ROWS (fxl_changed_widen), and the bytes of the display list, as JSON. ORDER_ENTRIES: 0: as many as the scene needs. LIST_MOST:
 * bytes that limit the display list alone. FRAMES: at most so many; 0: all. Exit code 0: it ran; 1:
 * the board has no room; 2: it could not. */
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "frames/input.h"
#include "frames/session.h"
#include "path.h"
#include "predict/counts.h"
#include "predict/frame.h"
#include "predict/shares.h"

static bool parse(int count, char **words, uint32_t settings[PREDICT_SETTINGS])
{
    if (count != PREDICT_SETTINGS + 2) {
        return false;
    }
    for (int i = 0; i < PREDICT_SETTINGS; i++) {
        if (!take_number(words[i + 2], &settings[i])) {
            return false;
        }
    }
    return true;
}

static void print_counts(bool first)
{
    const double values[] = {
#define X(name) counted.name,
        PREDICT_COUNTS(X)
#undef X
    };
    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
        printf("%s%.0f", i > 0 ? ", " : first ? "\n[" : ",\n[", values[i]);
    }
    printf("]");
}

/* Boxes of all frames, four numbers each. */
static uint16_t (*found_boxes)[FXL_CHANGED_BOXES_MAX][4];

/* Finds the boxes of the frame that was drawn, for the end of what is printed. */
static fxl_status find_boxes(fxl_changed *changed, const session *run, const uint32_t *settings,
                             uint32_t frame)
{
    fxl_status status = fxl_changed_find(changed, &run->renderer);
    if (status == FXL_OK) {
        status = fxl_changed_widen(changed, settings[PREDICT_COLUMNS], settings[PREDICT_ROWS]);
    }
    for (uint32_t i = 0; status == FXL_OK && i < changed->count; i++) {
        const fxl_screen_box *box = &changed->boxes[i];
        const uint16_t numbers[4] = {box->first_column, box->columns, box->first_row, box->rows};
        memcpy(found_boxes[frame][i], numbers, sizeof numbers);
    }
    return status;
}

static void print_boxes(uint32_t frames)
{
    printf("],\n\"boxes\": [");
    for (uint32_t i = 0; i < frames; i++) {
        printf("%s[", i > 0 ? ",\n" : "\n");
        for (uint32_t j = 0; j < FXL_CHANGED_BOXES_MAX && found_boxes[i][j][1] > 0; j++) {
            const uint16_t *box = found_boxes[i][j];
            printf("%s[%u, %u, %u, %u]", j > 0 ? ", " : "", box[0], box[1], box[2], box[3]);
        }
        printf("]");
    }
}

static fxl_status draw_all(session *run, uint32_t frames, const uint32_t settings[PREDICT_SETTINGS])
{
    const fxl_scene *scene = &run->image.scene;
    const size_t kept =
        8u * (size_t)FXL_CHANGED_MEMORY(scene->instance_count, scene->instance_count,
                                        scene->model_count, scene->model_count);
    fxl_changed changed;
    found_boxes = session_memory((frames + 1u) * sizeof *found_boxes);
    memset(found_boxes, 0, (frames + 1u) * sizeof *found_boxes);
    if (fxl_changed_init(&changed, session_memory(kept + 8u), kept) != FXL_OK) {
        return FXL_E_CAPACITY;
    }
    uint8_t *pixels = session_memory((size_t)run->image.lens.width * run->image.lens.height * 2u);
    walk_path path;
    walk_path_begin(&path, &run->image, false);
    for (uint32_t i = 0; i < frames; i++) {
        fxl_status status = walk_path_next(&path, 0);
        if (status == FXL_OK) {
            status = predict_frame(run, &path.viewer.pose, i, settings, pixels);
        }
        if (status != FXL_OK) {
            return status;
        }
        print_counts(i == 0);
        status = find_boxes(&changed, run, settings, i);
        if (status != FXL_OK) {
            return status;
        }
    }
    print_boxes(frames);
    return FXL_OK;
}

int main(int count, char **arguments)
{
    static session run;
    uint32_t settings[PREDICT_SETTINGS];
    if (!parse(count, arguments, settings)) {
        return fail("usage", "predict SCENE.fxls BAND_BYTES ORDER_ENTRIES LIST_BYTES "
                             "CACHE_ENTRIES LIST_MOST FRAMES COLUMNS ROWS");
    }
    const char *wrong = session_open(&run, arguments[1]);
    const uint32_t taken = wrong == NULL ? taken_bytes(&run.image) : 0;
    const char *no_room = wrong == NULL ? predict_no_room(&run.image, settings, taken) : NULL;
    if (no_room != NULL) {
        fail(arguments[1], no_room);
        return 1;
    }
    wrong = wrong != NULL ? wrong : predict_set_up(&run, settings, taken);
    if (wrong != NULL) {
        return fail(arguments[1], wrong);
    }
    const uint32_t frames =
        settings[PREDICT_FRAMES] > 0 && settings[PREDICT_FRAMES] < run.image.frame_count
            ? settings[PREDICT_FRAMES]
            : run.image.frame_count;
    printf("{\"list_bytes\": %" PRIu32 ",\n\"names\": [", 4 * run.memory.display_list_capacity);
    const char *const names[] = {
#define X(name) #name,
        PREDICT_COUNTS(X)
#undef X
    };
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        printf("%s\"%s\"", i > 0 ? ", " : "", names[i]);
    }
    printf("],\n\"frames\": [");
    const fxl_status status = draw_all(&run, frames, settings);
    if (status != FXL_OK) {
        return fail(arguments[1], fxl_status_text(status));
    }
    printf("]}\n");
    return fflush(stdout) == 0 ? 0 : 2;
}
