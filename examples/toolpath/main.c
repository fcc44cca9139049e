/* G-code on the screen of its machine: the path of a tool about a part, drawn with depth in bands of 16 rows. The file is read anew
 * for each band and kept nowhere, so it may have any length: 16 KB of RAM hold it all. read_char is yours: it takes the next
 * character of the file, or a negative number at its end; from_start goes back. The ones below make a file of MOVES moves. */
#include <fixel.h>
#include <fixel/lines.h>
#include "cube_scene.h" /* tools/scene.py export --c examples/cube/cube.obj -o cube_scene.h */
#ifndef MOVES
#define MOVES 100000u /* a twisted vase: 100 moves a turn, a turn a layer */
#endif
#ifndef FRAMES
#define FRAMES 1
#endif
#define SIDE 128
#ifndef ROWS
#define ROWS 16
#endif
static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY_LEAST], cells[FXL_DEPTH_BYTES(SIDE, ROWS, 16) / 8];
static uint8_t pixels[ROWS][SIDE];

/* The file, made as it is read: "G1 Y6.789 Z0.010" and so on, in millimetres. A turn has 100 moves. */
static uint32_t move_number;
static fxl_q2_30 east, north; /* of the unit circle */
static char line[40];
static const char *at = line;

static char *put_number(char *to, char axis, int32_t thousandths)
{
    static const uint32_t units[] = {100000, 10000, 1000, 100, 10, 1};
    uint32_t value = (uint32_t)(thousandths < 0 ? -thousandths : thousandths);
    *to++ = ' ';
    *to++ = axis;
    if (thousandths < 0) { *to++ = '-'; }
    for (uint32_t i = 0; i < 6; i++) {
        char digit = '0';
        for (; value >= units[i]; value -= units[i]) { digit++; }
        if (i == 3) { *to++ = '.'; }
        *to++ = digit;
    }
    return to;
}

static void from_start(void)
{
    move_number = 0;
    east = FXL_Q2_30_ONE;
    north = 0;
    line[0] = '\0';
    at = line;
}

static int read_char(void)
{
    if (*at == '\0') {
        if (move_number == MOVES) { return -1; }
        const int64_t cosine = 1071623297, sine = 67420995; /* of a hundredth of a turn, in 2.30 */
        const fxl_q2_30 next = (fxl_q2_30)((east * cosine - north * sine) >> 30);
        const int32_t wave = (int32_t)(move_number / 100 % 200), side = (int32_t)(move_number % 50);
        const int32_t radius = 30000 + 60 * (wave < 100 ? wave : 200 - wave) + 60 * (side < 25 ? side : 50 - side);
        char *to = line;
        *to++ = 'G';
        *to++ = '1';
        to = put_number(to, 'X', (int32_t)(((int64_t)radius * east) >> 30));
        to = put_number(to, 'Y', (int32_t)(((int64_t)radius * north) >> 30));
        to = put_number(to, 'Z', (int32_t)(move_number / (MOVES / 1000 > 0 ? MOVES / 1000 : 1)) * 100);
        *to++ = '\n';
        *to = '\0';
        north = (fxl_q2_30)((north * cosine + east * sine) >> 30);
        east = next;
        if (++move_number % 100 == 0) {
            east = FXL_Q2_30_ONE;
            north = 0;
        }
        at = line;
    }
    return *at++;
}

/* A number behind an axis, in 16.16 units of 20 mm. *c becomes the character behind it. */
static fxl_q16_16 read_number(int *c)
{
    int32_t value = 0, digits = -1, sign = 1;
    for (*c = read_char(); *c == '-' || *c == '.' || (*c >= '0' && *c <= '9'); *c = read_char()) {
        if (*c == '-') { sign = -1; }
        else if (*c == '.') { digits = 0; }
        else if (digits < 3) { /* thousandths of a millimetre are enough */
            value = 10 * value + (*c - '0');
            digits += digits >= 0;
        }
    }
    for (digits = digits < 0 ? 0 : digits; digits < 3; digits++) { value *= 10; }
    return sign * (fxl_q16_16)((int64_t)value * 65536 / 20000);
}

/* Draws all moves of the file into a band. G-code has z upward, Fixel y. */
static fxl_status draw_moves(const fxl_band *band)
{
    fxl_world_line move = {{0, 0, 0}, {0, 0, 0}, 0, 1};
    fxl_status status = FXL_OK;
    bool is_first = true;
    int c;
    from_start();
    for (c = read_char(); c >= 0 && status == FXL_OK; c = read_char()) {
        for (; c >= 0 && c != '\n';) {
            if (c == 'X') { move.to.x = read_number(&c); }
            else if (c == 'Y') { move.to.z = read_number(&c); }
            else if (c == 'Z') { move.to.y = read_number(&c); }
            else { c = read_char(); }
        }
        move.colour = (uint8_t)(1 + (uint32_t)move.to.y / 65536 % 6);
        if (!is_first) { status = fxl_frame_draw_line(&renderer, NULL, &move, band); }
        is_first = false;
        move.from = move.to;
    }
    return status;
}

int main(void)
{
    fxl_config config = fxl_config_for(SIDE, SIDE, &fxl_palette_depth_16);
    config.depth = cells;
    config.depth_size = sizeof cells;
    if (fxl_renderer_init(&renderer, &cube_scene, &config, memory, sizeof memory)) { return 1; }
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        const fxl_pose eye = {.position = {0, FXL_UNITS(6), FXL_UNITS(-8)}, .pitch = FXL_DEGREES(-25)};
        if (fxl_frame_begin(&renderer, &eye)) { return 1; }
        for (uint16_t row = 0; row < SIDE; row += ROWS) {
            const fxl_band band = {.pixels = pixels[0], .width = SIDE, .stride = SIDE, .first_row = row, .rows = ROWS};
            fxl_frame_fill(&renderer, &band, config.background);
            if (fxl_frame_draw(&renderer, &band) || draw_moves(&band)) { return 1; }
            /* here the rows go to your display */
        }
    }
    return 0;
}
