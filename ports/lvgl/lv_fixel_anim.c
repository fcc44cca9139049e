/* SPDX-License-Identifier: MIT */
/* Callbacks by which animations of LVGL move the pose of a widget. */
#include "lv_fixel.h"

/* Sets a member of the pose, which is a word at a place of the record. */
static void set_member(lv_obj_t *obj, size_t place, uint32_t value)
{
    fxl_pose pose = lv_fixel_get_pose(obj);
    lv_memcpy((uint8_t *)&pose + place, &value, sizeof value);
    lv_fixel_set_pose(obj, &pose);
}

void lv_fixel_anim_x(void *obj, int32_t value)
{
    set_member(obj, offsetof(fxl_pose, position.x), (uint32_t)value);
}

void lv_fixel_anim_y(void *obj, int32_t value)
{
    set_member(obj, offsetof(fxl_pose, position.y), (uint32_t)value);
}

void lv_fixel_anim_z(void *obj, int32_t value)
{
    set_member(obj, offsetof(fxl_pose, position.z), (uint32_t)value);
}

void lv_fixel_anim_yaw(void *obj, int32_t value)
{
    set_member(obj, offsetof(fxl_pose, yaw), (uint32_t)value << 16);
}

void lv_fixel_anim_pitch(void *obj, int32_t value)
{
    set_member(obj, offsetof(fxl_pose, pitch), (uint32_t)value << 16);
}

void lv_fixel_anim_roll(void *obj, int32_t value)
{
    set_member(obj, offsetof(fxl_pose, roll), (uint32_t)value << 16);
}

/* difference * value / 65536, rounded down. The product is below 2^63: both are below 2^31 in
 * magnitude. */
static int32_t part(int32_t difference, int32_t value)
{
    const int64_t product = (int64_t)difference * value;
    return (int32_t)(product >= 0 ? product / 65536 : -((65535 - product) / 65536));
}

void lv_fixel_anim_flight(void *flight, int32_t value)
{
    const lv_fixel_flight_t *path = flight;
    const fxl_pose *a = &path->from, *b = &path->to;
    const fxl_pose pose = {
        .position = {a->position.x + part(b->position.x - a->position.x, value),
                     a->position.y + part(b->position.y - a->position.y, value),
                     a->position.z + part(b->position.z - a->position.z, value)},
        /* A difference of angles as a signed number is that of the shorter way. */
        .yaw = a->yaw + (fxl_angle)part((int32_t)(b->yaw - a->yaw), value),
        .pitch = a->pitch + (fxl_angle)part((int32_t)(b->pitch - a->pitch), value),
        .roll = a->roll + (fxl_angle)part((int32_t)(b->roll - a->roll), value),
    };
    lv_fixel_set_pose(path->obj, &pose);
}
