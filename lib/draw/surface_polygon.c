/* SPDX-License-Identifier: MIT */
#include "../scene/face_bounds.h"
#include "../view/model_view.h"
#include "../view/outcode.h"
#include "../view/project.h"
#include "surface_polygon.h"

#include "../math/arith.h"
#include "../math/family.h"
#include "../math/memory.h"
#include "scratch.h"
#include "../paint/light_row.h"
#include "../paint/texture_level.h"

/* A record: what every record begins with, whose count is that of all pairs of words after it and
 * whose shade is that of the points; the points; the first two words below; with a surface
 * two more, its weight and its attributes; with a depth its unit and its gradient. */
#define FIRST_WORDS    2u /* surface, level and shade; shifts and count */
#define SURFACE_WORDS  2u /* weight_min */
#define UNIT_WORDS     2u /* the depth's unit, and 0 */
#define GRADIENT_WORDS 6u

/* What stands above the surface in the first word. */
#define IN_BEAM 0x10000u
#define EVENLY_LIT \
    0x20000u /* the light's upper byte is in the shade's place, its lower one in that \
              * of the third shift */
#define HAS_DEPTH 0x80000u
#define LEVEL_AT  20
#define SHADE_AT  24

FXL_STATIC_ASSERT(sizeof(fxl_gradient) == GRADIENT_WORDS * sizeof(uint32_t), "no padding");
FXL_STATIC_ASSERT(FXL_TEXTURE_LOG_MAX < 16, "bits of the first word");
FXL_STATIC_ASSERT(offsetof(fxl_gradients, count) == offsetof(fxl_gradients, shifts) + 3,
                  "the second word");
FXL_STATIC_ASSERT(offsetof(fxl_gradients, shifts) % sizeof(uint32_t) == 0,
                  "it is copied as a word");
FXL_STATIC_ASSERT(FXL_POLYGON_CAPACITY + (FIRST_WORDS + SURFACE_WORDS + UNIT_WORDS +
                                          GRADIENT_WORDS * (2 + FXL_ATTRIBUTES)) /
                                             2 <=
                      255,
                  "8 bits for the count of pairs");

/* An even number. */
static uint32_t words_beside(const fxl_surface_polygon *polygon)
{
    uint32_t words = FIRST_WORDS;
    if (polygon->surface != FXL_NO_SURFACE) {
        words += SURFACE_WORDS + GRADIENT_WORDS * (1 + polygon->gradients.count);
    }
    return words + (polygon->has_depth ? UNIT_WORDS + GRADIENT_WORDS : 0);
}

/* In place, so that the compiler copies words: a call takes longer than what it copies. */
FXL_ONCE uint32_t *put(uint32_t *to, const void *from, uint32_t words)
{
    __builtin_memcpy(__builtin_assume_aligned(to, sizeof *to),
                     __builtin_assume_aligned(from, sizeof *to), words * sizeof *to);
    return to + words;
}

FXL_ONCE const uint32_t *get(const uint32_t *from, void *to, uint32_t words)
{
    __builtin_memcpy(__builtin_assume_aligned(to, sizeof *from),
                     __builtin_assume_aligned(from, sizeof *from), words * sizeof *from);
    return from + words;
}

FXL_STATIC_ASSERT(offsetof(fxl_gradients, weight) == 0 &&
                      offsetof(fxl_gradients, attributes) == sizeof(fxl_gradient),
                  "the attributes follow the weight");

/* The weight and the attributes: as many words as their count says, or each by itself in place. */
static inline uint32_t *put_gradients(uint32_t *to, const fxl_gradients *from)
{
    if (FXL_IS_COMPACT) {
        return put(to, from, GRADIENT_WORDS * (1u + from->count));
    }
    to = put(to, &from->weight, GRADIENT_WORDS);
    for (uint32_t i = 0; i < from->count && i < FXL_ATTRIBUTES; i++) {
        to = put(to, &from->attributes[i], GRADIENT_WORDS);
    }
    return to;
}

static inline const uint32_t *get_gradients(const uint32_t *from, fxl_gradients *to)
{
    if (FXL_IS_COMPACT) {
        return get(from, to, GRADIENT_WORDS * (1u + to->count));
    }
    from = get(from, &to->weight, GRADIENT_WORDS);
    for (uint32_t i = 0; i < to->count && i < FXL_ATTRIBUTES; i++) {
        from = get(from, &to->attributes[i], GRADIENT_WORDS);
    }
    return from;
}

