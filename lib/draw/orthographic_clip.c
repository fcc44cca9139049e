/* SPDX-License-Identifier: MIT */
/* Faces with an orthographic lens: their vertices, clip and depth. */
#include "../clip/clip_by_view.h"
#include "../math/arith.h"
#include "orthographic.h"
#include "surface_polygon.h"

/* --- vertices ---------------------------------------------------------------------------------- */

/* With a depth buffer the depth of a face with a surface is that of its normal: the depths of its
 * corners in the cache say nothing. So no corner counts as between near and far, and no face as a
 * small one, by flags that no vertex can have; the flags that it has are above. */
#define HIDDEN_FLAGS  (FXL_VERTEX_UNPROJECTED | FXL_PLANES_DEPTH)
#define REAL_FLAGS_AT 8

/* fxl_model_view.scale_vertex. A vertex is projected at once, from where it is: surfaces would project
 * one that is not from where an off-centre lens draws it, which may round otherwise. */
/* orthographic 2.10 */
uint32_t fxl_flatten_vertex(const fxl_model_view *model_view, fxl_cached_vertex *entry)
{
    const fxl_orthographic_view *view = fxl_orthographic_view_of(model_view);
    const fxl_planes planes = model_view->planes & FXL_PLANES_ALL;
    if (view->scale_vertex != NULL) {
        (void)view->scale_vertex(model_view, entry);
    } else {
        entry->clip_flags = FXL_VERTEX_UNPROJECTED |
                            (planes != 0 ? (uint32_t)fxl_outcode(&model_view->view->view_frustum,
                                                                 planes, &entry->position)
                                         : 0u);
    }
    entry->position.z = fxl_flat_depth(&model_view->view->lens);
    if (view->is_deep) {
        entry->clip_flags = HIDDEN_FLAGS | (entry->clip_flags & FXL_PLANES_ALL) << REAL_FLAGS_AT;
    } else if (entry->clip_flags == FXL_VERTEX_UNPROJECTED &&
               fxl_project_orthographic(model_view->view, &entry->position, &entry->screen) ==
                   FXL_OK) {
        entry->clip_flags = fxl_vertex_place_flags(&entry->screen);
    }
    return entry->clip_flags;
}

static bool is_flat(const fxl_model_view *model_view)
{
    return (model_view->planes & FXL_MODEL_VIEW_SCALED) != 0 &&
           model_view->scale_vertex == fxl_flatten_vertex;
}

/* The depth of a vertex of a flat model view: as fxl_model_view_position, and as a scaled vertex. */
static fxl_q18_46 depth_of(const fxl_model_view *model_view, uint32_t number)
{
    const fxl_point *vertex = &model_view->vertices[number];
    const fxl_q18_46 ahead = fxl_dot(&model_view->axes->forward, vertex->x, vertex->y, vertex->z);
    const unsigned shift =
        fxl_orthographic_view_of(model_view)->scale_vertex != NULL ? model_view->shift : 0;
    return model_view->translation.z + (fxl_q18_46)((uint64_t)ahead << shift);
}

/* --- clip and project ------------------------------------------------------------------------ */

/* The clip flags of a vertex in the cache. */
static uint32_t real_flags(const fxl_model_view *model_view, const fxl_cached_vertex *vertex)
{
    return is_flat(model_view) && fxl_orthographic_view_of(model_view)->is_deep
               ? vertex->clip_flags >> REAL_FLAGS_AT
               : vertex->clip_flags;
}

/* fxl_corner_taker */
static inline uint32_t take(const fxl_model_view *model_view, uint32_t number,
                            const fxl_cached_vertex *vertex, fxl_view_point *place)
{
    fxl_copy_point(&vertex->position, place);
    if (is_flat(model_view)) {
        place->z = depth_of(model_view, number);
    }
    return real_flags(model_view, vertex);
}

static fxl_clip_result clip_assembled(const fxl_model_view *model_view, const fxl_face *face,
                                      fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    return fxl_clip_assembled_by(model_view, face, work, screen, take, fxl_project_orthographic);
}

/* fxl_projector of a point that is inside all planes: so on the screen, or an eighth of a pixel beside
 * it, which needs no test. */
static inline fxl_status project_inside(const fxl_view *view, const fxl_view_point *point,
                                        fxl_screen_point *screen)
{
    screen->x = (fxl_q16_16)fxl_orthographic_x(view, point);
    screen->y = (fxl_q16_16)fxl_orthographic_y(view, point);
    return FXL_OK;
}

/* orthographic 2.2 */
static fxl_clip_result clip(const fxl_model_view *model_view, const fxl_face *face,
                            fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    return fxl_clip_by(model_view, face, work, screen, project_inside, clip_assembled);
}

