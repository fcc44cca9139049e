/* SPDX-License-Identifier: MIT */
/* Draws every frame of the board's scene, each as one region. Clearing the
 * frame, moving what has a motion, and showing the frame are outside. Prints
 *   bench: memory BYTES     beside the band, the scene and the stack
 *   bench: stack BYTES      the deepest that drawing went
 *   bench: frames N         the end marker */
#include "contract/display.h"
#include "contract/journal.h"
#include "contract/store.h"
#include "contract/system.h"
#include "draw.h"
#include "fixel/motion.h"
#include "path.h"
#include "program.h"

#define STACK_WORDS   2048u /* words that are checked below the caller of draw_frame */
#define STACK_PATTERN 0xA5C35A3Cu
#define MOVING_MAX    128u /* instances of a scene with motions */

static _Alignas(2) uint8_t pixels[2u * DRAW_PIXELS_MAX]; /* of RGB565 at most */
static fxl_instance instances[MOVING_MAX];
static fxl_placement placements[MOVING_MAX];
static fxl_motion_player motion;

/* Fills the memory below the stack pointer. Uses a volatile pointer and no call, because a call
 * would use that memory itself. */
static inline __attribute__((always_inline)) volatile uint32_t *paint_stack(void)
{
    volatile uint32_t *here;
#ifdef __arm__
    __asm__ volatile("mov %0, sp" : "=r"(here));
#else
    __asm__ volatile("mv %0, sp" : "=r"(here));
#endif
    for (uint32_t i = 1; i <= STACK_WORDS; i++) {
        *(here - i) = STACK_PATTERN;
    }
    return here;
}

/* Returns the bytes from `here` down to the lowest word that has changed. */
static uint32_t painted_over(volatile const uint32_t *here)
{
    uint32_t untouched = 0;
    while (untouched < STACK_WORDS && *(here - (STACK_WORDS - untouched)) == STACK_PATTERN) {
        untouched++;
    }
    return (STACK_WORDS - untouched) * 4u;
}

/* Draws one frame as a region. *stack: the deepest so far. */
static __attribute__((noinline)) bool measured_frame(const fxl_pose *pose, const fxl_band *band,
                                                     uint32_t *stack)
{
    volatile uint32_t *here = paint_stack();
    uint32_t used;
    bool drawn;
    bench_begin();
    drawn = draw_frame(pose, band);
    bench_end();
    used = painted_over(here);
    *stack = used > *stack ? used : *stack;
    return drawn;
}

/* Sets every pixel of the frame to the scene's background, in the scene's pixel format. */
static void clear(const fxl_scene_image *image, const fxl_band *band)
{
    const uint8_t *colour = image->palette + 3u * image->background;
    uint16_t *const wide = (uint16_t *)(void *)pixels;

    if (image->pixel_bits == 8) {
        fxl_fill_band(band, image->background);
        return;
    }
    for (uint32_t i = 0; i < (uint32_t)band->width * band->rows; i++) {
        wide[i] = FXL_RGB565(colour[0], colour[1], colour[2]);
    }
}

static int one_frame(const fxl_scene_image *image, walk_path *path, uint32_t number,
                     uint32_t *stack)
{
    const fxl_band band = {.pixels = pixels,
                           .width = image->lens.width,
                           .stride = image->lens.width,
                           .first_row = 0,
                           .rows = image->lens.height};

    if (walk_path_next(path, 0) != FXL_OK) {
        return SYSTEM_EXIT_INPUT;
    }
    if (image->motion.motion_count > 0) {
        fxl_motion_play(&motion, number);
    }
    if (!journal_begin(number, &path->viewer.pose)) {
        return SYSTEM_EXIT_JOURNAL;
    }
    clear(image, &band);
    if (!measured_frame(&path->viewer.pose, &band, stack)) {
        return SYSTEM_EXIT_RENDER;
    }
    if (!display_flush(0, 0, band.width, band.rows, pixels)) {
        return SYSTEM_EXIT_DISPLAY;
    }
    return journal_end(draw_counters(), 0, 0) ? SYSTEM_EXIT_DONE : SYSTEM_EXIT_JOURNAL;
}

static int all_frames(const fxl_scene_image *image, uint32_t frames)
{
    uint32_t stack = 0;
    walk_path path;

    walk_path_begin(&path, image, false);
    for (uint32_t number = 0; number < frames; number++) {
        const int code = one_frame(image, &path, number, &stack);
        if (code != SYSTEM_EXIT_DONE) {
            return code;
        }
    }
    if (stack == STACK_WORDS * 4u) {
        system_text("bench: the stack went deeper than was looked at\n");
        return SYSTEM_EXIT_STACK;
    }
    text_with_number("bench: memory", "", " ", draw_memory());
    text_with_number("bench: stack", "", " ", stack);
    return display_close() ? SYSTEM_EXIT_DONE : SYSTEM_EXIT_DISPLAY;
}

/* Motions move copies of the instances, which the scene then names. */
static bool motion_open(fxl_scene_image *image)
{
    const fxl_motion_memory copies = {instances, MOVING_MAX, placements, MOVING_MAX};
    return image->motion.motion_count == 0 ||
           fxl_motion_begin(&motion, &image->motion, &image->scene, &copies) == FXL_OK;
}

static int run(void)
{
    fxl_scene_image image;
    fxl_scene_fault fault;
    size_t size = 0;
    const void *bytes = store_scene(&size);
    uint32_t frames;
    int code;

    if (bytes == NULL) {
        return SYSTEM_EXIT_STORE;
    }
    if (fxl_scene_open(bytes, size, &image, &fault) != FXL_OK) {
        text_with_number("bench: scene refused: ", fault.what, " ", fault.index);
        return SYSTEM_EXIT_SCENE;
    }
    if ((uint32_t)image.lens.width * image.lens.height > DRAW_PIXELS_MAX || !motion_open(&image)) {
        return SYSTEM_EXIT_CAPACITY;
    }
    code = draw_open(&image);
    if (code != SYSTEM_EXIT_DONE) {
        return code;
    }
    frames = system_frames() != 0 ? system_frames() : image.frame_count;
    if (!journal_open(frames) ||
        !display_open(image.lens.width, image.lens.height, image.pixel_bits, image.palette)) {
        return SYSTEM_EXIT_DISPLAY;
    }
    code = all_frames(&image, frames);
    if (code == SYSTEM_EXIT_DONE) {
        text_with_number("bench: frames", "", " ", frames);
    }
    return code;
}

int main(int argc, char **argv)
{
    bench_start(argc, argv);
    system_exit(run());
    return SYSTEM_EXIT_DONE; /* not reached */
}
