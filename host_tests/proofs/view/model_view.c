/* SPDX-License-Identifier: MIT */
#include "view/model_view.c"
#include "view/cull.h"
#include "view/order.h"
#include "proof.h"
#include "any_face.h"

#define ENTRIES 8

static fxl_cached_vertex entries[ENTRIES];
static fxl_vertex_cache cache;
static fxl_view view;

/* A cache of up to 8 entries, in any state. */
static void any_cache(void)
{
    ANY_CONTENT(entries);
    ANY_CONTENT(&cache);
    ANY_CONTENT(&view);
    cache.entries = nondet_bool() ? entries : NULL;
    ASSUME(cache.mask == 0 || (cache.entries != NULL && (cache.mask == 1 || cache.mask == 3 || cache.mask == 7)));
    ASSUME(cache.count % TAG_INSTANCE == 0);
    ASSUME(FXL_DIRECTION(&view.camera.axes.right) && FXL_DIRECTION(&view.camera.axes.up) && FXL_DIRECTION(&view.camera.axes.forward));
    ASSUME(FXL_POINT_BELOW(&view.camera.position, FXL_COORDINATE_MAX));
}

/* [[row]]
 * function = "fxl_vertex_cache_init"
 * property = "caches of up to 8 entries: a power of two, within the memory, and each entry is cleared within it"
 * checks = 101
 * unwind = 18
 */
void prove_vertex_cache_init(void)
{
    const uint32_t count = nondet_u32();
    any_cache();
    ASSUME(count <= ENTRIES);
    fxl_vertex_cache_init(&cache, count != 0 || nondet_bool() ? entries : NULL, count);
    ASSERT("a power of two, at most all", (cache.mask & (cache.mask + 1)) == 0 && cache.mask < (count == 0 ? 1 : count));
    ASSERT("memory for it", (cache.entries == NULL) == (count == 0));
    PROOF_ENDS();
}

/* [[row]]
 * function = "next_tag"
 * property = "caches of up to 8 entries, any state: a tag is never 0, and after the last one no vertex is known"
 * checks = 125
 * unwind = 9
 */
void prove_next_tag(void)
{
    any_cache();
    const uint32_t before = cache.count, i = nondet_u32();
    ASSUME(i <= cache.mask);
    const uint32_t tag = next_tag(&cache);
    ASSERT("never 0, and not that of a vertex", tag != 0 && tag % TAG_INSTANCE == 0);
    ASSERT("begun anew, no vertex is known", tag > before || (entries_of(&cache)[i].tag == 0));
    PROOF_ENDS();
}

/* For next_tag, and for fxl_dot: what its contract says. */
uint32_t any_tag(fxl_vertex_cache *of)
{
    const uint32_t tag = nondet_u32();
    ASSERT("of the cache", of == &cache);
    ASSUME(tag != 0 && tag % TAG_INSTANCE == 0);
    return tag;
}

fxl_q18_46 any_dot(const fxl_direction *direction, int32_t x, int32_t y, int32_t z)
{
    const fxl_q18_46 dot = nondet_s64();
    ASSERT("a direction, below 2^30", FXL_DIRECTION(direction) && WITHIN(x, 1 << 30) && WITHIN(y, 1 << 30) && WITHIN(z, 1 << 30));
    ASSUME(WITHIN(dot, (int64_t)7 << 59));
    return dot;
}

static bool is_model_view(const fxl_model_view *of)
{
    return of->view == &view && of->mask == cache.mask && of->entries == entries_of(&cache) && of->planes == FXL_PLANES_ALL &&
           FXL_POINT_BELOW(&of->translation, (int64_t)7 << 59);
}

/* [[row]]
 * function = "fxl_model_view_of_instance"
 * property = "any instance and eye in the world: nothing overflows, the offset is below 2^30, and the entries are the cache's; caches of up to 8 entries"
 * checks = 430
 * stands_in = { next_tag = "any_tag", fxl_dot = "any_dot" }
 */
