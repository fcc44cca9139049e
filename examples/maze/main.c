/* A walk through a maze: a sphere slides along its walls. show is yours: it takes a frame of 320 x 240 entries of
 * palette. */
#include <fixel/all.h>
#define SIDE 9 /* cells of 2 x 2 units; the walker starts in row 1, column 1 */
#define AT(x, y, z) {FXL_UNITS(x), FXL_UNITS(y), FXL_UNITS(z)}
int show(const uint8_t *pixels); /* 0: another frame, please */
static const char map[SIDE][SIDE + 1] = {"#########", "#   #   #", "# # # # #", "# #   # #", "# ##### #",
                                         "# #   # #", "# # # # #", "#   #    ", "#########"};
static const fxl_point corners[8 + 4] = { /* of a wall; of the floor, about the middle of the maze */
    AT(-1, -1, -1), AT(1, -1, -1), AT(-1, 1, -1), AT(1, 1, -1), AT(-1, -1, 1), AT(1, -1, 1), AT(-1, 1, 1), AT(1, 1, 1),
    AT(-9, 0, -9), AT(-9, 0, 9), AT(9, 0, 9), AT(9, 0, -9)};
static const uint16_t indices[24 + 4] = {2, 3, 1, 0, 7, 6, 4, 5, 6, 2, 0, 4, 3, 7, 5, 1, 6, 7, 3, 2, 0, 1, 5, 4, 0, 1, 2, 3};
static const fxl_face faces[6 + 1] = { /* normal, corners, colour, first corner and where it is among the indices */
    {{0, 0, -FXL_Q2_30_ONE}, 4, 1, FXL_INDICES_AT(2, 0)}, {{0, 0, FXL_Q2_30_ONE}, 4, 1, FXL_INDICES_AT(7, 4)}, {{-FXL_Q2_30_ONE, 0, 0}, 4, 2, FXL_INDICES_AT(6, 8)},
    {{FXL_Q2_30_ONE, 0, 0}, 4, 2, FXL_INDICES_AT(3, 12)}, {{0, FXL_Q2_30_ONE, 0}, 4, 3, FXL_INDICES_AT(6, 16)}, {{0, -FXL_Q2_30_ONE, 0}, 4, 3, FXL_INDICES_AT(0, 20)},
    {{0, FXL_Q2_30_ONE, 0}, 4, 4, FXL_INDICES_AT(0, 24)}};
static const fxl_model models[2] = { /* first corner, corners, first face, faces, kind, the last but one: radius */
    {0, 8, 0, 6, FXL_MODEL_CONVEX, 0, 0, FXL_UNITS(2), 0}, {8, 4, 6, 1, FXL_MODEL_CONVEX, 0, 0, FXL_UNITS(13), 0}};
static fxl_instance instances[SIDE * SIDE + 1] = {{AT(8, -1, 8), 1, 0, 0}}; /* the floor, in layer 0 */
static fxl_scene scene = {.vertices = corners, .indices = indices, .faces = faces, .models = models, .instances = instances,
                          .vertex_count = 12, .index_count = 28, .face_count = 7, .model_count = 2, .instance_count = 1};
const uint8_t palette[256][3] = { /* for show: sky, walls, ground, map, walker, edges */
    {150, 190, 230}, {190, 110, 80}, {150, 84, 66}, {214, 140, 104}, {96, 120, 84}, {240, 240, 220}, {230, 50, 60}, {70, 44, 40}};
static fxl_renderer renderer;
static fxl_outlines outlines;
static uint64_t memory[2048];
static uint8_t pixels[240][320];
static fxl_sphere walker = {AT(2, 0, 2), FXL_RATIO(1, 2)};

int main(void)
{
    static const uint8_t marks[][2] = {{3, 1}, {3, 3}, {5, 3}, {5, 1}, {7, 1}, {7, 7}, {12, 7}}; /* column, row */
    static const fxl_outline_style edges = {.line = 7, .keeps_colours = true};
    const fxl_band whole = {.pixels = pixels[0], .width = 320, .stride = 320, .rows = 240};
    fxl_config config = fxl_config_default(320, 240);
    fxl_pose eye = {.yaw = FXL_DEGREES(90)}, aim = eye;
    fxl_camera camera;
    config.fov = FXL_DEGREES(80);
    for (int i = 0; i < SIDE * SIDE; i++) { /* the walls, in layer 1 */
        instances[scene.instance_count] = (fxl_instance){AT(2 * (i % SIDE), 0, 2 * (i / SIDE)), 0, 1, 0};
        scene.instance_count += map[i / SIDE][i % SIDE] == '#';
    }
    if (fxl_scene_check(&scene, NULL) || fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory) ||
        fxl_attach_outlines(&renderer, &outlines, &edges)) { return 1; }
    for (int next = 0; next < 7;) { /* it walks at each mark, and the walls in between turn it aside */
        const fxl_sphere mark = {AT(2 * marks[next][0], 0, 2 * marks[next][1]), FXL_UNITS(1)};
        next += fxl_spheres_overlap(&walker, &mark);
        aim.position = eye.position = walker.centre;
        if (fxl_pose_look_at(&aim, &mark.centre)) { return 1; }
        eye.yaw += aim.yaw - eye.yaw < FXL_DEGREES(180) ? (aim.yaw - eye.yaw) / 8 : 0u - (eye.yaw - aim.yaw) / 8;
        if (fxl_camera_from_pose(&eye, &camera)) { return 1; }
        const fxl_point move = {camera.axes.forward.x >> 17, 0, camera.axes.forward.z >> 17}; /* an eighth of a unit */
        if (fxl_slide_sphere(&scene, &walker, &move, NULL) || fxl_render(&renderer, &eye, pixels[0], 320)) { return 1; }
        for (int i = 0; i < SIDE * SIDE; i++) { /* the map, seen from above, with the walker on it */
            (void)fxl_draw_rectangle(&whole, 260 + i % SIDE * 6, 54 - i / SIDE * 6, 6, 6, map[i / SIDE][i % SIDE] == '#' ? 1 : 5);
        }
        (void)fxl_draw_rectangle(&whole, 261 + walker.centre.x * 3 / 65536, 55 - walker.centre.z * 3 / 65536, 4, 4, 6);
        if (show(pixels[0]) != 0) { break; }
    }
    return 0;
}
