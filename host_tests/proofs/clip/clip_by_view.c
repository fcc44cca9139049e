/* SPDX-License-Identifier: MIT */
#include "clip/clip_by_view.c"
#include "proof.h"
#include "view/any_face.h"

static fxl_view view;
static fxl_clipper_work work;
static fxl_screen_polygon screen;

/* Vertices in the cache are in the view; projected ones lie on the screen. */
static bool is_vertex(const fxl_cached_vertex *vertex)
{
    return FXL_POINT_BELOW(&vertex->position, ((int64_t)1 << 61) - 1);
}

static bool on_screen(const fxl_screen_point *point)
{
    return point->x > -32768 && point->x <= (FXL_SCREEN_MAX << 16) + 32768 && point->y > -32768 && point->y <= (FXL_SCREEN_MAX << 16) + 32768;
}

static fxl_cached_vertex fetched;

/* For fxl_fetch_vertex, which has a row of its own: any vertex of the view, or one that was projected. */
fxl_cached_vertex *any_fetch(const fxl_model_view *model_view, uint32_t number)
{
    ASSERT("a vertex of the model", model_view->view == &view && number < VERTICES);
    ANY_CONTENT(&fetched);
    ASSUME(is_vertex(&fetched));
    return &fetched;
}

/* For fxl_project_inside: a vertex inside all planes lies on the screen, to half a pixel. */
fxl_status fxl_project_inside(const fxl_projection *projection, const fxl_view_point *point, fxl_screen_point *place)
{
    fxl_screen_point any;
    ASSERT("in the view", projection == &view.projection && FXL_POINT_BELOW(point, ((int64_t)1 << 61) - 1));
    ASSUME(on_screen(&any));
    *place = any;
    return nondet_bool() ? FXL_OK : FXL_E_RANGE;
}

/* For fxl_face_is_outside, which has a row of its own, and fxl_clip_assembled: any result. */
static bool is_assembled;
bool any_is_outside(const fxl_model_view *model_view, const fxl_face *of)
{
    (void)model_view;
    ASSERT("this face", of == &face);
    return nondet_bool();
}

fxl_clip_result any_assembled(const fxl_model_view *model_view, const fxl_face *of, fxl_clipper_work *to, fxl_screen_polygon *result)
{
    (void)model_view;
    ASSERT("this face", of == &face && to == &work && result == &screen);
    is_assembled = true;
    return (fxl_clip_result)nondet_u32();
}

/* [[row]]
 * function = "fxl_clip_by_view"
 * property = "any face of 3 to 24 corners, any vertices: nothing is out of bounds, and each shift and sum is in its range"
 * checks = 250
 * unwind = 25
 * stands_in = { fxl_fetch_vertex = "any_fetch", fxl_face_is_outside = "any_is_outside", fxl_clip_assembled = "any_assembled" }
 * stubs = { fxl_clip_assembled = "any result: no row proves it", fxl_project_inside = "any place on the screen: that a vertex inside the planes has one is what make report measures" }
 */
void prove_clip_by_view(void)
{
    fxl_model_view of;
    any_face();
    of.view = &view;
    of.indices = indices;
    of.clipper_workspace = NULL;
    is_assembled = false;
    const fxl_clip_result result = fxl_clip_by_view(&of, &face, &work, &screen);
    ASSERT("between, all of the face", is_assembled || result != FXL_CLIP_BETWEEN || (screen.count == face.count && screen.colour == face.material));
    PROOF_ENDS();
}
