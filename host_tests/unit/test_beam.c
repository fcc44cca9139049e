/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "unit.h"

/* A window of a metre by two in the plane x = -4, seen from outside. */
static const fxl_point window[] = {{Q16(-4), Q16(1), Q16(0)},
                                   {Q16(-4), Q16(3), Q16(0)},
                                   {Q16(-4), Q16(3), Q16(1)},
                                   {Q16(-4), Q16(1), Q16(1)}};
static const fxl_point lamp = {Q16(-9), Q16(6), Q16(0.5)};

static double length_of(const double *v)
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static bool holds(const fxl_beam *beam, fxl_point point)
{
    for (uint32_t i = 0; i < beam->plane_count; i++) {
        fxl_plane plane = fxl_beam_plane_at(beam, i);
        if (fxl_plane_distance(&plane, &point) < 0) {
            return false;
        }
    }
    return true;
}

/* beams 1.3a */
void test_a_window_has_a_plane_for_each_side_and_its_own(void)
{
    fxl_beam beam;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, window, 4, &beam));
    TEST_ASSERT_EQUAL(5, beam.plane_count);
    TEST_ASSERT_EQUAL(FXL_BEAM_POINT, beam.kind);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_check(&beam));
}

/* beams 1.2b */
void test_what_the_light_reaches_through_the_window_is_inside(void)
{
    fxl_beam beam;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, window, 4, &beam));
    /* Past the window's middle (-4, 2, 0.5), in as many steps as one likes. */
    TEST_ASSERT_TRUE(holds(&beam, (fxl_point){Q16(1), Q16(-2), Q16(0.5)}));
    TEST_ASSERT_FALSE(holds(&beam, (fxl_point){Q16(1), Q16(-2), Q16(2.5)}));
    TEST_ASSERT_FALSE(holds(&beam, (fxl_point){Q16(1), Q16(2), Q16(0.5)}));
    /* Before the window, and behind the lamp, where the planes cross over. */
    TEST_ASSERT_FALSE(holds(&beam, (fxl_point){Q16(-6.5), Q16(4), Q16(0.5)}));
    TEST_ASSERT_FALSE(holds(&beam, (fxl_point){Q16(-14), Q16(10), Q16(0.5)}));
}

/* A direction is of unit length with all of its components, and not with two of them. */
void test_the_length_of_a_direction(void)
{
    fxl_beam beam;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, window, 4, &beam));
    beam.kind = FXL_BEAM_DIRECTION;
    for (int axis = 0; axis < 3; axis++) {
        beam.from[axis] = Q30(0.36);
        beam.from[(axis + 1) % 3] = Q30(-0.48);
        beam.from[(axis + 2) % 3] = Q30(0.8);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_check(&beam));
        for (int k = 0; k < 3; k++) {
            const int32_t was = beam.from[k];
            beam.from[k] = 0;
            TEST_ASSERT_EQUAL(FXL_E_NORMAL, fxl_beam_check(&beam));
            beam.from[k] = was;
        }
    }
}

/* A sphere that touches the beam may lie in it; one that is 2^-13 unit away does not. */
/* beams 2.2 */
void test_a_sphere_beside_a_beam(void)
{
    const fxl_beam beam = {.kind = FXL_BEAM_DIRECTION,
                           .plane_count = 1,
                           .from = {0, -FXL_Q2_30_ONE, 0},
                           .planes = {{.normal = {FXL_Q2_30_ONE, 0, 0}}}}; /* x >= 0 */
    for (fxl_q16_16 radius = 0; radius <= FXL_RADIUS_MAX / 4; radius += FXL_RADIUS_MAX / 40) {
        const fxl_point touching = {-radius, Q16(3), Q16(-5)}, away = {-radius - 8, 0, 0};
        TEST_ASSERT_TRUE(fxl_beam_reaches(&beam, &touching, radius));
        TEST_ASSERT_FALSE(fxl_beam_reaches(&beam, &away, radius));
    }
}

