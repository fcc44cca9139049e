/* SPDX-License-Identifier: MIT */
/* What the order by tree and beams write while they draw. That of the renderer's own workspace lies
 * in their own memory, that of another one in front of its face order: beams, then the tree.
 * Internal. */
#ifndef FXL_SCRATCH_H
#define FXL_SCRATCH_H

#include "renderer.h"
#include "submit.h"

/* The shader of beams begins with this record. */
typedef struct {
    fxl_shader shader;
    uint32_t scratch_size; /* a multiple of 8 */
    const uint8_t *lit;    /* of fxl_beam_set */
} fxl_beam_shader;

/* A bit for each node of the tree. */
static inline uint32_t fxl_tree_scratch_size(const fxl_renderer *renderer)
{
    return renderer->order->memory_size != NULL
               ? (uint32_t)fxl_aligned((renderer->scene->bsp_node_count + 31u) / 32u * 4u)
               : 0;
}

static inline uint32_t fxl_beam_scratch_size(const fxl_renderer *renderer)
{
    const fxl_shader *shader = renderer->shader;
    while (shader != NULL && shader->rank != FXL_SHADER_BEAMS) {
        shader = shader->next;
    }
    return shader != NULL ? ((const fxl_beam_shader *)(const void *)shader)->scratch_size : 0;
}

/* Of a workspace that is not the renderer's own. */
static inline void *fxl_tree_scratch(const fxl_traversal *traversal)
{
    return (uint8_t *)traversal->workspace->face_list - fxl_tree_scratch_size(traversal->renderer);
}

static inline void *fxl_beam_scratch(const fxl_traversal *traversal, uint32_t size)
{
    return (uint8_t *)fxl_tree_scratch(traversal) - size;
}

/* Whether a traversal works in the renderer's own workspace. */
static inline bool fxl_is_own_workspace(const fxl_traversal *traversal)
{
    return traversal->workspace == &traversal->renderer->workspace;
}

#endif
