/* SPDX-License-Identifier: MIT */
#include "lv_fixel.h"

#include <fixel/pixels.h>
#include <lvgl_private.h>

/* LVGL's classes and draw units are declared in its private headers, which change between its
 * minor versions. */
#if LVGL_VERSION_MAJOR != 9 || LVGL_VERSION_MINOR < 5
#error "lv_fixel is written for LVGL 9.5"
#endif

#define UNIT_NAME "FIXEL"

typedef struct {
    lv_obj_t obj;
    fxl_renderer *renderer; /* null: there is none */
    lv_display_t *display;  /* whose refreshes are followed; it may have been deleted */
    fxl_pose pose, shown;   /* as set; as of the frame that was begun last */
    uint16_t *swapped;      /* the palette with its bytes swapped; null: not needed yet */
    uint32_t swapped_in;    /* as counters.frames has it: the frame that it was made for */
    lv_fixel_counters_t counters;
    const char *refusal;
    bool is_begun;      /* a frame is */
    bool is_refreshing; /* the display is */
    bool was_shown;     /* a frame was begun since the renderer was set */
} lv_fixel_t;

/* The draw tasks of this widget have its address as user data. */
static const uint8_t mark;

/* --- frames ----------------------------------------------------------------------------- */

static void end_frame(lv_fixel_t *widget)
{
    if (widget->is_begun) {
        widget->is_begun = false;
        fxl_frame_end(widget->renderer);
    }
}

static fxl_status begin_frame(lv_fixel_t *widget, const fxl_pose *pose)
{
    if (widget->is_begun) {
        return FXL_OK;
    }
    const fxl_status status = fxl_frame_begin(widget->renderer, pose);
    widget->is_begun = status == FXL_OK;
    return status;
}

/* The frame of this refresh: it is begun once, by the first of the layers. */
static fxl_status begin_shown(lv_fixel_t *widget)
{
    const bool is_new = !widget->is_begun;
    const fxl_status status = begin_frame(widget, &widget->pose);
    if (is_new && status == FXL_OK) {
        widget->shown = widget->pose;
        widget->was_shown = true;
        widget->counters.frames++;
    }
    return status;
}

/* Before and after a refresh no frame is begun: the program may change the scene. */
static void follow_refresh(lv_event_t *event)
{
    lv_fixel_t *widget = lv_event_get_user_data(event);
    widget->is_refreshing = lv_event_get_code(event) == LV_EVENT_REFR_START;
    end_frame(widget);
}

/* Follows the refreshes of a display, none if it is null, and no longer those of another. LVGL does
 * not tell a widget that an object above it has got a parent on another display, so each drawing
 * asks. */
static void follow_display(lv_fixel_t *widget, lv_display_t *display)
{
    lv_display_t *old = lv_display_get_next(NULL);
    if (display == widget->display) {
        return;
    }
    while (old != NULL && old != widget->display) {
        old = lv_display_get_next(old);
    }
    if (old != NULL) {
        lv_display_remove_event_cb_with_user_data(old, follow_refresh, widget);
    }
    end_frame(widget);
    widget->display = display;
    widget->is_refreshing = display != NULL && display->rendering_in_progress;
    if (display != NULL) {
        lv_display_add_event_cb(display, follow_refresh, LV_EVENT_REFR_START, widget);
        lv_display_add_event_cb(display, follow_refresh, LV_EVENT_REFR_READY, widget);
    }
}

/* --- the draw unit ---------------------------------------------------------------------- */

/* The widget of a draw task; null: the task is another's. */
static lv_fixel_t *widget_of(const lv_draw_task_t *task)
{
    const lv_draw_dsc_base_t *base = task->draw_dsc;
    return task->type == LV_DRAW_TASK_TYPE_FILL && base->user_data == &mark
               ? (lv_fixel_t *)base->obj
               : NULL;
}

static bool is_transformed(const lv_draw_task_t *task)
{
#if LV_DRAW_TRANSFORM_USE_MATRIX
    return !lv_matrix_is_identity(&task->matrix);
#else
    LV_UNUSED(task);
    return false;
#endif
}

