/* SPDX-License-Identifier: MIT */
#include "walk.h"

#include "act.h"
#include "billboards.h"
#include "contract/clock.h"
#include "contract/display.h"
#include "contract/input.h"
#include "contract/journal.h"
#include "contract/store.h"
#include "contract/system.h"
#include "fixel/all.h"
#include "looks.h"
#include "methods.h"
#include "path.h"
#include "surfaces.h"

/* A row of the widest screen must fit. */
_Static_assert(WALK_BAND_BYTES >= FXL_SCREEN_MAX, "WALK_BAND_BYTES is less than one row");

/* Where the build limits the rows of a band, no more memory than they take. */
#if defined WALK_ROWS_MAX && WALK_ROWS_MAX * FXL_SCREEN_MAX < WALK_BAND_BYTES
#define BAND_BYTES (WALK_ROWS_MAX * FXL_SCREEN_MAX)
#else
#define BAND_BYTES WALK_BAND_BYTES
#endif
static _Alignas(4) uint8_t band_pixels[BAND_BYTES];
static fxl_draw_entry order[WALK_ORDER_ENTRIES];
#if WALK_LIST_BYTES >= 4
static _Alignas(8) uint32_t list[WALK_LIST_BYTES / 4]; /* methods and beams take of it */
#else
static uint32_t *const list = NULL;           /* every band walks the scene */
#endif
#if WALK_CACHE_ENTRIES > 0
static fxl_cached_vertex cache[WALK_CACHE_ENTRIES];
#else
static fxl_cached_vertex *const cache = NULL; /* every face works its vertices out anew */
#endif
static fxl_renderer renderer;
static walk_methods methods;

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
static uint32_t band_rows(uint16_t width)
{
    const uint32_t most = (uint32_t)BAND_BYTES / (width * (methods.draws.target->pixel_bits / 8u));

#ifdef WALK_ROWS_MAX
    return most < WALK_ROWS_MAX ? most : WALK_ROWS_MAX;
#else
    return most;
#endif
}

/* How the list's memory is shared: what the act wants, what the scene's looks want, its billboards,
 * then what the methods want; the rest is the list. In bytes, multiples of 8. */
typedef struct {
    uint32_t act, looks, billboards, taken;
} shares;

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

static int share_list(const fxl_scene_image *image, shares *of)
{
    const uint32_t room = WALK_LIST_BYTES / 8 * 8;

    of->act = act_bytes(image);
    of->looks = walk_looks_bytes(image);
    of->billboards = walk_billboards_bytes(image);
    of->taken = of->act + of->looks + of->billboards;
    if (lacks_rgb565(image)) {
        return SYSTEM_EXIT_CAPACITY;
    }
    if (!walk_methods_choose(&methods, image, of->taken < room ? room - of->taken : 0)) {
        system_text("walk: this board has no room to draw by a BSP tree, with surfaces or with a "
                    "depth buffer (VISIBILITY=sorted), or billboards\n");
        if (image->surfaces.face_map != NULL && walk_surface_bytes(&image->surfaces) == 0) {
            system_text("walk: VISIBILITY=surfaces builds a program that draws surfaces\n");
        }
        return SYSTEM_EXIT_CAPACITY;
    }
#if !defined WALK_WITHOUT_RGB565
    if (band_rows(image->lens.width) == 0) {
        system_text("walk: this board's band holds no row of so wide a screen in RGB565\n");
        return SYSTEM_EXIT_CAPACITY;
    }
#endif
    of->taken += walk_methods_bytes(&methods);
    if (of->taken > room) {
        print_with_number("walk: what the scene has, clipper and visibility method need ",
                          of->taken, " bytes");
        print_with_number(", this board's display list has ", room, "\n");
        return SYSTEM_EXIT_CAPACITY;
    }
    return SYSTEM_EXIT_DONE;
}

