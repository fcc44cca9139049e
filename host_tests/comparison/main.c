/* SPDX-License-Identifier: MIT */
/* CLIPPER-HIDDEN lens|border|left|guard SCENE.fxls OUT.fxld [FRAMES]
 *
 * Draws the scene's path with the combination that the program was made for, as the boards'
 * programs of make clippers do, and prints what its clipper did, as JSON. Exit code 0: it
 * ran; else as boards/host. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "combination.h"
#include "comparison/spy.h"
#include "contract/display.h"
#include "contract/journal.h"
#include "contract/store.h"
#include "contract/system.h"
#include "path.h"

static const char *const names[] = {"lens", "border", "left", "guard"};

static uint8_t pixels[DRAW_PIXELS_MAX];

/* Without a list every face comes to a band, and there is one band. */
static bool draw_watched(const fxl_pose *pose, const fxl_band *band)
{
    fxl_renderer *renderer = draw_renderer();
    spy_watch(renderer, false);
    if (fxl_frame_begin(renderer, pose) != FXL_OK) {
        return false;
    }
    spy_watch(renderer, true);
    return fxl_frame_draw(renderer, band) == FXL_OK;
}

static int one_frame(const fxl_scene_image *image, walk_path *path, uint32_t number)
{
    const fxl_band band = {pixels, image->lens.width, image->lens.width, 0, image->lens.height};

    if (walk_path_next(path, 0) != FXL_OK) {
        return SYSTEM_EXIT_INPUT;
    }
    fxl_fill_band(&band, image->background);
    if (!journal_begin(number, &path->viewer.pose)) {
        return SYSTEM_EXIT_JOURNAL;
    }
    if (!draw_watched(&path->viewer.pose, &band)) {
        return SYSTEM_EXIT_RENDER;
    }
    return display_flush(0, 0, band.width, band.rows, pixels) && journal_end(draw_counters(), 0, 0)
               ? SYSTEM_EXIT_DONE
               : SYSTEM_EXIT_DISPLAY;
}

static int draw_all(const fxl_scene_image *image)
{
    const uint32_t frames = system_frames() != 0 ? system_frames() : image->frame_count;
    walk_path path;

    if (!journal_open(frames) ||
        !display_open(image->lens.width, image->lens.height, image->palette)) {
        return SYSTEM_EXIT_DISPLAY;
    }
    walk_path_begin(&path, image, false);
    for (uint32_t number = 0; number < frames; number++) {
        int code = one_frame(image, &path, number);
        if (code != SYSTEM_EXIT_DONE) {
            return code;
        }
    }
    return display_close() ? SYSTEM_EXIT_DONE : SYSTEM_EXIT_DISPLAY;
}

static void print(const spy_findings *of)
{
    printf(
        "{\"faces\": %" PRIu64 ", \"inside\": %" PRIu64 ", \"cut\": %" PRIu64
        ", \"outside\": %" PRIu64 ", \"degenerate\": %" PRIu64 ", \"refused\": %" PRIu64
        ", \"between\": %" PRIu64 ", \"crossing\": %" PRIu64 ", \"pieces\": %" PRIu64
        ",\n \"missed\": %" PRIu64
        ", \"max_error_units\": %.6g, \"max_error_units_at_all\": %.6g, \"beyond\": %" PRIu64
        ", \"vertices\": %d, \"screen_px\": %.6g, \"view_units\": %.8g, \"intersections\": %" PRIu64
        ", \"distances\": %" PRIu64 "}\n",
        of->faces, of->inside, of->cut, of->outside, of->degenerate, of->refused, of->between,
        of->crossing, of->pieces, of->missed, of->error, of->error_at_all, of->beyond, of->vertices,
        of->screen, of->view, of->intersections, of->distances);
}

static int run(spy_sides sides)
{
    fxl_scene_image image;
    fxl_scene_fault fault;
    size_t size = 0;
    const void *bytes = store_scene(&size);

    if (bytes == NULL) {
        return SYSTEM_EXIT_STORE;
    }
    if (fxl_scene_open(bytes, size, &image, &fault) != FXL_OK) {
        fprintf(stderr, "scene refused: %s %u\n", fault.what, (unsigned)fault.index);
        return SYSTEM_EXIT_SCENE;
    }
    if ((uint32_t)image.lens.width * image.lens.height > DRAW_PIXELS_MAX) {
        return SYSTEM_EXIT_CAPACITY;
    }
    int code = draw_open(&image);
    if (code != SYSTEM_EXIT_DONE) {
        return code;
    }
    if (!spy_begin(draw_renderer(), sides)) {
        return SYSTEM_EXIT_RENDER;
    }
    code = draw_all(&image);
    print(spy_end());
    return code;
}

int main(int argc, char **argv)
{
    int sides = -1;
    for (int i = 0; argc > 1 && i < (int)(sizeof names / sizeof *names); i++) {
        sides = strcmp(argv[1], names[i]) == 0 ? i : sides;
    }
    if (sides < 0) {
        fputs("usage: CLIPPER-HIDDEN lens|border|left|guard SCENE.fxls OUT.fxld [FRAMES]\n",
              stderr);
        return SYSTEM_EXIT_ARGUMENT;
    }
    system_start(argc - 1, argv + 1);
    int code = run((spy_sides)sides);
    if (fflush(stdout) != 0) {
        return SYSTEM_EXIT_ARGUMENT;
    }
    if (code != SYSTEM_EXIT_DONE) {
        system_exit(code);
    }
    return EXIT_SUCCESS;
}
