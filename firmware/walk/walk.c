/* SPDX-License-Identifier: MIT */
#include "walk.h"

#include "act.h"
#include "contract/clock.h"
#include "contract/display.h"
#include "contract/input.h"
#include "contract/journal.h"
#include "contract/store.h"
#include "contract/system.h"
#include "fixel/all.h"
#include "methods.h"
#include "path.h"
#include "plan.h"

#ifndef WALK_LIST_MOST
#define WALK_LIST_MOST UINT32_MAX
#endif

/* A row of the widest screen must fit. */
_Static_assert(WALK_BAND_BYTES >= FXL_SCREEN_MAX, "WALK_BAND_BYTES is less than one row");

/* Where the build limits the rows of a band, no more memory than they take. */
#if defined WALK_ROWS_MAX && WALK_ROWS_MAX * FXL_SCREEN_MAX < WALK_BAND_BYTES
#define BAND_BYTES (WALK_ROWS_MAX * FXL_SCREEN_MAX)
#else
#define BAND_BYTES WALK_BAND_BYTES
#endif
/* While nothing is drawn, it holds what the set-up reads: then that is not on the stack. */
static union {
    _Alignas(4) uint8_t pixels[BAND_BYTES];
    struct {
        fxl_scene_image image;
        walk_methods methods;
        walk_plan plan;
    } opening;
} band_pixels;
static fxl_draw_entry order[WALK_ORDER_ENTRIES];
static uint64_t list[WALK_LIST_BYTES / 8]; /* what the scene has, and the methods, take of it */
#if WALK_CACHE_ENTRIES > 0
static fxl_cached_vertex cache[WALK_CACHE_ENTRIES];
#else
static fxl_cached_vertex *const cache = NULL; /* every face works its vertices out anew */
#endif
static fxl_setup_plan plan;
static fxl_setup setup;

#if defined WALK_IN_PARTS
#define PART
#else
#define PART static
#endif

/* Of a program without a debugger, which has no host to end for: the path is drawn again and again. */
#if defined WALK_REPEATS
#define REPEATS true
#else
#define REPEATS false
#endif

/* What drawing took, without what the display does with it. */
typedef struct {
    uint64_t before, spent; /* instructions */
    bool is_broken;
} stopwatch;

static void stopwatch_start(stopwatch *watch)
{
    watch->before = clock_instructions();
}

static void stopwatch_stop(stopwatch *watch)
{
    const uint64_t now = clock_instructions();

    if (now < watch->before) {
        watch->is_broken = true;
    } else {
        watch->spent += now - watch->before;
    }
}

/* 0, which says that it was not counted, where the clock ran backward. */
static uint64_t stopwatch_read(const stopwatch *watch)
{
    return watch->is_broken ? 0 : watch->spent;
}

static void print_number(uint32_t number)
{
    char digits[11]; /* 4294967295 and the 0 that ends it */
    char *first = &digits[sizeof digits - 1];

    *first = '\0';
    do {
        first--;
        *first = (char)('0' + number % 10u);
        number /= 10u;
    } while (number != 0);
    system_text(first);
}

static void print_with_number(const char *before, uint32_t number, const char *after)
{
    system_text(before);
    print_number(number);
    system_text(after);
}

/* Says what failed in which frame, and answers with the exit code. */
static int fail_frame(const char *what, uint32_t frame, int exit_code)
{
    system_text("walk: ");
    system_text(what);
    print_with_number(" in frame ", frame, "\n");
    return exit_code;
}

static int fail_status(const char *what, fxl_status status, int exit_code)
{
    system_text("walk: ");
    system_text(what);
    system_text(": ");
    system_text(fxl_status_text(status));
    system_text("\n");
    return exit_code;
}

