/* SPDX-License-Identifier: MIT */
/* CLIPPER-HIDDEN lens|border|left|guard SCENE.fxls OUT.fxld [FRAMES]
 *
 * Draws the scene's path into a frame dump with the combination that the program was made for,
 * as the boards' programs of make clippers do: without a display list, a frame in one band.
 * Prints what its clipper did, as JSON. Exit code 0: it ran; 2: it could not. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "combination.h"
#include "comparison/spy.h"
#include "frames/dump.h"
#include "frames/input.h"
#include "frames/session.h"
#include "path.h"

enum {
    CACHE_ENTRIES = 256,
    PIECES_BYTES = 65536
};

static const char *const names[] = {"lens", "border", "left", "guard"};

/* Bytes for the target: what was chosen, or what it wants at the least. */
static uint32_t raster_bytes(const fxl_lens *lens)
{
    const fxl_target *target = combination_chosen.target;
    const uint32_t least = target && target->memory_size ? target->memory_size(lens) : 0;
    return least > 0 && least < combination_chosen.room ? combination_chosen.room : least;
}

static fxl_status set_up(session *run)
{
    const session_settings settings = {.clipper = combination_chosen.clipper,
                                       .order = combination_chosen.order,
                                       .target = combination_chosen.target,
                                       .without_surfaces = true,
                                       .cache_entries = CACHE_ENTRIES,
                                       .raster_bytes = raster_bytes(&run->image.lens),
                                       .pieces_bytes = PIECES_BYTES};
    session_reserve(run, &settings);
    return session_set_up(run, &settings);
}

/* Without a display list every face comes to a band, and there is one band. */
static fxl_status draw_watched(session *run, const fxl_pose *pose, uint8_t *pixels)
{
    spy_watch(&run->renderer, false);
    fxl_status status = fxl_frame_begin(&run->renderer, pose);
    spy_watch(&run->renderer, true);
    return status == FXL_OK ? session_draw_bands(&run->image.lens, 0, run->image.background, pixels,
                                                 session_draw_band, &run->renderer)
                            : status;
}

static fxl_status draw_all(session *run, dump *to, uint32_t frames)
{
    const size_t area = (size_t)run->image.lens.width * run->image.lens.height;
    uint8_t *pixels = session_memory(area);
    walk_path path;
    walk_path_begin(&path, &run->image, false);
    for (uint32_t number = 0; number < frames; number++) {
        fxl_status status = walk_path_next(&path, 0);
        session_play(run, number);
        if (status == FXL_OK) {
            status = draw_watched(run, &path.viewer.pose, pixels);
        }
        if (status != FXL_OK) {
            return status;
        }
        dump_frame(to, &path.viewer.pose, pixels, area, &run->renderer.workspace.counters, 0);
    }
    return FXL_OK;
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

static int run(spy_sides sides, const char *scene, const char *out, uint32_t frames)
{
    static session run;
    const char *wrong = session_open(&run, scene);
    if (wrong) {
        return fail(scene, wrong);
    }
    fxl_status status = set_up(&run);
    if (status != FXL_OK || !spy_begin(&run.renderer, sides)) {
        return fail(scene, fxl_status_text(status));
    }
    frames = frames > 0 ? frames : run.image.frame_count;
    dump to;
    if (!dump_begin(&to, out, &run.image, frames, 8)) {
        return fail(out, "it cannot be written");
    }
    status = draw_all(&run, &to, frames);
    if (!dump_end(&to)) {
        return fail(out, "it cannot be written");
    }
    if (status != FXL_OK) {
        return fail(scene, fxl_status_text(status));
    }
    print(spy_end());
    return fflush(stdout) == 0 ? 0 : fail("standard output", "nobody reads it");
}

int main(int count, char **arguments)
{
    int sides = -1;
    for (int i = 0; count > 1 && i < (int)(sizeof names / sizeof *names); i++) {
        sides = strcmp(arguments[1], names[i]) == 0 ? i : sides;
    }
    uint32_t frames = 0;
    if (sides < 0 || count < 4 || count > 5 || (count == 5 && !take_number(arguments[4], &frames))) {
        return fail("usage", "CLIPPER-HIDDEN lens|border|left|guard SCENE.fxls OUT.fxld [FRAMES]");
    }
    return run((spy_sides)sides, arguments[2], arguments[3], frames);
}
