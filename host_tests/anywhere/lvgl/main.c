/* SPDX-License-Identifier: MIT */
/* All tests of lv_fixel, and two programs whose sizes are compared: a dashboard with the widget,
 * and with a plain one in its place. */
#include "dashboard.h"

#include <stdio.h>

void run_all_tests(void);
void run_dashboard(void);
void run_dashboard_without(void);

void run_all_tests(void)
{
    setvbuf(stdout, NULL, _IOLBF, 0);
    test_dashboard();
    test_clip();
    test_formats();
    test_opacity();
    test_snapshot();
    test_pick_and_pose();
    test_another_display();
    test_setup();
}

static void run_with(lv_obj_t *(*make_view)(lv_obj_t *parent))
{
    lv_mem_monitor_t before, after;
    begin_display(LV_COLOR_FORMAT_RGB565);
    lv_obj_t *label = lv_label_create(lv_screen_active()),
             *button = lv_button_create(lv_screen_active());
    lv_label_set_text(label, "speed 42");
    lv_obj_set_pos(button, 200, 180);
    lv_mem_monitor(&before);
    lv_obj_t *view = make_view(lv_screen_active());
    lv_mem_monitor(&after);
    lv_obj_set_pos(view, VIEW_X, VIEW_Y);
    refresh();
    printf("heap: %d bytes for the widget, screen %u\n", (int)(before.free_size - after.free_size),
           screen[VIEW_Y + 75][2 * (VIEW_X + 100)]);
    end_display();
}

static lv_obj_t *make_plain(lv_obj_t *parent)
{
    lv_obj_t *view = lv_obj_create(parent);
    lv_obj_set_size(view, VIEW_W, VIEW_H);
    return view;
}

static lv_obj_t *make_fixel(lv_obj_t *parent)
{
    static model_t model;
    const fxl_pose eye = {.position = {0, FXL_UNITS(2), FXL_UNITS(-8)}, .pitch = FXL_DEGREES(-12)};
    lv_obj_t *view = lv_fixel_create(parent);
    make_model(&model, true, VIEW_W, VIEW_H);
    lv_fixel_set_renderer(view, &model.renderer, NULL);
    lv_fixel_set_pose(view, &eye);
    return view;
}

void run_dashboard(void)
{
    run_with(make_fixel);
}

void run_dashboard_without(void)
{
    run_with(make_plain);
}
