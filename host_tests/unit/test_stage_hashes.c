/* SPDX-License-Identifier: MIT */
/* What stages hand on inside the library is the same, bit for bit, on every core: hashes on record,
 * as in test_surface_hashes.c. */
#include "../../lib/draw/surface_polygon.h"
#include "../../lib/paint/gradients.h"
#include "../../lib/paint/lit_pieces.h"
#include "clip_unit.h"
#include "polygon_face.h"
#include "study/clippers.h"

enum {
    ROUNDS = 1000, /* of each kind */
    CORNERS = 200,
    PIECES = 40
};

static uint32_t hash;
static fxl_view view;
static fxl_gradient_corners face;
static fxl_gradients gradients;
static fxl_point corners[CORNERS];
static uint16_t nexts[CORNERS];
static fxl_lit_piece table[PIECES];

void setUp(void)
{
    hash = 0;
}

static void mix(int64_t value)
{
    hash = unit_mix(hash, value);
}

static void mix_gradient(const fxl_gradient *gradient)
{
    mix(gradient->at);
    mix(gradient->along);
    mix(gradient->down);
}

static void mix_gradients(void)
{
    fxl_gradients_find(&face, &view, &gradients);
    mix_gradient(&gradients.weight);
    for (uint32_t i = 0; i < gradients.count; i++) {
        mix_gradient(&gradients.attributes[i]);
        mix(gradients.shifts[i]);
    }
    mix(gradients.count);
    mix(gradients.volume.number);
    mix(gradients.volume.exponent);
    mix(gradients.weight_min[0]);
    mix(gradients.weight_min[1]);
}

static void make_view(void)
{
    const int32_t width = unit_between(1, FXL_SCREEN_MAX);
    view = clip_random_view((uint16_t)width, (uint16_t)unit_between(1, FXL_SCREEN_MAX));
}

/* The same, whose lens is off its centre. */
static void make_view_off_centre(void)
{
    const fxl_pose pose = unit_pose();
    fxl_lens lens;
    make_view();
    lens = view.lens;
    lens.inset = 0;
    const fxl_q16_16 x = lens.width * 32768 + unit_between(-lens.focal, lens.focal);
    const int32_t high = lens.height * 32768, reach = high < lens.focal ? high : lens.focal;
    const fxl_q16_16 y = high + unit_between(-reach, reach);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_set_centre(&lens, x, y));
    fxl_view_set_lens(&view, &lens);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
}

/* Three points of so many bits, of which the shorter ones are before the eye. */
static void make_face(unsigned bits)
{
    face.count = (uint32_t)unit_between(1, FXL_ATTRIBUTES);
    for (int i = 0; i < 3; i++) {
        fxl_view_point *corner = &face.corners[i];
        corner->x = unit_wide(bits);
        corner->y = unit_wide(bits);
        corner->z = unit_wide(bits);
        corner->z = bits < 56 && corner->z < 0 ? -corner->z : corner->z;
    }
    for (int i = 0; i < FXL_ATTRIBUTES * 3; i++) {
        face.values[i / 3][i % 3] = (int32_t)unit_wide((unsigned)unit_between(2, 30));
    }
}

static void gradients_of_any_corners(uint32_t number)
{
    make_face(40 + number % 21);
    mix_gradients();
}

/* On the screen, or a little beside it. */
static void gradients_of_affine_corners(uint32_t number)
{
    make_face(40);
    for (int i = 0; i < 3; i++) {
        const fxl_q18_46 z = (fxl_q18_46)unit_between(Q16(0.5), Q16(90)) * (1 << 30);
        const int32_t half[2] = {view.lens.width * 32768, view.lens.height * 32768};
        fxl_q18_46 at[2];
        for (int k = 0; k < 2; k++) {
            const int32_t reach = half[k] + (number % 4 == 0 ? half[k] / 8 : 0);
            at[k] = (z >> 30) * unit_between(-reach, reach) / view.lens.focal * (1 << 30);
        }
        face.corners[i] = (fxl_view_point){at[0], at[1], z};
    }
    fxl_corners_make_affine(&face, &view);
    for (int i = 0; i < 3; i++) {
        mix(face.corners[i].x);
        mix(face.corners[i].y);
        mix(face.corners[i].z);
    }
    mix_gradients();
}

