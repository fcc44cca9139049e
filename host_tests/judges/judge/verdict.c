/* SPDX-License-Identifier: MIT */
#include "judge/verdict.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include "frames/moving_reference.h"
#include "judge/explain.h"
#include "oracle/tie.h"
#include "reference/horizon.h"
#include "reference/scan.h"
#include "reference/placement.h"

enum {
    THREADS_MAX = 16
};

/* place pixel-format: the record of the reference by which a frame is judged */
/* What the threads share. Each takes the next frame under the lock. It writes only to that
 * frame's place in frames and twin. */
typedef struct {
    const judge_task *asked;
    ref_rgb565 rgb565; /* where the dump has 16 bits a pixel */
    pthread_mutex_t lock;
    uint32_t next, done;
    time_t reported;
    bool failed;
} job;

static void count_pixel(judge_frame *frame, const judge_sample *pixel, double limit)
{
    frame->differing++;
    if (isfinite(pixel->distance)) {
        frame->max_distance = fmax(frame->max_distance, pixel->distance);
    } else {
        frame->inexplicable++;
    }
    if (pixel->distance > limit) {
        if (frame->unexplained < JUDGE_SAMPLES_MAX) {
            frame->samples[frame->unexplained] = *pixel;
        }
        frame->unexplained++;
    }
}

/* Sets the pixel's distance. Counts where explaining it needs near and far moved by the bound on
 * depths, or another texel within the bound. */
static void explain(const judge_task *asked, const ref_renderer *renderer, const judge_box *boxes,
                    judge_sample *pixel, judge_frame *frame)
{
    const judge_reason reason = judge_pixel(renderer, boxes, asked->image->background, asked->line,
                                            pixel->x, pixel->y, pixel->board, asked->distance);
    pixel->distance = reason.distance;
    frame->near_far += reason.near_far;
    frame->texels += reason.texels;
}

static oracle_tie_view tie_view(const judge_task *asked, const ref_pose *pose)
{
    const ref_lens *lens = &asked->image->lens;
    return (oracle_tie_view){
        .eye = {pose->position.x, pose->position.y, pose->position.z},
        .yaw = pose->yaw,
        .pitch = pose->pitch,
        .roll = pose->roll,
        .width = lens->width,
        .height = lens->height,
        .focal = (int32_t)lround(lens->focal * REF_ONE),
        .near = (int32_t)lround(lens->near_z * REF_ONE),
        .far = (int32_t)lround(lens->far_z * REF_ONE),
        .inset = (int32_t)lround(lens->inset * REF_ONE),
        .centre = {(int32_t)lround(lens->centre_x * REF_ONE),
                   (int32_t)lround(lens->centre_y * REF_ONE)},
    };
}

/* Tells whether the pixel's centre lies exactly on an edge of a polygon that was drawn about
 * there. Then double cannot tell its side, and the exact test decides. */
static bool is_tied(const judge_task *asked, const ref_renderer *renderer, const judge_box *boxes,
                    const oracle_tie_view *view, int column, int row)
{
    const ref_scene *scene = renderer->scene;
    double x = column + 0.5, y = row + 0.5;
    for (size_t i = 0; i < renderer->display_list.count; i++) {
        const judge_box *box = &boxes[i];
        if (box->left - x > asked->distance || x - box->right > asked->distance ||
            box->top - y > asked->distance || y - box->bottom > asked->distance) {
            continue;
        }
        if (renderer->display_list.drawn[i].line.is_line) {
            continue;
        }
        const ref_instance *instance = &scene->instances[renderer->display_list.drawn[i].instance];
        if (ref_placement_of(scene, instance) && !renderer->method.by_points) {
            continue; /* its vertices are no integers */
        }
        const ref_face *face =
            ref_face_of(scene, instance, renderer->display_list.drawn[i].face);
        int32_t vertices[3 * UINT8_MAX];
        for (int corner = 0; corner < face->count; corner++) {
            ref_lattice_point point = ref_face_vertex(scene, instance, face, corner);
            vertices[3 * corner] = point.x;
            vertices[3 * corner + 1] = point.y;
            vertices[3 * corner + 2] = point.z;
        }
        if (oracle_tied(view, vertices, face->count, column, row)) {
            return true;
        }
    }
    return false;
}

/* False where memory is short. */
static bool compare_pixels(const judge_task *asked, const ref_renderer *renderer,
                           const uint16_t *twin, uint32_t number)
{
    judge_frame *frame = &asked->frames[number];
    *frame = (judge_frame){.max_distance = -1};
    judge_box *boxes = NULL; /* allocated at the first difference */
    ref_pose pose = judge_dump_pose(asked->dump, number);
    oracle_tie_view view = tie_view(asked, &pose);
    for (int y = 0; y < asked->dump->height; y++) {
        for (int x = 0; x < asked->dump->width; x++) {
            const size_t place = (size_t)y * (size_t)asked->dump->width + (size_t)x;
            const uint16_t board = judge_dump_pixel(asked->dump, number, place);
            if (board == twin[place]) {
                continue;
            }
            if (!boxes && !(boxes = judge_boxes_of(&renderer->display_list))) {
                return false;
            }
            judge_sample pixel = {x, y, board, twin[place], 0};
            explain(asked, renderer, boxes, &pixel, frame);
            count_pixel(frame, &pixel, asked->distance);
            frame->tied += is_tied(asked, renderer, boxes, &view, x, y);
        }
    }
    free(boxes);
    return true;
}