static int open_scene(fxl_scene_image *image)
{
    size_t size = 0;
    const void *bytes = store_scene(&size);
    fxl_scene_fault fault = {"image", 0};
    fxl_status status;

    if (bytes == NULL) {
        system_text("walk: this board has no scene\n");
        return SYSTEM_EXIT_STORE;
    }
    status = fxl_scene_open(bytes, size, image, &fault);
    if (status != FXL_OK) {
        system_text("walk: scene refused: ");
        system_text(fxl_status_text(status));
        system_text(" (");
        system_text(fault.what);
        print_with_number(" ", fault.index, ")\n");
        return SYSTEM_EXIT_SCENE;
    }
    return SYSTEM_EXIT_DONE;
}

/* place pixel-format: rows of a band that fit; what the program says without a target */
/* How many rows of a band fit into its memory, or fewer if the build says so. */
static uint32_t band_rows(uint16_t width, uint8_t pixel_bits)
{
    const uint32_t most = (uint32_t)BAND_BYTES / (width * (pixel_bits / 8u));

#ifdef WALK_ROWS_MAX
    return most < WALK_ROWS_MAX ? most : WALK_ROWS_MAX;
#else
    return most;
#endif
}

/* Whether the scene asks for an RGB565 that this program has not, which is said. */
static bool lacks_rgb565(const fxl_scene_image *image)
{
    const uint8_t depth_bits = walk_methods_depth_bits(image);

    if (image->pixel_bits != 16 || walk_methods_draw(16, depth_bits)) {
        return false;
    }
    system_text("walk: this board's program draws no RGB565");
#if !defined WALK_WITHOUT_RGB565
    if (walk_methods_draw(16, 0)) {
        print_with_number(" with a depth buffer of ", depth_bits, " bits");
    }
#endif
    system_text(": leave out pixels = \"rgb565\"\n");
    return true;
}

static int choose_methods(walk_methods *methods, const fxl_scene_image *image)
{
    if (lacks_rgb565(image)) {
        return SYSTEM_EXIT_CAPACITY;
    }
#if defined WALK_WITHOUT_ORTHOGRAPHIC
    if (image->scale != 0) {
        system_text("walk: this program draws with no orthographic lens: leave out view.scale\n");
        return SYSTEM_EXIT_CAPACITY;
    }
#endif
    if (!walk_methods_choose(methods, image)) {
        system_text("walk: this program has no room to draw by a BSP tree, with surfaces or with a "
                    "depth buffer (VISIBILITY=sorted), billboards, lines or a horizon\n");
        if (image->surfaces.face_map != NULL && walk_targets[0].surfaces == NULL) {
            system_text("walk: VISIBILITY=surfaces builds a program that draws surfaces\n");
        }
        return SYSTEM_EXIT_CAPACITY;
    }
#if !defined WALK_WITHOUT_RGB565
    if (band_rows(image->lens.width, methods->draws.target->pixel_bits) == 0) {
        system_text("walk: this board's band holds no row of so wide a screen in RGB565\n");
        return SYSTEM_EXIT_CAPACITY;
    }
#endif
    return SYSTEM_EXIT_DONE;
}

/* What the list's memory has no room for, or the order. */
static int fail_capacity(const walk_plan *of, uint32_t act)
{
    if (act + of->needed > sizeof list) {
        print_with_number("walk: what the scene has, clipper and visibility method need ",
                          act + of->needed, " bytes");
        print_with_number(", this board's display list has ", sizeof list, "\n");
    } else {
        print_with_number("walk: the scene needs ", of->entries, " order entries");
        print_with_number(", this board has ", WALK_ORDER_ENTRIES, "\n");
    }
    return SYSTEM_EXIT_CAPACITY;
}

