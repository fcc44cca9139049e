/* SPDX-License-Identifier: MIT */
/* The pump that draws and sends what changed, its sinks and displays, and what is refused.
 * docs/extras/changed.md. */
#include "changed_unit.h"
#include "controller.h"
#include "pixel_formats.h"

enum {
    WIDTH = CHANGED_WIDTH,
    HEIGHT = CHANGED_HEIGHT,
    ROWS = 8,
    FRAMES = 12
};

static uint8_t palette[768], frame[HEIGHT * WIDTH], shown[HEIGHT * WIDTH];
static uint32_t expected[WIDTH * ROWS];
static uint64_t memory[FXL_PUMP_MEMORY(WIDTH, ROWS, 24)];
static fxl_pixels pixels;
static fxl_pump pump;
static transfer wires;
static fxl_screen_box last_box; /* that came */
static uint32_t starts, failing;
static uint64_t sent;
static controller model;
static fxl_display display;
static fxl_renderer reference; /* of the same world: it draws the frame whole */
static fxl_draw_entry reference_order[CHANGED_PLACES + 6];

void setUp(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    for (uint32_t i = 0; i < sizeof palette; i++) {
        palette[i] = (uint8_t)(i * 37u);
    }
    changed_start_plain(&changed_palette, &lens, false, 0);
    changed_eye = (fxl_pose){{0, 0, -Q16(6)}, 0, 0, 0};
    const fxl_memory tables = {reference_order, CHANGED_PLACES + 6, NULL, 0, NULL, 0};
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_init_with(&reference, &changed_world.scene, &lens, &tables));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_attach(&changed_world, &reference));
    reference.frame.background = changed_renderer.frame.background;
    memset(&wires, 0, sizeof wires);
    starts = 0;
    failing = UINT32_MAX;
    sent = 0;
}

void tearDown(void)
{
    transfer_wait(&wires);
    transfer_wait(&model.wire);
}

/* --- a sink of the program ---------------------------------------------------------------------- */

/* Expects the bytes of the frame that is being sent, and keeps where they belong. */
static bool start_box(void *user, const fxl_screen_box *box, const uint8_t *bytes, size_t size)
{
    const fxl_band band = {.pixels = frame + box->first_row * WIDTH + box->first_column,
                           .width = WIDTH,
                           .stride = WIDTH,
                           .first_row = box->first_row,
                           .rows = box->rows,
                           .first_column = box->first_column,
                           .columns = box->columns};
    TEST_ASSERT_EQUAL_PTR(&wires, user);
    TEST_ASSERT_NULL(wires.bytes);
    if (starts++ == failing) {
        return false;
    }
    TEST_ASSERT_EQUAL(fxl_pixels_size(pixels.format, box->columns, box->rows), size);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_convert(&pixels, &band, expected, sizeof expected));
    TEST_ASSERT_EQUAL_MEMORY(expected, bytes, size);
    for (uint32_t y = box->first_row; y < (uint32_t)box->first_row + box->rows; y++) {
        memcpy(&shown[y * WIDTH + box->first_column], &frame[y * WIDTH + box->first_column],
               box->columns);
    }
    last_box = *box;
    sent += size;
    return true;
}

static bool start(void *user, uint16_t first_row, uint16_t rows, const uint8_t *bytes, size_t size)
{
    const fxl_screen_box box = {0, WIDTH, first_row, rows};
    return start_box(user, &box, bytes, size);
}

static bool wait(void *user)
{
    TEST_ASSERT_EQUAL_PTR(&wires, user);
    return true;
}

static fxl_status init(const fxl_pixel_format *format, bool has_boxes, uint32_t columns)
{
    const fxl_pump_sink sink = {&wires, start, wait, has_boxes ? start_box : NULL,
                                (uint8_t)(columns - 1u)};
    const fxl_pump_config config = {&pixels, WIDTH, HEIGHT, ROWS, NULL};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_init(&pixels, format, palette));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_init(&changed, changed_kept, sizeof changed_kept));
    return fxl_pump_init(&pump, &config, &sink, memory, sizeof memory);
}

/* The frame as it will be, and what the pump makes of it. */
static fxl_status show_changes(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&reference, &changed_eye, frame, WIDTH));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&reference));
    const fxl_status status = fxl_pump_changed(&pump, &changed_renderer, &changed_eye, &changed);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&changed_renderer));
    return status;
}

