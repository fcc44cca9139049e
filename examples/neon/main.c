/* A lamp flies along a wall of bricks, behind a pane of glass, in 16 bits a pixel: 71 lines. show is yours: it takes a frame of RGB565. */
#include <fixel.h>
#include <fixel/surfaces.h>
int show(const uint16_t *pixels); /* 0: another frame, please */
enum { COLUMNS = 8, ROWS = 6, WALL = COLUMNS * ROWS, PANE = WALL, GLOW, FACES }; /* light is linear over a face: so many squares */
static uint16_t pixels[240][320], bricks[32][32], glow[64][64];
static const uint16_t palette[256] = {FXL_RGB565(8, 8, 16), FXL_RGB565(40, 140, 255)}; /* the background, the glass */
static const uint8_t ramp[FXL_LIGHT_RAMP_BYTES(2)]; /* for flat faces in light, which this scene has not */
static const fxl_texture textures[2] = {
    {.texels = (const uint8_t *)bricks, .log_width = 5, .log_height = 5, .format = FXL_TEXTURE_565, .levels = 1},
    {.texels = (const uint8_t *)glow, .log_width = 6, .log_height = 6, .format = FXL_TEXTURE_565, .flags = FXL_TEXTURE_CLAMP, .levels = 1}};
static const fxl_surface kinds[3] = {{.texture = 1, .flags = FXL_SURFACE_LIT, .opacity = 16},
    {.flags = FXL_SURFACE_BLEND, .opacity = 16}, {.texture = 2, .flags = FXL_SURFACE_ADD, .opacity = 16}};
static const fxl_direction normal = {0, 0, -FXL_Q2_30_ONE};
static fxl_point vertices[4 * FACES];
static uint16_t indices[4 * FACES], face_map[FACES];
static fxl_face faces[FACES];
static fxl_mapped_face mapped[FACES];
static fxl_corner corners[4 * FACES];
static const fxl_model models[3] = { /* the wall, the glass, what shines */
    {.vertex_count = 4 * WALL, .face_count = WALL, .kind = FXL_MODEL_CONVEX, .radius = FXL_UNITS(17)},
    {.first_vertex = 4 * PANE, .vertex_count = 4, .first_face = PANE, .face_count = 1, .kind = FXL_MODEL_CONVEX, .radius = FXL_UNITS(8)},
    {.first_vertex = 4 * GLOW, .vertex_count = 4, .first_face = GLOW, .face_count = 1, .kind = FXL_MODEL_CONVEX, .radius = FXL_UNITS(4)}};
static fxl_instance instances[3] = {{.centre = {0, 0, FXL_UNITS(8)}}, {.centre = {FXL_UNITS(-1), 0, FXL_UNITS(4)}, .model = 1}, {.model = 2}};
static fxl_scene scene = {.vertices = vertices, .indices = indices, .faces = faces, .models = models, .instances = instances,
    .vertex_count = 4 * FACES, .index_count = 4 * FACES, .face_count = FACES, .model_count = 3, .instance_count = 3};
static fxl_renderer renderer;
static fxl_surfaces surfaces;
static fxl_lit_surfaces lit;
static fxl_light light;
static uint64_t memory[512];
/* Face i: a square with its upper left corner at (left, top), with so many texels along a side. */
static void put_face(int i, int left, int top, int size, int kind, int texels)
{
    for (int k = 0; k < 4; k++) {
        const int right = k == 1 || k == 2, low = k > 1;
        vertices[4 * i + k] = (fxl_point){FXL_UNITS(left + size * right), FXL_UNITS(top - size * low), 0};
        indices[4 * i + k] = (uint16_t)(i < WALL ? 4 * i + k : k);
        corners[4 * i + k] = (fxl_corner){{FXL_UNITS(texels * right), FXL_UNITS(texels * low)}, indices[4 * i + k], 0};
    }
    faces[i] = (fxl_face){.normal = normal, .count = 4, .material = 1}, fxl_face_take_indices(&faces[i], indices, 4u * (unsigned)i);
    mapped[i] = (fxl_mapped_face){(uint16_t)kind, {(uint16_t)(4 * i), (uint16_t)(4 * i + 1), (uint16_t)(4 * i + 2)}};
    face_map[i] = (uint16_t)(i + 1);
}
int main(void)
{
    const fxl_surface_set set = {textures, kinds, mapped, face_map, corners, &normal, 2, 3, FACES, 4 * FACES, 1, NULL, 0, 0};
    fxl_config config = fxl_config_for(320, 240, &fxl_rgb565);
    const fxl_pose eye = {.yaw = FXL_DEGREES(8), .pitch = FXL_DEGREES(3)};
    fxl_light_settings lamp = {.ambient = FXL_Q2_30_ONE / 16, .point_count = 1, .ramp = ramp, .levels = 2};
    for (int i = 0; i < 1024; i++) { /* bricks of two rows, each of a red of its own, that runs from side to side */
        const int x = (i + i / 512 * 16) % 32, y = i / 32 % 16, mortar = y == 0 || x == 0, grain = (x * 7 + y * 13) % 9;
        bricks[i / 32][i % 32] = mortar ? FXL_RGB565(150u, 146u, 138u) : FXL_RGB565(168u + (unsigned)(x + grain), 70u + (unsigned)(2 * y + grain), 48u + (unsigned)x);
    }
    for (int i = 0; i < 4096; i++) { /* brightest in the middle */
        const int x = i % 64 - 32, y = i / 64 - 32, far = x * x + y * y, near = far < 1024 ? (1024 - far) / 4 : 0;
        glow[i / 64][i % 64] = FXL_RGB565((unsigned)(near * near / 257), (unsigned)(near * near / 420), (unsigned)(near * near / 1100));
    }
    for (int i = 0; i < WALL; i++) { put_face(i, i % COLUMNS * 3 - 12, 9 - i / COLUMNS * 3, 3, 0, 64); }
    put_face(PANE, -3, 2, 4, 1, 1);
    put_face(GLOW, -2, 2, 4, 2, 64);
    config.palette = palette;
    if (fxl_scene_check(&scene, NULL) || fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory) ||
        fxl_attach_surfaces(&renderer, &surfaces, &set, FXL_SURFACES_OF(fxl_rgb565)) || fxl_attach_lit(&renderer, &lit)) { return 1; }
    for (int shown = 0; show(pixels[0]) == 0; shown++) {
        instances[2].centre = (fxl_point){FXL_UNITS(shown % 128 - 64) / 16, FXL_UNITS(1), FXL_UNITS(6)};
        lamp.points[0] = (fxl_point_light){instances[2].centre, FXL_UNITS(9), FXL_Q2_30_ONE};
        if (fxl_attach_light(&renderer, &light, &lamp) || fxl_render(&renderer, &eye, pixels[0], 320)) { return 1; }
    }
    return 0;
}
