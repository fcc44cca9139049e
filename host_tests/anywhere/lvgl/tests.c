/* SPDX-License-Identifier: MIT */
/* What lv_fixel draws, compared with the library's own frames. test_lvgl.py judges the lines. */
#include "dashboard.h"
#include "cube_scene.h"

#include <fixel/light.h>
#include <stdio.h>
#include <string.h>

static model_t model, twin;
static lv_obj_t *view, *label, *button;
static const fxl_pose eye = {.position = {0, FXL_UNITS(2), FXL_UNITS(-8)},
                             .pitch = FXL_DEGREES(-12)};
static const box_t whole_view = {VIEW_X, VIEW_Y, VIEW_X + VIEW_W, VIEW_Y + VIEW_H};

static box_t box_of(const lv_obj_t *obj)
{
    lv_area_t area;
    lv_obj_get_coords(obj, &area);
    return (box_t){area.x1, area.y1, area.x2 + 1, area.y2 + 1};
}

static long size_of(box_t box)
{
    return (long)(box.end_x - box.x) * (box.end_y - box.y);
}

static bool holds(box_t box, int32_t x, int32_t y)
{
    return x >= box.x && x < box.end_x && y >= box.y && y < box.end_y;
}

/* The dashboard: a widget with a label over it, and a button beside it, which covers a corner of
 * it. */
static void make_dashboard(lv_color_format_t format)
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

static uint32_t stored(void)
{
    return lv_fixel_get_counters(view).pixels;
}

/* How many pixels of the view, but for label and button, are not the library's own of a pose. */
static long view_differs(const fxl_pose *pose)
{
    const box_t without[] = {box_of(label), box_of(button)};
    return pixels_that_differ(&twin, pose, VIEW_X, VIEW_Y, whole_view, without, COUNTED(without));
}

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

static lv_point_t finger;
static bool is_pressed;
static fxl_picked clicked;
static uint32_t clicks;

static void read_finger(lv_indev_t *indev, lv_indev_data_t *data)
{
    LV_UNUSED(indev);
    data->point = finger;
    data->state = is_pressed ? LV_INDEV_STATE_PRESSED : LV_INDEV_STATE_RELEASED;
}

static void on_click(lv_event_t *event)
{
    lv_point_t point;
    lv_indev_get_point(lv_indev_active(), &point);
    clicks += lv_fixel_pick(lv_event_get_target(event), &point, &clicked) == FXL_OK;
}

static void click(int32_t x, int32_t y)
{
    finger = (lv_point_t){x, y};
    is_pressed = true;
    refresh();
    is_pressed = false;
    refresh();
}

