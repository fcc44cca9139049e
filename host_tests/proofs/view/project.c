/* SPDX-License-Identifier: MIT */
#include "view/project.c"
#include "products.h"

/* [[row]]
 * function = "fxl_projection_from_lens"
 * property = "nothing overflows, and each member is in its range"
 * checks = 256
 * contract = true
 */
void prove_projection_from_lens(void)
{
    fxl_lens *lens;
    fxl_projection *projection;
    fxl_projection_from_lens(lens, projection);
    PROOF_ENDS();
}

/* [[row]]
 * function = "scale_depth"
 * property = "a depth of 31 bits, and a shift of 7 to 30"
 * checks = 9
 */
void prove_scale_depth(void)
{
    const int64_t z = nondet_s64();
    ASSUME(z >= FXL_PROJECT_DEPTH_MIN && z < (int64_t)1 << 61);
    const scaled_depth scaled = scale_depth(z);
    ASSERT("depth", scaled.depth >= 1u << 30 && scaled.depth <= 1u << 31);
    ASSERT("shift", scaled.shift >= 7 && scaled.shift <= 30);
    PROOF_ENDS();
}

/* [[row]]
 * function = "project_side"
 * property = "nothing overflows, the quotient fits, and a coordinate is below 2^28"
 * checks = 140
 * contract = true
 * uses = ["fxl_divide_round"]
 */
