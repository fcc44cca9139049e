/* SPDX-License-Identifier: MIT */
#include "draw/render.c"
#include "draw/workspace.c"
#include "draw/pieces.c"
#include "fixel/billboards.h"
#include "scene/lens.h"
#include "proof.h"

/* [[row]]
 * function = "fxl_count_outcome"
 * property = "any outcome: a face is counted once, or the display list is what it was"
 * checks = 38
 */
void prove_count_outcome(void)
{
    fxl_traversal traversal;
    fxl_counters counters;
    fxl_display_list list;
    const fxl_outcome outcome = nondet_u32();
    const uint32_t used = nondet_u32(), before = list.used;
    ASSUME(counters.outside == 0 && counters.refused == 0 && counters.drawn == 0 && counters.degenerate == 0);
    traversal.counters = &counters;
    traversal.display_list = nondet_bool() ? NULL : &list;
    const bool counted = fxl_count_outcome(&traversal, outcome, used);
    ASSERT("a face is counted once", counters.outside + counters.refused + counters.drawn + counters.degenerate == (counted ? 1u : 0u));
    ASSERT("where the list is full, it is as before", list.used == (counted || traversal.display_list == NULL ? before : used));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/submit.h:fxl_count_drawn"
 * property = "any counters: of a face that is drawn at once they count what fxl_count_outcome counts of it"
 * checks = 57
 */
void prove_count_drawn(void)
{
    fxl_traversal traversal;
    fxl_counters counters, others = counters;
    const fxl_clip_result cut = nondet_bool() ? FXL_CLIP_INSIDE : FXL_CLIP_CUT;
    const bool has_rows = nondet_bool();
    traversal.counters = &others;
    fxl_count_drawn(&counters, cut, has_rows);
    (void)fxl_count_outcome(&traversal, (fxl_outcome)1 << cut | (has_rows ? FXL_OUTCOME_SPILLED : 0), 0);
    ASSERT("the same", counters.drawn == others.drawn && counters.clipped == others.clipped && counters.spilled == others.spilled);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/workspace.c:fxl_cache_entries"
 * property = "up to 2 models of any size: it ends, with a power of two that fits the memory"
 * checks = 30
 * unwind = 19
 */
void prove_cache_entries(void)
{
    fxl_scene scene;
    fxl_model models[2];
    const size_t bytes = nondet_size();
    scene.models = models;
    ASSUME(scene.model_count <= 2 && models[0].vertex_count <= FXL_MODEL_VERTICES_MAX && models[1].vertex_count <= FXL_MODEL_VERTICES_MAX);
    const uint32_t entries = fxl_cache_entries(&scene, bytes);
    ASSERT("a power of two, or none", (entries & (entries - 1u)) == 0 && entries <= 65536);
    ASSERT("within the memory", entries <= bytes / sizeof(fxl_cached_vertex));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/pieces.c:fxl_pieces_end"
 * property = "any outcome of pieces: a face is counted once"
 * checks = 55
 */
void prove_pieces_end(void)
{
    fxl_pieces pieces;
    fxl_traversal traversal;
    fxl_counters counters;
    ASSUME(counters.outside == 0 && counters.refused == 0 && counters.drawn == 0 && counters.degenerate == 0);
    traversal.counters = &counters;
    traversal.display_list = NULL;
    pieces.traversal = &traversal;
    const bool counted = fxl_pieces_end(&pieces);
    ASSERT("a face is counted once, whatever its pieces", counters.outside + counters.refused + counters.drawn + counters.degenerate == (counted ? 1u : 0u));
    PROOF_ENDS();
}

/* --- what a workspace was set up for -------------------------------------------------------- */

/* A renderer with up to two shaders, of which the first may be that of beams. */
static fxl_beam_shader first;
static fxl_shader second;
static fxl_scene scene;
static fxl_model models[2];
static fxl_clipper clipper;
static fxl_order order;
static fxl_target target, painted;
static fxl_off_centre_code off_centre;
static fxl_target_extras extras;
static fxl_billboards billboards;

/* One of two pointers: CBMC compares those that point nowhere to themselves in more than one way. */
#define EITHER(a, b) (nondet_bool() ? (a) : (b))

static uint32_t any_size_of(const fxl_scene *of)
{
    (void)of;
    return nondet_u32();
}

static void make_any(fxl_renderer *renderer)
{
    ANY_CONTENT(&first);
    ANY_CONTENT(&second);
    ANY_CONTENT(&scene);
    ANY_CONTENT(models);
    ANY_CONTENT(&clipper);
    ANY_CONTENT(&order);
    ANY_CONTENT(&target);
    ANY_CONTENT(&extras);
    second.next = NULL;
    first.shader.next = EITHER(NULL, &second);
    ASSUME(second.rank != FXL_SHADER_BEAMS); /* whose record is a larger one */
    scene.models = models;
    ASSUME(scene.model_count <= 2);
    order.memory_size = EITHER(NULL, any_size_of);
    extras.outlined = EITHER(NULL, &painted);
    target.extras = EITHER(NULL, &extras);
    renderer->shader = EITHER(NULL, &first.shader);
    renderer->billboards = EITHER(NULL, &billboards);
    renderer->frame.view.lens.off_centre = EITHER(NULL, &off_centre);
    renderer->scene = &scene;
    renderer->clipper = &clipper;
    renderer->order = &order;
    renderer->target = &target;
}

/* [[row]]
 * function = "lib/draw/renderer.h:fxl_workspace_begin"
 * property = "any workspace: no shade and no order of faces is left"
 * checks = 20
 */
void prove_workspace_begin(void)
{
    fxl_workspace workspace;
    const bool counted = nondet_bool();
    fxl_workspace_begin(&workspace, counted);
    ASSERT("no face is lit or sorted", workspace.screen.shade == 0 && workspace.sorted_instance == UINT16_MAX);
    ASSERT("counted as told", workspace.rest_counted == counted);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/workspace.c:are_equal"
 * property = "any two records up to a camera's size: whether all bytes are the same, and none beyond is read"
 * checks = 34
 * unwind = 50
 */
/* No record that is compared is larger than a camera. */
void prove_are_equal(void)
{
    uint8_t a[sizeof(fxl_camera)], b[sizeof(fxl_camera)];
    const size_t size = nondet_size(), at = nondet_size();
    ASSUME(size <= sizeof a && LENS_BYTES <= sizeof a);
    const bool equal = are_equal(a, b, size);
    ASSERT("equal: each byte is", !equal || at >= size || a[at] == b[at]);
    bool differs = false;
    for (size_t i = 0; i < sizeof a; i++) {
        differs = differs || (i < size && a[i] != b[i]);
    }
    ASSERT("not equal: a byte differs", equal || differs);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/workspace.c:has_room"
 * property = "up to 2 models, any room: whether the tables are the same ones and each sorted model fits"
 * checks = 130
 */
void prove_has_room(void)
{
    fxl_renderer renderer;
    fxl_workspace_room room;
    make_any(&renderer);
    room.models = EITHER(NULL, models);
    const bool has = has_room(&room, &renderer);
    const bool fits_0 = scene.model_count < 1 || models[0].kind != FXL_MODEL_SORTED || models[0].face_count <= room.face_room;
    const bool fits_1 = scene.model_count < 2 || models[1].kind != FXL_MODEL_SORTED || models[1].face_count <= room.face_room;
    ASSERT("the same tables, and room for each sorted model", has == (room.models == models && fits_0 && fits_1 &&
                                                                     room.tree_size == fxl_tree_scratch_size(&renderer)));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/workspace.c:note_settings"
 * property = "any renderer of up to 2 shaders: what is noted is current as long as nothing changes"
 * checks = 505
 * unwind = 50
 */
/* What was noted is current as long as nothing is changed; a change of one member is noticed. */
void prove_note_settings(void)
{
    fxl_renderer renderer;
    fxl_workspace workspace;
    make_any(&renderer);
    note_settings(&workspace.work.setup, &renderer);
    workspace.settings_number = renderer.workspace.settings_number;
    ASSUME(renderer.frame.state == FXL_FRAME_RELEASED);
    ASSERT("current, but at the last number", is_current(&workspace, &renderer) == (workspace.settings_number != UINT32_MAX));
    PROOF_ENDS();
}

static const fxl_lens *lens;
static bool lens_is_equal, camera_is_equal;

bool any_are_equal(const void *a, const void *b, size_t size)
{
    const bool is_lens = b == lens;
    const bool equal = nondet_bool();
    ASSERT("a lens without its code, or a camera", a != b && size == (is_lens ? LENS_BYTES : sizeof(fxl_camera)));
    lens_is_equal = lens_is_equal || (is_lens && equal);
    camera_is_equal = camera_is_equal || (!is_lens && equal);
    return equal;
}

/* [[row]]
 * function = "lib/draw/workspace.c:is_current"
 * property = "any renderer of up to 2 shaders, any workspace: current only with the same number, parts, shaders, sizes, lens and camera"
 * checks = 483
 * unwind = 8
 * stands_in = { are_equal = "any_are_equal" }
 */
void prove_is_current(void)
{
    fxl_renderer renderer;
    fxl_workspace workspace;
    lens = &renderer.frame.view.lens;
    lens_is_equal = camera_is_equal = false;
    make_any(&renderer);
    fxl_workspace_setup *const setup = &workspace.work.setup;
    setup->scene = EITHER(NULL, &scene);
    setup->clipper = EITHER(NULL, &clipper);
    setup->order = EITHER(NULL, &order);
    setup->target = EITHER(NULL, EITHER(&target, &painted));
    setup->billboards = EITHER(NULL, &billboards);
    setup->lens.off_centre = EITHER(NULL, &off_centre);
    setup->room.models = EITHER(NULL, models);
    for (uint32_t i = 0; i < FXL_SHADERS_MAX; i++) {
        setup->shaders[i] = EITHER(NULL, EITHER(&first.shader, &second));
    }
    const uint32_t rank = nondet_u32();
    ASSUME(rank < FXL_SHADERS_MAX);
    switch (nondet_u8()) {
    case 0: renderer.scene = NULL; break;
    case 1: renderer.clipper = NULL; break;
    case 2: renderer.target = NULL; break;
    case 3: renderer.order = NULL; break;
    default: break;
    }
    if (is_current(&workspace, &renderer)) {
        ASSERT("it is set up", renderer.scene != NULL && renderer.clipper != NULL && renderer.target != NULL && renderer.order != NULL);
        ASSERT("of one number", workspace.settings_number == renderer.workspace.settings_number && workspace.settings_number != UINT32_MAX);
        ASSERT("of the same parts", setup->scene == renderer.scene && setup->clipper == renderer.clipper && setup->order == renderer.order &&
                                        setup->billboards == renderer.billboards && setup->target == fxl_painted_target(&renderer));
        ASSERT("of the same shaders", setup->shaders[rank] == fxl_renderer_shader(&renderer, rank));
        ASSERT("of the same sizes", setup->beam_size == fxl_beam_scratch_size(&renderer) && setup->clipper_size == clipper.workspace_size);
        ASSERT("of the same lens", lens_is_equal && setup->lens.off_centre == lens->off_centre);
        ASSERT("of another frame, or the same camera", setup->frame != renderer.frame.view.frame || camera_is_equal);
        ASSERT("with room, or a frame that reads no model", renderer.frame.state == FXL_FRAME_RELEASED || has_room(&setup->room, &renderer));
    }
    PROOF_ENDS();
}

static bool is_drawn, was_current, is_noted;

fxl_status any_draw_in_workspace(const fxl_renderer *renderer, fxl_workspace *workspace, const fxl_band *band)
{
    (void)band;
    ASSERT("once, in the renderer's own, or in one that was set up for it", !is_drawn && (workspace == &renderer->workspace || was_current));
    ASSERT("begun, unless it is the renderer's own", !was_current || (workspace->rest_counted && workspace->sorted_instance == UINT16_MAX));
    ANY_CONTENT(workspace); /* what it was set up for lies where drawing works */
    is_drawn = true;
    return nondet_bool() ? FXL_OK : FXL_E_RANGE;
}

void any_note_settings(fxl_workspace_setup *setup, const fxl_renderer *renderer)
{
    ASSERT("after it has drawn, for the renderer that drew", is_drawn && was_current && setup != NULL && renderer->scene == &scene);
    is_noted = true;
}

bool any_is_current(const fxl_workspace *workspace, const fxl_renderer *renderer)
{
    ASSERT("another than the renderer's own", workspace != &renderer->workspace);
    was_current = nondet_bool();
    return was_current;
}

fxl_status any_refuse(fxl_workspace *workspace, fxl_status status)
{
    ASSERT("counted in a workspace", workspace != NULL);
    return status;
}

#if !defined(CASE) || CASE == 1
#define WORKSPACE(renderer, other) (other)
#elif CASE == 2
#define WORKSPACE(renderer, other) (&(renderer)->workspace)
#else
#define WORKSPACE(renderer, other) NULL
#endif

/* [[row]]
 * function = "lib/draw/workspace.c:fxl_frame_draw_with"
 * property = "any renderer and workspace, and null pointers: draws in the renderer's own or a current one alone, else refuses; a workspace's room stays; up to 2 models"
 * checks = 192
 * cases = [1, 2, 3]
 * stands_in = { fxl_draw_in_workspace = "any_draw_in_workspace", is_current = "any_is_current", note_settings = "any_note_settings", fxl_refuse = "any_refuse" }
 * stubs = { fxl_draw_in_workspace = "any status: it is measured" }
 */
void prove_frame_draw_with(void)
{
    fxl_renderer renderer;
    fxl_workspace other, *const workspace = WORKSPACE(&renderer, &other);
    const fxl_renderer *const by = EITHER(NULL, &renderer);
    fxl_band band;
    renderer.scene = &scene;
    is_drawn = was_current = is_noted = false;
    const fxl_workspace_room room = {models, nondet_u32(), nondet_u32()};
    other.work.setup.room = room;
    const fxl_status status = fxl_frame_draw_with(by, workspace, EITHER(NULL, &band));
    ASSERT("drawn, or refused", is_drawn || status == FXL_E_ARGUMENT || status == FXL_E_ORDER);
    ASSERT("null is refused", (workspace != NULL && by != NULL) || (!is_drawn && status == FXL_E_ARGUMENT));
    ASSERT("drawn wherever it may be", is_drawn == (workspace != NULL && by != NULL && (workspace == &renderer.workspace || was_current)));
    ASSERT("noted in each but the renderer's own", is_noted == (is_drawn && workspace == &other));
    ASSERT("the room that it was set up for stays", other.work.setup.room.models == models && other.work.setup.room.tree_size == room.tree_size &&
                                                        other.work.setup.room.face_room == room.face_room);
    PROOF_ENDS();
}
