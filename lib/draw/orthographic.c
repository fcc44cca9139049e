/* SPDX-License-Identifier: MIT */
/* The orthographic lens, its view, and how scenes are drawn with it: a clipper and an order in which
 * no eye stands (docs/extras/orthographic.md). Only what makes such a lens names this file's record. */
#include "../clip/clip_by_view.h"
#include "../math/arith.h"
#include "../scene/face_bounds.h"
#include "../scene/lens.h"
#include "../scene/placement_code.h"
#include "../view/order.h"
#include "../view/placement.h"
#include "../view/project.h"
#include "fixel/camera.h"
#include "renderer.h"
#include "rounded_faces.h"
#include "submit.h"
#include "submit_instance.h"
#include "surface_polygon.h"

/* --- the lens -------------------------------------------------------------------------------- */

/* The view's planes are those of any view (fxl_view_frustum) with an inset below 0: a point is inside
 * left and right if +-x_side x >= inset. The smaller extent of the screen says the inset, and the
 * larger one has a normal that is as much shorter. So sphere test, outcode and clip are those of any
 * view. */

/* orthographic 1.1 */
static bool is_valid(const fxl_lens *lens)
{
    return lens->inset == 0 && lens->focal >= FXL_ORTHOGRAPHIC_SCALE_MIN &&
           lens->focal <= FXL_ORTHOGRAPHIC_SCALE_MAX &&
           lens->centre_x == (int32_t)lens->width * 32768 &&
           lens->centre_y == (int32_t)lens->height * 32768;
}