/* Of a polygon anywhere, whose normal is any. */
static void depth_of_a_face(uint32_t number)
{
    static polygon_face polygon;
    fxl_depth_plane plane;
    const fxl_traversal on = {.clipper = number % 2 ? &fxl_clipper_view : &fxl_clipper_once};
    const fxl_polygon outline = clip_random_face(&view);
    polygon_face_set(&polygon, &outline, &view, 8);
    polygon.face.normal = unit_direction();
    fxl_find_depth_by_normal(&polygon.model_view, &polygon.face, &on, &plane);
    mix_gradient(&plane.gradient);
    mix(plane.one);
}

/* A face through which two windows throw light, mostly along whole numbers. */
static void pieces_of_a_face(uint32_t number)
{
    fxl_lit_pieces pieces = {corners, nexts, table, CORNERS, PIECES, 0, 0};
    const int32_t grid = number % 2 ? 65536 : 46341;
    fxl_beam beams[2];
    fxl_point window[3], outline[FXL_POLYGON_CAPACITY], points[4];
    uint32_t count = 0;
    for (uint32_t b = 0; b < 2; b++) {
        for (int k = 0; k < 3; k++) {
            window[k].x = unit_between(-4, 4) * grid;
            window[k].y = unit_between(-4, 4) * grid;
            window[k].z = 3 * grid;
        }
        fxl_point light = {0, 0, 8 * grid};
        light.x = unit_between(-6, 6) * grid;
        light.y = unit_between(-6, 6) * grid;
        count += fxl_beam_from_point(&light, window, 3, &beams[count]) == FXL_OK;
    }
    const fxl_q16_16 low = -unit_between(1, 9) * grid, high = unit_between(1, 9) * grid;
    for (uint32_t k = 0; k < 4; k++) { /* clockwise, seen from above */
        points[k] = (fxl_point){k == 1 || k == 2 ? high : low, k == 0 || k == 1 ? high : low, 0};
    }
    const fxl_direction normal = {0, 0, FXL_Q2_30_ONE};
    mix(fxl_lit_split(&pieces, beams, count, &normal, points, 4));
    for (uint32_t i = 0; i < pieces.piece_count; i++) {
        mix(pieces.pieces[i].is_lit);
        mix(fxl_lit_outline(&pieces, &pieces.pieces[i], outline));
        for (uint32_t k = 0; k < pieces.pieces[i].count; k++) {
            mix(outline[k].x);
            mix(outline[k].y);
            mix(outline[k].z);
        }
    }
}

void test_records_are_those_on_record(void)
{
    static const struct {
        void (*make_view)(void);
        void (*mix)(uint32_t number);
        uint32_t hash;
    } record[] = {
        {make_view, gradients_of_any_corners, 0x9BDE0036},
        {make_view, gradients_of_affine_corners, 0x95841FF6},
        {make_view, depth_of_a_face, 0x47BF7782},
        {make_view, pieces_of_a_face, 0x433FEFC4},
        {make_view_off_centre, gradients_of_any_corners, 0xAEF037C4},
        {make_view_off_centre, depth_of_a_face, 0x982677BA},
    };
    uint32_t wrong = 0;
    for (uint32_t i = 0; i < sizeof record / sizeof record[0]; i++) {
        hash = 0;
        for (uint32_t k = 0; k < ROUNDS; k++) {
            record[i].make_view();
            record[i].mix(k);
        }
        wrong += unit_tell_hash(i, hash, record[i].hash);
    }
    TEST_ASSERT_EQUAL_UINT32(0, wrong);
}
