# SPDX-License-Identifier: MIT
"""An exported scene sets itself up: fxl_setup_init with NAME_setup draws what make run draws."""

import subprocess

import pytest

from board_programs import ROOT, made
from conftest import CHECKOUT
from fixel.board import dump, frame_crc
from fixel.check import frozen_frames
from fixel.image import image
from fixel.scene import compiler, making
from test_export import compiled, printed

SCENES = sorted(file.stem for file in (CHECKOUT / "scenes").glob("*.toml"))
FRAMES = 2

# Draws whole frames, then the same in bands of three rows; a scene without a path takes the poses of its arguments.
PROGRAM = """
#include <stdio.h>
#include <stdlib.h>
#include <fixel/crc.h>
#include "scene.h"
#include "scene.h"
enum { ROWS = 16 };
static const uint32_t most = 3; /* rows of a band */
static fxl_setup it;
static uint64_t memory[SCENE_SETUP_MEMORY(ROWS)];
static uint8_t pixels[1024 * 1024 * 2];
static const fxl_pose *eye_of(int frame, char **arguments)
{
    static fxl_pose pose;
    const fxl_pose *eye = fxl_setup_frame(&it, FXL_CAST(uint32_t, frame));
    if (scene_setup.path == NULL) {
        int32_t *const place[] = {&pose.position.x, &pose.position.y, &pose.position.z};
        fxl_angle *const angle[] = {&pose.yaw, &pose.pitch, &pose.roll};
        for (int i = 0; i < 3; i++) {
            *place[i] = FXL_CAST(int32_t, strtol(arguments[6 * frame + i], NULL, 10));
            *angle[i] = FXL_CAST(fxl_angle, strtoul(arguments[6 * frame + 3 + i], NULL, 10));
        }
        eye = &pose;
    }
    return eye;
}
int main(int count, char **arguments)
{
    const fxl_config *config = scene_setup.config;
    const size_t bytes = config->target->pixel_bits / 8u;
    (void)count;
    fxl_status status = fxl_setup_init(&it, &scene_setup, ROWS, memory, sizeof memory);
    if (status != FXL_OK) {
        printf("%d: %s\\n", it.step, fxl_setup_explain(&it, &scene_setup, ROWS, memory, sizeof memory));
        return 1;
    }
    for (int frame = 0; frame < 2; frame++) {
        const fxl_pose *eye = eye_of(frame, arguments + 1);
        uint32_t whole = FXL_CRC_START, bands = FXL_CRC_START;
        fxl_band band = fxl_band();
        band.pixels = pixels;
        band.width = band.stride = config->width;
        band.rows = config->height;
        band.palette = it.renderer.palette;
        status = fxl_render(&it.renderer, eye, pixels, config->width);
        if (status != FXL_OK || fxl_band_crc(&whole, &band) != FXL_OK || fxl_frame_begin(&it.renderer, eye) != FXL_OK) {
            printf("%s\\n", fxl_render_explain(&it.renderer, eye, pixels, config->width, NULL));
            return 2;
        }
        for (uint32_t row = 0; row < config->height; row += band.rows) {
            band.first_row = FXL_CAST(uint16_t, row);
            band.rows = FXL_CAST(uint16_t, config->height - row < most ? config->height - row : most);
            band.pixels = pixels + row * config->width * bytes;
            fxl_frame_fill(&it.renderer, &band, config->background);
            if (fxl_frame_draw(&it.renderer, &band) != FXL_OK || fxl_band_crc(&bands, &band) != FXL_OK) { return 3; }
        }
        printf("%08x %08x\\n", FXL_CAST(unsigned, whole), FXL_CAST(unsigned, bands));
    }
    return 0;
}
"""


@pytest.fixture(scope="module", params=SCENES, name="drawn")
def fixture_drawn(request, tmp_path_factory):
    """A scene: the folder with its header, the frames that the host draws of its image."""
    folder, source = tmp_path_factory.mktemp("setup"), CHECKOUT / "scenes" / f"{request.param}.toml"
    made("build/host/frames")
    making.build(str(source), str(folder / "scene.fxls"))
    scene, _ = compiler.compile_scene(str(source), None, None, None, "program")
    frames = len(scene.path) if scene.path_kind == image.POSES else None
    making.export(str(source), str(folder / "scene.h"), "scene", frames)
    return folder, frozen_frames.drawn_by_host(folder / "scene.fxls", ROOT / "build", folder).frames[:FRAMES]


@pytest.mark.parametrize("language", [["gcc", "-std=c11"], ["g++", "-std=c++11"]], ids=["c", "c++"])
def test_the_setup_draws_the_frames_of_make_run(drawn, language):
    folder, frames = drawn
    name = "main.c" if language[0] == "gcc" else "main.cpp"
    text = PROGRAM if name == "main.cpp" else PROGRAM.replace("fxl_band band = fxl_band();", "fxl_band band = {0};")
    program = compiled(folder, text, "-Wno-redundant-decls", compiler=language, name=name)
    poses = [str(number) for frame in frames for number in (*frame.position, *frame.angles)]
    crcs = frame_crc.drawn(frames).each
    assert printed(program, *poses).split() == [crcs[frame % len(crcs)] for frame in range(FRAMES) for _ in range(2)]
