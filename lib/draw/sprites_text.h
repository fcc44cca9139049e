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
    fxl_depth_clear_rest(workspace, band, FXL_TARGET_DEPTH_BITS / 8);
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

#define COLUMNS 64 /* that are painted together */

/* A row of texels as it stands in these columns of the screen, until another one is drawn. */
typedef struct {
    fxl_pixel colours[COLUMNS];
    uint16_t texels[COLUMNS];
    uint8_t runs[COLUMNS + 1]; /* the first column and the end of each run that is no hole */
    uint8_t ends;              /* that are listed; both of a run */
    bool has_texels;
} sprite_columns;

typedef struct {
    const sprite_place *place;
    sprite_columns *columns;
} sprite_painting;

/* The texel of each column; all rows have the same ones. */
static void find_texels(const fxl_billboard_row *row, sprite_columns *columns)
{
    const uint32_t count = (uint32_t)(row->columns.end - row->columns.first);
    fxl_billboard_row copy = *row;
    for (uint32_t i = 0; i < count; i++) {
        columns->texels[i] = (uint16_t)copy.along.texel;
        fxl_take_step(&copy.along);
    }
    columns->has_texels = true;
}

/* The value of a texel of a row. bits: of the sprite, or 8 for any. */
static inline uint32_t value_of(const fxl_billboard_row *row, uint32_t texel, uint32_t bits)
{
    return bits == 4 ? (uint32_t)row->texels[texel >> 1] >> (4u * (~texel & 1u)) & 15u
                     : fxl_sprite_value(row->sprite, row->texels, texel, row->shift);
}

static inline fxl_pixel colour_of(const fxl_billboard_row *row, const fxl_band *band,
                                  uint32_t value)
{
    (void)band;
    return (fxl_pixel)FXL_PIXEL_OF_ENTRY(band, fxl_sprite_colour(row->sprite, value));
}

/* Looks up each texel of a row once, for all its columns. A run ends where a hole begins, or the
 * columns end: the list has at most one end more than there are columns. bits: of the sprite. */
/* billboards 3.2 */
static inline __attribute__((always_inline)) void find_colours(const fxl_billboard_row *row,
                                                               const fxl_band *band,
                                                               sprite_columns *columns,
                                                               uint32_t bits)
{
    const uint32_t count = (uint32_t)(row->columns.end - row->columns.first);
    const uint32_t key = row->sprite->key;
    uint32_t last = UINT32_MAX, ends = 0;
    fxl_pixel colour = 0;
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t texel = columns->texels[i];
        if (texel != last) {
            const uint32_t value = value_of(row, texel, bits);
            if ((value != key) != (ends & 1u)) {
                columns->runs[ends++] = (uint8_t)i;
            }
            if (value != key) {
                colour = colour_of(row, band, value);
            }
        }
        last = texel;
        columns->colours[i] = colour;
    }
    if (ends & 1u) {
        columns->runs[ends++] = (uint8_t)count;
    }
    columns->ends = (uint8_t)ends;
}

static inline __attribute__((always_inline)) void
show(const sprite_place *place, const fxl_pixel *colours, void *cells, fxl_pixel *pixels, int32_t x)
{
    if (is_visible(place, cells, x)) {
        pixels[x] = colours[x];
        keep(place, cells, x);
    }
}

/* The same of texels that only this row shows: only those at visible pixels are looked up. */
/* billboards 3.2 */
static inline __attribute__((always_inline)) void show_texels(const fxl_billboard_row *row,
                                                              const sprite_place *place,
                                                              const uint16_t *texels, void *cells,
                                                              fxl_pixel *pixels, uint32_t bits)
{
    const int32_t count = row->columns.end - row->columns.first;
    const uint32_t key = row->sprite->key;
    for (int32_t x = 0; x < count; x++) {
        if (is_visible(place, cells, x)) {
            const uint32_t value = value_of(row, texels[x], bits);
            if (value != key) {
                pixels[x] = colour_of(row, place->band, value);
                keep(place, cells, x);
            }
        }
    }
}

/* Pixels of the runs. */
/* billboards 3.2 */
static inline void show_runs(const sprite_place *place, const sprite_columns *columns, void *cells,
                             fxl_pixel *pixels)
{
    for (uint32_t i = 0; i < columns->ends; i += 2) {
        int32_t x = columns->runs[i];
        const int32_t end = columns->runs[i + 1];
        for (; !FXL_IS_COMPACT && end - x >= 4; x += 4) {
            show(place, columns->colours, cells, pixels, x);
            show(place, columns->colours, cells, pixels, x + 1);
            show(place, columns->colours, cells, pixels, x + 2);
            show(place, columns->colours, cells, pixels, x + 3);
        }
        for (; x < end; x++) {
            show(place, columns->colours, cells, pixels, x);
        }
    }
}

/* fxl_billboard_row_painter. Pixels may be bytes of a place or a sprite to the compiler, so it has
 * copies. */
static inline void paint_row(fxl_billboard_row *row, const void *with)
{
    const sprite_painting *painting = (const sprite_painting *)with;
    const sprite_place place = *painting->place;
    const fxl_sprite sprite = *row->sprite;
    fxl_billboard_row copy = *row;
    sprite_columns *columns = painting->columns;
    fxl_pixel *pixels = fxl_pixels_of_row(place.band, row->y) + row->columns.first;
    void *cells = cells_of(&place, row->y, row->columns.first);
    const bool has_4_bits = !FXL_IS_COMPACT && row->sprite->bits == 4;
    if (!columns->has_texels) {
        find_texels(row, columns);
    }
    copy.sprite = &sprite;
    if (!FXL_IS_COMPACT && row->is_single) {
        if (has_4_bits) {
            show_texels(&copy, &place, columns->texels, cells, pixels, 4);
        } else {
            show_texels(&copy, &place, columns->texels, cells, pixels, 8);
        }
        return;
    }
    if (!row->is_repeated) {
        if (has_4_bits) {
            find_colours(&copy, place.band, columns, 4);
        } else {
            find_colours(&copy, place.band, columns, 8);
        }
    }
    show_runs(&place, columns, cells, pixels);
}

static void paint(const fxl_renderer *renderer, fxl_workspace *workspace,
                  const fxl_screen_point *points, const fxl_band *band)
{
    sprite_place place;
    sprite_columns columns;
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
    for (uint32_t first = all.first; first < all.end; first += COLUMNS) {
        part.first = (uint16_t)first;
        part.end = (uint16_t)(first + COLUMNS < all.end ? first + COLUMNS : all.end);
        columns.has_texels = false;
        fxl_billboard_walk_rows(fxl_billboard_sprite(renderer, (uint32_t)points[2].x), &points[0],
                                &points[1], band, part, paint_row, &painting);
    }
}

const fxl_sprite_painter FXL_TARGET_SPRITES = {&FXL_TARGET, paint,
                                               FXL_TARGET_DEPTH_BITS != 0 ? 4 : 3};

#endif
