/* SPDX-License-Identifier: MIT */
/* Lines on the screen by the rule, and a scene's edges in whatever bands. */
#include "tiny.h"

enum {
    WIDTH = 48,
    HEIGHT = 32
};

static uint8_t whole[WIDTH * HEIGHT], other[WIDTH * HEIGHT];

static fxl_band all_of(uint8_t *pixels)
{
    fxl_band band = UNIT_BAND(pixels, WIDTH, 0, HEIGHT);
    return band;
}

static fxl_screen_point at(double x, double y)
{
    fxl_screen_point point = {Q16(x), Q16(y)};
    return point;
}

static void draw(uint8_t *pixels, fxl_screen_point from, fxl_screen_point to)
{
    fxl_band band = all_of(pixels);
    memset(pixels, 0, WIDTH * HEIGHT);
    fxl_wire_line(&from, &to, 1, &band);
}

static void expect_rows(const char *const *rows, int count)
{
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            const bool want = y < count && x < (int)strlen(rows[y]) && rows[y][x] == '#';
            TEST_ASSERT_EQUAL(want, whole[y * WIDTH + x]);
        }
    }
}
#define EXPECT(...) \
    expect_rows((const char *const[]){__VA_ARGS__}, \
                (int)(sizeof((const char *const[]){__VA_ARGS__}) / sizeof(char *)))

/* wire 2.1, 2.2a */
void test_a_flat_line(void)
{
    draw(whole, at(1.5, 1.9), at(6.5, 3.1));
    EXPECT("", ".#", "..####"); /* y at the centres 1.5, 2.5 ..: 1.9 2.14 2.38 2.62 2.86 */
}

/* wire 2.1b */
void test_a_diagonal_line_is_not_steep(void)
{
    draw(whole, at(1.25, 1.75), at(4.25, 4.75));
    EXPECT("", "", ".#", "..#", "...#"); /* y at the centres 1.5, 2.5, 3.5: 2 3 4 */
    draw(whole, at(4.25, 2.25), at(1.25, 5.25));
    EXPECT("", "", "", "...#", "..#", ".#"); /* 5 4 3 */
}

/* wire 2.1, 2.3a */
void test_a_steep_line(void)
{
    draw(whole, at(3, 0), at(1, 4));
    EXPECT("..#", "..#", ".#", ".#");
}

/* The centre where a line begins is its own, the one where it ends the next one's. */
/* wire 2.2a */
void test_centres_from_the_first_end_to_before_the_last(void)
{
    draw(whole, at(0.5, 0.5), at(4.5, 0.5));
    EXPECT("####");
    draw(whole, at(0.51, 0.5), at(4.51, 0.5));
    EXPECT(".####");
    draw(whole, at(2.6, 0.2), at(3.4, 0.4));
    EXPECT("");
}

/* Between two rows it takes the lower, both ways round. */
/* An end on a centre, and a unit beside it: the first end's pixel is in, the last one's is not. */
void test_ends_about_a_centre(void)
{
    for (int unit = -1; unit <= 1; unit++) {
        for (int upright = 0; upright < 2; upright++) {
            fxl_screen_point ends[2];
            for (int i = 0; i < 2; i++) {
                const int32_t along = (i == 0 ? Q16(5.5) : Q16(9.5)) + unit;
                ends[i] = upright ? (fxl_screen_point){Q16(3.5), along}
                                  : (fxl_screen_point){along, Q16(3.5)};
            }
            draw(whole, ends[0], ends[1]);
            for (int k = 0; k < 16; k++) {
                const int first = unit > 0 ? 6 : 5, end = unit > 0 ? 10 : 9;
                TEST_ASSERT_EQUAL_UINT8(k >= first && k < end,
                                        upright ? whole[k * WIDTH + 3] : whole[3 * WIDTH + k]);
            }
        }
    }
}

void test_a_line_between_rows(void)
{
    draw(whole, at(0, 2), at(3, 2));
    EXPECT("", "", "###");
    draw(whole, at(3, 2), at(0, 2));
    EXPECT("", "", "###");
    draw(whole, at(3, 0), at(3, 3));
    EXPECT("...#", "...#", "...#");
}

