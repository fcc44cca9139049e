/* SPDX-License-Identifier: MIT */
/* horizon: the level that a pixel shows, against the side of its ray, given the camera's rows. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fixel/camera.h"
#include "fixel/horizon.h"
#include "oracle/angle.h"
#include "oracle/claim.h"

#define UNIT  0x1p30L
#define BOUND 0x1p-20L
#define WIDTH 320
#define HEIGHT 240

/* What a sample draws: a row of a band from some column on, by the lens of a field of view. */
typedef struct {
    fxl_renderer renderer;
    fxl_horizon horizon;
    fxl_q2_30 sine;
    uint8_t colours[2], pixels[WIDTH];
    fxl_band band;
} sample;

static bool open_sample(const int64_t *numbers, sample *of)
{
    static fxl_target target;
    const fxl_pose pose = {{0, 0, 0}, (fxl_angle)numbers[0], (fxl_angle)numbers[1], (fxl_angle)numbers[2]};
    memset(of, 0, sizeof *of);
    target = fxl_palette;
    of->renderer.target = &target;
    of->colours[1] = 1;
    of->sine = (fxl_q2_30)numbers[6];
    of->horizon = (fxl_horizon){&of->sine, of->colours, 1};
    of->band = (fxl_band){.pixels = of->pixels, .width = WIDTH, .stride = WIDTH, .first_row = (uint16_t)numbers[4], .rows = 1,
                          .first_column = (uint16_t)numbers[5], .columns = (uint16_t)(WIDTH - numbers[5])};
    return fxl_lens_from_fov(WIDTH, HEIGHT, (fxl_angle)numbers[3], 65536, 64 * 65536, 0, &of->renderer.frame.view.lens) == FXL_OK &&
           fxl_camera_from_pose(&pose, &of->renderer.frame.view.camera) == FXL_OK &&
           fxl_attach_horizon(&of->renderer, &of->horizon) == FXL_OK;
}

/* The sine of the elevation of a column's ray, exact but for the last digits of a long double. */
static long double sine_of(const sample *of, uint32_t column)
{
    const fxl_lens *lens = &of->renderer.frame.view.lens;
    const fxl_axes *axes = &of->renderer.frame.view.camera.axes;
    /* place fill-rule: definition of a ray through the centre of a pixel */
    const int64_t x = column * INT64_C(65536) + 32768 - lens->centre_x, y = lens->centre_y - of->band.first_row * INT64_C(65536) - 32768;
    const int64_t rise = axes->right.y * x + axes->up.y * y + (int64_t)axes->forward.y * lens->focal;
    return rise / UNIT / sqrtl((long double)(x * x + y * y + (int64_t)lens->focal * lens->focal));
}

static void generate(oracle_random *random, oracle_input *input)
{
    static sample of;
    int64_t numbers[7];
    input->kind = (int)(input->index % 3);
    for (int i = 0; i < 3; i++) {
        numbers[i] = (int64_t)oracle_below(random, 1u << 16) << 16 | (int64_t)oracle_below(random, 1u << 16);
    }
    numbers[3] = FXL_FOV_MIN + (int64_t)oracle_below(random, FXL_FOV_MAX - FXL_FOV_MIN);
    numbers[4] = oracle_below(random, HEIGHT);
    numbers[5] = oracle_below(random, WIDTH);
    numbers[6] = 0;
    if (input->kind != 0 && open_sample(numbers, &of)) { /* the sine of a ray of the row, or nearly */
        const uint32_t column = (uint32_t)numbers[5] + oracle_below(random, WIDTH - (uint32_t)numbers[5]);
        const int64_t more = input->kind == 1 ? 0 : (int64_t)oracle_below(random, 16) - 8;
        numbers[6] = llrintl(sine_of(&of, column) * UNIT) + more;
        numbers[6] = numbers[6] > FXL_Q2_30_ONE ? FXL_Q2_30_ONE : numbers[6] < -FXL_Q2_30_ONE ? -FXL_Q2_30_ONE : numbers[6];
    }
    for (int i = 0; i < 7; i++) {
        oracle_put(input, numbers[i]);
    }
}

static oracle_outcome judge(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    static sample of;
    const int64_t *n = input->numbers;
    if (input->count != 7 || !oracle_are_angles(n, 4) || n[4] < 0 || n[4] >= HEIGHT || n[5] < 0 || n[5] >= WIDTH ||
        n[6] < -FXL_Q2_30_ONE || n[6] > FXL_Q2_30_ONE || !open_sample(n, &of)) {
        return ORACLE_UNUSABLE;
    }
    of.renderer.fill(&of.renderer, &of.band, 0);
    for (uint32_t column = of.band.first_column; column < WIDTH; column++) {
        const long double side = sine_of(&of, column) - of.sine / UNIT;
        if ((of.pixels[column - of.band.first_column] == 1) != (side >= 0)) {
            /* The horizon itself is exact. */
            verdict->value = fmax(verdict->value, of.sine == 0 ? ORACLE_REFUSED : (double)(fabsl(side) / BOUND));
            oracle_report(words, "level", of.pixels[column - of.band.first_column], side);
        }
    }
    return ORACLE_COUNTED;
}

const oracle_claim oracle_horizon = {
    .id = "horizon",
    .unit = "2^-20",
    .numbers = "yaw pitch roll, field of view, binary angles; row, first column; sine, 2.30",
    .kinds = {"the horizon", "the sine of a ray", "nearly that of one"},
    .generate = generate,
    .judge = judge,
};
