/* SPDX-License-Identifier: MIT */
/* What the tests of lv_fixel share: a memory display, a scene whose model turns, its picture by
 * the library alone, and a dashboard that shows it. */
#ifndef DASHBOARD_H
#define DASHBOARD_H

#include "lv_fixel.h"

#define WIDTH      320
#define HEIGHT     240
#define ROWS       40 /* of the display's buffer */
#define VIEW_X     12
#define VIEW_Y     25
#define VIEW_W     200
#define VIEW_H     150
#define LABEL_X    10
#define LABEL_Y    8
#define COUNTED(x) (sizeof(x) / sizeof *(x))

/* What the display got, 16 bits a pixel, or 8. */
extern uint8_t screen[HEIGHT][2 * WIDTH];

/* Begins LVGL with a display of a format, whose buffer lies between canaries. */
void begin_display(lv_color_format_t format);
void end_display(void);
/* Another display of the same format and buffer, shown in the same place. */
lv_display_t *add_display(void);
/* One refresh, 33 ms later. */
void refresh(void);
bool canaries_are_intact(void);

/* A renderer and its scene, of which there are two: the widget's, and the one that it is compared
 * with. */
typedef struct {
    fxl_scene scene;
    fxl_placement placement;
    fxl_face faces[16];
    fxl_renderer renderer;
    uint64_t before; /* a canary */
    uint64_t memory[2048];
    uint64_t after;
} model_t;

extern uint16_t palette[256];
extern uint8_t grey_palette[256][3];

/* Makes it: in RGB565, or as entries of a ramp of grey. */
fxl_status make_model(model_t *model, bool is_wide, uint16_t width, uint16_t height);
/* Turns the model to frame k of 60. */
void turn_model(model_t *model, uint32_t k);

/* A rectangle; the end is not in it. */
typedef struct {
    int32_t x, y, end_x, end_y;
} box_t;

box_t box_of(const lv_obj_t *obj);
long size_of(box_t box);
bool holds(box_t box, int32_t x, int32_t y);

/* Draws the model as the library does, and counts the pixels of the display that differ from it
 * within a box, but for those in the boxes that are left out. at: where the picture is on the
 * display. */
long pixels_that_differ(model_t *model, const fxl_pose *eye, int32_t x, int32_t y, box_t within,
                        const box_t *without, size_t count);

/* The dashboard: a widget with a label over it, and a button beside it, which covers a corner of
 * it. */
extern model_t model, twin;
extern lv_obj_t *view, *label, *button;
extern const fxl_pose eye;
extern const box_t whole_view;
void make_dashboard(lv_color_format_t format);
/* Pixels that the widget has stored. */
uint32_t stored(void);
/* How many pixels of the view, but for label and button, are not the library's own of a pose. */
long view_differs(const fxl_pose *pose);

/* Tests, each a line on standard output. */
void test_dashboard(void);
void test_clip(void);
void test_formats(void);
void test_opacity(void);
void test_snapshot(void);
void test_pick_and_pose(void);
void test_another_display(void);
void test_setup(void);

#endif
