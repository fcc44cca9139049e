/* SPDX-License-Identifier: MIT */
#include "paint/texture_level.c"
#include "proof.h"

/* [[row]]
 * function = "fxl_texel_area"
 * property = "nothing overflows for coordinates below 2^30"
 * checks = 101
 */
void prove_texel_area(void)
{
    int32_t values[FXL_ATTRIBUTES][3];
    for (int i = 0; i < 3; i++) {
        ASSUME(WITHIN(values[FXL_ATTRIBUTE_U][i], (1 << 30) - 1) && WITHIN(values[FXL_ATTRIBUTE_V][i], (1 << 30) - 1));
    }
    (void)fxl_texel_area(values);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_texel_density_find"
 * property = "any depth, projection and volume: nothing overflows, and both numbers have 32 bits"
 * checks = 46
 */
void prove_texel_density_find(void)
{
    fxl_view view;
    fxl_gradients gradients;
    fxl_texel_density density;
    ASSUME(view.projection.factor >= 4 && view.projection.factor < (uint32_t)1 << 31);
    ASSUME(gradients.volume.number >= 0 && WITHIN(gradients.volume.exponent, 1 << 12));
    const bool found = fxl_texel_density_find(nondet_s64(), &view, &gradients, &density);
    ASSERT("numbers of 32 bits", !found || (density.depth.mantissa >> 31 == 1 && density.pixels.mantissa >> 31 == 1));
    ASSERT("their exponents", !found || (WITHIN(density.depth.exponent, 64) && WITHIN(density.pixels.exponent, 1 << 13)));
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_texture_level_choose"
 * property = "any texture and density: nothing overflows, and the level is one that the texture has"
 * checks = 95
 */
void prove_texture_level_choose(void)
{
    fxl_texture texture;
    fxl_texel_density density;
    fxl_gradients gradients;
    ASSUME(texture.levels >= 1 && texture.levels <= 9 && texture.log_width <= 8 && texture.log_height <= 8);
    ASSUME(texture.format != FXL_TEXTURE_4 || texture.log_width >= 1);
    ASSUME(density.depth.mantissa >> 31 == 1 && WITHIN(density.depth.exponent, 64));
    ASSUME(density.pixels.mantissa >> 31 == 1 && WITHIN(density.pixels.exponent, 1 << 13));
    ASSUME(gradients.shifts[FXL_ATTRIBUTE_U] >= -112 && gradients.shifts[FXL_ATTRIBUTE_V] >= -112); /* as shift_of leaves them */
    const uint8_t level = fxl_texture_level_choose(&texture, nondet_bool() ? NULL : &density, &gradients);
    ASSERT("a level that it has", level < texture.levels);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/texture_level.h:fxl_texture_level_set"
 * property = "so it is of its sides"
 * checks = 135
 */
/* [[row]]
 * function = "fxl_texture_level_find"
 * property = "textures of up to 16 x 16 texels and 5 levels: nothing overflows, and the level lies in the texture"
 * checks = 135
 */
void prove_texture_level_find(void)
{
    uint8_t texels[2 * (16 * 16 + 8 * 8 + 4 * 4 + 2 * 2 + 1)];
    fxl_texture texture;
    fxl_texture_level level;
    const uint32_t number = nondet_u32();
    texture.texels = texels;
    ASSUME(texture.log_width <= 4 && texture.log_height <= 4 && texture.levels >= 1 && texture.levels <= 5 && number < texture.levels);
    ASSUME(texture.format <= FXL_TEXTURE_565 && (texture.format != FXL_TEXTURE_4 || texture.log_width >= 1));
    fxl_texture_level_find(&texture, number, &level);
    ASSERT("its side", level.columns_less_1 == ((uint32_t)1 << level.log_width) - 1 && level.log_width <= texture.log_width);
    ASSERT("its texels lie in those of the texture", __CPROVER_r_ok(level.texels, 1));
    PROOF_ENDS();
}
