/* SPDX-License-Identifier: MIT */
#include "draw/orthographic.c"
#include "products.h"

static fxl_lens any_lens(void)
{
    fxl_lens lens;
    ASSUME(lens.focal >= FXL_ORTHOGRAPHIC_SCALE_MIN && lens.focal <= FXL_ORTHOGRAPHIC_SCALE_MAX);
    ASSUME(lens.width >= 1 && lens.width <= FXL_SCREEN_MAX && lens.height >= 1 && lens.height <= FXL_SCREEN_MAX);
    ASSUME(WITHIN(lens.centre_x - lens.width * (int64_t)32768, FXL_ORTHOGRAPHIC_CENTRE_MAX));
    ASSUME(WITHIN(lens.centre_y - lens.height * (int64_t)32768, FXL_ORTHOGRAPHIC_CENTRE_MAX));
    return lens;
}

/* [[row]]
 * function = "lib/draw/orthographic.c:is_valid"
 * id = "orthographic-is-valid"
 * property = "any lens of a screen: nothing overflows, and the scale and the centre of a valid one are in range"
 * checks = 45
 */
void prove_is_valid(void)
{
    fxl_lens lens;
    ASSUME(lens.width <= FXL_SCREEN_MAX && lens.height <= FXL_SCREEN_MAX);
    ASSERT("its scale and centre", !is_valid(&lens) || (lens.focal >= 4096 && lens.focal <= 1 << 28 && lens.inset == 0 &&
                                                        WITHIN(lens.centre_x, 2048 * 65536) && WITHIN(lens.centre_y, 2048 * 65536)));
    PROOF_ENDS();
}

/* [[row]]
 * function = "units_of"
 * property = "any offset of a lens's centre: nothing overflows, and the quotient fits"
 * checks = 18
 * stands_in = { fxl_divide_round = "any_down" }
 */
void prove_units_of(void)
{
    const fxl_lens lens = any_lens();
    const int64_t offset = nondet_s64();
    ASSUME(WITHIN(offset, FXL_ORTHOGRAPHIC_CENTRE_MAX));
    (void)units_of(offset, &lens);
    PROOF_ENDS();
}

/* [[row]]
 * function = "moved_by"
 * property = "any place, ways and rows: nothing overflows, and the sum is below 2^33"
 * checks = 9
 */
void prove_moved_by(void)
{
    const fxl_q16_16 from = nondet_s32();
    const int64_t right = nondet_s32(), up = nondet_s32();
    const fxl_q2_30 by_right = nondet_s32(), by_up = nondet_s32();
    ASSUME(WITHIN(from, FXL_COORDINATE_MAX) && WITHIN(by_right, FXL_Q2_30_ONE) && WITHIN(by_up, FXL_Q2_30_ONE));
    ASSERT("below 2^33", WITHIN(moved_by(from, right, by_right, up, by_up), (int64_t)1 << 33));
    PROOF_ENDS();
}

/* Of a lens and a pose: what its eye was moved by is below 2^61. */
static fxl_view any_view(void)
{
    fxl_view view;
    view.lens = any_lens();
    ASSUME(WITHIN(view.frustum.planes[FXL_ALONG_RIGHT].distance, ((int64_t)1 << 61) - 1));
    ASSUME(WITHIN(view.frustum.planes[FXL_ALONG_UP].distance, ((int64_t)1 << 61) - 1));
    return view;
}

static fxl_view_point any_point(void)
{
    fxl_view_point point;
    ASSUME(WITHIN(point.x, ((int64_t)1 << 61) - 1) && WITHIN(point.y, ((int64_t)1 << 61) - 1));
    return point;
}

/* [[row]]
 * function = "fxl_project_orthographic"
 * property = "any point of the view: nothing overflows, and what is answered is within the range of screen coordinates"
 * checks = 60
 */
void prove_project_orthographic(void)
{
    const fxl_view view = any_view();
    const fxl_view_point point = any_point();
    fxl_screen_point screen;
    const fxl_status status = fxl_project_orthographic(&view, &point, &screen);
    ASSERT("in range", status != FXL_OK || (WITHIN(screen.x, FXL_SCREEN_COORDINATE_MAX) && WITHIN(screen.y, FXL_SCREEN_COORDINATE_MAX)));
    PROOF_ENDS();
}

/* The scale times a coordinate, by its words. */
static wide product_of(int32_t scale, int64_t across)
{
    const int64_t high = any_signed(scale, (int32_t)(across >> 32));
    const uint64_t low = any_unsigned((uint32_t)scale, fxl_low_32(fxl_bits_64(across)));
    ASSUME(WITHIN(high, (int64_t)1 << 58) && low < (uint64_t)1 << 60);
    return (wide)high * ((wide)1 << 32) + low;
}

/* [[row]]
 * function = "fxl_project_orthographic"
 * id = "fxl_project_orthographic, its result"
 * property = "each coordinate is at most half of 1/65536 pixel from the centre and the scale times that from the pose's eye, of which the products of words are exact"
 * checks = 60
 * stands_in = { fxl_multiply_u32 = "any_unsigned", fxl_multiply_s32 = "any_signed" }
 * stubs = { fxl_multiply_u32 = "C's product of two words" }
 * clause = "orthographic 2.6a"
 */
void prove_project_orthographic_result(void)
{
    const fxl_view view = any_view();
    const fxl_view_point point = any_point();
    const wide half = (wide)1 << 45;
    const wide right = product_of(view.lens.focal, point.x + view.frustum.planes[FXL_ALONG_RIGHT].distance);
    const wide up = product_of(view.lens.focal, point.y + view.frustum.planes[FXL_ALONG_UP].distance);
    fxl_screen_point screen;
    if (fxl_project_orthographic(&view, &point, &screen) == FXL_OK) {
        const wide x = (wide)screen.x - view.lens.centre_x, y = (wide)view.lens.centre_y - screen.y;
        ASSERT("x", WITHIN(x * 2 * half - right, half));
        ASSERT("y", WITHIN(y * 2 * half - up, half));
    }
    PROOF_ENDS();
}

/* [[row]]
 * function = "flat_shift"
 * property = "any lens: the screen is at most 2 C wide and high, and the focal length of the drawing is below 2^29"
 * checks = 43
 * unwind = 15
 */
void prove_flat_shift(void)
{
    const fxl_lens lens = any_lens();
    const unsigned shift = flat_shift(&lens);
    ASSERT("C", shift <= 13 && (uint64_t)(uint32_t)lens.focal << (shift + 1) >= (uint64_t)lens.width << 16 &&
                    (uint64_t)(uint32_t)lens.focal << (shift + 1) >= (uint64_t)lens.height << 16);
    ASSERT("below 2^29", (uint64_t)(uint32_t)lens.focal << shift < 1u << 29);
    PROOF_ENDS();
}
