/* SPDX-License-Identifier: MIT */
/* The numbers of a turned instance. Rows and columns of a checked orientation are at most
 * 1 + 11 2^-28 long (lib/scene/placement_check.c), so a product of one with differences below 2^30
 * is below 2^61, as with a unit vector (fxl_dot). Their entries exceed 2^30 by less than 2^6, which
 * fxl_multiply_s31 allows for both factors: where the upper half of a factor is 2^14 or more, its
 * lower half is below 2^6, and where it is -2^14 - 1, the middle products add up to more than
 * -2^31. */
#include "../math/family.h"
#include "../math/arith.h"
#include "placement.h"
#include "../scene/face_bounds.h"
#include "../scene/placement_code.h"
#include "cull.h"
#include "model_view.h"
#include "order.h"
#include "outcode.h"

/* floor(value * scale / 2^32). |value| < 2^61 and scale <= 2^24: the result is below 2^53. */
static int64_t scaled(int64_t value, fxl_q16_16 scale)
{
    const uint64_t low = fxl_multiply_u32((uint32_t)value, (uint32_t)scale);
    return fxl_multiply_s32((int32_t)(value >> 32), scale) + (int64_t)(low >> 32);
}

/* The same, rounded, / 2^shift. The 32 bits that `scaled` leaves out are below the half unit that
 * the rounding adds. */
FXL_ONCE int32_t scaled_by(int64_t value, fxl_q16_16 scale, unsigned shift)
{
    return (int32_t)fxl_round_shift(scaled(value, scale), shift);
}

/* Column n of the orientation along a row of the view, in units of 2^-60. */
#define ALONG(row, of, n) \
    (fxl_multiply_s31((row)->x, (of)->x.n) + fxl_multiply_s31((row)->y, (of)->y.n) + \
     fxl_multiply_s31((row)->z, (of)->z.n))

/* A row of the matrix / 2^shift. */
/* SPEC 8.2 */
static void scale_row(const fxl_direction *row, const fxl_placement *placement, unsigned shift,
                      fxl_direction *to)
{
    const fxl_orientation *of = &placement->orientation;
    to->x = (fxl_q2_30)scaled_by(ALONG(row, of, x), placement->scale, 14 + shift);
    to->y = (fxl_q2_30)scaled_by(ALONG(row, of, y), placement->scale, 14 + shift);
    to->z = (fxl_q2_30)scaled_by(ALONG(row, of, z), placement->scale, 14 + shift);
}

/* SPEC 8.2 */
unsigned fxl_placement_matrix(const fxl_placement *placement, const fxl_axes *view,
                              fxl_axes *matrix)
{
    unsigned shift = 0;
    if (placement->scale == FXL_Q16_16_ONE) {
        fxl_placement_rows(view, &placement->orientation, matrix);
        return 0;
    }
    while (FXL_Q16_16_ONE << shift < placement->scale) {
        shift++;
    }
    scale_row(&view->right, placement, shift, &matrix->right);
    scale_row(&view->up, placement, shift, &matrix->up);
    scale_row(&view->forward, placement, shift, &matrix->forward);
    return shift;
}

static int32_t along(const fxl_direction *row, const fxl_point *vertex, fxl_q16_16 scale)
{
    const int64_t sum = fxl_multiply_s31(row->x, vertex->x) + fxl_multiply_s31(row->y, vertex->y) +
                        fxl_multiply_s31(row->z, vertex->z);
    return scaled_by(sum, scale, 14);
}

/* SPEC 8.5 */
void fxl_placement_point(const fxl_placement *placement, const fxl_point *centre,
                         const fxl_point *vertex, fxl_point *point)
{
    point->x = centre->x + along(&placement->orientation.x, vertex, placement->scale);
    point->y = centre->y + along(&placement->orientation.y, vertex, placement->scale);
    point->z = centre->z + along(&placement->orientation.z, vertex, placement->scale);
}

