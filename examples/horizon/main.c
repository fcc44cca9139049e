/* An attitude indicator on a display of 240 x 240 pixels: sky and ground by elevation, a runway, a pitch ladder and a tape of heights,
 * by a palette, in bands of 16 rows. 24 KB of RAM hold all of it, with both buffers of the pump; with ROWS 4 it takes 16 KB.
 * display_send and display_pause are yours: the functions of a fxl_display_port, which reach the wires of your chip. */
#include <fixel/all.h>
#ifndef ROWS
#define ROWS 16 /* of a band */
#endif
enum { SIDE = 240, FRAMES = 60, WHITE = 11, YELLOW, GREY, DARK };
bool display_send(void *user, bool is_data, const uint8_t *bytes, size_t size);
void display_pause(void *user, uint32_t milliseconds);
const uint8_t horizon_palette[256][3] = {
    {52, 30, 12}, {72, 44, 20}, {92, 60, 28}, {110, 74, 36}, {128, 90, 48}, /* ground, from straight down */
    {176, 204, 232}, {140, 182, 228}, {100, 156, 220}, {66, 126, 206}, {40, 92, 184}, /* sky, to straight up */
    {0, 0, 0}, {240, 240, 240}, {255, 212, 40}, {88, 92, 96}, {24, 28, 34}};