/* wire 2.4b */
void test_either_way_is_the_same(void)
{
    for (int i = 0; i < UNIT_REPEAT / 100; i++) {
        fxl_screen_point a = {unit_between(-Q16(9), Q16(60)), unit_between(-Q16(9), Q16(40))};
        fxl_screen_point b = {unit_between(-Q16(9), Q16(60)), unit_between(-Q16(9), Q16(40))};
        draw(whole, a, b);
        draw(other, b, a);
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
    }
}

/* place fill-rule: definition: the pixels of a line */
/* The rule itself, pixel by pixel: the point of the line over the centre of a column, or
 * beside that of a row, lies in the pixel. |products| < 2^60. */
static bool covers(const fxl_screen_point *a, const fxl_screen_point *b, int x, int y)
{
    int64_t w = (int64_t)b->x - a->x, h = (int64_t)b->y - a->y;
    int64_t cx = x * 65536 + 32768, cy = y * 65536 + 32768;
    if ((h < 0 ? -h : h) > (w < 0 ? -w : w)) {
        if (!(a->y <= b->y ? a->y <= cy && cy < b->y : b->y <= cy && cy < a->y)) {
            return false;
        }
        int64_t over = (a->x - (int64_t)x * 65536) * h + (cy - a->y) * w; /* times 1 / h */
        return h > 0 ? over >= 0 && over < 65536 * h : over <= 0 && over > 65536 * h;
    }
    if (!(a->x <= b->x ? a->x <= cx && cx < b->x : b->x <= cx && cx < a->x)) {
        return false;
    }
    int64_t over = (a->y - (int64_t)y * 65536) * w + (cx - a->x) * h;
    return w > 0 ? over >= 0 && over < 65536 * w : over <= 0 && over > 65536 * w;
}

/* wire 2.2a-b, 2.3a-b, 2.4a, 2.4c */
void test_lines_are_what_the_rule_says(void)
{
    for (int i = 0; i < UNIT_REPEAT / 300; i++) {
        const int32_t reach = unit_random() % 4 ? Q16(70) : FXL_SCREEN_COORDINATE_MAX;
        const int32_t grid = unit_random() % 3 ? 1 : 32768;
        fxl_screen_point a = {unit_between(-reach, reach) / grid * grid,
                              unit_between(-reach, reach) / grid * grid};
        fxl_screen_point b = {unit_between(-reach, reach) / grid * grid,
                              unit_between(-reach, reach) / grid * grid};
        draw(whole, a, b);
        for (int k = 0; k < WIDTH * HEIGHT; k++) {
            TEST_ASSERT_EQUAL(covers(&a, &b, k % WIDTH, k / WIDTH), whole[k]);
        }
    }
}

/* Lines that pass exactly between two pixels, or a unit beside that, over the centre of a column:
 * with a slope of odd / 2^k and a first end 2^k u before the centre, the line rises by odd u. */
void test_lines_between_two_pixels(void)
{
    for (int i = 0; i < UNIT_REPEAT / 300; i++) {
        const int k = unit_between(1, 5), odd = 2 * unit_between(0, (1 << k) / 2 - 1) + 1;
        const int32_t u = unit_between(1, Q16(40) >> k), more = unit_between(1, Q16(50) >> k);
        const int32_t centre = Q16(0.5) + Q16(1) * unit_between(0, WIDTH - 1);
        const int32_t level = Q16(1) * unit_between(1, HEIGHT - 1) + unit_between(-1, 1);
        const int sign = unit_random() % 2 ? 1 : -1;
        fxl_screen_point a = {centre - (u << k), level - sign * odd * u};
        fxl_screen_point b = {a.x + ((u + more) << k), a.y + sign * odd * (u + more)};
        if (unit_random() % 2) { /* upright */
            a = (fxl_screen_point){a.y, a.x};
            b = (fxl_screen_point){b.y, b.x};
        }
        draw(whole, a, b);
        for (int n = 0; n < WIDTH * HEIGHT; n++) {
            TEST_ASSERT_EQUAL(covers(&a, &b, n % WIDTH, n / WIDTH), whole[n]);
        }
    }
}

