/* SPDX-License-Identifier: MIT */
/* Sentences about setups that were refused. A file of its own, so that a program which asks for none
 * links none. */
#include "setup.h"

static const char *explain_step(const fxl_setup *setup, const fxl_setup_plan *plan,
                                const fxl_setup_shares *shares, const uint8_t *block, size_t size)
{
    const char *const reasons[] = {
        fxl_setup_reasons, /* FXL_SETUP_NOTHING */
        fxl_motion_reasons, /* FXL_SETUP_MOTIONS */
        fxl_render_reasons, /* FXL_SETUP_RENDERER */
        fxl_render_reasons, /* FXL_SETUP_CENTRE */
        fxl_beams_reasons, /* FXL_SETUP_BEAMS */
        fxl_light_reasons, /* FXL_SETUP_LIGHT */
        fxl_surfaces_reasons, /* FXL_SETUP_SURFACES */
        fxl_surfaces_reasons, /* FXL_SETUP_LIT */
        fxl_billboards_reasons, /* FXL_SETUP_BILLBOARDS */
        fxl_lines_reasons, /* FXL_SETUP_LINES */
        fxl_horizon_reasons, /* FXL_SETUP_HORIZON */
        fxl_setup_reasons, /* FXL_SETUP_DONE */
    };
    if (setup->step == FXL_SETUP_CENTRE && plan->set_orthographic != NULL &&
        (plan->scale < FXL_ORTHOGRAPHIC_SCALE_MIN || plan->scale > FXL_ORTHOGRAPHIC_SCALE_MAX)) {
        return "plan->scale must be FXL_ORTHOGRAPHIC_SCALE_MIN..FXL_ORTHOGRAPHIC_SCALE_MAX";
    }
    if (!plan->has_tables && (setup->step == FXL_SETUP_RENDERER || setup->step >= FXL_SETUP_DONE)) {
        return fxl_renderer_explain(&setup->renderer, &setup->scene, &setup->config,
                                    block + shares->before_renderer,
                                    size - shares->before_renderer);
    }
    return fxl_explain(reasons[setup->step], setup->status);
}

FXL_COLD const char *fxl_setup_explain(const fxl_setup *setup, const fxl_setup_plan *plan,
                                       uint16_t rows, const void *memory, size_t memory_size)
{
    fxl_setup_shares shares;
    const fxl_status status = fxl_setup_divide(setup, plan, rows, memory, &shares);
    if (status != FXL_OK) {
        return fxl_explain(fxl_setup_reasons, status);
    }
    return memory_size < (size_t)shares.before_renderer + shares.renderer
               ? fxl_explain(fxl_setup_reasons, FXL_E_CAPACITY)
               : explain_step(setup, plan, &shares, (const uint8_t *)memory,
                              memory_size);
}
