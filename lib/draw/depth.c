/* SPDX-License-Identifier: MIT */
/* The depth of a face by its normal, and the parts in which a band with a depth buffer is drawn. */
#include "../scene/lens.h"
#include "../view/view.h"
#include "surface_polygon.h"

#include "../math/arith.h"
#include "depth_plane.h"
#include "submit.h"
#include "../paint/depth_outline.h"

#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT

void fxl_depth_paint_row_16(fxl_depth_painting *of, int32_t y, int32_t x0, int32_t x1,
                            fxl_run_painter *paint, const void *with)
{
    fxl_depth_paint_row(of, y, x0, x1, 16, paint, with);
}

#endif

/* Products of a row whose components are at most 2^30 and a normal: a sum is below 2^62. */
static int64_t row_times(const fxl_direction *row, const fxl_direction *normal)
{
    return fxl_multiply_s32(row->x, normal->x) + fxl_multiply_s32(row->y, normal->y) +
           fxl_multiply_s32(row->z, normal->z);
}

/* The components are at most 2^30, so differences of two products are at most 2^61. */
static fxl_block_vector cross(const fxl_direction *a, const fxl_direction *b)
{
    return fxl_block(fxl_multiply_s32(a->y, b->z) - fxl_multiply_s32(a->z, b->y),
                     fxl_multiply_s32(a->z, b->x) - fxl_multiply_s32(a->x, b->z),
                     fxl_multiply_s32(a->x, b->y) - fxl_multiply_s32(a->y, b->x), 0);
}

/* The same where the rows are sheared: by the inverse of the transposed matrix, whose columns are
 * the products of two rows each. A sum of three products is at most 2^62, so of halves 2^61. */
static fxl_block_vector sheared(const fxl_axes *axes, const fxl_direction *normal)
{
    const fxl_block_vector rows[3] = {cross(&axes->up, &axes->forward),
                                      cross(&axes->forward, &axes->right),
                                      cross(&axes->right, &axes->up)};
    int64_t sums[3];
    int exponent = INT32_MIN;
    for (uint32_t i = 0; i < 3; i++) {
        exponent = rows[i].exponent > exponent ? rows[i].exponent : exponent;
    }
    for (uint32_t i = 0; i < 3; i++) {
        const fxl_direction row = {rows[i].x, rows[i].y, rows[i].z};
        const int drop = exponent - rows[i].exponent + 1;
        sums[i] = -row_times(&row, normal) >> (drop < 63 ? drop : 63);
    }
    return fxl_block(sums[0], sums[1], sums[2], 0);
}

/* The first corner of a face in the view; other: room for it. */
static inline const fxl_view_point *first_corner(const fxl_model_view *model_view,
                                                 const fxl_face *face,
                                                 const fxl_traversal *traversal,
                                                 fxl_cached_vertex *other)
{
    const uint32_t number = face->indices[0];
    if (traversal->clipper->by_clip_flags) {
        return &fxl_fetch_vertex(model_view, number)->position;
    }
    fxl_transform_vertex(model_view, number, other);
    return &other->position;
}

/* By an off-centre or an orthographic lens. Not inline: what it has would be on the stack of others. */
static __attribute__((noinline)) void find_by_other_lens(const fxl_model_view *model_view,
                                                         const fxl_face *face,
                                                         const fxl_view_point *first,
                                                         fxl_depth_plane *plane)
{
    const fxl_view *view = model_view->view;
    if (view->lens.off_centre->orthographic != NULL) {
        view->lens.off_centre->orthographic->find_depth(model_view, face, plane);
        return;
    }
    const fxl_block_vector n = sheared(model_view->axes, &face->normal);
    const fxl_direction normal = {n.x, n.y, n.z};
    fxl_find_depth_plane(&normal, NULL, first, view, plane);
}

/* SPEC 10.1 */
void fxl_find_depth_by_normal(const fxl_model_view *model_view, const fxl_face *face,
                              const fxl_traversal *traversal, fxl_depth_plane *plane)
{
    const fxl_view *view = model_view->view;
    fxl_cached_vertex other;
    const fxl_view_point *first = first_corner(model_view, face, traversal, &other);
    if (view->lens.off_centre == NULL) {
        fxl_find_depth_plane(&face->normal, model_view->axes, first, view, plane);
    } else {
        find_by_other_lens(model_view, face, first, plane);
    }
}