static const fxl_pixel_format *const formats[] = EVERY_FORMAT;

static void expect_built_up(const fxl_pixel_format *format, bool has_boxes, uint32_t columns)
{
    TEST_ASSERT_EQUAL(FXL_OK, init(format, has_boxes, columns));
    memset(shown, 0x5A, sizeof shown);
    sent = 0;
    for (uint32_t i = 0; i < FRAMES; i++) {
        TEST_ASSERT_EQUAL(FXL_OK, show_changes());
        TEST_ASSERT_EQUAL_MEMORY(frame, shown, sizeof frame);
        TEST_ASSERT_TRUE(last_box.first_row % format->rows == 0);
        TEST_ASSERT_TRUE(has_boxes ? last_box.first_column % columns == 0
                                   : last_box.columns == WIDTH);
        changed_change_world();
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_wait(&pump));
    TEST_ASSERT_LESS_THAN(FRAMES * fxl_pixels_size(format, WIDTH, HEIGHT), sent);
}

/* changed 3.2c-f, 3.2h, 4.1a-b, 4.3a-b */
void test_a_display_shows_the_frame_that_was_sent_in_boxes(void)
{
    for (uint32_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        for (uint32_t columns = 1; columns <= 8; columns *= 2) {
            expect_built_up(formats[i], true, columns);
        }
        expect_built_up(formats[i], false, 1);
    }
}

/* changed 4.1c */
void test_nothing_is_sent_where_nothing_changed(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, init(&fxl_pixels_rgb565, true, 1));
    TEST_ASSERT_EQUAL(FXL_OK, show_changes());
    TEST_ASSERT_EQUAL(HEIGHT / ROWS, starts);
    TEST_ASSERT_TRUE(changed.whole);
    TEST_ASSERT_EQUAL(FXL_OK, show_changes());
    TEST_ASSERT_EQUAL(0, changed.count);
    TEST_ASSERT_FALSE(changed.whole);
    TEST_ASSERT_EQUAL(HEIGHT / ROWS, starts);
}

/* changed 4.1d */
void test_after_a_failure_comes_the_whole_frame(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, init(&fxl_pixels_rgb565, true, 1));
    failing = 2;
    TEST_ASSERT_EQUAL(FXL_E_DISPLAY, show_changes());
    TEST_ASSERT_EQUAL(FXL_OK, show_changes());
    TEST_ASSERT_TRUE(changed.whole);
    TEST_ASSERT_EQUAL_MEMORY(frame, shown, sizeof frame);
}

/* --- displays --------------------------------------------------------------------------------- */

static const fxl_display_port port = {&model, controller_send, controller_begin, controller_wait,
                                      controller_pause};

/* Of pages the model keeps all rows. */
static void open_display(int kind)
{
    const fxl_display_config config = fxl_display_config_default(controllers[kind].driver, 0);
    const uint16_t left = (uint16_t)((config.width - WIDTH) / 2u);
    const bool has_pages = controllers[kind].page > 1;
    controller_start(&model, kind, left, has_pages ? 0 : (uint16_t)((config.height - HEIGHT) / 2u),
                     WIDTH, has_pages ? config.height : HEIGHT);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &port, palette));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_place(&display, WIDTH, HEIGHT));
    const fxl_pump_config bands = {&display.pixels, WIDTH, HEIGHT, ROWS, NULL};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_init(&pump, &bands, &display.sink, memory, sizeof memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_init(&changed, changed_kept, sizeof changed_kept));
}

/* What a pixel is on the glass: its two bytes, or its bit of a page. */
static uint32_t expected_pixel(const uint8_t *bytes, uint32_t x, uint32_t y)
{
    return model.is_colour
               ? (uint32_t)bytes[2u * (y * WIDTH + x)] << 8 | bytes[2u * (y * WIDTH + x) + 1u]
               : (uint32_t)bytes[y / 8u * WIDTH + x] >> (y & 7u) & 1u;
}

