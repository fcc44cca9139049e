/* SPDX-License-Identifier: MIT */
/* Neighbours meet by every clipper of the family. */
#include "watertight.h"

static void expect_through(const fxl_clipper *clipper, int few)
{
    static fxl_clipper_workspace workspace;
    static fxl_screen_polygon screens[WATERTIGHT_PIECES];
    memset(&workspace, 0, sizeof workspace);
    watertight_expect_through(clipper, &workspace, few, screens, WATERTIGHT_PIECES);
}

void test_through_the_normalised_frustum(void)
{
    expect_through(&fxl_clipper_normalised, UNIT_REPEAT / 4);
}

void test_through_all_planes_at_once(void)
{
    expect_through(&fxl_clipper_once, UNIT_REPEAT / 4);
}

/* place clipper: a test of each clipper */
void test_through_half_spaces(void)
{
    expect_through(&fxl_clipper_half_spaces, UNIT_REPEAT / 4);
}

/* clippers 3.2e-f, 7.2 */
void test_in_triangles(void)
{
    expect_through(&fxl_clipper_triangles, UNIT_REPEAT / 4);
}

void test_before_the_scan_cuts_what_near_leaves(void)
{
    expect_through(&fxl_clipper_near, UNIT_REPEAT / 20);
}

void test_before_the_scan_cuts_what_left_leaves(void)
{
    expect_through(&fxl_clipper_left, UNIT_REPEAT / 4);
}
