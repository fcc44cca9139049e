/* SPDX-License-Identifier: MIT */
#include "chain_walks.h"
#include "colour_runs.h"
#include "depth_outlines.h"
#include "depth_planes.h"
#include "depth_rows.h"
#include "edges.h"
#include "equality.h"
#include "estimates.h"
#include "faces.h"
#include "fill.h"
#include "intersect.h"
#include "paint/depth_outline.h"
#include "transform_vertex.h"
#include "divided_rows.h"
#include "divisions.h"
#include "products.h"
#include "project.h"
#include "rows.h"
#include "smooth_planes.h"
#include "texture_rows.h"
#include "placement_rows.h"

#include <stddef.h>

const equality_test equality_tests[] = {
    {"multiply", test_products},
    {"multiply-short", test_short_products},
    {"multiply-wide", test_wide_products},
    {"leading-zeros", test_leading_zeros},
    {"divide", test_divide},
    {"divide-half", test_divide_half},
    {"divide-wide", test_divide_wide},
    {"fraction", test_fraction},
    {"edge-divide", test_edge_divide},
    {"look-at", test_look_at},
    {"project", test_project},
    {"facing", test_facing},
    {"sphere", test_sphere},
    {"front-faces", test_front_faces},
    {"clip-by-view", test_clip_by_view},
    {"intersect", test_intersect},
    {"placement-rows", test_placement_rows},
    {"chains", test_chains},
    {"fill", test_fill},
    {"fill-rgb565", test_fill_rgb565},
    {"draw-outline", test_draw_outline},
    {"draw-outline-rgb565", test_draw_outline_rgb565},
    {"row-to-16", test_row_to_16},
    {"texture-rows", test_texture_rows},
    {"divided-rows", test_divided_rows},
    {"colour-runs", test_colour_runs},
    {"depth-planes", test_depth_planes},
    {"depth-rows", test_depth_rows},
#if FXL_DRAWS_DEPTH_OUTLINES
    {"depth-outlines", test_depth_outlines},
    {"smooth-outlines", test_smooth_outlines},
    {"smooth-planes", test_smooth_planes},
    {"depth-runs", test_depth_runs},
#endif
    {NULL, NULL},
};
