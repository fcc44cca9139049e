/* SPDX-License-Identifier: MIT */
#include "draw/renderer_centre.c"
#include "draw/renderer_init_with.c"
#include "draw/beam_light.c"
#include "proof.h"

fxl_status fxl_refuse(fxl_workspace *workspace, fxl_status status)
{
    (void)workspace;
    return status;
}

fxl_status fxl_lens_set_centre(fxl_lens *lens, fxl_q16_16 x, fxl_q16_16 y)
{
    lens->centre_x = x;
    lens->centre_y = y;
    return nondet_bool() ? FXL_OK : FXL_E_RANGE;
}

void fxl_view_set_lens(fxl_view *view, const fxl_lens *lens)
{
    view->lens = *lens;
    view->frame = nondet_u32();
}

/* [[row]]
 * function = "fxl_renderer_set_centre"
 * property = "any renderer and centre: the count of frames stays, and refused, so does the lens"
 * checks = 63
 * stubs = { fxl_refuse = "its own row", fxl_lens_set_centre = "any status", fxl_view_set_lens = "any count of frames" }
 */
void prove_renderer_set_centre(void)
{
    fxl_renderer renderer;
    const uint32_t frame = renderer.frame.view.frame;
    const fxl_q16_16 before = renderer.frame.view.lens.centre_x, x = nondet_s32();
    const fxl_status status = fxl_renderer_set_centre(&renderer, x, nondet_s32());
    ASSERT("the count of frames stays", renderer.frame.view.frame == frame);
    ASSERT("refused, the lens stays", renderer.frame.view.lens.centre_x == (status == FXL_OK ? x : before));
    ASSERT("null is refused", fxl_renderer_set_centre(NULL, 0, 0) == FXL_E_ARGUMENT);
    PROOF_ENDS();
}

fxl_status fxl_renderer_init_bare(fxl_renderer *renderer, const fxl_scene *scene, const fxl_lens *lens, const fxl_memory *memory)
{
    (void)renderer, (void)scene, (void)lens, (void)memory;
    return nondet_bool() ? FXL_OK : FXL_E_ARGUMENT;
}

/* [[row]]
 * id = "fxl_renderer_init_with"
 * function = "lib/draw/renderer_init_with.c:fxl_renderer_init_with_for_polygons_of_32"
 * property = "a renderer that is set up has a clipper, an order and a target"
 * checks = 19
 * stubs = { fxl_renderer_init_bare = "any status" }
 */
void prove_renderer_init_with(void)
{
    fxl_renderer renderer;
    renderer.frame.view.lens.off_centre = NULL; /* an orthographic lens: unit tests */
    const fxl_status status = fxl_renderer_init_with(&renderer, NULL, NULL, NULL);
    ASSERT("set up, it has all three", status != FXL_OK || (renderer.clipper == &fxl_clipper_view && renderer.order == &fxl_by_distance &&
                                                           renderer.target == &fxl_palette));
    PROOF_ENDS();
}

bool fxl_beams_fit(const fxl_beam *beams, uint32_t beam_count, uint32_t face_vertices)
{
    ASSERT("as it requires", beams != NULL && beam_count >= 1 && beam_count <= FXL_BEAMS_MAX && face_vertices == 3);
    return nondet_bool();
}

static uint32_t pieces, corners;

uint32_t fxl_lit_pieces_needed(const fxl_beam *beams, uint32_t beam_count)
{
    (void)beams, (void)beam_count;
    return pieces;
}

uint32_t fxl_lit_corners_needed(const fxl_beam *beams, uint32_t beam_count)
{
    (void)beams, (void)beam_count;
    return corners;
}

/* [[row]]
 * function = "lib/draw/beam_light.c:fxl_beam_light_workspace_size"
 * property = "any beams, or null: a multiple of 8 that does not overflow, with room for the corners"
 * checks = 3
 * stubs = { fxl_beams_fit = "its own row", fxl_lit_pieces_needed = "at most 9^4, as its row says", fxl_lit_corners_needed = "up to six for each piece" }
 */
void prove_beam_light_workspace_size(void)
{
    fxl_beam beams[FXL_BEAMS_MAX];
    pieces = nondet_u32();
    corners = nondet_u32();
    ASSUME(pieces >= 1 && pieces <= 6561 && corners >= 3 && corners <= 6561 * 6 + 48);
    const uint32_t size = fxl_beam_light_workspace_size(nondet_bool() ? NULL : beams, nondet_u32());
    ASSERT("a multiple of 8, with room for the corners", size % 8 == 0 && (size == 0 || size >= corners * sizeof(fxl_point)));
    PROOF_ENDS();
}
