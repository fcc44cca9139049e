/* SPDX-License-Identifier: MIT */
/* The pump: whole frames by bands that are sent while the next one is drawn. */
#include "pixel_formats.h"
#include "tiny.h"
#include "transfer.h"

enum {
    WIDTH = 24,
    HEIGHT = 27,
    BACKGROUND = 200,
    NEVER = 1000
};

static uint64_t block[160], memory[(8 * WIDTH * 16 + 7) / 8];
static uint8_t palette[768], whole[HEIGHT * WIDTH];
static uint16_t palette_565[256], whole_565[HEIGHT * WIDTH];
static const uint16_t *colours; /* of the pump's bands: null, or palette_565 */
static uint32_t expected[(3 * WIDTH * HEIGHT + 7) / 4], received[(3 * WIDTH * HEIGHT + 7) / 4];
static fxl_renderer renderer;
static fxl_pixels pixels;
static fxl_pump pump;
static transfer wires;
static uint32_t taken;    /* bytes of the frame that have arrived */
static uint32_t next_row; /* that must come next */
static uint32_t refused;  /* the call of start that fails */
static bool is_wait_broken;

static void take(void *user, const uint8_t *bytes, size_t size)
{
    (void)user;
    TEST_ASSERT_LESS_OR_EQUAL(sizeof received, taken + size);
    memcpy((uint8_t *)received + taken, bytes, size);
    taken += (uint32_t)size;
}

static bool start(void *user, uint16_t first_row, uint16_t rows, const uint8_t *bytes, size_t size)
{
    TEST_ASSERT_EQUAL_PTR(&wires, user);
    TEST_ASSERT_EQUAL(next_row, first_row);
    next_row += rows;
    if (wires.count == refused) {
        return false;
    }
    transfer_start(&wires, bytes, size);
    return true;
}

static bool wait(void *user)
{
    TEST_ASSERT_EQUAL_PTR(&wires, user);
    transfer_wait(&wires);
    return !is_wait_broken;
}

static const fxl_pump_sink sink = {.user = &wires, .start = start, .wait = wait};

static fxl_pose pose_number(int number)
{
    fxl_pose pose = {{Q16(0.5), Q16(0.25), Q16(-6)}, 0, 0, 0};
    pose.roll = (uint32_t)number * DEGREES(11);
    return pose;
}

static void draw_into(const fxl_target *target)
{
    tiny_scene *made = tiny_make();
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, target);
    config.background = BACKGROUND;
    config.palette = colours = target->pixel_bits == 16 ? palette_565 : NULL;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&made->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_init(&renderer, &made->scene, &config, block, sizeof block));
}

void setUp(void)
{
    for (uint32_t i = 0; i < sizeof palette; i++) {
        palette[i] = (uint8_t)(i * 37u);
    }
    for (uint32_t i = 0; i < 256; i++) {
        palette_565[i] = (uint16_t)(i * 40503u + 7u);
    }
    draw_into(&fxl_palette);
    wires = (transfer){take, NULL, NULL, 0, 0, 0};
    refused = NEVER;
    is_wait_broken = false;
}

void tearDown(void)
{
    transfer_wait(&wires); /* a failed test leaves no byte poisoned */
}

static fxl_status init(const fxl_pixel_format *format, uint16_t rows)
{
    fxl_pump_config config = {NULL, WIDTH, HEIGHT, rows, colours};
    memset(&pump, 0x5A, sizeof pump);
    if (format != NULL) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_init(&pixels, format, palette));
        config.pixels = &pixels;
    }
    const fxl_status status =
        fxl_pump_init(&pump, &config, &sink, memory, fxl_pump_memory_size(&config));
    TEST_ASSERT_TRUE(status != FXL_OK || (pump.band.first_row == 0 && pump.band.rows == 0));
    return status;
}

/* What must arrive of a frame. */
static uint32_t expect_frame(int number)
{
    const fxl_pose pose = pose_number(number);
    uint8_t *frame = colours != NULL ? (uint8_t *)whole_565 : whole;
    const fxl_band band = {.pixels = frame, .width = WIDTH, .stride = WIDTH, .first_row = 0,
                           .rows = HEIGHT, .palette = colours};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, frame, WIDTH));
    if (pump.config.pixels == NULL) {
        const uint32_t size = colours != NULL ? sizeof whole_565 : sizeof whole;
        memcpy(expected, frame, size);
        return size;
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_convert(&pixels, &band, expected, sizeof expected));
    return (uint32_t)fxl_pixels_size(pixels.format, WIDTH, HEIGHT);
}

