/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "clip/clip_by_view.h"
#include "clip/clip_view.h"
#include "clip/intersection.h"
#include "draw/display_list.h"
#include "draw/orthographic.h"
#include "draw/submit.h"
#include "predict/counts.h"
#include "raster/draw_outline.h"
#include "raster/fill.h"
#include "raster/scan.h"
#include "scene/placement_code.h"
#include "view/model_view.h"
#include "view/order.h"
#include "view/project.h"
#include "view/placement.h"
#include "order/bsp_pieces.h"
#include "scene/bsp_node.h"
#include "view/outcode.h"

/* Counts of what every scene may have: instances, faces and polygons. */

predict_counts counted;
bool is_wide, is_parallel;

/* Under way is a band that looks at those faces alone of which it knows that they reach it. */
static bool passes_over;

/* --- instances and faces ------------------------------------------------------------------ */

/* Faces of an instance of which is asked whether they face the eye. */
static uint32_t faces_to_test(const fxl_model *model)
{
    return model->kind == FXL_MODEL_CONVEX && !passes_over && !draws_lines ? model->face_count : 0;
}

WRAPPED_COUNT_VOID(void, fxl_model_view_of_instance,
                   (fxl_model_view * model_view, const fxl_scene *scene,
                    const fxl_instance *instance, const fxl_view *view, fxl_vertex_cache *cache),
                   (model_view, scene, instance, view, cache), counted.instances_viewed += 1,
                   counted.faces_tested += faces_to_test(&scene->models[instance->model]))

WRAPPED(const fxl_model *, fxl_turned_view_of_instance,
        (fxl_turned_view * turned, const fxl_scene *scene, uint32_t number, const fxl_view *view,
         fxl_vertex_cache *cache, uint32_t planes))
{
    const fxl_model *model =
        __real_fxl_turned_view_of_instance(turned, scene, number, view, cache, planes);
    counted.turned_viewed += 1;
    counted.faces_tested += faces_to_test(model);
    return model;
}

WRAPPED_COUNT(bool, fxl_is_rotation, (const fxl_orientation *rows), (rows),
              counted.turned_checked += 1)

WRAPPED_COUNT(uint32_t, fxl_list_front_faces,
              (const fxl_scene *scene, const fxl_model *model, const fxl_point *eye,
               fxl_draw_entry *entries),
              (scene, model, eye, entries), counted.faces_facing += model->face_count)

WRAPPED_COUNT_VOID(void, fxl_sort_faces,
                   (fxl_draw_entry * entries, uint32_t count, fxl_sort_work *work),
                   (entries, count, work), counted.faces_sorted += count,
                   counted.parallel_sorted += is_parallel ? count : 0)

WRAPPED(bool, fxl_extents_submit, (const fxl_traversal *traversal))
{
    counted.spilled_faces += traversal->renderer->workspace.counters.spilled;
    counted.instances_passed += traversal->renderer->frame.visible_count;
    passes_over = true;
    const bool done = __real_fxl_extents_submit(traversal);
    passes_over = false;
    return done;
}

/* --- clip ----------------------------------------------------------------------------------- */

static fxl_clip_result clip_by_view(const fxl_model_view *model_view, const fxl_face *face,
                                    fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    counted.faces_clipped += 1;
    counted.corners += face->count;
    const fxl_clip_result result = fxl_clip_by_view(model_view, face, work, screen);
    counted.faces_outside += result == FXL_CLIP_OUTSIDE;
    counted.faces_between += result == FXL_CLIP_BETWEEN;
    return result;
}

WRAPPED_RECORD(fxl_clipper, fxl_clipper_view) = {.clip = clip_by_view, .by_clip_flags = true};

/* Those of an orthographic lens, whose vertices are projected in C. */
extern const fxl_clipper __real_fxl_orthographic_clipper, __real_fxl_orthographic_deep_clipper;

static fxl_clip_result clip_parallel(const fxl_model_view *model_view, const fxl_face *face,
                                     fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    counted.parallel_clipped += 1;
    counted.parallel_corners += face->count;
    return __real_fxl_orthographic_clipper.clip(model_view, face, work, screen);
}