void fxl_placement_direction(const fxl_placement *placement, const fxl_direction *direction,
                             fxl_direction *turned)
{
    const fxl_point as_point = {direction->x, direction->y, direction->z};
    turned->x = along(&placement->orientation.x, &as_point, FXL_Q16_16_ONE);
    turned->y = along(&placement->orientation.y, &as_point, FXL_Q16_16_ONE);
    turned->z = along(&placement->orientation.z, &as_point, FXL_Q16_16_ONE);
}

/* orientation^T . (eye - centre), exact, in units of 2^-46. */
static inline void eye_along(const fxl_orientation *of, const fxl_point *from_eye,
                             fxl_q18_46 eye[3])
{
    const fxl_point to_eye = {-from_eye->x, -from_eye->y, -from_eye->z};
    eye[0] = ALONG(&to_eye, of, x);
    eye[1] = ALONG(&to_eye, of, y);
    eye[2] = ALONG(&to_eye, of, z);
}

unsigned fxl_placement_eye(const fxl_placement *placement, const fxl_point *from_eye,
                           fxl_q16_16 radius, fxl_point *eye)
{
    fxl_q18_46 exact[3];
    eye_along(&placement->orientation, from_eye, exact);
    if (placement->scale == FXL_Q16_16_ONE) { /* sums below 2^61: the results fit */
        eye->x = (int32_t)fxl_round_shift(exact[0], 30);
        eye->y = (int32_t)fxl_round_shift(exact[1], 30);
        eye->z = (int32_t)fxl_round_shift(exact[2], 30);
        if (fxl_eye_is_within(eye, (1 << 30) - 1 - radius)) {
            return 0;
        }
    }
    return fxl_placement_divide_eye(exact, placement->scale, radius, eye);
}

/* Both sides in units of 2^-76, as upper * 2^32 + lower, 0 <= lower < 2^32. Left: with
 * e = upper * 2^32 + lower along each axis, |upper| < 2^29 and |normal| sums up to less than
 * 1.74 2^30, so both sums are below 2^63. Right: scale * height * 2^14, with |scale * height| below
 * 2^14 units, 2^76 of 2^-62. */
/* SPEC 8.3 */
bool fxl_placement_is_front(const fxl_placement *placement, const fxl_point *from_eye,
                            const fxl_direction *normal, fxl_q18_46 height)
{
    const int32_t of[3] = {normal->x, normal->y, normal->z};
    fxl_q18_46 eye[3];
    int64_t upper = 0, lower = 0;
    eye_along(&placement->orientation, from_eye, eye);
    for (uint32_t i = 0; i < 3; i++) {
        upper += fxl_multiply_s32(of[i], (int32_t)(eye[i] >> 32));
        lower += fxl_multiply_su32(of[i], (uint32_t)eye[i]);
    }
    const uint64_t low = fxl_multiply_u32((uint32_t)height, (uint32_t)placement->scale);
    const int64_t high =
        fxl_multiply_s32((int32_t)(height >> 32), placement->scale) + (int64_t)(low >> 32);
    const int64_t right_upper = (int64_t)((uint64_t)high << 14) + (int64_t)((uint32_t)low >> 18);
    const uint32_t right_lower = (uint32_t)low << 14;
    upper += (lower >> 32) - right_upper;
    return upper > 0 || (upper == 0 && (uint32_t)lower > right_lower);
}

/* A file of its own, so that fxl_placement_eye keeps no registers for it. */

/* value / (scale 2^(14 + shift)), rounded: floor((value + half) / divisor), in two exact floors.
 * half is below 2^24 2^23. Returns false if the quotient exceeds 2^30. */
static bool divide(int64_t value, fxl_q16_16 scale, unsigned shift, int32_t *quotient)
{
    const int64_t half = (int64_t)scale << (13 + shift);
    const int64_t numerator = (value + half) >> (14 + shift);
    if (!fxl_within(numerator, (int64_t)scale << 30)) {
        return false;
    }
    *quotient = fxl_divide_down(numerator, (uint32_t)scale);
    return true;
}

