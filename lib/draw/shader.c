/* SPDX-License-Identifier: MIT */
/* The shaders of a renderer, in the order of their ranks. A file of its own, so that a program
 * without shaders does not link it. */
#include "../view/view.h"
#include "submit.h"

void fxl_renderer_set_shader(fxl_renderer *renderer, uint32_t rank, fxl_shader *shader)
{
    const fxl_shader **place = &renderer->shader;
    while (*place != NULL && (*place)->rank < rank) {
        place = &((fxl_shader *)(uintptr_t)*place)->next; /* none of these is constant */
    }
    const fxl_shader *following = *place;
    if (following != NULL && following->rank == rank) {
        following = following->next;
    }
    if (shader != NULL) {
        shader->rank = rank;
        shader->next = following;
        following = shader;
    }
    *place = following;
    fxl_view_count_change(&renderer->frame.view);
    renderer->frame.state = FXL_FRAME_NONE;
}

bool fxl_submit_coloured_face(const fxl_model_view *model_view, const fxl_face *face,
                              const fxl_traversal *traversal, const fxl_shader *shader)
{
    const fxl_instance *instance = model_view->instance;
    fxl_face coloured = *face;
    coloured.material =
        shader->code->colour(shader, traversal, instance, face, face->material);
    const fxl_shader *next =
        fxl_shader_reaching(shader->next, traversal->renderer->scene, instance);
    return next != NULL ? next->code->face(model_view, &coloured, traversal, next)
                        : fxl_submit_shaded_face(model_view, &coloured, traversal);
}
