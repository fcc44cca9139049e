/* SPDX-License-Identifier: MIT */
#include "../math/aligned.h"
#include "../math/arith.h"
#include "../scene/fault.h"
#include "fixel/billboards.h"

static bool has_bits(const fxl_sprite *sprite)
{
    return sprite->bits == 1 || sprite->bits == 4 || sprite->bits == 8;
}

static bool is_side(fxl_q16_16 side, fxl_q16_16 anchor)
{
    return side >= 1 && side <= FXL_BILLBOARD_SIDE_MAX && anchor >= 0 && anchor <= side;
}

static fxl_status check_billboard(const fxl_billboard *billboard)
{
    const fxl_sprite *sprite = billboard->sprite;
    if (sprite == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!fxl_is_aligned(sprite, FXL_POINTER)) {
        return FXL_E_ALIGNMENT;
    }
    if (sprite->pixels == NULL) {
        return FXL_E_ARGUMENT;
    }
    return has_bits(sprite) && sprite->width >= 1 && sprite->height >= 1 &&
                   is_side(billboard->width, billboard->anchor_x) &&
                   is_side(billboard->height, billboard->anchor_y)
               ? FXL_OK
               : FXL_E_RANGE;
}

/* The square of the greater part of a side, below 2^58. */
static uint64_t square_beyond(fxl_q16_16 side, fxl_q16_16 anchor)
{
    const fxl_q16_16 rest = side - anchor;
    const uint32_t part = (uint32_t)(rest > anchor ? rest : anchor);
    return fxl_multiply_u32(part, part);
}

/* The radius is below 2^31, so its square is below 2^62. */
static fxl_status check_model(const fxl_model *model, const fxl_billboard *billboard)
{
    const uint32_t radius = (uint32_t)model->radius;
    if (model->kind != FXL_MODEL_CONVEX || model->face_count != 1) {
        return FXL_E_COUNT;
    }
    return square_beyond(billboard->width, billboard->anchor_x) +
                       square_beyond(billboard->height, billboard->anchor_y) <=
                   fxl_multiply_u32(radius, radius)
               ? FXL_OK
               : FXL_E_RADIUS;
}

fxl_status fxl_billboards_check(const fxl_billboard_set *set, const fxl_scene *scene,
                                fxl_scene_fault *fault)
{
    if (set == NULL || scene == NULL || set->model_map == NULL ||
        (set->count > 0 && set->billboards == NULL)) {
        return fxl_fault_at(fault, "billboard table", 0, FXL_E_ARGUMENT);
    }
    if (!fxl_is_aligned(set->billboards, FXL_POINTER) ||
        !fxl_is_aligned(set->model_map, sizeof *set->model_map)) {
        return fxl_fault_at(fault, "billboard table", 0, FXL_E_ALIGNMENT);
    }
    if (set->count > UINT16_MAX) {
        return fxl_fault_at(fault, "billboard table", 0, FXL_E_COUNT);
    }
    for (uint32_t i = 0; i < set->count; i++) {
        const fxl_status status = check_billboard(&set->billboards[i]);
        if (status != FXL_OK) {
            return fxl_fault_at(fault, "billboard", i, status);
        }
    }
    for (uint32_t i = 0; i < scene->model_count; i++) {
        const uint32_t number = set->model_map[i];
        if (number > set->count) {
            return fxl_fault_at(fault, "model", i, FXL_E_INDEX);
        }
        const fxl_status status =
            number == 0 ? FXL_OK : check_model(&scene->models[i], &set->billboards[number - 1]);
        if (status != FXL_OK) {
            return fxl_fault_at(fault, "model", i, status);
        }
    }
    return FXL_OK;
}
