/* SPDX-License-Identifier: MIT */
/* The pictures of lv_fixel, compared with the library's own frames. test_lvgl.py judges the lines. */
#include "dashboard.h"

#include <fixel/light.h>
#include <stdio.h>
#include <string.h>

/* Turns the model, refreshes the display, and compares the view. */
static long turn_and_compare(uint32_t step)
{
    turn_model(&model, step);
    turn_model(&twin, step);
    lv_obj_invalidate(view);
    refresh();
    return view_differs(&eye);
}

static uint32_t invalid;

/* Adds up the areas that LVGL is to draw anew, each of them once. */
static void on_invalid(lv_event_t *event)
{
    static lv_area_t last;
    const lv_area_t *area = lv_event_get_param(event);
    if (memcmp(&last, area, sizeof last) != 0) {
        last = *area;
        invalid += lv_area_get_size(area);
    }
}

/* Changes the text of the label alone, and says what was stored and what has changed. */
static void change_label(const char *name, const char *text)
{
    static uint8_t before[sizeof screen];
    memcpy(before, screen, sizeof screen);
    const uint32_t stored_before = stored(), tasks = lv_fixel_get_counters(view).tasks;
    invalid = 0;
    lv_display_add_event_cb(lv_display_get_default(), on_invalid, LV_EVENT_INVALIDATE_AREA, NULL);
    lv_label_set_text(label, text);
    refresh();
    lv_display_remove_event_cb_with_user_data(lv_display_get_default(), on_invalid, NULL);
    const box_t box = box_of(label);
    long changed_outside = 0, changed = 0;
    for (int32_t y = 0; y < HEIGHT; y++) {
        for (int32_t x = 0; x < WIDTH; x++) {
            const bool has_changed =
                memcmp(&screen[y][2 * x], &before[y * 2 * WIDTH + 2 * x], 2) != 0;
            changed += has_changed;
            changed_outside += has_changed && !holds(box, x, y);
        }
    }
    const long differ = view_differs(&eye);
    printf("%s: %u pixels stored by %u task, invalid %u, rectangle %ld, %ld changed, %ld outside, "
           "%ld differ, canaries %s\n",
           name, stored() - stored_before, lv_fixel_get_counters(view).tasks - tasks, invalid,
           size_of(box), changed, changed_outside, differ,
           canaries_are_intact() && model.before == twin.before && model.after == twin.after
               ? "intact"
               : "broken");
}

/* (a) 60 frames, (c) the pixels of one, and (b) the label alone. */
void test_dashboard(void)
{
    long differ = 0;
    uint32_t most = 0, least = UINT32_MAX, distinct = 0, last_crc = 0;
    make_dashboard(LV_COLOR_FORMAT_RGB565);
    for (uint32_t k = 0; k < 60; k++) {
        const uint32_t before = stored();
        differ += turn_and_compare(k);
        const uint32_t pixels = stored() - before;
        most = pixels > most ? pixels : most;
        least = pixels < least ? pixels : least;
        uint32_t crc = 0;
        for (uint32_t i = 0; i < sizeof screen; i++) {
            crc = crc * 31 + ((const uint8_t *)screen)[i];
        }
        distinct += crc != last_crc;
        last_crc = crc;
    }
    const lv_fixel_counters_t counters = lv_fixel_get_counters(view);
    printf(
        "a: %u frames, %u begun, %u tasks, %u different pictures, %ld pixels differ, %u refused\n",
        60u, counters.frames, counters.tasks, distinct, differ, counters.refused);
    printf("c: %u to %u pixels stored of %u\n", least, most, VIEW_W * VIEW_H);

    change_label("b", "speed 43");
    /* In a panel of its own size the label has no margin: LVGL draws its letters as far as a
     * quarter of a line beyond it. */
    const box_t box = box_of(label);
    lv_obj_t *panel = lv_obj_create(view);
    lv_obj_remove_style_all(panel);
    lv_obj_set_pos(panel, LABEL_X, LABEL_Y);
    lv_obj_set_size(panel, box.end_x - box.x, box.end_y - box.y);
    lv_obj_set_parent(label, panel);
    lv_obj_set_pos(label, 0, 0);
    refresh();
    change_label("b in a panel", "speed 45");
    end_display();
}

/* A container that cuts the widget on all four sides, and a widget that is larger and smaller than
 * its picture. */