static void draw_frame(int number)
{
    const fxl_pose pose = pose_number(number);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_frame(&pump, &renderer, &pose));
}

static void assert_frames(void)
{
    for (int number = 0; number < 3; number++) {
        const uint32_t size = expect_frame(number);
        taken = next_row = 0;
        draw_frame(number);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_wait(&pump));
        TEST_ASSERT_EQUAL(size, taken);
        TEST_ASSERT_EQUAL_MEMORY(expected, received, size);
    }
}

static const fxl_pixel_format *const formats[] = EVERY_FORMAT;
enum {
    FORMATS = sizeof formats / sizeof formats[0]
};

static void assert_every_format_and_height(void)
{
    for (uint32_t i = 0; i <= FORMATS; i++) {
        const fxl_pixel_format *format = i < FORMATS ? formats[i] : NULL; /* and without one */
        const uint16_t least = format != NULL ? format->rows : 1;
        for (uint16_t rows = least; rows <= 16; rows = (uint16_t)(rows + (least > 1 ? least : 5))) {
            TEST_ASSERT_EQUAL(FXL_OK, init(format, rows));
            assert_frames();
        }
    }
}

/* pixels 2.1b, 2.2a */
void test_frames_arrive_whole_in_every_format_and_height(void)
{
    assert_every_format_and_height();
}

void test_frames_of_rgb565_arrive_whole_in_every_format_and_height(void)
{
    draw_into(&fxl_rgb565);
    assert_every_format_and_height();
}

/* To a display with red first from a little-endian core: the colours of the palette, swapped. */
void test_a_frame_of_rgb565_has_the_colours_of_its_palette(void)
{
    const fxl_pose pose = pose_number(1);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, whole, WIDTH));
    draw_into(&fxl_rgb565);
    TEST_ASSERT_EQUAL(FXL_OK, init(&fxl_pixels_rgb565, 5));
    taken = next_row = 0;
    draw_frame(1);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_wait(&pump));
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const uint8_t *bytes = (const uint8_t *)received + 2u * i;
        TEST_ASSERT_EQUAL_HEX16(palette_565[whole[i]], bytes[0] << 8 | bytes[1]);
    }
}

void test_a_pump_and_a_renderer_of_other_pixels(void)
{
    const fxl_pose pose = pose_number(0);
    fxl_band rows = {.pixels = (uint8_t *)whole_565, .width = WIDTH, .stride = WIDTH,
                     .first_row = 0, .rows = 2, .palette = palette_565};
    for (uint32_t i = 0; i < 2; i++) {
        const fxl_target *const target = i == 0 ? &fxl_rgb565 : &fxl_palette;
        draw_into(target);
        colours = i == 0 ? NULL : palette_565;
        TEST_ASSERT_EQUAL(FXL_OK, init(NULL, 2));
        TEST_ASSERT_EQUAL(FXL_E_COMBINATION, fxl_pump_frame(&pump, &renderer, &pose));
        TEST_ASSERT_EQUAL(FXL_E_COMBINATION, fxl_pump_send_rows(&pump, &rows));
        rows.palette = NULL;
    }
    TEST_ASSERT_EQUAL(FXL_OK, init(&fxl_pixels_rgb332, 2));
    rows.palette = palette_565;
    rows.pixels++;
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, fxl_pump_send_rows(&pump, &rows));
    TEST_ASSERT_EQUAL(0, wires.count);
}

