/* SPDX-License-Identifier: MIT */
/* What a program does with lv_fixel: picks, poses, flights, another display. test_lvgl.py judges the lines. */
#include "dashboard.h"

#include <stdio.h>
#include <string.h>

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
