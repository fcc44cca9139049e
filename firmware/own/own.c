/* SPDX-License-Identifier: MIT */
#include "own.h"

#include <stddef.h>

#include "contract/clock.h"
#include "contract/panel.h"
#include "contract/system.h"
#include "fixel.h"
#include "fixel/changed.h"
#include "fixel/lines.h"
#include "parts/dump.h"

fxl_status __real_fxl_frame_begin(fxl_renderer *renderer, const fxl_pose *pose);
fxl_status __wrap_fxl_frame_begin(fxl_renderer *renderer, const fxl_pose *pose);
void __real_fxl_frame_fill(const fxl_renderer *renderer, const fxl_band *band, uint8_t colour);
void __wrap_fxl_frame_fill(const fxl_renderer *renderer, const fxl_band *band, uint8_t colour);
fxl_status __real_fxl_frame_draw(fxl_renderer *renderer, const fxl_band *band);
fxl_status __wrap_fxl_frame_draw(fxl_renderer *renderer, const fxl_band *band);
fxl_status __real_fxl_render(fxl_renderer *renderer, const fxl_pose *eye, void *pixels,
                             uint16_t stride);
fxl_status __wrap_fxl_render(fxl_renderer *renderer, const fxl_pose *eye, void *pixels,
                             uint16_t stride);
fxl_status __real_fxl_changed_find(fxl_changed *changed, const fxl_renderer *renderer);
fxl_status __wrap_fxl_changed_find(fxl_changed *changed, const fxl_renderer *renderer);
fxl_status __real_fxl_frame_draw_line(fxl_renderer *renderer, fxl_workspace *workspace,
                                      const fxl_world_line *line, const fxl_band *band);
fxl_status __wrap_fxl_frame_draw_line(fxl_renderer *renderer, fxl_workspace *workspace,
                                      const fxl_world_line *line, const fxl_band *band);
int __real_main(int argc, char **argv);
int __wrap_main(int argc, char **argv);

/* place pixel-format: the frames of a program of the user's own */
/* The frame that is shown, and the panels to which it goes: the board's first one, which is the dump or a display, and with
 * DRIVER= that of the driver. */
static struct {
    const panel *shows[2]; /* null: not open, or not there */
    bool in_frame;
    bool in_boxes;        /* in a frame of boxes: what fxl_changed_find found */
    /* Of such a frame: dump_box, or null if the first panel is no dump. A pointer, so that programs without
     * boxes do not link it. */
    bool (*dump_box)(const fxl_screen_box *box);
    uint32_t frames, most; /* ended; after how many the program ends, 0: it ends itself */
    uint16_t width, height, row;
    uint8_t pixel_bits;
} shown;

/* What was drawn last. */
static struct {
    const fxl_renderer *renderer;
    fxl_pose pose;
    uint64_t spent; /* instructions for the frame so far */
    uint16_t width;
    uint8_t pixel_bits;
    bool is_whole; /* a frame in one band */
} drawn;

/* Rows that are shown when the next ones are cleared or drawn, or at the end: the program may draw
 * over them until then. */
static struct {
    const void *pixels; /* null: none */
    fxl_screen_box box;
    uint16_t stride;
} held;

static const void *cleared; /* pixels that fxl_frame_fill cleared and nothing drew into yet */
static const uint8_t *first_frame; /* the stack of main is below */

extern const panel driver_panel __attribute__((weak)); /* boards/parts/driver_panel.c */

static void fail(const char *sentence, int status)
{
    system_text("own: ");
    system_text(sentence);
    system_text("\n");
    system_exit(status);
}

static void print_done(void)
{
    char digits[11]; /* 4294967295 and the 0 that ends it */
    char *first = &digits[sizeof digits - 1];
    uint32_t left = shown.frames;

    *first = '\0';
    do {
        first--;
        *first = (char)('0' + left % 10u);
        left /= 10u;
    } while (left != 0);
    system_text("own: done ");
    system_text(first);
    system_text(" frames\n");
}

static bool close_panels(bool whole)
{
    bool is_shown = true;

    for (uint32_t i = 0; i < 2 && shown.shows[i] != NULL; i++) {
        is_shown = shown.shows[i]->close(whole) && is_shown;
    }
    return is_shown;
}

static void end_frame(void);

