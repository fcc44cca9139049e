/* SPDX-License-Identifier: MIT */
/* fxl_surfaces_check: what it takes, at each limit, and what it refuses one beyond. */
#include <stddef.h>

#include "fixel/surfaces.h"
#include "mapped_quad.h"
#include "unit.h"

static mapped_quad quad;
static fxl_direction corner_normals[2];
static uint8_t table[FXL_BLEND_TABLE_BYTES(1)], colours[16];
static fxl_scene_fault fault;

/* A square with a texture of 64 x 64 that keeps all rules. */
void setUp(void)
{
    const fxl_direction back = {0, 0, -FXL_Q2_30_ONE};
    memset(&quad, 0, sizeof quad);
    quad.vertices[0] = (fxl_point){Q16(-1), Q16(1), 0};
    quad.vertices[1] = (fxl_point){Q16(1), Q16(1), 0};
    quad.vertices[2] = (fxl_point){Q16(1), Q16(-1), 0};
    quad.vertices[3] = (fxl_point){Q16(-1), Q16(-1), 0};
    mapped_quad_make(&quad, back, Q16(2));
    corner_normals[0] = corner_normals[1] = back;
    quad.set.normals = corner_normals;
    quad.set.normal_count = 2;
}

static void takes(void)
{
    fault = (fxl_scene_fault){.what = "untouched"};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_surfaces_check(&quad.set, &quad.scene, 8, &fault));
    TEST_ASSERT_EQUAL_STRING("untouched", fault.what);
}

static void refuses(fxl_status status, const char *where, uint32_t number)
{
    TEST_ASSERT_EQUAL(status, fxl_surfaces_check(&quad.set, &quad.scene, 8, &fault));
    TEST_ASSERT_EQUAL_STRING(where, fault.what);
    TEST_ASSERT_EQUAL_UINT32(number, fault.index);
    TEST_ASSERT_EQUAL(status, fxl_surfaces_check(&quad.set, &quad.scene, 8, NULL));
}

/* What the set says, from its texture on: the texels before that do not fit on a small stack. */
enum {
    SAID_AT = offsetof(mapped_quad, texture)
};
static uint8_t said[sizeof quad - SAID_AT];

static void keep(void)
{
    memcpy(said, (const uint8_t *)&quad + SAID_AT, sizeof said);
}

static void restore(void)
{
    memcpy((uint8_t *)&quad + SAID_AT, said, sizeof said);
}

/* Sets a member to a value that is taken, or to one that is refused; then as it was. */
#define TAKES(member, value) \
    do { \
        keep(); \
        (member) = (value); \
        takes(); \
        restore(); \
    } while (0)
#define REFUSES(member, value, status, where) \
    do { \
        keep(); \
        (member) = (value); \
        refuses(status, where, 0); \
        restore(); \
    } while (0)

void test_null_pointers(void)
{
    takes();
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_surfaces_check(NULL, &quad.scene, 8, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_surfaces_check(&quad.set, NULL, 8, NULL));
    REFUSES(quad.set.face_map, NULL, FXL_E_ARGUMENT, "surfaces");
    REFUSES(quad.set.textures, NULL, FXL_E_ARGUMENT, "surfaces");
    REFUSES(quad.set.surfaces, NULL, FXL_E_ARGUMENT, "surfaces");
    REFUSES(quad.set.faces, NULL, FXL_E_ARGUMENT, "surfaces");
    REFUSES(quad.set.corners, NULL, FXL_E_ARGUMENT, "surfaces");
    REFUSES(quad.set.normals, NULL, FXL_E_ARGUMENT, "surfaces");
    const uintptr_t odd = (uintptr_t)&quad + 1;
    REFUSES(quad.set.face_map, (const uint16_t *)odd, FXL_E_ALIGNMENT, "surfaces");
    REFUSES(quad.set.textures, (const fxl_texture *)odd, FXL_E_ALIGNMENT, "surfaces");
    REFUSES(quad.set.surfaces, (const fxl_surface *)odd, FXL_E_ALIGNMENT, "surfaces");
    REFUSES(quad.set.faces, (const fxl_mapped_face *)odd, FXL_E_ALIGNMENT, "surfaces");
    REFUSES(quad.set.corners, (const fxl_corner *)odd, FXL_E_ALIGNMENT, "surfaces");
    REFUSES(quad.set.normals, (const fxl_direction *)odd, FXL_E_ALIGNMENT, "surfaces");
    /* A table of no entries may be absent. */
    quad.surface.texture = 0;
    quad.set.texture_count = quad.set.normal_count = 0;
    TAKES(quad.set.textures, NULL);
    TAKES(quad.set.normals, NULL);
}

