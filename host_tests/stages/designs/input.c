/* SPDX-License-Identifier: MIT */
#include "designs/stage.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    NUMBERS_MAX = ORACLE_NUMBERS_MAX > 3 + 2 * FXL_POLYGON_CAPACITY ? ORACLE_NUMBERS_MAX
                                                                    : 3 + 2 * FXL_POLYGON_CAPACITY
};

/* The numbers of an input, in the order of their text. */
typedef struct {
    int64_t values[NUMBERS_MAX];
    int count, next;
} numbers;

static void put(numbers *list, int64_t value)
{
    list->values[list->count++] = value;
}

static void put_point(numbers *list, const fxl_point *point)
{
    put(list, point->x);
    put(list, point->y);
    put(list, point->z);
}

static void put_direction(numbers *list, const fxl_direction *direction)
{
    put(list, direction->x);
    put(list, direction->y);
    put(list, direction->z);
}

static void put_view(numbers *list, const designs_input *input)
{
    const fxl_lens *lens = &input->lens;
    put(list, lens->width);
    put(list, lens->height);
    put(list, lens->focal);
    put(list, lens->near_z);
    put(list, lens->far_z);
    put(list, lens->inset);
    put_point(list, &input->camera.position);
    put_direction(list, &input->camera.axes.right);
    put_direction(list, &input->camera.axes.up);
    put_direction(list, &input->camera.axes.forward);
}

static numbers list_input(enum designs_stage stage, const designs_input *input)
{
    numbers list = {.count = 0};
    if (stage >= DESIGNS_TEXEL) {
        for (int i = 0; i < input->face.count; i++) {
            put(&list, input->face.numbers[i]);
        }
        return list;
    }
    switch (stage) {
    case DESIGNS_MATRIX:
        put(&list, input->pose.yaw);
        put(&list, input->pose.pitch);
        put(&list, input->pose.roll);
        break;
    case DESIGNS_VERTEX:
        put_view(&list, input);
        put_point(&list, &input->points[0]);
        break;
    case DESIGNS_CLIP:
        put_view(&list, input);
        put(&list, input->plane);
        put_point(&list, &input->points[0]);
        put_point(&list, &input->points[1]);
        break;
    default:
        put(&list, input->lens.width);
        put(&list, input->lens.height);
        put(&list, input->outline.count);
        for (int i = 0; i < input->outline.count; i++) {
            put(&list, input->outline.points[i].x);
            put(&list, input->outline.points[i].y);
        }
    }
    return list;
}

void designs_write_input(enum designs_stage stage, const designs_input *input,
                         char text[DESIGNS_TEXT_MAX])
{
    numbers list = list_input(stage, input);
    int at = 0;
    for (int i = 0; i < list.count; i++) {
        at += snprintf(text + at, (size_t)(DESIGNS_TEXT_MAX - at), "%s%" PRId64, i ? " " : "",
                       list.values[i]);
    }
}

static bool parse(const char *text, numbers *list)
{
    *list = (numbers){.count = 0};
    for (;;) {
        char *end;
        long long value = strtoll(text, &end, 10);
        if (end == text) {
            return *end == '\0';
        }
        if (list->count == NUMBERS_MAX || (*end != ' ' && *end != '\0')) {
            return false;
        }
        put(list, value);
        text = end;
    }
}

/* The next number, 0 past the end: the caller has checked the count. Numbers
 * outside low..high clear *sound. */
static int64_t take(numbers *list, int64_t low, int64_t high, bool *sound)
{
    int64_t value = list->values[list->next++];
    *sound = *sound && value >= low && value <= high;
    return *sound ? value : low;
}

/* Three numbers of at most so much. */
static void take_three(numbers *list, int64_t limit, int32_t *x, int32_t *y, int32_t *z,
                       bool *sound)
{
    *x = (int32_t)take(list, -limit, limit, sound);
    *y = (int32_t)take(list, -limit, limit, sound);
    *z = (int32_t)take(list, -limit, limit, sound);
}

