/* SPDX-License-Identifier: MIT */
#include "../clip/intersection.h"
#include "../clip/volume.h"
#include "../math/arith.h"
#include "../view/project.h"
#include "triangle.h"

#define MASK (FXL_TRIANGLE_QUEUE - 1u)

/* A border at most doubles the triangles that wait, so four borders make at most 16. */
/* clippers 3.2 */
static void cut_flats(fxl_triangle_workspace *workspace, int border, uint16_t extent)
{
    fxl_clip_stats stats = workspace->stats;
    stats.sliver = workspace->screen_sliver;
    for (uint32_t left = workspace->flat_count; left > 0; left--) {
        fxl_screen_triangle cut[2];
        uint32_t made = fxl_triangle_cut_screen(&workspace->flats[workspace->flat_first & MASK],
                                                border, extent, workspace->carried, &stats, cut);
        workspace->flat_first += 1;
        workspace->flat_count -= 1;
        for (uint32_t i = 0; i < made; i++) {
            FXL_ASSERT(workspace->flat_count < FXL_TRIANGLE_QUEUE);
            workspace->flats[(workspace->flat_first + workspace->flat_count++) & MASK] = cut[i];
        }
    }
    workspace->stats.intersections = stats.intersections;
}

fxl_clip_result fxl_triangle_begin(const fxl_clip_triangle *in, uint32_t carried,
                                   const fxl_volume *volume, fxl_triangle_workspace *workspace)
{
    uint32_t any = 0, all = UINT32_MAX;
    for (int i = 0; i < 3; i++) {
        uint32_t code = fxl_volume_code(volume, &in->corners[i].position);
        any |= code;
        all &= code;
    }
    workspace->stats.distances += 3 * FXL_PLANE_COUNT;
    workspace->planes = any;
    workspace->carried = (uint8_t)carried;
    workspace->flat_first = workspace->flat_count = workspace->solid_count = 0;
    if (all != 0) {
        return FXL_CLIP_OUTSIDE;
    }
    workspace->solids[0] = *in;
    workspace->next_plane[0] = 0;
    workspace->solid_count = 1;
    return any == 0 ? FXL_CLIP_INSIDE : FXL_CLIP_CUT;
}

/* Cuts the triangle on top of the stack by the planes that have not cut it yet. Where a plane
 * leaves two triangles, the second is pushed, to be cut by the planes that follow. So no two
 * triangles that wait have the same next plane. Returns null where nothing is left. */
static const fxl_clip_triangle *pop_solid(const fxl_volume *volume,
                                          fxl_triangle_workspace *workspace)
{
    uint32_t top = --workspace->solid_count;
    for (uint32_t plane = workspace->next_plane[top]; workspace->planes >> plane != 0; plane++) {
        fxl_clip_triangle cut[2];
        if ((workspace->planes >> plane & 1u) == 0) {
            continue;
        }
        /* The result replaces its source on the stack; the next triangle goes above it. */
        uint32_t made = fxl_triangle_cut(&workspace->solids[top], &volume->planes[plane],
                                         workspace->carried, &workspace->stats, cut);
        if (made == 0) {
            workspace->solid_count = top;
            return NULL;
        }
        if (made == 2) {
            workspace->solids[top] = cut[1];
            workspace->next_plane[top] = (uint8_t)(plane + 1);
            top += 1;
            FXL_ASSERT(top < FXL_TRIANGLE_STACK);
        }
        workspace->solids[top] = cut[0];
    }
    workspace->solid_count = top;
    return &workspace->solids[top];
}

/* Projects a triangle, and keeps the depth of each vertex. */
static fxl_status project(const fxl_lens *lens, const fxl_clip_triangle *solid, uint32_t carried,
                          fxl_screen_triangle *flat)
{
    for (int i = 0; i < 3; i++) {
        const fxl_varying_vertex *from = &solid->corners[i];
        fxl_screen_corner *to = &flat->corners[i];
        fxl_status status = fxl_project_point(lens, &from->position, &to->at);
        if (status != FXL_OK) {
            return status;
        }
        to->depth = from->position.z;
        for (uint32_t k = 0; k < carried; k++) {
            to->carried[k] = from->carried[k];
        }
    }
    return FXL_OK;
}

const fxl_screen_triangle *fxl_triangle_next(const fxl_volume *volume, const fxl_lens *lens,
                                             fxl_triangle_workspace *workspace, fxl_status *status)
{
    *status = FXL_OK;
    while (workspace->flat_count == 0) {
        if (workspace->solid_count == 0) {
            return NULL;
        }
        const fxl_clip_triangle *solid = pop_solid(volume, workspace);
        if (solid == NULL) {
            continue;
        }
        *status = project(lens, solid, workspace->carried, &workspace->flats[0]);
        if (*status != FXL_OK) {
            workspace->solid_count = 0;
            return NULL;
        }
        workspace->flat_first = 0;
        workspace->flat_count = 1;
        cut_flats(workspace, FXL_BORDER_LEFT, lens->width);
        cut_flats(workspace, FXL_BORDER_RIGHT, lens->width);
        cut_flats(workspace, FXL_BORDER_TOP, lens->height);
        cut_flats(workspace, FXL_BORDER_BOTTOM, lens->height);
    }
    workspace->flat_count -= 1;
    return &workspace->flats[workspace->flat_first++ & MASK];
}
