/* SPDX-License-Identifier: MIT */
/* Orientations for instances that turn: from angles, from an axis, from a direction, and products;
 * and an instance that is attached to another. docs/extras/orientation.md. */
#ifndef FXL_ORIENTATION_H
#define FXL_ORIENTATION_H

#include "fixel/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The rows that these functions write are within 1.8 units of 2^-30 of unit length and of right
 * angles. Each function takes the orientations that fxl_placement_check takes. An output may be one
 * of the inputs. Errors are those of an entry, in units of 2^-30, against the exact rotation;
 * docs/accuracy.md, section 3, has the claims that the report checks. */

/* Makes the orientation whose axes are those of a camera with these angles: it rotates a model's z
 * axis to the camera's forward, its y axis to the camera's up and its x axis to the camera's right
 * (fxl_camera_from_pose). Takes any angles. Exact at quarter turns. Error: at most 4.
 * FXL_E_ARGUMENT: a null pointer; nothing is written. */
fxl_status fxl_orientation_from_angles(fxl_angle yaw, fxl_angle pitch, fxl_angle roll,
                                       fxl_orientation *orientation);

/* Makes the rotation by an angle about an axis, from x towards y about +z, from y towards z about
 * +x, from z towards x about +y. Takes any angle. The axis may have any length above 0; each
 * coordinate is below 2^30 in magnitude.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: an axis of length 0, or a coordinate out of range.
 * With each of these statuses: *orientation untouched.
 * Error: at most 4. */
fxl_status fxl_orientation_from_axis(const fxl_point *axis, fxl_angle angle,
                                     fxl_orientation *orientation);

/* A quaternion w + x i + y j + z k by Hamilton's product, i j = k, with w first. It stands for the
 * rotation that takes a vector v to q v q*; cos(t / 2) + sin(t / 2) (x i + y j + z k) turns by t
 * about the axis x, y, z as fxl_orientation_from_axis does. q and -q are one rotation. */
typedef struct {
    int32_t w, x, y, z; /* of any norm above 0: 2.30, 1/16384, ... */
} fxl_quaternion;

/* Makes the rotation of a quaternion of any norm above 0; each number is at most 2^30 in magnitude.
 * q and -q give the same bits.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: all numbers are 0, or one is out of range.
 * With each of these statuses: *orientation untouched.
 * Error: at most 0.5: each entry is the nearest to the exact quotient. */
fxl_status fxl_orientation_from_quaternion(const fxl_quaternion *quaternion,
                                           fxl_orientation *orientation);

/* Writes the quaternion of unit length of an orientation, in units of 2^-30, with w >= 0. Where w
 * is 0, the largest of the others in magnitude, of equals the first, is above 0.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_PLACEMENT: it is no rotation, by the test of fxl_placement_check.
 * With each of these statuses: *quaternion untouched.
 * Error: at most 2 of each number, against that of the rotation nearest to the rows. */
fxl_status fxl_orientation_to_quaternion(const fxl_orientation *orientation,
                                         fxl_quaternion *quaternion);

/* Makes the orientation that rotates a model's z axis to a direction, and its y axis as near to up
 * as a right angle to the direction allows. Both may have any length above 0; each coordinate is
 * below 2^30 in magnitude. The difference of two points of the world is such a direction.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: a vector of length 0, a direction parallel to up, or a coordinate out of range.
 * With each of these statuses: *orientation untouched.
 * Error: at most 4, however near the direction is to up. */
fxl_status fxl_orientation_look_at(const fxl_point *direction, const fxl_point *up,
                                   fxl_orientation *orientation);

/* Makes the rotation that applies b and then a: a point v goes to a . (b . v). The product's rows
 * are brought to unit length and to right angles again, so a chain of products of any length keeps
 * within the range that every function takes.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_PLACEMENT: a or b is no rotation, by the test of fxl_placement_check.
 * With each of these statuses: *product untouched.
 * Error: at most 0.501 from the rotation nearest to the exact product. */
fxl_status fxl_orientation_multiply(const fxl_orientation *a, const fxl_orientation *b,
                                    fxl_orientation *product);

/* Places an instance that is attached to a parent, as a wheel to a car. The centre and the
 * placement of the child are stated in the parent's model space: its centre in units of the
 * parent's model, each coordinate below 2^30 in magnitude. Writes the child's centre and placement
 * in the world: centre      = parent's centre + parent's scale * (parent's orientation . child's
 * centre) orientation = parent's orientation . child's orientation scale       = parent's scale *
 * child's scale A child may be the parent of another. docs/extras/orientation.md states the error
 * by depth. The parent's centre and placement, and those that would be written, must be such as
 * fxl_placement_check takes with a radius of 0, and so must the child's placement.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: a centre or a scale, of an input or of the result, is out of range.
 * FXL_E_PLACEMENT: the orientation of the parent or of the child is no rotation.
 * With each of these statuses: *centre and *placement untouched.
 * Error: of the centre and of the scale half a unit of 1/65536, of the orientation that of
 * fxl_orientation_multiply. */
fxl_status fxl_placement_attach(const fxl_point *parent_centre, const fxl_placement *parent,
                                const fxl_point *child_centre, const fxl_placement *child,
                                fxl_point *centre, fxl_placement *placement);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_orientation_reasons[];

#ifdef __cplusplus
}
#endif

#endif