void prove_project_side(void)
{
    scaled_depth *scaled;
    int32_t *coordinate;
    (void)project_side(nondet_s32(), nondet_s64(), scaled, nondet_s32(), coordinate);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_project_any"
 * property = "nothing overflows for any point of the view"
 * checks = 278
 * contract = true
 * uses = ["project_side"]
 */
void prove_project_any(void)
{
    fxl_projection *projection;
    fxl_view_point *view;
    fxl_screen_point *screen;
    (void)fxl_project_any(projection, view, screen);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_project_visible"
 * property = "any projection and point of the view: nothing overflows, and the kernel gets points whose sides are at most twice their depth"
 * checks = 389
 * contract = true
 * stands_in = { fxl_project_any = "any_projection", fxl_project_inside = "any_inside" }
 */
void prove_project_visible(void)
{
    fxl_projection *projection;
    fxl_view_point *view;
    fxl_screen_point *screen;
    (void)fxl_project_visible(projection, view, screen);
    PROOF_ENDS();
}

/* --- by a reciprocal ------------------------------------------------------------------------------------ */

/* [[row]]
 * function = "scale_of"
 * property = "any projection and depth: no division by less than 2^15"
 * checks = 29
 */
void prove_scale_of(void)
{
    fxl_projection projection;
    const uint32_t depth = nondet_u32();
    ASSUME(FXL_PROJECTION(&projection) && projection.depth_min != INT32_MAX && depth >= 1u << 30 && depth <= 1u << 31);
    (void)scale_of(&projection, depth);
    PROOF_ENDS();
}

static bool is_scaling(const scaling *by, int64_t side)
{
    return by->zeros >= 3 && by->zeros <= 26 && by->depth >= 1u << 30 && by->depth <= 1u << 31 && by->factor >= 4 && by->factor < 1u << 28 &&
           WITHIN(side, (int64_t)1 << (65 - by->zeros));
}

/* [[row]]
 * function = "offset_of"
 * property = "any side of at most twice the depth: nothing overflows"
 * checks = 100
 */
void prove_offset_of(void)
{
    scaling by;
    const int64_t side = nondet_s64();
    ASSUME(is_scaling(&by, side) && by.scale <= 1u << 30);
    ASSERT("below 2^28 pixels", WITHIN(offset_of(&by, side), (1 << 28) + 1));
    PROOF_ENDS();
}

/* For offset_of: what its own row assumes, but for the scale, and asserts. */
int32_t any_offset(const scaling *by, int64_t side)
{
    const int32_t offset = nondet_s32();
    ASSERT("a side and its depth", is_scaling(by, side));
    ASSUME(WITHIN(offset, (1 << 28) + 1));
    return offset;
}

/* For fxl_project_any: what its contract says. */
fxl_status any_projection(const fxl_projection *projection, const fxl_view_point *view, fxl_screen_point *screen)
{
    const int64_t limit = ((int64_t)1 << 61) - 1;
    ASSERT("a projection, and in the view", FXL_PROJECTION(projection) && FXL_POINT_BELOW(view, limit));
    if (nondet_bool()) {
        return FXL_E_RANGE;
    }
    const int32_t x = nondet_s32(), y = nondet_s32();
    screen->x = x;
    screen->y = y;
    return FXL_OK;
}

/* [[row]]
 * function = "fxl_project_inside"
 * property = "any projection, and any point whose sides are at most twice its depth: nothing overflows, every shift is in its range, and the divisions get what they take"
 * checks = 331
 * stands_in = { fxl_project_any = "any_projection", offset_of = "any_offset" }
 * narrows = "it takes over a minute of CPU time with the check"
 */
void prove_project_inside(void)
{
    fxl_projection projection;
    fxl_view_point view;
    fxl_screen_point screen;
    ASSUME(FXL_PROJECTION(&projection) && view.z > 0 && view.z < (int64_t)1 << 61);
    ASSUME(WITHIN(view.x, 2 * view.z) && WITHIN(view.y, 2 * view.z));
    ASSUME(WITHIN(view.x, ((int64_t)1 << 61) - 1) && WITHIN(view.y, ((int64_t)1 << 61) - 1));
    const fxl_status status = fxl_project_inside(&projection, &view, &screen);
    ASSERT("its statuses", status == FXL_OK || status == FXL_E_RANGE);
    PROOF_ENDS();
}

/* For fxl_project_inside: what its own row assumes. */
fxl_status any_inside(const fxl_projection *projection, const fxl_view_point *view, fxl_screen_point *screen)
{
    ASSERT("inside", view->z > 0 && WITHIN(view->x, 2 * view->z) && WITHIN(view->y, 2 * view->z));
    return any_projection(projection, view, screen);
}

static fxl_lens any_lens(void)
{
    fxl_lens lens;
    ASSUME(lens.width >= 1 && lens.width <= FXL_SCREEN_MAX && lens.height >= 1 && lens.height <= FXL_SCREEN_MAX && lens.focal > 0 &&
           lens.focal < 1 << 29);
    return lens;
}

/* [[row]]
 * function = "fxl_project_point"
 * property = "any lens and point of the view: nothing overflows"
 * checks = 241
 * stands_in = { fxl_project_visible = "any_projection" }
 */
void prove_project_point(void)
{
    const fxl_lens lens = any_lens();
    fxl_view_point view;
    fxl_screen_point screen;
    ASSUME(FXL_POINT_BELOW(&view, ((int64_t)1 << 61) - 1));
    (void)fxl_project_point(&lens, &view, &screen);
    PROOF_ENDS();
}

/* --- results, of products and quotients that may be any ------------------------------------------------- */


/* [[row]]
 * function = "scale_depth"
 * id = "scale_depth, its result"
 * property = "the depth to the nearest of 2^shift, halves upward, where its highest bit is bit 30"
 * checks = 15
 */
void prove_scale_depth_result(void)
{
    const int64_t z = nondet_s64();
    ASSUME(z >= FXL_PROJECT_DEPTH_MIN && z < (int64_t)1 << 61);
    const scaled_depth scaled = scale_depth(z);
    ASSERT("its highest bit", z >> scaled.shift >> 30 == 1);
    ASSERT("the nearest", scaled.depth == (uint32_t)((z + ((int64_t)1 << (scaled.shift - 1))) >> scaled.shift));
    PROOF_ENDS();
}

/* [[row]]
 * function = "scale_product"
 * property = "the floor of the product of both words, over 2^shift; refused where that has more than 63 bits with its sign, and only there"
 * checks = 24
 * stands_in = { fxl_multiply_u32 = "any_unsigned", fxl_multiply_s32 = "any_signed" }
 * stubs = { fxl_multiply_u32 = "C's product of two words" }
 */
void prove_scale_product(void)
{
    const int32_t focal = nondet_s32();
    const int64_t side = nondet_s64();
    const uint32_t shift = nondet_u32();
    int64_t product = 7;
    ASSUME(focal > 0 && focal < 1 << 29 && WITHIN(side, ((int64_t)1 << 61) - 1) && shift >= 2 && shift < 32);
    const int64_t high = any_signed(focal, (int32_t)(side >> 32));
    const uint64_t low = any_unsigned((uint32_t)focal, fxl_low_32(fxl_bits_64(side)));
    ASSUME(WITHIN(high, (int64_t)1 << 58) && low < (uint64_t)1 << 61);
    const wide exact = ((wide)high * ((wide)1 << 32) + low) >> shift;
    const bool fits = exact >= -((wide)1 << 62) && exact < (wide)1 << 62;
    ASSERT("whether it fits", scale_product(focal, side, shift, &product) == fits);
    ASSERT("the floor, or untouched", product == (fits ? (int64_t)exact : 7));
    PROOF_ENDS();
}

int64_t __CPROVER_uninterpreted_scaled(int32_t, int64_t, unsigned);

/* For scale_product: its row says what it is. */
bool any_scaled(fxl_q16_16 focal, fxl_q18_46 side, unsigned shift, int64_t *product)
{
    ASSERT("its range", focal > 0 && focal < 1 << 29 && WITHIN(side, ((int64_t)1 << 61) - 1) && shift >= 2 && shift < 32);
    *product = __CPROVER_uninterpreted_scaled(focal, side, shift);
    return WITHIN(*product, ((int64_t)1 << 62) - 1);
}

/* [[row]]
 * function = "project_side"
 * id = "project_side, its result"
 * property = "the scaled product and the centre times the depth, over the depth, to the nearest; refused beyond the range of the screen, and only there"
 * checks = 61
 * stands_in = { scale_product = "any_scaled", fxl_multiply_su32 = "any_mixed", fxl_divide_round = "any_down" }
 */
void prove_project_side_result(void)
{
    const int32_t focal = nondet_s32(), centre = nondet_s32();
    const int64_t side = nondet_s64();
    scaled_depth scaled;
    int32_t coordinate = 7;
    ASSUME(focal > 0 && focal < 1 << 29 && WITHIN(side, ((int64_t)1 << 61) - 1) && WITHIN(centre, 512 * 65536));
    ASSUME(scaled.depth >= 1u << 30 && scaled.depth <= 1u << 31 && scaled.shift >= 7 && scaled.shift <= 30);
    const int64_t product = __CPROVER_uninterpreted_scaled(focal, side, scaled.shift), middle = any_mixed(centre, scaled.depth);
    const int64_t most = any_mixed(FXL_SCREEN_COORDINATE_MAX, scaled.depth);
    ASSUME(WITHIN(middle, (int64_t)1 << 56) && most > 0 && most < (int64_t)scaled.depth << 29);
    const bool fits = WITHIN(product, ((int64_t)1 << 62) - 1) && WITHIN(product + middle, most);
    ASSERT("whether it is on the screen", project_side(focal, side, &scaled, centre, &coordinate) == fits);
    ASSERT("the nearest, or untouched", coordinate == (fits ? any_down(product + middle, scaled.depth) : 7));
    PROOF_ENDS();
}