static fxl_wire wire;

static void draw_frame(uint8_t *pixels, uint32_t rows)
{
    memset(pixels, 0, WIDTH * HEIGHT);
    for (uint32_t row = 0; row < HEIGHT; row += rows) {
        uint32_t left = HEIGHT - row;
        fxl_band band = {.pixels = pixels + row * WIDTH,
                         .width = WIDTH,
                         .stride = WIDTH,
                         .first_row = (uint16_t)row,
                         .rows = (uint16_t)(rows < left ? rows : left)};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_draw(&wire, &band));
    }
}

static void make(fxl_wire_clipper clipper)
{
    tiny_scene *tiny = tiny_make();
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_init(&wire, &tiny->scene, &lens, clipper));
}

/* The same pixels in RGB565, each of the colour that the band's palette has for it. */
static void assert_same_in_rgb565(void)
{
    static uint16_t wide[WIDTH * HEIGHT], palette[256];
    const fxl_band band = {.pixels = (uint8_t *)wide,
                           .width = WIDTH,
                           .stride = WIDTH,
                           .first_row = 0,
                           .rows = HEIGHT,
                           .palette = palette};
    for (uint32_t i = 0; i < 256; i++) {
        palette[i] = (uint16_t)(i * 40503u);
    }
    memset(wide, 0, sizeof wide);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_draw(&wire, &band));
    for (int k = 0; k < WIDTH * HEIGHT; k++) {
        TEST_ASSERT_EQUAL_HEX16(palette[whole[k]], wide[k]);
    }
    fxl_band odd = band;
    odd.pixels++;
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, fxl_wire_draw(&wire, &odd));
}

/* wire 1.2, 2.4b */
void test_bands_and_both_clippers_draw_the_same(void)
{
    int pixels = 0, clipped = 0;
    for (int i = 0; i < UNIT_REPEAT / 100; i++) {
        fxl_pose pose = {unit_point(Q16(6)), unit_random(), unit_random(), unit_random()};
        make(fxl_line_by_planes);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
        draw_frame(whole, HEIGHT);
        assert_same_in_rgb565();
        fxl_wire_counters counters = wire.counters;
        TEST_ASSERT_EQUAL_UINT32(counters.in, counters.outside + counters.refused + counters.drawn);
        make(fxl_line_by_codes);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
        draw_frame(other, (uint32_t)unit_between(1, HEIGHT));
        TEST_ASSERT_TRUE(wire.counters.intersections <= counters.intersections);
        wire.counters.intersections = counters.intersections;
        TEST_ASSERT_EQUAL_MEMORY(&counters, &wire.counters, sizeof counters);
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
        clipped += (int)counters.clipped;
        for (int k = 0; k < WIDTH * HEIGHT; k++) {
            pixels += whole[k] != 0;
        }
    }
    TEST_ASSERT_TRUE(pixels > UNIT_REPEAT / 20 && clipped > UNIT_REPEAT / 200);
}

/* Without a placement an instance is drawn as one that has none. A cube that is a quarter turned looks
 * the same but for its colours. */
/* wire 1.1a-b, SPEC 8.5k */
void test_turned_cubes(void)
{
    static fxl_placement placements[TINY_INSTANCES] = {FXL_PLACEMENT_NONE, FXL_PLACEMENT_NONE,
                                                       FXL_PLACEMENT_NONE};
    static const fxl_orientation quarter = {
        {0, 0, FXL_Q2_30_ONE}, {0, FXL_Q2_30_ONE, 0}, {-FXL_Q2_30_ONE, 0, 0}};
    tiny_scene *tiny = tiny_make();
    fxl_pose pose = {{Q16(1), Q16(0.5), Q16(-4)}, DEGREES(10), 0, 0};
    make(fxl_line_by_codes);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
    draw_frame(whole, HEIGHT);
    tiny->scene.placements = placements;
    tiny->scene.first_turned = 0;
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_wire_begin(&wire, &pose));
    tiny->scene.placement_code = &fxl_turned_instances;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
    draw_frame(other, HEIGHT / 3);
    TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
    placements[0].orientation = quarter;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
    draw_frame(other, HEIGHT);
    int differing = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        TEST_ASSERT_EQUAL(whole[i] == 0, other[i] == 0);
        differing += whole[i] != other[i];
    }
    TEST_ASSERT_TRUE(differing > 0);
}

