/* SPDX-License-Identifier: MIT */
/* Lines on faces with surfaces: the codes of the depth buffer, to the bit. */
#include <math.h>

#include "line_scene.h" /* last: its names are those of parameters */

/* place pixel-format: its target with a depth buffer, and what draws its surfaces */
static const fxl_target *const targets[4] = {&fxl_palette_depth_16, &fxl_palette_depth_32,
                                             &fxl_rgb565_depth_16, &fxl_rgb565_depth_32};
static const fxl_painter *const painters[4] = {
    FXL_SURFACES_OF(fxl_palette_depth_16), FXL_SURFACES_OF(fxl_palette_depth_32),
    FXL_SURFACES_OF(fxl_rgb565_depth_16), FXL_SURFACES_OF(fxl_rgb565_depth_32)};

/* --- two triangles with an edge in common --------------------------------------------------- */

enum {
    LEVELS = 4,
    FIRST = 1, /* the faces that a frame has */
    SECOND = 2
};

/* What a face has; from BLENDED on it is blended too. */
enum {
    NOTHING,
    COLOUR,
    TEXELS,
    EXACT_TEXELS, /* divided at each pixel: its depth is that of the plane of its corners */
    LIGHT,
    COLOURS, /* of its corners: for pixels of 16 bits */
    BLENDED = 8
};

static uint8_t texels[8 * 8], ramp[FXL_LIGHT_RAMP_BYTES(LEVELS)], blend[256];
static fxl_surface surfaces[2];
static fxl_mapped_face mapped[2];
static fxl_corner corners[2][3];
static uint16_t face_map[2];
static fxl_point seen[4]; /* the vertices in the world */
static fxl_surfaces attached_surfaces;
static fxl_light light;
static fxl_lit_surfaces lit;
static uint32_t of_16[PIXELS];
static uint32_t alone[2][PIXELS], on_one[2][PIXELS], on_both[PIXELS];

/* A vertex that is seen so many pixels right of and above the middle of the screen, in 1/65536, at a
 * distance. */
static fxl_point seen_at(int32_t right, int32_t above, fxl_q16_16 z)
{
    const fxl_point point = {(fxl_q16_16)((int64_t)right * z / (WIDTH * 32768)),
                             (fxl_q16_16)((int64_t)above * z / (WIDTH * 32768)), z};
    return point;
}

/* Makes the scene of the vertices in the world, of which the first two are those of the edge. is_away: the
 * second face is turned away; is_turned: the instance is turned, by a quarter, and its model back. */
static void make_pair(bool is_away, bool is_turned)
{
    static const fxl_placement quarter = {
        {{0, -FXL_Q2_30_ONE, 0}, {FXL_Q2_30_ONE, 0, 0}, {0, 0, FXL_Q2_30_ONE}}, Q16(1)};
    tiny = tiny_make();
    for (uint32_t i = 0; i < 4; i++) {
        const fxl_point back = {seen[i].y, -seen[i].x, seen[i].z};
        tiny->vertices[i] = is_turned ? back : seen[i];
    }
    tiny->scene.placements = is_turned ? &quarter : NULL;
    tiny->scene.placement_code = &fxl_turned_instances;
    for (uint16_t i = 0; i < 2; i++) {
        const uint16_t side = i == 0 || is_away ? 0 : 1;
        fxl_plane plane;
        fxl_face *face = &tiny->faces[i];
        *face = (fxl_face){{0, 0, 0}, 3, (uint8_t)(10 + i), {side, 1u - side, 2u + i}};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_plane_from_points(&tiny->vertices[face->indices[0]],
                                                        &tiny->vertices[face->indices[1]],
                                                        &tiny->vertices[face->indices[2]], &plane));
        face->normal = plane.normal;
    }
    tiny->models[0] = (fxl_model){
        .vertex_count = 4, .face_count = 2, .kind = FXL_MODEL_CONVEX, .radius = Q16(90)};
    tiny->instances[0] = (fxl_instance){{0, 0, 0}, 0, 0, 0};
    tiny->scene.vertex_count = 4;
    tiny->scene.index_count = 0;
    tiny->scene.face_count = 2;
    tiny->scene.model_count = tiny->scene.instance_count = 1;
    tiny->scene.face_bounds = NULL;
    tiny->scene.face_bounds_count = 0;
    line_map[0] = 0;
    line_map[1] = 1;
    lines[0] = (fxl_line){0, 1, {1, 2}, LINE, 1, 0};
    set = (fxl_line_set){lines, 1, line_map};
}

