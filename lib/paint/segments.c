/* SPDX-License-Identifier: MIT */
#include "segments.h"
#include "texel_place.h"
#include "texture_level.h"

#include "../math/arith.h"

/* value * 2^62 / weight, shifted to the right by 62 - shift, is in units of 2^-16. The upper word
 * of the product is shifted by 32 less, and by less for less fraction. */
static int32_t drop_of(int shift, int fraction)
{
    return 46 - shift - fraction;
}

/* A weight from which on no product is shifted to the left: the weight's leading zeros are at most
 * the drop and 32. */
static int32_t weight_for(int32_t drop)
{
    return drop >= -2 ? 2 : drop < -31 ? INT32_MAX : (int32_t)1 << (-1 - drop);
}

/* Before what two functions share of which a small program has one. */
#if FXL_IS_SMALL
#define OF_ONE static inline __attribute__((always_inline))
#else
#define OF_ONE FXL_APART
#endif

static int32_t smaller(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

/* A texture's columns wrap in 2^log_width. */
static bool is_common(const fxl_paint *paint)
{
    const fxl_texture_level *level = &paint->level;
    return level->texels != NULL && level->log_width >= FXL_SEGMENT_LOG_MIN;
}

/* place stipple: the pattern as bits, 4 x 4; what kernels paint */
uint32_t fxl_stipple_of(uint32_t opacity)
{
    uint32_t pattern = 0;
    for (int32_t i = 0; i < 16; i++) {
        pattern |= (uint32_t)!fxl_is_stippled_away(opacity, i & 3, i >> 2) << i;
    }
    return pattern;
}

static inline bool is_plain(const fxl_paint *paint, uint32_t flags)
{
    return flags == 0 && paint->level.colours == NULL && paint->opacity == 16;
}

static void find_light(const fxl_paint *paint, fxl_segment_face *face)
{
    const fxl_gradients *gradients = paint->gradients;
    const fxl_gradient *light = &gradients->attributes[FXL_SEGMENT_LIGHT];
    face->light_step = (int32_t)(light->along * 16 >> 32);
    face->light_drop = drop_of(gradients->shifts[FXL_SEGMENT_LIGHT], 8);
    face->light_max = 256 * paint->levels_less_1 + 255;
    face->drop_min = smaller(face->drop_min, face->light_drop);
}

/* The least weights: those of the rule, and from which on no product is shifted to the left.
 * Returns whether there is a weight that suffices. */
/* surfaces 2.1 */
static inline bool find_least(const fxl_paint *paint, const uint8_t *ramp, fxl_segment_face *face)
{
    const bool is_line = face->is_constant && ramp == NULL;
    const uint32_t by_drop = (uint32_t)weight_for(face->drop_min - (is_line ? FXL_ROW_BITS : 0));
    face->least[3] = by_drop;
    if (is_line) { /* it has no segments */
        face->least[0] = face->least[1] = face->least[2] = by_drop;
        return by_drop < INT32_MAX;
    }
    fxl_find_least_weights(paint->gradients, paint->division, face->least);
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t least = face->least[i] < by_drop ? by_drop : face->least[i];
        face->least[i] = least > INT32_MAX ? INT32_MAX : least;
    }
    if (ramp != NULL) {
        face->least[3] = face->least[2];
    }
    return face->least[3] < INT32_MAX;
}

/* place sampling: positions in a segment, and their texels: keys, patterns, 4 bits too */
/* by_row: for small_row.h, which needs nothing of the texels. */
OF_ONE bool find(const fxl_paint *paint, bool by_row, fxl_segment_face *face)
{
    const fxl_gradients *gradients = paint->gradients;
    const uint32_t log_width = paint->level.log_width;
    const uint32_t log_height = fxl_bit_length(paint->level.rows_less_1);
    const uint32_t log = log_width > log_height ? log_width : log_height;
    const uint8_t *ramp = by_row ? NULL : paint->ramp;
    face->u_step = gradients->attributes[FXL_ATTRIBUTE_U].along * 16;
    face->v_step = gradients->attributes[FXL_ATTRIBUTE_V].along * 16;
    face->u_drop = drop_of(gradients->shifts[FXL_ATTRIBUTE_U], 20 - (int)log_width);
    face->v_drop = drop_of(gradients->shifts[FXL_ATTRIBUTE_V], 20 - (int)log);
    face->drop_min = smaller(face->u_drop, face->v_drop);
    face->log_width = (uint8_t)log_width;
    face->is_constant = gradients->weight.along == 0 && paint->division != FXL_DIVIDE_1;
    face->kind = FXL_TEXELS_PLAIN;
    if (by_row) {
        face->log = (uint8_t)log;
        return find_least(paint, ramp, face);
    }
    face->weight_step = gradients->weight.along * 16;
    face->texels = paint->level.texels;
    face->rows_mask = paint->level.rows_less_1 << log_width;
    face->row_drop = (uint8_t)(16 - log - log_width);
    face->form = (uint8_t)(log_width == log ? log_width - FXL_SEGMENT_LOG_MIN : 0);
    face->ramp = paint->ramp;
    face->light_step = face->light_drop = face->light_max = 0;
    if (ramp != NULL) {
        find_light(paint, face);
    }
    face->palette = NULL;
    face->in_beam = NULL;
    face->table = paint->table;
    return find_least(paint, ramp, face);
}

