/* SPDX-License-Identifier: MIT */
/* Surfaces with a depth buffer: textures, stipple and glass. */
#include "depth_scene.h"

static depth_scene *made;
static uint8_t panes[FXL_BLEND_TABLE_BYTES(11)];

void setUp(void)
{
    made = depth_scene_make();
}

static void set_texture(uint32_t face)
{
    made->face_map[face] = 1;
    made->is_mapped = true;
    depth_scene_start_with(made, &fxl_palette_depth_16);
}

/* Pixels of the texture of face `face` are where the flat frame has its colour; a texel of the key
 * lets through what is behind. */
static void check_textured(uint32_t face, bool keyed)
{
    uint32_t drawn[2] = {0, 0};
    for (uint32_t i = 0; i < DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT; i++) {
        const bool texel = made->again[i] == 98 || made->again[i] == 99;
        if (made->frame[i] != made->scene.faces[face].material) {
            TEST_ASSERT_EQUAL(made->frame[i], made->again[i]);
        } else if (!keyed) {
            TEST_ASSERT_TRUE(texel);
        } else {
            TEST_ASSERT_NOT_EQUAL(99, made->again[i]);
            TEST_ASSERT_NOT_EQUAL(made->scene.faces[face].material, made->again[i]);
        }
        drawn[0] += texel;
        drawn[1] += made->frame[i] == made->scene.faces[face].material && !texel;
    }
    TEST_ASSERT_GREATER_THAN(50, drawn[0]);
    TEST_ASSERT_EQUAL(keyed, drawn[1] > 50);
}

void test_textures_are_seen_where_they_are_nearest(void)
{
    static uint8_t plain[DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT]; /* without a key */
    for (uint32_t face = 0; face < DEPTH_SCENE_QUADS; face++) {
        memset(made->face_map, 0, sizeof made->face_map);
        made->texture.flags = 0;
        made->is_mapped = false;
        depth_scene_start_with(made, &fxl_palette_depth_16);
        depth_scene_draw(made, made->frame);
        set_texture(face);
        depth_scene_draw(made, made->again);
        check_textured(face, false);
        memcpy(plain, made->again, sizeof plain);
        made->texture.flags = FXL_TEXTURE_KEYED;
        made->texture.key = 99;
        depth_scene_draw(made, made->again);
        check_textured(face, true);
        for (uint32_t i = 0; i < DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT; i++) {
            TEST_ASSERT_EQUAL(plain[i] == 98, made->again[i] == 98);
        }
        memcpy(made->frame, made->again, sizeof made->frame);
        depth_scene_check_bands(made, &fxl_palette_depth_16);
    }
}

/* SPEC 10.4d, surfaces 4.2a */
void test_a_stippled_surface_keeps_depth_where_it_is_drawn(void)
{
    depth_scene_start_with(made, &fxl_palette_depth_16);
    depth_scene_draw(made, made->frame);
    set_texture(1);
    for (uint8_t opacity = 1; opacity < 16; opacity += 7) {
        made->surface.opacity = opacity;
        depth_scene_draw(made, made->again);
        uint32_t drawn = 0, through = 0, behind = 0;
        for (uint32_t i = 0; i < DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT; i++) {
            const bool texel = made->again[i] == 98 || made->again[i] == 99;
            const bool is_hole = made->frame[i] == made->scene.faces[1].material && !texel;
            drawn += texel;
            through += is_hole;
            behind += is_hole && made->again[i] != DEPTH_SCENE_BACKGROUND;
            TEST_ASSERT_TRUE(made->frame[i] == made->scene.faces[1].material || !texel);
        }
        TEST_ASSERT_INT_WITHIN(DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT / 50,
                               (drawn + through) * opacity / 16, drawn);
        TEST_ASSERT_GREATER_THAN(15, drawn);
        TEST_ASSERT_GREATER_THAN(15, through);
        TEST_ASSERT_GREATER_THAN(5, behind); /* faces that are drawn before and after it */
    }
}