static int open_renderer(const fxl_scene_image *image)
{
    walk_methods *const methods = &band_pixels.opening.methods;
    walk_plan *const of = &band_pixels.opening.plan;
    const uint32_t act = act_bytes(image);
    fxl_status status;
    int code = choose_methods(methods, image);

    if (code != SYSTEM_EXIT_DONE) {
        return code;
    }
    plan = (fxl_setup_plan){0}; /* a path that begins again opens the scene again */
    *of = (walk_plan){.image = image,
                      .methods = methods,
                      .tables = {.draw_list = order,
                                 .draw_list_capacity = WALK_ORDER_ENTRIES,
                                 .cache = cache,
                                 .cache_capacity = WALK_CACHE_ENTRIES},
                      .list_most = WALK_LIST_MOST,
                      .block = (uint8_t *)list + act,
                      .size = sizeof list - act};
    if (act > sizeof list) {
        return fail_capacity(of, act);
    }
    status = act_open(image, list, &plan);
    if (status != FXL_OK) {
        return fail_status("scene", status, SYSTEM_EXIT_RENDER);
    }
    status = walk_plan_open(of, &plan, &setup);
    if (status == FXL_E_CAPACITY) {
        return fail_capacity(of, act);
    }
    if (status == FXL_OK) {
        status = act_attach(&setup.renderer);
    }
    return status == FXL_OK ? SYSTEM_EXIT_DONE : fail_status("renderer", status, SYSTEM_EXIT_RENDER);
}

/* The column at which a frame is drawn as two rectangles, one after the other in the band's memory: in
 * every fourth frame another one. 0: the frame is drawn in whole rows, as each frame is of a live run or of a path without end. */
static uint32_t border_of(uint32_t frame, uint32_t width)
{
    return frame % 4u == 3u && width > 1 && !system_live() && !REPEATS ? 1u + frame * 509u % (width - 1u) : 0;
}

/* Draws the rectangles of a band of whole rows, which is then another one. border: as border_of says. */
static fxl_status draw_band(fxl_band *band, uint32_t border)
{
    const fxl_target *target = setup.renderer.target;
    fxl_status status;

    do {
        band->columns = (uint16_t)border;
        setup.renderer.fill(&setup.renderer, band, setup.config.background);
        status = fxl_frame_draw(&setup.renderer, band);
        if (status == FXL_OK) {
            status = act_draw_over(band, &setup.renderer.frame.view.lens);
        }
        band->pixels += border * (target->pixel_bits / 8u);
        band->first_column = (uint16_t)(band->first_column + border);
        border = band->width - border;
    } while (status == FXL_OK && band->first_column != 0 && band->first_column != band->width);
    return status;
}

/* Draws the frame in bands as high as memory allows. border: as border_of says. */
static int draw_bands(uint32_t frame, uint32_t border, stopwatch *watch)
{
    const uint16_t width = setup.config.width, height = setup.config.height;
    const uint32_t rows_max = band_rows(width, setup.renderer.target->pixel_bits);
    uint32_t row, rows;

    for (row = 0; row < height; row += rows) {
        fxl_band band = {.pixels = band_pixels.pixels,
                         .width = width,
                         .stride = width,
                         .first_row = (uint16_t)row,
                         .palette = setup.renderer.palette};
        fxl_status status;

        system_alive();
        rows = rows_max < height - row ? rows_max : height - row;
        band.rows = (uint16_t)rows;
        stopwatch_start(watch);
        status = draw_band(&band, border);
        stopwatch_stop(watch);
        if (status != FXL_OK) {
            return fail_status("draw", status, SYSTEM_EXIT_RENDER);
        }
        if (!display_flush(0, (uint16_t)row, width, (uint16_t)rows, band_pixels.pixels)) {
            return fail_frame("the display did not take every pixel", frame, SYSTEM_EXIT_DISPLAY);
        }
    }
    return SYSTEM_EXIT_DONE;
}

