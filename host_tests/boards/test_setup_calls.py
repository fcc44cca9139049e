# SPDX-License-Identifier: MIT
"""docs/setup.md: every set-up call of the public headers is in the table once, answers what it says if it comes too early, and is
taken in the table's order."""

import re
import subprocess

import pytest
from conftest import CHECKOUT

from fixel.report import examples

BUILT_PROGRAMS = ("host/libfixel.a",)
PAGE = (CHECKOUT / "docs" / "setup.md").read_text(encoding="utf-8")
ROWS = re.findall(r"^\| (\d+) \| `(fxl_\w+)` \| [^|]+ \| ([\d, ]*) ?\| (?:`(FXL_E_\w+)`)? ?\|$", PAGE, re.MULTILINE)
DECLARED = re.compile(r"^fxl_status (fxl_\w+)\(", re.MULTILINE)
SETS_UP = re.compile(r"_(init|init_with|init_bare|open|attach|choose|set_clipper|set_centre|set_orthographic|set_colours|place)$|^fxl_attach_|"
                     r"^fxl_motion_begin$|^fxl_scene_check(_all)?$")
# They set nothing up: the first moves a lens, the second computes where a child is, the third sets a placement of an instance.
OTHERS = {"fxl_lens_set_centre", "fxl_placement_attach"}
FLAGS = ["-std=c11", "-Wall", "-Wextra", "-Werror", f"-I{CHECKOUT / 'lib' / 'include'}"]
RECORDS = """
#include <stdio.h>
#include <fixel/all.h>
#include "cube_scene.h"
static fxl_renderer renderer;
static fxl_world world;
static fxl_world_colours recolouring;
static fxl_light light;
static fxl_lit_surfaces lit;
static fxl_surfaces surfaces;
static fxl_billboards billboards;
static fxl_outlines outlines;
static fxl_lines lines;
static fxl_workspace second;
static fxl_motion_player motions;
static fxl_display display;
static fxl_pixels pixels;
static fxl_pump pump;
static fxl_wire wire;
static fxl_instance instances[4];
static fxl_world_slot slots[4];
static fxl_placement placements[4];
static fxl_draw_entry draw_list[8];
static uint64_t memory[4096], clip_memory[256], second_memory[1024], pump_memory[FXL_PUMP_MEMORY(320, 8, 16)], beam_memory[512];
static uint8_t ramp[FXL_LIGHT_RAMP_BYTES(2)], lit_colours[256], colours[256], frame[240][320];
static const fxl_surface wood = {.opacity = 16};
static const uint16_t face_map[6], model_map[1];
static const fxl_mapped_face mapped = {.corners = {0, 1, 2}};
static const fxl_corner corners[] = {{{0, 0}, 0, 0}, {{0, 0}, 1, 0}, {{0, 0}, 2, 0}};
static const fxl_surface_set set = {.surfaces = &wood, .faces = &mapped, .face_map = face_map, .corners = corners,
    .surface_count = 1, .face_count = 1, .corner_count = 3};
static const fxl_billboard_set boards = {.model_map = model_map};
static const fxl_beam beam = {.plane_count = 1};
static const fxl_light_settings day = {.ambient = FXL_Q2_30_ONE, .ramp = ramp, .levels = 2};
static const fxl_outline_style ink = {.line = 1};
static const uint32_t line_map[2];
static const fxl_line_set line_set = {NULL, 0, line_map};
static const fxl_q2_30 level[1];
static const uint8_t ground_and_sky[2] = {1, 2};
static const fxl_horizon sky = {level, ground_and_sky, 1};
static fxl_changed changed;
static uint64_t kept[FXL_CHANGED_MEMORY(4, 4, 0, 0)];
static bool send(void *user, bool is_data, const uint8_t *bytes, size_t size) { (void)user; (void)is_data; (void)bytes; return size > 0; }
static void wait_for(void *user, uint32_t milliseconds) { (void)user; (void)milliseconds; }
static bool start(void *user, uint16_t first, uint16_t rows, const uint8_t *bytes, size_t size)
{
    (void)user; (void)first; (void)rows;
    return send(NULL, true, bytes, size);
}
static bool wait(void *user) { (void)user; return true; }
static const fxl_pump_sink no_sink = {.start = start, .wait = wait};
static const fxl_display_port port = {NULL, send, NULL, NULL, wait_for};
static void say(const char *name, fxl_status status) { printf("%s %d\\n", name, (int)status); }
#define CALL(name, ...) say(#name, name(__VA_ARGS__))
"""
# Every record is all zeros, but for what the caller writes himself.
EARLY = """
int main(void)
{
    static fxl_scene scene;
    static fxl_scene_image image;
    static fxl_texture textures[1];
    static fxl_sprite sprites[1];
    static fxl_billboard shown[1];
    const fxl_config config = fxl_config_default(320, 240);
    const fxl_world_memory room = {instances, slots, placements, 2, 0, NULL, 0, NULL};
    const fxl_motion_memory moved = {instances, 4, placements, 4};
    const fxl_memory tables = {draw_list, 8, NULL, 0, NULL, 0};
    const fxl_motion_set still = {0};
    const fxl_beam_set beams = {&beam, 1, lit_colours};
    fxl_surface_set opened;
    fxl_billboard_set opened_boards;
    fxl_lens lens;
    scene = cube_scene;
    scene.draw_list_needed = 0; /* written as tables, and not checked */
    if (fxl_lens_from_fov(320, 240, FXL_DEGREES(60), FXL_RATIO(1, 4), FXL_UNITS(100), 0, &lens)) { return 1; }
    CALL(fxl_surfaces_open, &image, textures, 1, &opened, NULL);
    CALL(fxl_billboards_open, &image, sprites, shown, 1, &opened_boards, NULL);
    CALL(fxl_motion_begin, &motions, &still, &scene, &moved);
    CALL(fxl_world_init, &world, &scene, &room);
    CALL(fxl_renderer_init, &renderer, &scene, &config, memory, sizeof memory);
    CALL(fxl_renderer_init_with, &renderer, &scene, &lens, &tables);
    CALL(fxl_renderer_init_bare, &renderer, &scene, &lens, &tables);
    CALL(fxl_renderer_set_clipper, &renderer, &fxl_clipper_view, clip_memory, sizeof clip_memory);
    CALL(fxl_renderer_choose, &renderer, &config);
    CALL(fxl_renderer_set_centre, &renderer, FXL_UNITS(160), FXL_UNITS(120));
    CALL(fxl_renderer_set_orthographic, &renderer, FXL_UNITS(12));
    CALL(fxl_world_attach, &world, &renderer);
    CALL(fxl_world_set_colours, &world, &renderer, &recolouring);
    CALL(fxl_attach_surfaces, &renderer, &surfaces, &set, FXL_SURFACES_OF(fxl_palette));
    CALL(fxl_attach_lit, &renderer, &lit);
    CALL(fxl_attach_light, &renderer, &light, &day);
    CALL(fxl_attach_billboards, &renderer, &billboards, &boards, FXL_SPRITES_OF(fxl_palette));
    CALL(fxl_attach_beams, &renderer, &beams, beam_memory, sizeof beam_memory);
    CALL(fxl_attach_outlines, &renderer, &outlines, &ink);
    CALL(fxl_attach_lines, &renderer, &lines, &line_set);
    CALL(fxl_attach_horizon, &renderer, &sky);
    CALL(fxl_workspace_init, &second, &renderer, second_memory, sizeof second_memory);
    CALL(fxl_display_place, &display, 16, 16);
    CALL(fxl_pump_init, &pump, &(fxl_pump_config){&pixels, 320, 240, 8, NULL}, &no_sink, pump_memory, sizeof pump_memory);
    return 0;
}
"""
ORDERLY = """
int main(void)
{
    const fxl_config config = fxl_config_default(320, 240);
    const fxl_world_memory room = {instances, slots, placements, 2, 0, colours, 1, NULL};
    const fxl_display_config glass = fxl_display_config_default(&fxl_st7789, 1);
    const fxl_pose eye = {.position = {0, FXL_UNITS(2), FXL_UNITS(-8)}, .pitch = FXL_DEGREES(-12)};
    fxl_scene scene = cube_scene;
    CALL(fxl_scene_check, &scene, NULL);
    CALL(fxl_world_init, &world, &scene, &room);
    CALL(fxl_renderer_init, &renderer, &world.scene, &config, memory, sizeof memory);
    CALL(fxl_renderer_set_clipper, &renderer, &fxl_clipper_view, clip_memory, sizeof clip_memory);
    CALL(fxl_renderer_choose, &renderer, &config);
    CALL(fxl_renderer_set_centre, &renderer, FXL_UNITS(150), FXL_UNITS(120));
    CALL(fxl_world_attach, &world, &renderer);
    CALL(fxl_world_set_colours, &world, &renderer, &recolouring);
    CALL(fxl_attach_surfaces, &renderer, &surfaces, &set, FXL_SURFACES_OF(fxl_palette));
    CALL(fxl_attach_lit, &renderer, &lit);
    CALL(fxl_attach_light, &renderer, &light, &day);
    CALL(fxl_attach_billboards, &renderer, &billboards, &boards, FXL_SPRITES_OF(fxl_palette));
    CALL(fxl_attach_outlines, &renderer, &outlines, &ink);
    CALL(fxl_attach_lines, &renderer, &lines, &line_set);
    CALL(fxl_attach_horizon, &renderer, &sky);
    CALL(fxl_workspace_init, &second, &renderer, second_memory, sizeof second_memory);
    CALL(fxl_changed_init, &changed, kept, sizeof kept);
    CALL(fxl_display_open, &display, &glass, &port, cube_palette[0]);
    CALL(fxl_pixels_init, &pixels, &fxl_pixels_rgb565, cube_palette[0]);
    CALL(fxl_display_place, &display, 320, 240);
    CALL(fxl_pump_init, &pump, &(fxl_pump_config){&display.pixels, 320, 240, 8, NULL}, &display.sink, pump_memory, sizeof pump_memory);
    CALL(fxl_render, &renderer, &eye, frame[0], 320);
    CALL(fxl_frame_end, &renderer);
    CALL(fxl_pump_frame, &pump, &renderer, &eye);
    return 0;
}
"""


