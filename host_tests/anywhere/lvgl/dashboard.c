/* SPDX-License-Identifier: MIT */
#include "dashboard.h"
#include "cube_scene.h"

#include <fixel/orientation.h>
#include <fixel/pixels.h>
#include <fixel/target.h>
#include <stdio.h>
#include <string.h>

#define CANARY 64 /* bytes before and after the buffer */

uint8_t screen[HEIGHT][2 * WIDTH];
uint16_t palette[256];
uint8_t grey_palette[256][3];
model_t model, twin;
lv_obj_t *view, *label, *button;
const fxl_pose eye = {.position = {0, FXL_UNITS(2), FXL_UNITS(-8)}, .pitch = FXL_DEGREES(-12)};
const box_t whole_view = {VIEW_X, VIEW_Y, VIEW_X + VIEW_W, VIEW_Y + VIEW_H};

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

bool holds(box_t box, int32_t x, int32_t y)
{
    return x >= box.x && x < box.end_x && y >= box.y && y < box.end_y;
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
                is_left_out = is_left_out || holds(without[i], column, row);
            }
            const size_t place = (size_t)(row - y) * lens->width + (size_t)(column - x);
            differ += !is_left_out && shown_at(column, row) != expected_at(pixels, place);
        }
    }
    return differ;
}

/* --- the dashboard ------------------------------------------------------------------------- */

box_t box_of(const lv_obj_t *obj)
{
    lv_area_t area;
    lv_obj_get_coords(obj, &area);
    return (box_t){area.x1, area.y1, area.x2 + 1, area.y2 + 1};
}

long size_of(box_t box)
{
    return (long)(box.end_x - box.x) * (box.end_y - box.y);
}

void make_dashboard(lv_color_format_t format)
{
    const bool is_wide = format != LV_COLOR_FORMAT_L8;
    begin_display(format);
    const fxl_status made = make_model(&model, is_wide, VIEW_W, VIEW_H),
                     twin_made = make_model(&twin, is_wide, VIEW_W, VIEW_H);
    view = lv_fixel_create(lv_screen_active());
    const fxl_status set =
        lv_fixel_set_renderer(view, &model.renderer, is_wide ? NULL : grey_palette[0]);
    printf("made: %d %d %d\n", made, twin_made, set);
    lv_fixel_set_pose(view, &eye);
    lv_obj_set_pos(view, VIEW_X, VIEW_Y);
    label = lv_label_create(view);
    lv_label_set_text(label, "speed 42");
    lv_obj_set_pos(label, LABEL_X, LABEL_Y);
    button = lv_button_create(lv_screen_active());
    lv_obj_set_pos(button, VIEW_X + VIEW_W - 20, VIEW_Y + VIEW_H - 15);
    lv_obj_set_size(button, 60, 40);
    lv_obj_set_style_shadow_width(button, 0, 0);
}

uint32_t stored(void)
{
    return lv_fixel_get_counters(view).pixels;
}

long view_differs(const fxl_pose *pose)
{
    const box_t without[] = {box_of(label), box_of(button)};
    return pixels_that_differ(&twin, pose, VIEW_X, VIEW_Y, whole_view, without, COUNTED(without));
}