PART int walk_frame(walk_path *path, uint32_t frame)
{
    const uint32_t held = walk_path_wants_keys(path) ? input_keys() : 0;
    const uint32_t border = border_of(frame, setup.config.width);
    static uint32_t begun; /* frames, where the path is drawn again and again */
    stopwatch watch = {0, 0, false};
    fxl_status status = act_step(&setup, path, frame, held);
    int code;

    if (status != FXL_OK) {
        return fail_status("step", status, SYSTEM_EXIT_INPUT);
    }
    if (!journal_begin(REPEATS ? begun++ : frame, &path->viewer.pose)) {
        return fail_frame("the pose could not be noted", frame, SYSTEM_EXIT_JOURNAL);
    }
    stopwatch_start(&watch);
    status = fxl_frame_begin(&setup.renderer, &path->viewer.pose);
    stopwatch_stop(&watch);
    if (status != FXL_OK) {
        return fail_status("frame", status, SYSTEM_EXIT_RENDER);
    }
    code = draw_bands(frame, border, &watch);
    status = act_end(&setup.renderer);
    if (code == SYSTEM_EXIT_DONE && status != FXL_OK) {
        return fail_status("end", status, SYSTEM_EXIT_RENDER);
    }
    if (code == SYSTEM_EXIT_DONE && walk_methods_unsplit(&setup.renderer) > 0) {
        return fail_frame("the display list's memory is too small to cut what moves among the tree",
                          frame, SYSTEM_EXIT_CAPACITY);
    }
    if (code == SYSTEM_EXIT_DONE &&
        !journal_end(&setup.renderer.workspace.counters, path->viewer.clamped,
                     border > 0 ? 0 : stopwatch_read(&watch))) {
        return fail_frame("the counters could not be noted", frame, SYSTEM_EXIT_JOURNAL);
    }
    return code;
}

static int draw_frames(walk_path *path, uint32_t frames)
{
    uint32_t frame;

    for (frame = 0; frame < frames; frame++) {
        const int code = walk_frame(path, frame);

        if (code != SYSTEM_EXIT_DONE) {
            return code;
        }
    }
    return SYSTEM_EXIT_DONE;
}

PART int walk_open(walk_path *path)
{
    fxl_scene_image *const image = &band_pixels.opening.image;
    int code = open_scene(image);

    if (code == SYSTEM_EXIT_DONE) {
        code = open_renderer(image);
    }
    if (code == SYSTEM_EXIT_DONE) {
        walk_path_begin(path, image, system_live());
    }
    return code;
}

/* Draws the path once; or without end, until something fails. Each time the scene begins as it was made. */
static int draw_path(walk_path *path, uint32_t frames)
{
    int code = draw_frames(path, frames);

    while (REPEATS && code == SYSTEM_EXIT_DONE) {
        code = walk_open(path);
        if (code == SYSTEM_EXIT_DONE) {
            code = draw_frames(path, frames);
        }
    }
    return code;
}

PART int walk_show(uint32_t frames)
{
    if (!journal_open(frames)) {
        system_text("walk: the journal could not be opened\n");
        return SYSTEM_EXIT_JOURNAL;
    }
    if (!display_open(setup.config.width, setup.config.height, setup.renderer.target->pixel_bits,
                      plan.palette)) {
        system_text("walk: the display could not be opened\n");
        return SYSTEM_EXIT_DISPLAY;
    }
    return SYSTEM_EXIT_DONE;
}

int walk(void)
{
    walk_path path;
    uint32_t frames;
    bool closed;
    int code = walk_open(&path);

    if (code != SYSTEM_EXIT_DONE) {
        return code;
    }
    frames = system_frames() != 0 ? system_frames() : path.frame_count;
    code = walk_show(REPEATS ? UINT32_MAX : frames);
    if (code != SYSTEM_EXIT_DONE) {
        return code;
    }
    code = draw_path(&path, frames);
    closed = display_close();
    if (code != SYSTEM_EXIT_DONE) {
        return code;
    }
    if (!closed) {
        system_text("walk: the display could not be closed\n");
        return SYSTEM_EXIT_DISPLAY;
    }
    print_with_number("walk: done ", frames, " frames\n");
    return SYSTEM_EXIT_DONE;
}