/* Each count alone is beyond its limit. */
void test_counts(void)
{
    REFUSES(quad.set.texture_count, FXL_TEXTURES_MAX + 1, FXL_E_COUNT, "surfaces");
    REFUSES(quad.set.surface_count, FXL_SURFACES_MAX + 1, FXL_E_COUNT, "surfaces");
    REFUSES(quad.set.face_count, FXL_MAPPED_FACES_MAX + 1, FXL_E_COUNT, "surfaces");
    REFUSES(quad.set.corner_count, FXL_SCENE_CORNERS_MAX + 1, FXL_E_COUNT, "surfaces");
    REFUSES(quad.set.normal_count, UINT16_MAX + 1u, FXL_E_COUNT, "surfaces");
    TAKES(quad.set.corner_count, FXL_SCENE_CORNERS_MAX); /* only those that faces name are read */
    REFUSES(quad.set.blend_first, 256, FXL_E_COUNT, "surfaces");
    REFUSES(quad.set.blend_count, 257, FXL_E_COUNT, "surfaces");
    TAKES(quad.set.face_count, FXL_MAPPED_FACES_MAX); /* only those that the map names are read */
    TAKES(quad.set.blend_first, 255);
    TAKES(quad.set.blend_count, 256);
}

/* As many as there may be: the last of each is looked at. */
void test_the_last_of_each(void)
{
    static fxl_texture textures[3];
    static fxl_surface surfaces[3];
    for (int i = 0; i < 3; i++) {
        textures[i] = quad.texture;
        surfaces[i] = quad.surface;
    }
    quad.set.textures = textures;
    quad.set.surfaces = surfaces;
    quad.set.texture_count = quad.set.surface_count = 3;
    surfaces[2].texture = 3;
    takes();
    surfaces[2].texture = 4;
    refuses(FXL_E_INDEX, "surface", 2);
    surfaces[2].texture = 3;
    textures[2].levels = 0;
    refuses(FXL_E_RANGE, "texture", 2);
    textures[2].levels = 1;
    corner_normals[1].z += 65536;
    refuses(FXL_E_NORMAL, "normal", 1);
}

/* surfaces 1.3c */
void test_textures(void)
{
    REFUSES(quad.texture.texels, NULL, FXL_E_ARGUMENT, "texture");
    REFUSES(quad.texture.colours, colours, FXL_E_ARGUMENT, "texture"); /* of 8 bits */
    REFUSES(quad.texture.format, FXL_TEXTURE_565, FXL_E_RESERVED, "texture");
    REFUSES(quad.texture.format, 3, FXL_E_RESERVED, "texture");
    TAKES(quad.texture.flags, FXL_TEXTURE_CLAMP | FXL_TEXTURE_KEYED);
    REFUSES(quad.texture.flags, 4, FXL_E_RESERVED, "texture");
    TAKES(quad.texture.key, 255);
    REFUSES(quad.texture.key_565, 1, FXL_E_RESERVED, "texture");
    TAKES(quad.texture.log_width, FXL_TEXTURE_LOG_MAX);
    REFUSES(quad.texture.log_width, FXL_TEXTURE_LOG_MAX + 1, FXL_E_RANGE, "texture");
    TAKES(quad.texture.log_height, FXL_TEXTURE_LOG_MAX);
    REFUSES(quad.texture.log_height, FXL_TEXTURE_LOG_MAX + 1, FXL_E_RANGE, "texture");
    TAKES(quad.texture.log_width, 0);
    TAKES(quad.texture.log_height, 0);
    /* 64 x 64: seven levels; and as many where only one side is that long. */
    REFUSES(quad.texture.levels, 0, FXL_E_RANGE, "texture");
    for (int shorter = 0; shorter < 3; shorter++) {
        quad.texture.log_width = shorter == 1 ? 2 : 6;
        quad.texture.log_height = shorter == 2 ? 2 : 6;
        TAKES(quad.texture.levels, 7);
        REFUSES(quad.texture.levels, 8, FXL_E_RANGE, "texture");
    }
}

/* surfaces 1.3a */
void test_textures_of_4_bits(void)
{
    quad.texture.format = FXL_TEXTURE_4;
    refuses(FXL_E_ARGUMENT, "texture", 0);
    quad.texture.colours = colours;
    takes();
    TAKES(quad.texture.log_width, 1);
    REFUSES(quad.texture.log_width, 0, FXL_E_RANGE, "texture");
    TAKES(quad.texture.log_height, 0);
}

void test_surfaces(void)
{
    REFUSES(quad.surface.texture, 2, FXL_E_INDEX, "surface");
    TAKES(quad.surface.texture, 0);
    TAKES(quad.surface.opacity, 1);
    REFUSES(quad.surface.opacity, 0, FXL_E_RANGE, "surface");
    REFUSES(quad.surface.opacity, 17, FXL_E_RANGE, "surface");
    TAKES(quad.surface.division, FXL_AFFINE);
    REFUSES(quad.surface.division, FXL_AFFINE + 1, FXL_E_RESERVED, "surface");
    REFUSES(quad.surface.flags, FXL_SURFACE_BLEND, FXL_E_ARGUMENT, "surface");
    quad.set.blend = table;
    TAKES(quad.surface.flags, FXL_SURFACE_BLEND);
    TAKES(quad.surface.flags, FXL_SURFACE_LIT | FXL_SURFACE_BLEND);
    REFUSES(quad.surface.flags, FXL_SURFACE_ADD, FXL_E_RESERVED, "surface");
    REFUSES(quad.surface.flags, 8, FXL_E_RESERVED, "surface");
    for (int i = 0; i < 2; i++) {
        REFUSES(quad.surface.reserved[i], 1, FXL_E_RESERVED, "surface");
    }
    REFUSES(quad.surface.sixteenths, 1, FXL_E_RESERVED, "surface");
    quad.surface.flags = FXL_SURFACE_BLEND;
    TAKES(quad.surface.sixteenths, 16);
    REFUSES(quad.surface.sixteenths, 17, FXL_E_RANGE, "surface");
}

