/* SPDX-License-Identifier: MIT */
/* From a pose to a point of the screen, in double: angles, the camera, the lens, the transform into
 * the view and the projection. */
#ifndef REF_CAMERA_H
#define REF_CAMERA_H

#include "reference/record.h"

/* Sine and cosine of binary angles, in double. */

/* Sine and cosine of an angle. Exact at the quarter turns, elsewhere good to about the last bit
 * of a double. */
double ref_sin(ref_angle angle);
double ref_cos(ref_angle angle);

/* The camera (SPEC.md, section 1.3), in double. */

typedef struct {
    ref_point position;
    ref_point right, up, forward;
    bool has_no_eye;    /* of an orthographic lens */
    int32_t forward_30[3]; /* then: forward, each component rounded to 2.30 */
} ref_camera;

/* Makes the camera: R . P . Y, computed as three turns one after the other. */
ref_camera ref_camera_from_pose(const ref_pose *pose);

/* The same camera with an orthographic lens (docs/extras/orthographic.md). */
void ref_camera_take_eye(ref_camera *camera);

/* Returns the direction in which a player looks: the image of (0, 0, 1) under the turns. */
ref_point ref_forward(ref_angle yaw, ref_angle pitch);

ref_point ref_point_from_lattice(const ref_lattice_point *point);

/* The lens (SPEC.md, section 4.2), in double. */

typedef struct {
    int width, height;           /* pixels */
    double focal;                /* pixels */
    double near_z, far_z, inset; /* world units */
    double centre_x, centre_y;   /* pixels: where the screen is straight ahead */
    double scale;                /* pixels a world unit, of an orthographic lens; else 0 */
} ref_lens;

/* Makes a lens. focal = (width / 2) / tan(fov / 2), rounded to the nearest 1/65536; the
 * specification defines that rounding. near_z, far_z and inset are in world units. The centre is
 * the middle of the screen. */
ref_lens ref_lens_from_fov(int width, int height, ref_angle fov, double near_z, double far_z,
                           double inset);

/* The transform from the world into the view (SPEC.md, section 4.6). */

/* Summed in 64 bits: exact where matrix and point are the library's integers. */
ref_view_point ref_transform_point(const ref_camera *camera, const ref_point *point);
void ref_transform_polygon(const ref_camera *camera, const ref_polygon *polygon,
                           ref_view_polygon *view);

/* The projection from the view onto the screen (SPEC.md, section 4.8), in double. */

/* Requires view->z > 0, or an orthographic lens. */
ref_screen_point ref_project_point(const ref_lens *lens, const ref_view_point *view);

/* A point in the view of those that are seen at a point of the screen; the others are its
 * multiples. With an orthographic lens: of a view whose depths are all 1. */
ref_view_point ref_ray_through(const ref_lens *lens, const ref_screen_point *screen);
void ref_project_polygon(const ref_lens *lens, const ref_view_polygon *view,
                         ref_screen_polygon *screen);

/* --- a player ----------------------------------------------------------------------------------- */

/* The movement of a player (docs/extras/player.md), in double. */

enum {
    REF_KEY_FORWARD = 1,
    REF_KEY_BACK = 2,
    REF_KEY_LEFT = 4,
    REF_KEY_RIGHT = 8,
    REF_KEY_PITCH_UP = 16,
    REF_KEY_PITCH_DOWN = 32,
    REF_KEY_ROLL_LEFT = 64,
    REF_KEY_ROLL_RIGHT = 128
};

/* Limits per step: world units, and an angle. */
typedef struct {
    double acceleration, friction, speed_max;
    ref_angle turn;
} ref_motion_limits;

/* A player. The position is never rounded: the judge compares the library's positions with it. */
typedef struct {
    ref_point position;
    ref_angle yaw, pitch, roll;
    double speed;
    uint32_t clamped; /* steps in which the position was clamped to the range */
} ref_player;

ref_player ref_player_at(const ref_pose *pose);
void ref_player_step(ref_player *player, uint32_t keys, const ref_motion_limits *limits);

#endif