/* A sphere that lies behind any one of a beam's planes is not reached. */
/* beams 1.2b */
void test_every_plane_of_a_beam_limits_it(void)
{
    fxl_beam beam = {.kind = FXL_BEAM_DIRECTION, .from = {0, -FXL_Q2_30_ONE, 0}};
    for (uint32_t count = 1; count <= FXL_BEAM_PLANES_MAX; count++) {
        beam.plane_count = (uint8_t)count;
        for (uint32_t behind = 0; behind <= count; behind++) {
            for (uint32_t i = 0; i < count; i++) {
                const fxl_q2_30 x = i == behind ? -FXL_Q2_30_ONE : FXL_Q2_30_ONE;
                beam.planes[i] = (fxl_beam_plane){.normal = {x, 0, 0}};
            }
            const fxl_point centre = {Q16(2), 0, 0};
            TEST_ASSERT_EQUAL(behind == count, fxl_beam_reaches(&beam, &centre, Q16(1)));
        }
    }
}

/* Light that travels along an axis shines on faces that are turned the other way. */
/* beams 1.4a */
void test_what_the_sun_shines_on(void)
{
    for (int travel = 0; travel < 6; travel++) {
        fxl_beam sun = {.kind = FXL_BEAM_DIRECTION};
        sun.from[travel / 2] = travel % 2 ? FXL_Q2_30_ONE : -FXL_Q2_30_ONE;
        for (int turned = 0; turned < 6; turned++) {
            const fxl_q2_30 to = turned % 2 ? FXL_Q2_30_ONE : -FXL_Q2_30_ONE;
            const fxl_direction normal = {turned / 2 == 0 ? to : 0, turned / 2 == 1 ? to : 0,
                                          turned / 2 == 2 ? to : 0};
            const fxl_point vertex = {Q16(1), Q16(2), Q16(3)};
            TEST_ASSERT_EQUAL(turned == (travel ^ 1), fxl_beam_shines_on(&sun, &vertex, &normal));
        }
    }
}

/* The least that a lamp may be before a face is one unit of 2^-46. */
void test_a_face_that_is_barely_turned_to_a_lamp(void)
{
    const fxl_beam beam = {.kind = FXL_BEAM_POINT, .from = {1, 0, 0}};
    const fxl_direction least = {1, 0, 0};
    for (int32_t x = -1; x <= 2; x++) {
        const fxl_point vertex = {x, 0, 0};
        TEST_ASSERT_EQUAL(x < 1, fxl_beam_shines_on(&beam, &vertex, &least));
    }
}

/* A face is turned to a lamp that is before its plane: along each axis, to a unit. */
/* beams 1.4a */
void test_what_a_lamp_shines_on(void)
{
    const fxl_beam beam = {.kind = FXL_BEAM_POINT, .from = {Q16(3), Q16(-5), Q16(7)}};
    for (int axis = 0; axis < 3; axis++) {
        for (int sign = -1; sign <= 1; sign += 2) {
            fxl_q2_30 normal[3] = {0, 0, 0};
            normal[axis] = sign > 0 ? FXL_Q2_30_ONE : -FXL_Q2_30_ONE;
            const fxl_direction along = {normal[0], normal[1], normal[2]};
            for (int unit = -1; unit <= 1; unit++) {
                int32_t at[3] = {Q16(100), Q16(200), Q16(-300)};
                at[axis] = beam.from[axis] - sign * unit;
                const fxl_point vertex = {at[0], at[1], at[2]};
                TEST_ASSERT_EQUAL(unit > 0, fxl_beam_shines_on(&beam, &vertex, &along));
            }
        }
    }
}