static void make_surface(uint16_t face, uint32_t what)
{
    static const uint8_t flags[] = {0, 0, 0, 0, FXL_SURFACE_LIT, FXL_SURFACE_COLOURS};
    const uint32_t kind = what % BLENDED;
    const bool has_texels = kind == TEXELS || kind == EXACT_TEXELS;
    surfaces[face] =
        (fxl_surface){.texture = has_texels,
                      .opacity = 16,
                      .division = kind == EXACT_TEXELS ? FXL_DIVIDE_1 : FXL_DIVIDE_16,
                      .flags = (uint8_t)(flags[kind] | (what >= BLENDED ? FXL_SURFACE_BLEND : 0))};
    mapped[face] = (fxl_mapped_face){.surface = face, .corners = {0, 1, 2}};
    surfaces[face].first_corner = (uint16_t)(3 * face);
    for (uint16_t i = 0; i < 3; i++) {
        corners[face][i] = (fxl_corner){
            {unit_between(0, Q16(2)), unit_between(0, Q16(2))}, tiny->faces[face].indices[i], i};
        if (kind == COLOURS) {
            corners[face][i].texel =
                (fxl_texel){(fxl_q16_16)FXL_CORNER_COLOUR(90 + 10 * i, 90, 70), 0};
        }
    }
    face_map[face] = kind != NOTHING || what >= BLENDED ? (uint16_t)(face + 1) : 0;
}

/* Draws the faces of the model, and codes[] is what is kept. */
static void draw_codes(uint32_t target, uint32_t faces, bool has_line, uint32_t codes[PIXELS])
{
    static const fxl_direction normals[] = {
        {0, 0, -FXL_Q2_30_ONE}, {0, FXL_Q2_30_ONE, 0}, {FXL_Q2_30_ONE, 0, 0}};
    static const fxl_texture texture = {
        .texels = texels, .log_width = 3, .log_height = 3, .levels = 1};
    const fxl_surface_set surface_set = {.textures = &texture,
                                         .texture_count = 1,
                                         .surfaces = surfaces,
                                         .surface_count = 2,
                                         .faces = mapped,
                                         .face_count = 2,
                                         .face_map = face_map + (faces == SECOND),
                                         .corners = corners[0],
                                         .corner_count = 6,
                                         .normals = normals,
                                         .normal_count = 3,
                                         .blend = blend,
                                         .blend_first = 0,
                                         .blend_count = 1};
    const fxl_light_settings lamp = {.direction = {0, 0, FXL_Q2_30_ONE},
                                     .strength = FXL_Q2_30_ONE / 2,
                                     .ambient = FXL_Q2_30_ONE / 4,
                                     .ramp = ramp,
                                     .levels = LEVELS};
    tiny->scene.faces = tiny->faces + (faces == SECOND);
    tiny->scene.face_count = tiny->models[0].face_count = faces == (FIRST | SECOND) ? 2 : 1;
    lines[0].faces[1] = (uint16_t)(tiny->scene.face_count == 2 ? 2 : 0);
    start(targets[target], has_line);
    TEST_ASSERT_EQUAL(
        FXL_OK, fxl_attach_surfaces(&renderer, &attached_surfaces, &surface_set, painters[target]));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, &lamp));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lit(&renderer, &lit));
    memset(cells, 0, sizeof cells); /* rows that nothing reaches are not cleared */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &ahead, of_16, WIDTH));
    for (int32_t i = 0; i < PIXELS; i++) {
        codes[i] = cell_at(targets[target]->depth_bits, i);
    }
}

