/* SPDX-License-Identifier: MIT */
#include "divisions.h"
#include "equality.h"
#include "fill.h"
#include "transform_vertex.h"
#include "products.h"
#include "project.h"
#include "rows.h"
#include "small_stages.h"

#include <stddef.h>

const equality_test equality_tests[] = {
    {"multiply-high", test_high_products},
    {"divide-wide", test_divide_wide},
    {"fraction", test_fraction},
    {"look-at", test_look_at},
    {"project", test_project},
    {"order", test_order},
    {"outlines", test_outlines},
    {"fill", test_fill},
    {"fill-rgb565", test_fill_rgb565},
    {"draw-outline", test_draw_outline},
    {"draw-outline-rgb565", test_draw_outline_rgb565},
    {"row-to-16", test_row_to_16},
    {NULL, NULL},
};