/* SPEC 3.1m */
void test_mapped_faces(void)
{
    REFUSES(quad.face_map, 2, FXL_E_INDEX, "face");
    REFUSES(quad.mapped.surface, 1, FXL_E_INDEX, "mapped face");
    REFUSES(quad.set.corner_count, 2, FXL_E_INDEX, "mapped face");
    for (int i = 0; i < 3; i++) {
        REFUSES(quad.mapped.corners[i], 3, FXL_E_INDEX, "mapped face");
        REFUSES(quad.mapped.corners[i], UINT16_MAX, FXL_E_INDEX, "mapped face");
        TAKES(quad.mapped_corners[i].vertex, 3);
        REFUSES(quad.mapped_corners[i].vertex, 4, FXL_E_INDEX, "mapped face");
        REFUSES(quad.mapped_corners[i].vertex, UINT16_MAX, FXL_E_INDEX, "mapped face");
        REFUSES(quad.mapped_corners[i].vertex, (uint16_t)((i + 1) % 3), FXL_E_DEGENERATE,
                "mapped face");
        TAKES(quad.mapped_corners[i].normal, 2); /* not lit: not read */
        TAKES(quad.mapped_corners[i].texel.u, FXL_TEXEL_MAX);
        TAKES(quad.mapped_corners[i].texel.v, FXL_TEXEL_MAX);
        TAKES(quad.mapped_corners[i].texel.u, -FXL_TEXEL_MAX);
        TAKES(quad.mapped_corners[i].texel.v, -FXL_TEXEL_MAX);
        REFUSES(quad.mapped_corners[i].texel.u, FXL_TEXEL_MAX + 1, FXL_E_RANGE, "mapped face");
        REFUSES(quad.mapped_corners[i].texel.v, FXL_TEXEL_MAX + 1, FXL_E_RANGE, "mapped face");
        REFUSES(quad.mapped_corners[i].texel.u, -FXL_TEXEL_MAX - 1, FXL_E_RANGE, "mapped face");
        REFUSES(quad.mapped_corners[i].texel.v, -FXL_TEXEL_MAX - 1, FXL_E_RANGE, "mapped face");
    }
    quad.surface.flags = FXL_SURFACE_LIT;
    for (int i = 0; i < 3; i++) {
        TAKES(quad.mapped_corners[i].normal, 1);
        REFUSES(quad.mapped_corners[i].normal, 2, FXL_E_INDEX, "mapped face");
    }
}

/* A surface counts from a corner of its own, which may be as far as the end of the table. */
/* surfaces 1.4 */
void test_first_corners(void)
{
    static fxl_corner five[5];
    memcpy(five + 2, quad.mapped_corners, sizeof quad.mapped_corners);
    quad.set.corners = five;
    quad.set.corner_count = 5;
    refuses(FXL_E_DEGENERATE, "mapped face", 0);
    TAKES(quad.surface.first_corner, 2);
    REFUSES(quad.surface.first_corner, 3, FXL_E_INDEX, "mapped face");
    REFUSES(quad.surface.first_corner, 5, FXL_E_INDEX, "mapped face");
    REFUSES(quad.surface.first_corner, 6, FXL_E_INDEX, "surface");
    REFUSES(quad.surface.first_corner, UINT32_MAX, FXL_E_INDEX, "surface");
}

/* A face that has no surface is not looked at. */
void test_a_face_without_a_surface(void)
{
    quad.mapped.surface = 1;
    refuses(FXL_E_INDEX, "mapped face", 0);
    quad.face_map = 0;
    takes();
}

/* Along each axis: three points on a line have every part of the cross product 0, and others one
 * part at least that is not. */
/* surfaces 1.2a */
void test_corners_on_one_line(void)
{
    static const fxl_point sides[3] = {{Q16(1), 0, 0}, {0, Q16(1), 0}, {0, 0, Q16(1)}};
    for (int a = 0; a < 3; a++) {
        for (int b = 0; b < 3; b++) {
            const fxl_point start = {3, -5, 7};
            quad.vertices[0] = start;
            quad.vertices[1] =
                (fxl_point){start.x + sides[a].x, start.y + sides[a].y, start.z + sides[a].z};
            quad.vertices[2] = (fxl_point){start.x + 3 * sides[b].x, start.y + 3 * sides[b].y,
                                           start.z + 3 * sides[b].z};
            if (a == b) {
                refuses(FXL_E_DEGENERATE, "mapped face", 0);
                (&quad.vertices[2].x)[(a + 1) % 3] += 1;
            }
            takes();
        }
    }
}
