/* SPDX-License-Identifier: MIT */
/* Formulas of equations.smt2 and roundings.gappa beside the functions that they were written from, as in math/formulas.c. */
#include "view/project.c"
#include "math/arith.c"

#include "enumeration.h"
#include "formula.h"

#define WIDEST (((int64_t)1 << 61) - 1) /* of a side and a depth */

/* A depth of the view, of all lengths, often of the most, and how far it is shifted down to have 31 bits. */
static int64_t any_depth(int *shift)
{
    const int64_t least = draw() >> 40 & 3 ? FXL_PROJECT_DEPTH_MIN : (int64_t)1 << 60;
    const int64_t depth = least + (int64_t)up_to((uint64_t)(WIDEST - least));
    *shift = 33 - __builtin_clzll((uint64_t)depth);
    return depth;
}

static uint32_t scaled_by(int64_t depth, int shift)
{
    return (uint32_t)(((depth >> (shift - 1)) + 1) >> 1);
}

/* Of a lens of any screen, and for the fast path where its focal length allows that. */
static fxl_projection projection_of(int32_t focal)
{
    const fxl_lens small = {.focal = focal, .width = 2, .height = 2};
    const fxl_lens lens = {.focal = focal, .width = (uint16_t)(up_to(FXL_SCREEN_MAX - 1) + 1), .height = (uint16_t)(up_to(FXL_SCREEN_MAX - 1) + 1)};
    fxl_projection fast, projection;
    fxl_projection_from_lens(&small, &fast);
    fxl_projection_from_lens(&lens, &projection);
    projection.depth_min = fast.depth_min;
    return projection;
}

/* Where fxl_project_any has a side, from the middle; as both coordinates, whose signs differ. */
static int32_t placed(int32_t focal, int64_t side, int64_t depth)
{
    const fxl_projection projection = projection_of(focal);
    const fxl_view_point point = {side, side, depth};
    fxl_screen_point screen = {0, 0};
    HOLDS(side, fxl_project_any(&projection, &point, &screen) == FXL_OK);
    HOLDS(side, screen.x - projection.centre_x == projection.centre_y - screen.y);
    return screen.x - projection.centre_x;
}

/* [[row]]
 * id = "fxl_project_any beside its formula"
 * function = "fxl_project_any"
 * property = "the formula's quotient, which is as near as it claims, of a million points within 512 pixels of the middle"
 * checks = 1000000
 * formula = "projection by Gappa"
 */
/* [[row]]
 * id = "project_side beside its formula"
 * function = "project_side"
 * property = "the same"
 * checks = 1000000
 * formula = "projection by Gappa"
 */
/* [[row]]
 * id = "scale_product beside its formula"
 * function = "scale_product"
 * property = "the same"
 * checks = 1000000
 * formula = "projection by Gappa"
 */
/* [[row]]
 * id = "scale_depth beside its formula"
 * function = "scale_depth"
 * property = "the same"
 * checks = 1000000
 * formula = "projection by Gappa"
 */
void enumerate_quotient(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        int shift;
        const int64_t depth = any_depth(&shift);
        const int32_t focal = (int32_t)up_to((1 << 29) - 2) + 1;
        const wide most = ((wide)depth << 25) / focal;
        const int64_t side = between((int64_t)(most < WIDEST ? most : WIDEST));
        const real F = focal, X = (real)side / ((wide)1 << shift), Z = (real)depth / ((wide)1 << shift);
        TRY(side, quotient_assumed && quotient_holds && placed(focal, side, depth) == quotient_q);
        /* Any side: refused exactly where it lies outside the screen's coordinates. */
        const fxl_projection projection = projection_of(focal);
        const fxl_view_point far = {between(WIDEST), 0, depth};
        const wide d = scaled_by(depth, shift), limit = FXL_SCREEN_COORDINATE_MAX * d, product = floor_of((wide)focal * far.x, (wide)1 << shift) + projection.centre_x * d;
        fxl_screen_point screen;
        HOLDS(far.x, (fxl_project_any(&projection, &far, &screen) == FXL_OK) == (product >= -limit && product <= limit));
    }
}

/* Of a vertex and a lens: the numbers of a formula. (x, z) is the exact point, beside (X, Z). */
static real F, X, Z, x, z;

/* Draws them: the side is at most the depth less its share, and the exact point off by up to `most` units of the depth. Where
 * fxl_project_any has the side. */
static int32_t any_vertex(int64_t share, int64_t most, real unit)
{
    int shift;
    const int64_t depth = any_depth(&shift), side = between(depth - depth / share);
    const int32_t focal = (int32_t)up_to((1 << 25) - 1) + 1;
    F = focal;
    X = (real)side / ((wide)1 << shift);
    Z = (real)depth / ((wide)1 << shift);
    x = X + Z * between(most) * unit;
    z = Z + Z * between(most) * unit;
    return placed(focal, side, depth);
}

/* [[row]]
 * id = "clipped vertices beside their formula"
 * function = "fxl_project_any"
 * property = "the formula's coordinate, which is as near as it claims, of a million points and of points beside them"
 * checks = 1000000
 * formula = "clipped vertex by Gappa"
 */
void enumerate_clipped(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const int32_t found = any_vertex(1000000000, 945, 1e-13Q);
        TRY(i, clipped_assumed && clipped_holds && found == clipped_q);
    }
}

