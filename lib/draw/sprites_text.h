/* SPDX-License-Identifier: MIT */
/* The text of all painters of billboards. The file that includes this one defines FXL_TARGET,
 * FXL_TARGET_FORMAT and FXL_TARGET_DEPTH_BITS as for target_text.h, and
 *
 *   FXL_TARGET_SPRITES  the painter's name
 *
 * Internal. */
#ifndef FXL_SPRITES_TEXT_H
#define FXL_SPRITES_TEXT_H

#include "../paint/billboard_paint.h"
#include "../paint/billboard_walk.h"
#include "../raster/columns.h"
#include "pixel_row.h"

#if FXL_TARGET_DEPTH_BITS == 0

/* Where a billboard is painted. */
typedef struct {
    const fxl_band *band;
} sprite_place;

static inline bool find_place(const fxl_renderer *renderer, const fxl_workspace *workspace,
                              const fxl_screen_point *points, const fxl_band *band,
                              sprite_place *place)
{
    (void)renderer;
    (void)workspace;
    (void)points;
    place->band = band;
    return true;
}

static inline void *cells_of(const sprite_place *place, uint32_t row, uint32_t column)
{
    (void)place;
    (void)row;
    (void)column;
    return NULL;
}

/* billboards 3.2 */
static inline bool is_visible(const sprite_place *place, void *cells, int32_t x)
{
    (void)place;
    (void)cells;
    (void)x;
    return true;
}

/* billboards 4.2 */
static inline void keep(const sprite_place *place, void *cells, int32_t x)
{
    (void)place;
    (void)cells;
    (void)x;
}

#else

#include "../math/arith.h"
#include "../paint/depth_row.h"
#include "surface_polygon.h"

/* Where a billboard is painted, and how far away it is. */
typedef struct {
    const fxl_band *band;
    uint8_t *cells;  /* of the band's first pixel */
    uint32_t code;   /* of the billboard */
    uint32_t beyond; /* cells of 16 bits below this one are farther, by the rule */
    fxl_depth_rule rule;
} sprite_place;

/* The plane at a distance, above 0, that is parallel to the screen. Its depth is off relatively by
 * less than 2^-28. near_z has units of 2^-16 and the distance of 2^-46, so near_z / distance is the
 * ratio of the mantissas times 2^(30 + the difference of the exponents). */
/* billboards 4.2 */
static void find_plane(const fxl_lens *lens, fxl_q18_46 distance, fxl_depth_plane *plane)
{
    const fxl_real near_z = fxl_real_of((uint32_t)lens->near_z, 0);
    const fxl_real divisor = fxl_real_of((uint64_t)distance, 0);
    plane->gradient.at = fxl_mantissa_ratio(&near_z, &divisor);
    plane->gradient.along = plane->gradient.down = 0;
    plane->one = divisor.exponent - near_z.exponent + 1;
}

/* The code of a plane that is parallel to the screen: that of every pixel. The sum is modulo 2^32,
 * as the bias of the farthest octave is below 0. */
/* billboards 4.2 */
static uint32_t code_of(fxl_depth_scale scale, const fxl_depth_plane *plane)
{
    fxl_depth_octave octave;
    fxl_depth_octave_of(scale, plane, plane->gradient.at, &octave);
    return octave.is_constant ? octave.bias
                              : octave.bias + fxl_depth_shifted(plane->gradient.at, octave.drop);
}

/* False where billboards are not painted: where what is blended is. */
static bool find_place(const fxl_renderer *renderer, fxl_workspace *workspace,
                       const fxl_screen_point *points, const fxl_band *band, sprite_place *place)
{
    fxl_depth_head *head = (fxl_depth_head *)workspace->target_memory;
    if (head->pass == FXL_DEPTH_BLENDED) {
        return false;
    }
    fxl_depth_clear_rest(workspace, band, &FXL_TARGET);
    const fxl_q18_46 distance =
        (fxl_q18_46)((uint64_t)(uint32_t)points[3].x << 32 | (uint32_t)points[3].y);
    fxl_depth_plane plane;
    find_plane(&renderer->frame.view.lens, distance, &plane);
    place->band = band;
    place->cells = (uint8_t *)(head + 1);
    place->code = code_of(head->scale, &plane);
    place->rule.wide = FXL_TARGET_DEPTH_BITS == 32;
    place->rule.or_equal = head->or_equal;
    place->beyond = (place->code >> 16) + head->or_equal;
    return true;
}

static inline void *cells_of(const sprite_place *place, uint32_t row, uint32_t column)
{
    const fxl_band *band = place->band;
    return place->cells +
           ((row - band->first_row) * (size_t)band->width + column) * (FXL_TARGET_DEPTH_BITS / 8u);
}

