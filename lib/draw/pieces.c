/* SPDX-License-Identifier: MIT */
#include "../math/arith.h"
#include "../scene/placement_code.h"
#include "../view/model_view.h"
#include "../view/outcode.h"
#include "rounded_faces.h"

/* beams 4.2 */
void fxl_pieces_begin(fxl_pieces *pieces, const fxl_traversal *traversal)
{
    pieces->traversal = traversal;
    pieces->take = NULL;
    pieces->planes = FXL_PLANES_ALL;
    pieces->outcome = 0;
    pieces->used = traversal->renderer->frame.display_list.used;
}

bool fxl_submit_piece(fxl_pieces *pieces, const fxl_point *points, uint32_t count, uint8_t colour)
{
    const fxl_traversal *traversal = pieces->traversal;
    fxl_face face = {.material = colour};
    fxl_model_view model_view;
    FXL_ASSERT(count >= 3 && count <= FXL_POLYGON_CAPACITY);
    fxl_model_view_of_polygon(&model_view, points, &traversal->renderer->frame.view,
                              &traversal->workspace->cache);
    model_view.planes = pieces->planes;
    fxl_set_face_of_points(&face, count);
    pieces->outcome |= fxl_submit_polygons(&model_view, &face, traversal);
    return pieces->outcome < FXL_OUTCOME_FULL;
}

void fxl_submit_shaded_piece(fxl_pieces *pieces, const fxl_instance *instance,
                             const fxl_face *whole, const fxl_direction *normal,
                             const fxl_point *points, uint32_t count)
{
    const fxl_face piece = {
        .normal = *normal, .count = (uint8_t)count, .material = whole->material};
    pieces->instance = instance;
    pieces->face = whole;
    (void)fxl_submit_piece_by(pieces, pieces->traversal->renderer->shader, &piece, points);
}

bool fxl_submit_piece_by(fxl_pieces *pieces, const fxl_shader *shader, const fxl_face *piece,
                         const fxl_point *points)
{
    const fxl_renderer *renderer = pieces->traversal->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_instance *instance = pieces->instance;
    fxl_face made = *piece;
    shader = fxl_shader_reaching(shader, scene, instance);
    while (shader != NULL && (shader->code->split == NULL ||
                              (shader->code->takes != NULL &&
                               !shader->code->takes(shader, renderer, pieces->face)))) {
        if (shader->code->colour != NULL) {
            made.material = shader->code->colour(shader, pieces->traversal, instance, pieces->face,
                                                 made.material);
        }
        shader = fxl_shader_reaching(shader->next, scene, instance);
    }
    return shader != NULL ? shader->code->split(shader, pieces, &made, points, made.count)
                          : fxl_submit_piece(pieces, points, made.count, made.material);
}

bool fxl_submit_split_piece(const fxl_shader *by, fxl_pieces *pieces, const fxl_face *face,
                            const fxl_point *points, uint32_t count, uint8_t colour)
{
    const fxl_shader *next = by->next;
    fxl_face piece = {.normal = face->normal, .count = (uint8_t)count, .material = colour};
    return next != NULL ? next->code->split(next, pieces, &piece, points, count)
                        : fxl_submit_piece(pieces, points, count, colour);
}

/* beams 4.2 */
bool fxl_pieces_end(fxl_pieces *pieces)
{
    return fxl_count_outcome(pieces->traversal, pieces->outcome, pieces->used);
}

bool fxl_submit_split_face(const fxl_model_view *model_view, const fxl_face *face,
                           const fxl_traversal *traversal, const fxl_shader *shader)
{
    const fxl_point *eye = &model_view->view->camera.position;
    const uint16_t *corners = fxl_face_indices(model_view->indices, face);
    fxl_point *points = traversal->workspace->work.points;
    fxl_pieces pieces;
    for (uint32_t i = 0; i < face->count; i++) {
        /* A vertex of the world again: within FXL_COORDINATE_MAX. */
        points[i] = fxl_model_view_vertex(model_view, corners[i]);
        points[i].x += eye->x;
        points[i].y += eye->y;
        points[i].z += eye->z;
    }
    fxl_pieces_begin(&pieces, traversal);
    pieces.instance = model_view->instance;
    pieces.face = face;
    pieces.planes = model_view->planes;
    (void)shader->code->split(shader, &pieces, face, points, face->count);
    return fxl_pieces_end(&pieces);
}

/* The face's rounded points are a polygon of the world, which any clipper takes. */
/* SPEC 8.5 */
static bool submit_rounded_face(const fxl_model_view *model_view, const fxl_face *face,
                                const fxl_traversal *traversal, const fxl_shader *shader)
{
    const fxl_rounded_instance *instance = (const fxl_rounded_instance *)(const void *)shader;
    const fxl_scene *scene = traversal->renderer->scene;
    const fxl_placement_code *turned = scene->placement_code;
    const fxl_direction normal = turned->normal(scene, instance->number, face);
    fxl_point points[FXL_FACE_VERTICES_MAX];
    fxl_pieces pieces;
    (void)model_view;
    turned->place_face(scene, instance->number, face, points);
    fxl_pieces_begin(&pieces, traversal);
    pieces.planes = instance->planes;
    fxl_submit_shaded_piece(&pieces, &scene->instances[instance->number], face, &normal, points,
                            face->count);
    return fxl_pieces_end(&pieces);
}

const fxl_shader_code fxl_rounded_faces = {.face = submit_rounded_face};
