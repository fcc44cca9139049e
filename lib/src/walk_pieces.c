/* SPDX-License-Identifier: MIT */
#include "arith.h"
#include "walk.h"

void fxl_walk_pieces_begin(fxl_pieces *pieces, const fxl_walk *on)
{
    pieces->on = on;
    pieces->planes = FXL_PLANES_ALL;
    pieces->fate = 0;
    pieces->used = on->renderer->list.used;
}

bool fxl_walk_piece(fxl_pieces *pieces, const fxl_point *points, uint32_t count, uint8_t colour)
{
    fxl_renderer *renderer = pieces->on->renderer;
    const fxl_face face = {.count = (uint8_t)count, .colour = colour};
    fxl_placed placed;
    FXL_ASSERT(count >= 3 && count <= FXL_POLYGON_CAPACITY);
    fxl_place_polygon(&placed, points, pieces->planes, &renderer->view, &renderer->cache);
    pieces->fate |= fxl_walk_polygons(pieces->on, &placed, &face);
    return pieces->fate < FXL_FATE_NO_ROOM;
}

bool fxl_walk_pieces_end(fxl_pieces *pieces)
{
    return fxl_walk_account(pieces->on, pieces->fate, pieces->used);
}

bool fxl_walk_lit_face(const fxl_walk *on, const fxl_placed *placed, const fxl_face *face)
{
    const fxl_light *light = on->renderer->light;
    const fxl_point *eye = &placed->view->camera.position;
    const uint16_t *corners = placed->corners + face->first_corner;
    fxl_point points[FXL_FACE_VERTICES_MAX];
    fxl_pieces pieces;
    for (uint32_t i = 0; i < face->count; i++) {
        /* A vertex of the world again: within FXL_COORDINATE_MAX. */
        points[i] = fxl_placed_vertex(placed, corners[i]);
        points[i].x += eye->x;
        points[i].y += eye->y;
        points[i].z += eye->z;
    }
    fxl_walk_pieces_begin(&pieces, on);
    pieces.planes = placed->planes;
    (void)light->split(light, &pieces, face, points, face->count);
    return fxl_walk_pieces_end(&pieces);
}