static inline bool is_visible(const sprite_place *place, const void *cells, int32_t x)
{
    const fxl_depth_rule rule = {FXL_TARGET_DEPTH_BITS == 32, place->rule.or_equal};
    return FXL_TARGET_DEPTH_BITS == 16 ? ((const uint16_t *)cells)[x] < place->beyond
                                       : fxl_depth_passes(cells, x, place->code, rule);
}

static inline void keep(const sprite_place *place, void *cells, int32_t x)
{
    fxl_depth_keep(cells, x, place->code, FXL_TARGET_DEPTH_BITS == 32);
}

#endif

typedef struct {
    const sprite_place *place;
    fxl_billboard_columns *columns;
} sprite_painting;

/* Pixels of the runs. */
/* billboards 3.2 */
static inline void show_runs(const sprite_place *place, const fxl_billboard_columns *columns,
                             void *cells, fxl_pixel *pixels)
{
    for (uint32_t i = 0; i < columns->ends; i += 2) {
        const int32_t end = columns->runs[i + 1];
        for (int32_t x = columns->runs[i]; x < end; x++) {
            if (is_visible(place, cells, x)) {
                pixels[x] = (fxl_pixel)FXL_PIXEL_OF_ENTRY(place->band, columns->entries[x]);
                keep(place, cells, x);
            }
        }
    }
}

/* The same of a row of texels that is shown once: only those at visible pixels are looked up. */
/* billboards 3.2 */
static inline void show_texels(const sprite_place *place, const fxl_billboard_row *row,
                               const uint16_t *texels, void *cells, fxl_pixel *pixels)
{
    const fxl_sprite sprite = *row->sprite;
    const int32_t count = row->columns.end - row->columns.first;
    for (int32_t x = 0; x < count; x++) {
        if (is_visible(place, cells, x)) {
            const uint32_t value = fxl_sprite_value(&sprite, row->texels, texels[x], row->shift);
            if (value != sprite.key) {
                const uint8_t entry = fxl_sprite_colour(&sprite, value);
                pixels[x] = (fxl_pixel)FXL_PIXEL_OF_ENTRY(place->band, entry);
                keep(place, cells, x);
            }
        }
    }
}

/* fxl_billboard_row_painter. Pixels may be bytes of a place to the compiler, so it has a copy, and
 * one of the row. */
static inline void paint_row(fxl_billboard_row *row, const void *with)
{
    const sprite_painting *painting = (const sprite_painting *)with;
    const sprite_place place = *painting->place;
    fxl_pixel *pixels = fxl_pixels_of_row(place.band, row->y) + row->columns.first;
    void *cells = cells_of(&place, row->y, row->columns.first);
    fxl_billboard_find_texels(row, painting->columns);
    if (!FXL_IS_COMPACT && row->is_single) {
        const fxl_billboard_row copy = *row;
        show_texels(&place, &copy, painting->columns->texels, cells, pixels);
        return;
    }
    if (!row->is_repeated) {
        fxl_billboard_find_entries(row, painting->columns);
    }
    show_runs(&place, painting->columns, cells, pixels);
}

static void paint(const fxl_renderer *renderer, fxl_workspace *workspace,
                  const fxl_screen_point *points, const fxl_band *band)
{
    sprite_place place;
    fxl_billboard_columns columns;
    const sprite_painting painting = {&place, &columns};
    fxl_rows part = {band->first_column, (uint16_t)fxl_band_end_column(band)};
    if (points[2].y != 0) {
        part.end = (uint16_t)points[2].y;
        part.first = (uint16_t)(part.end - 1);
    }
    if (!find_place(renderer, workspace, points, band, &place)) {
        return;
    }
    const fxl_rows all = fxl_pixels_between(points[0].x, points[1].x, part.first, part.end);
    for (uint32_t first = all.first; first < all.end; first += FXL_BILLBOARD_COLUMNS) {
        part.first = (uint16_t)first;
        part.end = (uint16_t)(all.end - first > FXL_BILLBOARD_COLUMNS ? first + FXL_BILLBOARD_COLUMNS
                                                                      : all.end);
        columns.has_texels = false;
        fxl_billboard_walk_rows(fxl_billboard_sprite(renderer, (uint32_t)points[2].x), &points[0],
                                &points[1], band, part, paint_row, &painting);
    }
}

const fxl_sprite_painter FXL_TARGET_SPRITES = {&FXL_TARGET, paint,
                                               FXL_TARGET_DEPTH_BITS != 0 ? 4 : 3};

#endif
