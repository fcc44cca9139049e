/* SPDX-License-Identifier: MIT */
/* A lens and a camera: as numbers of an input, as records of the library, and random ones from
 * the ends of their ranges to their middles. */
#ifndef ORACLE_SETUP_H
#define ORACLE_SETUP_H

#include "draw/stages.h"
#include "fixel/all.h"
#include "oracle/claim.h"

__extension__ typedef __int128 oracle_wide;

enum {
    ORACLE_SETUP_NUMBERS = 14
};

#define ORACLE_SETUP_TEXT "width height fov near far inset, eye x y z yaw pitch roll, centre x y"

/* The lens, the matrix and the frustum are the library's own. The exact side takes them as
 * given. The lens of the view is the one that it is drawn with: centred. */
typedef struct {
    fxl_pose pose;
    fxl_view view; /* the frustum in the world is not set */
} oracle_setup;

/* Reads the first ORACLE_SETUP_NUMBERS numbers of the input. Returns 0 where the library refuses
 * them. */
int oracle_setup_read(const oracle_input *input, oracle_setup *setup);

/* The lens as it was set; the view has the one that it is drawn with. Requires numbers that
 * oracle_setup_read takes. Returns 0 where the library refuses them. */
int oracle_setup_lens(const oracle_input *input, fxl_lens *lens);

/* Whether the third number is below 0: it is then less the scale of an orthographic lens, and no field
 * of view. */
int oracle_setup_is_orthographic(const oracle_input *input);

/* Appends random numbers for a setup. The sides of the screen are at most side_max. */
void oracle_setup_generate(oracle_random *random, int side_max, oracle_input *input);

/* The same with an orthographic lens, a third of them off-centre. */
void oracle_setup_generate_orthographic(oracle_random *random, int side_max, oracle_input *input);

/* Converts a vector of the view to one of the world, in double: for making samples. Where the lens
 * is off-centre, the view is sheared so that the middle of the screen is straight ahead; its x and
 * y are as long as those of the unsheared view. With an orthographic lens they count from the middle of the
 * screen. */
void oracle_to_world(const oracle_input *input, const double view[3], double world[3]);

/* Appends the point of the world that a point of the view is. Returns whether it is in range. */
int oracle_put_point(oracle_input *input, const double view[3]);

/* Computes the exact coordinates of a point in the view, in units of 2^-46. */
typedef struct {
    int64_t x, y, z;
} oracle_view_point;

oracle_view_point oracle_transform(const fxl_camera *camera, const int64_t point[3]);

/* Computes the exact distance from a plane of the frustum, times 2^76. */
oracle_wide oracle_distance(const fxl_view_frustum *frustum, int plane,
                            const oracle_view_point *point);

#endif