/* SPEC 8.4 */
unsigned fxl_placement_divide_eye(const fxl_q18_46 exact[3], fxl_q16_16 scale, fxl_q16_16 radius,
                                  fxl_point *eye)
{
    unsigned shift = 0;
    int32_t limit = (1 << 30) - 1 - radius;
    while (!(divide(exact[0], scale, shift, &eye->x) && divide(exact[1], scale, shift, &eye->y) &&
             divide(exact[2], scale, shift, &eye->z) && limit >= 0 &&
             fxl_eye_is_within(eye, limit))) {
        shift++;
        limit = (1 << 30) - 1 - (radius >> shift);
    }
    return shift;
}

/* Moves the vertex to translation + 2^shift (matrix . vertex). Exact: the difference is matrix .
 * vertex, and the instance lies within FXL_COORDINATE_MAX, so the product is below 2^60. */
FXL_ONCE fxl_q18_46 scaled_from(fxl_q18_46 translation, fxl_q18_46 position, unsigned shift)
{
    return translation + (fxl_q18_46)((uint64_t)(position - translation) << shift);
}

static uint32_t scale_vertex(const fxl_model_view *model_view, fxl_cached_vertex *entry)
{
    const fxl_view_point *from = &model_view->translation;
    const fxl_planes planes = model_view->planes & FXL_PLANES_ALL;
    fxl_view_point *at = &entry->position;
    at->x = scaled_from(from->x, at->x, model_view->shift);
    at->y = scaled_from(from->y, at->y, model_view->shift);
    at->z = scaled_from(from->z, at->z, model_view->shift);
    entry->clip_flags =
        FXL_VERTEX_UNPROJECTED |
        (planes != 0 ? (uint32_t)fxl_outcode(&model_view->view->view_frustum, planes, at) : 0u);
    return entry->clip_flags;
}

/* SPEC 8.2 */
const fxl_model *fxl_turned_view_of_instance(fxl_turned_view *turned, const fxl_scene *scene,
                                             uint32_t number, const fxl_view *view,
                                             fxl_vertex_cache *cache, uint32_t planes)
{
    fxl_model_view *model_view = &turned->model_view;
    const fxl_instance *instance = &scene->instances[number];
    const fxl_model *model = &scene->models[instance->model];
    const fxl_placement *placement = fxl_placement_of(scene, number);
    fxl_point eye;
    turned->placement = placement;
    fxl_model_view_of_instance(model_view, scene, instance, view, cache);
    turned->from_eye = model_view->offset;
    turned->eye_shift = fxl_placement_eye(placement, &turned->from_eye, model->radius, &eye);
    model_view->offset.x = -eye.x;
    model_view->offset.y = -eye.y;
    model_view->offset.z = -eye.z;
    model_view->axes = &turned->matrix;
    model_view->planes = (fxl_planes)planes;
    const unsigned shift = fxl_placement_matrix(placement, &view->camera.axes, &turned->matrix);
    if (shift != 0) {
        model_view->shift = (uint8_t)shift;
        model_view->planes |= FXL_MODEL_VIEW_SCALED;
        model_view->scale_vertex = scale_vertex;
    }
    return model;
}

/* SPEC 8.3 */
bool fxl_turned_view_is_front(const fxl_turned_view *turned, const fxl_face *face)
{
    const fxl_model_view *model_view = &turned->model_view;
    const fxl_q18_46 height = fxl_face_height(model_view->vertices, face);
    return fxl_placement_is_front(turned->placement, &turned->from_eye, &face->normal, height);
}

/* The squared distance of the box from the eye, both in units of 2^shift / 65536; the box is
 * rounded down. With the limit of fxl_placement_eye each difference is at most 2^31, and the square
 * of one that wraps to -2^31 is the same. */
/* SPEC 8.4 */
static uint64_t box_distance(const fxl_point *box, const fxl_point *eye, unsigned shift)
{
    return fxl_box_distance(box->x >> shift, box->y >> shift, box->z >> shift, eye);
}