WRAPPED_RECORD(fxl_clipper, fxl_orthographic_clipper) = {.clip = clip_parallel,
                                                         .by_clip_flags = true};

static fxl_clip_result clip_deep(const fxl_model_view *model_view, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    counted.parallel_clipped += 1;
    counted.parallel_corners += face->count;
    return __real_fxl_orthographic_deep_clipper.clip(model_view, face, work, screen);
}

WRAPPED_RECORD(fxl_clipper, fxl_orthographic_deep_clipper) = {.clip = clip_deep};

WRAPPED_COUNT_VOID(void, fxl_find_orthographic_depth,
                   (const fxl_model_view *model_view, const fxl_face *face, fxl_depth_plane *plane),
                   (model_view, face, plane), counted.parallel_depths += 1)

WRAPPED_COUNT_VOID(void, fxl_transform_vertex,
                   (const fxl_model_view *model_view, uint32_t number, fxl_cached_vertex *entry),
                   (model_view, number, entry), counted.vertices += 1,
                   counted.parallel_vertices += is_parallel,
                   counted.parallel_flat +=
                   is_parallel && (model_view->planes & FXL_MODEL_VIEW_SCALED) != 0)

WRAPPED_COUNT(fxl_status, fxl_project_inside,
              (const fxl_projection *projection, const fxl_view_point *view,
               fxl_screen_point *screen),
              (projection, view, screen), counted.projections += 1)

WRAPPED_COUNT(fxl_clip_result, fxl_clip_view_by_planes,
              (const fxl_view_polygon *in, const fxl_view_frustum *frustum, fxl_planes planes,
               fxl_clip_view_work *work, fxl_clip_stats *stats, const fxl_view_polygon **result),
              (in, frustum, planes, work, stats, result), counted.assembled += 1)

WRAPPED_COUNT_VOID(void, fxl_intersect_edge,
                   (const fxl_view_point *from, const fxl_view_point *to,
                    const fxl_q18_46 *from_distance, const fxl_q18_46 *to_distance,
                    fxl_view_point *result),
                   (from, to, from_distance, to_distance, result), counted.cut_edges += 1)

/* --- display list --------------------------------------------------------------------------- */

WRAPPED_COUNT(bool, fxl_display_list_append,
              (fxl_display_list * list, const fxl_screen_polygon *polygon, fxl_rows rows),
              (list, polygon, rows), counted.list_polygons += 1,
              counted.list_words += 2 + 2 * polygon->count)

WRAPPED(const fxl_screen_polygon *, fxl_display_list_next,
        (const fxl_display_list *list, fxl_rows rows, uint32_t *place))
{
    const fxl_screen_polygon *found = __real_fxl_display_list_next(list, rows, place);
    counted.list_reads += found != NULL;
    counted.list_scanned += found != NULL ? 0 : list->used; /* at the end of each band's pass */
    return found;
}

/* --- raster --------------------------------------------------------------------------------- */

double area_between(const fxl_screen_point *points, uint32_t count, double top, double bottom)
{
    double twice = 0;
    for (uint32_t i = 0; i < count; i++) {
        const fxl_screen_point *a = &points[i], *b = &points[i + 1 < count ? i + 1 : 0];
        const double ay = a->y / 65536.0, by = b->y / 65536.0;
        const double ax = a->x / 65536.0, bx = b->x / 65536.0;
        const double from = fmin(fmax(ay, top), bottom), to = fmin(fmax(by, top), bottom);
        if (from != to) { /* the strip between the edge and x = 0 */
            const double slope = (bx - ax) / (by - ay);
            twice += (to - from) * (2 * ax + slope * (from + to - 2 * ay));
        }
    }
    return fabs(twice) / 2;
}

/* place fill-rule: definition: the rows that an outline has, ⌈y − 1/2⌉ */
double rows_between(const fxl_screen_point *points, uint32_t count, double top, double bottom)
{
    double first = bottom, end = top;
    for (uint32_t i = 0; i < count; i++) {
        const double row = ceil(points[i].y / 65536.0 - 0.5);
        first = fmin(first, row);
        end = fmax(end, row);
    }
    return fmax(0, fmin(end, bottom) - fmax(first, top));
}

