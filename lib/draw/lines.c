/* SPDX-License-Identifier: MIT */
/* Lines and points of models. Without a depth buffer the traversal of the order by distance submits
 * them after the faces of their instance. With one a pass over the scene draws them over the faces
 * of each part of a band. */
#include "fixel/lines.h"

#include "../math/arith.h"
#include "../math/memory.h"
#include "../paint/billboard_paint.h"
#include "../scene/placement_code.h"
#include "../view/cull.h"
#include "../view/model_view.h"
#include "../view/project.h"
#include "../view/view.h"
#include "display_list.h"
#include "line_view.h"
#include "renderer.h"
#include "submit_instance.h"
#include "surface_polygon.h"

/* What draws with an orthographic lens; null: the lens has an eye. */
static const fxl_orthographic_code *flat_of(const fxl_renderer *renderer)
{
    return fxl_orthographic_of(&renderer->frame.view.lens);
}

/* --- the lines of an instance --------------------------------------------------------------- */

void fxl_begin_line_instance(const fxl_traversal *traversal, uint32_t number, fxl_turned_view *view,
                             fxl_line_canvas *canvas, fxl_line_instance *of)
{
    const fxl_renderer *renderer = traversal->renderer;
    of->traversal = traversal;
    of->model_view = fxl_surfaces_view(traversal, &renderer->scene->instances[number], view);
    of->turned = fxl_placement_code_of(renderer->scene, number);
    of->flat = flat_of(renderer);
    of->number = number;
    of->canvas = canvas;
    of->is_simple = canvas != NULL && canvas->head != NULL && of->flat == NULL &&
                    traversal->band->rows == renderer->frame.view.lens.height;
    of->painted.is_point = false;
    of->first_face =
        &renderer->scene
             ->faces[renderer->scene->models[of->model_view->instance->model].first_face];
    of->tested = of->front = 0;
    of->next = 0;
    memset(of->faces, 0, sizeof of->faces);
}

static inline bool face_is_front(const fxl_line_instance *of, const fxl_face *face)
{
    const fxl_renderer *renderer = of->traversal->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_point *eye = &renderer->frame.view.camera.position;
    if (of->flat != NULL) {
        return of->flat->face_is_front(&renderer->frame.view, scene, of->number, face);
    }
    return of->turned != NULL ? of->turned->face_is_front(scene, of->number, face, eye)
                              : fxl_face_is_front(scene, of->model_view->instance, face, eye);
}

bool fxl_line_face_is_front(const fxl_line_instance *of, const fxl_face *face)
{
    return face_is_front(of, face);
}

/* The depth that a face has when it is drawn: to the bit, by the function that draws it. */
/* lines 3.2 */
static void find_plane(const fxl_line_instance *of, const fxl_face *face, fxl_depth_plane *plane)
{
    const fxl_traversal *traversal = of->traversal;
    const fxl_surfaces *surfaces = fxl_surfaces_of(traversal->renderer);
    const fxl_scene *scene = traversal->renderer->scene;
    const uint32_t mapped = surfaces != NULL ? surfaces->set->face_map[face - scene->faces] : 0;
    if (mapped == 0 || of->flat != NULL) {
        fxl_find_depth_by_normal(of->model_view, face, traversal, plane);
        return;
    }
    fxl_pieces pieces = {.instance = of->model_view->instance, .face = face};
    const fxl_mapped_surface surface = {surfaces, &surfaces->set->faces[mapped - 1], &pieces, NULL,
                                        false};
    fxl_surface_polygon polygon;
    surfaces->painter->find(&surface, of->model_view, face, traversal, &polygon);
    *plane = polygon.depth;
    if (fxl_depth_is_in_words(plane)) { /* a triangle, whose corners can all be projected */
        fxl_view_point first;
        fxl_screen_point corner = {0, 0};
        fxl_find_corner(of->model_view, face->indices[0], traversal, &first);
        (void)fxl_project_visible(&of->model_view->view->projection, &first, &corner);
        fxl_line_continue_words(plane, &corner);
    }
}

static FXL_COLD __attribute__((noinline)) fxl_line_plane *new_plane(fxl_line_instance *of,
                                                                    const fxl_face *face)
{
    fxl_line_plane *plane = &of->planes[of->next];
    of->faces[of->next] = face;
    of->next = (of->next + 1u) % FXL_LINE_PLANES;
    find_plane(of, face, &plane->plane);
    fxl_line_plane_begin(plane);
    return plane;
}

