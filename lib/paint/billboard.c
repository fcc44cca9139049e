/* SPDX-License-Identifier: MIT */
/* The billboards of a scene image (docs/formats.md, section 1.13), and what their columns show. */
#include "../math/arith.h"
#include "../math/family.h"
#include "../math/memory.h"
#include "../scene/scene_check.h"
#include "fixel/billboards.h"
/* place sampling: if billboards change too: a billboard's texel, its value, the sprite */
#include "billboard_walk.h"

/* formats 1.13 */
static bool lies_in(uint32_t place, uint64_t bytes, uint32_t size)
{
    return place <= size && bytes <= size - place;
}

/* Whether a sprite lies within the pixels of the image. A picture of 65535 x 65535 pixels has less
 * than 2^32 bytes. */
/* billboards 5.1, formats 1.13 */
static fxl_status make_sprite(const fxl_scene_billboard *from, const fxl_scene_billboards *image,
                              fxl_sprite *to)
{
    if ((from->bits != 1 && from->bits != 4 && from->bits != 8) || from->key > FXL_SPRITE_OPAQUE) {
        return FXL_E_RANGE;
    }
    if (from->reserved != 0 || (from->bits == 8 && from->colours != 0)) {
        return FXL_E_RESERVED;
    }
    memset(to, 0, sizeof *to);
    to->width = from->pixel_width;
    to->height = from->pixel_height;
    to->bits = from->bits;
    to->key = from->key;
    const uint64_t bytes = fxl_multiply_u32((uint32_t)fxl_sprite_row_bytes(to), to->height);
    if (!lies_in(from->pixels, bytes, image->pixel_bytes) ||
        (from->bits != 8 && !lies_in(from->colours, 1u << from->bits, image->pixel_bytes))) {
        return FXL_E_OFFSET;
    }
    to->pixels = image->pixels + from->pixels;
    to->colours = from->bits != 8 ? image->pixels + from->colours : NULL;
    return FXL_OK;
}

/* place field: what sets the pointer to billboards; their checks */
/* billboards 5.1 */
FXL_COLD fxl_status fxl_billboards_open(const fxl_scene_image *image, fxl_sprite *sprites,
                                        fxl_billboard *boards, uint32_t capacity,
                                        fxl_billboard_set *set, fxl_scene_fault *fault)
{
    if (image == NULL || sprites == NULL || boards == NULL || set == NULL ||
        image->billboards.model_map == NULL) {
        return fxl_fault_at(fault, "billboards", 0, FXL_E_ARGUMENT);
    }
    if (!fxl_is_aligned(sprites, FXL_POINTER) || !fxl_is_aligned(boards, FXL_POINTER)) {
        return fxl_fault_at(fault, "billboard table", 0, FXL_E_ALIGNMENT);
    }
    const fxl_scene_billboards *from = &image->billboards;
    if (from->count > capacity) {
        return fxl_fault_at(fault, "billboard table", 0, FXL_E_CAPACITY);
    }
    for (uint32_t i = 0; i < from->count; i++) {
        const fxl_scene_billboard *one = &from->billboards[i];
        const fxl_status status = make_sprite(one, from, &sprites[i]);
        if (status != FXL_OK) {
            return fxl_fault_at(fault, "billboard", i, status);
        }
        boards[i].sprite = &sprites[i];
        boards[i].width = one->width;
        boards[i].height = one->height;
        boards[i].anchor_x = one->anchor_x;
        boards[i].anchor_y = one->anchor_y;
    }
    fxl_billboard_set found;
    memset(&found, 0, sizeof found);
    found.billboards = boards;
    found.count = from->count;
    found.model_map = from->model_map;
    const fxl_status status = fxl_billboards_check(&found, &image->scene, fault);
    if (status == FXL_OK) {
        *set = found;
    }
    return status;
}

static bool has_bits(const fxl_sprite *sprite)
{
    return sprite->bits == 1 || sprite->bits == 4 || sprite->bits == 8;
}

static bool is_side(fxl_q16_16 side, fxl_q16_16 anchor)
{
    return side >= 1 && side <= FXL_BILLBOARD_SIDE_MAX && anchor >= 0 && anchor <= side;
}

/* billboards 1.2 */
static FXL_COLD fxl_status check_billboard(const fxl_billboard *billboard)
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
/* billboards 1.1 */
static uint64_t square_beyond(fxl_q16_16 side, fxl_q16_16 anchor)
{
    const fxl_q16_16 rest = side - anchor;
    const uint32_t part = (uint32_t)(rest > anchor ? rest : anchor);
    return fxl_multiply_u32(part, part);
}

/* The radius is below 2^31, so its square is below 2^62. */
/* billboards 1.1 */
static FXL_COLD fxl_status check_model(const fxl_model *model, const fxl_billboard *billboard)
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

FXL_COLD fxl_status fxl_billboards_check(const fxl_billboard_set *set, const fxl_scene *scene,
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

/* --- columns ----------------------------------------------------------------------------------- */

/* What the columns of a billboard show is looked up once for all rows that repeat a row of texels.
 * This knows entries of the palette, and no pixels. */
void fxl_billboard_find_texels(const fxl_billboard_row *row, fxl_billboard_columns *columns)
{
    const uint32_t count = (uint32_t)(row->columns.end - row->columns.first);
    fxl_texel_walk along = row->along;
    for (uint32_t i = 0; !columns->has_texels && i < count; i++) {
        columns->texels[i] = (uint16_t)along.texel;
        fxl_take_step(&along);
    }
    columns->has_texels = true;
}

/* The value of a texel of a row. bits: of the sprite, or 8 for any. */
static inline uint32_t value_of(const fxl_billboard_row *row, uint32_t texel, uint32_t bits)
{
    return bits == 4 ? (uint32_t)row->texels[texel >> 1] >> (4u * (~texel & 1u)) & 15u
                     : fxl_sprite_value(row->sprite, row->texels, texel, row->shift);
}

/* Each texel once, for all its columns. A run ends where a hole begins, or the columns end: the list
 * has at most one end more than there are columns. bits: of the sprite, or 8 for any. */
/* billboards 3.2 */
static inline __attribute__((always_inline)) void find_entries(const fxl_billboard_row *row,
                                                               uint32_t count,
                                                               fxl_billboard_columns *columns,
                                                               uint32_t bits)
{
    const uint32_t key = row->sprite->key;
    uint32_t last = UINT32_MAX, ends = 0;
    uint8_t entry = 0;
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t texel = columns->texels[i];
        if (texel != last) {
            const uint32_t value = value_of(row, texel, bits);
            if ((value != key) != (ends & 1u)) {
                columns->runs[ends++] = (uint8_t)i;
            }
            entry = value != key ? fxl_sprite_colour(row->sprite, value) : 0;
        }
        last = texel;
        columns->entries[i] = entry;
    }
    if (ends & 1u) {
        columns->runs[ends++] = (uint8_t)count;
    }
    columns->ends = (uint8_t)ends;
}

/* Entries may be bytes of the sprite to the compiler, so it has a copy. */
void fxl_billboard_find_entries(const fxl_billboard_row *row, fxl_billboard_columns *columns)
{
    const fxl_sprite sprite = *row->sprite;
    fxl_billboard_row copy = *row;
    const uint32_t count = (uint32_t)(row->columns.end - row->columns.first);
    copy.sprite = &sprite;
    if (!FXL_IS_COMPACT && sprite.bits == 4) {
        find_entries(&copy, count, columns, 4);
    } else {
        find_entries(&copy, count, columns, 8);
    }
}