bool fxl_surface_polygon_append(fxl_display_list *list, const fxl_screen_polygon *screen,
                                fxl_rows rows, const fxl_surface_polygon *polygon)
{
    const fxl_gradients *gradients = &polygon->gradients;
    const uint32_t beside = words_beside(polygon);
    const uint32_t words = FXL_DISPLAY_LIST_WORDS((uint32_t)screen->count) + beside;
    FXL_ASSERT(rows.first < rows.end && list->used <= list->capacity);
    if (list->capacity - list->used < words) {
        return false;
    }
    uint32_t *to = list->words + list->used;
    to[0] = (uint32_t)rows.end << 16 | rows.first;
    uint8_t *head = (uint8_t *)(to + 1);
    head[0] = screen->colour;
    head[1] = (uint8_t)(screen->count + beside / 2);
    head[2] = polygon->surface != FXL_NO_SURFACE ? FXL_POLYGON_SURFACE : FXL_POLYGON_DEPTH;
    head[3] = screen->count;
    memcpy(to + 2, screen->points, screen->count * sizeof screen->points[0]);
    to += 2 + 2u * screen->count;
    uint32_t first = polygon->surface | (uint32_t)polygon->level << LEVEL_AT |
                     (uint32_t)polygon->shade << SHADE_AT |
                     (polygon->has_depth ? HAS_DEPTH : 0) | (polygon->is_in_beam ? IN_BEAM : 0);
    (void)put(to + 1, gradients->shifts, 1);
    if (polygon->is_evenly_lit) {
        first |= EVENLY_LIT | (uint32_t)(polygon->light >> 8) << SHADE_AT;
        ((uint8_t *)(to + 1))[FXL_ATTRIBUTES - 1] = fxl_low_8(polygon->light);
    }
    *to = first;
    to += FIRST_WORDS;
    if (polygon->surface != FXL_NO_SURFACE) {
        to = put(to, gradients->weight_min, SURFACE_WORDS);
        to = put_gradients(to, gradients);
    }
    if (polygon->has_depth) {
        to[0] = fxl_bits_32(polygon->depth.one);
        to[1] = 0;
        (void)put(to + UNIT_WORDS, &polygon->depth.gradient, GRADIENT_WORDS);
    }
    list->used += words;
    return true;
}

uint32_t fxl_surface_polygon_read(const fxl_screen_polygon *record, fxl_surface_polygon *polygon)
{
    fxl_gradients *gradients = &polygon->gradients;
    const uint32_t count = fxl_surface_polygon_points(record);
    const uint32_t *from = (const uint32_t *)(const void *)(record->points + count);
    const uint32_t first = *from++;
    polygon->surface = fxl_low_16(first);
    polygon->colour = record->colour;
    polygon->level = (uint8_t)(first >> LEVEL_AT & 15u);
    polygon->has_depth = (first & HAS_DEPTH) != 0;
    polygon->is_in_beam = (first & IN_BEAM) != 0;
    polygon->shade = (uint8_t)(first >> SHADE_AT);
    from = get(from, (uint8_t *)gradients + offsetof(fxl_gradients, shifts), 1);
    polygon->is_evenly_lit = (first & EVENLY_LIT) != 0;
    polygon->light = (uint16_t)((first >> SHADE_AT) << 8 |
                                fxl_low_8(fxl_bits_32(gradients->shifts[FXL_ATTRIBUTES - 1])));
    if (polygon->surface != FXL_NO_SURFACE) {
        from = get(from, gradients->weight_min, SURFACE_WORDS);
        from = get_gradients(from, gradients);
    }
    if (polygon->has_depth) {
        polygon->depth.one = fxl_signed_32(from[0]);
        (void)get(from + UNIT_WORDS, &polygon->depth.gradient, GRADIENT_WORDS);
    }
    return count;
}

void fxl_find_corner(const fxl_model_view *model_view, uint32_t number,
                     const fxl_traversal *traversal, fxl_view_point *corner)
{
    if (traversal->clipper->by_clip_flags) {
        *corner = fxl_fetch_vertex(model_view, number)->position;
    } else {
        fxl_cached_vertex vertex;
        fxl_transform_vertex(model_view, number, &vertex);
        *corner = vertex.position;
    }
}

