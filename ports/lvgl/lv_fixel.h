/* SPDX-License-Identifier: MIT */
/* lv_fixel: a widget of LVGL 9.5 that shows what a renderer of Fixel draws. docs/lvgl.md.
 *
 * The widget adds a draw task of its own to each layer that shows it, and a draw unit of its own
 * takes the task: Fixel draws straight into the layer's buffer, at its stride and within the clip
 * area, in LVGL's order. No pixel is copied. LVGL draws the widgets over it and beside it.
 *
 * It draws into layers of RGB565 and RGB565_SWAPPED (a renderer with an RGB565 target), and into L8
 * (a renderer of a palette that is a ramp of grey). Into any other layer, and with an opacity, it
 * draws nothing: LVGL fills the rectangle with the background's colour, the widget counts that
 * (lv_fixel_get_counters), and says why (lv_fixel_get_refusal, and once in LVGL's log).
 *
 * All functions are for the thread that calls lv_timer_handler, as LVGL's own are. */
#ifndef LV_FIXEL_H
#define LV_FIXEL_H

#include <fixel/pick.h>
#include <fixel/render.h>
#include <lvgl.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of the draw unit, which no other unit of the program may have. */
#ifndef LV_FIXEL_DRAW_UNIT_ID
#define LV_FIXEL_DRAW_UNIT_ID 70
#endif

extern const lv_obj_class_t lv_fixel_class;

/* What a widget has drawn since it was created. */
typedef struct {
    uint32_t frames;  /* frames begun: at most one a refresh of the display */
    uint32_t tasks;   /* draw tasks that were drawn: one a layer that shows the widget */
    uint32_t pixels;  /* stored by them */
    uint32_t refused; /* draw tasks of which LVGL drew a plain rectangle */
} lv_fixel_counters_t;

/* Makes a widget without a renderer, which shows nothing. Its size is that of its content: the
 * renderer's screen. A smaller widget shows the upper left part. */
lv_obj_t *lv_fixel_create(lv_obj_t *parent);

/* Gives a widget its renderer, which must live as long as the widget, or until another is set.
 * No other widget may have it, and while the display is refreshed the program may not use it.
 * Between two refreshes no frame is begun, so the scene and what is attached may change;
 * lv_obj_invalidate then has the widget drawn anew. Null: it has none.
 * palette: of a renderer whose target is a palette, its 256 x red, green, blue. Else it is not
 * read. An exported scene has both: &it.renderer and NAME_setup.palette (fixel/setup.h).
 * FXL_E_ARGUMENT: obj is null.
 * FXL_E_ORDER: the renderer was never initialised.
 * FXL_E_COMBINATION: the palette is null, or no ramp of grey: entry i must be i, i, i.
 * With each of these statuses: the widget untouched. */
fxl_status lv_fixel_set_renderer(lv_obj_t *obj, fxl_renderer *renderer, const uint8_t *palette);

/* Sets the pose of the eye, and has the widget drawn anew if it is another. */
void lv_fixel_set_pose(lv_obj_t *obj, const fxl_pose *pose);

/* The pose that was set last; all zeros at first. */
fxl_pose lv_fixel_get_pose(const lv_obj_t *obj);

lv_fixel_counters_t lv_fixel_get_counters(const lv_obj_t *obj);

/* Why a draw task was refused last: an English sentence, constant. Null: none was. */
const char *lv_fixel_get_refusal(const lv_obj_t *obj);

/* Finds what the widget shows at a point of the display, as lv_indev_get_point answers it:
 * picked->instance is FXL_PICK_NONE where it shows no instance. It takes the pose that was drawn
 * last, begins a frame for it and ends it; so the scene must be as it was then.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: the widget has no renderer, or was not drawn yet.
 * FXL_E_RANGE: the point is not on the picture.
 * The statuses of fxl_frame_begin.
 * With each of these statuses: *picked untouched. */
fxl_status lv_fixel_pick(lv_obj_t *obj, const lv_point_t *point, fxl_picked *picked);

/* Callbacks for lv_anim_set_exec_cb; the variable of the animation is the widget. They set one
 * member of the pose: a coordinate in units of 1/65536, an angle in units of 1/65536 turn. */
void lv_fixel_anim_x(void *obj, int32_t value);
void lv_fixel_anim_y(void *obj, int32_t value);
void lv_fixel_anim_z(void *obj, int32_t value);
void lv_fixel_anim_yaw(void *obj, int32_t value);
void lv_fixel_anim_pitch(void *obj, int32_t value);
void lv_fixel_anim_roll(void *obj, int32_t value);

/* A flight from one pose to another, which the caller owns while it is animated. */
typedef struct {
    lv_obj_t *obj;
    fxl_pose from, to;
} lv_fixel_flight_t;

/* Another callback; the variable is a flight. value: 0 is `from`, 65536 is `to`; a path that
 * overshoots may go beyond. Positions are linear; angles go the shorter way. */
void lv_fixel_anim_flight(void *flight, int32_t value);

#ifdef __cplusplus
}
#endif

#endif