/* Glass: face 2 shows what is beneath it in another colour, whatever is drawn first. */
/* SPEC 10.5a-c, surfaces 4.4b */
void test_a_blended_surface_is_seen_over_what_is_behind_it(void)
{
    static uint8_t beneath[DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT], table[FXL_BLEND_TABLE_BYTES(1)];
    for (uint32_t i = 0; i < sizeof table; i++) {
        table[i] = (uint8_t)(i ^ 0x80);
    }
    depth_scene_start_with(made, &fxl_palette_depth_16);
    depth_scene_draw(made, made->frame);
    memset(made->texels, 99, sizeof made->texels);
    made->texture.flags = FXL_TEXTURE_KEYED;
    made->texture.key = 99;
    set_texture(2);
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_render(&made->renderer, &depth_scene_eye, beneath, DEPTH_SCENE_WIDTH));
    made->surface.texture = 0;
    made->surface.flags = FXL_SURFACE_BLEND;
    made->set.blend = table;
    made->set.blend_first = made->scene.faces[2].material;
    made->set.blend_count = 1;
    const fxl_surface two[2] = {{.opacity = 16}, made->surface}; /* the blended one is the last */
    made->set.surfaces = two;
    made->set.surface_count = 2;
    made->mapped.surface = 1;
    set_texture(2);
    depth_scene_draw(made, made->again);
    uint32_t seen_through = 0;
    for (uint32_t i = 0; i < DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT; i++) {
        const bool is_glass = made->frame[i] == made->scene.faces[2].material;
        seen_through += is_glass && beneath[i] != DEPTH_SCENE_BACKGROUND;
        TEST_ASSERT_EQUAL(is_glass ? table[beneath[i]] : made->frame[i], made->again[i]);
    }
    TEST_ASSERT_GREATER_THAN(100, seen_through);
    memcpy(made->frame, made->again, sizeof made->frame);
    depth_scene_check_bands(made, &fxl_palette_depth_16);
}

/* The floor, and of the two panes those that the bits of `shown` name. */
static void draw_panes(uint32_t shown, uint8_t *frame)
{
    fxl_instance instances[DEPTH_SCENE_QUADS];
    uint16_t count = 0;
    depth_scene *fresh = depth_scene_make();
    const fxl_instance *all = fresh->scene.instances;
    instances[count++] = all[0];
    for (uint32_t pane = 1; pane <= 2; pane++) {
        fresh->face_map[pane] = 1;
        if (shown >> pane & 1u) {
            instances[count++] = all[pane];
        }
    }
    fresh->scene.instances = instances;
    fresh->scene.instance_count = count;
    fresh->surface = (fxl_surface){.flags = FXL_SURFACE_BLEND, .opacity = 16};
    fresh->set.blend = panes;
    fresh->set.blend_first = 20; /* the colours of the panes are 20 and 30 */
    fresh->set.blend_count = 11;
    fresh->is_mapped = true;
    depth_scene_start_with(fresh, &fxl_palette_depth_16);
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_render(&fresh->renderer, &depth_scene_eye, frame, DEPTH_SCENE_WIDTH));
}

/* Two panes that cross: in each pixel one covers the other, and both are seen. Each adds a number
 * to the colour beneath it, so the order does not matter. */
/* SPEC 10.5c, surfaces 4.4b */
void test_panes_that_cross_are_seen_through_each_other(void)
{
    static uint8_t frames[4][DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT];
    uint32_t through_both = 0;
    for (uint32_t i = 0; i < sizeof panes; i++) {
        panes[i] = (uint8_t)(i + (i < 256 ? 64 : 128));
    }
    for (uint32_t shown = 0; shown < 4; shown++) {
        draw_panes(2 * shown, frames[shown]);
    }
    for (uint32_t i = 0; i < sizeof frames[0]; i++) {
        const int beneath = frames[0][i], one = frames[1][i], other = frames[2][i];
        TEST_ASSERT_EQUAL_UINT8(one + other - beneath, frames[3][i]);
        TEST_ASSERT_TRUE(one == beneath || one == (beneath + 64) % 256);
        TEST_ASSERT_TRUE(other == beneath || other == (beneath + 128) % 256);
        through_both += one != beneath && other != beneath;
    }
    TEST_ASSERT_GREATER_THAN(100, through_both);
}
