/* SPDX-License-Identifier: MIT */
/* The names of what does not go together. A file of its own, so that a program which does not ask for
 * them does not link them. */
#include "renderer.h"

bool fxl_renderer_conflict(const fxl_renderer *renderer, const char *names[2])
{
    /* In the order of FXL_HAS_...; C++ has no designators of elements. */
    static const char *const parts[FXL_HAS_COUNT] = {
        "the order by tree", /* FXL_HAS_TREE */
        "instances that the tree cuts", /* FXL_HAS_MOVERS */
        "a depth buffer", /* FXL_HAS_DEPTH */
        "a target of the study", /* FXL_HAS_STUDY */
        "surfaces", /* FXL_HAS_SURFACES */
        "textures of RGB565", /* FXL_HAS_TEXELS_565 */
        "colours at corners", /* FXL_HAS_COLOURS */
        "billboards", /* FXL_HAS_BILLBOARDS */
        "beams", /* FXL_HAS_BEAMS */
        "outlines", /* FXL_HAS_OUTLINES */
        "surfaces or billboards of another target", /* FXL_HAS_OTHER_PAINTER */
        "the renderer's target", /* FXL_HAS_TARGET */
    };
    if (renderer == NULL || names == NULL || renderer->target == NULL) {
        return false;
    }
    const fxl_conflict *conflict = fxl_find_conflict(renderer);
    if (conflict == NULL) {
        return false;
    }
    names[0] = parts[conflict->first];
    names[1] = parts[conflict->second];
    return true;
}
