/* SPDX-License-Identifier: MIT */
/* What a game asks of the library beside frames, it gets bit for bit on every core: hashes on
 * record, as in test_surface_hashes.c. */
#include "tiny.h"

enum {
    ROUNDS = 300, /* of each kind */
    WIDTH = 40,
    HEIGHT = 30
};

static uint32_t hash;
static uint8_t pixels[HEIGHT * WIDTH], texels[64];
static fxl_placement placements[TINY_INSTANCES];
static tiny_scene *tiny;
static fxl_wire wire;

static void mix_point(const fxl_point *point)
{
    hash = unit_mix(hash, point->x);
    hash = unit_mix(hash, point->y);
    hash = unit_mix(hash, point->z);
}

static void mix_placement(const fxl_placement *placement)
{
    hash = unit_mix(hash, placement->scale);
    hash = unit_mix(
        hash, unit_crc32((const uint8_t *)&placement->orientation, sizeof placement->orientation));
}

static void mix_pixels(void)
{
    hash = unit_mix(hash, unit_crc32(pixels, sizeof pixels));
}

static fxl_placement any_placement(void)
{
    fxl_placement placement = FXL_PLACEMENT_NONE;
    const fxl_angle yaw = unit_random(), pitch = unit_random(), roll = unit_random();
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_orientation_from_angles(yaw, pitch, roll, &placement.orientation));
    placement.scale = unit_between(Q16(0.25), Q16(2));
    return placement;
}

static fxl_point any_point(fxl_q16_16 reach)
{
    fxl_point point;
    point.x = unit_between(-reach, reach);
    point.y = unit_between(-reach, reach);
    point.z = unit_between(-reach, reach);
    return point;
}

void setUp(void)
{
    tiny = tiny_make();
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        placements[i] = any_placement();
    }
    for (uint32_t i = 0; i < sizeof texels; i++) {
        texels[i] = (uint8_t)(i * 37 + i / 8);
    }
    tiny->scene.placements = placements;
    tiny->scene.first_turned = 0;
    tiny->scene.placement_code = &fxl_turned_instances;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
}

/* A point some units from one of the cubes. */
static fxl_point point_about(uint32_t instance)
{
    fxl_point point = any_point(Q16(4));
    point.x += tiny->instances[instance].centre.x;
    point.y += tiny->instances[instance].centre.y;
    point.z += tiny->instances[instance].centre.z;
    return point;
}

static void cast(uint32_t number)
{
    fxl_hit hit;
    const fxl_point from = point_about(number % TINY_INSTANCES),
                    to = point_about(number % TINY_INSTANCES);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_cast_segment(&tiny->scene, &from, &to, &hit));
    mix_point(&hit.point);
    hash = unit_mix(hash, hit.fraction);
    hash = unit_mix(hash, hit.instance);
    hash = unit_mix(hash, hit.face);
}

/* From where no cube is, as a rule. */
static void slide(uint32_t number)
{
    fxl_sphere sphere = {point_about(number % TINY_INSTANCES), Q16(0.25)};
    fxl_slide slid = {0, 0, 0, 0};
    const fxl_point move = any_point(Q16(3));
    hash = unit_mix(hash, fxl_slide_sphere(&tiny->scene, &sphere, &move, &slid));
    mix_point(&sphere.centre);
    hash = unit_mix(hash, slid.contacts + 1000u * slid.blocked);
    hash = unit_mix(hash, slid.instance + 100u * slid.face);
}

static void attach(uint32_t number)
{
    const fxl_placement parent = any_placement(), child = any_placement();
    const fxl_point at = any_point(Q16(90)), from = any_point(Q16(9) >> number % 16);
    fxl_point centre = {0, 0, 0};
    fxl_placement placement = FXL_PLACEMENT_NONE;
    hash = unit_mix(hash, fxl_placement_attach(&at, &parent, &from, &child, &centre, &placement));
    mix_point(&centre);
    mix_placement(&placement);
}

static void look(uint32_t number)
{
    fxl_pose pose = {any_point(Q16(2)), 0, 0, 0};
    const fxl_point target = any_point(Q16(40) >> number % 12);
    hash = unit_mix(hash, fxl_pose_look_at(&pose, &target));
    hash = unit_mix(hash, pose.yaw);
    hash = unit_mix(hash, pose.pitch);
}

/* Lines, borders, sprites and text, often beyond the band's ends. */
static void overlay(uint32_t number)
{
    static const char words[] = "Score 0123456789\nFxl: @{}~";
    const fxl_band band = UNIT_BAND(pixels, WIDTH, 7, HEIGHT);
    const fxl_text_style style = {&fxl_font_5x7, (uint8_t)number, (uint8_t)(number % 3 ? 0 : 7)};
    const fxl_sprite sprite = {texels,
                               texels,
                               9,
                               5,
                               number % 2 ? 4 : 1,
                               number % 5 ? (uint16_t)(number % 2) : FXL_SPRITE_OPAQUE};
    int32_t at[4];
    for (int i = 0; i < 4; i++) {
        at[i] = unit_between(-20, 60);
    }
    memset(pixels, 0, sizeof pixels);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_border(&band, at[1], at[2], at[0], at[3], 9));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_rectangle(&band, at[3], at[0], at[1], at[2], 8));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_line(&band, at[0], at[1], at[2], at[3], 7));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_sprite(&band, at[0], at[3], &sprite));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_text(&band, at[2] - 20, at[1], words + number % 9, &style));
    mix_pixels();
}

/* The edges of the cubes, in bands. */
static void lines(uint32_t number)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const uint16_t rows = (uint16_t)(1 + number % HEIGHT);
    fxl_pose pose = {any_point(Q16(5)), 0, 0, 0};
    pose.yaw = unit_random();
    pose.pitch = unit_random();
    pose.roll = unit_random();
    memset(pixels, 0, sizeof pixels);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_init(&wire, &tiny->scene, &lens,
                                            number % 2 ? fxl_line_by_planes : fxl_line_by_codes));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
    for (uint16_t row = 0; row < HEIGHT; row = (uint16_t)(row + rows)) {
        const uint16_t left = (uint16_t)(HEIGHT - row);
        const fxl_band band =
            UNIT_BAND(pixels + row * WIDTH, WIDTH, row, rows < left ? rows : left);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_draw(&wire, &band));
    }
    mix_pixels();
    hash = unit_mix(hash, wire.counters.drawn + 1000u * wire.counters.clipped);
    hash = unit_mix(hash, wire.counters.intersections + 1000u * wire.counters.outside);
}

void test_answers_are_those_on_record(void)
{
    static const struct {
        void (*ask)(uint32_t number);
        uint32_t hash;
    } record[] = {
        {cast, 0x0244753B}, {slide, 0x9EF97048},   {attach, 0x9D66E9E5},
        {look, 0x6DAAD7E2}, {overlay, 0x222A5B62}, {lines, 0x3B98C79B},
    };
    uint32_t wrong = 0;
    for (uint32_t i = 0; i < sizeof record / sizeof record[0]; i++) {
        hash = 0;
        for (uint32_t k = 0; k < ROUNDS; k++) {
            setUp();
            record[i].ask(k);
        }
        wrong += unit_tell_hash(i, hash, record[i].hash);
    }
    TEST_ASSERT_EQUAL_UINT32(0, wrong);
}