/* What a dump has before the pixels of a box, and with a box of 0 columns behind the last one. */
static void dump_head(const fxl_screen_box *box)
{
    if (shown.dump_box != NULL && !shown.dump_box(box)) {
        fail("the frames could not be shown", SYSTEM_EXIT_DISPLAY);
    }
}

/* A frame of boxes ends when the next one begins, or with the program: it has as many boxes as it has. */
static void end_boxes(void)
{
    static const fxl_screen_box none = {0, 0, 0, 0};

    if (shown.in_boxes) {
        shown.in_boxes = false;
        dump_head(&none);
        shown.dump_box = NULL;
        end_frame();
    }
}

/* Ends the program where main drew no frame, or not the whole of its last one. */
static void check_frames(void)
{
    end_boxes();
    if (shown.shows[0] == NULL) {
        fail("main drew no frame: it called neither fxl_render nor fxl_frame_draw",
             SYSTEM_EXIT_PROGRAM);
    }
    if (shown.in_frame) {
        (void)close_panels(false);
        fail("main returned within a frame: its last rows were not drawn", SYSTEM_EXIT_PROGRAM);
    }
}

static void finish(void)
{
    check_frames();
    if (!close_panels(true)) {
        fail("the frames could not be shown", SYSTEM_EXIT_DISPLAY);
    }
    print_done();
    system_exit(SYSTEM_EXIT_DONE);
}

static void open_panels(void)
{
    const panel *const panels[] = {board_panels()[0], &driver_panel};
    const fxl_lens *lens = &drawn.renderer->frame.view.lens;
    const panel_format format = {own_colours, 0, lens->width, lens->height, drawn.pixel_bits};

    shown.width = lens->width;
    shown.height = lens->height;
    shown.pixel_bits = drawn.pixel_bits;
    for (uint32_t i = 0; i < 2 && panels[i] != NULL && (i == 0 || panels[i] != panels[0]); i++) {
        if (panels[i]->open(&format) != PANEL_READY) {
            fail("the display could not be opened: the frames may be larger than it is", SYSTEM_EXIT_DISPLAY);
        }
        shown.shows[i] = panels[i];
    }
}

static void begin_frame(void)
{
    if (shown.shows[0] == NULL) {
        open_panels();
    }
    if (drawn.width != shown.width || drawn.pixel_bits != shown.pixel_bits ||
        drawn.renderer->frame.view.lens.height != shown.height) {
        fail("a frame has another size, or other pixels, than the frame before",
             SYSTEM_EXIT_DISPLAY);
    }
    for (uint32_t i = 0; i < 2 && shown.shows[i] != NULL; i++) {
        const uint32_t number =
            i == 0 && shown.dump_box != NULL ? shown.frames | DUMP_BOXES : shown.frames;

        if (shown.shows[i]->begin != NULL && !shown.shows[i]->begin(number, &drawn.pose)) {
            fail("the frames could not be shown", SYSTEM_EXIT_DISPLAY);
        }
    }
    shown.in_frame = true;
    shown.row = 0;
}

static void end_frame(void)
{
    fxl_counters counters = drawn.renderer->workspace.counters;

    if (drawn.is_whole) {
        counters.spilled = 0; /* one band computed them, once */
    }
    for (uint32_t i = 0; i < 2 && shown.shows[i] != NULL; i++) {
        if (!shown.shows[i]->end(&counters, 0, drawn.spent)) {
            fail("the frames could not be shown", SYSTEM_EXIT_DISPLAY);
        }
    }
    shown.in_frame = false;
    shown.frames++;
    drawn.spent = 0;
    system_alive();
    if (shown.frames == shown.most) {
        finish();
    }
    if (own_wait != NULL) {
        own_wait();
    }
}

uint16_t own_width(void)
{
    return drawn.width;
}

static void show_pixels(const fxl_screen_box *box, const void *pixels, uint16_t stride)
{
    const uint32_t row_bytes = (uint32_t)stride * (drawn.pixel_bits / 8u);
    /* A panel takes rows without a gap between them. */
    const uint16_t at_once = stride == box->columns ? box->rows : 1;
    const uint8_t *row = pixels;

    for (uint16_t i = 0; i < box->rows; i = (uint16_t)(i + at_once)) {
        for (uint32_t each = 0; each < 2 && shown.shows[each] != NULL; each++) {
            if (!shown.shows[each]->flush(box->first_column, (uint16_t)(box->first_row + i),
                                          box->columns, at_once, row)) {
                fail(shown.in_boxes ? "a box could not be shown: DRIVER= may send other columns, or other rows, than the pump of the program"
                                    : "the frames could not be shown",
                     SYSTEM_EXIT_DISPLAY);
            }
        }
        row += row_bytes;
    }
}