static void expect_glass(void)
{
    static uint32_t bytes[WIDTH * HEIGHT / 2];
    const fxl_band all = UNIT_BAND(frame, WIDTH, 0, HEIGHT);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_convert(&display.pixels, &all, bytes, sizeof bytes));
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const uint32_t x = i % WIDTH, y = i / WIDTH;
        TEST_ASSERT_EQUAL_HEX(
            expected_pixel((const uint8_t *)bytes, x, y),
            controller_pixel(&model, (uint16_t)(display.left + x), (uint16_t)(display.top + y)));
    }
}

/* changed 3.2g, 4.3a */
void test_displays_take_boxes(void)
{
    static const int kinds[] = {CONTROLLER_ST7789, CONTROLLER_SH1107};
    for (uint32_t kind = 0; kind < 2; kind++) {
        open_display(kinds[kind]);
        for (uint32_t i = 0; i < FRAMES; i++) {
            TEST_ASSERT_EQUAL(FXL_OK, show_changes());
            TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_wait(&pump));
            expect_glass();
            changed_change_world();
        }
    }
}

/* Pages begin with one, addresses of two columns with one; a memory LCD takes whole rows alone. */
/* changed 3.2e, 3.2h */
void test_what_a_display_takes(void)
{
    static const fxl_screen_box odd = {1, 4, 8, 8}, ends = {2, 3, 8, 8},
                                beyond = {WIDTH - 2, 4, 8, 8}, page = {2, 4, 3, 8};
    static const uint8_t bytes[64];
    open_display(CONTROLLER_SH1107);
    TEST_ASSERT_EQUAL(0, display.sink.columns_less_1);
    TEST_ASSERT_TRUE(display.sink.start_box(&display, &odd, bytes, 4));
    TEST_ASSERT_TRUE(display.sink.wait(&display));
    TEST_ASSERT_FALSE(display.sink.start_box(&display, &odd, bytes, 5));
    TEST_ASSERT_FALSE(display.sink.start_box(&display, &page, bytes, 4));
    TEST_ASSERT_FALSE(display.sink.start_box(&display, &beyond, bytes, 4));
    display.driver = &fxl_ssd1327;
    display.pixels.format = &fxl_pixels_grey4;
    TEST_ASSERT_FALSE(display.sink.start_box(&display, &odd, bytes, 16));
    TEST_ASSERT_FALSE(display.sink.start_box(&display, &ends, bytes, 16));
    TEST_ASSERT_TRUE(fxl_ls013b7dh03.family->takes_whole_rows);
}

/* --- what is refused ---------------------------------------------------------------------------- */

static void expect_boxes_refused(void)
{
    static const fxl_screen_box wrong[] = {{0, 0, 0, 8},      {0, 8, 0, 0},  {8, WIDTH, 0, 8},
                                           {0, 8, HEIGHT, 1}, {4, 12, 0, 8}, {8, 4, 0, 8}};
    const fxl_pump before = pump;
    for (uint32_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_begin_box(&pump, &wrong[i]));
    }
    TEST_ASSERT_EQUAL_MEMORY(&before, &pump, sizeof pump);
}

/* changed 3.2f-g, 4.2a, 4.3c */
void test_which_boxes_a_pump_takes(void)
{
    const fxl_screen_box right = {40, 8, 0, 8}, page = {0, 8, 4, 8}, half = {0, 8, 0, 4};
    const fxl_screen_box last = {0, 8, HEIGHT - 8, 4};
    fxl_band band = UNIT_BAND(frame, WIDTH, 0, 8);
    fxl_pump never = {0};
    TEST_ASSERT_EQUAL(FXL_OK, init(&fxl_pixels_mono_rows, true, 8));
    expect_boxes_refused();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_begin_box(&pump, &right));
    TEST_ASSERT_EQUAL(40, fxl_pump_band(&pump)->first_column);
    TEST_ASSERT_EQUAL(8, fxl_pump_band(&pump)->columns);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_begin_box(NULL, &right));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_begin_box(&pump, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_pump_begin_box(&never, &right));
    band.first_column = 8;
    band.columns = 16;
    band.pixels = frame + 8;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_send_rows(&pump, &band));
    TEST_ASSERT_TRUE(last_box.first_column == 8 && last_box.columns == 16);
    band.first_column = 4;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_send_rows(&pump, &band));
    TEST_ASSERT_EQUAL(FXL_OK, init(&fxl_pixels_mono_rows, false, 8));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_begin_box(&pump, &right));
    band.first_column = 8;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_send_rows(&pump, &band));
    TEST_ASSERT_EQUAL(FXL_OK, init(&fxl_pixels_mono_pages, true, 1));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_begin_box(&pump, &page));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_begin_box(&pump, &half));
    pump.config.height = HEIGHT - 4; /* not whole pages: the last one is a part */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_begin_box(&pump, &last));
}