uint32_t fxl_list_turned_faces(const fxl_turned_view *turned, const fxl_scene *scene,
                               const fxl_model *model, uint32_t first, uint32_t count,
                               fxl_draw_entry *entries)
{
    const fxl_model_view *model_view = &turned->model_view;
    const fxl_point *offset = &model_view->offset;
    const fxl_point eye = {-offset->x, -offset->y, -offset->z};
    const fxl_face_bounds *known =
        scene->face_bounds != NULL ? &scene->face_bounds[model->first_face_bounds] : NULL;
    const fxl_draw_entry *const start = entries;
    for (uint32_t i = first; i < first + count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        const uint16_t *indices = fxl_face_indices(model_view->indices, face);
        const fxl_q18_46 height = known != NULL ? fxl_face_bounds_height(&known[i])
                                                : fxl_face_height(model_view->vertices, face);
        const int side = fxl_estimated_side((height >> turned->eye_shift) -
                                            fxl_dot(&face->normal, eye.x, eye.y, eye.z));
        if (side < 0 || (side == 0 && fxl_turned_view_is_front(turned, face))) {
            const fxl_point box =
                fxl_face_box_of(known, i, model_view->vertices, indices, face->count);
            *entries++ =
                fxl_draw_entry_of(box_distance(&box, &eye, turned->eye_shift), (uint16_t)i, 0);
        }
    }
    return (uint32_t)(entries - start);
}

/* A vertex v of the cluster is |scale orientation . (v - c)| away from the cluster's centre c, both
 * placed. That is at most the scaled radius and 22 units of 1/65536, if the scaled radius is at
 * most FXL_COORDINATE_MAX: rows stretch by less than 11 2^-28. The centre's rounding adds 0.87
 * units, and the matrix's, or the point's where it is rounded in the world, 1.5.
 * FXL_PLACEMENT_SLACK is more. The box that holds c may reach out of the model's sphere, and so of
 * the world. */
/* SPEC 8.4 */
uint32_t fxl_turned_cluster_planes(const fxl_turned_view *turned, const fxl_cluster *cluster)
{
    const fxl_model_view *model_view = &turned->model_view;
    const fxl_view *view = model_view->view;
    const fxl_point *eye = &view->camera.position;
    const fxl_placement *placement = turned->placement;
    const uint64_t reach = fxl_multiply_u32((uint32_t)placement->scale, (uint32_t)cluster->radius);
    fxl_point centre = {turned->from_eye.x + eye->x, turned->from_eye.y + eye->y,
                        turned->from_eye.z + eye->z};
    uint32_t planes = model_view->planes & FXL_PLANES_ALL;
    if (planes == 0) {
        return 0;
    }
    fxl_placement_point(placement, &centre, &cluster->centre, &centre);
    if (reach <= (uint64_t)FXL_COORDINATE_MAX << 16 && fxl_point_in_range(&centre)) {
        const uint32_t crossed =
            fxl_sphere_planes(&view->camera, &view->view_frustum, &centre,
                              fxl_scaled_radius(placement->scale, cluster->radius));
        if (crossed == FXL_SPHERE_OUTSIDE) {
            return crossed;
        }
        planes &= crossed;
    }
    return planes == 0 ? 0 : planes | (model_view->planes & FXL_MODEL_VIEW_SCALED);
}

#if !FXL_PLACEMENTS_IN_ASSEMBLY

/* A row of the view along a column of the orientation. Both may have an entry of -2^30 - 4, so
 * fxl_multiply_s31 would not do. */
static FXL_ONE_COPY fxl_q2_30 row_along(const fxl_direction *row, int32_t x, int32_t y, int32_t z)
{
    return (fxl_q2_30)fxl_round_shift(fxl_multiply_s32(row->x, x) + fxl_multiply_s32(row->y, y) +
                                          fxl_multiply_s32(row->z, z),
                                      30);
}

static void turn_row(const fxl_direction *row, const fxl_orientation *of, fxl_direction *to)
{
    to->x = row_along(row, of->x.x, of->y.x, of->z.x);
    to->y = row_along(row, of->x.y, of->y.y, of->z.y);
    to->z = row_along(row, of->x.z, of->y.z, of->z.z);
}

void fxl_placement_rows(const fxl_axes *view, const fxl_orientation *of, fxl_axes *matrix)
{
    turn_row(&view->right, of, &matrix->right);
    turn_row(&view->up, of, &matrix->up);
    turn_row(&view->forward, of, &matrix->forward);
}

#endif
