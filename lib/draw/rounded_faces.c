/* SPDX-License-Identifier: MIT */
#include "rounded_faces.h"

#include "../scene/placement_code.h"

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