#define SINE(thousandths) (FXL_Q2_30_ONE / 1000 * (thousandths))
static const fxl_q2_30 sines[] = {-SINE(866), -SINE(500), -SINE(259), -SINE(87), 0, SINE(87), SINE(259), SINE(500), SINE(866)};
static const uint8_t levels[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
static const fxl_horizon horizon = {sines, levels, 9};
static const fxl_point points[4] = {{FXL_UNITS(-4), 0, FXL_UNITS(-60)}, {FXL_UNITS(-4), 0, FXL_UNITS(60)}, {FXL_UNITS(4), 0, FXL_UNITS(60)}, {FXL_UNITS(4), 0, FXL_UNITS(-60)}};
static const uint16_t indices[4] = {0, 1, 2, 3};
static const fxl_face faces[1] = {{{0, FXL_Q2_30_ONE, 0}, 4, GREY, FXL_INDICES_AT(0, 0)}};
static const fxl_model models[1] = {{0, 4, 0, 1, FXL_MODEL_CONVEX, 0, 0, FXL_UNITS(61), 0}};
static const fxl_instance instances[1] = {{{0, 0, FXL_UNITS(100)}, 0, 0, 0}}; /* the runway */
static fxl_scene scene = {.vertices = points, .indices = indices, .faces = faces, .models = models, .instances = instances,
                          .vertex_count = 4, .index_count = 4, .face_count = 1, .model_count = 1, .instance_count = 1};
static fxl_renderer renderer;
static fxl_display display;
static fxl_pump pump;
static uint64_t memory[96], bands[FXL_PUMP_MEMORY(SIDE, ROWS, 16)];
static const fxl_text_style small = {.font = &fxl_font_5x7, .colour = WHITE};

/* A number of up to four digits as text. */
static const char *text_of(int32_t number)
{
    static char text[6];
    char *to = &text[5];
    const bool is_below = number < 0;
    for (number = is_below ? -number : number; to == &text[5] || number > 0; number /= 10) { *--to = (char)('0' + number % 10); }
    if (is_below) { *--to = '-'; }
    return to;
}
/* The sine of an angle, times a number. */
static int32_t wave(fxl_angle angle, int32_t number)
{
    fxl_camera camera;
    const fxl_pose pose = {.yaw = angle};
    (void)fxl_camera_from_pose(&pose, &camera);
    return (int32_t)((int64_t)camera.axes.forward.x * number >> 30);
}
/* The point of the world 64 units from the eye along a camera's forward, and so many units to its right. */
static fxl_point beside(const fxl_point *eye, const fxl_axes *axes, int32_t units)
{
    const fxl_point at = {eye->x + (axes->forward.x >> 8) + (fxl_q16_16)((int64_t)axes->right.x * units >> 14),
                          eye->y + (axes->forward.y >> 8) + (fxl_q16_16)((int64_t)axes->right.y * units >> 14),
                          eye->z + (axes->forward.z >> 8) + (fxl_q16_16)((int64_t)axes->right.z * units >> 14)};
    return at;
}
/* A line of the world at each tenth degree of elevation, and what it is at its right end. */
static fxl_status draw_ladder(const fxl_band *band, const fxl_pose *eye)
{
    fxl_status status = FXL_OK;
    for (int32_t degrees = -40; degrees <= 40 && status == FXL_OK; degrees += 5) {
        const fxl_pose level = {eye->position, eye->yaw, (fxl_angle)(degrees * (int32_t)FXL_DEGREES(1)), 0};
        const int32_t width = degrees == 0 ? 30 : degrees % 10 == 0 ? 12 : 5;
        fxl_camera camera;
        fxl_screen_place end;
        if (fxl_camera_from_pose(&level, &camera)) { return FXL_E_RANGE; }
        const fxl_world_line rung = {beside(&eye->position, &camera.axes, -width), beside(&eye->position, &camera.axes, width), WHITE, 1};
        status = fxl_frame_draw_line(&renderer, NULL, &rung, band);
        if (width == 12 && status == FXL_OK && fxl_find_on_screen(&renderer.frame.view, &rung.to, &end) == FXL_OK && end.place == FXL_POINT_VISIBLE) {
            status = fxl_draw_text(band, (end.at.x >> 16) + 4, (end.at.y >> 16) - 3, text_of(degrees < 0 ? -degrees : degrees), &small);
        }
    }
    return status;
}
/* Heights on the right, a pixel a foot, the aeroplane's own in a box; and the aeroplane in the middle. */
static fxl_status draw_tape(const fxl_band *band, int32_t height)
{
    fxl_status status = fxl_draw_rectangle(band, SIDE - 40, 20, 40, SIDE - 40, DARK);
    for (int32_t mark = (height - 86) / 10 * 10; mark <= height + 95 && status == FXL_OK; mark += 10) {
        const int32_t row = SIDE / 2 + height - mark;
        status = fxl_draw_rectangle(band, SIDE - 40, row, mark % 50 == 0 ? 10 : 5, 1, WHITE);
        if (mark % 50 == 0 && (row < SIDE / 2 - 12 || row > SIDE / 2 + 12) && status == FXL_OK) { status = fxl_draw_text(band, SIDE - 26, row - 3, text_of(mark), &small); }
    }
    if (status) { return status; }
    (void)fxl_draw_rectangle(band, SIDE - 30, SIDE / 2 - 7, 30, 15, 10);
    (void)fxl_draw_border(band, SIDE - 30, SIDE / 2 - 7, 30, 15, YELLOW);
    (void)fxl_draw_text(band, SIDE - 26, SIDE / 2 - 3, text_of(height), &small);
    (void)fxl_draw_rectangle(band, 60, SIDE / 2 - 1, 36, 3, YELLOW);
    (void)fxl_draw_rectangle(band, 144, SIDE / 2 - 1, 36, 3, YELLOW);
    return fxl_draw_rectangle(band, SIDE / 2 - 2, SIDE / 2 - 2, 5, 5, YELLOW);
}
int main(void)
{
    static const fxl_display_port port = {NULL, display_send, NULL, NULL, display_pause};
    const fxl_display_config module = fxl_display_config_turned(&fxl_module_st7789_240x240, 0);
    const fxl_config config = fxl_config_default(SIDE, SIDE);
    const fxl_pump_config pieces = {&display.pixels, SIDE, SIDE, ROWS, NULL};
    if (fxl_scene_check(&scene, NULL) || fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory) ||
        fxl_attach_horizon(&renderer, &horizon) || fxl_display_open(&display, &module, &port, horizon_palette[0]) ||
        fxl_pump_init(&pump, &pieces, &display.sink, bands, sizeof bands)) { return 1; }
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        const fxl_angle turn = frame * (FXL_ANGLE_QUARTER / 15);
        const fxl_pose eye = {.position = {wave(turn, FXL_UNITS(3)), FXL_UNITS(6) + wave(turn, FXL_UNITS(2)), 0},
                              .yaw = (fxl_angle)wave(turn + FXL_ANGLE_QUARTER, (int32_t)FXL_DEGREES(10)),
                              .pitch = (fxl_angle)wave(2 * turn, (int32_t)FXL_DEGREES(18)),
                              .roll = (fxl_angle)wave(turn, (int32_t)FXL_DEGREES(40))};
        const fxl_band *band;
        if (fxl_frame_begin(&renderer, &eye) || fxl_pump_begin(&pump)) { return 2; }
        while ((band = fxl_pump_band(&pump)) != NULL) {
            fxl_frame_fill(&renderer, band, 0);
            if (fxl_frame_draw(&renderer, band) || draw_ladder(band, &eye) || draw_tape(band, 1200 + wave(turn, 140)) || fxl_pump_send(&pump)) { return 2; }
        }
    }
    return fxl_pump_wait(&pump) != FXL_OK;
}