fxl_status fxl_lens_orthographic(uint16_t width, uint16_t height, fxl_q16_16 scale,
                                 fxl_q16_16 near_z, fxl_q16_16 far_z, fxl_lens *lens)
{
    if (lens == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_lens made = {
        width, height, scale, near_z, far_z, 0, width * 32768, height * 32768, &fxl_orthographic};
    if (!fxl_lens_is_valid(&made)) {
        return FXL_E_RANGE;
    }
    *lens = made;
    return FXL_OK;
}

/* The part that the smaller extent is of this one, at most 1. Below 2^41 / 1. */
static fxl_q2_30 side_of(uint32_t smaller, uint32_t extent)
{
    return fxl_divide_round((int64_t)smaller * FXL_Q2_30_ONE, extent);
}

/* Surfaces find attributes by the corners' view points and the focal length. With an orthographic
 * lens these are those of corners in the plane z = C, seen with the focal length scale C: C is a power
 * of two, from which the screen is at most 2 C wide and high, and at least 1. So where surfaces are
 * attached, a vertex has this depth in the cache, once its clip flags were found. */
static unsigned flat_shift(const fxl_lens *lens)
{
    const uint32_t larger = lens->width > lens->height ? lens->width : lens->height;
    unsigned shift = 0;
    while ((uint64_t)(uint32_t)lens->focal << (shift + 1) < (uint64_t)larger << 16) {
        shift++;
    }
    return shift;
}

static fxl_q18_46 flat_depth(const fxl_lens *lens)
{
    return (fxl_q18_46)1 << (46 + flat_shift(lens));
}

/* m / (2 scale) world units, rounded downward: m 2^61 / scale in units of 2^-46, at most 2^59. The
 * scale is at least 2^12, so 8 times it is above m, and below 2^32. */
/* orthographic 2.1 */
static void set_lens(fxl_view *view)
{
    const fxl_lens *lens = &view->lens;
    fxl_view_frustum *frustum = &view->view_frustum;
    const uint32_t smaller = lens->width < lens->height ? lens->width : lens->height;
    frustum->x_side = side_of(smaller, lens->width);
    frustum->y_side = side_of(smaller, lens->height);
    frustum->x_depth = frustum->y_depth = 0;
    frustum->inset = -(int64_t)fxl_fraction(smaller, 8 * (uint64_t)(uint32_t)lens->focal);
    fxl_lens flat = *lens;
    flat.focal = lens->focal << flat_shift(lens);
    fxl_projection_from_lens(&flat, &view->projection);
}

/* The axes are those of the pose. */
static void set_pose(fxl_view *view)
{
    (void)view;
}

/* scale * across, rounded. The scale is at most 2^28, so what is summed is below 2^58, in units of
 * 2^-30 pixel. The 32 bits that the sum leaves out are below the half that rounding adds: a floor of
 * a floor. */
static int64_t pixels_of(uint32_t scale, fxl_q18_46 across)
{
    const uint64_t low = fxl_multiply_u32(scale, fxl_low_32(fxl_bits_64(across)));
    const int64_t high =
        fxl_multiply_s32((int32_t)scale, (int32_t)(across >> 32)) + (int64_t)(low >> 32);
    return fxl_round_shift(high, 14);
}

/* A centre is below 2^26. */
/* orthographic 2.6 */
fxl_status fxl_project_orthographic(const fxl_view *view, const fxl_view_point *point,
                                    fxl_screen_point *screen)
{
    const uint32_t scale = (uint32_t)view->lens.focal;
    const int64_t x = view->lens.centre_x + pixels_of(scale, point->x);
    const int64_t y = view->lens.centre_y - pixels_of(scale, point->y);
    if (!fxl_within(x, FXL_SCREEN_COORDINATE_MAX) || !fxl_within(y, FXL_SCREEN_COORDINATE_MAX)) {
        return FXL_E_RANGE;
    }
    screen->x = (fxl_q16_16)x;
    /* SPEC 1.1 */
    screen->y = (fxl_q16_16)y;
    return FXL_OK;
}

/* --- the view of an instance ------------------------------------------------------------------ */

/* The model view of an instance, turned or not, and forward in its model. */
typedef struct {
    fxl_turned_view turned; /* of one that is not turned its model_view, and a null placement */
    fxl_direction forward;
    const fxl_scene *scene;
    bool is_deep; /* there is a depth buffer */
    /* Where surfaces are attached: what scales a vertex; null: nothing. */
    uint32_t (*scale_vertex)(const fxl_model_view *model_view, fxl_cached_vertex *entry);
} orthographic_view;

static const orthographic_view *view_of(const fxl_model_view *model_view)
{
    return (const orthographic_view *)(const void *)model_view;
}

/* The sum of three products, below 2^62: a box is below 2^31.8 long, and forward at most
 * 1 + 2^-25. */
static int64_t along(const fxl_direction *forward, int32_t x, int32_t y, int32_t z)
{
    return fxl_multiply_s32(forward->x, x) + fxl_multiply_s32(forward->y, y) +
           fxl_multiply_s32(forward->z, z);
}

/* --- vertices ---------------------------------------------------------------------------------- */

/* With a depth buffer the depth of a face with a surface is that of its normal: the depths of its
 * corners in the cache say nothing. So no corner counts as between near and far, and no face as a
 * small one, by flags that no vertex can have; the flags that it has are above. */
#define HIDDEN_FLAGS  (FXL_VERTEX_UNPROJECTED | FXL_PLANES_DEPTH)
#define REAL_FLAGS_AT 8

/* fxl_model_view.scale_vertex */
/* orthographic 2.10 */
static uint32_t flatten(const fxl_model_view *model_view, fxl_cached_vertex *entry)
{
    const orthographic_view *view = view_of(model_view);
    const fxl_planes planes = model_view->planes & FXL_PLANES_ALL;
    if (view->scale_vertex != NULL) {
        (void)view->scale_vertex(model_view, entry);
    } else {
        entry->clip_flags =
            FXL_VERTEX_UNPROJECTED |
            (planes != 0 ? (uint32_t)fxl_outcode(&model_view->view->view_frustum, planes,
                                                 &entry->position)
                         : 0u);
    }
    entry->position.z = flat_depth(&model_view->view->lens);
    if (view->is_deep) {
        entry->clip_flags = HIDDEN_FLAGS | (entry->clip_flags & FXL_PLANES_ALL) << REAL_FLAGS_AT;
    }
    return entry->clip_flags;
}

static bool is_flat(const fxl_model_view *model_view)
{
    return (model_view->planes & FXL_MODEL_VIEW_SCALED) != 0 && model_view->scale_vertex == flatten;
}

/* The depth of a vertex of a flat model view: as fxl_model_view_position, and as a scaled vertex. */
static fxl_q18_46 depth_of(const fxl_model_view *model_view, uint32_t number)
{
    const fxl_point *vertex = &model_view->vertices[number];
    const fxl_q18_46 ahead = fxl_dot(&model_view->axes->forward, vertex->x, vertex->y, vertex->z);
    const unsigned shift = view_of(model_view)->scale_vertex != NULL ? model_view->shift : 0;
    return model_view->translation.z + (fxl_q18_46)((uint64_t)ahead << shift);
}

/* --- clip and project ------------------------------------------------------------------------ */

/* The clip flags of a vertex in the cache. */
static uint32_t real_flags(const fxl_model_view *model_view, const fxl_cached_vertex *vertex)
{
    return is_flat(model_view) && view_of(model_view)->is_deep ? vertex->clip_flags >> REAL_FLAGS_AT
                                                               : vertex->clip_flags;
}

static fxl_clip_result clip_assembled(const fxl_model_view *model_view, const fxl_face *face,
                                      fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    const uint16_t *indices = fxl_face_indices(model_view->indices, face);
    const fxl_view *view = model_view->view;
    fxl_view_polygon *assembled = &work->by_view.polygons[0];
    const fxl_view_polygon *clipped;
    unsigned of_any = 0;
    for (uint32_t i = 0; i < face->count; i++) {
        const fxl_cached_vertex *vertex = fxl_fetch_vertex(model_view, indices[i]);
        fxl_view_point *to = &assembled->vertices[i].position;
        of_any |= real_flags(model_view, vertex);
        fxl_copy_point(&vertex->position, to);
        if (is_flat(model_view)) {
            to->z = depth_of(model_view, indices[i]);
        }
    }
    assembled->colour = face->material;
    assembled->count = face->count;
    const fxl_clip_result result = fxl_clip_view_by_planes(
        assembled, &view->view_frustum, (fxl_planes)(of_any & FXL_PLANES_ALL), &work->by_view,
        (fxl_clip_stats *)model_view->clipper_workspace, &clipped);
    if (clipped == NULL) {
        return result;
    }
    screen->colour = clipped->colour;
    screen->count = clipped->count;
    for (uint32_t i = 0; i < clipped->count; i++) {
        if (fxl_project_orthographic(view, &clipped->vertices[i].position, &screen->points[i]) !=
            FXL_OK) {
            return FXL_CLIP_RANGE;
        }
    }
    return result;
}

/* orthographic 2.2 */
static fxl_clip_result clip(const fxl_model_view *model_view, const fxl_face *face,
                            fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    return fxl_clip_by(model_view, face, work, screen, fxl_project_orthographic, clip_assembled);
}

static const fxl_clipper clipper = {.clip = clip, .by_clip_flags = true};

/* The same of vertices whose flags are hidden: none is projected but here. */
static fxl_clip_result clip_deep(const fxl_model_view *model_view, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    const uint16_t *indices = fxl_face_indices(model_view->indices, face);
    uint32_t of_any = 0, of_all = FXL_PLANES_ALL;
    if (!is_flat(model_view)) {
        return clip(model_view, face, work, screen);
    }
    for (uint32_t i = 0; i < face->count; i++) {
        const fxl_cached_vertex *vertex = fxl_fetch_vertex(model_view, indices[i]);
        const uint32_t flags = real_flags(model_view, vertex) & FXL_PLANES_ALL;
        of_any |= flags;
        of_all &= flags;
        if (of_any == 0 && fxl_project_orthographic(model_view->view, &vertex->position,
                                                    &screen->points[i]) != FXL_OK) {
            return FXL_CLIP_RANGE;
        }
    }
    if (of_any != 0) {
        return of_all != 0 ? FXL_CLIP_OUTSIDE : clip_assembled(model_view, face, work, screen);
    }
    screen->colour = face->material;
    screen->count = face->count;
    return FXL_CLIP_INSIDE;
}

static const fxl_clipper deep_clipper = {.clip = clip_deep};

/* --- depth ------------------------------------------------------------------------------------ */

/* A depth of 1 in a gradient, as a power of two; and how large its members may be: over 1024 columns
 * and rows sums stay below 2^62. */
#define DEPTH_ONE  44
#define DEPTH_MOST 51

/* part / whole 2^scale, off by less than 2^-29 of it. False: it is not below 2^DEPTH_MOST. */
static bool find_quotient(int64_t part, const fxl_real *whole, int scale, int64_t *quotient)
{
    *quotient = 0;
    if (part == 0) {
        return true;
    }
    const fxl_real of = fxl_real_of(fxl_magnitude(part), 0);
    const uint32_t ratio = fxl_mantissa_ratio(&of, whole);
    const int shift = of.exponent - whole->exponent - 31 + scale;
    if (shift > DEPTH_MOST - 32) {
        return false;
    }
    const int64_t value = shift >= 0 ? (int64_t)((uint64_t)ratio << shift)
                                     : (int64_t)(shift > -32 ? ratio >> -shift : 0);
    *quotient = part < 0 ? -value : value;
    return true;
}

/* n . (V - near) is 0 in the plane that is seen at near, and in the middle of the screen it is n_z
 * times the depth behind near: h. With R = far - near the depth there is 1 - h / (2 n_z R), and a
 * column changes it by n_x / (2 n_z R scale). n has 30 bits, h units of 2^-14 of n's, R and scale of
 * 2^-16: n_z R is below 2^61, h below 2^62. */
/* orthographic 2.11 */
static void find_depth(const fxl_model_view *model_view, const fxl_face *face,
                       fxl_depth_plane *plane)
{
    const fxl_view *view = model_view->view;
    const fxl_axes *axes = model_view->axes;
    const fxl_direction *normal = &face->normal;
    fxl_cached_vertex first;
    fxl_transform_vertex(model_view, face->indices[0], &first);
    fxl_view_point *p = &first.position;
    if (is_flat(model_view)) {
        p->z = depth_of(model_view, face->indices[0]);
    }
    p->z -= view->view_frustum.near_z;
    const fxl_block_vector n =
        fxl_block(-along(&axes->right, normal->x, normal->y, normal->z),
                  -along(&axes->up, normal->x, normal->y, normal->z),
                  -along(&axes->forward, normal->x, normal->y, normal->z), 0);
    fxl_gradient *gradient = &plane->gradient;
    int64_t behind = 0;
    plane->one = DEPTH_ONE;
    if (n.z > 0) {
        const int64_t lower = fxl_multiply_s32(n.x, (int32_t)((uint32_t)p->x >> 1)) +
                              fxl_multiply_s32(n.y, (int32_t)((uint32_t)p->y >> 1)) +
                              fxl_multiply_s32(n.z, (int32_t)((uint32_t)p->z >> 1));
        const int64_t height = fxl_multiply_s32(n.x, (int32_t)(p->x >> 32)) +
                               fxl_multiply_s32(n.y, (int32_t)(p->y >> 32)) +
                               fxl_multiply_s32(n.z, (int32_t)(p->z >> 32)) + (lower >> 31);
        const uint32_t range = (uint32_t)(view->lens.far_z - view->lens.near_z);
        const fxl_real whole = fxl_real_of(fxl_multiply_u32((uint32_t)n.z, range), 0);
        const fxl_real by_pixel = fxl_real_of(
            fxl_multiply_u32(whole.mantissa, (uint32_t)view->lens.focal), whole.exponent);
        if (find_quotient(height, &whole, DEPTH_ONE + 1, &behind) &&
            find_quotient(n.x, &by_pixel, DEPTH_ONE + 31, &gradient->along) &&
            find_quotient(-n.y, &by_pixel, DEPTH_ONE + 31, &gradient->down)) {
            gradient->at = ((int64_t)1 << DEPTH_ONE) - behind +
                           ((gradient->along * (1 - view->lens.width) +
                             gradient->down * (1 - view->lens.height)) >>
                            1);
            return;
        }
    }
    gradient->at = gradient->along = gradient->down = 0; /* seen edge-on: at infinity */
    plane->one = 0;
}

/* A distance of a lens with an eye that has the depth of an orthographic one: near / d, with
 * d = (2 far - near - z) / (2 R). Both products are below 2^63; their quotient is near at least. */
/* orthographic 2.11 */
static fxl_q18_46 distance_of(const fxl_lens *lens, fxl_q18_46 depth)
{
    const int64_t range = (int64_t)lens->far_z - lens->near_z;
    const fxl_real near_z = fxl_real_of(
        fxl_multiply_u32((uint32_t)lens->near_z, (uint32_t)range), 31); /* 2 R near, in 2^-46 2^-16 */
    const fxl_real less = fxl_real_of(
        (uint64_t)((lens->far_z + range) * FXL_Q2_30_ONE - depth), 0); /* at least R */
    const uint32_t ratio = fxl_mantissa_ratio(&near_z, &less);
    const int shift = near_z.exponent - less.exponent - 31 + 30;
    return shift >= 0 ? (fxl_q18_46)((uint64_t)ratio << shift) : (fxl_q18_46)(ratio >> -shift);
}

/* --- which faces are drawn ------------------------------------------------------------------- */

/* orthographic 2.4 */
static bool is_front(const fxl_model_view *model_view, const fxl_face *face)
{
    return along(&view_of(model_view)->forward, face->normal.x, face->normal.y, face->normal.z) < 0;
}

/* Keys are unsigned: what is below 2^62 in magnitude is moved above 0. */
static uint64_t key_of(int64_t depth)
{
    return (uint64_t)(depth + ((int64_t)1 << 62));
}

/* Of fxl_cluster_tests: the faces from first on that are fronts, by number. */
/* orthographic 2.4, 2.5 */
static uint32_t find_front(const fxl_scene *scene, const fxl_model *model, uint32_t first,
                           uint32_t count, const fxl_model_view *model_view, const fxl_point *eye,
                           fxl_draw_entry *entries)
{
    const fxl_direction *forward = &view_of(model_view)->forward;
    const fxl_face_bounds *known =
        scene->face_bounds != NULL ? &scene->face_bounds[model->first_face_bounds] : NULL;
    uint32_t found = 0;
    (void)eye;
    for (uint32_t i = first; i < first + count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        if (!is_front(model_view, face)) {
            continue;
        }
        fxl_point box;
        if (known != NULL) {
            box.x = known[i].box_x;
            box.y = known[i].box_y;
            box.z = known[i].box_z;
        } else {
            box = fxl_face_box(model_view->vertices, fxl_face_indices(model_view->indices, face),
                               face->count);
        }
        entries[found++] =
            fxl_draw_entry_of(key_of(along(forward, box.x, box.y, box.z)), (uint16_t)i, 0);
    }
    return found;
}

static uint32_t find_all_front(const fxl_scene *scene, const fxl_model *model,
                               const fxl_model_view *model_view, fxl_draw_entry *entries)
{
    return find_front(scene, model, 0, model->face_count, model_view, NULL, entries);
}

/* The test of an eye that is as far as the cone's apex less forward: u = forward. */
/* orthographic 2.4 */
static bool is_turned_away(const fxl_cluster *cluster, const fxl_point *eye,
                           const fxl_model_view *model_view)
{
    static const fxl_point origin = {0, 0, 0};
    const fxl_direction *forward = &view_of(model_view)->forward;
    fxl_cluster at_origin = *cluster;
    (void)eye;
    at_origin.apex.x = forward->x;
    at_origin.apex.y = forward->y;
    at_origin.apex.z = forward->z;
    return view_of(model_view)->scene->cluster_code->is_turned_away(&at_origin, &origin, model_view);
}

static void find_clusters(const fxl_traversal *traversal, const fxl_model_view *model_view,
                          const fxl_model *model)
{
    const fxl_scene *scene = traversal->renderer->scene;
    const fxl_cluster_code *by = scene->cluster_code;
    const bool is_turned = view_of(model_view)->turned.placement != NULL;
    const fxl_cluster_tests tests = {is_turned ? scene->placement_code->cluster_planes : by->planes,
                                     is_turned_away, find_front};
    by->find_faces_by(traversal, model_view, model, &tests);
}

/* fxl_list_model. */
static void order_faces(const fxl_traversal *traversal, const fxl_model_view *model_view,
                        const fxl_model *model)
{
    fxl_list_found_faces(traversal, model_view, model, find_clusters, find_all_front);
}

/* Has vertices made flat, if the renderer has surfaces. */
static void make_flat(orthographic_view *view, const fxl_renderer *renderer)
{
    fxl_model_view *model_view = &view->turned.model_view;
    if (fxl_renderer_shader(renderer, FXL_SHADER_SURFACES) == NULL) {
        return;
    }
    if ((model_view->planes & FXL_MODEL_VIEW_SCALED) != 0) {
        view->scale_vertex = model_view->scale_vertex;
    }
    model_view->planes |= FXL_MODEL_VIEW_SCALED;
    model_view->scale_vertex = flatten;
}

/* Sets up the view of an instance, with its shader. rounded: room for one. Answers its model. */
/* orthographic 2.3 */
static const fxl_model *view_instance(const fxl_traversal *traversal, const fxl_draw_entry *entry,
                                      orthographic_view *view, fxl_rounded_instance *rounded)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_axes *axes = &renderer->frame.view.camera.axes;
    const fxl_placement_code *turned = fxl_placement_code_of(scene, entry->index);
    fxl_model_view *model_view = &view->turned.model_view;
    view->scene = scene;
    view->is_deep = renderer->target->depth_bits != 0;
    view->scale_vertex = NULL;
    if (turned == NULL) {
        const fxl_instance *instance = fxl_view_instance(traversal, entry, model_view);
        view->turned.placement = NULL;
        view->forward = axes->forward;
        make_flat(view, renderer);
        return &scene->models[instance->model];
    }
    const fxl_model *model =
        turned->view(&view->turned, scene, entry->index, &renderer->frame.view,
                     &traversal->workspace->cache, entry->instance.planes);
    fxl_axes rows;
    turned->rows(axes, &view->turned.placement->orientation, &rows);
    view->forward = rows.forward;
    turned->set_shader(traversal, entry, NULL, model_view, rounded);
    make_flat(view, renderer);
    return model;
}