/* --- the definition ------------------------------------------------------------------------- */

/* near / z of the plane of three points at a pixel's centre. */
static double depth_at(const fxl_point *const of[3], int32_t pixel)
{
    double e[2][3], n[3];
    for (uint32_t i = 0; i < 2; i++) {
        e[i][0] = of[i + 1]->x - (double)of[0]->x;
        e[i][1] = of[i + 1]->y - (double)of[0]->y;
        e[i][2] = of[i + 1]->z - (double)of[0]->z;
    }
    for (uint32_t i = 0; i < 3; i++) {
        n[i] = e[0][(i + 1) % 3] * e[1][(i + 2) % 3] - e[0][(i + 2) % 3] * e[1][(i + 1) % 3];
    }
    const double ray[3] = {pixel % WIDTH + 0.5 - WIDTH / 2.0, HEIGHT / 2.0 - pixel / WIDTH - 0.5,
                           WIDTH / 2.0};
    const double volume = n[0] * of[0]->x + n[1] * of[0]->y + n[2] * of[0]->z;
    return NEAR * (n[0] * ray[0] + n[1] * ray[1] + n[2] * ray[2]) / (volume * ray[2]);
}

/* The code of the plane in the octaves of the corners: where it leaves them, of the straight lines that it follows
 * there. */
static double code_beyond(const fxl_point *const of[3], double depth)
{
    double least = HUGE_VAL;
    for (uint32_t i = 0; i < 3; i++) {
        const double code = exact_code_beyond(depth, NEAR / (double)of[i]->z);
        least = code < least ? code : least;
    }
    return least;
}

/* --- against the faces ---------------------------------------------------------------------- */

/* A triangle on each side of an edge, all of them on the screen, whose sizes are from 1 to 4 times the least,
 * in 1/10 pixel, and whose distances are `middle` by so many per cent. */
static void make_any_pair(int32_t least, fxl_q16_16 middle, int32_t percent, bool is_away,
                          bool is_turned)
{
    static const double angles[] = {0, 3.14, 1.57, 4.71};
    const double turn = unit_between(0, 628) / 100.0;
    const double size = 6553.6 * unit_between(least, 4 * least);
    for (uint32_t i = 0; i < 4; i++) {
        const double angle = turn + angles[i] + unit_between(-50, 50) / 100.0;
        const double z = (double)middle * unit_between(100 - percent, 100 + percent) / 100;
        seen[i] =
            seen_at((int32_t)(size * cos(angle)), (int32_t)(size * sin(angle)), (fxl_q16_16)z);
    }
    make_pair(is_away, is_turned);
    lines[0].width = (uint8_t)unit_between(1, FXL_LINE_WIDTH_MAX);
}

static void corners_of(uint32_t face, const fxl_point *of[3])
{
    for (uint32_t i = 0; i < 3; i++) {
        of[i] = &seen[tiny->faces[face].indices[i]];
    }
}

/* The frame of the line alone: it has the line wherever that has a pixel. */
static void draw_line_alone(void)
{
    const fxl_line kept = lines[0];
    lines[0].faces[0] = lines[0].faces[1] = 0;
    start(&fxl_palette, true);
    draw(&ahead, frame);
    lines[0] = kept;
}

/* A blended face has the code that it has where it is not blended: but for texels or light that is a function
 * of the screen, which a blended face does not have, nor one that is divided at each pixel. */
static void draw_faces_alone(uint32_t target, const uint32_t what[2])
{
    fxl_surface kept[2];
    memcpy(kept, surfaces, sizeof kept);
    for (uint32_t i = 0; i < 2; i++) {
        surfaces[i].flags &= (uint8_t) ~(uint32_t)FXL_SURFACE_BLEND;
        if (what[i] >= BLENDED && what[i] != BLENDED + COLOURS) {
            surfaces[i].division = FXL_DIVIDE_1;
        }
    }
    draw_codes(target, FIRST, false, alone[0]);
    draw_codes(target, SECOND, false, alone[1]);
    memcpy(surfaces, kept, sizeof kept);
}