/* A cube from the front: its four sides, in its colour. */
/* wire 1.1b */
void test_a_cube_from_the_front(void)
{
    fxl_pose pose = {{0, 0, Q16(-4)}, 0, 0, 0};
    make(fxl_line_by_codes);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
    draw_frame(whole, HEIGHT);
    /* 24 / 3 pixels each way from (24, 16). */
    TEST_ASSERT_EQUAL(5, whole[8 * WIDTH + 20]);
    TEST_ASSERT_EQUAL(5, whole[24 * WIDTH + 20]);
    TEST_ASSERT_EQUAL(5, whole[16 * WIDTH + 16]);
    TEST_ASSERT_EQUAL(5, whole[16 * WIDTH + 32]);
    TEST_ASSERT_EQUAL(0, whole[14 * WIDTH + 18]);
}

/* From each side of a cube: the edges of the side that is turned to the eye, in its colour, and no
 * other's. */
/* wire 1.1b */
void test_every_side_of_a_cube(void)
{
    static const struct {
        int x, y, z;
        int32_t yaw, pitch;
    } sides[] = {{-4, 0, 0, 90, 0}, {4, 0, 0, -90, 0}, {0, -4, 0, 0, 90},
                 {0, 4, 0, 0, -90}, {0, 0, -4, 0, 0},  {0, 0, 4, 180, 0}};
    for (uint8_t side = 0; side < 6; side++) {
        const fxl_pose pose = {
            {Q16(1) * sides[side].x, Q16(1) * sides[side].y, Q16(1) * sides[side].z},
            (fxl_angle)(sides[side].yaw * (int32_t)DEGREES(1)),
            (fxl_angle)(sides[side].pitch * (int32_t)DEGREES(1)),
            0};
        make(fxl_line_by_codes);
        tiny_scene *tiny = tiny_make();
        tiny->instances[1].centre = tiny->instances[2].centre = (fxl_point){Q16(500), 0, 0};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
        draw_frame(whole, HEIGHT);
        for (uint8_t colour = 1; colour <= 6; colour++) {
            TEST_ASSERT_EQUAL(colour == side + 1,
                              memchr(whole + 7 * WIDTH + 12, colour, 18 * WIDTH) != NULL);
        }
    }
}