void test_clip(void)
{
    static const lv_point_t places[] = { /* of the widget in the container */
        {-50, -40}, {60, 50}, {-90, 30}, {20, -100}, {-199, -149}};
    make_dashboard(LV_COLOR_FORMAT_RGB565);
    lv_obj_add_flag(button, LV_OBJ_FLAG_HIDDEN);
    lv_obj_add_flag(label, LV_OBJ_FLAG_HIDDEN);
    lv_obj_t *container = lv_obj_create(lv_screen_active());
    lv_obj_remove_style_all(container);
    lv_obj_remove_flag(container, LV_OBJ_FLAG_SCROLLABLE);
    lv_obj_set_pos(container, 31, 17);
    lv_obj_set_size(container, 101, 83);
    lv_obj_set_parent(view, container);
    for (size_t i = 0; i < COUNTED(places); i++) {
        const uint32_t before = stored();
        lv_obj_set_pos(view, places[i].x, places[i].y);
        lv_obj_invalidate(lv_screen_active());
        refresh();
        const box_t own = box_of(view), outer = box_of(container);
        const box_t shown = {LV_MAX(own.x, outer.x), LV_MAX(own.y, outer.y),
                             LV_MIN(own.end_x, outer.end_x), LV_MIN(own.end_y, outer.end_y)};
        printf("clip: %ld pixels differ, %u stored of %ld\n",
               pixels_that_differ(&twin, &eye, own.x, own.y, shown, NULL, 0), stored() - before,
               size_of(shown));
    }
    const uint32_t before = stored();
    lv_obj_set_pos(view, 3, 5);
    lv_obj_set_size(view, 40, 30);
    lv_obj_invalidate(lv_screen_active());
    refresh();
    printf("clip: %ld pixels differ, %u stored of %d\n",
           pixels_that_differ(&twin, &eye, 34, 22, (box_t){34, 22, 74, 52}, NULL, 0),
           stored() - before, 40 * 30);
    printf("canaries %s\n", canaries_are_intact() ? "intact" : "broken");
    end_display();
}

static void draw_format(const char *name, lv_color_format_t format, bool is_lit)
{
    static fxl_light light, twin_light;
    static uint8_t ramp[FXL_LIGHT_RAMP_BYTES(2)];
    const fxl_light_settings settings = {.ambient = FXL_Q2_30_ONE / 4,
                                         .strength = FXL_Q2_30_ONE / 2,
                                         .direction = {0, -FXL_Q2_30_ONE, 0},
                                         .ramp = ramp,
                                         .levels = 2};
    make_dashboard(format);
    if (is_lit) {
        printf("lit: %d %d\n", fxl_attach_light(&model.renderer, &light, &settings),
               fxl_attach_light(&twin.renderer, &twin_light, &settings));
    }
    long differ = 0;
    const uint32_t before = stored();
    for (uint32_t k = 0; k < 5; k++) {
        differ += turn_and_compare(k);
    }
    printf("%s: %ld pixels differ, %u stored, %u refused\n", name, differ, stored() - before,
           lv_fixel_get_counters(view).refused);
    end_display();
}

void test_formats(void)
{
    draw_format("RGB565", LV_COLOR_FORMAT_RGB565, false);
    draw_format("RGB565 lit", LV_COLOR_FORMAT_RGB565, true);
    draw_format("RGB565_SWAPPED", LV_COLOR_FORMAT_RGB565_SWAPPED, false);
    draw_format("RGB565_SWAPPED lit", LV_COLOR_FORMAT_RGB565_SWAPPED, true);
    draw_format("L8", LV_COLOR_FORMAT_L8, false);
    /* A renderer whose pixels are not the layer's, and a palette that is no ramp. */
    begin_display(LV_COLOR_FORMAT_L8);
    make_model(&model, true, VIEW_W, VIEW_H);
    view = lv_fixel_create(lv_screen_active());
    lv_fixel_set_renderer(view, &model.renderer, NULL);
    lv_fixel_set_pose(view, &eye);
    refresh();
    printf("RGB565 in L8: %u stored, refused %s, %s\n", stored(),
           lv_fixel_get_counters(view).refused > 0 ? "yes" : "no", lv_fixel_get_refusal(view));
    make_model(&twin, false, VIEW_W, VIEW_H);
    grey_palette[200][1] = 3;
    printf("no ramp: %d, no palette: %d",
           lv_fixel_set_renderer(view, &twin.renderer, grey_palette[0]),
           lv_fixel_set_renderer(view, &twin.renderer, NULL));
    memset(&twin.renderer, 0, sizeof twin.renderer);
    printf(", no renderer: %d\n", lv_fixel_set_renderer(view, &twin.renderer, NULL));
    end_display();
}

/* How many pixels within the view, but for label and button, are of one colour. */
static long pixels_of(uint32_t colour)
{
    const box_t without[] = {box_of(label), box_of(button)};
    long count = 0;
    for (int32_t y = VIEW_Y; y < VIEW_Y + VIEW_H; y++) {
        for (int32_t x = VIEW_X; x < VIEW_X + VIEW_W; x++) {
            count += !holds(without[0], x, y) && !holds(without[1], x, y) &&
                     (screen[y][2 * x] | (uint32_t)screen[y][2 * x + 1] << 8) == colour;
        }
    }
    return count;
}

/* Refreshes the display, and says what was stored since a count, and whether the widget was
 * refused. */
static void draw_refused(const char *name, uint32_t stored_before)
{
    const uint32_t refused = lv_fixel_get_counters(view).refused;
    refresh();
    printf("d: %s: %u stored, refused %s: %s\n", name, stored() - stored_before,
           lv_fixel_get_counters(view).refused > refused ? "yes" : "no",
           lv_fixel_get_refusal(view));
}