/* Whether the codes of a face may be functions of the screen. */
static bool may_be_linear(uint32_t target, uint32_t what)
{
    return targets[target]->depth_bits == 16 &&
           (what == LIGHT || what == TEXELS || what % BLENDED == COLOURS);
}

/* What is kept in a frame of a face alone with the line on it. */
static void check_one(uint32_t target, uint32_t face, uint32_t what, bool is_front,
                      uint32_t *within, uint32_t *beside)
{
    const fxl_point *of[3];
    corners_of(face, of);
    for (int32_t i = 0; i < PIXELS; i++) {
        const uint32_t code = on_one[face][i];
        if (frame[i] != LINE || !is_front) {
            TEST_ASSERT_EQUAL_HEX32(what >= BLENDED ? 0 : alone[face][i], code);
        } else if (alone[face][i] != 0) {
            TEST_ASSERT_EQUAL_HEX32(alone[face][i], code);
            (*within)++;
        } else if (!may_be_linear(target, what)) {
            expect_code(exact_code(depth_at(of, i)), targets[target]->depth_bits, code);
            (*beside)++;
        }
    }
}

/* Of each face alone, then of both, where it is the larger one of those that face the eye. Each face with any
 * surface, blended or not. */
/* lines 3.2a */
void test_the_codes_of_a_line_are_those_of_its_faces(void)
{
    uint32_t within[2 * BLENDED] = {0}, beside[2 * BLENDED] = {0}, second = 0;
    for (uint32_t round = 0; round < 48 + UNIT_REPEAT / 100; round++) {
        const uint32_t target = round % 4, kinds = target < 2 ? COLOURS : COLOURS + 1;
        const bool is_away = round % 7 == 0;
        uint32_t what[2];
        make_any_pair(30, unit_between(Q16(0.5), Q16(12)), 25, is_away, unit_between(0, 2) == 0);
        for (uint16_t i = 0; i < 2; i++) {
            const uint32_t kind = i == 0 ? round / 4 : unit_random();
            what[i] = kind / 2 % kinds + (kind % 2 != 0 ? BLENDED : 0);
            make_surface(i, what[i]);
        }
        draw_line_alone();
        draw_faces_alone(target, what);
        for (uint32_t i = 0; i < 2; i++) {
            draw_codes(target, FIRST << i, true, on_one[i]);
            check_one(target, i, what[i], i == 0 || !is_away, &within[what[i]], &beside[what[i]]);
        }
        draw_codes(target, FIRST | SECOND, true, on_both);
        for (int32_t i = 0; i < PIXELS; i++) {
            const uint32_t first = on_one[0][i], other = on_one[1][i];
            TEST_ASSERT_EQUAL_HEX32(first > other ? first : other, on_both[i]);
            second += frame[i] == LINE && first < other;
        }
    }
    for (uint32_t i = 0; i < 2 * BLENDED; i++) {
        TEST_ASSERT_TRUE(i % BLENDED > COLOURS || within[i] > 50);
        TEST_ASSERT_TRUE(i % BLENDED > COLOURS || beside[i] > 50 || may_be_linear(0, i));
    }
    TEST_ASSERT_TRUE(second > 100);
}

