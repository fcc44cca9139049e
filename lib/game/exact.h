/* SPDX-License-Identifier: MIT */
/* Exact predicates of points, vectors and planes. Internal. */
#ifndef FXL_EXACT_H
#define FXL_EXACT_H

#include "fixel/records.h"
#include "../math/arith.h"
#include "../scene/placement_code.h"
#include "fixel/collide.h"

/* a . b of vectors, each component below 2^30: below 3 * 2^60. Exact. */
static inline int64_t fxl_dot_vectors(const fxl_point *a, const fxl_point *b)
{
    return fxl_multiply_s32(a->x, b->x) + fxl_multiply_s32(a->y, b->y) +
           fxl_multiply_s32(a->z, b->z);
}

/* The squared length of a vector, each component below 2^30: below 3 * 2^60. Exact. */
static inline uint64_t fxl_square_of(const fxl_point *a)
{
    return (uint64_t)fxl_dot_vectors(a, a);
}

/* -1, 0 or 1: the sign of a . (b x c). Requires components of at most 2^30, those of a of at most
 * 2^30 + 2^7. Exact. */
int fxl_determinant_sign(const fxl_point *a, const fxl_point *b, const fxl_point *c);

/* The vertices of a face of an instance, in the world. */
typedef struct {
    const fxl_point *vertices; /* of the model; or `turned` */
    const uint16_t *indices;   /* of the face; null: the vertices are those of the face in turn */
    fxl_point centre;          /* of the instance; 0 where it is turned */
    uint32_t count;
    fxl_direction normal;
    fxl_point turned[FXL_FACE_VERTICES_MAX]; /* of an instance that is turned: in the world */
} fxl_face_place;

/* collide 2.3 */
static inline void fxl_place_face(fxl_face_place *place, const fxl_scene *scene,
                                  const fxl_instance *instance, uint32_t number)
{
    const fxl_model *model = &scene->models[instance->model];
    const fxl_face *face = &scene->faces[model->first_face + number];
    const uint32_t at = fxl_instance_number(scene, instance);
    const fxl_placement_code *turned = fxl_placement_code_of(scene, at);
    place->count = face->count;
    if (turned != NULL) {
        turned->place_face(scene, at, face, place->turned);
        place->vertices = place->turned;
        place->indices = NULL;
        place->centre.x = place->centre.y = place->centre.z = 0;
        place->normal = turned->normal(scene, at, face);
    } else {
        place->vertices = &scene->vertices[model->first_vertex];
        place->indices = fxl_face_indices(scene->indices, face);
        place->centre = instance->centre;
        place->normal = face->normal;
    }
}

/* Vertex k of the face relative to a point of the world. A vertex of a checked scene is within
 * FXL_COORDINATE_MAX, so each coordinate of the result is below 2^30. */
static inline fxl_point fxl_corner_from(const fxl_face_place *face, uint32_t k,
                                        const fxl_point *from)
{
    const fxl_point *vertex = &face->vertices[face->indices != NULL ? face->indices[k] : k];
    fxl_point corner;
    corner.x = face->centre.x + vertex->x - from->x;
    corner.y = face->centre.y + vertex->y - from->y;
    corner.z = face->centre.z + vertex->z - from->z;
    return corner;
}

/* normal . (point - first vertex): the point's height over the face's plane, exact. */
static inline fxl_q18_46 fxl_height_over(const fxl_face_place *face, const fxl_point *point)
{
    const fxl_point corner = fxl_corner_from(face, 0, point);
    return -fxl_dot(&face->normal, corner.x, corner.y, corner.z);
}

/* Whether the line through `from` along `direction`, which passes from the front of the face to its
 * back, passes within the face; its edges belong to it. Exact. Requires each component of the
 * direction to be at most 2^30 + 2^7: the normal of a turned face may be as long. */
bool fxl_line_is_within(const fxl_face_place *face, const fxl_point *from,
                        const fxl_point *direction);

/* Whether the sphere of the model, turned or not, about an instance's centre meets the segment. */
bool fxl_segment_nears_instance(const fxl_scene *scene, const fxl_instance *instance,
                                const fxl_point *from, const fxl_point *to, fxl_q16_16 margin);

/* --- a bounding box against the frustum ---------------------------------------------------- */

/* A box is tighter than a sphere about a long or flat instance, and costs more. The renderer itself
 * tests spheres. Source: chapter 65 (A9). */

/* Finds the planes that a box may cross. Returns a bit for each such plane (1 << FXL_PLANE_...):
 * 0 where the box lies inside all planes, FXL_SPHERE_OUTSIDE alone where it lies outside one, as
 * fxl_sphere_planes does. The box is outside a plane if all eight corners are more than 2^-9
 * unit outside it. It is inside a plane if all eight corners are at least 2^-9 unit inside it.
 * Otherwise it may cross the plane. The test is exact on the integers of the world's planes. The
 * margin of 2^-9 unit covers the difference between the planes of the world and those of the
 * view, and the rounding of every clipper. The test is therefore conservative. If the result is
 * FXL_SPHERE_OUTSIDE, no clipper draws a face whose vertices all lie in the box. If a plane's
 * bit is not set, every vertex in the box is inside that plane.
 * Requires a frustum made by its function, and corners within FXL_COORDINATE_MAX. Costs at most
 * twelve sums of three 32 x 32 -> 64 bit products. */
uint32_t fxl_box_planes(const fxl_frustum *frustum, const fxl_box *box);

#endif