static fxl_point take_point(numbers *list, bool *sound)
{
    fxl_point point;
    take_three(list, FXL_COORDINATE_MAX, &point.x, &point.y, &point.z, sound);
    return point;
}

static fxl_direction take_direction(numbers *list, bool *sound)
{
    fxl_direction direction;
    take_three(list, FXL_Q2_30_ONE, &direction.x, &direction.y, &direction.z, sound);
    return direction;
}

static void take_view(numbers *list, designs_input *input, bool *sound)
{
    input->lens.width = (uint16_t)take(list, 1, FXL_SCREEN_MAX, sound);
    input->lens.height = (uint16_t)take(list, 1, FXL_SCREEN_MAX, sound);
    input->lens.focal = (fxl_q16_16)take(list, 1, (1 << 29) - 1, sound);
    input->lens.near_z = (fxl_q16_16)take(list, FXL_NEAR_MIN, FXL_FAR_MAX, sound);
    input->lens.far_z = (fxl_q16_16)take(list, FXL_NEAR_MIN, FXL_FAR_MAX, sound);
    input->lens.inset = (fxl_q16_16)take(list, 0, FXL_INSET_MAX, sound);
    input->camera.position = take_point(list, sound);
    input->camera.axes.right = take_direction(list, sound);
    input->camera.axes.up = take_direction(list, sound);
    input->camera.axes.forward = take_direction(list, sound);
}

static void take_outline(numbers *list, designs_input *input, bool *sound)
{
    const int64_t limit = FXL_SCREEN_COORDINATE_MAX;
    input->lens.width = (uint16_t)take(list, 1, FXL_SCREEN_MAX, sound);
    input->lens.height = (uint16_t)take(list, 1, FXL_SCREEN_MAX, sound);
    input->outline.colour = 1;
    input->outline.count = (uint8_t)take(list, 3, FXL_POLYGON_CAPACITY, sound);
    if (list->count != 3 + 2 * input->outline.count) {
        *sound = false;
        return;
    }
    for (int i = 0; i < input->outline.count; i++) {
        input->outline.points[i].x = (fxl_q16_16)take(list, -limit, limit, sound);
        input->outline.points[i].y = (fxl_q16_16)take(list, -limit, limit, sound);
    }
}

bool designs_read_input(enum designs_stage stage, const char *text, designs_input *input)
{
    static const int counts[DESIGNS_TEXEL] = {3, 21, 25, 0};
    numbers list;
    *input = (designs_input){.plane = 0};
    if (!parse(text, &list)) {
        return false;
    }
    if (stage >= DESIGNS_TEXEL) {
        for (int i = 0; i < list.count && i < ORACLE_NUMBERS_MAX; i++) {
            oracle_put(&input->face, list.values[i]);
        }
        return designs_is_surface(stage, &input->face);
    }
    if ((stage != DESIGNS_FILL && list.count != counts[stage])) {
        return false;
    }
    bool sound = true;
    if (stage == DESIGNS_MATRIX) {
        input->pose.yaw = (fxl_angle)take(&list, 0, UINT32_MAX, &sound);
        input->pose.pitch = (fxl_angle)take(&list, 0, UINT32_MAX, &sound);
        input->pose.roll = (fxl_angle)take(&list, 0, UINT32_MAX, &sound);
    } else if (stage == DESIGNS_FILL) {
        take_outline(&list, input, &sound);
    } else {
        take_view(&list, input, &sound);
        if (stage == DESIGNS_CLIP) {
            input->plane = (int)take(&list, 0, FXL_PLANE_COUNT - 1, &sound);
        }
        input->points[0] = take_point(&list, &sound);
        if (stage == DESIGNS_CLIP) {
            input->points[1] = take_point(&list, &sound);
        }
    }
    return sound;
}