/* The rows of a frame that is drawn whole. */
static void show_whole_rows(const fxl_screen_box *box, const void *pixels, uint16_t stride)
{
    if (box->first_row == 0 && !shown.in_frame) {
        begin_frame();
    }
    if (!shown.in_frame || box->first_row != shown.row ||
        box->rows > shown.height - box->first_row) {
        fail("the rows of a frame do not go downward, each once", SYSTEM_EXIT_DISPLAY);
    }
    if (box->columns != shown.width) {
        fail("a band of some columns cannot be shown: only a frame of which fxl_changed_find was asked has such bands", SYSTEM_EXIT_DISPLAY);
    }
    show_pixels(box, pixels, stride);
    shown.row = (uint16_t)(box->first_row + box->rows);
    if (shown.row == shown.height) {
        end_frame();
    }
}

static void show(const fxl_screen_box *box, const void *pixels, uint16_t stride)
{
    if (!shown.in_boxes) {
        show_whole_rows(box, pixels, stride);
        return;
    }
    dump_head(box);
    show_pixels(box, pixels, stride);
}

void own_show(uint16_t first_row, uint16_t rows, const void *pixels, uint16_t stride)
{
    const fxl_screen_box box = {0, drawn.width, first_row, rows};

    if (drawn.renderer == NULL) {
        fail("rows are shown before any were drawn", SYSTEM_EXIT_DISPLAY);
    }
    show(&box, pixels, stride);
}

static void show_held(void)
{
    const void *pixels = held.pixels;

    if (pixels != NULL) {
        held.pixels = NULL;
        show(&held.box, pixels, held.stride);
    }
}

/* Shows rows that were drawn. Those that the next ones may take the place of without a call that is
 * seen here are shown at once. stack: the stack of who called the library is above. */
static void hold(const fxl_screen_box *box, const void *pixels, uint16_t stride, bool is_seen,
                 const uint8_t *stack)
{
    held.pixels = pixels;
    held.box = *box;
    held.stride = stride;
    /* Pixels on the stack of main, or of who it called, may be gone when the next ones come. */
    if (!is_seen || ((const uint8_t *)pixels > stack && (const uint8_t *)pixels < first_frame)) {
        show_held();
    }
}

/* first_row, end_row: of what was drawn. */
static void note(fxl_renderer *renderer, uint16_t width, uint32_t first_row, uint32_t end_row)
{
    const uint16_t height = renderer->frame.view.lens.height;

    drawn.is_whole = first_row == 0 && end_row == height;
    drawn.renderer = renderer;
    drawn.width = width;
    drawn.pixel_bits = renderer->palette != NULL ? 16 : 8;
    if (own_keep != NULL && end_row == height) {
        own_keep(renderer);
    }
}

fxl_status __wrap_fxl_frame_begin(fxl_renderer *renderer, const fxl_pose *pose)
{
    uint64_t before;
    fxl_status status;

    show_held();
    end_boxes();
    before = clock_instructions();
    status = __real_fxl_frame_begin(renderer, pose);
    if (status == FXL_OK) {
        drawn.spent = clock_instructions() - before;
        drawn.pose = *pose;
    }
    return status;
}

void __wrap_fxl_frame_fill(const fxl_renderer *renderer, const fxl_band *band, uint8_t colour)
{
    show_held();
    cleared = band->pixels;
    __real_fxl_frame_fill(renderer, band, colour);
}

fxl_status __wrap_fxl_frame_draw(fxl_renderer *renderer, const fxl_band *band)
{
    uint64_t before;
    fxl_status status;

    show_held();
    before = clock_instructions();
    status = __real_fxl_frame_draw(renderer, band);
    if (status != FXL_OK) {
        return status;
    }
    drawn.spent += clock_instructions() - before;
    system_alive(); /* a program may draw over each band for long */
    note(renderer, band->width, band->first_row, (uint32_t)band->first_row + band->rows);
    if (&own_has_display_rows == NULL) {
        const fxl_screen_box box = {band->first_column, band->columns != 0 ? band->columns : band->width,
                                    band->first_row, band->rows};

        /* A program that clears no band may paint its own background into the next one. */
        hold(&box, band->pixels, band->stride, cleared == band->pixels, __builtin_frame_address(0));
    }
    cleared = NULL;
    return FXL_OK;
}