/* Why a draw task cannot be drawn; null: it can. */
static const char *refusal_of(lv_fixel_t *widget, const lv_draw_task_t *task)
{
    const bool is_wide = widget->renderer->palette != NULL;
    if (task->opa < LV_OPA_MAX) {
        return "a widget with an opacity is not drawn: use the style opa_layered";
    }
    if (task->target_layer->recolor.alpha != 0) {
        return "a widget that is recoloured is not drawn";
    }
    if (is_transformed(task)) {
        return "a widget that is rotated or scaled is not drawn";
    }
    switch (task->target_layer->color_format) {
    case LV_COLOR_FORMAT_RGB565:
    case LV_COLOR_FORMAT_RGB565_SWAPPED:
        if (!is_wide) {
            return "a layer of RGB565 needs a renderer with an RGB565 target";
        }
        break;
    case LV_COLOR_FORMAT_L8:
        if (is_wide) {
            return "a layer of L8 needs a renderer of a palette that is a ramp of grey";
        }
        break;
    default:
        return "the layer is neither RGB565 nor L8, as one that is rotated or has an alpha channel";
    }
    const fxl_status status = begin_shown(widget);
    return status != FXL_OK ? fxl_status_text(status) : NULL;
}

static void refuse(lv_fixel_t *widget, const char *why)
{
    widget->counters.refused++;
    if (widget->refusal != why) {
        widget->refusal = why;
        LV_LOG_WARN("%s", why);
    }
}

/* Takes the draw tasks that can be drawn. The software unit draws the others: a plain rectangle. */
static int32_t evaluate(lv_draw_unit_t *unit, lv_draw_task_t *task)
{
    LV_UNUSED(unit);
    lv_fixel_t *widget = widget_of(task);
    if (widget != NULL) {
        const char *why = refusal_of(widget, task);
        if (why == NULL) {
            task->preference_score = 0;
            task->preferred_draw_unit_id = LV_FIXEL_DRAW_UNIT_ID;
        } else {
            refuse(widget, why);
        }
    }
    return 0;
}

/* Whether all colours of a frame are entries of the palette: no light, surface or sprite makes
 * others. */
static bool is_plain(const fxl_renderer *renderer)
{
    const fxl_target_extras *extras = renderer->target->extras;
    return renderer->billboards == NULL &&
           (renderer->shader == NULL || (extras != NULL && renderer->shader == extras->last));
}

/* The palette with the bytes of each colour swapped, made once a frame; null: there is no memory
 * for it. */
static const uint16_t *swapped_palette(lv_fixel_t *widget)
{
    if (widget->swapped == NULL) {
        widget->swapped = lv_malloc(FXL_PALETTE_COLOURS * sizeof(uint16_t));
        widget->swapped_in = 0;
    }
    if (widget->swapped != NULL && widget->swapped_in != widget->counters.frames) {
        widget->swapped_in = widget->counters.frames;
        for (uint32_t i = 0; i < FXL_PALETTE_COLOURS; i++) {
            const uint16_t colour = widget->renderer->palette[i];
            widget->swapped[i] = (uint16_t)(colour << 8 | colour >> 8);
        }
    }
    return widget->swapped;
}

/* Draws a rectangle of the display, which lies within the task and the layer's buffer. */
static fxl_status draw(lv_fixel_t *widget, const lv_draw_task_t *task, const lv_area_t *area)
{
    lv_layer_t *layer = task->target_layer;
    const bool is_wide = widget->renderer->palette != NULL;
    const bool is_swapped = layer->color_format == LV_COLOR_FORMAT_RGB565_SWAPPED;
    fxl_band band = {
        .pixels = lv_draw_layer_go_to_xy(layer, area->x1 - layer->buf_area.x1,
                                         area->y1 - layer->buf_area.y1),
        .width = widget->renderer->frame.view.lens.width,
        .stride = (uint16_t)(layer->draw_buf->header.stride / (is_wide ? 2u : 1u)),
        .first_row = (uint16_t)(area->y1 - task->area.y1),
        .rows = (uint16_t)lv_area_get_height(area),
        .palette = widget->renderer->palette,
        .first_column = (uint16_t)(area->x1 - task->area.x1),
        .columns = (uint16_t)lv_area_get_width(area),
    };
    fxl_status status = begin_shown(widget);
    /* Colours of the palette are stored swapped. Others are swapped once the band is drawn. */
    const uint16_t *swapped =
        is_swapped && is_plain(widget->renderer) ? swapped_palette(widget) : NULL;
    if (swapped != NULL) {
        band.palette = swapped;
    }
    if (status == FXL_OK) {
        fxl_frame_fill(widget->renderer, &band, widget->renderer->frame.background);
        status = fxl_frame_draw(widget->renderer, &band);
    }
    if (status == FXL_OK && is_swapped && swapped == NULL) {
        fxl_swap_rgb565(&band);
    }
    return status;
}

