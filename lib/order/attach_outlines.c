/* SPDX-License-Identifier: MIT */
#include "../draw/renderer.h"
#include "../draw/submit.h"
#include "../math/memory.h"
#include "fixel/wire.h"

/* The target of the palette stands in the renderer, or in its place the one that outlines. */
static void change_target(fxl_renderer *renderer, fxl_outlines *outlines)
{
    fxl_workspace *workspace = &renderer->workspace;
    const bool may_draw =
        renderer->target == &fxl_palette || renderer->target == &fxl_palette_outlined;
    if (may_draw) {
        renderer->target = outlines != NULL ? &fxl_palette_outlined : &fxl_palette;
        workspace->target_memory = outlines != NULL ? &outlines->style : NULL;
        workspace->target_memory_size = outlines != NULL ? (uint32_t)sizeof outlines->style : 0;
        workspace->settings_version += 1;
    }
}

fxl_status fxl_attach_outlines(fxl_renderer *renderer, fxl_outlines *outlines,
                               const fxl_outline_style *style)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (renderer->scene == NULL) {
        return fxl_refuse(&renderer->workspace, FXL_E_ORDER);
    }
    if (style == NULL) {
        fxl_renderer_attach(renderer, FXL_SHADER_OUTLINES, NULL);
        change_target(renderer, NULL);
        return FXL_OK;
    }
    if (outlines == NULL || !fxl_is_aligned(outlines, 8)) {
        return fxl_refuse(&renderer->workspace,
                          outlines == NULL ? FXL_E_ARGUMENT : FXL_E_ALIGNMENT);
    }
    outlines->style = *style;
    outlines->shader.code = &fxl_mark;
    fxl_renderer_attach(renderer, FXL_SHADER_OUTLINES, &outlines->shader);
    change_target(renderer, outlines);
    return FXL_OK;
}
