/* SPDX-License-Identifier: MIT */
/* Single stages, fed with any record that their contracts allow, and with
 * some that they must refuse. */
#ifndef STAGES_H
#define STAGES_H

#include "input.h"

void fuzz_project(fuzz_input *in);
void fuzz_scan(fuzz_input *in);
void fuzz_clip_world(fuzz_input *in);
void fuzz_clip_view(fuzz_input *in);
void fuzz_viewer(fuzz_input *in);
void fuzz_lenses(fuzz_input *in);
void fuzz_misuse(fuzz_input *in);
void fuzz_sort(fuzz_input *in);
void fuzz_beams(fuzz_input *in);
void fuzz_split(fuzz_input *in);
void fuzz_volumes(fuzz_input *in);
void fuzz_normalised(fuzz_input *in);
void fuzz_first_program(fuzz_input *in);
void fuzz_planes(fuzz_input *in);
void fuzz_orientations(fuzz_input *in);
void fuzz_overlay(fuzz_input *in);
void fuzz_geometry(fuzz_input *in);
void fuzz_world(fuzz_input *in);
void fuzz_surfaces(fuzz_input *in);

/* What the library says of refused calls with a scene of no objects, whatever the input. */
void fuzz_explained(const fxl_scene *scene);

/* Lights a renderer, or not: settings of any kind. */
void fuzz_set_light(fxl_renderer *renderer, fxl_light *light, fuzz_input *in);

/* Shows frames of a renderer whose screen is 24 x 16, and feeds formats, pump and drivers with what
 * they must refuse. */
void fuzz_show(fuzz_input *in, fxl_renderer *renderer, const fxl_pose *eye);

#endif