/* What is left for the list. */
static uint32_t list_bytes(uint32_t taken)
{
    const uint32_t left = WALK_LIST_BYTES - taken;

#ifdef WALK_LIST_MOST
    return left < WALK_LIST_MOST ? left : WALK_LIST_MOST;
#else
    return left;
#endif
}

static int open_renderer(fxl_scene_image *image)
{
    uint8_t *const bytes = (uint8_t *)list;
    const fxl_scene *scene;
    shares of;
    fxl_status status;
    int code = share_list(image, &of);

    if (code != SYSTEM_EXIT_DONE) {
        return code;
    }
    status = act_open(image, list, &scene);
    if (status != FXL_OK) {
        return fail_status("scene", status, SYSTEM_EXIT_RENDER);
    }
    const fxl_memory memory = {.draw_list = order,
                               .draw_list_capacity = WALK_ORDER_ENTRIES,
                               .display_list = of.taken > 0 ? list + of.taken / 4 : list,
                               .display_list_capacity = list_bytes(of.taken) / 4,
                               .cache = cache,
                               .cache_capacity = WALK_CACHE_ENTRIES};
    status = fxl_renderer_init_with(&renderer, scene, &image->lens, &memory);
    if (status == FXL_E_CAPACITY) {
        print_with_number("walk: the scene needs ", scene->draw_list_needed, " order entries");
        print_with_number(", this board has ", WALK_ORDER_ENTRIES, "\n");
        return SYSTEM_EXIT_CAPACITY;
    }
    if (status == FXL_OK) {
        status =
            walk_methods_set(&methods, image, &renderer, bytes + of.act + of.looks + of.billboards);
    }
    if (status == FXL_OK) {
        status = walk_looks_open(image, methods.draws.surfaces, &renderer, bytes + of.act);
    }
    if (status == FXL_OK) {
        status = walk_billboards_open(image, methods.draws.sprites, &renderer,
                                      bytes + of.act + of.looks);
    }
    if (status == FXL_OK) {
        status = act_attach(&renderer);
    }
    if (status != FXL_OK) {
        return fail_status("renderer", status, SYSTEM_EXIT_RENDER);
    }
    return SYSTEM_EXIT_DONE;
}

/* The column at which a frame is drawn as two rectangles, one after the other in the band's memory: in
 * every fourth frame another one. 0: the frame is drawn in whole rows, as each frame is of a live run or of a path without end. */
static uint32_t border_of(uint32_t frame, uint32_t width)
{
    return frame % 4u == 3u && width > 1 && !system_live() && !REPEATS ? 1u + frame * 509u % (width - 1u) : 0;
}

/* Draws the rectangles of a band of whole rows, which is then another one. border: as border_of says. */
static fxl_status draw_band(const fxl_scene_image *image, fxl_band *band, uint32_t border)
{
    fxl_status status;

    do {
        band->columns = (uint16_t)border;
        methods.draws.target->fill(band, image->background);
        status = fxl_frame_draw(&renderer, band);
        if (status == FXL_OK) {
            status = act_draw_over(band, &image->lens);
        }
        band->pixels += border * (methods.draws.target->pixel_bits / 8u);
        band->first_column = (uint16_t)(band->first_column + border);
        border = band->width - border;
    } while (status == FXL_OK && band->first_column != 0 && band->first_column != band->width);
    return status;
}

/* Draws the frame in bands as high as memory allows. border: as border_of says. */
static int draw_bands(const fxl_scene_image *image, uint32_t frame, uint32_t border, stopwatch *watch)
{
    const uint16_t width = image->lens.width, height = image->lens.height;
    const uint32_t rows_max = band_rows(width);
    uint32_t row, rows;

    for (row = 0; row < height; row += rows) {
        fxl_band band = {.pixels = band_pixels,
                         .width = width,
                         .stride = width,
                         .first_row = (uint16_t)row,
                         .palette = renderer.palette};
        fxl_status status;

        system_alive();
        rows = rows_max < height - row ? rows_max : height - row;
        band.rows = (uint16_t)rows;
        stopwatch_start(watch);
        status = draw_band(image, &band, border);
        stopwatch_stop(watch);
        if (status != FXL_OK) {
            return fail_status("draw", status, SYSTEM_EXIT_RENDER);
        }
        if (!display_flush(0, (uint16_t)row, width, (uint16_t)rows, band_pixels)) {
            return fail_frame("the display did not take every pixel", frame, SYSTEM_EXIT_DISPLAY);
        }
    }
    return SYSTEM_EXIT_DONE;
}