/* lines 3.2b */
void test_codes_beside_a_face_whose_codes_are_linear(void)
{
    static const uint32_t kinds[][2] = {
        {0, LIGHT}, {2, LIGHT}, {2, TEXELS}, {2, COLOURS}, {2, BLENDED + COLOURS}};
    for (uint32_t k = 0; k < 5; k++) {
        const uint32_t target = kinds[k][0], what = kinds[k][1];
        uint32_t above = 0, bent = 0;
        for (int round = 0; round < 90; round++) {
            const fxl_point *of[3];
            /* nearer than the end of an octave at 4, farther, and across it */
            make_any_pair(40,
                          round % 3 == 0   ? Q16(3.65)
                          : round % 3 == 1 ? Q16(4.4)
                                           : Q16(4.02),
                          10, false, false);
            lines[0].width = FXL_LINE_WIDTH_MAX;
            make_surface(0, what);
            make_surface(1, NOTHING);
            corners_of(0, of);
            const double first = NEAR / (double)of[0]->z;
            bool is_bent = false;
            for (uint32_t i = 1; i < 3; i++) {
                is_bent = is_bent || ilogb(NEAR / (double)of[i]->z) != ilogb(first);
            }
            if (is_bent && what == LIGHT) {
                continue;
            }
            draw_line_alone();
            draw_codes(target, FIRST, false, alone[0]);
            draw_codes(target, FIRST, true, on_one[0]);
            for (int32_t i = 0; i < PIXELS; i++) {
                if (frame[i] == LINE && alone[0][i] == 0) {
                    const double depth = depth_at(of, i), code = code_beyond(of, depth);
                    expect_code(code, 16, on_one[0][i]);
                    above += code > exact_code(depth) + 3;
                    bent += is_bent;
                }
            }
        }
        TEST_ASSERT_TRUE(above > 20 && (bent > 20 || what == LIGHT));
    }
}

/* Whether the codes that the line has beside its face are all those of the plane, or of the linear function, held
 * between the least code and the largest. Counts those that are held at each. */
static bool are_beside(bool is_linear, uint32_t held[2])
{
    const fxl_point *of[3];
    corners_of(0, of);
    for (int32_t i = 0; i < PIXELS; i++) {
        if (frame[i] == LINE && alone[0][i] == 0) {
            const double depth = depth_at(of, i);
            double code = is_linear ? code_beyond(of, depth) : exact_code(depth);
            held[code > 1] += code < 1 || code > 65535;
            code = code < 1 ? 1 : code > 65535 ? 65535 : code;
            if (on_one[0][i] > code + 0.1 || on_one[0][i] < code - 1.1) {
                return false;
            }
        }
    }
    return true;
}

/* A triangle of a height of 3/4 pixel, whose depths are 0.5 to 0.55 and 0.75 to 0.85, so that it is in one octave, and
 * 2 pixels beside it are beyond the largest code. Its corners are on the screen exactly where seen_at has them. */
static void make_thin_pair(void)
{
    const fxl_q16_16 far_z = 64 * unit_between(464, 511), near_z = 64 * unit_between(301, 341);
    seen[0] = seen_at(9 * 65536, 0, far_z);
    seen[1] = seen_at(-9 * 65536, 0, far_z);
    seen[2] = seen_at(0, 49152, near_z);
    seen[3] = seen_at(0, -49152, far_z);
    make_pair(false, false);
}

/* A steep face, whose linear function leaves all codes beside it. */
/* lines 3.2b */
void test_codes_beside_a_steep_face_are_held(void)
{
    uint32_t low = 0, held[2] = {0, 0};
    for (int round = 0; round < 600; round++) {
        make_any_pair(20, (fxl_q16_16)ldexp(unit_between(65536, 131072), round % 7 - 1), 30, false,
                      false);
        far_by_near = round % 8 == 0 ? 100 : FAR_BY_NEAR; /* of 7 octaves codes are up to 57345 */
        if (round % 8 == 0) {
            make_thin_pair();
        }
        lines[0].width = FXL_LINE_WIDTH_MAX;
        make_surface(0, COLOURS - (uint32_t)round % 2);
        make_surface(1, NOTHING);
        draw_line_alone();
        draw_codes(2, FIRST, false, alone[0]);
        draw_codes(2, FIRST, true, on_one[0]);
        uint32_t of_plane[2] = {0, 0};
        if (!are_beside(false, of_plane)) {
            TEST_ASSERT_TRUE(are_beside(true, held));
            low++;
        }
    }
    far_by_near = FAR_BY_NEAR;
    TEST_ASSERT_TRUE(low > 20 && held[0] > 50 && held[1] > 50);
}
