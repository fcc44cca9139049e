/* SPDX-License-Identifier: MIT */
/* live SCENE.fxls [--clipper NAME] [--hidden NAME]
 *
 * Draws with the reference renderer, pose by pose. A request on standard
 * input is 36 bytes, an answer on standard output a head of 16 bytes and what
 * the request asked for; all little-endian, as in docs/formats.md, section 1:
 *
 *   request  bytes A S K S; u8 wants (1 frame, 2 outlines); u8 x 3, 0; pose; u32
 *            number of the frame, which says where things are that move
 *   answer   bytes T W I N; u32 number of the request, from 0; u32 bytes of the
 *            frame (0 or width x height); u32 bytes of the outlines; the frame,
 *            rows downward; the outlines in the order of drawing: u16 points,
 *            u8 colour, u8 0, then for each point f32 x, f32 y in pixels
 *
 * Ends with 0 at the end of its input; with 2 and a sentence where a file or a
 * request is not what it should be, or nobody reads. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "frames/moving_reference.h"
#include "frames/read_file.h"
#include "reference/clipper.h"
#include "reference/render.h"
#include "reference/scene.h"
#include "reference/fill.h"

enum {
    REQUEST_SIZE = 36,
    ANSWER_HEAD = 16,
    POSE_AT = 8,
    FRAME_AT = 32,
    WANT_FRAME = 1,
    WANT_OUTLINES = 2
};

typedef struct {
    ref_scene_image image;
    uint8_t *bytes; /* of the image */
    moving_reference moving;
    ref_renderer renderer;
    uint8_t *frame;
    uint8_t *outlines;
    size_t outlines_capacity;
} session;

static int fail(const char *where, const char *what)
{
    fprintf(stderr, "error: live: %s: %s\n", where, what);
    return 2;
}

static void put_u32(uint8_t *to, uint32_t value)
{
    for (int i = 0; i < 4; i++) {
        to[i] = (uint8_t)(value >> 8 * i);
    }
}

static void put_f32(uint8_t *to, double value)
{
    float narrow = (float)value;
    uint32_t bits;
    memcpy(&bits, &narrow, sizeof bits);
    put_u32(to, bits);
}

static size_t outlines_size(const ref_renderer *renderer)
{
    size_t size = 0;
    for (size_t i = 0; i < renderer->display_list.count; i++) {
        size += 4 + 8 * (size_t)renderer->display_list.drawn[i].polygon.count;
    }
    return size;
}

static uint8_t *put_outline(uint8_t *to, const ref_screen_polygon *polygon)
{
    to[0] = (uint8_t)polygon->count;
    to[1] = 0;
    to[2] = polygon->colour;
    to[3] = 0;
    to += 4;
    for (int i = 0; i < polygon->count; i++) {
        put_f32(to, polygon->points[i].x);
        put_f32(to + 4, polygon->points[i].y);
        to += 8;
    }
    return to;
}

/* The frame's outlines into the session's memory; false where that is short. */
static bool collect_outlines(session *run, size_t *size)
{
    *size = outlines_size(&run->renderer);
    if (*size > run->outlines_capacity) {
        uint8_t *more = realloc(run->outlines, 2 * *size);
        if (!more) {
            return false;
        }
        run->outlines = more;
        run->outlines_capacity = 2 * *size;
    }
    uint8_t *to = run->outlines;
    for (size_t i = 0; i < run->renderer.display_list.count; i++) {
        to = put_outline(to, &run->renderer.display_list.drawn[i].polygon);
    }
    return true;
}

static void draw(session *run)
{
    const ref_lens *lens = &run->image.lens;
    ref_band band = {run->frame, lens->width, lens->width, 0, lens->height};
    ref_fill_band(&band, run->image.background);
    ref_frame_draw(&run->renderer, &band);
}

