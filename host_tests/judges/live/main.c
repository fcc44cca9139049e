/* SPDX-License-Identifier: MIT */
/* live SCENE.fxls [--clipper NAME] [--hidden NAME]
 *
 * Draws with the reference renderer, pose by pose. A request on standard
 * input is 36 bytes, and the board's pixels where it wants the verdict. An answer
 * on standard output is a head of 24 bytes and the parts that the request wants.
 * All is little-endian, as in docs/formats.md, section 1:
 *
 *   request  bytes A S K S; u8 wants (1 frame, 2 outlines, 4 faces, 8 verdict);
 *            u8 x 3, 0; pose; u32 number of the frame, which says where things
 *            are that move; with 8: the board's frame, width x height pixels
 *   answer   bytes T W I N; u32 number of the request, from 0; u32 x 4: bytes of
 *            each of the four parts, 0 for a part that is not wanted; the parts
 *
 * The parts. Frame, faces and verdict have an entry for each pixel, rows downward:
 *
 *   frame     u8 palette index; or u16 of RGB565, as the board's pixels are then
 *   outlines  in the order of drawing: u16 points, u8 colour, u8 0, then for each
 *             point f32 x, f32 y in pixels
 *   faces     what the frame shows: u16 instance, u16 face within its model, or FFFF FFFF where
 *             that is the background; f32 how far away, along the view's axis; of its texel u16
 *             column and row, then u16 width and height of the level, 0 without a texture
 *   verdict   u8: 0 the board's pixel equals the frame's, 1 it is explained within
 *             the bound by which `make run` judges, 2 it is not
 *
 * Ends with 0 at the end of its input; with 2 and a sentence where a file or a
 * request is not what it should be, or nobody reads. */
#include <string.h>
#include <stdio.h>
#include <stdlib.h>

#include "reference/billboard.h"
#include "frames/moving_reference.h"
#include "frames/input.h"
#include "judge/explain.h"
#include "reference/frustum.h"
#include "reference/render.h"
#include "reference/scene.h"
#include "reference/scan.h"

enum {
    FACE_SIZE = 16 /* bytes of a pixel's face */
};

static void put_u32(uint8_t *to, uint32_t value)
{
    for (int i = 0; i < 4; i++) {
        to[i] = (uint8_t)(value >> 8 * i);
    }
}

static void put_u16(uint8_t *to, uint32_t value)
{
    to[0] = (uint8_t)value;
    to[1] = (uint8_t)(value >> 8);
}

static void put_f32(uint8_t *to, double value)
{
    float narrow = (float)value;
    uint32_t bits;
    memcpy(&bits, &narrow, sizeof bits);
    put_u32(to, bits);
}

/* How far away a polygon is at a pixel. The renderer knows the planes if it draws by depth. */
static double distance_at(const ref_renderer *renderer, const ref_drawn *drawn, double x, double y)
{
    const ref_scene *scene = renderer->scene;
    const ref_instance *instance = &scene->instances[drawn->instance];
    ref_depth_plane plane = drawn->depth;
    if (renderer->method.depth_bits == 0 && !ref_billboard_of(scene, instance)) {
        ref_depth_plane_find(scene, &renderer->camera, instance,
                             ref_face_of(scene, instance, drawn->face), &plane);
    }
    return 1 / ref_nearness(&plane, &renderer->lens, x, y);
}

/* place sampling: the texel under the mouse */
static void put_face(const ref_renderer *renderer, const ref_drawn *drawn, double x, double y,
                     uint8_t *to)
{
    int texel[2];
    put_u16(to, drawn->instance);
    put_u16(to + 2, drawn->face);
    put_f32(to + 4, distance_at(renderer, drawn, x, y));
    if (ref_surface_texel_at(&drawn->look, &renderer->lens, x, y, texel)) {
        put_u16(to + 8, (uint32_t)texel[0]);
        put_u16(to + 10, (uint32_t)texel[1]);
        put_u16(to + 12, (uint32_t)drawn->look.level->width);
        put_u16(to + 14, (uint32_t)drawn->look.level->height);
    }
}

/* What each pixel of a frame shows, the part "faces" of an answer: FACE_SIZE bytes a pixel. Of the frame
 * that was drawn, whose renderer->shown is set. */