void fxl_find_exact_depth(const fxl_model_view *model_view, const fxl_face *face,
                          const fxl_traversal *traversal, fxl_corner_planes *planes, bool has_words,
                          fxl_depth_plane *plane)
{
    (void)planes;
    (void)has_words;
    fxl_find_depth_by_normal(model_view, face, traversal, plane);
}

#define CLEARED_AT_ONCE 1024u /* bytes; the kernel that fills is fastest in long rows */

/* Of a part of so many rows or more, faces clear the rows that they reach. */
#define CLEARED_BY_FACES 16

/* Sets so many bytes to 0, by what fills a band: so a program has no kernel for pixels that it does not
 * draw. A cell has 2 or 4 bytes, so cells are whole pixels of either size, at even addresses. */
static void clear(const fxl_target *target, uint8_t *bytes, uint32_t count)
{
    static const uint16_t colours[1] = {0};
    const uint32_t pixel_bytes = target->pixel_bits / 8u;
    const uint32_t rows = count / CLEARED_AT_ONCE, remaining = count % CLEARED_AT_ONCE;
    fxl_band band = {.pixels = bytes,
                     .width = (uint16_t)(CLEARED_AT_ONCE / pixel_bytes),
                     .stride = (uint16_t)(CLEARED_AT_ONCE / pixel_bytes),
                     .first_row = 0,
                     .rows = (uint16_t)rows,
                     .palette = colours};
    if (rows > 0) {
        target->fill(NULL, &band, 0);
    }
    if (remaining > 0) {
        band.pixels += rows * CLEARED_AT_ONCE;
        band.width = band.stride = (uint16_t)(remaining / pixel_bytes);
        band.rows = 1;
        target->fill(NULL, &band, 0);
    }
}

/* Clears the cells of the rows first <= y < end. */
static void clear_rows(fxl_depth_head *head, const fxl_band *band, int32_t first, int32_t end,
                       const fxl_target *target)
{
    const uint32_t row_bytes = band->width * (target->depth_bits / 8u);
    clear(target,
          (uint8_t *)(head + 1) + (uint32_t)(first - band->first_row) * row_bytes,
          (uint32_t)(end - first) * row_bytes);
}

void fxl_depth_clear(fxl_workspace *workspace, const fxl_band *band, int32_t first, int32_t end,
                     const fxl_target *target)
{
    fxl_depth_head *head = (fxl_depth_head *)workspace->target_memory;
    const int32_t top = band->first_row, below = top + band->rows;
    int32_t from = head->clear_from, to = head->clear_to;
    first = first < top ? top : first;
    end = end > below ? below : end;
    if (first >= end || from == FXL_DEPTH_ALL_CLEAR) {
        return;
    }
    if (from == to) {
        from = to = first;
    }
    if (first < from) {
        clear_rows(head, band, first, from, target);
        from = first;
    }
    if (end > to) {
        clear_rows(head, band, to, end, target);
        to = end;
    }
    const bool is_all = from == top && to == below;
    head->clear_from = (int16_t)(is_all ? FXL_DEPTH_ALL_CLEAR : from);
    head->clear_to = (int16_t)(is_all ? INT16_MAX : to);
}

void fxl_depth_clear_all(fxl_workspace *workspace, const fxl_band *band, const fxl_target *target)
{
    fxl_depth_clear(workspace, band, band->first_row, band->first_row + band->rows, target);
}

/* What a pass tests, and by what. */
static void begin_pass(fxl_workspace *workspace, const fxl_band *band, uint8_t pass,
                       bool near_first, uint32_t pixel_bytes)
{
    fxl_depth_head *head = (fxl_depth_head *)workspace->target_memory;
    head->pass = pass;
    head->or_equal = !near_first;
    workspace->draws_outlines =
        FXL_DRAWS_DEPTH_OUTLINES && fxl_depth_outline_can_draw(head, band, pixel_bytes);
}