@pytest.fixture(scope="module", name="statuses")
def fixture_statuses():
    """Names of statuses by their number."""
    text = (CHECKOUT / "lib/include/fixel/types.h").read_text(encoding="utf-8")
    names = re.findall(r"^    (FXL_OK|FXL_E_\w+)", re.search(r"    FXL_OK = 0.*?\} fxl_status;", text, re.DOTALL)[0], re.MULTILINE)
    return dict(enumerate(names))


def said(folder, build, program):
    """(call, status) of each call of a program."""
    examples.write_scene(folder)
    (folder / "calls.c").write_text(RECORDS + program, encoding="utf-8")
    subprocess.run(["gcc", *FLAGS, "-Wno-unused", f"-I{folder}", "calls.c", str(build / "host/libfixel.a"), "-o", "calls"], cwd=folder,
                   check=True)
    lines = subprocess.run(["./calls"], cwd=folder, text=True, capture_output=True, check=True).stdout.splitlines()
    return [(line.split()[0], int(line.split()[1])) for line in lines]


def test_the_table_has_every_set_up_call_once():
    declared = {name for header in (CHECKOUT / "lib/include/fixel").glob("*.h")
                for name in DECLARED.findall(header.read_text(encoding="utf-8")) if SETS_UP.search(name)}
    assert sorted(call for _, call, _, _ in ROWS) == sorted(declared - OTHERS)
    assert len(ROWS) > 25 and [int(step) for step, *_ in ROWS] == sorted(int(step) for step, *_ in ROWS)


def test_a_call_comes_after_earlier_steps():
    for step, call, after, early in ROWS:
        assert all(int(before) < int(step) for before in after.split(", ") if before.strip()), call
        assert after.strip() or not early, call


def test_a_call_that_comes_too_early_is_refused_as_the_table_says(build, tmp_path, statuses):
    answers = {call: statuses[number] for call, number in said(tmp_path, build, EARLY)}
    assert answers == {call: early for _, call, _, early in ROWS if early}


def test_the_calls_in_their_order_are_taken(build, tmp_path, statuses):
    calls = said(tmp_path, build, ORDERLY)
    refused = [(call, statuses[number]) for call, number in calls if number]
    assert refused == []
    steps = {call: int(step) for step, call, _, _ in ROWS}
    made = [steps[call] for call, _ in calls if call in steps]
    assert made == sorted(made) and len(made) > 15