void test_rows_of_rgb565_from_elsewhere(void)
{
    fxl_band rows = {.pixels = (uint8_t *)whole_565, .width = WIDTH, .stride = WIDTH,
                     .first_row = 0, .rows = 9, .palette = palette_565};
    draw_into(&fxl_rgb565);
    for (uint32_t with_format = 0; with_format < 2; with_format++) {
        const uint16_t *const own = colours;
        TEST_ASSERT_EQUAL(FXL_OK, init(NULL, 9));
        const uint32_t plain_size = expect_frame(2);
        colours = with_format != 0 ? NULL : own; /* a format takes rows of either kind */
        TEST_ASSERT_EQUAL(FXL_OK, init(with_format != 0 ? &fxl_pixels_rgb565_low : NULL, 9));
        colours = own;
        const uint32_t size = with_format != 0 ? expect_frame(2) : plain_size;
        taken = next_row = 0;
        for (uint32_t row = 0; row < HEIGHT; row += 9) {
            rows.pixels = (uint8_t *)&whole_565[row * WIDTH];
            rows.first_row = (uint16_t)row;
            TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_send_rows(&pump, &rows));
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_wait(&pump));
        TEST_ASSERT_EQUAL(size, taken);
        TEST_ASSERT_EQUAL_MEMORY(expected, received, size);
    }
}

/* The band that is drawn while another is sent; the frame after it, too. */
/* pixels 2.1a-b */
void test_a_band_is_drawn_while_another_is_sent(void)
{
    const fxl_band *band;
    const fxl_pose pose = pose_number(1);
    TEST_ASSERT_EQUAL(FXL_OK, init(&fxl_pixels_rgb565, 8));
    for (int frame = 0; frame < 2; frame++) {
        taken = next_row = 0;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_begin(&pump));
        for (uint32_t sent = 0; (band = fxl_pump_band(&pump)) != NULL; sent++) {
            TEST_ASSERT_EQUAL(sent > 0 || frame > 0, wires.bytes != NULL);
            memset(band->pixels, 0x11, (size_t)band->rows * band->stride);
            TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, band));
            if (sent == 0) {
                taken = 0; /* what is left of the frame before arrives with the first wait */
                transfer_wait(&wires);
                taken = 0;
            }
            TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_send(&pump));
        }
        TEST_ASSERT_NOT_NULL(wires.bytes);
        TEST_ASSERT_EQUAL(2 * WIDTH * 24, taken); /* all but the last three rows */
        TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_pump_send(&pump));
    }
    TEST_ASSERT_EQUAL(8, wires.count);
}

/* pixels 2.4 */
void test_rows_from_elsewhere(void)
{
    fxl_band rows = {.pixels = whole, .width = WIDTH, .stride = WIDTH, .first_row = 0, .rows = 8};
    for (uint32_t with_format = 0; with_format < 2; with_format++) {
        TEST_ASSERT_EQUAL(FXL_OK, init(with_format != 0 ? &fxl_pixels_rgb332 : NULL, 8));
        const uint32_t size = expect_frame(2);
        taken = next_row = 0;
        for (rows.first_row = 0; rows.first_row < HEIGHT;
             rows.first_row = (uint16_t)(rows.first_row + rows.rows)) {
            uint8_t lent[8 * (WIDTH + 3)];
            rows.rows = (uint16_t)(HEIGHT - rows.first_row < 8 ? HEIGHT - rows.first_row : 8);
            rows.pixels = lent;
            rows.stride = WIDTH + 3;
            for (uint32_t y = 0; y < rows.rows; y++) {
                memcpy(lent + y * (WIDTH + 3), whole + (rows.first_row + y) * WIDTH, WIDTH);
            }
            TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_send_rows(&pump, &rows));
            memset(lent, 0xEE, sizeof lent);
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_wait(&pump));
        TEST_ASSERT_EQUAL(size, taken);
        TEST_ASSERT_EQUAL_MEMORY(expected, received, size);
    }
}

/* Rows from elsewhere take the buffer in which a band without a format lies. */
/* pixels 2.4 */
void test_rows_from_elsewhere_between_bands(void)
{
    const fxl_band rows = UNIT_BAND(whole, WIDTH, 0, 1);
    TEST_ASSERT_EQUAL(FXL_OK, init(NULL, 2));
    (void)expect_frame(0);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_begin(&pump));
    const uint8_t *before = fxl_pump_band(&pump)->pixels;
    next_row = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_send_rows(&pump, &rows));
    TEST_ASSERT_TRUE(before != fxl_pump_band(&pump)->pixels);
    TEST_ASSERT_EQUAL(0, fxl_pump_band(&pump)->first_row);
    memset(fxl_pump_band(&pump)->pixels, 3, 2 * WIDTH); /* not poisoned */
    taken = 0;
    transfer_wait(&wires);
    TEST_ASSERT_EQUAL(WIDTH, taken);
}