static void collect_faces(const ref_renderer *renderer, uint8_t *to)
{
    const int width = renderer->lens.width, area = width * renderer->lens.height;
    for (int i = 0; i < area; i++, to += FACE_SIZE) {
        const uint32_t number = renderer->shown[i];
        memset(to, 0, FACE_SIZE);
        if (number == 0) {
            put_u32(to, UINT32_MAX);
        } else {
            put_face(renderer, &renderer->display_list.drawn[number - 1], i % width + 0.5,
                     i / width + 0.5, to);
        }
    }
}

enum {
    REQUEST_SIZE = 36,
    ANSWER_HEAD = 24,
    POSE_AT = 8,
    FRAME_AT = 32,
    WANT_FRAME = 1,
    WANT_OUTLINES = 2,
    WANT_FACES = 4,
    WANT_VERDICT = 8,
    WANT_ALL = 15,
    PARTS = 4
};

/* A pixel of the verdict. */
enum {
    IS_EQUAL,
    IS_WITHIN_THE_BOUND,
    IS_BEYOND_THE_BOUND
};

/* place pixel-format: the record of the reference by which a frame is judged; the bytes of a pixel */
typedef struct {
    ref_scene_image image;
    uint8_t *bytes; /* of the image */
    moving_reference moving;
    ref_renderer renderer;
    ref_rgb565 rgb565;
    size_t area;     /* pixels of a frame */
    uint16_t *frame; /* the reference renderer's */
    uint8_t *bytes_of_frame;
    uint8_t *board;   /* the bytes of the board's frame */
    uint8_t *verdict; /* of each pixel */
    uint8_t *faces;
    uint32_t *shown; /* ref_renderer.shown, while faces are wanted */
    uint8_t *outlines;
    size_t outlines_capacity;
} session;

static size_t outlines_size(const ref_renderer *renderer)
{
    size_t size = 0;
    for (size_t i = 0; i < renderer->display_list.count; i++) {
        const int count = renderer->display_list.drawn[i].polygon.count;
        size += count == 0 ? 0 : 4 + 8 * (size_t)count;
    }
    return size;
}

