/* SPDX-License-Identifier: MIT */
#include "draw/orthographic.c"
#include "proof.h"

static fxl_lens any_lens(void)
{
    fxl_lens lens;
    ASSUME(lens.focal >= FXL_ORTHOGRAPHIC_SCALE_MIN && lens.focal <= FXL_ORTHOGRAPHIC_SCALE_MAX);
    ASSUME(lens.width >= 1 && lens.width <= FXL_SCREEN_MAX && lens.height >= 1 && lens.height <= FXL_SCREEN_MAX);
    lens.centre_x = lens.width * 32768;
    lens.centre_y = lens.height * 32768;
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
                                                        WITHIN(lens.centre_x, 512 * 65536) && WITHIN(lens.centre_y, 512 * 65536)));
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_project_orthographic"
 * property = "any point of the view: nothing overflows, and what is answered is within the range of screen coordinates"
 * checks = 60
 */
void prove_project_orthographic(void)
{
    fxl_view view;
    fxl_view_point point;
    fxl_screen_point screen;
    view.lens = any_lens();
    ASSUME(WITHIN(point.x, ((int64_t)1 << 61) - 1) && WITHIN(point.y, ((int64_t)1 << 61) - 1));
    const fxl_status status = fxl_project_orthographic(&view, &point, &screen);
    ASSERT("in range", status != FXL_OK || (WITHIN(screen.x, FXL_SCREEN_COORDINATE_MAX) && WITHIN(screen.y, FXL_SCREEN_COORDINATE_MAX)));
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