/* A vertex between the near and the far plane, in the view and on the screen, or beside it. False:
 * it cannot be projected. Which planes the model view leaves out, and what a cache of few vertices
 * displaced, changes nothing. */
/* SPEC 9.3, surfaces 2.3 */
static bool find_on_screen(const fxl_model_view *model_view, uint32_t number,
                           const fxl_traversal *traversal, fxl_screen_point *point,
                           fxl_q18_46 *depth)
{
    fxl_cached_vertex other;
    const fxl_cached_vertex *vertex = &other;
    if (traversal->clipper->by_clip_flags) {
        vertex = fxl_fetch_vertex(model_view, number);
    } else {
        fxl_transform_vertex(model_view, number, &other);
    }
    *depth = vertex->position.z;
    if ((vertex->clip_flags & FXL_VERTEX_OUTSIDE) == 0) {
        *point = vertex->screen;
        return true;
    }
    return (vertex->clip_flags & FXL_PLANES_DEPTH) == 0 &&
           fxl_project_visible(&model_view->view->projection, &vertex->position, point) == FXL_OK;
}

/* A vertex that the clipper has projected, if it is in the cache: mostly. Else null. */
static inline const fxl_cached_vertex *projected_of(const fxl_model_view *model_view,
                                                    uint32_t number)
{
    const fxl_cached_vertex *vertex = &model_view->entries[number & model_view->mask];
    return vertex->tag == model_view->tag + number &&
                   (vertex->clip_flags & FXL_VERTEX_OUTSIDE) == 0
               ? vertex
               : NULL;
}

/* The same, at once if it can be. */
static __attribute__((noinline)) bool find_vertex(const fxl_model_view *model_view, uint32_t number,
                                                  const fxl_traversal *traversal,
                                                  fxl_screen_point *point, fxl_q18_46 *depth)
{
    if (!FXL_IS_SMALL && traversal->clipper->by_clip_flags) {
        const fxl_cached_vertex *vertex = projected_of(model_view, number);
        if (vertex != NULL) {
            *point = vertex->screen;
            *depth = vertex->position.z;
            return true;
        }
    }
    return find_on_screen(model_view, number, traversal, point, depth);
}

typedef struct {
    int32_t left, right, top, bottom;
} screen_box;

static inline void add_point(screen_box *box, const fxl_screen_point *point)
{
    box->left = point->x < box->left ? point->x : box->left;
    box->right = point->x > box->right ? point->x : box->right;
    box->top = point->y < box->top ? point->y : box->top;
    box->bottom = point->y > box->bottom ? point->y : box->bottom;
}

/* What the box of all vertices says of the corners. */
static inline bool have_box(fxl_screen_corners *corners, const screen_box *box, bool is_triangle)
{
    corners->width = box->right - box->left;
    corners->height = box->bottom - box->top;
    corners->is_triangle = is_triangle;
    return true;
}

static inline void begin_box(screen_box *box, const fxl_screen_point *a, const fxl_screen_point *b,
                             const fxl_screen_point *c)
{
    box->left = box->right = a->x;
    box->top = box->bottom = a->y;
    add_point(box, b);
    add_point(box, c);
}

#if !FXL_IS_COMPACT /* which has one call of it */
__attribute__((noinline))
#endif
static bool has_vertex(const uint16_t *indices, uint32_t count, uint32_t number)
{
    uint32_t place = 0;
    while (place < count && indices[place] != number) {
        place++;
    }
    return place < count;
}

/* The corners of a face that is no part of another, where all of its vertices are projected and in the
 * cache. */
static inline bool find_projected(const fxl_model_view *model_view, const fxl_face *face,
                                  const fxl_corner *const of[3], const fxl_scene *scene,
                                  fxl_screen_corners *corners)
{
    screen_box box;
    const uint32_t count = face->count;
    const uint16_t *indices = fxl_face_indices(scene->indices, face);
    if (fxl_is_part(scene, face)) {
        return false;
    }
    uint32_t others = 3; /* the first vertex that is no corner, if it is not known which are */
    FXL_EACH_CORNER
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t number = of[i]->vertex;
        const fxl_cached_vertex *vertex = projected_of(model_view, number);
        if (vertex == NULL) {
            return false;
        }
        if (number != indices[i]) {
            others = count == 3 ? 3 : 0;
            if (!has_vertex(indices, count, number)) {
                return false;
            }
        }
        corners->points[i] = vertex->screen;
        corners->depths[i] = vertex->position.z;
    }
    begin_box(&box, &corners->points[0], &corners->points[1], &corners->points[2]);
    for (uint32_t i = others; i < count; i++) {
        const fxl_cached_vertex *vertex = projected_of(model_view, indices[i]);
        if (vertex == NULL) {
            return false;
        }
        add_point(&box, &vertex->screen);
    }
    return have_box(corners, &box, count == 3);
}