/* The same, kept from one line of the instance to the next. */
static inline fxl_line_plane *plane_of(fxl_line_instance *of, const fxl_face *face)
{
    return of->faces[0] == face   ? &of->planes[0]
           : of->faces[1] == face ? &of->planes[1]
           : of->faces[2] == face ? &of->planes[2]
           : of->faces[3] == face ? &of->planes[3]
                                  : new_plane(of, face);
}

static FXL_COLD __attribute__((noinline)) bool test_front(fxl_line_instance *of, uint32_t number)
{
    const bool front = face_is_front(of, &of->first_face[number]);
    if (number < 32) {
        of->tested |= (uint32_t)1 << number;
        of->front |= (uint32_t)front << number;
    }
    return front;
}

/* fxl_line_face_is_front of a face of the model, kept from one line of the instance to the next of
 * the first faces. */
static inline bool is_front(fxl_line_instance *of, uint32_t number)
{
    const uint32_t bit = number < 32 ? (uint32_t)1 << number : 0;
    return (of->front & bit) != 0 || ((of->tested & bit) == 0 && test_front(of, number));
}

/* The faces of a line that face the eye. Returns how many; false in *visible: it has faces, and
 * none does. */
/* lines 2.4 */
static inline uint32_t front_faces(fxl_line_instance *of, const fxl_line *line,
                                   const fxl_face *faces[2], bool *visible)
{
    const uint32_t first = line->faces[0], second = line->faces[1];
    uint32_t count = 0;
    *visible = true;
    if ((first | second) == 0) {
        return 0;
    }
    if (first != 0 && is_front(of, first - 1)) {
        faces[count++] = &of->first_face[first - 1];
    }
    if (second != 0 && is_front(of, second - 1)) {
        faces[count++] = &of->first_face[second - 1];
    }
    *visible = count > 0;
    return count;
}

/* Into the display list. False where it has no room. */
/* lines 4.1 */
static FXL_COLD bool append(const fxl_line_instance *of, const fxl_painted_line *painted)
{
    const fxl_traversal *traversal = of->traversal;
    fxl_screen_polygon *screen = &traversal->workspace->screen;
    const uint8_t shade = screen->shade;
    screen->colour = painted->colour;
    screen->count = 3;
    screen->kind = FXL_POLYGON_LINE;
    screen->shade = painted->width;
    screen->points[0] = painted->ends[0];
    screen->points[1] = painted->ends[1];
    screen->points[2].x = painted->is_point;
    screen->points[2].y = 0;
    fxl_display_list *const list = traversal->display_list;
    const bool fits = fxl_display_list_append(
        list, screen, fxl_rows_of_line(painted, traversal->renderer->frame.view.lens.height));
    screen->kind = FXL_POLYGON_FLAT;
    screen->shade = shade;
    return fits;
}

static inline __attribute__((always_inline)) void paint(fxl_line_instance *of, const fxl_line *line,
                                                        const fxl_face *const faces[],
                                                        uint32_t count, fxl_painted_line *painted)
{
    if (count > 0) {
        painted->planes[0] = plane_of(of, faces[0]);
    }
    if (count > 1) {
        painted->planes[1] = plane_of(of, faces[1]);
        if (painted->planes[1] == painted->planes[0]) { /* it is kept where the first one was */
            painted->planes[0] = new_plane(of, faces[0]);
        }
    }
    painted->plane_count = (uint8_t)count;
    painted->colour = line->colour;
    painted->width = line->width;
    fxl_paint_wide_line(of->canvas, painted);
}

/* Into a whole screen that has a depth buffer, by a lens with an eye. */
/* lines 1.1 */
static inline __attribute__((always_inline)) fxl_line_outcome
draw_simple(fxl_line_instance *of, const fxl_line *line, const fxl_face *const faces[],
            uint32_t count)
{
    fxl_painted_line *painted = &of->painted;
    const fxl_line_outcome outcome = fxl_place_model_line(of, line, painted);
    if (outcome >= FXL_LINE_DRAWN) {
        painted->is_point = line->from == line->to;
        paint(of, line, faces, count, painted);
    }
    return outcome;
}

/* lines 1.1 */
fxl_line_outcome fxl_draw_line_on(fxl_line_instance *of, const fxl_line *line,
                                  const fxl_face *const faces[], uint32_t count, bool *fits)
{
    fxl_painted_line *painted = &of->painted;
    const fxl_line_outcome outcome = of->flat != NULL ? fxl_place_any_line(of, line, painted)
                                                      : fxl_place_model_line(of, line, painted);
    painted->is_point = line->from == line->to;
    if (outcome < FXL_LINE_DRAWN) {
        return outcome;
    }
    painted->width = line->width;
    if (of->canvas == NULL) {
        painted->colour = line->colour;
        painted->plane_count = 0;
        *fits = append(of, painted);
    } else if (fxl_line_meets_rows(painted, of->traversal->band->first_row,
                                   of->traversal->band->rows)) {
        paint(of, line, faces, of->canvas->head != NULL ? count : 0, painted);
    }
    return outcome;
}

