/* SPDX-License-Identifier: MIT */
/* Geometry for a game's loop: overlaps of spheres and boxes, the first face that a segment hits,
 * and a sphere that slides along the faces of a scene. docs/extras/collide.md.
 *
 * Points are in the world, in 16.16, each coordinate within FXL_COORDINATE_MAX. A scene is a
 * checked one. */
#ifndef FXL_COLLIDE_H
#define FXL_COLLIDE_H

#include "fixel/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* An axis-aligned box of the world: least <= point <= most in each coordinate. */
typedef struct {
    fxl_point least, most;
} fxl_box;

/* Makes the smallest box that holds all vertices of an instance, in world coordinates. Exact; of an
 * instance that is turned, given its points, each rounded once.
 * Reads every vertex of the model once, so a caller should keep the box of an instance that does
 * not move. Requires an instance of a checked scene. */
void fxl_box_of_instance(const fxl_scene *scene, const fxl_instance *instance, fxl_box *box);

/* A sphere of the world. */
typedef struct {
    fxl_point centre;
    fxl_q16_16 radius; /* 0..FXL_RADIUS_MAX */
} fxl_sphere;

/* Whether two spheres have a point in common; spheres that touch do. Exact.
 * Requires spheres within their ranges. */
bool fxl_spheres_overlap(const fxl_sphere *a, const fxl_sphere *b);

/* Whether two boxes have a point in common; boxes that touch do. Exact. Takes any boxes with
 * least <= most; fxl_box_of_instance makes one of an instance. */
bool fxl_boxes_overlap(const fxl_box *a, const fxl_box *b);

/* Whether a sphere and a box have a point in common. Exact.
 * Requires a sphere within its range, and corners within FXL_COORDINATE_MAX. */
bool fxl_sphere_meets_box(const fxl_sphere *sphere, const fxl_box *box);

/* Whether a sphere and the segment between two points have a point in common. Exact.
 * Requires a sphere within its range, and points within FXL_COORDINATE_MAX. */
bool fxl_sphere_meets_segment(const fxl_sphere *sphere, const fxl_point *start,
                              const fxl_point *end);

/* The number that stands for no instance. */
#define FXL_HIT_NONE 0xFFFFu

/* Where a segment hits the scene. */
typedef struct {
    fxl_point point;    /* of the face, rounded to 16.16 */
    fxl_q1_31 fraction; /* of the segment from its start to the hit, rounded */
    uint16_t instance;  /* number in the scene, or FXL_HIT_NONE: nothing is hit; in a world,
                           fxl_world_handle_at gives its handle */
    uint16_t face;      /* number within the model */
} fxl_hit;

/* Finds the first face that the segment from one point to another passes from its front to its
 * back, or ends on. A face whose back is turned to `start`, or in whose plane `start` lies, is not
 * hit. The edges belong to the face, and whether the segment passes within them is exact: between
 * neighbours that share an edge there is no gap. Of faces at the same fraction, to within 2^-64,
 * the first of the scene is the result. An instance that has a placement is tested by its points
 * and normals in the world, each rounded once. A sphere test, which is exact, skips instances that
 * the segment does not come near. Error: 0.51 units of 2^-31 in `fraction`; 0.75 units of 1/65536
 * in each coordinate of `point`. With no hit, *hit has `end`, a fraction of 1, FXL_HIT_NONE and
 * face 0. All placements are checked in each call.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: the scene was not checked, or has placements without a placement_code.
 * FXL_E_PLACEMENT: the orientation of an instance is no rotation.
 * FXL_E_RANGE: a coordinate of `start` or `end` outside of FXL_COORDINATE_MAX; the scale or the
 * centre of an instance with a placement is out of range.
 * With each of these statuses: *hit untouched. */
fxl_status fxl_cast_segment(const fxl_scene *scene, const fxl_point *start, const fxl_point *end,
                            fxl_hit *hit);

/* Ranges of fxl_slide_sphere, in world units: the radius is 1/64..256. The move is cut into steps
 * of at most half the radius, of which there may be FXL_SLIDE_STEPS_MAX. */
#define FXL_SLIDE_RADIUS_MIN FXL_CAST(fxl_q16_16, 1024)
#define FXL_SLIDE_RADIUS_MAX FXL_CAST(fxl_q16_16, 256 * 65536)
#define FXL_SLIDE_STEPS_MAX  1024

/* What a sphere touched on its way. */
typedef struct {
    uint32_t contacts; /* times that a face pushed the sphere away */
    uint32_t blocked;  /* steps in which it stayed where it was; 0 if it slid all the way */
    uint16_t instance; /* that pushed last, or FXL_HIT_NONE */
    uint16_t face;     /* of that instance's model */
} fxl_slide;

/* Moves a sphere by `move`, so that it slides along the faces that are in its way and never passes
 * through one. Faces stop it from either side. After each step the sphere is pushed off the faces
 * that it reaches into, the nearest to its centre first; if it then still reaches into one, it
 * stays where the step began. If the sphere is free of all faces at the start, it is free after
 * each step, and its centre keeps at least half the radius from every face on the straight way
 * between two steps. A push leaves a gap of 8 to 16 units of 1/65536, and from a turned face of
 * scale s up to 4 s + 132 units more. If the sphere is not free at the start, it may stay there
 * (`blocked`). A coordinate beyond FXL_COORDINATE_MAX is clamped to it. It reads every face of each
 * instance whose sphere it reaches, a few times for each step. The faces of an instance that is
 * turned are those of fxl_cast_segment; all placements are checked in each call. *slide may be
 * null.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: the scene was not checked, or has placements without a placement_code.
 * FXL_E_PLACEMENT: the orientation of an instance is no rotation.
 * FXL_E_RANGE: the centre, or the radius; a component of `move` outside of FXL_COORDINATE_MAX; a
 * move of more than FXL_SLIDE_STEPS_MAX steps; the scale or the place of a turned instance.
 * With each of these statuses: nothing is changed. */
fxl_status fxl_slide_sphere(const fxl_scene *scene, fxl_sphere *sphere, const fxl_point *move,
                            fxl_slide *slide);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_collide_reasons[];

#ifdef __cplusplus
}
#endif

#endif
