/* SPDX-License-Identifier: MIT */
/* A sphere that slides. Each position that is accepted was found free of every face: the faces are
 * then at least the radius away from its centre. Two such positions are at most the radius apart,
 * so on the way between them the centre keeps half the radius from every face. */
#include "../math/plane.h"
#include "../scene/placement_code.h"
#include "exact.h"

enum {
    PASSES = 6, /* pushes of a step, one after another */
    GAP = 8,    /* units of 1/65536 that a push leaves; above the error of a push, 2 units, or 3.5
                   from a turned face, whose normal may be 12 2^-28 longer than 1 */
    SKEW = 4    /* units that a vertex may lie off the plane of its face: FXL_PLANARITY_MAX */
};

/* What may be wrong with the plane of a face: how far in units of 1/65536 a vertex may lie off it,
 * and by how many units of 2^-30 its normal may be longer than 1. */
typedef struct {
    int32_t skew, longer;
} tolerance;

/* A turned vertex is SKEW times the scale off, and more by what the rows are off a rotation and by
 * three roundings. With O the rows and w a vector of the face, at most twice the scaled radius R
 * long, O n . O w differs from n . w by 22 2^-28 of |w|, so by less than R / 2^22. The rounded
 * normal adds 0.87 units and the two rounded points 0.87 each. The turned normal is at most 1 + 12
 * 2^-28 long. */
/* collide 3.5 */
static tolerance tolerance_of(const fxl_scene *scene, const fxl_instance *instance)
{
    const uint32_t number = fxl_instance_number(scene, instance);
    tolerance of = {SKEW, 4};
    if (fxl_placement_code_of(scene, number) != NULL) {
        const fxl_q16_16 scale = fxl_placement_of(scene, number)->scale;
        of.skew += fxl_instance_radius(scene, instance) >> 22;
        of.skew += (SKEW * scale + 0xFFFF) >> 16;
        of.longer = 48;
    }
    return of;
}

/* The face that is nearest to the centre of a sphere, of those that the sphere reaches into. */
typedef struct {
    fxl_q16_16 distance; /* rounded; INT32_MAX: there is none */
    fxl_point away;      /* from the face to the centre, as long as `length` */
    uint32_t length;     /* units of `away`; may be 2^30 for a unit vector */
    int32_t skew;        /* of the face */
    uint16_t instance, face;
} contact;

/* The nearest point of the edge from a to b, relative to the centre, where the foot of the centre
 * falls between them; a and b are relative to the centre, too. Error: half a unit, and half of
 * 2^-31 of the edge. */
static fxl_point nearest_of_edge(const fxl_point *a, const fxl_point *b)
{
    fxl_point d, nearest = *a;
    fxl_subtract(b, a, &d);
    const int64_t along = -fxl_dot_vectors(a, &d);
    const int64_t whole = fxl_dot_vectors(&d, &d);
    if (along >= whole) {
        return *b;
    }
    if (along > 0) {
        const uint32_t part = (uint32_t)(fxl_fraction((uint64_t)along, (uint64_t)whole) >> 33);
        nearest.x += (int32_t)fxl_round_shift(fxl_multiply_su32(d.x, part), 31);
        nearest.y += (int32_t)fxl_round_shift(fxl_multiply_su32(d.y, part), 31);
        nearest.z += (int32_t)fxl_round_shift(fxl_multiply_su32(d.z, part), 31);
    }
    return nearest;
}

/* collide 3.1 */
static void keep(contact *nearest, fxl_q16_16 distance, const fxl_point *away, uint32_t length)
{
    if (distance < nearest->distance) {
        nearest->distance = distance;
        nearest->away = *away;
        nearest->length = length;
    }
}

/* The edges of a face that a sphere reaches into. */
/* collide 3.2 */
static void touch_edges(const fxl_face_place *face, const fxl_sphere *sphere, contact *nearest)
{
    const fxl_point origin = {0, 0, 0};
    const fxl_sphere about = {origin, sphere->radius};
    fxl_point before = fxl_corner_from(face, face->count - 1, &sphere->centre);
    for (uint32_t k = 0; k < face->count; k++) {
        const fxl_point corner = fxl_corner_from(face, k, &sphere->centre);
        if (fxl_sphere_meets_segment(&about, &before, &corner)) {
            const fxl_point at = nearest_of_edge(&before, &corner);
            const fxl_point away = {-at.x, -at.y, -at.z};
            const uint32_t length = fxl_square_root(fxl_square_of(&away));
            keep(nearest, (fxl_q16_16)length, &away, length);
        }
        before = corner;
    }
}

/* A face that the sphere may reach into. The height of the centre is at most
 * |normal| (radius + skew) where it does: the bound is below 2^55. */
/* collide 3.2 */
static void touch_face(const fxl_face_place *face, const fxl_sphere *sphere,
                       const tolerance *of_face, contact *nearest)
{
    const fxl_q18_46 height = fxl_height_over(face, &sphere->centre);
    const int64_t reach = sphere->radius + of_face->skew;
    const bool front = height >= 0;
    if (!fxl_within(height, reach * FXL_Q2_30_ONE + reach * of_face->longer)) {
        return;
    }
    const fxl_point normal = {face->normal.x, face->normal.y, face->normal.z};
    const fxl_point inward = {-normal.x, -normal.y, -normal.z};
    if (fxl_line_is_within(face, &sphere->centre, &inward)) {
        const int64_t distance = fxl_round_shift(front ? height : -height, 30);
        keep(nearest, (fxl_q16_16)distance, front ? &normal : &inward, (uint32_t)FXL_Q2_30_ONE);
    } else {
        touch_edges(face, sphere, nearest);
    }
}

