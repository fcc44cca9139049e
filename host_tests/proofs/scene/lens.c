/* SPDX-License-Identifier: MIT */
#include "scene/lens.c"
#include "proof.h"

const fxl_off_centre_code fxl_off_centre = {fxl_off_centre_is_valid, NULL, NULL, NULL};

/* Any lens: what makes one sets off_centre to null or to the code of off-centre lenses. */
static fxl_lens any_lens(void)
{
    fxl_lens lens;
    lens.off_centre = nondet_bool() ? NULL : &fxl_off_centre;
    return lens;
}

/* [[row]]
 * function = "fxl_lens_is_valid"
 * property = "any lens, or null: nothing overflows, and a valid one has a screen, depths and a focal length in range"
 * checks = 143
 * stubs = { fxl_off_centre = "the table of lib/view/off_centre.c, of which no other function is called" }
 */
void prove_lens_is_valid(void)
{
    const fxl_lens lens = any_lens();
    const bool valid = fxl_lens_is_valid(nondet_bool() ? NULL : &lens);
    ASSERT("its screen", !valid || (lens.width >= 1 && lens.width <= FXL_SCREEN_MAX && lens.height >= 1 && lens.height <= FXL_SCREEN_MAX));
    ASSERT("its depths", !valid || (lens.near_z >= FXL_NEAR_MIN && lens.far_z <= FXL_FAR_MAX && lens.near_z < lens.far_z));
    ASSERT("its focal length is below 2^29", !valid || (lens.focal > 0 && lens.focal < 1 << 29));
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_off_centre_is_valid"
 * property = "any lens: nothing overflows, and the centre of a valid one is within two extents"
 * checks = 56
 * stubs = { fxl_off_centre = "the table of lib/view/off_centre.c, of which no other function is called" }
 */
void prove_off_centre_is_valid(void)
{
    const fxl_lens lens = any_lens();
    const bool valid = fxl_off_centre_is_valid(&lens);
    ASSERT("within two extents", !valid || (WITHIN((int64_t)lens.centre_x, lens.width * (int64_t)131072) &&
                                            WITHIN((int64_t)lens.centre_y, lens.height * (int64_t)131072)));
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_lens_set_centre"
 * property = "any lens of a screen, any centre: nothing overflows, and what is set is valid"
 * checks = 155
 * stubs = { fxl_off_centre = "the table of lib/view/off_centre.c, of which no other function is called" }
 */
void prove_lens_set_centre(void)
{
    fxl_lens lens = any_lens();
    const fxl_q16_16 x = nondet_s32(), y = nondet_s32();
    ASSUME(lens.width <= FXL_SCREEN_MAX && lens.height <= FXL_SCREEN_MAX);
    const fxl_status status = fxl_lens_set_centre(nondet_bool() ? NULL : &lens, x, y);
    ASSERT("set, it is a valid lens", status != FXL_OK || (lens.centre_x == x && lens.centre_y == y && lens.width >= 1));
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_lens_of_part"
 * property = "any lens and part of a screen, and null pointers: nothing overflows"
 * checks = 179
 * stubs = { fxl_off_centre = "the table of lib/view/off_centre.c, of which no other function is called" }
 */
void prove_lens_of_part(void)
{
    fxl_lens whole = any_lens(), part;
    const uint16_t width = nondet_u16(), height = nondet_u16();
    ASSUME(width <= FXL_SCREEN_MAX && height <= FXL_SCREEN_MAX);
    const fxl_status status = fxl_lens_of_part(nondet_bool() ? NULL : &whole, nondet_s16(), nondet_s16(), width, height,
                                               nondet_bool() ? NULL : &part);
    ASSERT("the part's screen", status != FXL_OK || (part.width == width && part.height == height && width >= 1 && height >= 1));
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_lens_from_window"
 * property = "any window, or null: nothing overflows, and each quotient fits"
 * checks = 257
 * uses = ["fxl_divide_round", "fxl_divide_u64"]
 * stubs = { fxl_off_centre = "the table of lib/view/off_centre.c, of which no other function is called" }
 */
void prove_lens_from_window(void)
{
    fxl_lens lens;
    const fxl_status status = fxl_lens_from_window(nondet_u16(), nondet_s32(), nondet_s32(), nondet_s32(), nondet_s32(), nondet_s32(), nondet_s32(),
                                                   nondet_bool() ? NULL : &lens);
    ASSERT("its screen", status != FXL_OK || (lens.width >= 1 && lens.width <= FXL_SCREEN_MAX && lens.height >= 1 && lens.height <= FXL_SCREEN_MAX));
    PROOF_ENDS();
}

/* For fxl_cos_q31 and fxl_sin_q31: the sine of 10 to 150 degrees is above 2^28. */
int64_t fxl_cos_q31(fxl_angle angle)
{
    const int64_t cosine = nondet_s64();
    (void)angle;
    ASSUME(WITHIN(cosine, (int64_t)1 << 31));
    return cosine;
}

int64_t fxl_sin_q31(fxl_angle angle)
{
    const int64_t sine = nondet_s64();
    ASSERT("10 to 150 degrees", angle >= FXL_FOV_MIN && angle <= FXL_FOV_MAX);
    ASSUME(sine > (int64_t)1 << 28 && sine <= (int64_t)1 << 31);
    return sine;
}

/* For fxl_multiply_s64: any product of factors below 2^25 and at most 2^32. */
int64_t any_product(int64_t a, int64_t b)
{
    const int64_t product = nondet_s64();
    ASSERT("factors in their ranges", a >= 32768 && a <= FXL_SCREEN_MAX * 32768 && b >= 0 && b <= (int64_t)1 << 32);
    ASSUME(product >= 0 && product <= (int64_t)1 << 57);
    return product;
}

/* [[row]]
 * function = "fxl_lens_from_fov"
 * property = "any screen, angle and depths, or null: nothing overflows, the division gets a quotient that fits, and the screen and the depths of a lens are in range"
 * checks = 105
 * uses = ["fxl_divide_round"]
 * stands_in = { fxl_multiply_s64 = "any_product" }
 * stubs = { fxl_off_centre = "the table of lib/view/off_centre.c, of which no other function is called", fxl_cos_q31 = "any cosine", fxl_sin_q31 = "any sine above 2^28, as those of 10 to 150 degrees are" }
 */
void prove_lens_from_fov(void)
{
    fxl_lens lens;
    const fxl_status status = fxl_lens_from_fov(nondet_u16(), nondet_u16(), nondet_u32(), nondet_s32(), nondet_s32(), nondet_s32(),
                                                nondet_bool() ? NULL : &lens);
    ASSERT("its screen", status != FXL_OK || (lens.width >= 1 && lens.width <= FXL_SCREEN_MAX && lens.height >= 1 && lens.height <= FXL_SCREEN_MAX));
    ASSERT("its depths", status != FXL_OK || (lens.near_z >= FXL_NEAR_MIN && lens.near_z < lens.far_z && lens.far_z <= FXL_FAR_MAX));
    PROOF_ENDS();
}