/* 0, or 2 after saying why. */
static int answer(session *run, uint32_t number, const uint8_t *request)
{
    const uint8_t wants = request[4];
    if (memcmp(request, "ASKS", 4) != 0 || (wants & ~(WANT_FRAME | WANT_OUTLINES)) != 0) {
        return fail("standard input", "that is not a request");
    }
    const ref_pose pose = ref_pose_read(request + POSE_AT);
    size_t frame_size = 0, outline_size = 0;
    moving_reference_play(&run->moving, ref_u32(request + FRAME_AT));
    if (!ref_frame_begin(&run->renderer, &pose) ||
        ((wants & WANT_OUTLINES) != 0 && !collect_outlines(run, &outline_size))) {
        return fail("a frame", "there is not enough memory");
    }
    if ((wants & WANT_FRAME) != 0) {
        draw(run);
        frame_size = (size_t)run->image.lens.width * (size_t)run->image.lens.height;
    }
    uint8_t head[ANSWER_HEAD];
    memcpy(head, "TWIN", 4);
    put_u32(head + 4, number);
    put_u32(head + 8, (uint32_t)frame_size);
    put_u32(head + 12, (uint32_t)outline_size);
    if (fwrite(head, 1, sizeof head, stdout) != sizeof head ||
        fwrite(run->frame, 1, frame_size, stdout) != frame_size ||
        fwrite(run->outlines, 1, outline_size, stdout) != outline_size || fflush(stdout) != 0) {
        return fail("standard output", "nobody reads it");
    }
    return 0;
}

static int serve(session *run)
{
    uint8_t request[REQUEST_SIZE];
    for (uint32_t number = 0;; number++) {
        size_t got = fread(request, 1, sizeof request, stdin);
        if (got != sizeof request) {
            return got == 0 ? 0 : fail("standard input", "it ends within a request");
        }
        int code = answer(run, number, request);
        if (code != 0) {
            return code;
        }
    }
}

static int open_scene(const char *path, session *run)
{
    size_t size;
    uint8_t *bytes = read_file(path, &size);
    if (!bytes) {
        return fail(path, "it cannot be read");
    }
    const char *wrong = ref_scene_open(bytes, size, &run->image);
    if (!wrong && !moving_reference_open(&run->moving, &run->image, bytes, size)) {
        wrong = "there is not enough memory for it, or the library refuses it";
    }
    run->bytes = bytes;
    if (wrong) {
        return fail(path, wrong);
    }
    run->frame = malloc((size_t)run->image.lens.width * (size_t)run->image.lens.height);
    if (!run->frame || !ref_renderer_init(&run->renderer, &run->moving.scene, &run->image.lens)) {
        return fail(path, "there is not enough memory for it");
    }
    return 0;
}

static bool choose(const char *option, const char *name, ref_renderer *as)
{
    return strcmp(option, "--clipper") == 0 ? ref_clipper_cuts(name, &as->cuts, &as->by_points)
           : strcmp(option, "--hidden") == 0
               ? ref_visibility_draws(name, &as->by_bsp, &as->draws_flat, &as->depth_bits)
               : false;
}

int main(int count, char **arguments)
{
    ref_renderer as = {.by_bsp = true /* where the scene has a tree */, .cuts = REF_CUT_ALL};
    bool unasked = true;
    for (int i = 2; i < count; i += 2) {
        unasked = unasked && strcmp(arguments[i], "--hidden") != 0;
        if (i + 1 == count || !choose(arguments[i], arguments[i + 1], &as)) {
            count = 0;
        }
    }
    if (count < 2) {
        return fail("usage", "live SCENE.fxls [--clipper NAME] [--hidden NAME]");
    }
    session run = {0};
    int code = open_scene(arguments[1], &run);
    if (code == 0 && unasked && run.image.by_depth) {
        (void)ref_visibility_draws("depth", &as.by_bsp, &as.draws_flat, &as.depth_bits);
    }
    run.renderer.by_bsp = as.by_bsp;
    run.renderer.draws_flat = as.draws_flat;
    run.renderer.depth_bits = as.depth_bits;
    run.renderer.cuts = as.cuts;
    run.renderer.by_points = as.by_points;
    if (code == 0) {
        code = serve(&run);
    }
    ref_renderer_close(&run.renderer);
    moving_reference_close(&run.moving);
    ref_scene_close(&run.image);
    free(run.bytes);
    free(run.frame);
    free(run.outlines);
    return code;
}