/* [[row]]
 * id = "vertices beside their formula"
 * function = "fxl_project_any"
 * property = "the same, of points as far as the matrix may move them"
 * checks = 1000000
 * formula = "vertex by Gappa"
 */
void enumerate_vertex(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const int32_t found = any_vertex(10000000, 559, 1e-11Q);
        TRY(i, vertex_assumed && vertex_holds && found == vertex_q);
    }
}

/* [[row]]
 * id = "scale_of beside its formula"
 * function = "scale_of"
 * property = "both quotients and their rests are the formula's, and the scale is within one unit, of a million depths and lenses"
 * checks = 1000000
 * formula = "scale_of bound"
 */
void enumerate_scale(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const int32_t focal = (int32_t)up_to((1 << 26) - 2) + 1;
        const uint32_t depth = ((uint32_t)1 << 30) + (uint32_t)up_to(1 << 30);
        const fxl_projection projection = projection_of(focal);
        const wide F = (wide)focal * 4, d = depth, D = d >> 15, f = d & 32767, g = 4 * F / D, r = 4 * F % D, rest = scale_rest_of_first;
        const wide size = rest < 0 ? -rest : rest, k = size / D, t = size % D, G = scale_of(&projection, depth);
        TRY(depth, scale_of_parts && scale_first && scale_second && G == scale_scale && scale_near);
    }
}

/* [[row]]
 * id = "scale_of beside its formula on reals"
 * function = "scale_of"
 * property = "the scale of the formula, which is as near as it claims, of a million depths and lenses"
 * checks = 1000000
 * formula = "scale_of by Gappa"
 */
void enumerate_reals(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const int32_t focal = (int32_t)up_to((1 << 26) - 2) + 1;
        const uint32_t scaled = ((uint32_t)1 << 30) + (uint32_t)up_to(1 << 30);
        const fxl_projection projection = projection_of(focal);
        const real depth = scaled, factor = projection.factor_2;
        TRY(scaled, reals_assumed && reals_holds && scale_of(&projection, scaled) == (reals_rest >= 0 ? reals_of_positive : reals_of_negative));
    }
}

/* A side of at most twice the depth; of the largest depths often one at which the quotient changes: the first whose product is
 * q d - h. */
static int64_t any_side(uint32_t factor, int64_t depth, int shift)
{
    const wide d = scaled_by(depth, shift), product = between(factor / 4) * d - d / 2;
    const wide change = -floor_of(-product * ((wide)1 << 32), factor);
    const int64_t most = 2 * depth > WIDEST ? WIDEST : 2 * depth;
    return shift == 30 && draw() >> 40 & 1 && change <= most && change >= -most ? (int64_t)change : between(most);
}

/* Any lens and depth of the fast path, and a side. */
static scaling any_scaling(int64_t *side)
{
    int shift;
    const int64_t depth = any_depth(&shift);
    const fxl_projection projection = projection_of((int32_t)up_to((1 << 26) - 2) + 1);
    const uint32_t scaled = scaled_by(depth, shift);
    const scaling by = {projection.factor, scaled, scale_of(&projection, scaled), (unsigned)(33 - shift)};
    *side = any_side(by.factor, depth, shift);
    return by;
}

/* [[row]]
 * id = "offset_of beside its formula"
 * function = "offset_of"
 * property = "the formula's offset, whose rest is below twice the depth, of a million sides"
 * checks = 1000000
 * formula = "offset_of bound"
 */
void enumerate_offset(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        int64_t side;
        const scaling by = any_scaling(&side);
        const wide moved = (wide)side * ((wide)1 << (by.zeros - 3)), F = by.factor, d = by.depth, G = by.scale;
        const wide x = floor_of(moved, (wide)1 << 32), l = floor_rest(moved, (wide)1 << 32), q = offset_estimate;
        HOLDS(side, offset_near && offset_left >= 0 && offset_left < 2 * d && offset_product == floor_of(F * moved, (wide)1 << 32));
        TRY(side, offset_of(&by, side) == offset_offset);
    }
}

/* [[row]]
 * id = "fxl_project_inside beside its formula"
 * function = "fxl_project_inside"
 * property = "both coordinates are the formula's, whose rest is within its claim, of a million points"
 * checks = 1000000
 * formula = "project_inside by Gappa"
 */
void enumerate_inside(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        int shift;
        const int64_t depth = any_depth(&shift);
        const fxl_projection projection = projection_of((int32_t)up_to((1 << 26) - 66000) + 65537);
        const fxl_view_point point = {any_side(projection.factor, depth, shift), any_side(projection.factor, depth, shift), depth};
        fxl_screen_point screen = {0, 0};
        HOLDS(i, projection.depth_min == FXL_PROJECT_DEPTH_MIN >> 32 && fxl_project_inside(&projection, &point, &screen) == FXL_OK);
        const uint32_t scaled = scaled_by(depth, shift);
        const int64_t sides[2] = {point.x, point.y}, found[2] = {screen.x - projection.centre_x, projection.centre_y - screen.y};
        for (int j = 0; j < 2; j++) {
            const real f = projection.factor, d = scaled, g = scale_of(&projection, scaled), side = (real)sides[j] * ((wide)1 << (30 - shift));
            HOLDS(i, inside_assumed && inside_holds && found[j] == inside_k + (inside_rest >= d));
        }
        tried += 1;
    }
}