/* The least that a face may be turned to the light is one unit of 2^-46. */
/* beams 1.4b */
void test_a_face_that_is_barely_turned_to_the_light(void)
{
    const fxl_direction normal = {FXL_Q2_30_ONE, 1,
                                  0}; /* of unit length, as far as that is asked */
    const fxl_point vertex = {0, 0, 0};
    for (int unit = -1; unit <= 1; unit++) {
        const fxl_beam lamp_beside = {.kind = FXL_BEAM_POINT, .from = {0, unit, 0}};
        const fxl_beam sun = {.kind = FXL_BEAM_DIRECTION, .from = {0, -unit, FXL_Q2_30_ONE}};
        TEST_ASSERT_EQUAL(unit > 0, fxl_beam_shines_on(&lamp_beside, &vertex, &normal));
        TEST_ASSERT_EQUAL(unit > 0, fxl_beam_shines_on(&sun, &vertex, &normal));
    }
}

/* The margin is 4 units of 2^-16, for normals that are a little too long. */
/* beams 2.2 */
void test_the_margin_of_a_sphere_beside_a_beam(void)
{
    for (int sign = -1; sign <= 1; sign += 2) {
        /* No product: as one that grows by 2^31 a round, GCC 12 by -Os takes it for one round. */
        const fxl_q2_30 along = sign < 0 ? -FXL_Q2_30_ONE : FXL_Q2_30_ONE;
        const fxl_beam beam = {.kind = FXL_BEAM_DIRECTION,
                               .plane_count = 1,
                               .from = {0, -FXL_Q2_30_ONE, 0},
                               .planes = {{.normal = {along, 0, 0}}}};
        const fxl_point near = {-sign * (Q16(2) + 4), 0, 0}, far = {-sign * (Q16(2) + 5), 0, 0};
        TEST_ASSERT_TRUE(fxl_beam_reaches(&beam, &near, Q16(2)));
        TEST_ASSERT_FALSE(fxl_beam_reaches(&beam, &far, Q16(2)));
    }
}

/* beams 1.3a-b */
void test_a_direction_makes_a_shaft(void)
{
    const fxl_direction down = {Q30(0.6), Q30(-0.8), 0};
    fxl_beam beam;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_direction(&down, window, 4, &beam));
    TEST_ASSERT_EQUAL(FXL_BEAM_DIRECTION, beam.kind);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_check(&beam));
    TEST_ASSERT_TRUE(holds(&beam, (fxl_point){Q16(-1), Q16(-2), Q16(0.5)}));
    TEST_ASSERT_FALSE(holds(&beam, (fxl_point){Q16(-7), Q16(6), Q16(0.5)}));
    TEST_ASSERT_FALSE(holds(&beam, (fxl_point){Q16(-1), Q16(-2), Q16(1.5)}));
}

/* The way round of a window does not matter. */
/* beams 1.3a */
void test_a_window_may_be_wound_either_way(void)
{
    fxl_point turned[4];
    fxl_beam one, other;
    for (int i = 0; i < 4; i++) {
        turned[i] = window[3 - i];
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, window, 4, &one));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, turned, 4, &other));
    for (int i = 0; i < 1000; i++) {
        fxl_point point = unit_point(Q16(12));
        TEST_ASSERT_EQUAL(holds(&one, point), holds(&other, point));
    }
}

