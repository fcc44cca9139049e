/* SPDX-License-Identifier: MIT */
/* Of a face with a texture, the texels a pixel at the depth z are, by area,
 *
 *   |du1 dv2 - du2 dv1| z^3 / (focal^2 V),
 *
 * where du and dv are those of two edges, and V is the volume between eye and corners times six:
 * the face has |E1 x E2| units of area for |du1 dv2 - du2 dv1| texels, and a unit of it is seen as
 * focal^2 V / (|E1 x E2| z^3) pixels. In the view of an off-centre lens, which is sheared, V and
 * the focal length of the drawing give the same. The units of 2^-16 and 2^-46 of both sides are the
 * same. */
#include "../math/arith.h"
#include "../math/family.h"
#include "../view/view.h"
#include "texture_level.h"

#if FXL_ESTIMATES
__attribute__((noinline)) /* in place, all calls of it take 580 bytes more at -O2 */
#endif
static fxl_real
real_of(uint64_t number, int exponent)
{
    return fxl_real_of(number, exponent);
}

static fxl_real product(fxl_real a, fxl_real b)
{
    return real_of(fxl_multiply_u32(a.mantissa, b.mantissa), a.exponent + b.exponent);
}

/* Coordinates differ by less than 2^31, so products are below 2^62. */
uint64_t fxl_texel_area(int32_t (*values)[3])
{
    const int32_t *u = values[FXL_ATTRIBUTE_U], *v = values[FXL_ATTRIBUTE_V];
    const int64_t u1 = u[1] - (int64_t)u[0], v1 = v[1] - (int64_t)v[0];
    const int64_t u2 = u[2] - (int64_t)u[0], v2 = v[2] - (int64_t)v[0];
    return fxl_magnitude(u1 * v2 - u2 * v1);
}

/* SPEC 9.4 */
bool fxl_texel_density_find(int64_t depth, const fxl_view *view, const fxl_gradients *gradients,
                            fxl_texel_density *density)
{
    if (depth <= 0 || gradients->volume.number == 0) {
        return false;
    }
    const fxl_real focal = real_of((uint32_t)fxl_view_drawn_focal(view), 0);
    density->depth = real_of((uint64_t)depth, 0);
    density->pixels =
        product(real_of((uint64_t)gradients->volume.number, gradients->volume.exponent),
                product(focal, focal));
    return true;
}

/* SPEC 9.4, surfaces 3.2 */
uint8_t fxl_texture_level_choose(const fxl_texture *texture, const fxl_texel_density *density,
                                 fxl_gradients *gradients)
{
    if (density == NULL || density->texels == 0) {
        return 0;
    }
    const fxl_real z = density->depth, pixels = density->pixels;
    const fxl_real texels = product(real_of(density->texels, 1), product(z, product(z, z)));
    const int log = texels.exponent - pixels.exponent - (texels.mantissa < pixels.mantissa);
    if (log < 2) {
        return 0;
    }
    const uint32_t last = texture->levels - 1u, wanted = (uint32_t)log / 2;
    const uint32_t level = wanted < last ? wanted : last;
    const uint32_t least = fxl_level_least(texture);
    gradients->shifts[FXL_ATTRIBUTE_U] =
        (int8_t)(gradients->shifts[FXL_ATTRIBUTE_U] -
                 (int32_t)(texture->log_width - fxl_level_log(texture->log_width, level, least)));
    gradients->shifts[FXL_ATTRIBUTE_V] =
        (int8_t)(gradients->shifts[FXL_ATTRIBUTE_V] -
                 (int32_t)(texture->log_height - fxl_level_log(texture->log_height, level, 0)));
    return (uint8_t)level;
}

/* surfaces 3.1 */
void fxl_texture_level_find(const fxl_texture *texture, uint32_t number, fxl_texture_level *level)
{
    const uint32_t least = fxl_level_least(texture);
    uint32_t log_width = texture->log_width, log_height = texture->log_height;
    const uint8_t *texels = texture->texels;
    const bool is_565 = texture->format == FXL_TEXTURE_565;
    for (uint32_t i = 0; i < number; i++) {
        texels += (is_565 ? 2u : 1u) << (log_width + log_height) >> least;
        log_width = fxl_level_log(texture->log_width, i + 1, least);
        log_height = fxl_level_log(texture->log_height, i + 1, 0);
    }
    fxl_texture_level_set(texture, texels, log_width, log_height, level);
}