static inline fxl_line_outcome draw_line(fxl_line_instance *of, const fxl_line *line, bool *fits)
{
    const fxl_face *faces[2];
    bool visible;
    const uint32_t count = front_faces(of, line, faces, &visible);
    return !visible        ? FXL_LINE_BACKFACING
           : of->is_simple ? draw_simple(of, line, faces, count)
                           : fxl_draw_line_on(of, line, faces, count, fits);
}

/* Of each outcome so many. */
/* lines 4.2 */
static void add_outcomes(fxl_line_counters *counters, const uint32_t outcomes[])
{
    for (uint32_t i = 0; i <= FXL_LINE_CLIPPED; i++) {
        counters->in += outcomes[i];
    }
    counters->backfacing += outcomes[FXL_LINE_BACKFACING];
    counters->outside += outcomes[FXL_LINE_OUTSIDE];
    counters->refused += outcomes[FXL_LINE_REFUSED];
    counters->drawn += outcomes[FXL_LINE_DRAWN] + outcomes[FXL_LINE_CLIPPED];
    counters->clipped += outcomes[FXL_LINE_CLIPPED];
}

/* The lines of a renderer that has some; they may be counted. */
static fxl_lines *lines_of(const fxl_renderer *renderer)
{
    return (fxl_lines *)(uintptr_t)fxl_renderer_shader(renderer, FXL_SHADER_LINES);
}

/* Whether a pick draws the frame: its shader stands before all others, and looks through lines. */
/* lines 4.4 */
static bool is_pick(const fxl_renderer *renderer)
{
    return renderer->shader->rank > FXL_SHADER_LINES;
}

/* All lines of an instance, added to *counters; canvas: null for a display list. False where that has no
 * room: then none of them is in it, and none is counted. */
static bool draw_lines(const fxl_traversal *traversal, uint32_t number, fxl_line_canvas *canvas,
                       fxl_line_counters *counters)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_line_set *set = &lines_of(renderer)->set;
    const uint32_t *map = &set->line_map[renderer->scene->instances[number].model];
    if (map[0] == map[1] || is_pick(renderer)) {
        return true;
    }
    FXL_ALIGN_8 fxl_turned_view view;
    uint32_t outcomes[FXL_LINE_CLIPPED + 1] = {0};
    fxl_line_instance of;
    const uint32_t used = renderer->frame.display_list.used;
    bool fits = true;
    fxl_begin_line_instance(traversal, number, &view, canvas, &of);
    const fxl_line *const end = &set->lines[map[1]];
    for (const fxl_line *line = &set->lines[map[0]]; line < end; line++) {
        outcomes[draw_line(&of, line, &fits)]++;
        if (!fits) {
            traversal->display_list->used = used;
            return false;
        }
    }
    add_outcomes(counters, outcomes);
    return true;
}

/* --- in the turn of their instances, without a depth buffer --------------------------------- */

/* fxl_resume_point.faces of an instance whose faces are done, and whose lines are not. A traversal
 * that was stopped in its faces has done fewer of them. */
#define FACES_DONE UINT16_MAX

/* fxl_instance_submit. */
/* lines 2.5 */
static bool submit_one(const fxl_traversal *traversal, const fxl_draw_entry *entry)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_billboards *billboards = renderer->billboards;
    fxl_line_counters uncounted = {0};
    const fxl_orthographic_code *flat = flat_of(renderer);
    if (traversal->resume->faces != FACES_DONE &&
        !(billboards != NULL ? billboards->code->instance(traversal, entry)
          : flat != NULL     ? flat->submit(traversal, entry)
                             : fxl_submit_any_instance(traversal, entry))) {
        return false;
    }
    const bool counts = traversal->counters == &renderer->workspace.counters;
    fxl_line_canvas canvas;
    if (traversal->display_list == NULL) {
        fxl_find_line_canvas(renderer, traversal->workspace, traversal->band, &canvas);
    }
    if (!draw_lines(traversal, entry->index, traversal->display_list == NULL ? &canvas : NULL,
                    counts ? &lines_of(renderer)->counters : &uncounted)) {
        traversal->resume->faces = FACES_DONE;
        return false;
    }
    return true;
}

