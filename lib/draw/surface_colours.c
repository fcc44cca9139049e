/* SPDX-License-Identifier: MIT */
/* A file of its own: a renderer of a palette does not link it. */
#include "../paint/corner_colours.h"
#include "surface_polygon.h"

/* surfaces 1.4 */
bool fxl_find_colours(const fxl_surfaces *surfaces, const fxl_corner *const mapped[3],
                      const fxl_corner_planes *planes, bool is_affine, bool is_coarse,
                      fxl_gradient_corners *corners, fxl_gradients *gradients)
{
    int32_t(*values)[3] = corners->values;
    if (!FXL_IS_COMPACT && planes != NULL && corners->count == 0 &&
        fxl_corner_colours_unlit(mapped, planes, is_affine, gradients)) {
        return true;
    }
    const int32_t light[3] = {values[0][0], values[0][1], values[0][2]};
    fxl_corner_colours(mapped, values);
    if (corners->count != 0) {
        fxl_corner_colours_light(&surfaces->light->settings, light, values);
    }
    corners->count = FXL_ATTRIBUTES;
    return planes != NULL &&
           fxl_corner_colours_linear(planes, values, is_affine, is_coarse, gradients);
}
