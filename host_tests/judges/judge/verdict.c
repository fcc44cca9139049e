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
#include "reference/scan.h"
#include "reference/placement.h"

enum {
    THREADS_MAX = 16
};

/* place pixel-format: frames as files, and their twins */
/* What the threads share. Each takes the next frame under the lock. It writes only to that
 * frame's place in frames and twin. */
typedef struct {
    const judge_scene *scene;
    const ref_scene_image *image; /* the scene's */
    const judge_dump *dump;
    unsigned cuts;
    bool by_points;
    bool by_bsp;
    bool flat;
    int depth_bits;
    double distance;
    int line; /* the palette index of outlines; below 0: none */
    judge_frame *frames;
    judge_dump *twin, *names, *shown;
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
static void explain(const job *work, const ref_renderer *renderer, const judge_box *boxes,
                    judge_sample *pixel, judge_frame *frame)
{
    const judge_reason reason = judge_pixel(renderer, boxes, work->image->background, work->line,
                                            pixel->x, pixel->y, pixel->board, work->distance);
    pixel->distance = reason.distance;
    frame->near_far += reason.near_far;
    frame->texels += reason.texels;
}

static oracle_tie_view tie_view(const job *work, const ref_pose *pose)
{
    const ref_lens *lens = &work->image->lens;
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
static bool is_tied(const job *work, const ref_renderer *renderer, const judge_box *boxes,
                    const oracle_tie_view *view, int column, int row)
{
    const ref_scene *scene = renderer->scene;
    double x = column + 0.5, y = row + 0.5;
    for (size_t i = 0; i < renderer->display_list.count; i++) {
        const judge_box *box = &boxes[i];
        if (box->left - x > work->distance || x - box->right > work->distance ||
            box->top - y > work->distance || y - box->bottom > work->distance) {
            continue;
        }
        const ref_instance *instance = &scene->instances[renderer->display_list.drawn[i].instance];
        if (ref_placement_of(scene, instance) && !renderer->by_points) {
            continue; /* its vertices are no integers */
        }
        const ref_model *model = &scene->models[instance->model];
        const ref_face *face =
            &scene->faces[model->first_face + renderer->display_list.drawn[i].face];
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
static bool compare_pixels(const job *work, const ref_renderer *renderer, const uint16_t *twin,
                           uint32_t number)
{
    judge_frame *frame = &work->frames[number];
    *frame = (judge_frame){.max_distance = -1};
    judge_box *boxes = NULL; /* allocated at the first difference */
    ref_pose pose = judge_dump_pose(work->dump, number);
    oracle_tie_view view = tie_view(work, &pose);
    for (int y = 0; y < work->dump->height; y++) {
        for (int x = 0; x < work->dump->width; x++) {
            const size_t place = (size_t)y * (size_t)work->dump->width + (size_t)x;
            const uint16_t board = judge_dump_pixel(work->dump, number, place);
            if (board == twin[place]) {
                continue;
            }
            if (!boxes && !(boxes = judge_boxes_of(&renderer->display_list))) {
                return false;
            }
            judge_sample pixel = {x, y, board, twin[place], 0};
            explain(work, renderer, boxes, &pixel, frame);
            count_pixel(frame, &pixel, work->distance);
            frame->tied += is_tied(work, renderer, boxes, &view, x, y);
        }
    }
    free(boxes);
    return true;
}

/* The names of what changed each pixel last. pixels: of the band, which is a frame. */
static bool put_shown(const job *work, ref_renderer *renderer, const ref_band *band,
                      uint16_t *pixels, uint32_t number)
{
    const size_t area = (size_t)work->dump->width * (size_t)work->dump->height;
    renderer->shown = calloc(area, sizeof *renderer->shown);
    if (!renderer->shown) {
        return false;
    }
    ref_fill_band(band, ref_pixel_of(renderer, work->image->background));
    ref_frame_draw(renderer, band);
    for (size_t i = 0; i < area; i++) {
        const uint32_t place = renderer->shown[i];
        const ref_drawn *drawn = &renderer->display_list.drawn[place > 0 ? place - 1 : 0];
        pixels[i] = place > 0 ? ref_face_name(drawn->instance, drawn->face) : 0;
    }
    judge_dump_put(work->shown, number, pixels, &renderer->counters);
    free(renderer->shown);
    renderer->shown = NULL;
    return true;
}

static bool judge_one(const job *work, ref_renderer *renderer, uint16_t *pixels, uint32_t number)
{
    int width = work->dump->width, height = work->dump->height;
    ref_band band = {NULL, width, width, 0, height, pixels};
    ref_pose pose = judge_dump_pose(work->dump, number);
    if (!ref_frame_begin(renderer, &pose)) {
        return false;
    }
    ref_fill_band(&band, ref_pixel_of(renderer, work->image->background));
    ref_frame_draw(renderer, &band);
    if (work->twin) {
        judge_dump_put(work->twin, number, pixels, &renderer->counters);
    }
    const bool compared = compare_pixels(work, renderer, pixels, number);
    if (work->names) {
        ref_fill_band(&band, 0);
        renderer->draws_names = true;
        ref_frame_draw(renderer, &band);
        renderer->draws_names = false;
        judge_dump_put(work->names, number, pixels, &renderer->counters);
    }
    return compared && (!work->shown || put_shown(work, renderer, &band, pixels, number));
}

/* Called under the lock. Prints nothing in the first second, and then at most once a second. */
static void report_progress(job *work)
{
    time_t now = time(NULL);
    uint32_t total = work->dump->frame_count;
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
    size_t area = (size_t)work->dump->width * (size_t)work->dump->height;
    ref_renderer renderer;
    moving_reference moving; /* each thread's own: it is at the thread's frame */
    uint16_t *pixels = malloc(area * sizeof *pixels);
    bool moves = moving_reference_open(&moving, work->image, work->scene->bytes, work->scene->size);
    bool ready = ref_renderer_init(&renderer, &moving.scene, &work->image->lens);
    bool sound = pixels && ready && moves;
    renderer.cuts = work->cuts;
    renderer.by_points = work->by_points;
    renderer.by_bsp = work->by_bsp;
    renderer.draws_flat = work->flat;
    renderer.depth_bits = work->depth_bits;
    renderer.rgb565 = work->dump->pixel_bits == 16 ? &work->rgb565 : NULL;
    renderer.keeps_doubt = true;
    pthread_mutex_lock(&work->lock);
    while (sound && !work->failed && work->next < work->dump->frame_count) {
        uint32_t number = work->next++;
        pthread_mutex_unlock(&work->lock);
        moving_reference_play(&moving, number);
        sound = judge_one(work, &renderer, pixels, number);
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

bool judge_frames(const judge_scene *scene, const judge_dump *dump, unsigned cuts, bool by_points,
                  bool by_bsp, bool flat, int depth_bits, double distance, int line,
                  judge_frame *frames, judge_dump *twin, judge_dump *names, judge_dump *shown)
{
    job work = {.scene = scene,
                .image = scene->image,
                .dump = dump,
                .cuts = cuts,
                .by_points = by_points,
                .by_bsp = by_bsp,
                .flat = flat,
                .depth_bits = depth_bits,
                .distance = distance,
                .line = line,
                .frames = frames,
                .twin = twin,
                .names = names,
                .shown = shown,
                .lock = PTHREAD_MUTEX_INITIALIZER,
                .reported = time(NULL)};
    ref_rgb565_make(&work.rgb565, scene->image->palette, scene->image->dark);
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