void prove_model_view_of_instance(void)
{
    fxl_model_view of;
    fxl_scene scene;
    fxl_instance instance;
    static fxl_model models[2];
    static fxl_point vertices[4];
    any_cache();
    ANY_CONTENT(models);
    scene.models = models;
    scene.vertices = vertices;
    ASSUME(instance.model < 2 && models[instance.model].first_vertex < 4 && FXL_POINT_BELOW(&instance.centre, FXL_COORDINATE_MAX));
    fxl_model_view_of_instance(&of, &scene, &instance, &view, &cache);
    ASSERT("a model view, its offset below 2^30", is_model_view(&of) && FXL_POINT_BELOW(&of.offset, (1 << 30) - 1));
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_model_view_of_polygon"
 * property = "any eye in the world: nothing overflows, the offset is below 2^30, and the entries are the cache's; caches of up to 8 entries"
 * checks = 355
 * stands_in = { next_tag = "any_tag", fxl_dot = "any_dot" }
 */
void prove_model_view_of_polygon(void)
{
    fxl_model_view of;
    static fxl_point points[FXL_POLYGON_CAPACITY];
    any_cache();
    fxl_model_view_of_polygon(&of, points, &view, &cache);
    ASSERT("a model view, its offset below 2^30", is_model_view(&of) && FXL_POINT_BELOW(&of.offset, (1 << 30) - 1));
    PROOF_ENDS();
}

static fxl_cached_vertex fetched;
static uint32_t of_all;

/* For fxl_fetch_vertex, which has a row of its own: any vertex of the model. Keeps which planes all were outside of. */
fxl_cached_vertex *any_fetch(const fxl_model_view *model_view, uint32_t number)
{
    ASSERT("a vertex of the model", model_view->indices == indices && number < VERTICES);
    ANY_CONTENT(&fetched);
    of_all &= fetched.clip_flags;
    return &fetched;
}

/* [[row]]
 * function = "fxl_face_is_outside"
 * property = "any face of 3 to 24 corners: nothing is out of bounds, and it is outside if all that were fetched are outside of one plane"
 * checks = 82
 * unwind = 25
 * stands_in = { fxl_fetch_vertex = "any_fetch" }
 */
void prove_face_is_outside(void)
{
    fxl_model_view of;
    any_face();
    of.indices = indices;
    of_all = FXL_PLANES_ALL;
    const bool is_outside = fxl_face_is_outside(&of, &face);
    ASSERT("outside of one plane", is_outside == (of_all != 0));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/view/model_view.h:fxl_set_face_of_points"
 * property = "any number of points: those of a triangle have the indices 0, 1 and 2, and the listed ones of others begin at 0"
 * checks = 30
 */
void prove_set_face_of_points(void)
{
    const uint32_t count = nondet_u32();
    ASSUME(count >= 3 && count <= FXL_POLYGON_CAPACITY);
    fxl_set_face_of_points(&face, count);
    ASSERT("as many", face.count == count && face.indices[0] == 0);
    ASSERT("of a triangle, or none", count == 3 ? face.indices[1] == 1 && face.indices[2] == 2 : face.indices[1] == 0 && face.indices[2] == 0);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/view/order.h:fxl_draw_entry_of"
 * property = "any distance, index and layer: each member has its part"
 * checks = 4
 */
void prove_draw_entry_of(void)
{
    const uint64_t distance = nondet_u64();
    const uint16_t index = nondet_u16();
    const uint8_t layer = nondet_u8();
    const fxl_draw_entry entry = fxl_draw_entry_of(distance, index, layer);
    ASSERT("the distance in two words", entry.distance_high == distance >> 32 && entry.distance_low == (distance & 0xFFFFFFFF));
    ASSERT("index and layer", entry.index == index && entry.instance.layer == layer && entry.instance.planes == 0);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/view/order.h:fxl_draw_entry_distance"
 * property = "any entry: its two words"
 * checks = 13
 */
void prove_draw_entry_distance(void)
{
    fxl_draw_entry entry;
    ANY_CONTENT(&entry);
    const uint64_t distance = fxl_draw_entry_distance(&entry);
    ASSERT("both words", distance >> 32 == entry.distance_high && (distance & 0xFFFFFFFF) == entry.distance_low);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/view/cull.h:fxl_starts_inside"
 * property = "caches of up to 8 entries, any state: the entry is one of them, and a face of other than three corners is never known to be inside"
 * checks = 102
 */
void prove_starts_inside(void)
{
    fxl_model_view model_view;
    fxl_face face;
    ANY_CONTENT(&model_view);
    ANY_CONTENT(&face);
    any_cache();
    model_view.entries = entries;
    model_view.mask = cache.mask;
    const bool inside = fxl_starts_inside(&model_view, &face);
    const fxl_cached_vertex *entry = &entries[face.indices[0] & cache.mask];
    ASSERT("three corners", !inside || face.count == 3);
    ASSERT("of the vertex, and inside", !inside || (entry->tag == model_view.tag + face.indices[0] && (entry->clip_flags & FXL_PLANES_ALL) == 0));
    PROOF_ENDS();
}
