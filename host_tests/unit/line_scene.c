/* SPDX-License-Identifier: MIT */
#include "line_scene.h"

#include <math.h>

tiny_scene *tiny;
fxl_renderer renderer;
fxl_lines attached;
fxl_line lines[2 * EDGES + 16];
uint32_t line_map[3];
fxl_line_set set;
uint64_t memory[4096];
uint64_t cells[FXL_DEPTH_BYTES(WIDTH, HEIGHT, 32) / 8];
uint16_t palette[256];
uint8_t frame[PIXELS];
int32_t far_by_near = FAR_BY_NEAR;

const fxl_pose ahead = {{0, 0, 0}, 0, 0, 0};

/* The other face of a cube, counted from 1, that has an edge of a face in the other direction. */
static uint16_t other_face(const fxl_model *model, uint32_t face, uint16_t a, uint16_t b)
{
    for (uint16_t i = 0; i < model->face_count; i++) {
        const fxl_face *other = &tiny->faces[model->first_face + i];
        const uint16_t *corners = fxl_face_indices(tiny->corners, other);
        for (uint32_t k = 0; k < 4 && i != face; k++) {
            if (corners[k] == b && corners[(k + 1) % 4] == a) {
                return (uint16_t)(i + 1);
            }
        }
    }
    return 0;
}

void make_edges(uint8_t width)
{
    uint32_t count = 0;
    tiny = tiny_make();
    for (uint32_t m = 0; m < 2; m++) {
        line_map[m] = count;
        const fxl_model *model = &tiny->models[m];
        for (uint16_t i = 0; i < model->face_count; i++) {
            const uint16_t *corners =
                fxl_face_indices(tiny->corners, &tiny->faces[model->first_face + i]);
            for (uint32_t k = 0; k < 4; k++) {
                const uint16_t a = corners[k], b = corners[(k + 1) % 4];
                if (a < b) {
                    lines[count] = (fxl_line){a,
                                              b,
                                              {(uint16_t)(i + 1), other_face(model, i, a, b)},
                                              (uint8_t)(LINE + count),
                                              width,
                                              0};
                    count++;
                }
            }
        }
    }
    line_map[2] = count;
    set = (fxl_line_set){lines, count, line_map};
    TEST_ASSERT_EQUAL_UINT32(2 * EDGES, count);
}

void make_free_edges(uint8_t width)
{
    make_edges(width);
    for (uint32_t i = 0; i < set.count; i++) {
        lines[i].faces[0] = lines[i].faces[1] = 0;
    }
}

fxl_config config_of(const fxl_target *target)
{
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, target);
    config.near_z = NEAR;
    config.far_z = NEAR * far_by_near;
    config.fov = DEGREES(90);
    config.background = BACKGROUND;
    config.palette = palette;
    config.depth = cells;
    config.depth_size = sizeof cells;
    return config;
}

void start_with(const fxl_config *config, uint32_t memory_size)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_init(&renderer, &tiny->scene, config, memory, memory_size));
}

void start(const fxl_target *target, bool has_lines)
{
    const fxl_config config = config_of(target);
    start_with(&config, sizeof memory);
    if (has_lines) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lines(&renderer, &attached, &set));
    }
}

void draw(const fxl_pose *pose, uint8_t *to)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, pose, to, WIDTH));
}

const fxl_target *const depths[2] = {&fxl_palette_depth_16, &fxl_palette_depth_32};

void begin_band(const fxl_pose *pose)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, pose));
    frame_draw_bands(&renderer, frame, HEIGHT, BACKGROUND);
}

/* The least whole number e for which 257/256 far <= 2^e near. */
static int exact_octaves(void)
{
    const fxl_lens *lens = &renderer.frame.view.lens;
    int octaves = 0;
    while (ldexp(lens->near_z, octaves) < lens->far_z * 257.0 / 256) {
        octaves++;
    }
    return octaves;
}

double exact_code_beyond(double depth, double other)
{
    const int octaves = exact_octaves(), octave = -1 - ilogb(other);
    int mantissa = 16;
    while (octaves << mantissa >= 65536) {
        mantissa--;
    }
    return ldexp(ldexp(depth, octave + 1) - 1 + octaves - 1 - octave, mantissa) + 1;
}

double exact_code(double depth)
{
    const double least = ldexp(1, -exact_octaves());
    const double held = depth < least ? least : depth;
    return depth >= 1 ? 65535 : exact_code_beyond(held, held);
}

void expect_code(double most, uint32_t bits, uint32_t code)
{
    const double kept = bits == 16 ? code : code / 65536.0;
    TEST_ASSERT_TRUE(kept < most + 0.1 && kept > most - (bits == 16 ? 1.1 : 0.1));
}