WRAPPED(bool, fxl_draw_outline,
        (fxl_scan * scan, const fxl_screen_polygon *polygon, const fxl_band *band, uint32_t colour))
{
    const double top = band->first_row, bottom = top + band->rows;
    const double rows = rows_between(polygon->points, polygon->count, top, bottom);
    counted.polygons += 1;
    counted.edges += polygon->count;
    counted.polygons_drawn += rows > 0;
    counted.rows += rows;
    counted.pixels += area_between(polygon->points, polygon->count, top, bottom);
    return __real_fxl_draw_outline(scan, polygon, band, colour);
}

/* Is under way: fxl_draw_outline_rgb565, which fills by fxl_fill_trapezoid_rgb565. */
static bool draws_outline;

WRAPPED(bool, fxl_draw_outline_rgb565,
        (fxl_scan * scan, const fxl_screen_polygon *polygon, const fxl_band *band, uint32_t colour))
{
    const double top = band->first_row, bottom = top + band->rows;
    counted.wide_polygons += 1;
    counted.wide_edges += polygon->count;
    counted.wide_outline_rows += rows_between(polygon->points, polygon->count, top, bottom);
    counted.wide_outline_pixels += area_between(polygon->points, polygon->count, top, bottom);
    draws_outline = true;
    const bool reaches_band = __real_fxl_draw_outline_rgb565(scan, polygon, band, colour);
    draws_outline = false;
    return reaches_band;
}

WRAPPED(const fxl_trapezoid *, fxl_scan_next_trapezoid, (fxl_scan * scan))
{
    *(draws_smooth          ? &counted.smooth_trapezoids
      : draws_depth_outline ? &counted.depth_outline_trapezoids
      : draws_listed        ? &counted.listed_trapezoids
                            : &counted.trapezoids) += 1;
    return __real_fxl_scan_next_trapezoid(scan);
}

WRAPPED_COUNT(fxl_rows, fxl_scan_rows, (const fxl_screen_polygon *polygon, uint16_t height),
              (polygon, height), counted.row_searches += 1)

/* Cells of a depth buffer that are cleared: what fills a band of a frame has a renderer. */
WRAPPED(void, fxl_fill_band_palette,
        (const fxl_renderer *renderer, const fxl_band *band, uint8_t colour))
{
    if (renderer == NULL) {
        counted.cleared += (double)band->rows * band->width;
    }
    __real_fxl_fill_band_palette(renderer, band, colour);
}

/* The same, or a band that is cleared: a pixel of 16 bits takes as long as two of 8. */
WRAPPED(void, fxl_fill_trapezoid_rgb565,
        (const fxl_band *band, const fxl_trapezoid *trapezoid, uint16_t colour))
{
    if (!draws_outline) {
        counted.bands += !has_depth_buffer;
        counted.cleared += 2.0 * band->rows * band->width;
    }
    __real_fxl_fill_trapezoid_rgb565(band, trapezoid, colour);
}

/* A row of a polygon with depth. */
WRAPPED(void, fxl_fill_row_rgb565, (uint16_t * pixel, uint16_t *end, uint16_t colour))
{
    if (!draws_depth_outline) { /* else it is a visible pixel of one */
        counted.wide_rows += 1;
        counted.wide_pixels += (double)(end - pixel);
    }
    __real_fxl_fill_row_rgb565(pixel, end, colour);
}

/* Counts of the order by tree: nodes, their faces, and instances among them. */

/* A traversal, as far as it is counted. */
typedef struct {
    const fxl_traversal *traversal;
    const fxl_instance *instance;
    fxl_point from;                    /* the eye, relative to the instance */
    const fxl_bsp_resume_point *start; /* where it resumes; null: it is past that */
    const fxl_bsp_resume_point *end;   /* where the list was full; or null */
    bool has_ended;
} counted_walk;

/* The phases of a node, as submit_by_bsp.c calls them. */
enum {
    FIRST,
    FACES,
    SECOND
};

static bool is_place(const fxl_bsp_resume_point *place, uint32_t number, uint32_t phase)
{
    return place != NULL && place->node == number && place->phase == phase;
}

