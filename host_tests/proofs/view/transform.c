/* SPDX-License-Identifier: MIT */
#include "view/transform.c"
#include "view/outcode.c"
#include "proof.h"

/* [[row]]
 * function = "lib/view/model_view.h:fxl_rotate"
 * property = "no sum overflows, for an origin below 2^62"
 * checks = 293
 * contract = true
 * uses = ["fxl_dot"]
 */
void prove_rotate(void)
{
    fxl_axes *axes;
    fxl_point *point;
    fxl_view_point *origin, *sum;
    fxl_rotate(axes, point, origin, sum);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_transform_point"
 * property = "no sum overflows, and each coordinate is below 7 2^59"
 * checks = 348
 * contract = true
 * uses = ["fxl_dot", "fxl_point_in_range", "fxl_subtract"]
 */
void prove_transform_point(void)
{
    fxl_camera *camera;
    fxl_point *point;
    fxl_view_point *view;
    fxl_transform_point(camera, point, view);
    PROOF_ENDS();
}

/* --- a vertex of a model ---------------------------------------------------------------------- */

#define VERTICES 4

static fxl_view view;
static fxl_point vertices[VERTICES];
static fxl_cached_vertex entries[VERTICES];

/* For a turned instance's scale_vertex: any flags. */
static uint32_t any_scale_vertex(const fxl_model_view *model_view, fxl_cached_vertex *entry)
{
    ASSERT("of this model view", (model_view->planes & FXL_MODEL_VIEW_SCALED) != 0);
    entry->clip_flags = nondet_u32();
    return entry->clip_flags;
}

static fxl_model_view any_model_view(void)
{
    fxl_model_view of;
    const fxl_axes *axes = &view.camera.axes;
    ANY_CONTENT(&view);
    ANY_CONTENT(vertices);
    ANY_CONTENT(entries);
    ASSUME(FXL_DIRECTION(&axes->right) && FXL_DIRECTION(&axes->up) && FXL_DIRECTION(&axes->forward));
    ASSUME(of.mask == 0 || of.mask == 1 || of.mask == 3);
    ASSUME(FXL_POINT_BELOW(&of.translation, (int64_t)1 << 61));
    for (int i = 0; i < VERTICES; i++) {
        ASSUME(FXL_POINT_BELOW(&vertices[i], 1 << 30));
    }
    of.view = &view;
    of.axes = axes;
    of.vertices = vertices;
    of.entries = entries;
    of.scale_vertex = any_scale_vertex;
    return of;
}

/* For fxl_outside: what an outcode is. */
unsigned any_outside(const fxl_view_frustum *frustum, unsigned planes, const fxl_view_point *point)
{
    (void)point;
    ASSERT("of the view", frustum == &view.view_frustum);
    return nondet_u32() & ((planes & FXL_PLANES_ALL) | FXL_OUTSIDE_IS_OPEN);
}

/* For fxl_outcode, of a vertex whose upper words do not decide. */
fxl_planes any_outcode(const fxl_view_frustum *frustum, fxl_planes planes, const fxl_view_point *point)
{
    (void)point;
    ASSERT("of the view", frustum == &view.view_frustum);
    return nondet_u8() & planes & FXL_PLANES_ALL;
}

/* [[row]]
 * function = "fxl_transform_vertex"
 * property = "any model view, any vertex below 2^30: no sum overflows, and the entry gets the vertex's tag; up to 4 vertices"
 * checks = 427
 * uses = ["fxl_rotate"]
 * stands_in = { fxl_outside = "any_outside", fxl_outcode = "any_outcode" }
 */
void prove_transform_vertex(void)
{
    const fxl_model_view of = any_model_view();
    const uint32_t number = nondet_u32();
    ASSUME(number < VERTICES);
    fxl_cached_vertex *entry = &entries[number & of.mask];
    fxl_transform_vertex(&of, number, entry);
    ASSERT("its tag", entry->tag == of.tag + number);
    ASSERT("unprojected", (of.planes & FXL_MODEL_VIEW_SCALED) != 0 || (entry->clip_flags & FXL_VERTEX_UNPROJECTED) != 0);
    PROOF_ENDS();
}

/* For fxl_transform_vertex. */
void any_vertex(const fxl_model_view *model_view, uint32_t number, fxl_cached_vertex *entry)
{
    ASSERT("an entry of the cache", entry == &entries[number & model_view->mask] && number < VERTICES);
    entry->tag = model_view->tag + number;
}

/* [[row]]
 * function = "lib/view/model_view.h:fxl_fetch_vertex"
 * property = "caches of up to 4 entries, any state: the entry of the vertex, in the cache"
 * checks = 224
 * stands_in = { fxl_transform_vertex = "any_vertex" }
 */
void prove_fetch_vertex(void)
{
    const fxl_model_view of = any_model_view();
    const uint32_t number = nondet_u32();
    ASSUME(number < VERTICES);
    const fxl_cached_vertex *entry = fxl_fetch_vertex(&of, number);
    ASSERT("the vertex", entry->tag == of.tag + number);
    ASSUME(FXL_POINT_BELOW(&of.offset, (1 << 30) - 1));
    (void)fxl_model_view_vertex(&of, number); /* a vertex and an offset below 2^30 */
    PROOF_ENDS();
}

/* For fxl_view_distance: what its contract says. */
fxl_q18_46 any_distance(const fxl_view_frustum *frustum, int plane, const fxl_view_point *point)
{
    (void)frustum;
    ASSERT("of a plane, and in the view", plane >= 0 && plane < FXL_PLANE_COUNT && FXL_POINT_BELOW(point, ((int64_t)1 << 61) - 1));
    return nondet_s64();
}

/* [[row]]
 * function = "lib/view/outcode.c:fxl_outside_of_pair"
 * property = "any point of the view: bits of the pair alone"
 * checks = 49
 * stands_in = { fxl_view_distance = "any_distance" }
 */
void prove_outside_of_pair(void)
{
    fxl_view_point point;
    const int plane = nondet_bool() ? FXL_PLANE_LEFT : FXL_PLANE_BOTTOM;
    ASSUME(FXL_POINT_BELOW(&point, ((int64_t)1 << 61) - 1));
    ASSERT("bits of the pair", (fxl_outside_of_pair(&view.view_frustum, plane, &point) & ~(3u << plane)) == 0);
    PROOF_ENDS();
}

/* For fxl_outside_of_pair. */
unsigned any_pair(const fxl_view_frustum *frustum, int plane, const fxl_view_point *point)
{
    (void)frustum;
    ASSERT("a pair, in the view", (plane == FXL_PLANE_LEFT || plane == FXL_PLANE_BOTTOM) && FXL_POINT_BELOW(point, ((int64_t)1 << 61) - 1));
    return (nondet_u8() & 3u) << plane;
}

/* [[row]]
 * function = "lib/view/outcode.h:fxl_outside"
 * property = "any frustum and point of the view: no sum overflows, and bits of the given planes alone, or that a pair is open"
 * checks = 208
 */
void prove_outside(void)
{
    fxl_view_point point;
    const fxl_planes planes = nondet_u8() & FXL_PLANES_ALL;
    ANY_CONTENT(&view);
    ASSUME(FXL_FRUSTUM(&view.view_frustum) && FXL_POINT_BELOW(&point, ((int64_t)1 << 61) - 1));
    ASSERT("some of the planes", (fxl_outside(&view.view_frustum, planes, &point) & ~(planes | FXL_OUTSIDE_IS_OPEN)) == 0);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/view/outcode.c:fxl_outcode"
 * property = "any frustum and point of the view: bits of the given planes alone, also where a pair is open"
 * checks = 87
 * stands_in = { fxl_outside = "any_outside", fxl_outside_of_pair = "any_pair" }
 */
void prove_outcode(void)
{
    fxl_view_point point;
    const fxl_planes planes = nondet_u8() & FXL_PLANES_ALL;
    ANY_CONTENT(&view);
    ASSUME(FXL_FRUSTUM(&view.view_frustum) && FXL_POINT_BELOW(&point, ((int64_t)1 << 61) - 1));
    ASSERT("some of the planes", (fxl_outcode(&view.view_frustum, planes, &point) & ~planes) == 0);
    PROOF_ENDS();
}