/* (d) An opacity, a rotation and a layer with alpha are refused; what LVGL blends as a whole is
 * drawn. */
void test_opacity(void)
{
    make_dashboard(LV_COLOR_FORMAT_RGB565);
    lv_obj_set_style_bg_color(lv_screen_active(), lv_color_black(), 0);
    refresh();
    const uint32_t drawn = stored();
    lv_obj_set_style_opa(view, LV_OPA_50, 0);
    refresh();
    /* The background's colour, half of it over black: each channel rounded down or up. */
    const uint32_t found = screen[VIEW_Y + 70][2 * (VIEW_X + 70)] |
                           (uint32_t)screen[VIEW_Y + 70][2 * (VIEW_X + 70) + 1] << 8;
    const long one_colour = pixels_of(found),
               all = VIEW_W * VIEW_H - size_of(box_of(label)) - 20 * 15;
    printf("d: opacity of 50 %%: %u stored, %u refused, %ld of %ld pixels are a plain rectangle of "
           "%04x over %04x: %s\n",
           stored() - drawn, lv_fixel_get_counters(view).refused, one_colour, all, found,
           palette[0], lv_fixel_get_refusal(view));
    lv_obj_set_style_opa(view, LV_OPA_COVER, 0);
    lv_obj_set_style_transform_rotation(view, 100, 0);
    draw_refused("rotation", drawn);
    lv_obj_set_style_transform_rotation(view, 0, 0);
    lv_obj_set_style_recolor(view, lv_color_white(), 0);
    lv_obj_set_style_recolor_opa(view, LV_OPA_30, 0);
    draw_refused("recoloured", drawn);
    lv_obj_set_style_recolor_opa(view, LV_OPA_TRANSP, 0);
    lv_obj_set_style_radius(view, 20, 0);
    lv_obj_set_style_clip_corner(view, true, 0);
    lv_obj_set_style_opa_layered(view, LV_OPA_50, 0);
    draw_refused("a layer with alpha", drawn);
    lv_obj_set_style_clip_corner(view, false, 0);
    const uint32_t refused = lv_fixel_get_counters(view).refused;
    refresh();
    /* Half of each channel of the library's frame, over black. */
    static uint16_t pixels[VIEW_W * VIEW_H];
    long differ = fxl_render(&twin.renderer, &eye, pixels, VIEW_W) == FXL_OK ? 0 : 1000000;
    const box_t box = box_of(label);
    for (int32_t y = 0; y < VIEW_H - 15; y++) {
        for (int32_t x = 0; x < VIEW_W - 20; x++) {
            if (holds(box, x + VIEW_X, y + VIEW_Y)) {
                continue;
            }
            const uint8_t *at = &screen[VIEW_Y + y][2 * (VIEW_X + x)];
            const int32_t shown = at[0] | at[1] << 8, own = pixels[y * VIEW_W + x];
            const int32_t off[] = {(shown >> 11) * 2 - (own >> 11),
                                   (shown >> 5 & 63) * 2 - (own >> 5 & 63),
                                   (shown & 31) * 2 - (own & 31)};
            differ += LV_ABS(off[0]) > 2 || LV_ABS(off[1]) > 2 || LV_ABS(off[2]) > 2;
        }
    }
    printf("d: a whole layer at 50 %%: %u stored, %u refused, %ld pixels are not half of the "
           "frame's colour\n",
           stored() - drawn, lv_fixel_get_counters(view).refused - refused, differ);
    printf("canaries %s\n", canaries_are_intact() ? "intact" : "broken");
    end_display();
}

/* A snapshot is drawn outside of a refresh: its frame begins and ends with it. */
void test_snapshot(void)
{
    static uint16_t pixels[VIEW_W * VIEW_H];
    make_dashboard(LV_COLOR_FORMAT_RGB565);
    refresh();
    const uint32_t frames = lv_fixel_get_counters(view).frames;
    lv_draw_buf_t *shot = lv_snapshot_take(view, LV_COLOR_FORMAT_RGB565);
    long differ =
        fxl_render(&twin.renderer, &eye, pixels, VIEW_W) == FXL_OK && shot != NULL ? 0 : 1000000;
    const box_t box = box_of(label);
    for (uint32_t y = 0; shot != NULL && y < VIEW_H; y++) {
        for (uint32_t x = 0; x < VIEW_W; x++) {
            differ += !holds(box, VIEW_X + (int32_t)x, VIEW_Y + (int32_t)y) &&
                      *(const uint16_t *)lv_draw_buf_goto_xy(shot, x, y) != pixels[y * VIEW_W + x];
        }
    }
    printf("snapshot: %ld pixels differ, %u begun, %s afterwards\n", differ,
           lv_fixel_get_counters(view).frames - frames,
           model.renderer.frame.state == FXL_FRAME_NONE ? "none" : "one");
    if (shot != NULL) {
        lv_draw_buf_destroy(shot);
    }
    end_display();
}