static int32_t dispatch(lv_draw_unit_t *unit, lv_layer_t *layer)
{
    lv_draw_task_t *task = lv_draw_get_next_available_task(layer, NULL, LV_FIXEL_DRAW_UNIT_ID);
    lv_area_t area;
    if (task == NULL || lv_draw_layer_alloc_buf(layer) == NULL) {
        return LV_DRAW_UNIT_IDLE;
    }
    task->state = LV_DRAW_TASK_STATE_IN_PROGRESS;
    task->draw_unit = unit;
    if (lv_area_intersect(&area, &task->area, &task->clip_area) &&
        lv_area_intersect(&area, &area, &layer->buf_area)) {
        lv_fixel_t *widget = widget_of(task);
        const fxl_status status = draw(widget, task, &area);
        if (status == FXL_OK) {
            widget->counters.tasks++;
            widget->counters.pixels += lv_area_get_size(&area);
        } else {
            refuse(widget, fxl_status_text(status));
        }
        if (!widget->is_refreshing) {
            end_frame(widget); /* a snapshot */
        }
    }
    task->state = LV_DRAW_TASK_STATE_FINISHED;
    lv_draw_dispatch_request();
    return 1;
}

/* The draw unit is made once after lv_init, and lv_deinit deletes it. */
static void make_unit(void)
{
    for (lv_draw_unit_t *unit = LV_GLOBAL_DEFAULT()->draw_info.unit_head; unit != NULL;
         unit = unit->next) {
        if (unit->dispatch_cb == dispatch) {
            return;
        }
    }
    lv_draw_unit_t *unit = lv_draw_create_unit(sizeof(lv_draw_unit_t));
    unit->dispatch_cb = dispatch;
    unit->evaluate_cb = evaluate;
    unit->name = UNIT_NAME;
}

/* --- the widget ------------------------------------------------------------------------- */

/* Where the picture is on the display. */
static lv_area_t picture_of(const lv_fixel_t *widget)
{
    const fxl_lens *lens = &widget->renderer->frame.view.lens;
    lv_area_t area = widget->obj.coords;
    area.x2 = area.x1 + lens->width - 1;
    area.y2 = area.y1 + lens->height - 1;
    return area;
}

/* The colour that a picture is cleared to. */
static lv_color_t background_of(const fxl_renderer *renderer)
{
    const uint8_t entry = renderer->frame.background;
    if (renderer->palette == NULL) {
        return lv_color_make(entry, entry, entry);
    }
    const uint32_t colour = renderer->palette[entry];
    const uint32_t red = colour >> 11, green = colour >> 5 & 63u, blue = colour & 31u;
    return lv_color_make((uint8_t)(red << 3 | red >> 2), (uint8_t)(green << 2 | green >> 4),
                         (uint8_t)(blue << 3 | blue >> 2));
}

static void add_task(lv_fixel_t *widget, lv_layer_t *layer)
{
    const lv_area_t area = picture_of(widget);
    lv_draw_fill_dsc_t fill;
    follow_display(widget, lv_obj_get_display(&widget->obj));
    lv_draw_fill_dsc_init(&fill);
    fill.base.obj = &widget->obj;
    fill.base.layer = layer;
    fill.base.user_data = (void *)(uintptr_t)&mark;
    fill.color = background_of(widget->renderer);
    fill.opa = layer->opa;
    lv_draw_fill(layer, &fill, &area);
}

/* What the picture covers wholly LVGL does not draw beneath it. */
static void answer_cover_check(const lv_fixel_t *widget, lv_cover_check_info_t *info)
{
    const lv_area_t area = picture_of(widget);
    if (info->res != LV_COVER_RES_MASKED && lv_area_is_in(info->area, &area, 0) &&
        lv_area_is_in(info->area, &widget->obj.coords, 0) &&
        lv_obj_get_style_opa_recursive(&widget->obj, LV_PART_MAIN) >= LV_OPA_MAX) {
        info->res = LV_COVER_RES_COVER;
    }
}