static bool submit_instance(const fxl_traversal *traversal, const fxl_draw_entry *entry)
{
    FXL_ALIGN_8 orthographic_view view;
    fxl_rounded_instance rounded;
    const fxl_model *model = view_instance(traversal, entry, &view, &rounded);
    const fxl_model_view *model_view = &view.turned.model_view;
    return fxl_lists_faces(traversal->renderer, model)
               ? fxl_submit_sorted_once(traversal, model_view, model, order_faces)
               : fxl_submit_convex(traversal, model_view, model, is_front);
}

/* --- the order ------------------------------------------------------------------------------- */

/* The instances in sight were sorted by distance. A difference of two points of the world is below
 * 2^30, so a depth is below 2^61. */
/* orthographic 2.5 */
static void begin(const fxl_traversal *traversal)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_frame *frame = &renderer->frame;
    const fxl_camera *camera = &frame->view.camera;
    if (traversal->display_list == NULL) {
        return;
    }
    for (uint32_t i = 0; i < frame->visible_count; i++) {
        fxl_draw_entry *entry = &frame->draw_list[i];
        const fxl_draw_instance kept = entry->instance;
        fxl_point from_eye;
        fxl_subtract(&scene->instances[entry->index].centre, &camera->position, &from_eye);
        *entry = fxl_draw_entry_of(
            key_of(along(&camera->axes.forward, from_eye.x, from_eye.y, from_eye.z)), entry->index,
            kept.layer);
        entry->instance = kept;
    }
    fxl_sort_instances(frame->draw_list, frame->visible_count);
    if (scene->placements != NULL) {
        traversal->counters->rounded =
            (uint16_t)scene->placement_code->count_rounded(traversal, 0, 0);
    }
}

static bool submit(const fxl_traversal *traversal)
{
    begin(traversal);
    return fxl_submit_all(traversal, submit_instance);
}

static const fxl_order by_depth = {.submit = submit};

/* --- the renderer ---------------------------------------------------------------------------- */

static bool has_clipper(const fxl_renderer *renderer)
{
    return renderer->clipper == &clipper || renderer->clipper == &deep_clipper;
}

/* orthographic 1.3 */
static void take(fxl_renderer *renderer)
{
    const bool is_deep = renderer->target != NULL && renderer->target->depth_bits != 0 &&
                         fxl_renderer_shader(renderer, FXL_SHADER_SURFACES) != NULL;
    if (renderer->clipper == &fxl_clipper_view || has_clipper(renderer)) {
        renderer->clipper = is_deep ? &deep_clipper : &clipper;
    }
    if (renderer->order == &fxl_by_distance) {
        renderer->order = &by_depth;
    }
    renderer->check = fxl_check_combination;
}

static const fxl_orthographic_code code = {
    fxl_project_orthographic, has_clipper, &by_depth, take, begin, submit_instance, find_depth,
    distance_of};

const fxl_off_centre_code fxl_orthographic = {is_valid, set_lens, set_pose, &code};