/* Whether opaque faces of a frame that is drawn far to near may come near to far, by the kernels for that: of
 * equal codes the same one is seen. Not those of a display list, or whose rows are kept. */
static bool may_turn(const fxl_frame *frame)
{
    return frame->display_list.used == 0 && frame->state != FXL_FRAME_MEASURED;
}

/* All opaque faces, near to far. The pass of those that are blended counts all. A list of sorted faces is kept
 * by the number of its instance, which is another one in the other direction. */
static void draw_opaque(const fxl_renderer *renderer, fxl_workspace *workspace,
                        const fxl_band *band)
{
    const bool is_counted = workspace->rest_counted;
    workspace->rest_counted = true;
    workspace->sorted_instance = UINT16_MAX;
    (void)fxl_draw_band_turned(renderer, workspace, band, true);
    workspace->sorted_instance = UINT16_MAX;
    workspace->rest_counted = is_counted;
}

/* What is drawn over the faces that are not blended. The pass is that of all faces, so that the
 * depth of any is found. */
/* lines 2.6 */
static void draw_over(const fxl_renderer *renderer, fxl_workspace *workspace, const fxl_band *band)
{
    const fxl_shader *shader = fxl_overdraw_from(renderer->shader);
    for (; shader != NULL; shader = fxl_overdraw_from(shader->next)) {
        ((fxl_depth_head *)workspace->target_memory)->pass = FXL_DEPTH_ALL;
        ((const fxl_overdraw *)(const void *)shader)->draw_over(renderer, workspace, band);
    }
}

/* SPEC 10.5, surfaces 4.4 */
static void draw_part(const fxl_renderer *renderer, fxl_workspace *workspace, const fxl_band *band,
                      uint32_t pixel_bytes)
{
    const bool near_first = renderer->near_first, turns = !near_first && may_turn(&renderer->frame);
    begin_pass(workspace, band, near_first ? FXL_DEPTH_ALL : FXL_DEPTH_OPAQUE, near_first || turns,
               pixel_bytes);
    if (turns) {
        draw_opaque(renderer, workspace, band);
        begin_pass(workspace, band, FXL_DEPTH_OPAQUE, false, pixel_bytes);
    } else {
        (void)fxl_draw_band(renderer, workspace, band);
    }
    draw_over(renderer, workspace, band);
    if (!near_first) {
        begin_pass(workspace, band, FXL_DEPTH_BLENDED, false, pixel_bytes);
        (void)fxl_draw_band(renderer, workspace, band);
    }
}

/* Depths of an orthographic lens have one octave. */
/* orthographic 2.11 */
static fxl_depth_scale scale_of(const fxl_lens *lens)
{
    static const fxl_depth_scale one_octave = {1, 15};
    return fxl_orthographic_of(lens) != NULL ? one_octave : fxl_depth_scale_of(lens);
}

void fxl_depth_draw_parts(const fxl_renderer *renderer, fxl_workspace *workspace,
                          const fxl_band *band)
{
    fxl_depth_head *head = (fxl_depth_head *)workspace->target_memory;
    const fxl_target *target = renderer->target;
    const uint32_t pixel_bytes = target->pixel_bits / 8u;
    const uint32_t row_bytes = band->width * (target->depth_bits / 8u);
    const uint32_t room =
        (workspace->target_memory_size - (uint32_t)sizeof(fxl_depth_head)) / row_bytes;
    fxl_band part = *band;
    uint32_t left = band->rows;
    FXL_ASSERT(room > 0);
    head->scale = scale_of(&renderer->frame.view.lens);
    for (;;) {
        part.rows = (uint16_t)(left < room ? left : room);
        head->clear_from = head->clear_to = (int16_t)part.first_row;
        if (part.rows < CLEARED_BY_FACES) {
            fxl_depth_clear_all(workspace, &part, target);
        }
        draw_part(renderer, workspace, &part, pixel_bytes);
        left -= part.rows;
        if (left == 0) {
            return;
        }
        if (workspace->counters.split_bands < UINT16_MAX) {
            workspace->counters.split_bands++;
        }
        part.first_row = (uint16_t)(part.first_row + part.rows);
        part.pixels += (size_t)part.rows * part.stride * pixel_bytes;
    }
}