/* Whether the traversal is at work at a node. */
static bool is_at_work(counted_walk *walk, uint32_t number, uint32_t phase)
{
    if (is_place(walk->start, number, phase)) {
        walk->start = NULL;
    }
    walk->has_ended =
        walk->has_ended || (walk->start == NULL && is_place(walk->end, number, phase));
    return walk->start == NULL && !walk->has_ended;
}

/* The planes that a node's sphere may cross, or FXL_SPHERE_OUTSIDE. */
static uint32_t planes_of(const counted_walk *walk, const fxl_bsp_node *node)
{
    const fxl_view *view = &walk->traversal->renderer->frame.view;
    const fxl_point *origin = &walk->instance->centre;
    const fxl_point centre = {node->centre.x + origin->x, node->centre.y + origin->y,
                              node->centre.z + origin->z};
    counted.tree_spheres += 1;
    return fxl_sphere_planes(&view->camera, &view->view_frustum, &centre, node->radius);
}

/* A subtree as the traversal visits it. inside: no sphere of it is tested. */
static void count_subtree(counted_walk *walk, uint32_t number, fxl_q16_16 above, bool inside)
{
    const fxl_bsp_node *node = &walk->traversal->renderer->scene->bsp_nodes[number];
    const bool front_first =
        fxl_bsp_is_front(node, &walk->from) == walk->traversal->renderer->near_first;
    const uint32_t first = front_first ? node->front : node->back;
    const uint32_t second = front_first ? node->back : node->front;
    if (is_at_work(walk, number, FIRST)) {
        counted.tree_nodes += 1;
        if (!inside && node->radius != above) {
            const uint32_t planes = planes_of(walk, node);
            if (planes == FXL_SPHERE_OUTSIDE) {
                return;
            }
            inside = planes == 0;
        }
    }
    if (first != FXL_BSP_NONE) {
        count_subtree(walk, first, node->radius, inside);
    }
    if (is_at_work(walk, number, FACES)) {
        counted.tree_faces += node->face_count;
    }
    (void)is_at_work(walk, number, SECOND);
    if (second != FXL_BSP_NONE) {
        count_subtree(walk, second, node->radius, inside);
    }
}

static bool submit(const fxl_traversal *traversal)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_instance *instance = &scene->instances[scene->bsp_instance];
    const fxl_point *eye = &renderer->frame.view.camera.position;
    const fxl_bsp_workspace *workspace = (const fxl_bsp_workspace *)renderer->order_memory;
    const fxl_bsp_resume_point start = workspace->rest;
    const fxl_resume_point before = *traversal->resume;
    const bool done = fxl_by_tree.submit(traversal);
    counted_walk walk = {.traversal = traversal,
                         .instance = instance,
                         .from = {eye->x - instance->centre.x, eye->y - instance->centre.y,
                                  eye->z - instance->centre.z},
                         .start = before.faces != 0 && before.instances == workspace->first ? &start
                                                                                            : NULL,
                         .end = !done && traversal->resume->faces != 0 ? &workspace->rest : NULL};
    if (before.instances <= workspace->first) {
        count_subtree(&walk, 0, -1, false);
    }
    return done;
}

static uint32_t memory_size(const fxl_scene *scene)
{
    return fxl_by_tree.memory_size(scene);
}

static fxl_status choose(fxl_renderer *renderer, const fxl_config *config)
{
    return fxl_by_tree.choose(renderer, config);
}

const fxl_order counting_tree = {.submit = submit, .memory_size = memory_size, .choose = choose};

/* --- instances that are cut ----------------------------------------------------------------- */

WRAPPED(bool, fxl_bsp_cut,
        (fxl_bsp_cutter * cutter, const fxl_instance *instance, const fxl_point *eye,
         uint32_t entry))
{
    const uint32_t items = cutter->item_count, vertices = cutter->vertex_count;
    const bool done = __real_fxl_bsp_cut(cutter, instance, eye, entry);
    counted.tree_pieces += cutter->item_count - items;
    counted.tree_vertices += cutter->vertex_count - vertices;
    return done;
}

WRAPPED_COUNT(bool, fxl_submit_bsp_leaf,
              (const fxl_traversal *traversal, fxl_bsp_workspace *workspace, uint32_t leaf,
               fxl_bsp_resume_point *place),
              (traversal, workspace, leaf, place), counted.tree_leaves += 1)