fxl_status __wrap_fxl_render(fxl_renderer *renderer, const fxl_pose *eye, void *pixels,
                             uint16_t stride)
{
    uint64_t before;
    fxl_status status;

    show_held();
    end_boxes();
    before = clock_instructions();
    status = __real_fxl_render(renderer, eye, pixels, stride);
    if (status != FXL_OK) {
        return status;
    }
    drawn.spent = clock_instructions() - before;
    drawn.pose = *eye;
    note(renderer, renderer->frame.view.lens.width, 0, renderer->frame.view.lens.height);
    if (&own_has_display_rows != NULL) {
        return FXL_OK;
    }
    const fxl_screen_box box = {0, drawn.width, 0, renderer->frame.view.lens.height};

    hold(&box, pixels, stride, true, __builtin_frame_address(0));
    return FXL_OK;
}

/* A program may draw more lines over a band than there is time for without a sign of life, to the board and, by the clock, to an
 * emulator. What they take is not counted: to read the clock for each would take longer. */
fxl_status __wrap_fxl_frame_draw_line(fxl_renderer *renderer, fxl_workspace *workspace,
                                      const fxl_world_line *line, const fxl_band *band)
{
    static uint32_t lines;

    system_alive();
    if (++lines % 4096u == 0) {
        (void)clock_instructions();
    }
    return __real_fxl_frame_draw_line(renderer, workspace, line, band);
}

/* From here on the bands of the frame are those of boxes: the rest of the picture stays. */
fxl_status __wrap_fxl_changed_find(fxl_changed *changed, const fxl_renderer *renderer)
{
    uint64_t before;
    fxl_status status;

    show_held();
    before = clock_instructions();
    status = __real_fxl_changed_find(changed, renderer);
    if (status != FXL_OK) {
        return status;
    }
    drawn.spent += clock_instructions() - before;
    if (shown.in_frame) {
        if (!shown.in_boxes) {
            fail("fxl_changed_find was asked within a frame whose rows came", SYSTEM_EXIT_DISPLAY);
        }
        return FXL_OK;
    }
    note((fxl_renderer *)(uintptr_t)renderer, renderer->frame.view.lens.width, 0, 0);
#if !defined OWN_REPEATS /* without a debugger there is no dump */
    shown.dump_box = board_panels()[0] == &dump_panel ? dump_box : NULL;
#endif
    begin_frame();
    shown.in_boxes = true;
    if (own_keep != NULL) {
        own_keep((fxl_renderer *)(uintptr_t)renderer);
    }
    return FXL_OK;
}

#if defined OWN_REPEATS
/* Memory of the program's own files: linker/sections.ld. */
extern uint8_t fxl_data_load[], fxl_data_start[];
extern uint8_t fxl_unit_data_start[], fxl_unit_data_end[], fxl_unit_bss_start[], fxl_unit_bss_end[];

/* Without a debugger there is no host to end for: main begins again when it has returned, with its variables as they
 * were at first, and the display goes on showing what it shows. */
static bool begins_again(void)
{
    const size_t offset = (size_t)(fxl_unit_data_start - fxl_data_start);
    uint8_t *to;

    check_frames();
    for (to = fxl_unit_data_start; to < fxl_unit_data_end; to++) {
        *to = fxl_data_load[offset + (size_t)(to - fxl_unit_data_start)];
    }
    for (to = fxl_unit_bss_start; to < fxl_unit_bss_end; to++) {
        *to = 0;
    }
    return true;
}
#else
static bool begins_again(void)
{
    return false;
}
#endif

int __wrap_main(int argc, char **argv)
{
    int answer;

    first_frame = __builtin_frame_address(0);
    system_start(own_arguments != NULL ? own_arguments(argc, argv) : argc, argv);
    shown.most = system_frames();
    system_alive();
    do {
        answer = __real_main(argc, argv);
        if (answer != 0) {
            fail("main did not return 0", SYSTEM_EXIT_PROGRAM);
        }
        show_held();
    } while (begins_again());
    finish();
    return 0; /* not reached */
}