static bool submit(const fxl_traversal *traversal)
{
    const fxl_renderer *renderer = traversal->renderer;
    if (traversal->display_list != NULL) {
        fxl_lines *lines = lines_of(renderer);
        memset(&lines->counters, 0, sizeof lines->counters);
        if (flat_of(renderer) != NULL) {
            flat_of(renderer)->begin(traversal);
        } else if (renderer->scene->placements != NULL) {
            traversal->counters->rounded =
                (uint16_t)renderer->scene->placement_code->count_rounded(traversal, 0, 0);
        }
    }
    return fxl_submit_all(traversal, submit_one);
}

static const fxl_order by_distance_with_lines = {.submit = submit};

/* fxl_overdraw.draw_record. */
static void draw_record(fxl_workspace *workspace, const fxl_screen_polygon *record,
                        const fxl_band *band)
{
    const fxl_painted_line painted = {.ends = {record->points[0], record->points[1]},
                                      .colour = record->colour,
                                      .width = record->shade,
                                      .is_point = record->points[2].x != 0,
                                      .plane_count = 0};
    fxl_line_canvas canvas;
    (void)workspace;
    fxl_line_canvas_begin(&canvas, band, NULL, 0, false);
    fxl_paint_wide_line(&canvas, &painted);
}

/* --- over the faces of a band, with a depth buffer ------------------------------------------ */

typedef struct {
    fxl_line_canvas canvas;
    fxl_line_counters sums;
} band_of_lines;

/* fxl_instance_overdraw. */
static void draw_over_one(const fxl_traversal *traversal, uint32_t number, void *with)
{
    band_of_lines *of = (band_of_lines *)with;
    (void)draw_lines(traversal, number, &of->canvas, &of->sums);
}

/* fxl_overdraw.draw_over. */
/* lines 2.7 */
static void draw_over(const fxl_renderer *renderer, fxl_workspace *workspace, const fxl_band *band)
{
    fxl_lines *lines = lines_of(renderer);
    band_of_lines of;
    memset(&of.sums, 0, sizeof of.sums);
    fxl_find_line_canvas(renderer, workspace, band, &of.canvas);
    fxl_draw_over_instances(renderer, workspace, band, draw_over_one, &of);
    if (workspace == &renderer->workspace && lines->frame != renderer->frame.view.frame) {
        lines->counters = of.sums;
        lines->frame = renderer->frame.view.frame;
    }
}

/* --- attaching ------------------------------------------------------------------------------ */

static const fxl_order *order_without(const fxl_renderer *renderer)
{
    const fxl_orthographic_code *flat = flat_of(renderer);
    return renderer->billboards != NULL ? renderer->billboards->code->order
           : flat != NULL               ? flat->order
                                        : &fxl_by_distance;
}

/* combinations 1.1, lines 4.5 */
static fxl_status check(const fxl_renderer *renderer, const fxl_lines *lines,
                        const fxl_line_set *set)
{
    if (renderer->scene == NULL || renderer->target == NULL) {
        return FXL_E_ORDER;
    }
    if (set == NULL) {
        return FXL_OK;
    }
    if (lines == NULL) {
        return FXL_E_ARGUMENT;
    }
    return !fxl_is_aligned(lines, 8) ? FXL_E_ALIGNMENT
                                     : fxl_lines_check(set, renderer->scene, NULL);
}

/* lines 4.3 */
fxl_status fxl_attach_lines(fxl_renderer *renderer, fxl_lines *lines, const fxl_line_set *set)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_status status = check(renderer, lines, set);
    if (status != FXL_OK) {
        return fxl_refuse(&renderer->workspace, status);
    }
    if (set == NULL) {
        if (lines_of(renderer) == NULL) {
            return FXL_OK; /* a frame that has begun stays */
        }
        fxl_renderer_attach(renderer, FXL_SHADER_LINES, NULL);
        if (renderer->order == &by_distance_with_lines) {
            renderer->order = order_without(renderer);
        }
        return FXL_OK;
    }
    memset(&lines->counters, 0, sizeof lines->counters); /* not all: they may be attached already */
    lines->frame = 0;
    lines->overdraw.shader.code = &fxl_mark;
    lines->overdraw.draw_over = draw_over;
    lines->overdraw.draw_record = draw_record;
    lines->set = *set;
    fxl_renderer_attach(renderer, FXL_SHADER_LINES, &lines->overdraw.shader);
    if (renderer->target->depth_bits == 0) {
        renderer->draw_display_list = fxl_mixed_draw_list;
        if (renderer->order == order_without(renderer)) {
            renderer->order = &by_distance_with_lines;
        }
    }
    return FXL_OK;
}