/* pixels 2.3b-c */
void test_a_transfer_that_fails_ends_the_frame(void)
{
    const fxl_pose pose = pose_number(0);
    TEST_ASSERT_EQUAL(FXL_OK, init(&fxl_pixels_rgb565, 8));
    taken = next_row = 0;
    refused = 2;
    TEST_ASSERT_EQUAL(FXL_E_DISPLAY, fxl_pump_frame(&pump, &renderer, &pose));
    TEST_ASSERT_EQUAL(2, wires.count);
    TEST_ASSERT_NULL(fxl_pump_band(&pump));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_pump_send(&pump));
    refused = NEVER;
    taken = next_row = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_frame(&pump, &renderer, &pose));
    is_wait_broken = true;
    TEST_ASSERT_EQUAL(FXL_E_DISPLAY, fxl_pump_wait(&pump));
    TEST_ASSERT_EQUAL(FXL_E_DISPLAY, fxl_pump_frame(&pump, &renderer, &pose));
}

void test_what_a_pump_is_not_set_up_with(void)
{
    fxl_pump_config config = {NULL, WIDTH, HEIGHT, 4, NULL};
    const fxl_pump_sink no_start = {.user = &wires, .wait = wait},
                        no_wait = {.user = &wires, .start = start};
    const size_t size = fxl_pump_memory_size(&config);
    fxl_pump untouched;
    TEST_ASSERT_EQUAL(2 * WIDTH * 4, size);
    memset(&pump, 0x5A, sizeof pump);
    untouched = pump;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_init(NULL, &config, &sink, memory, size));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_init(&pump, NULL, &sink, memory, size));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_init(&pump, &config, NULL, memory, size));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_init(&pump, &config, &sink, NULL, size));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_init(&pump, &config, &no_start, memory, size));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_init(&pump, &config, &no_wait, memory, size));
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT,
                      fxl_pump_init(&pump, &config, &sink, (uint8_t *)memory + 4, size));
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_pump_init(&pump, &config, &sink, memory, size - 1));
    static const uint16_t wrong[][3] = {{0, HEIGHT, 4},     {1025, HEIGHT, 4},
                                        {WIDTH, 0, 4},      {WIDTH, 1025, 4},
                                        {WIDTH, HEIGHT, 0}, {WIDTH, HEIGHT, HEIGHT + 1}};
    for (uint32_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        config = (fxl_pump_config){NULL, wrong[i][0], wrong[i][1], wrong[i][2], NULL};
        TEST_ASSERT_EQUAL(0, fxl_pump_memory_size(&config));
        TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_init(&pump, &config, &sink, memory, sizeof memory));
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_init(&pixels, &fxl_pixels_mono_pages, palette));
    config = (fxl_pump_config){&pixels, WIDTH, HEIGHT, 4, NULL}; /* half a page */
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_init(&pump, &config, &sink, memory, sizeof memory));
    static const fxl_pixels unprepared;
    config = (fxl_pump_config){&unprepared, WIDTH, HEIGHT, 4, NULL};
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_init(&pump, &config, &sink, memory, sizeof memory));
    TEST_ASSERT_EQUAL(0, fxl_pump_memory_size(&config));
    TEST_ASSERT_EQUAL(0, fxl_pump_memory_size(NULL));
    TEST_ASSERT_EQUAL_MEMORY(&untouched, &pump, sizeof pump);
}

void test_what_a_pump_is_not_called_with(void)
{
    fxl_pose pose = pose_number(0);
    fxl_band rows = {.pixels = whole, .width = WIDTH, .stride = WIDTH, .first_row = 0, .rows = 8};
    TEST_ASSERT_EQUAL(FXL_OK, init(&fxl_pixels_rgb565, 8));
    TEST_ASSERT_NULL(fxl_pump_band(&pump)); /* no frame has begun */
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_pump_send(&pump));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_frame(NULL, &renderer, &pose));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_frame(&pump, NULL, &pose));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_frame(&pump, &renderer, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_begin(NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_send(NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_wait(NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_send_rows(NULL, &rows));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_send_rows(&pump, NULL));
    TEST_ASSERT_NULL(fxl_pump_band(NULL));
    pose.position.x = INT32_MAX;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_frame(&pump, &renderer, &pose));
    pump.config.width = WIDTH - 1; /* the renderer has another screen */
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_frame(&pump, &renderer, &pose));
    pump.config.width = WIDTH;
    rows.rows = 9;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_send_rows(&pump, &rows));
    rows.rows = 8;
    rows.first_row = HEIGHT - 7;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_send_rows(&pump, &rows));
    rows.first_row = 0;
    rows.width = WIDTH - 1;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_send_rows(&pump, &rows));
    rows.width = WIDTH;
    rows.columns = WIDTH - 1; /* the sink takes whole rows */
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_send_rows(&pump, &rows));
    rows.columns = 0;
    rows.stride = WIDTH - 1;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_send_rows(&pump, &rows));
    rows.rows = 0;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_send_rows(&pump, &rows));
    rows.pixels = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pump_send_rows(&pump, &rows));
    TEST_ASSERT_EQUAL(0, wires.count);
}

