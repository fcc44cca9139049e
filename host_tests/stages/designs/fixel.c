/* SPDX-License-Identifier: MIT */
/* The library, by its public functions. A call that it refuses counts as the
 * end of 16.16, so that it cannot pass for precise. */
#include "designs/stage.h"

static const designs_screen refused = {0x1p31, 0x1p31};

static void fixel_matrix(const fxl_pose *pose, double entries[9])
{
    fxl_camera camera = {.position = {0, 0, 0}};
    (void)fxl_camera_from_pose(pose, &camera);
    const fxl_direction *rows[3] = {&camera.axes.right, &camera.axes.up, &camera.axes.forward};
    for (int i = 0; i < 3; i++) {
        entries[3 * i] = rows[i]->x;
        entries[3 * i + 1] = rows[i]->y;
        entries[3 * i + 2] = rows[i]->z;
    }
}

static designs_screen show(const designs_input *input, const fxl_view_point *view)
{
    fxl_screen_point screen;
    if (fxl_project_point(&input->lens, view, &screen) != FXL_OK) {
        return refused;
    }
    return (designs_screen){screen.x, screen.y};
}

static designs_screen fixel_vertex(const designs_input *input)
{
    fxl_view_point view;
    fxl_transform_point(&input->camera, &input->points[0], &view);
    return show(input, &view);
}

/* There and back again along the edge: the second vertex of what is left is
 * the crossing. */
static designs_screen fixel_clip(const designs_input *input)
{
    fxl_view_frustum frustum;
    fxl_view_frustum_from_lens(&input->lens, &frustum);
    fxl_view_polygon edge = {.count = 3}, cut;
    for (int i = 0; i < 3; i++) {
        fxl_transform_point(&input->camera, &input->points[i == 1], &edge.vertices[i].position);
    }
    fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
    if (fxl_clip_view_to_plane(&edge, &frustum, input->plane, &cut, distances) != FXL_CLIP_CUT) {
        return refused;
    }
    return show(input, &cut.vertices[1].position);
}

static void fixel_fill(const fxl_screen_polygon *outline, const designs_bitmap *bitmap)
{
    static fxl_scan scan;
    fxl_band band = {.pixels = bitmap->pixels, .width = (uint16_t)bitmap->width,
                     .stride = (uint16_t)bitmap->width, .first_row = 0,
                     .rows = (uint16_t)bitmap->height};
    fxl_span span;
    if (fxl_scan_begin(outline, &band, &scan) != FXL_OK) {
        return;
    }
    while (fxl_scan_next(&scan, &span)) {
        fxl_fill_span(&band, &span, 1);
    }
}

/* place sampling: the texel of a pixel in other arithmetic */
static int fixel_texel(designs_surface *face, uint8_t division)
{
    return surface_sample_texel(&face->sample, 0, DESIGNS_TEXEL_LOG, division);
}

static int fixel_level(designs_surface *face)
{
    return surface_sample_level(&face->sample, face->normals, &face->light);
}

static int fixel_nearer(const depth_sample *faces, bool wide)
{
    return depth_sample_drawn(faces, wide);
}

const designs_design designs_fixel = {"fixel",    fixel_matrix, fixel_vertex, fixel_clip,
                                      fixel_fill, fixel_texel,  fixel_level,  fixel_nearer};