static void answer(const lv_obj_class_t *class_p, lv_event_t *event)
{
    LV_UNUSED(class_p);
    if (lv_obj_event_base(&lv_fixel_class, event) != LV_RESULT_OK) {
        return;
    }
    lv_fixel_t *widget = lv_event_get_current_target(event);
    if (widget->renderer == NULL) {
        return;
    }
    switch (lv_event_get_code(event)) {
    case LV_EVENT_GET_SELF_SIZE: {
        const fxl_lens *lens = &widget->renderer->frame.view.lens;
        *(lv_point_t *)lv_event_get_param(event) = (lv_point_t){lens->width, lens->height};
        break;
    }
    case LV_EVENT_COVER_CHECK:
        answer_cover_check(widget, lv_event_get_param(event));
        break;
    case LV_EVENT_DRAW_MAIN:
        add_task(widget, lv_event_get_layer(event));
        break;
    default:
        break;
    }
}

static void construct(const lv_obj_class_t *class_p, lv_obj_t *obj)
{
    LV_UNUSED(class_p);
    make_unit();
    lv_obj_remove_flag(obj, LV_OBJ_FLAG_SCROLLABLE);
    follow_display((lv_fixel_t *)obj, lv_obj_get_display(obj));
}

static void destruct(const lv_obj_class_t *class_p, lv_obj_t *obj)
{
    LV_UNUSED(class_p);
    lv_fixel_t *widget = (lv_fixel_t *)obj;
    follow_display(widget, NULL);
    lv_free(widget->swapped);
}

const lv_obj_class_t lv_fixel_class = {
    .base_class = &lv_obj_class,
    .constructor_cb = construct,
    .destructor_cb = destruct,
    .event_cb = answer,
    .name = "lv_fixel",
    .width_def = LV_SIZE_CONTENT,
    .height_def = LV_SIZE_CONTENT,
    .instance_size = sizeof(lv_fixel_t),
};

lv_obj_t *lv_fixel_create(lv_obj_t *parent)
{
    lv_obj_t *obj = lv_obj_class_create_obj(&lv_fixel_class, parent);
    lv_obj_class_init_obj(obj);
    return obj;
}

/* --- what a program sets and asks ------------------------------------------------------- */

static bool is_grey_ramp(const uint8_t *palette)
{
    for (uint32_t i = 0; palette != NULL && i < 3 * FXL_PALETTE_COLOURS; i++) {
        if (palette[i] != i / 3) {
            return false;
        }
    }
    return palette != NULL;
}

fxl_status lv_fixel_set_renderer(lv_obj_t *obj, fxl_renderer *renderer, const uint8_t *palette)
{
    lv_fixel_t *widget = (lv_fixel_t *)obj;
    if (widget == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (renderer != NULL && renderer->target == NULL) {
        return FXL_E_ORDER;
    }
    if (renderer != NULL && renderer->palette == NULL && !is_grey_ramp(palette)) {
        return FXL_E_COMBINATION;
    }
    end_frame(widget);
    widget->renderer = renderer;
    widget->was_shown = false;
    lv_obj_refresh_self_size(obj);
    lv_obj_invalidate(obj);
    return FXL_OK;
}

void lv_fixel_set_pose(lv_obj_t *obj, const fxl_pose *pose)
{
    lv_fixel_t *widget = (lv_fixel_t *)obj;
    if (lv_memcmp(&widget->pose, pose, sizeof *pose) != 0) {
        widget->pose = *pose;
        lv_obj_invalidate(obj);
    }
}

fxl_pose lv_fixel_get_pose(const lv_obj_t *obj)
{
    return ((const lv_fixel_t *)obj)->pose;
}

lv_fixel_counters_t lv_fixel_get_counters(const lv_obj_t *obj)
{
    return ((const lv_fixel_t *)obj)->counters;
}

const char *lv_fixel_get_refusal(const lv_obj_t *obj)
{
    return ((const lv_fixel_t *)obj)->refusal;
}

fxl_status lv_fixel_pick(lv_obj_t *obj, const lv_point_t *point, fxl_picked *picked)
{
    lv_fixel_t *widget = (lv_fixel_t *)obj;
    if (widget == NULL || point == NULL || picked == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (widget->renderer == NULL || !widget->was_shown) {
        return FXL_E_ORDER;
    }
    const lv_area_t area = picture_of(widget);
    if (point->x < area.x1 || point->x > area.x2 || point->y < area.y1 || point->y > area.y2) {
        return FXL_E_RANGE;
    }
    fxl_status status = begin_frame(widget, &widget->shown);
    if (status == FXL_OK) {
        status = fxl_pick_face(widget->renderer, (uint16_t)(point->x - area.x1),
                               (uint16_t)(point->y - area.y1), picked);
    }
    if (!widget->is_refreshing) {
        end_frame(widget);
    }
    return status;
}