const fxl_clipper fxl_orthographic_clipper = {.clip = clip, .by_clip_flags = true};

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

const fxl_clipper fxl_orthographic_deep_clipper = {.clip = clip_deep};

/* --- depth ------------------------------------------------------------------------------------ */

/* A depth of 1 in a gradient, as a power of two; how large its changes a column and a row may be; and how
 * far behind near its plane in the middle of the screen: over 512 columns and rows from there sums stay below 2^62 + 2^50. */
#define DEPTH_ONE   44
#define CHANGE_MOST 51
#define BEHIND_MOST 61

/* part / whole 2^scale, off by less than 2^-29 of it. False: it is not below 2^most. */
static bool find_quotient(int64_t part, const fxl_real *whole, int scale, int most,
                          int64_t *quotient)
{
    *quotient = 0;
    if (part == 0) {
        return true;
    }
    const fxl_real of = fxl_real_of(fxl_magnitude(part), 0);
    const uint32_t ratio = fxl_mantissa_ratio(&of, whole);
    const int shift = of.exponent - whole->exponent - 31 + scale;
    if (shift >= most || (shift > most - 32 && ratio >> (most - shift) != 0)) {
        return false;
    }
    const int64_t value = shift >= 0 ? (int64_t)((uint64_t)ratio << shift)
                                     : (int64_t)(shift > -32 ? ratio >> -shift : 0);
    *quotient = part < 0 ? -value : value;
    return true;
}

/* What so much of a pixel, in 1/65536, changes: of what is below 2^CHANGE_MOST and 2^13. */
static int64_t beside(int64_t gradient, int32_t pixels)
{
    return (gradient >> 4) * pixels >> 12;
}

/* n . (V - near) is 0 in the plane that is seen at near, and where the eye is, it is n_z
 * times the depth behind near: h. With R = far - near the depth there is 1 - h / (2 n_z R), and a
 * column changes it by n_x / (2 n_z R scale). n has 30 bits, h units of 2^-14 of n's, R and scale of
 * 2^-16: n_z R is below 2^61, h below 2^62. */
/* orthographic 2.11 */
void fxl_find_orthographic_depth(const fxl_model_view *model_view, const fxl_face *face,
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
        fxl_block(-fxl_along(&axes->right, normal->x, normal->y, normal->z),
                  -fxl_along(&axes->up, normal->x, normal->y, normal->z),
                  -fxl_along(&axes->forward, normal->x, normal->y, normal->z), 0);
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
        if (find_quotient(height, &whole, DEPTH_ONE + 1, BEHIND_MOST, &behind) &&
            find_quotient(n.x, &by_pixel, DEPTH_ONE + 31, CHANGE_MOST, &gradient->along) &&
            find_quotient(-n.y, &by_pixel, DEPTH_ONE + 31, CHANGE_MOST, &gradient->down)) {
            gradient->at =
                ((int64_t)1 << DEPTH_ONE) - behind +
                ((gradient->along * (1 - view->lens.width) +
                  gradient->down * (1 - view->lens.height)) >>
                 1) -
                beside(gradient->along, view->projection.centre_x - view->lens.width * 32768) -
                beside(gradient->down, view->projection.centre_y - view->lens.height * 32768);
            return;
        }
    }
    gradient->at = gradient->along = gradient->down = 0; /* seen edge-on: at infinity */
    plane->one = 0;
}

/* A distance of a lens with an eye that has the depth of an orthographic one: near / d, with
 * d = 1 - (z - near) / (2 R). Both products are below 2^63; their quotient is near at least. */
/* orthographic 2.11 */
fxl_q18_46 fxl_distance_of_orthographic(const fxl_view *view, fxl_q18_46 depth)
{
    const fxl_lens *lens = &view->lens;
    const fxl_q18_46 behind = depth - view->view_frustum.near_z;
    const int64_t range = (int64_t)lens->far_z - lens->near_z;
    const fxl_real near_z = fxl_real_of(fxl_multiply_u32((uint32_t)lens->near_z, (uint32_t)range),
                                        31); /* 2 R near, in 2^-46 2^-16 */
    const fxl_real less =
        fxl_real_of((uint64_t)(2 * range * FXL_Q2_30_ONE - behind), 0); /* at least R */
    const uint32_t ratio = fxl_mantissa_ratio(&near_z, &less);
    const int shift = near_z.exponent - less.exponent - 31 + 30;
    return shift >= 0 ? (fxl_q18_46)((uint64_t)ratio << shift) : (fxl_q18_46)(ratio >> -shift);
}
