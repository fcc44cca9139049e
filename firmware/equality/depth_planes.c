/* SPDX-License-Identifier: MIT */
/* Compares the planes of depth: of normals that are rotated, and of normals in the view. */

#include "draw/depth_plane.h"
#include "equality.h"
#include "sides.h"

/* Of a vector of unit length or shorter, or 0. */
static int32_t any_component(void)
{
    const uint32_t kind = any_32() >> 9 & 15u;
    const int32_t value = (int32_t)(any_32() % 1239850261u) - 619925130; /* 2^30 / sqrt(3) */
    return kind == 0 ? 0 : kind == 1 ? value >> (any_32() >> 9 & 31u) : value;
}

static void any_direction(fxl_direction *direction)
{
    direction->x = any_component();
    direction->y = any_component();
    direction->z = any_component();
}

static int64_t any_coordinate(void)
{
    const int64_t value = (int64_t)(any_length() >> 3);
    return any_32() & 1024u ? -value : value;
}

static void any_view(fxl_view *view)
{
    view->lens.near_z = (int32_t)(1u + (any_32() >> 1 >> (any_32() >> 9) % 23u));
    view->projection.factor = 4u * (1u + (any_32() >> 3 >> (any_32() >> 9) % 20u));
    view->projection.centre_x = (int32_t)(any_32() >> 3) - (1 << 28);
    view->projection.centre_y = (int32_t)(any_32() >> 3) - (1 << 28);
}

static bool is_same(const fxl_depth_plane *a, const fxl_depth_plane *b)
{
    return a->gradient.at == b->gradient.at && a->gradient.along == b->gradient.along &&
           a->gradient.down == b->gradient.down && a->one == b->one;
}

void test_depth_planes(uint32_t rounds)
{
    static fxl_view view;
    fxl_depth_plane core, portable;
    fxl_direction normal;
    fxl_axes axes;
    fxl_view_point point;
    for (uint32_t i = 0; i < rounds; i++) {
        const fxl_axes *rotation = (any_32() & 0x700u) != 0 ? &axes : NULL;
        any_view(&view);
        any_direction(&normal);
        any_direction(&axes.right);
        any_direction(&axes.up);
        any_direction(&axes.forward);
        point.x = any_coordinate();
        point.y = any_coordinate();
        point.z = any_coordinate();
        fxl_find_depth_plane(&normal, rotation, &point, &view, &core);
        portable_find_depth_plane(&normal, rotation, &point, &view, &portable);
        equality_case(is_same(&core, &portable));
    }
}
