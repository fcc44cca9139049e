/* SPDX-License-Identifier: MIT */
#include "draw/choose.c"
#include "draw/combination.c"
#include "proof.h"

void fxl_renderer_set_shader(fxl_renderer *renderer, uint32_t rank, fxl_shader *shader)
{
    (void)rank;
    renderer->shader = shader;
}

/* [[row]]
 * function = "lib/draw/combination.c:fxl_renderer_attach"
 * property = "any renderer and shader: all that it has is looked at before the next frame"
 * checks = 393
 * stubs = { fxl_renderer_set_shader = "its own row", fxl_choose_with_memory = "not called", fxl_refuse = "not called" }
 */
void prove_renderer_attach(void)
{
    fxl_renderer renderer;
    fxl_shader shader;
    renderer.frame.view.lens.off_centre = NULL; /* an orthographic lens: unit tests */
    fxl_renderer_attach(&renderer, nondet_u32(), nondet_bool() ? NULL : &shader);
    ASSERT("what it has is looked at before the next frame", renderer.check == fxl_check_combination);
    PROOF_ENDS();
}

static bool chosen;

fxl_status fxl_choose_with_memory(fxl_renderer *renderer, const fxl_config *config)
{
    ASSERT("as it requires", renderer != NULL && renderer->scene != NULL && config != NULL && config->target != NULL);
    chosen = true;
    return nondet_bool() ? FXL_OK : FXL_E_CAPACITY;
}

fxl_status fxl_refuse(fxl_workspace *workspace, fxl_status status)
{
    (void)workspace;
    return status;
}

/* [[row]]
 * function = "fxl_renderer_choose"
 * property = "any renderer and configuration whose order needs no tables of its own, and null pointers: chosen only with a scene and nothing attached"
 * checks = 76
 * stubs = { fxl_renderer_set_shader = "not called", fxl_choose_with_memory = "any status", fxl_refuse = "its own row" }
 */
void prove_renderer_choose(void)
{
    fxl_renderer renderer;
    fxl_config config;
    fxl_shader shader;
    fxl_order order;
    renderer.shader = nondet_bool() ? NULL : &shader;
    config.order = &order;
    order.choose = NULL;
    chosen = false;
    const fxl_status status = fxl_renderer_choose(nondet_bool() ? NULL : &renderer, nondet_bool() ? NULL : &config);
    ASSERT("chosen only with nothing attached", !chosen || (renderer.billboards == NULL && (renderer.shader == NULL || shader.rank == FXL_SHADER_TARGET)));
    ASSERT("or refused", status != FXL_OK || chosen);
    PROOF_ENDS();
}