/* Has the kernel paint texels that are clamped, keyed, stippled or of 4 bits, one of these. key: of
 * such texels; leaves_out: pixels may be left out, as nothing follows the kernel that changes its
 * pixels. Returns false if the kernel cannot: nor does it paint a face that a beam may split, as
 * such texels in the beam are painted by C, which rounds otherwise: the texture would jump at the
 * beam's border. Requires a face that is not plain. */
OF_ONE bool find_kind(const fxl_paint *paint, uint32_t flags, uint32_t key, bool leaves_out,
                      bool by_row, fxl_segment_face *face)
{
    if (paint->has_beams) {
        return false;
    }
    const bool is_keyed = flags == FXL_TEXTURE_KEYED, is_stippled = paint->opacity < 16;
    const bool has_4_bits = paint->level.colours != NULL;
    if (flags == FXL_TEXTURE_CLAMP && !is_stippled && !has_4_bits && face->log_width >= 5 &&
        paint->level.rows_less_1 == paint->level.columns_less_1 && paint->ramp == NULL) {
        face->kind = FXL_TEXELS_CLAMPED;
        face->form = 0;
        face->is_constant = false; /* the least weight of a line suffices for segments of 16 */
        return true;
    }
    if ((flags != 0 && !is_keyed) || is_keyed + is_stippled + has_4_bits != 1 ||
        paint->ramp != NULL || (!leaves_out && !has_4_bits)) {
        return false;
    }
    if (by_row) {
        return true;
    }
    face->form = 0;
    if (has_4_bits) {
        face->kind = FXL_TEXELS_4;
        face->colours = paint->level.colours;
    } else if (is_keyed) {
        face->kind = FXL_TEXELS_KEYED;
        face->key = key;
    } else {
        face->kind = FXL_TEXELS_STIPPLED;
        face->stipple = fxl_stipple_of(paint->opacity);
    }
    return true;
}

bool fxl_segments_find(const fxl_paint *paint, fxl_segment_face *face)
{
    const uint32_t flags = paint->level.flags;
    return is_common(paint) && paint->blend == NULL && paint->division != FXL_DIVIDE_1 &&
           find(paint, false, face) && /* paint_divided.h */
           (is_plain(paint, flags) ||
            find_kind(paint, flags, paint->level.key, paint->in_beam == NULL, false, face));
}

bool fxl_segments_find_565(const fxl_paint *paint, fxl_segment_face *face)
{
    const fxl_paint_565 *of = &paint->of_565;
    const bool is_565 = (paint->level.flags & FXL_LEVEL_565) != 0;
    const uint32_t flags = paint->level.flags & ~(FXL_LEVEL_565 | FXL_LEVEL_IN_BEAM);
    const bool is_in_beam = !is_565 && (paint->level.flags & FXL_LEVEL_IN_BEAM) != 0;
    if (!is_common(paint) || paint->ramp != NULL || of->sixteenths != 0 || of->adds ||
        !find(paint, FXL_IS_SMALL, face) ||
        (!is_plain(paint, flags) &&
         !find_kind(paint, flags, of->key, is_565 && !paint->is_evenly_lit, FXL_IS_SMALL, face))) {
        return false;
    }
    if (FXL_IS_SMALL) {
        return true;
    }
    face->palette = is_565 ? NULL : of->palette;
    if (is_in_beam) {
        face->in_beam = paint->in_beam;
        face->form = 0;
    }
    return true;
}

#if FXL_RECIPROCAL_IS_APART

fxl_reciprocal fxl_reciprocal_of(uint32_t weight)
{
    return fxl_reciprocal_in_place(weight);
}

#endif

void fxl_divide_row_at(const fxl_paint *paint, const fxl_paint_row *row, int32_t x,
                       int32_t values[FXL_ATTRIBUTES])
{
    const fxl_gradients *gradients = paint->gradients;
    const fxl_reciprocal reciprocal = fxl_reciprocal_of(fxl_row_weight_at(paint, row, x));
    for (uint32_t i = 0; i < gradients->count; i++) {
        values[i] =
            fxl_attribute_of(fxl_row_value_at(row->attributes[i], &gradients->attributes[i], x),
                             &reciprocal, gradients->shifts[i]);
    }
}