/* collide 3.1 */
static contact find_contact(const fxl_scene *scene, const fxl_sphere *sphere)
{
    contact nearest = {INT32_MAX, {0, 0, 0}, 0, 0, FXL_HIT_NONE, 0};
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        const fxl_instance *instance = &scene->instances[i];
        const uint32_t faces = scene->models[instance->model].face_count;
        const tolerance of_faces = tolerance_of(scene, instance);
        if (!fxl_segment_nears_instance(scene, instance, &sphere->centre, &sphere->centre,
                                        sphere->radius + of_faces.skew)) {
            continue;
        }
        for (uint32_t k = 0; k < faces; k++) {
            fxl_face_place face;
            fxl_place_face(&face, scene, instance, k);
            const fxl_q16_16 before = nearest.distance;
            touch_face(&face, sphere, &of_faces, &nearest);
            if (nearest.distance < before) {
                nearest.skew = of_faces.skew;
                nearest.instance = (uint16_t)i;
                nearest.face = (uint16_t)k;
            }
        }
    }
    return nearest;
}

static fxl_q16_16 clamped(int64_t value)
{
    return (fxl_q16_16)(value > FXL_COORDINATE_MAX    ? FXL_COORDINATE_MAX
                        : value < -FXL_COORDINATE_MAX ? -FXL_COORDINATE_MAX
                                                      : value);
}

/* by * component / length, |component| <= length + 1, by < 2^25: the product is below 2^56. */
static int64_t scaled(int32_t component, int32_t by, uint32_t length)
{
    return fxl_divide_round(fxl_multiply_s32(component, by), length);
}

/* Moves the sphere so far away from a contact that it is free of that face. */
/* collide 3.4 */
static void push(fxl_sphere *sphere, const contact *from)
{
    /* A sphere on an edge has no direction away from it; upward will do. */
    const fxl_point up = {0, 1, 0};
    const fxl_point *away = from->length != 0 ? &from->away : &up;
    const uint32_t length = from->length != 0 ? from->length : 1;
    const int32_t by = sphere->radius + from->skew + GAP - from->distance;
    sphere->centre.x = clamped(sphere->centre.x + scaled(away->x, by, length));
    sphere->centre.y = clamped(sphere->centre.y + scaled(away->y, by, length));
    sphere->centre.z = clamped(sphere->centre.z + scaled(away->z, by, length));
}

/* Whether two positions are at most the radius apart. */
/* collide 3.3 */
static bool is_near(const fxl_point *a, const fxl_point *b, fxl_q16_16 radius)
{
    fxl_point between;
    fxl_subtract(a, b, &between);
    return fxl_square_of(&between) <= (uint64_t)fxl_multiply_s32(radius, radius);
}

/* One step; false where the sphere stays. */
/* collide 3.1 */
static bool step(const fxl_scene *scene, fxl_sphere *sphere, const fxl_point *by, fxl_slide *slide)
{
    fxl_sphere moved = *sphere;
    moved.centre.x = clamped((int64_t)sphere->centre.x + by->x);
    moved.centre.y = clamped((int64_t)sphere->centre.y + by->y);
    moved.centre.z = clamped((int64_t)sphere->centre.z + by->z);
    for (uint32_t pass = 0; pass <= PASSES; pass++) {
        const contact nearest = find_contact(scene, &moved);
        if (nearest.instance == FXL_HIT_NONE) {
            if (!is_near(&moved.centre, &sphere->centre, sphere->radius)) {
                return false;
            }
            *sphere = moved;
            return true;
        }
        push(&moved, &nearest);
        slide->contacts += 1; /* at most PASSES + 1 a step */
        slide->instance = nearest.instance;
        slide->face = nearest.face;
    }
    return false;
}

/* Steps of at most half the radius. The square root is rounded, so a step may be 1/2 unit longer.
 */
/* collide 3.3 */
static uint32_t steps_of(const fxl_point *move, fxl_q16_16 radius)
{
    return 2 * fxl_square_root(fxl_square_of(move)) / (uint32_t)radius + 1;
}

/* The part of the move after step `number` of `count`: its coordinate is below 2^30, and count at
 * most 2^10. */
static int32_t part_after(int32_t move, uint32_t number, uint32_t count)
{
    return fxl_divide_down(fxl_multiply_su32(move, number), count);
}

/* collide 3.1 */
fxl_status fxl_slide_sphere(const fxl_scene *scene, fxl_sphere *sphere, const fxl_point *move,
                            fxl_slide *slide)
{
    fxl_slide done = {0, 0, FXL_HIT_NONE, 0};
    if (scene == NULL || sphere == NULL || move == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (scene->draw_list_needed == 0) {
        return FXL_E_ORDER;
    }
    if (scene->placements != NULL) {
        const fxl_status turned = fxl_check_placements(scene);
        if (turned != FXL_OK) {
            return turned;
        }
    }
    if (!fxl_point_in_range(&sphere->centre) || !fxl_point_in_range(move) ||
        sphere->radius < FXL_SLIDE_RADIUS_MIN || sphere->radius > FXL_SLIDE_RADIUS_MAX) {
        return FXL_E_RANGE;
    }
    const uint32_t count = steps_of(move, sphere->radius);
    if (count > FXL_SLIDE_STEPS_MAX) {
        return FXL_E_RANGE;
    }
    for (uint32_t i = 0; i < count; i++) {
        const fxl_point by = {part_after(move->x, i + 1, count) - part_after(move->x, i, count),
                              part_after(move->y, i + 1, count) - part_after(move->y, i, count),
                              part_after(move->z, i + 1, count) - part_after(move->z, i, count)};
        done.blocked += step(scene, sphere, &by, &done) ? 0u : 1u;
    }
    if (slide != NULL) {
        *slide = done;
    }
    return FXL_OK;
}
