/* SPDX-License-Identifier: MIT */
#include "dashboard.h"
#include "cube_scene.h"

#include <fixel/orientation.h>
#include <fixel/pixels.h>
#include <fixel/target.h>
#include <string.h>

#define CANARY 64 /* bytes before and after the buffer */

uint8_t screen[HEIGHT][2 * WIDTH];
uint16_t palette[256];
uint8_t grey_palette[256][3];

static struct {
    uint8_t before[CANARY];
    _Alignas(64) uint8_t pixels[2 * WIDTH * ROWS];
    uint8_t after[CANARY];
} buffer;
static lv_color_format_t format_of_screen;
static uint32_t now;

static uint32_t tick(void)
{
    return now;
}

static uint32_t pixel_bytes(void)
{
    return format_of_screen == LV_COLOR_FORMAT_L8 ? 1 : 2;
}

static void flush(lv_display_t *display, const lv_area_t *area, uint8_t *pixels)
{
    const uint32_t bytes = pixel_bytes(), width = (uint32_t)lv_area_get_width(area);
    const uint32_t stride = lv_draw_buf_width_to_stride(width, format_of_screen);
    for (int32_t y = area->y1; y <= area->y2; y++) {
        memcpy(&screen[y][(uint32_t)area->x1 * bytes], pixels, width * bytes);
        pixels += stride;
    }
    lv_display_flush_ready(display);
}

void begin_display(lv_color_format_t format)
{
    memset(&buffer, 0xA5, sizeof buffer);
    memset(screen, 0, sizeof screen);
    format_of_screen = format;
    lv_init();
    lv_tick_set_cb(tick);
    add_display();
}

lv_display_t *add_display(void)
{
    lv_display_t *display = lv_display_create(WIDTH, HEIGHT);
    lv_display_set_color_format(display, format_of_screen);
    lv_display_set_flush_cb(display, flush);
    lv_display_set_buffers(display, buffer.pixels, NULL, WIDTH * ROWS * pixel_bytes(),
                           LV_DISPLAY_RENDER_MODE_PARTIAL);
    return display;
}

void end_display(void)
{
    lv_deinit();
}

void refresh(void)
{
    now += 33;
    lv_timer_handler();
    lv_refr_now(NULL);
}

bool canaries_are_intact(void)
{
    for (uint32_t i = 0; i < CANARY; i++) {
        if (buffer.before[i] != 0xA5 || buffer.after[i] != 0xA5) {
            return false;
        }
    }
    return true;
}

fxl_status make_model(model_t *model, bool is_wide, uint16_t width, uint16_t height)
{
    fxl_config config = fxl_config_for(width, height, is_wide ? &fxl_rgb565 : &fxl_palette);
    memset(model, 0, sizeof *model);
    model->before = model->after = 0x5A5A5A5A5A5A5A5Au;
    model->scene = cube_scene;
    model->placement = (fxl_placement)FXL_PLACEMENT_NONE;
    model->scene.placements = &model->placement;
    model->scene.placement_code = &fxl_turned_instances;
    for (uint32_t i = 0; i < 256; i++) {
        const uint8_t *rgb = cube_palette[i];
        palette[i] = FXL_RGB565(rgb[0], rgb[1], rgb[2]);
        memset(grey_palette[i], (int)i, 3);
    }
    if (is_wide) {
        config.palette = palette;
    } else {
        /* The faces' colours as greys. */
        for (uint32_t i = 0; i < model->scene.face_count && i < COUNTED(model->faces); i++) {
            model->faces[i] = cube_faces[i];
            model->faces[i].material = fxl_luma(cube_palette[cube_faces[i].material]);
        }
        model->scene.faces = model->faces;
        config.background = 17;
    }
    return fxl_renderer_init(&model->renderer, &model->scene, &config, model->memory,
                             sizeof model->memory);
}

void turn_model(model_t *model, uint32_t k)
{
    const fxl_point axis = {1, 2, 0};
    fxl_orientation_from_axis(&axis, k * FXL_DEGREES(6), &model->placement.orientation);
}

static bool is_within(const box_t *box, int32_t x, int32_t y)
{
    return x >= box->x && x < box->end_x && y >= box->y && y < box->end_y;
}

/* A pixel of the picture as the display has it. */
static uint32_t expected_at(const void *pixels, size_t place)
{
    if (format_of_screen == LV_COLOR_FORMAT_L8) {
        return ((const uint8_t *)pixels)[place];
    }
    const uint32_t pixel = ((const uint16_t *)pixels)[place];
    return format_of_screen == LV_COLOR_FORMAT_RGB565_SWAPPED ? (pixel << 8 | pixel >> 8) & 0xFFFFu
                                                              : pixel;
}

static uint32_t shown_at(int32_t x, int32_t y)
{
    const uint8_t *at = &screen[y][(uint32_t)x * pixel_bytes()];
    return pixel_bytes() == 1 ? at[0] : at[0] | (uint32_t)at[1] << 8;
}

long pixels_that_differ(model_t *model, const fxl_pose *eye, int32_t x, int32_t y, box_t within,
                        const box_t *without, size_t count)
{
    static uint16_t pixels[WIDTH * HEIGHT];
    const fxl_lens *lens = &model->renderer.frame.view.lens;
    long differ = fxl_render(&model->renderer, eye, pixels, lens->width) == FXL_OK ? 0 : 1000000;
    for (int32_t row = within.y; row < within.end_y; row++) {
        for (int32_t column = within.x; column < within.end_x; column++) {
            bool is_left_out = false;
            for (size_t i = 0; i < count; i++) {
                is_left_out = is_left_out || is_within(&without[i], column, row);
            }
            const size_t place = (size_t)(row - y) * lens->width + (size_t)(column - x);
            differ += !is_left_out && shown_at(column, row) != expected_at(pixels, place);
        }
    }
    return differ;
}
