/* SPDX-License-Identifier: MIT */
#include "draw/renderer.c"
#include "proof.h"

/* [[row]]
 * function = "fxl_refuse"
 * property = "the status that it is given, and one call more is counted"
 * checks = 8
 */
void prove_refuse(void)
{
    fxl_workspace workspace;
    const uint32_t before = workspace.counters.refused_calls;
    const fxl_status status = (fxl_status)nondet_u8();
    ASSERT("its status", fxl_refuse(&workspace, status) == status);
    ASSERT("counted", workspace.counters.refused_calls == before + 1u);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_frame_release_scene"
 * property = "any renderer, or null: released only in a frame whose instances are all done"
 * checks = 32
 */
void prove_frame_release_scene(void)
{
    fxl_renderer renderer;
    const bool has_frame = renderer.frame.state != FXL_FRAME_NONE;
    const fxl_status status = fxl_frame_release_scene(&renderer);
    ASSERT("released only in a frame whose instances are all done",
           status != FXL_OK || (has_frame && renderer.frame.state == FXL_FRAME_RELEASED &&
                                renderer.frame.resume.instances >= renderer.frame.visible_count));
    ASSERT("null is refused", fxl_frame_release_scene(NULL) == FXL_E_ARGUMENT);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_frame_end"
 * property = "any renderer, or null: no frame is left"
 * checks = 7
 */
void prove_frame_end(void)
{
    fxl_renderer renderer;
    const bool has_one = nondet_bool();
    const fxl_status status = fxl_frame_end(has_one ? &renderer : NULL);
    ASSERT("no frame is left", has_one ? status == FXL_OK && renderer.frame.state == FXL_FRAME_NONE : status == FXL_E_ARGUMENT);
    PROOF_ENDS();
}
