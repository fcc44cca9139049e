/* SPDX-License-Identifier: MIT */
#include "benchmark.h"

#include <fixel.h>
#include <fixel/crc.h>
#include <stddef.h>

#include "cube_scene.h"
#include "plaza_scene.h"
#include "spin_scene.h"

#define WIDTH  320u
#define HEIGHT 240u
#define ROWS   16u /* of a band; the last one of a frame is full, too */

/* Units of 8 bytes for the renderer. More of them make frames that need it faster, and change no
 * pixel. */
#ifndef BENCHMARK_MEMORY
#define BENCHMARK_MEMORY PLAZA_MEMORY
#endif

typedef struct {
    const char *name;
    const fxl_scene *scene;
    const fxl_config *config;
    const fxl_pose *path;
    uint32_t frames;
} benchmark_scene;

static const benchmark_scene scenes[] = {
    {"cube", &cube_scene, &cube_config, cube_path, CUBE_FRAMES},
    {"spin", &spin_scene, &spin_config, spin_path, SPIN_FRAMES},
    {"plaza", &plaza_scene, &plaza_config, plaza_path, PLAZA_FRAMES},
};

static fxl_renderer renderer;
static uint64_t memory[BENCHMARK_MEMORY];
static uint8_t pixels[ROWS * WIDTH];

/* --- a line --------------------------------------------------------------------------------- */

#define LINE_BYTES 96u

typedef struct {
    char text[LINE_BYTES];
    uint32_t length; /* < LINE_BYTES */
} line;

static void add_character(line *to, char character)
{
    if (to->length < LINE_BYTES - 1u) {
        to->text[to->length++] = character;
        to->text[to->length] = '\0';
    }
}

static void add_text(line *to, const char *text)
{
    for (; *text != '\0'; text++) {
        add_character(to, *text);
    }
}

static void add_decimal(line *to, uint32_t number)
{
    char digits[10]; /* of 4294967295 */
    uint32_t count = 0;

    do {
        digits[count++] = (char)('0' + number % 10u);
        number /= 10u;
    } while (number != 0);
    while (count > 0) {
        add_character(to, digits[--count]);
    }
}

static void add_hexadecimal(line *to, uint32_t number)
{
    int32_t shift;

    for (shift = 28; shift >= 0; shift -= 4) {
        add_character(to, "0123456789abcdef"[(number >> shift) & 15u]);
    }
}

/* --- a scene -------------------------------------------------------------------------------- */

/* Draws a frame; adds the time to *spent, and the pixels to *crc. */
static fxl_status draw(const benchmark_port *port, const fxl_pose *pose, uint8_t background,
                       uint32_t *spent, uint32_t *crc)
{
    uint32_t begun = port->microseconds();
    fxl_status status = fxl_frame_begin(&renderer, pose);
    uint32_t row;

    for (row = 0; row < HEIGHT && status == FXL_OK; row += ROWS) {
        fxl_band band = {.pixels = pixels,
                         .width = WIDTH,
                         .stride = WIDTH,
                         .first_row = (uint16_t)row,
                         .rows = ROWS};

        fxl_fill_band(&band, background);
        status = fxl_frame_draw(&renderer, &band);
        *spent += port->microseconds() - begun; /* modulo 2^32 */
        if (status == FXL_OK) {
            status = fxl_band_crc(crc, &band);
        }
        begun = port->microseconds();
    }
    return status;
}

static bool measure(const benchmark_port *port, const benchmark_scene *scene)
{
    fxl_config config = *scene->config;
    uint32_t spent = 0; /* 2^32 microseconds are 71 minutes */
    uint32_t crc = FXL_CRC_START;
    line told = {.length = 0};
    uint32_t i;

    config.target = &fxl_palette; /* a byte a pixel, whatever a scene asks for */
    config.width = WIDTH;
    config.height = HEIGHT;
    if (fxl_renderer_init(&renderer, scene->scene, &config, memory, sizeof memory) != FXL_OK) {
        return false;
    }
    for (i = 0; i < scene->frames; i++) {
        if (draw(port, &scene->path[i], config.background, &spent, &crc) != FXL_OK) {
            return false;
        }
    }
    add_text(&told, "FIXEL,");
    add_text(&told, port->board);
    add_character(&told, ',');
    add_decimal(&told, port->hertz);
    add_character(&told, ',');
    add_text(&told, scene->name);
    add_character(&told, ',');
    add_decimal(&told, spent / scene->frames);
    add_character(&told, ',');
    add_hexadecimal(&told, crc);
    add_character(&told, '\n');
    port->print(told.text);
    return true;
}

bool benchmark_run(const benchmark_port *port)
{
    bool is_good = true;
    uint32_t i;

    for (i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
        is_good = measure(port, &scenes[i]) && is_good;
    }
    port->print("FIXEL,end\n");
    return is_good;
}