void test_pick_and_pose(void)
{
    fxl_picked picked = {0, 0, 0};
    make_dashboard(LV_COLOR_FORMAT_RGB565);
    lv_indev_t *indev = lv_indev_create();
    lv_indev_set_type(indev, LV_INDEV_TYPE_POINTER);
    lv_indev_set_read_cb(indev, read_finger);
    lv_obj_add_event_cb(view, on_click, LV_EVENT_CLICKED, NULL);
    const lv_point_t early = {VIEW_X, VIEW_Y};
    const fxl_status too_early = lv_fixel_pick(view, &early, &picked);
    refresh();
    long wrong = 0, on_model = 0;
    for (int32_t y = 0; y < VIEW_H; y += 7) {
        for (int32_t x = 0; x < VIEW_W; x += 7) {
            const lv_point_t point = {VIEW_X + x, VIEW_Y + y};
            fxl_picked own;
            fxl_frame_begin(&twin.renderer, &eye);
            wrong += lv_fixel_pick(view, &point, &picked) != FXL_OK ||
                     fxl_pick_face(&twin.renderer, (uint16_t)x, (uint16_t)y, &own) != FXL_OK ||
                     own.instance != picked.instance || own.face != picked.face;
            on_model += picked.instance != FXL_PICK_NONE;
        }
    }
    const lv_point_t beside = {VIEW_X - 1, VIEW_Y};
    printf("pick: %ld wrong, %ld on the model, early %d, beside %d\n", wrong, on_model, too_early,
           lv_fixel_pick(view, &beside, &picked));
    click(VIEW_X + VIEW_W / 2, VIEW_Y + VIEW_H / 2);
    const uint16_t middle = clicked.instance;
    click(VIEW_X + 3, VIEW_Y + VIEW_H - 3);
    printf("click: %u clicks, instance %u, then %s\n", clicks, middle,
           clicked.instance == FXL_PICK_NONE ? "none" : "one");

    lv_anim_t anim;
    lv_anim_init(&anim);
    lv_anim_set_var(&anim, view);
    lv_anim_set_exec_cb(&anim, lv_fixel_anim_yaw);
    lv_anim_set_values(&anim, 0, 4096);
    lv_anim_set_duration(&anim, 330);
    lv_anim_start(&anim);
    const uint32_t begun = lv_fixel_get_counters(view).frames;
    long differ = 0;
    for (uint32_t k = 0; k < 20; k++) {
        refresh();
        const fxl_pose pose = lv_fixel_get_pose(view);
        differ += view_differs(&pose);
    }
    const fxl_pose arrived = lv_fixel_get_pose(view);
    printf("anim: %ld pixels differ, yaw %08x, %u frames for 20 refreshes\n", differ, arrived.yaw,
           lv_fixel_get_counters(view).frames - begun);

    lv_fixel_flight_t flight = {view, eye, eye};
    flight.from.yaw = FXL_DEGREES(350);
    flight.to.yaw = FXL_DEGREES(10);
    flight.to.position.x = FXL_UNITS(-3);
    lv_fixel_anim_flight(&flight, 0);
    const fxl_pose first = lv_fixel_get_pose(view);
    lv_fixel_anim_flight(&flight, 32768);
    const fxl_pose half = lv_fixel_get_pose(view);
    lv_fixel_anim_flight(&flight, 65536);
    const fxl_pose last = lv_fixel_get_pose(view);
    printf("flight: %d %d, half yaw %d x %d\n", memcmp(&first, &flight.from, sizeof first),
           memcmp(&last, &flight.to, sizeof last), (int32_t)half.yaw, half.position.x);
    lv_obj_delete(view); /* and LVGL goes on without it */
    refresh();
    printf("deleted: no frame %s\n", model.renderer.frame.state == FXL_FRAME_NONE ? "yes" : "no");
    end_display();
}

/* How many callbacks of the widget a display has. */
static uint32_t callbacks_of_view(lv_display_t *display)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < lv_display_get_event_count(display); i++) {
        count += lv_event_dsc_get_user_data(lv_display_get_event_dsc(display, i)) == view;
    }
    return count;
}

/* A panel with the widget goes to a screen of another display, whose refreshes it follows then. */
void test_another_display(void)
{
    make_dashboard(LV_COLOR_FORMAT_RGB565);
    lv_display_t *first = lv_display_get_default(), *second = add_display();
    lv_obj_t *panel = lv_obj_create(lv_display_get_screen_active(first));
    lv_obj_remove_style_all(panel);
    lv_obj_set_size(panel, WIDTH, HEIGHT);
    lv_obj_set_parent(view, panel);
    refresh();
    lv_obj_delete(button);
    lv_obj_set_parent(panel, lv_display_get_screen_active(second));
    refresh();
    fxl_pose pose = eye;
    const uint32_t begun = lv_fixel_get_counters(view).frames;
    long differ = 0;
    for (uint32_t k = 1; k <= 5; k++) {
        pose.yaw = k * FXL_DEGREES(3);
        lv_fixel_set_pose(view, &pose);
        refresh();
        const box_t without[] = {box_of(label)};
        differ += pixels_that_differ(&twin, &pose, VIEW_X, VIEW_Y, whole_view, without, 1);
    }
    printf("another display: %ld pixels differ, %u frames of 5, callbacks %u and %u\n", differ,
           lv_fixel_get_counters(view).frames - begun, callbacks_of_view(first),
           callbacks_of_view(second));
    lv_display_delete(first);
    lv_obj_delete(panel);
    printf("deleted: callbacks %u, no frame %s\n", callbacks_of_view(second),
           model.renderer.frame.state == FXL_FRAME_NONE ? "yes" : "no");
    refresh();
    end_display();
}
