/* SPDX-License-Identifier: MIT */
#include "surface_polygon.h"

#include "../../src/math/arith.h"
#include "../../src/math/memory.h"
#include "paint.h"
#include "surface_light.h"
#include "texture_level.h"

/* A record: what every record begins with, whose count is that of all pairs of words after it and
 * whose reserved byte is that of the points; the points; then the words below. */
#define FIXED_WORDS    4u /* surface, count, level and colour; shifts; weight_min */
#define GRADIENT_WORDS 6u

FXL_STATIC_ASSERT(sizeof(fxl_gradient) == GRADIENT_WORDS * sizeof(uint32_t), "no padding");
FXL_STATIC_ASSERT(FXL_POLYGON_CAPACITY +
                          (FIXED_WORDS + GRADIENT_WORDS * (1 + FXL_ATTRIBUTES)) / 2 <=
                      255,
                  "8 bits for the count of pairs");

static uint32_t words_beside(const fxl_gradients *gradients)
{
    return FIXED_WORDS + GRADIENT_WORDS * (1 + gradients->count); /* even */
}

bool fxl_surface_polygon_append(fxl_display_list *list, const fxl_screen_polygon *screen,
                                fxl_rows rows, const fxl_surface_polygon *polygon)
{
    const fxl_gradients *gradients = &polygon->gradients;
    const uint32_t beside = words_beside(gradients);
    const uint32_t words = FXL_DISPLAY_LIST_WORDS((uint32_t)screen->count) + beside;
    FXL_ASSERT(rows.first < rows.end && list->used <= list->capacity);
    if (list->capacity - list->used < words) {
        return false;
    }
    uint32_t *to = list->words + list->used;
    to[0] = (uint32_t)rows.end << 16 | rows.first;
    const uint8_t head[4] = {screen->colour, (uint8_t)(screen->count + beside / 2),
                             FXL_POLYGON_SURFACE, screen->count};
    memcpy(to + 1, head, sizeof head);
    memcpy(to + 2, screen->points, screen->count * sizeof screen->points[0]);
    to += words - beside;
    to[0] = polygon->surface | (uint32_t)gradients->count << 16 | (uint32_t)polygon->level << 20 |
            (uint32_t)polygon->colour << 24;
    memcpy(to + 1, gradients->shifts, sizeof gradients->shifts);
    memcpy(to + 2, gradients->weight_min, sizeof gradients->weight_min);
    memcpy(to + FIXED_WORDS, &gradients->weight, sizeof gradients->weight);
    memcpy(to + FIXED_WORDS + GRADIENT_WORDS, gradients->attributes,
           gradients->count * sizeof gradients->attributes[0]);
    list->used += words;
    return true;
}

uint32_t fxl_surface_polygon_read(const fxl_display_list_record *record,
                                  fxl_surface_polygon *polygon)
{
    fxl_gradients *gradients = &polygon->gradients;
    const uint8_t *head = (const uint8_t *)(const void *)record->points - 4;
    const uint32_t *from = (const uint32_t *)(const void *)(record->points + head[3]);
    polygon->surface = (uint16_t)from[0];
    polygon->colour = (uint8_t)(from[0] >> 24);
    polygon->level = (uint8_t)(from[0] >> 20 & 15u);
    gradients->count = (uint8_t)(from[0] >> 16 & 15u);
    memcpy(gradients->shifts, from + 1, sizeof gradients->shifts);
    memcpy(gradients->weight_min, from + 2, sizeof gradients->weight_min);
    memcpy(&gradients->weight, from + FIXED_WORDS, sizeof gradients->weight);
    memcpy(gradients->attributes, from + FIXED_WORDS + GRADIENT_WORDS,
           gradients->count * sizeof gradients->attributes[0]);
    return head[3];
}

void fxl_surface_polygon_paint(const fxl_surfaces *surfaces, const fxl_surface_polygon *polygon,
                               const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                               fxl_scan *scan)
{
    const fxl_surface_set *set = surfaces->set;
    const fxl_surface *surface = &set->surfaces[polygon->surface];
    fxl_paint paint;
    paint.gradients = &polygon->gradients;
    paint.level.texels = NULL;
    if (surface->texture != 0) {
        fxl_texture_level_find(&set->textures[surface->texture - 1], polygon->level, &paint.level);
    }
    paint.ramp = NULL;
    paint.levels_less_1 = 0;
    if (fxl_surface_is_lit(surfaces, surface)) {
        paint.ramp = surfaces->light->settings.ramp;
        paint.levels_less_1 = (uint8_t)(surfaces->light->settings.levels - 1);
    }
    paint.blend = surface->flags & FXL_SURFACE_BLEND ? set->blend : NULL;
    paint.blend_first = (uint8_t)set->blend_first;
    paint.blend_count = set->blend_count;
    paint.colour = polygon->colour;
    paint.division = surface->division == FXL_AFFINE ? FXL_DIVIDE_16 : surface->division;
    paint.opacity = surface->opacity;
    fxl_paint_polygon(&paint, points, count, band, scan);
}