/* A polygon without points is in the list because the board may draw it: it has no outline. */
static uint8_t *put_outline(uint8_t *to, const ref_screen_polygon *polygon)
{
    if (polygon->count == 0) {
        return to;
    }
    put_u16(to, (uint32_t)polygon->count);
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

static void draw(session *run, bool wants_faces)
{
    const ref_lens *lens = &run->image.lens;
    ref_band band = {NULL, lens->width, lens->width, 0, lens->height, run->frame};
    memset(run->shown, 0, run->area * sizeof *run->shown);
    run->renderer.shown = wants_faces ? run->shown : NULL;
    ref_fill_band(&band, ref_pixel_of(&run->renderer, run->image.background));
    ref_frame_draw(&run->renderer, &band);
}

static size_t pixel_bytes(const session *run)
{
    return run->renderer.rgb565 ? 2 : 1;
}

static uint16_t board_pixel(const session *run, size_t number)
{
    return run->renderer.rgb565 ? ref_u16(run->board + 2 * number) : run->board[number];
}

static void collect_frame(session *run)
{
    for (size_t i = 0; i < run->area; i++) {
        if (run->renderer.rgb565) {
            put_u16(run->bytes_of_frame + 2 * i, run->frame[i]);
        } else {
            run->bytes_of_frame[i] = (uint8_t)run->frame[i];
        }
    }
}

/* Judges each pixel of the board's frame. False where memory is short. */
static bool judge_board(session *run)
{
    const int width = run->image.lens.width;
    judge_box *boxes = judge_boxes_of(&run->renderer.display_list);
    for (size_t i = 0; boxes && i < run->area; i++) {
        run->verdict[i] = IS_EQUAL;
        if (board_pixel(run, i) != run->frame[i]) {
            const judge_reason reason =
                judge_pixel(&run->renderer, boxes, run->image.background, -1, (int)i % width,
                            (int)i / width, board_pixel(run, i), JUDGE_DISTANCE);
            run->verdict[i] =
                reason.distance <= JUDGE_DISTANCE ? IS_WITHIN_THE_BOUND : IS_BEYOND_THE_BOUND;
        }
    }
    free(boxes);
    return boxes != NULL;
}

/* Draws what a request wants. False where memory is short. */
static bool work_out(session *run, uint8_t wants, const ref_pose *pose, uint32_t frame,
                     size_t *outlines_size)
{
    moving_reference_play(&run->moving, frame);
    run->renderer.keeps_doubt = (wants & WANT_VERDICT) != 0;
    if (!ref_frame_begin(&run->renderer, pose)) {
        return false;
    }
    if ((wants & ~WANT_OUTLINES) != 0) {
        draw(run, (wants & WANT_FACES) != 0);
        collect_frame(run);
    }
    if ((wants & WANT_FACES) != 0) {
        collect_faces(&run->renderer, run->faces);
    }
    return ((wants & WANT_OUTLINES) == 0 || collect_outlines(run, outlines_size)) &&
           ((wants & WANT_VERDICT) == 0 || judge_board(run));
}

/* 0, or 2 after saying why. */
static int answer(session *run, uint32_t number, const uint8_t *request)
{
    const uint8_t wants = request[4];
    if (memcmp(request, "ASKS", 4) != 0 || (wants & ~WANT_ALL) != 0) {
        return fail("standard input", "that is not a request");
    }
    const size_t frame_bytes = pixel_bytes(run) * run->area;
    if ((wants & WANT_VERDICT) != 0 && fread(run->board, 1, frame_bytes, stdin) != frame_bytes) {
        return fail("standard input", "it ends within a request");
    }
    const ref_pose pose = ref_pose_read(request + POSE_AT);
    size_t outlines_size = 0;
    if (!work_out(run, wants, &pose, ref_u32(request + FRAME_AT), &outlines_size)) {
        return fail("a frame", "there is not enough memory");
    }
    const uint8_t *parts[PARTS] = {run->bytes_of_frame, run->outlines, run->faces, run->verdict};
    const size_t sizes[PARTS] = {frame_bytes, outlines_size, FACE_SIZE * run->area, run->area};
    uint8_t head[ANSWER_HEAD];
    memcpy(head, "TWIN", 4);
    put_u32(head + 4, number);
    for (int i = 0; i < PARTS; i++) {
        put_u32(head + 8 + 4 * i, wants >> i & 1 ? (uint32_t)sizes[i] : 0);
    }
    bool written = fwrite(head, 1, sizeof head, stdout) == sizeof head;
    for (int i = 0; i < PARTS && written; i++) {
        written = (wants >> i & 1) == 0 || fwrite(parts[i], 1, sizes[i], stdout) == sizes[i];
    }
    return written && fflush(stdout) == 0 ? 0 : fail("standard output", "nobody reads it");
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
    run->area = (size_t)run->image.lens.width * (size_t)run->image.lens.height;
    run->frame = malloc(run->area * sizeof *run->frame);
    run->bytes_of_frame = malloc(2 * run->area);
    run->board = malloc(2 * run->area);
    run->verdict = malloc(run->area);
    run->faces = malloc(FACE_SIZE * run->area);
    run->shown = malloc(run->area * sizeof *run->shown);
    if (!run->frame || !run->bytes_of_frame || !run->board || !run->verdict || !run->faces || !run->shown ||
        !ref_renderer_init(&run->renderer, &run->moving.scene, &run->image.lens)) {
        return fail(path, "there is not enough memory for it");
    }
    return 0;
}

static void close_session(session *run)
{
    ref_renderer_close(&run->renderer);
    moving_reference_close(&run->moving);
    ref_scene_close(&run->image);
    free(run->bytes);
    free(run->frame);
    free(run->bytes_of_frame);
    free(run->board);
    free(run->verdict);
    free(run->faces);
    free(run->shown);
    free(run->outlines);
}

int main(int count, char **arguments)
{
    ref_method method = REF_METHOD_OF_SCENE;
    const char *scene;
    const argument known[] = {{"--clipper", ref_take_clipper, &method},
                              {"--hidden", ref_take_visibility, &method}};
    if (!read_arguments(count, arguments, known, 2, &scene, 1)) {
        return fail("live: usage", "live SCENE.fxls [--clipper NAME] [--hidden NAME]");
    }
    session run = {0};
    int code = open_scene(scene, &run);
    if (code == 0 && !method.is_asked) {
        method.by_bsp = !run.image.by_distance;
        method.depth_bits = run.image.depth_bits;
    }
    run.renderer.method = method;
    ref_rgb565_make(&run.rgb565, run.image.palette, run.image.dark);
    run.renderer.rgb565 = run.image.is_rgb565 ? &run.rgb565 : NULL;
    if (code == 0) {
        code = serve(&run);
    }
    close_session(&run);
    return code;
}