static int draw_frame(const fxl_scene_image *image, walk_path *path, uint32_t frame)
{
    const uint32_t held = walk_path_wants_keys(path) ? input_keys() : 0;
    const uint32_t border = border_of(frame, image->lens.width);
    static uint32_t begun; /* frames, however often the path is drawn */
    stopwatch watch = {0, 0, false};
    fxl_status status = act_step(path, frame, held);
    int code;

    if (status != FXL_OK) {
        return fail_status("step", status, SYSTEM_EXIT_INPUT);
    }
    if (!journal_begin(begun++, &path->viewer.pose)) {
        return fail_frame("the pose could not be noted", frame, SYSTEM_EXIT_JOURNAL);
    }
    stopwatch_start(&watch);
    status = fxl_frame_begin(&renderer, &path->viewer.pose);
    stopwatch_stop(&watch);
    if (status != FXL_OK) {
        return fail_status("frame", status, SYSTEM_EXIT_RENDER);
    }
    code = draw_bands(image, frame, border, &watch);
    status = act_end(&renderer);
    if (code == SYSTEM_EXIT_DONE && status != FXL_OK) {
        return fail_status("end", status, SYSTEM_EXIT_RENDER);
    }
    if (code == SYSTEM_EXIT_DONE && walk_methods_unsplit(&methods, &renderer) > 0) {
        return fail_frame("the display list's memory is too small to cut what moves among the tree",
                          frame, SYSTEM_EXIT_CAPACITY);
    }
    if (code == SYSTEM_EXIT_DONE &&
        !journal_end(&renderer.workspace.counters, path->viewer.clamped,
                     border > 0 ? 0 : stopwatch_read(&watch))) {
        return fail_frame("the counters could not be noted", frame, SYSTEM_EXIT_JOURNAL);
    }
    return code;
}

static int draw_frames(const fxl_scene_image *image, uint32_t frames)
{
    walk_path path;
    uint32_t frame;

    walk_path_begin(&path, image, system_live());
    for (frame = 0; frame < frames; frame++) {
        const int code = draw_frame(image, &path, frame);

        if (code != SYSTEM_EXIT_DONE) {
            return code;
        }
    }
    return SYSTEM_EXIT_DONE;
}

static int open_walk(fxl_scene_image *image)
{
    const int code = open_scene(image);

    return code == SYSTEM_EXIT_DONE ? open_renderer(image) : code;
}

/* Draws the path once; or without end, until something fails. Each time the scene begins as it was made. */
static int draw_path(fxl_scene_image *image, uint32_t frames)
{
    int code = draw_frames(image, frames);

    while (REPEATS && code == SYSTEM_EXIT_DONE) {
        code = open_walk(image);
        if (code == SYSTEM_EXIT_DONE) {
            code = draw_frames(image, frames);
        }
    }
    return code;
}

int walk(void)
{
    fxl_scene_image image;
    uint32_t frames;
    bool closed;
    int code = open_walk(&image);

    if (code != SYSTEM_EXIT_DONE) {
        return code;
    }
    frames = system_frames() != 0 ? system_frames() : image.frame_count;
    if (!journal_open(REPEATS ? UINT32_MAX : frames)) {
        system_text("walk: the journal could not be opened\n");
        return SYSTEM_EXIT_JOURNAL;
    }
    if (!display_open(image.lens.width, image.lens.height, methods.draws.target->pixel_bits,
                      image.palette)) {
        system_text("walk: the display could not be opened\n");
        return SYSTEM_EXIT_DISPLAY;
    }
    code = draw_path(&image, frames);
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