/* What was prepared is gone: the band stays the next one. */
void test_pixels_that_changed_after_the_pump_was_set_up(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, init(&fxl_pixels_rgb565, 8));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_begin(&pump));
    const fxl_band *const band = fxl_pump_band(&pump);
    memset(&pixels, 0, sizeof pixels);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_pump_send(&pump));
    TEST_ASSERT_EQUAL_PTR(band, fxl_pump_band(&pump));
    TEST_ASSERT_EQUAL(0, band->first_row);
    TEST_ASSERT_EQUAL(0, wires.count);
}

void test_a_renderer_without_a_target(void)
{
    const fxl_pose pose = pose_number(0);
    TEST_ASSERT_EQUAL(FXL_OK, init(&fxl_pixels_rgb565, 8));
    renderer.target = NULL; /* as fxl_renderer_init_bare leaves it */
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_pump_frame(&pump, &renderer, &pose));
    TEST_ASSERT_EQUAL(0, wires.count);
}

void test_a_pump_that_was_never_set_up(void)
{
    const fxl_pose pose = pose_number(0);
    const fxl_band rows = UNIT_BAND(whole, WIDTH, 0, 8);
    TEST_ASSERT_EQUAL(FXL_OK, init(&fxl_pixels_rgb565, 8)); /* the renderer */
    memset(&pump, 0, sizeof pump);
    const fxl_pump before = pump;
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_pump_wait(&pump));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_pump_begin(&pump));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_pump_send(&pump));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_send_rows(&pump, &rows));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pump_frame(&pump, &renderer, &pose));
    TEST_ASSERT_NULL(fxl_pump_band(&pump));
    TEST_ASSERT_EQUAL_MEMORY(&before, &pump, sizeof pump);
}

/* The macro for static memory is what the function says. */
/* pixels 2.2 */
void test_the_memory_of_a_pump(void)
{
    for (uint32_t i = 0; i < FORMATS; i++) {
        const uint32_t bits = formats[i]->bits;
        const fxl_pump_config config = {&pixels, 40, HEIGHT, 8, NULL};
        const fxl_pump_config wide = {&pixels, 40, HEIGHT, 8, palette_565};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_init(&pixels, formats[i], palette));
        TEST_ASSERT_EQUAL(8u * FXL_PUMP_MEMORY(40u, 8u, bits), fxl_pump_memory_size(&config));
        TEST_ASSERT_EQUAL(8u * FXL_PUMP_MEMORY_RGB565(40u, 8u, bits), fxl_pump_memory_size(&wide));
    }
    const fxl_pump_config bare_565 = {NULL, 37, HEIGHT, 3, palette_565};
    TEST_ASSERT_EQUAL(8u * FXL_PUMP_MEMORY_RGB565(37, 3, 0), fxl_pump_memory_size(&bare_565));
    const fxl_pump_config bare = {NULL, 37, HEIGHT, 3, NULL};
    TEST_ASSERT_EQUAL(8u * FXL_PUMP_MEMORY(37, 3, 0), fxl_pump_memory_size(&bare));
    const fxl_pump_config least = {NULL, 1, 1, 1, NULL}, most = {NULL, 1024, 1024, 1024, NULL};
    TEST_ASSERT_EQUAL(8u * FXL_PUMP_MEMORY(1, 1, 0), fxl_pump_memory_size(&least));
    TEST_ASSERT_EQUAL(8u * FXL_PUMP_MEMORY(1024, 1024, 0), fxl_pump_memory_size(&most));
}
