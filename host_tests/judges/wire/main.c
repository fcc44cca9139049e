/* SPDX-License-Identifier: MIT */
/* wire SCENE.fxls OUT.fxld [--frames N]
 *
 * Draws a scene's path as wireframes into a frame dump, what moves included, with both line
 * clippers and in bands of several heights, which must agree, and compares it with the reference
 * renderer. Prints what it found as JSON. Exit code 0: it ran; 2: it could not. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw/stages.h"
#include "fixel/all.h"
#include "frames/dump.h"
#include "frames/moving_reference.h"
#include "frames/input.h"
#include "frames/session.h"
#include "path.h"
#include "reference/wire.h"

#define EXPLAINED_AT (1.0 / 8192)

static uint8_t pixels[2][FXL_SCREEN_MAX * FXL_SCREEN_MAX];
static uint8_t expected[FXL_SCREEN_MAX * FXL_SCREEN_MAX]; /* the reference renderer's */

typedef struct {
    uint64_t lines, clipped, lit, differing, unexplained, disagreeing;
    uint64_t intersections[2]; /* plane by plane, by outcodes */
} findings;

static fxl_status draw_band(void *wire, const fxl_band *band)
{
    return fxl_wire_draw(wire, band);
}

static bool draw(fxl_wire *wire, const fxl_scene_image *image, const fxl_pose *pose, uint32_t rows,
                 uint8_t *to)
{
    return fxl_wire_begin(wire, pose) == FXL_OK &&
           session_draw_bands(&image->lens, rows, image->background, to, draw_band, wire) == FXL_OK;
}

static void compare(const ref_wire *lines, const fxl_scene_image *image, findings *found)
{
    const int width = image->lens.width, height = image->lens.height;
    const ref_band band = {expected, width, width, 0, height, NULL};
    memset(expected, image->background, (size_t)width * (size_t)height);
    for (size_t i = 0; i < lines->count; i++) {
        ref_wire_line(&lines->lines[i], &band);
    }
    for (int i = 0; i < width * height; i++) {
        found->lit += pixels[0][i] != image->background;
        found->disagreeing += pixels[0][i] != pixels[1][i];
        if (pixels[0][i] == expected[i]) {
            continue;
        }
        int is_near = 0;
        for (size_t k = 0; k < lines->count && !is_near; k++) {
            is_near = ref_wire_is_near(&lines->lines[k], i % width, i / width, EXPLAINED_AT);
        }
        found->differing++;
        found->unexplained += !is_near;
    }
}

static bool draw_all(const session *run, const ref_lens *lens, moving_reference *moving, dump *to,
                     uint32_t frames, findings *found)
{
    const fxl_scene_image *image = &run->image;
    static fxl_wire by_planes, by_codes;
    walk_path path;
    ref_wire lines = {0};
    const size_t area = (size_t)image->lens.width * image->lens.height;
    walk_path_begin(&path, image, false);
    bool done =
        fxl_wire_init(&by_planes, &image->scene, &image->lens, fxl_line_by_planes) == FXL_OK &&
        fxl_wire_init(&by_codes, &image->scene, &image->lens, fxl_line_by_codes) == FXL_OK;
    for (uint32_t i = 0; done && i < frames; i++) {
        session_play(run, i);
        moving_reference_play(moving, i);
        done = walk_path_next(&path, 0) == FXL_OK &&
               draw(&by_planes, image, &path.viewer.pose, image->lens.height, pixels[0]) &&
               draw(&by_codes, image, &path.viewer.pose, 1 + i % 16, pixels[1]);
        const fxl_pose *p = &path.viewer.pose;
        const ref_pose pose = {
            {p->position.x, p->position.y, p->position.z}, p->yaw, p->pitch, p->roll};
        done = done && ref_wire_frame(&lines, &moving->scene, lens, &pose);
        if (done) {
            const fxl_counters counters = {.in = by_planes.counters.in,
                                           .outside = by_planes.counters.outside,
                                           .refused = by_planes.counters.refused,
                                           .drawn = by_planes.counters.drawn,
                                           .clipped = by_planes.counters.clipped};
            compare(&lines, image, found);
            dump_frame(to, p, pixels[0], area, &counters, path.viewer.clamped);
            found->lines += by_planes.counters.drawn;
            found->clipped += by_planes.counters.clipped;
            found->intersections[0] += by_planes.counters.intersections;
            found->intersections[1] += by_codes.counters.intersections;
        }
    }
    ref_wire_close(&lines);
    return done;
}

static int save(const char *out, const session *run, const ref_lens *lens, moving_reference *moving,
                uint32_t frames, findings *found)
{
    dump to;
    if (!dump_begin(&to, out, &run->image, frames, 8)) {
        return fail(out, strerror(errno));
    }
    const bool done = draw_all(run, lens, moving, &to, frames, found);
    if (!dump_end(&to)) {
        return fail(out, "it cannot be written");
    }
    return done ? 0 : fail(out, "a frame cannot be drawn");
}

int main(int count, char **arguments)
{
    const char *files[2];
    uint32_t frames = 0;
    const argument known[] = {{"--frames", take_number, &frames}};
    if (!read_arguments(count, arguments, known, 1, files, 2)) {
        return fail("usage", "wire SCENE.fxls OUT.fxld [--frames N]");
    }
    size_t size;
    uint8_t *bytes = read_file(files[0], &size);
    if (!bytes) {
        return fail(files[0], "it cannot be read");
    }
    static session run;
    ref_scene_image reference;
    moving_reference moving;
    const char *wrong = session_open(&run, files[0]);
    wrong = wrong ? wrong : ref_scene_open(bytes, size, &reference);
    if (wrong) {
        return fail(files[0], wrong);
    }
    if (session_take_scale(&run.image) != FXL_OK) {
        return fail(files[0], "its lens is out of range");
    }
    if (!moving_reference_open(&moving, &reference, bytes, size)) {
        return fail(files[0], "no memory for what moves");
    }
    frames = frames > 0 && frames < run.image.frame_count ? frames : run.image.frame_count;
    findings found = {0};
    const int code = save(files[1], &run, &reference.lens, &moving, frames, &found);
    moving_reference_close(&moving);
    ref_scene_close(&reference);
    free(bytes);
    if (code != 0) {
        return code;
    }
    printf(
        "{\"frames\": %u, \"lines\": %llu, \"clipped\": %llu, \"intersections_by_planes\": %llu, "
        "\"intersections_by_codes\": %llu, \"pixels_drawn\": %llu, \"pixels_disagreeing\": %llu, "
        "\"pixels_differing\": %llu, \"pixels_unexplained\": %llu}\n",
        frames, (unsigned long long)found.lines, (unsigned long long)found.clipped,
        (unsigned long long)found.intersections[0], (unsigned long long)found.intersections[1],
        (unsigned long long)found.lit, (unsigned long long)found.disagreeing,
        (unsigned long long)found.differing, (unsigned long long)found.unexplained);
    return fflush(stdout) == 0 ? 0 : 2;
}
