/* A watch on a display of 240 x 240 pixels, for 16 KB of RAM. Of each second only the boxes in which a hand moved are drawn and sent.
 * display_send and display_pause are yours: the functions of a fxl_display_port, which reach the wires of your chip. */
#include <fixel/all.h>
enum { SIDE = 240, ROWS = 4, MARKS = 12, HANDS = 3, TURNED = MARKS + HANDS, DIAL_CORNERS = 24, START = (10 * 60 + 8) * 60 + 36, SECONDS = 60 };
bool display_send(void *user, bool is_data, const uint8_t *bytes, size_t size);
void display_pause(void *user, uint32_t milliseconds);
const uint8_t watch_palette[256][3] = {{14, 15, 20}, {236, 232, 222}, {58, 60, 70}, {92, 104, 128}, {44, 52, 70}, {216, 60, 44}, {160, 34, 26}};
#define AT(x, y) {FXL_RATIO(x, 16), FXL_RATIO(y, 16), 0} /* in sixteenths of a unit */
static fxl_point points[DIAL_CORNERS + 4 * 4] = { /* behind those of the dial: a mark, the hands of hours, minutes and seconds; 12 is at the top */
    [DIAL_CORNERS] = AT(-2, 72), AT(-2, 84), AT(2, 84), AT(2, 72), AT(0, -14), AT(-5, 0), AT(0, 48), AT(5, 0),
    AT(0, -14), AT(-4, 0), AT(0, 74), AT(4, 0), AT(0, -24), AT(-2, 0), AT(0, 80), AT(2, 0)};
static uint16_t indices[DIAL_CORNERS + 4 + 6]; /* of the dial, of a mark, of the two halves of a hand */
static fxl_face faces[2 + 2 * HANDS];
static fxl_model models[2 + HANDS];
static fxl_instance instances[1 + TURNED]; /* the dial, the marks, the hands */
static fxl_placement placements[TURNED];
static fxl_scene scene = {.vertices = points, .indices = indices, .faces = faces, .models = models, .instances = instances,
                                .vertex_count = DIAL_CORNERS + 16, .index_count = DIAL_CORNERS + 10, .face_count = 2 + 2 * HANDS, .model_count = 2 + HANDS,
                                .instance_count = 1 + TURNED, .placements = placements, .first_turned = 1, .placement_code = &fxl_turned_instances};
static fxl_renderer renderer;
static fxl_display display;
static fxl_pump pump;
static fxl_changed changed;
static uint64_t memory[192], bands[FXL_PUMP_MEMORY(SIDE, ROWS, 16)], kept[FXL_CHANGED_MEMORY(1 + TURNED, TURNED, 0, 0)];

/* Turns an instance clockwise: by so many parts of a turn that has `of` parts. */
static void turn(uint32_t number, uint32_t part, uint32_t of)
{
    const fxl_point axis = {0, 0, -1};
    (void)fxl_orientation_from_axis(&axis, (fxl_angle)(((uint64_t)part << 32) / of), &placements[number].orientation);
}
/* The hand of minutes moves each ten seconds, that of hours each minute. */
static void set_hands(uint32_t second)
{
    turn(MARKS, second / 60 % 720, 720);
    turn(MARKS + 1, second / 10 % 360, 360);
    turn(MARKS + 2, second % 60, 60);
}
static void make_face(uint32_t number, uint8_t corners, uint8_t colour, uint32_t first_index)
{
    faces[number] = (fxl_face){{0, 0, -FXL_Q2_30_ONE}, corners, colour, {0, 0, 0}};
    fxl_face_take_indices(&faces[number], indices, first_index);
}
static void make_watch(void)
{
    static const uint16_t halves[6] = {0, 1, 2, 2, 3, 0};
    for (uint16_t i = 0; i < DIAL_CORNERS; i++) {
        fxl_orientation way;
        (void)fxl_orientation_from_axis(&(fxl_point){0, 0, -1}, i * FXL_DEGREES(15), &way);
        points[i] = (fxl_point){(fxl_q16_16)((int64_t)way.y.x * 11 >> 15), (fxl_q16_16)((int64_t)way.y.y * 11 >> 15), 0}; /* 5.5 units */
        indices[i] = i;
    }
    for (uint16_t i = 0; i < 10; i++) { indices[DIAL_CORNERS + i] = i < 4 ? i : halves[i - 4]; }
    make_face(0, DIAL_CORNERS, 1, 0);
    make_face(1, 4, 2, DIAL_CORNERS);
    models[0] = (fxl_model){0, DIAL_CORNERS, 0, 1, FXL_MODEL_CONVEX, 0, 0, FXL_UNITS(6), 0};
    models[1] = (fxl_model){DIAL_CORNERS, 4, 1, 1, FXL_MODEL_CONVEX, 0, 0, FXL_UNITS(6), 0};
    for (uint32_t i = 0; i < HANDS; i++) {
        make_face(2 + 2 * i, 3, i < 2 ? 3 : 5, DIAL_CORNERS + 4);
        make_face(3 + 2 * i, 3, i < 2 ? 4 : 6, DIAL_CORNERS + 7);
        models[2 + i] = (fxl_model){DIAL_CORNERS + 4 + 4 * i, 4, 2 + 2 * i, 2, FXL_MODEL_CONVEX, 0, 0, FXL_UNITS(6), 0};
    }
    for (uint32_t i = 0; i < TURNED; i++) {
        placements[i] = (fxl_placement)FXL_PLACEMENT_NONE;
        instances[1 + i] = (fxl_instance){{0, 0, 0}, (uint16_t)(i < MARKS ? 1 : i - MARKS + 2), (uint8_t)(i < MARKS ? 1 : i - MARKS + 2), 0}; /* a layer each */
        turn(i, i, MARKS);
    }
}
int main(void)
{
    static const fxl_display_port port = {NULL, display_send, NULL, NULL, display_pause};
    const fxl_pose eye = {.position = {0, 0, FXL_UNITS(-10)}};
    const fxl_config config = fxl_config_default(SIDE, SIDE);
    const fxl_display_config module = fxl_display_config_turned(&fxl_module_st7789_240x240, 0);
    const fxl_pump_config pieces = {&display.pixels, SIDE, SIDE, ROWS, NULL};
    make_watch();
    if (fxl_scene_check(&scene, NULL) || fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory) ||
        fxl_display_open(&display, &module, &port, watch_palette[0]) || fxl_pump_init(&pump, &pieces, &display.sink, bands, sizeof bands) ||
        fxl_changed_init(&changed, kept, sizeof kept)) { return 1; }
    for (uint32_t second = START; second < START + SECONDS; second++) { /* here a watch waits for its next second, and has no end */
        set_hands(second);
        if (fxl_pump_changed(&pump, &renderer, &eye, &changed)) { return 2; }
    }
    return fxl_pump_wait(&pump) != FXL_OK;
}