/* A plane against the same from the exact cross product, in double. */
/* beams 1.2a */
void test_normals_are_right_to_two_units(void)
{
    int made = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        static const fxl_q16_16 limits[] = {FXL_COORDINATE_MAX, Q16(10), 200, 20};
        fxl_q16_16 limit =
            limits[i % 4]; /* the last two: a few units, whose normals are made longer */
        fxl_point light = unit_point(limit), corners[3];
        fxl_beam beam;
        for (int k = 0; k < 3; k++) {
            corners[k] = unit_point(limit);
        }
        if (fxl_beam_from_point(&light, corners, 3, &beam) != FXL_OK) {
            continue;
        }
        for (uint32_t k = 0; k < 3; k++) {
            const fxl_point *a = &corners[k], *b = &corners[(k + 1) % 3];
            double p[3] = {(double)a->x - light.x, (double)a->y - light.y, (double)a->z - light.z};
            double q[3] = {(double)b->x - a->x, (double)b->y - a->y, (double)b->z - a->z};
            double n[3] = {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
                           p[0] * q[1] - p[1] * q[0]};
            double scale = FXL_Q2_30_ONE / length_of(n);
            fxl_plane plane = fxl_beam_plane_at(&beam, k);
            double sign = n[0] * plane.normal.x + n[1] * plane.normal.y + n[2] * plane.normal.z;
            scale = sign < 0 ? -scale : scale;
            /* The double's own error is far below a unit unless the vectors are nearly
             * parallel. */
            if (length_of(n) > 1e-4 * length_of(p) * length_of(q)) {
                TEST_ASSERT_NEAR(plane.normal.x, n[0] * scale, 2);
                TEST_ASSERT_NEAR(plane.normal.y, n[1] * scale, 2);
                TEST_ASSERT_NEAR(plane.normal.z, n[2] * scale, 2);
                made++;
            }
            TEST_ASSERT_EQUAL_INT64(0, fxl_plane_distance(&plane, a));
        }
        const fxl_plane own = fxl_beam_plane_at(&beam, 3); /* the window's */
        TEST_ASSERT_EQUAL_INT64(0, fxl_plane_distance(&own, &corners[0]));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_check(&beam));
    }
    TEST_ASSERT_TRUE(made > UNIT_REPEAT);
}

static void expect_refused(fxl_status status, const fxl_point *light, const fxl_point *corners,
                           uint32_t count)
{
    fxl_beam beam, before;
    memset(&beam, 0x5A, sizeof beam);
    memcpy(&before, &beam, sizeof before);
    TEST_ASSERT_EQUAL(status, fxl_beam_from_point(light, corners, count, &beam));
    TEST_ASSERT_EQUAL_MEMORY(&before, &beam, sizeof before);
}

/* beams 1.3b */
void test_what_makes_no_beam_is_refused(void)
{
    static const fxl_point off = {Q16(8192), 0, 0};
    static const fxl_point flat_light = {Q16(-4), Q16(9), Q16(9)};
    static const fxl_point line[] = {{0, 0, 0}, {Q16(1), 0, 0}, {Q16(2), 0, 0}};
    static const fxl_point star[] = {
        {0, 0, 0}, {Q16(2), Q16(2), 0}, {Q16(2), 0, 0}, {0, Q16(2), 0}};
    expect_refused(FXL_E_ARGUMENT, NULL, window, 4);
    expect_refused(FXL_E_ARGUMENT, &lamp, NULL, 4);
    expect_refused(FXL_E_COUNT, &lamp, window, 2);
    expect_refused(FXL_E_COUNT, &lamp, window, FXL_BEAM_PLANES_MAX);
    expect_refused(FXL_E_RANGE, &off, window, 4);
    expect_refused(FXL_E_RANGE, &lamp, &off, 3);
    for (int i = 0; i < 4; i++) { /* any corner */
        fxl_point corners[4];
        memcpy(corners, window, sizeof corners);
        corners[i].y = FXL_COORDINATE_MAX + 1;
        expect_refused(FXL_E_RANGE, &lamp, corners, 4);
    }
    expect_refused(FXL_E_DEGENERATE, &flat_light, window, 4);
    expect_refused(FXL_E_DEGENERATE, &lamp, line, 3);
    expect_refused(FXL_E_DEGENERATE, &lamp, star, 4);
    expect_refused(FXL_E_DEGENERATE, &window[0], window, 4);
    for (int i = 0; i < 8; i++) { /* the largest numbers, whose squares must not wrap */
        const fxl_direction huge = {i & 1 ? INT32_MIN : 0, i & 2 ? INT32_MIN : 0,
                                    i & 4 ? INT32_MIN : 0};
        fxl_beam none;
        TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_beam_from_direction(&huge, window, 4, &none));
    }
    const fxl_direction crooked = {Q30(0.6), Q30(-0.7), 0};
    fxl_beam beam;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_beam_from_direction(&crooked, window, 4, &beam));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_beam_from_direction(NULL, window, 4, &beam));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_beam_from_point(&lamp, window, 4, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_beam_check(NULL));
}

