/* A map of tiles with a walker: a billboard that goes behind what is nearer. show is yours: it takes a frame of 320 x 240 entries
 * of palette. */
#include <fixel/all.h>
#define SIDE 10 /* tiles of 1 x 1 unit */
#define AT(x, y, z) {FXL_UNITS(x) / 2, FXL_UNITS(y) / 2, FXL_UNITS(z) / 2} /* in half units */
int show(const uint8_t *pixels); /* 0: another frame, please */
static const char map[SIDE][SIDE + 1] = {"~~~~~~~~~~", "~........~", "~.##..^..~", "~.##.....~", "~....^.#.~",
                                         "~.^......~", "~....##..~", "~.#..##^.~", "~........~", "~~~~~~~~~~"};
static const char kinds[] = "~.^#"; /* water, grass, a rock, a house: models 0..3, of this height in half units: */
static const int heights[] = {1, 2, 4, 6};
static fxl_point corners[4 * 8 + 4]; /* boxes on the ground, then what stands for the walker */
static const uint16_t indices[24] = {2, 3, 1, 0, 7, 6, 4, 5, 6, 2, 0, 4, 3, 7, 5, 1, 6, 7, 3, 2, 0, 1, 5, 4};
static const fxl_direction normals[6] = {{0, 0, -FXL_Q2_30_ONE}, {0, 0, FXL_Q2_30_ONE}, {-FXL_Q2_30_ONE, 0, 0},
                                         {FXL_Q2_30_ONE, 0, 0}, {0, FXL_Q2_30_ONE, 0}, {0, -FXL_Q2_30_ONE, 0}};
static fxl_face faces[4 * 6 + 1];
static fxl_model models[5];
static fxl_instance instances[SIDE * SIDE + 1];
static fxl_scene scene = {.vertices = corners, .indices = indices, .faces = faces, .models = models, .instances = instances,
                          .vertex_count = 36, .index_count = 24, .face_count = 25, .model_count = 5, .instance_count = SIDE * SIDE + 1};
const uint8_t palette[256][3] = { /* for show: sky, then sides and top of each kind, then the walker */
    {24, 30, 52}, {40, 84, 150}, {34, 70, 130}, {60, 120, 190}, {92, 70, 44}, {76, 58, 38}, {92, 152, 70},
    {120, 116, 112}, {96, 94, 92}, {164, 160, 152}, {196, 168, 120}, {160, 132, 92}, {196, 74, 56}, {250, 214, 170}, {220, 60, 120}, {60, 40, 80}};
static const uint8_t figure[] = {0x00, 0xDD, 0x00, 0x00, 0xDD, 0x00, 0x0E, 0xEE, 0xE0, 0xDE, 0xEE, 0xED, 0x0E, 0xEE, 0xE0,
                                 0x0E, 0xEE, 0xE0, 0x0F, 0x0F, 0x00, 0x0F, 0x0F, 0x00}; /* 6 x 8 pixels of 4 bits */
static const uint8_t colours[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
static const fxl_sprite sprite = {figure, colours, 6, 8, 4, 0};
static const fxl_billboard board = {&sprite, FXL_RATIO(3, 4), FXL_UNITS(1), FXL_RATIO(3, 8), 0};
static const uint16_t model_map[5] = {0, 0, 0, 0, 1};
static const fxl_billboard_set set = {&board, 1, model_map};
static fxl_billboards billboards;
static fxl_renderer renderer;
static uint64_t memory[4096];
static uint8_t pixels[240][320];

static void make_scene(void)
{
    for (uint32_t i = 0; i < 32; i++) { corners[i] = (fxl_point)AT(i & 1 ? 1 : -1, i & 2 ? heights[i / 8] : 0, i & 4 ? 1 : -1); }
    for (uint32_t i = 0; i < 24; i++) {
        const uint16_t *of = &indices[i % 6 * 4]; /* the first corner, and where it is among the indices */
        faces[i] = (fxl_face){normals[i % 6], 4, (uint8_t)(1 + i / 6 * 3 + (i % 6 < 2 ? 0 : i % 6 < 4 ? 1 : 2)), {of[0], (uint16_t)(i % 6 * 4), 0}};
    }
    for (uint32_t i = 0; i < 5; i++) {
        models[i] = (fxl_model){i * 8, i < 4 ? 8 : 4, i * 6, i < 4 ? 6 : 1, FXL_MODEL_CONVEX, 0, 0, FXL_UNITS(4), 0};
    }
    for (uint32_t i = 0; i < 4; i++) { corners[32 + i] = (fxl_point)AT(i & 1 ? 1 : -1, i & 2 ? 2 : 0, 0); }
    faces[24] = (fxl_face){normals[0], 4, 13, {2, 0, 0}};
    for (int i = 0; i < SIDE * SIDE; i++) {
        uint16_t kind = 0;
        while (kinds[kind] != map[i / SIDE][i % SIDE]) { kind++; }
        instances[i] = (fxl_instance){AT(2 * (i % SIDE), 0, 2 * (i / SIDE)), kind, 0, 0};
    }
}

int main(void)
{
    static const int8_t ways[][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}; /* along the border of the island */
    fxl_config config = fxl_config_default(320, 240);
    const fxl_pose eye = {.position = {FXL_RATIO(-21, 4), FXL_UNITS(9), FXL_RATIO(-21, 4)}, .yaw = FXL_DEGREES(45), .pitch = FXL_PITCH_DIMETRIC};
    fxl_instance *walker = &instances[SIDE * SIDE];
    make_scene();
    *walker = (fxl_instance){AT(2, 2, 2), 4, 0, 0};
    if (fxl_scene_check(&scene, NULL) || fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory) ||
        fxl_renderer_set_orthographic(&renderer, FXL_UNITS(20)) ||
        fxl_attach_billboards(&renderer, &billboards, &set, FXL_SPRITES_OF(fxl_palette))) { return 1; }
    for (int step = 0;; step++) {
        walker->centre.x += ways[step / 56 % 4][0] * 8192; /* an eighth of a unit */
        walker->centre.z += ways[step / 56 % 4][1] * 8192;
        if (fxl_render(&renderer, &eye, pixels[0], 320)) { return 1; }
        if (show(pixels[0]) != 0) { break; }
    }
    return 0;
}
