/* SPDX-License-Identifier: MIT */
#include "live/answer.h"

#include <string.h>
#include <stdlib.h>

#include "reference/billboard.h"
#include "judge/explain.h"
#include "reference/frustum.h"
#include "reference/horizon.h"
#include "reference/scan.h"

/* Of a request, and what it wants. */
enum {
    FACE_SIZE = 16, /* bytes of a pixel's face */
    POSE_AT = 8,
    FRAME_AT = 32,
    WANT_FRAME = 1,
    WANT_OUTLINES = 2,
    WANT_FACES = 4,
    WANT_ALL = 15
};

/* A pixel of the verdict. */
enum {
    IS_EQUAL,
    IS_WITHIN_THE_BOUND,
    IS_BEYOND_THE_BOUND
};

void live_put_u32(uint8_t *to, uint32_t value)
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
    live_put_u32(to, bits);
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
            live_put_u32(to, UINT32_MAX);
        } else {
            put_face(renderer, &renderer->display_list.drawn[number - 1], i % width + 0.5,
                     i / width + 0.5, to);
        }
    }
}

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
static bool collect_outlines(live_session *run, size_t *size)
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

static void draw(live_session *run, bool wants_faces)
{
    const ref_lens *lens = &run->image.lens;
    ref_band band = {NULL, lens->width, lens->width, 0, lens->height, run->frame};
    memset(run->shown, 0, run->area * sizeof *run->shown);
    run->renderer.shown = wants_faces ? run->shown : NULL;
    ref_frame_fill(&run->renderer, &band, run->image.background);
    ref_frame_draw(&run->renderer, &band);
}

/* place pixel-format: a pixel's bytes, of the board and in an answer */
static uint16_t board_pixel(const live_session *run, size_t number)
{
    return run->renderer.rgb565 ? ref_u16(run->board + 2 * number) : run->board[number];
}

static void collect_frame(live_session *run)
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
static bool judge_board(live_session *run)
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
static bool work_out(live_session *run, uint8_t wants, const ref_pose *pose, uint32_t frame,
                     size_t *outlines_size)
{
    moving_reference_play(&run->moving, frame);
    run->renderer.keeps_doubt = (wants & LIVE_WANT_VERDICT) != 0;
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
           ((wants & LIVE_WANT_VERDICT) == 0 || judge_board(run));
}

const char *live_ask(live_session *run, const uint8_t *request, live_answer *answer)
{
    const uint8_t wants = request[4];
    if (memcmp(request, "ASKS", 4) != 0 || (wants & ~WANT_ALL) != 0) {
        return "that is not a request";
    }
    const ref_pose pose = ref_pose_read(request + POSE_AT);
    size_t outlines_size = 0;
    if (!work_out(run, wants, &pose, ref_u32(request + FRAME_AT), &outlines_size)) {
        return "there is not enough memory for a frame";
    }
    *answer = (live_answer){{run->bytes_of_frame, run->outlines, run->faces, run->verdict},
                            {run->frame_bytes, outlines_size, FACE_SIZE * run->area, run->area}};
    for (int i = 0; i < LIVE_PARTS; i++) {
        answer->sizes[i] = wants >> i & 1 ? answer->sizes[i] : 0;
    }
    return NULL;
}

const char *live_open(live_session *run, const uint8_t *bytes, size_t size, ref_method method)
{
    memset(run, 0, sizeof *run);
    const char *wrong = ref_scene_open(bytes, size, &run->image);
    if (wrong) {
        return wrong;
    }
    if (!moving_reference_open(&run->moving, &run->image, bytes, size)) {
        return "there is not enough memory for it, or the library refuses it";
    }
    if (!method.is_asked) {
        method.by_bsp = !run->image.by_distance;
        method.depth_bits = run->image.depth_bits;
    }
    run->area = (size_t)run->image.lens.width * (size_t)run->image.lens.height;
    run->frame_bytes = (run->image.is_rgb565 ? 2 : 1) * run->area;
    run->frame = malloc(run->area * sizeof *run->frame);
    run->bytes_of_frame = malloc(run->frame_bytes);
    run->board = malloc(run->frame_bytes);
    run->verdict = malloc(run->area);
    run->faces = malloc(FACE_SIZE * run->area);
    run->shown = malloc(run->area * sizeof *run->shown);
    if (!run->frame || !run->bytes_of_frame || !run->board || !run->verdict || !run->faces ||
        !run->shown ||
        !ref_renderer_init(&run->renderer, &run->moving.scene, &run->image.lens)) {
        return "there is not enough memory for it";
    }
    run->renderer.method = method;
    ref_rgb565_make(&run->rgb565, run->image.palette, run->image.dark);
    run->renderer.rgb565 = run->image.is_rgb565 ? &run->rgb565 : NULL;
    return NULL;
}

void live_close(live_session *run)
{
    ref_renderer_close(&run->renderer);
    moving_reference_close(&run->moving);
    ref_scene_close(&run->image);
    free(run->frame);
    free(run->bytes_of_frame);
    free(run->board);
    free(run->verdict);
    free(run->faces);
    free(run->shown);
    free(run->outlines);
}