/* beams 1.1d */
void test_a_beam_of_a_table_is_checked(void)
{
    fxl_beam good, beam;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, window, 4, &good));
    beam = good;
    beam.kind = 2;
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_beam_check(&beam));
    beam = good;
    beam.reserved = 1;
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_beam_check(&beam));
    beam = good;
    beam.planes[5].distance_high = 1;
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_beam_check(&beam));
    beam = good;
    beam.plane_count = 0;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_beam_check(&beam));
    beam.plane_count = FXL_BEAM_PLANES_MAX + 1;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_beam_check(&beam));
    beam = good;
    for (int i = 0; i < 3; i++) {
        beam.from[i] = FXL_COORDINATE_MAX + 1;
        TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_beam_check(&beam));
        beam.from[i] = -FXL_COORDINATE_MAX - 1;
        TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_beam_check(&beam));
        beam = good;
    }
    beam.kind = FXL_BEAM_DIRECTION;
    TEST_ASSERT_EQUAL(FXL_E_NORMAL, fxl_beam_check(&beam));
    beam = good;
    beam.planes[2].normal.y += 64;
    beam.planes[2].normal.x -= 64;
    TEST_ASSERT_EQUAL(FXL_E_NORMAL, fxl_beam_check(&beam));
    beam = good;
    beam.planes[0].distance_high = 0x20000000u;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_beam_check(&beam));
}

void test_light_falls_on_what_is_turned_to_it(void)
{
    const fxl_direction up = {0, FXL_Q2_30_ONE, 0}, under = {0, -FXL_Q2_30_ONE, 0};
    const fxl_direction travel = {0, -FXL_Q2_30_ONE, 0};
    fxl_point floor = {0, 0, 0}, level = {0, lamp.y, 0};
    fxl_beam beam;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, window, 4, &beam));
    TEST_ASSERT_TRUE(fxl_beam_shines_on(&beam, &floor, &up));
    TEST_ASSERT_FALSE(fxl_beam_shines_on(&beam, &floor, &under));
    TEST_ASSERT_FALSE(fxl_beam_shines_on(&beam, &level, &up)); /* it glances off */
    level.y -= 1;
    TEST_ASSERT_TRUE(fxl_beam_shines_on(&beam, &level, &up));
    const fxl_point roof[] = {{0, 0, 0}, {Q16(1), 0, 0}, {0, 0, Q16(1)}};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_direction(&travel, roof, 3, &beam));
    TEST_ASSERT_TRUE(fxl_beam_shines_on(&beam, &floor, &up));
    TEST_ASSERT_FALSE(fxl_beam_shines_on(&beam, &floor, &under));
}

/* A sphere that is ruled out has no point in the beam. */
void test_a_sphere_that_is_ruled_out_is_outside(void)
{
    fxl_beam beam;
    int out = 0, reached = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, window, 4, &beam));
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_point centre = unit_point(Q16(6));
        fxl_q16_16 radius = unit_between(0, Q16(3));
        fxl_direction way = unit_direction();
        fxl_point at = {centre.x + (int32_t)floor(way.x * 0x1p-30 * radius),
                        centre.y + (int32_t)floor(way.y * 0x1p-30 * radius),
                        centre.z + (int32_t)floor(way.z * 0x1p-30 * radius)};
        bool may = fxl_beam_reaches(&beam, &centre, radius);
        TEST_ASSERT_TRUE(may || !holds(&beam, at));
        out += !may;
        reached += may;
    }
    TEST_ASSERT_TRUE(out > UNIT_REPEAT / 10);
    TEST_ASSERT_TRUE(reached > UNIT_REPEAT / 50);
}