/* Any face. Not inline: what it has would stay on the stack of triangles. */
static __attribute__((noinline)) bool
find_corners(const fxl_model_view *model_view, const fxl_face *face, const fxl_corner *const of[3],
             const fxl_traversal *traversal, fxl_screen_corners *corners)
{
    const fxl_face_outline outline = fxl_whole_face(traversal->renderer->scene, face);
    const uint16_t *indices = outline.indices;
    const uint32_t count = outline.count;
    const uint16_t vertices[3] = {of[0]->vertex, of[1]->vertex, of[2]->vertex};
    screen_box box;
    for (uint32_t i = 0; i < 3; i++) {
        if (!has_vertex(indices, count, vertices[i])) {
            return false;
        }
    }
    for (uint32_t i = 0; i < 3; i++) {
        if (!find_vertex(model_view, vertices[i], traversal, &corners->points[i],
                         &corners->depths[i])) {
            return false;
        }
    }
    begin_box(&box, &corners->points[0], &corners->points[1], &corners->points[2]);
    for (uint32_t i = 0; count > 3 && i < count; i++) {
        fxl_screen_point point;
        fxl_q18_46 depth;
        const uint32_t number = indices[i];
        if (number == vertices[0] || number == vertices[1] || number == vertices[2]) {
            continue;
        }
        if (!find_vertex(model_view, number, traversal, &point, &depth)) {
            return false;
        }
        add_point(&box, &point);
    }
    return have_box(corners, &box, count == 3);
}

bool fxl_find_screen_corners(const fxl_model_view *model_view, const fxl_face *face,
                             const fxl_corner *const of[3], const fxl_traversal *traversal,
                             fxl_screen_corners *corners)
{
    if (!FXL_IS_COMPACT && traversal->clipper->by_clip_flags &&
        find_projected(model_view, face, of, traversal->renderer->scene, corners)) {
        return true;
    }
    return find_corners(model_view, face, of, traversal, corners);
}

void fxl_surface_paint_of(const fxl_surfaces *surfaces, const fxl_surface_polygon *polygon,
                          fxl_paint *paint)
{
    const fxl_surface_set *set = surfaces->set;
    const fxl_surface *surface = &set->surfaces[polygon->surface];
    paint->gradients = &polygon->gradients;
    paint->level.texels = NULL;
    paint->level.flags = 0;
    if (surface->texture != 0) {
        fxl_texture_level_find(&set->textures[surface->texture - 1], polygon->level, &paint->level);
    }
    paint->table = NULL;
    paint->ramp = NULL;
    paint->levels_less_1 = 0;
    if (fxl_surface_is_lit(surfaces, surface)) {
        fxl_surface_light_of(surfaces, paint);
    }
    paint->has_beams = surfaces->beams != NULL;
    paint->in_beam =
        polygon->is_in_beam ? ((const fxl_beam_shader *)(const void *)surfaces->beams)->lit : NULL;
    paint->blend = surface->flags & FXL_SURFACE_BLEND ? set->blend : NULL;
    paint->blend_first = (uint8_t)set->blend_first;
    paint->blend_count = set->blend_count;
    paint->colour = polygon->colour;
    paint->division = surface->division == FXL_AFFINE ? (uint8_t)FXL_DIVIDE_16 : surface->division;
    paint->opacity = surface->opacity;
    paint->is_evenly_lit = polygon->is_evenly_lit;
    paint->light = polygon->light;
    paint->has_light_rows =
        surface->texture == 0 && paint->ramp != NULL && paint->in_beam == NULL &&
        surface->opacity == 16 &&
        (surface->flags & (FXL_SURFACE_BLEND | FXL_SURFACE_ADD | FXL_SURFACE_COLOURS)) == 0;
    paint->colours = surface->flags & FXL_SURFACE_COLOURS ? surfaces->painter->colours : NULL;
    paint->is_light_linear = paint->colours != NULL ||
                             (paint->has_light_rows && fxl_weight_is_constant(&polygon->gradients));
}