/* The names of what changed each pixel last. pixels: of the band, which is a frame. */
static bool put_shown(const judge_task *asked, ref_renderer *renderer, const ref_band *band,
                      uint16_t *pixels, uint32_t number)
{
    const size_t area = (size_t)asked->dump->width * (size_t)asked->dump->height;
    renderer->shown = calloc(area, sizeof *renderer->shown);
    if (!renderer->shown) {
        return false;
    }
    ref_frame_fill(renderer, band, asked->image->background);
    ref_frame_draw(renderer, band);
    for (size_t i = 0; i < area; i++) {
        const uint32_t place = renderer->shown[i];
        const ref_drawn *drawn = &renderer->display_list.drawn[place > 0 ? place - 1 : 0];
        pixels[i] = place > 0 ? ref_face_name(drawn->instance, drawn->face) : 0;
    }
    judge_dump_put(asked->shown, number, pixels, &renderer->counters);
    free(renderer->shown);
    renderer->shown = NULL;
    return true;
}

static bool judge_one(const judge_task *asked, ref_renderer *renderer, uint16_t *pixels,
                      uint32_t number)
{
    int width = asked->dump->width, height = asked->dump->height;
    ref_band band = {NULL, width, width, 0, height, pixels};
    ref_pose pose = judge_dump_pose(asked->dump, number);
    if (!ref_frame_begin(renderer, &pose)) {
        return false;
    }
    ref_frame_fill(renderer, &band, asked->image->background);
    ref_frame_draw(renderer, &band);
    if (asked->twin) {
        judge_dump_put(asked->twin, number, pixels, &renderer->counters);
    }
    const bool compared = compare_pixels(asked, renderer, pixels, number);
    if (asked->names) {
        ref_fill_band(&band, 0);
        renderer->draws_names = true;
        ref_frame_draw(renderer, &band);
        renderer->draws_names = false;
        judge_dump_put(asked->names, number, pixels, &renderer->counters);
    }
    return compared && (!asked->shown || put_shown(asked, renderer, &band, pixels, number));
}

/* Called under the lock. Prints nothing in the first second, and then at most once a second. */
static void report_progress(job *work)
{
    time_t now = time(NULL);
    uint32_t total = work->asked->dump->frame_count;
    if (now - work->reported < 2 && (work->done < total || !isatty(STDERR_FILENO))) {
        return;
    }
    work->reported = now;
    const char *end = isatty(STDERR_FILENO) && work->done < total ? "\r" : "\n";
    fprintf(stderr, "judge: %u of %u frames%s", (unsigned)work->done, (unsigned)total, end);
}

static void *run_worker(void *argument)
{
    job *work = argument;
    size_t area = (size_t)work->asked->dump->width * (size_t)work->asked->dump->height;
    ref_renderer renderer;
    moving_reference moving; /* each thread's own: it is at the thread's frame */
    uint16_t *pixels = malloc(area * sizeof *pixels);
    bool moves =
        moving_reference_open(&moving, work->asked->image, work->asked->bytes, work->asked->size);
    bool ready = ref_renderer_init(&renderer, &moving.scene, &work->asked->image->lens);
    bool sound = pixels && ready && moves;
    renderer.method = work->asked->method;
    renderer.rgb565 = work->asked->dump->pixel_bits == 16 ? &work->rgb565 : NULL;
    renderer.keeps_doubt = true;
    pthread_mutex_lock(&work->lock);
    while (sound && !work->failed && work->next < work->asked->dump->frame_count) {
        uint32_t number = work->next++;
        pthread_mutex_unlock(&work->lock);
        moving_reference_play(&moving, number);
        sound = judge_one(work->asked, &renderer, pixels, number);
        pthread_mutex_lock(&work->lock);
        work->done++;
        report_progress(work);
    }
    work->failed = work->failed || !sound;
    pthread_mutex_unlock(&work->lock);
    if (ready) {
        ref_renderer_close(&renderer);
    }
    moving_reference_close(&moving);
    free(pixels);
    return NULL;
}

bool judge_frames(const judge_task *asked)
{
    job work = {.asked = asked, .lock = PTHREAD_MUTEX_INITIALIZER, .reported = time(NULL)};
    ref_rgb565_make(&work.rgb565, asked->image->palette, asked->image->dark);
    pthread_t threads[THREADS_MAX];
    long wanted = sysconf(_SC_NPROCESSORS_ONLN), started = 0;
    while (started < wanted - 1 && started < THREADS_MAX &&
           pthread_create(&threads[started], NULL, run_worker, &work) == 0) {
        started++;
    }
    run_worker(&work); /* this thread works too, so one is enough */
    while (started > 0) {
        pthread_join(threads[--started], NULL);
    }
    return !work.failed;
}
