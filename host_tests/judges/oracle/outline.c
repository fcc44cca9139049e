/* SPDX-License-Identifier: MIT */
/* outline_clipped, outline_near_parallel: takes a polygon through the default clipper and the
 * projection, and measures the Hausdorff distance to the exact outline. A polygon that is nearly
 * parallel to a plane is a claim of its own: its cut moves by a vertex's rounding divided by the
 * angle.
 *
 * If one of the two outlines is empty because something merely touches the view, the other is
 * measured against a stroke, which covers no pixel: it must be as thin as that. Those samples
 * are counted as "touching" and stay in the claim. */
#include <math.h>
#include <stdlib.h>

#include "oracle/clip.h"
#include "oracle/cover.h"
#include "oracle/polygons.h"
#include "reference/clip.h"
#include "reference/frustum.h"
#include "reference/camera.h"
#include "stages/bridge.h"

enum {
    CUT,
    TOUCHING,
    REFUSED,
    BEYOND,
    TWIN_BEYOND
};

/* The values that are counted as beyond. */
#define BOUND 1.25

/* Of one claim the polygons that are nearly parallel to a plane, of the other all else. */
static void generate(oracle_random *random, oracle_input *input)
{
    do {
        oracle_polygon_generate(random, FXL_SCREEN_MAX, FXL_FACE_VERTICES_MAX, input);
    } while ((input->kind == ORACLE_NEAR_PARALLEL) != input->variant);
}

static void print_spots(FILE *words, const char *whose, const oracle_spot *spots, int count)
{
    fprintf(words, "%s: %d vertices\n", whose, count);
    for (int i = 0; i < count; i++) {
        fprintf(words, "  pixel (%.9Lf, %.9Lf) = units (%.6Lf, %.6Lf)\n",
                (long double)spots[i].x * 0x1p-48L, (long double)spots[i].y * 0x1p-48L,
                (long double)spots[i].x * 0x1p-32L, (long double)spots[i].y * 0x1p-32L);
    }
}

static double distance(const oracle_outline *exact, const oracle_spot *spots, int count)
{
    if (exact->count == 0) {
        return oracle_from_stroke(spots, count);
    }
    if (count == 0) {
        return oracle_from_stroke(exact->spots, exact->count);
    }
    return oracle_hausdorff(exact->spots, exact->count, spots, count);
}

/* Tells whether the outline of the reference renderer, from the same integers and its own
 * planes, is beyond the bound. */
static int twin_is_beyond(const oracle_setup *setup, const fxl_polygon *polygon,
                          const oracle_outline *exact)
{
    ref_camera camera = bridge_camera(&setup->view.camera);
    ref_lens lens = bridge_lens(&setup->view.lens);
    ref_frustum frustum = ref_frustum_from_camera(&camera, &lens);
    ref_polygon whole = bridge_polygon(polygon), clipped = {0};
    ref_clip_result result = ref_clip_world_to_frustum(&whole, &frustum, &clipped);
    if (exact->count == 0 || (result != REF_CLIP_INSIDE && result != REF_CLIP_CUT)) {
        return 0; /* double cannot decide whether an outline merely touches */
    }
    oracle_spot spots[REF_POLYGON_CAPACITY];
    for (int i = 0; i < clipped.count; i++) {
        ref_view_point view = ref_transform_point(&camera, &clipped.vertices[i].position);
        ref_screen_point screen = ref_project_point(&lens, &view);
        spots[i].x = (int64_t)llround(ldexp(screen.x, 48));
        spots[i].y = (int64_t)llround(ldexp(screen.y, 48));
    }
    return oracle_hausdorff(exact->spots, exact->count, spots, clipped.count) > BOUND;
}

static oracle_outcome judge(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    static fxl_screen_polygon screens[2];
    oracle_setup setup;
    fxl_polygon polygon;
    if (!oracle_polygon_read(input, 0, &setup, &polygon)) {
        return ORACLE_UNUSABLE;
    }
    oracle_outline exact;
    const oracle_space space = oracle_clipper_space(&setup.view);
    oracle_clip(&space, &polygon, &exact);

    int given;
    fxl_clip_result result = oracle_clipper_take(&setup.view, &polygon, screens, 2, &given);
    fxl_screen_polygon screen = screens[0];
    if (result == FXL_CLIP_CAPACITY || result == FXL_CLIP_RANGE) {
        verdict->extras[REFUSED] = 1;
        verdict->value = ORACLE_REFUSED;
    }
    if (given == 0) {
        screen.count = 0;
    }
    oracle_spot spots[FXL_POLYGON_CAPACITY];
    for (int i = 0; i < screen.count; i++) {
        spots[i].x = (int64_t)screen.points[i].x * ((int64_t)1 << ORACLE_SPOT_BITS);
        spots[i].y = (int64_t)screen.points[i].y * ((int64_t)1 << ORACLE_SPOT_BITS);
    }
    if (words) {
        print_spots(words, "exact", exact.spots, exact.count);
        print_spots(words, "library", spots, screen.count);
    }
    if (exact.count == 0 && screen.count == 0) {
        return verdict->extras[REFUSED] ? ORACLE_COUNTED : ORACLE_SKIPPED;
    }
    verdict->extras[CUT] = result != FXL_CLIP_INSIDE && result != FXL_CLIP_BETWEEN;
    if (verdict->extras[REFUSED]) {
        return ORACLE_COUNTED;
    }
    verdict->extras[TOUCHING] = exact.count == 0 || screen.count == 0;
    verdict->value = distance(&exact, spots, screen.count);
    verdict->extras[TWIN_BEYOND] = (uint64_t)twin_is_beyond(&setup, &polygon, &exact);
    verdict->extras[BEYOND] = verdict->value > BOUND;
    return ORACLE_COUNTED;
}

#define OUTLINE_CLAIM(name, is_near_parallel) \
    const oracle_claim oracle_outline_##name = { \
        .id = "outline_" #name, \
        .unit = "1/65536 pixel", \
        .numbers = ORACLE_SETUP_TEXT ", count of vertices, x y z of each", \
        .kinds = {ORACLE_POLYGON_KINDS}, \
        .extras = {"cut", "touching", "refused", "beyond_bound", "twin_beyond"}, \
        .variant = is_near_parallel, \
        .generate = generate, \
        .judge = judge, \
    }

OUTLINE_CLAIM(clipped, 0);
OUTLINE_CLAIM(near_parallel, 1);