/* changed 5.1a, 5.3a */
void test_what_finding_refuses(void)
{
    const fxl_screen_box box = {0, 8, 0, 8}, none = {0, 0, 0, 8}, beyond = {44, 8, 0, 8};
    const fxl_screen_box no_rows = {0, 8, 0, 0}, below = {0, 8, HEIGHT - 4, 8};
    const fxl_pose away = {{0, 0, Q16(90)}, 0, 0, 0}; /* it sees nothing, so all is in the list */
    fxl_changed never = {0}, small;
    fxl_pump no_pump = {0};
    TEST_ASSERT_EQUAL(FXL_OK, init(&fxl_pixels_rgb565, true, 1));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_changed_init(NULL, changed_kept, 8));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_changed_init(&never, NULL, 8));
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, fxl_changed_init(&never, (uint8_t *)changed_kept + 4, 8));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_changed_find(NULL, &changed_renderer));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_changed_find(&changed, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_changed_find(&changed, &changed_renderer));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_changed_add(&changed, &box));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_changed_add_model(&changed, &changed_renderer, 0));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_changed_widen(&changed, 1, 1));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&changed_renderer, &changed_eye));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_changed_find(&never, &changed_renderer));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_init(&small, changed_kept, 40));
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_changed_find(&small, &changed_renderer));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_init(&small, changed_kept, 48));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_find(&small, &changed_renderer));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_find(&changed, &changed_renderer));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_changed_add(NULL, &box));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_changed_add(&changed, NULL));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_changed_add(&changed, &none));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_changed_add(&changed, &beyond));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_changed_add(&changed, &no_rows));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_changed_add(&changed, &below));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_changed_add_model(NULL, &changed_renderer, 0));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_changed_add_model(&changed, NULL, 0));
    TEST_ASSERT_EQUAL(FXL_E_INDEX,
                      fxl_changed_add_model(&changed, &changed_renderer, CHANGED_MODELS));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_changed_widen(NULL, 1, 1));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_changed_widen(&changed, 3, 1));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_changed_widen(&changed, 16, 1));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_changed_widen(&changed, 1, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_changed_widen(&changed, 1, 6));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_changed_widen(&changed, 1, 16));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_widen(NULL, &changed));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_widen(&pump, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_pump_widen(&no_pump, &changed));
    no_pump = pump;
    no_pump.config.pixels = NULL; /* it sends them as they are drawn */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_widen(&no_pump, &changed));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&changed_renderer));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_changed_add_model(&changed, &changed_renderer, 0));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&changed_renderer, &away));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_changed_add_model(&changed, &changed_renderer, 0));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_find(&changed, &changed_renderer));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_release_scene(&changed_renderer));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_changed_find(&changed, &changed_renderer));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_changed_add_model(&changed, &changed_renderer, 0));
}

void test_what_a_pump_of_changes_refuses(void)
{
    const fxl_pose far_away = {{FXL_COORDINATE_MAX + 1, 0, 0}, 0, 0, 0};
    TEST_ASSERT_EQUAL(FXL_OK, init(&fxl_pixels_rgb565, true, 1));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_pump_changed(NULL, &changed_renderer, &changed_eye, &changed));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_changed(&pump, NULL, &changed_eye, &changed));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_changed(&pump, &changed_renderer, NULL, &changed));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_pump_changed(&pump, &changed_renderer, &changed_eye, NULL));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_changed(&pump, &changed_renderer, &far_away, &changed));
    pump.config.width = WIDTH - 8;
    TEST_ASSERT_EQUAL(FXL_E_RANGE,
                      fxl_pump_changed(&pump, &changed_renderer, &changed_eye, &changed));
    pump.config.width = WIDTH;
    pump.config.palette = changed_colours;
    TEST_ASSERT_EQUAL(FXL_E_COMBINATION,
                      fxl_pump_changed(&pump, &changed_renderer, &changed_eye, &changed));
    TEST_ASSERT_EQUAL(0, starts);
}
