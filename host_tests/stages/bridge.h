/* SPDX-License-Identifier: MIT */
/* The library's records as the twin's: exact in every case, so that both sides
 * of a stage get the same input. */
#ifndef STAGES_BRIDGE_H
#define STAGES_BRIDGE_H

#include "fixel.h"
#include "reference/camera.h"
#include "reference/lens.h"
#include "reference/record.h"

ref_point bridge_point(const fxl_point *point);
ref_plane bridge_plane(const fxl_plane *plane);
ref_camera bridge_camera(const fxl_camera *camera);
ref_lens bridge_lens(const fxl_lens *lens);
ref_polygon bridge_polygon(const fxl_polygon *polygon);
ref_point bridge_view_point(const fxl_view_point *point);
ref_screen_polygon bridge_screen_polygon(const fxl_screen_polygon *polygon);

#endif