/* wire 1.3a */
void test_what_is_no_wireframe_is_refused(void)
{
    fxl_pose pose = {{0, 0, Q16(-4)}, 0, 0, 0};
    fxl_band band = all_of(whole);
    tiny_scene *tiny = tiny_make();
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_wire_init(NULL, &tiny->scene, &lens, fxl_line_by_codes));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_wire_init(&wire, NULL, &lens, fxl_line_by_codes));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_wire_init(&wire, &tiny->scene, NULL, fxl_line_by_codes));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_wire_init(&wire, &tiny->scene, &lens, NULL));
    make(fxl_line_by_planes);
    const fxl_wire before = wire;
    const fxl_lens none_at_all = {0};
    TEST_ASSERT_EQUAL(FXL_E_RANGE,
                      fxl_wire_init(&wire, &tiny->scene, &none_at_all, fxl_line_by_codes));
    lens.focal = -lens.focal;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_wire_init(&wire, &tiny->scene, &lens, fxl_line_by_codes));
    TEST_ASSERT_EQUAL_MEMORY(&before, &wire, sizeof wire);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_wire_draw(&wire, &band));
    pose.position.x = FXL_COORDINATE_MAX + 1;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_wire_begin(&wire, &pose));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_wire_begin(NULL, &pose));
    pose.position.x = 0;
    memset(&wire, 0, sizeof wire); /* never set up */
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_wire_begin(&wire, &pose));
    wire = before;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
    const fxl_band bad[] = {
        {.pixels = whole, .width = WIDTH, .stride = WIDTH, .first_row = 0, .rows = HEIGHT + 1},
        {.pixels = whole, .width = WIDTH, .stride = WIDTH, .first_row = 0, .rows = 0},
        {.pixels = whole, .width = WIDTH, .stride = WIDTH, .first_row = 1, .rows = HEIGHT},
        {.pixels = whole, .width = WIDTH, .stride = WIDTH, .first_row = HEIGHT, .rows = 1},
        {.pixels = whole, .width = WIDTH - 1, .stride = WIDTH, .first_row = 0, .rows = 1},
        {.pixels = whole, .width = WIDTH + 1, .stride = WIDTH + 1, .first_row = 0, .rows = 1},
        {.pixels = whole, .width = WIDTH, .stride = WIDTH - 1, .first_row = 0, .rows = 1}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_wire_draw(&wire, &bad[i]));
    }
    const fxl_band last = {.pixels = whole,
                           .width = WIDTH,
                           .stride = WIDTH,
                           .first_row = HEIGHT - 1,
                           .rows = 1},
                   none = {.width = WIDTH, .stride = WIDTH, .rows = 1};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_draw(&wire, &last));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_wire_draw(&wire, &none));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_wire_draw(&wire, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_wire_draw(NULL, &band));
}

static bool keep_all(fxl_clip_line *line, const fxl_volume *volume, uint32_t *intersections)
{
    (void)line;
    (void)volume;
    (void)intersections;
    return true;
}

/* An edge with an end behind the eye is refused, if the clipper leaves it: three of the four about
 * the face -z, seen from beside. */
/* wire 1.2 */
void test_edges_behind_the_eye_are_refused(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_pose beside = {{0, 0, Q16(-1.2)}, DEGREES(90), 0, 0};
    const fxl_band band = all_of(whole);
    tiny_scene *tiny = tiny_make();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_init(&wire, &tiny->scene, &lens, keep_all));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &beside));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_draw(&wire, &band));
    TEST_ASSERT_EQUAL_UINT32(4, wire.counters.in);
    TEST_ASSERT_EQUAL_UINT32(3, wire.counters.refused);
    TEST_ASSERT_EQUAL_UINT32(1, wire.counters.drawn);
    TEST_ASSERT_EQUAL_UINT32(0, wire.counters.outside);
}

/* Vertices of a model that are given from another origin, and instances that are moved back by as
 * much, are the same scene. */
void test_the_origin_of_a_model_does_not_matter(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_pose before_all = {{Q16(-1), Q16(2), Q16(-5)}, 0, 0, 0};
    const fxl_point origin = {Q16(1), Q16(0.5), Q16(0.25)};
    for (int moved = 0; moved < 2; moved++) {
        const fxl_band band = all_of(moved ? other : whole);
        tiny_scene *tiny = tiny_make();
        tiny->scene.face_bounds = NULL;
        tiny->scene.face_bounds_count = 0;
        tiny->models[0].radius = tiny->models[1].radius = Q16(3);
        for (uint32_t i = 0; moved && i < 16; i++) {
            tiny->vertices[i].x -= origin.x;
            tiny->vertices[i].y -= origin.y;
            tiny->vertices[i].z -= origin.z;
        }
        for (uint32_t i = 0; moved && i < TINY_INSTANCES; i++) {
            tiny->instances[i].centre.x += origin.x;
            tiny->instances[i].centre.y += origin.y;
            tiny->instances[i].centre.z += origin.z;
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_init(&wire, &tiny->scene, &lens, fxl_line_by_planes));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &before_all));
        memset(band.pixels, 0, WIDTH * HEIGHT);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_draw(&wire, &band));
        TEST_ASSERT_TRUE(wire.counters.drawn > 8);
    }
    TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
}
