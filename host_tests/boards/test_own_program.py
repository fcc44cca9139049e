# SPDX-License-Identifier: MIT
"""make run PROGRAM=my.c: a program of the user's own, on boards and on the host."""

import json
import re

import numpy
import pytest
import own_tools
from conftest import CHECKOUT, run_cli, run_make
from PIL import Image

from fixel.board import dump, own_run, room
from fixel.scene import making
from test_export_setup import write_planet
import test_wires

BUILT_PROGRAMS = ("host/frames",)
HELLO = (CHECKOUT / "docs" / "hello.md").read_text(encoding="utf-8")
BLOCKS = dict(re.findall(r"```c\n/\* ([a-z]+\.[ch])\b[^\n]*\n(.*?)```", HELLO, re.DOTALL))
OVERLAY = """
#include <fixel.h>
#include <fixel/overlay.h>
#include "cube_scene.h"
static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY];
static uint8_t pixels[240][320];
int main(void)
{
    const fxl_band whole = {.pixels = pixels[0], .width = 320, .stride = 320, .rows = 240};
    fxl_config view = cube_config;
    view.target = &fxl_palette; /* a byte a pixel */
    if (fxl_renderer_init(&renderer, &cube_scene, &view, memory, sizeof memory)) { return 1; }
    for (int i = 0;; i++) {
        if (fxl_render(&renderer, &cube_path[i % CUBE_FRAMES], pixels[0], 320) ||
            fxl_draw_rectangle(&whole, 10 * i, 0, 10, 240, 1)) { return 1; }
    }
}
"""
RGB565 = """
#include <fixel/all.h>
#include "cube_scene.h"
static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY];
static uint16_t pixels[240][322], colours[256];
int main(void)
{
    fxl_config config = cube_config;
    for (int i = 0; i < 256; i++) { colours[i] = FXL_RGB565(cube_palette[i][0], cube_palette[i][1], cube_palette[i][2]); }
    config.target = &fxl_rgb565;
    config.palette = colours;
    return fxl_renderer_init(&renderer, &cube_scene, &config, memory, sizeof memory) ||
           fxl_render(&renderer, &cube_path[0], pixels[0], 322);
}
"""
# An exported scene in bands of RGB565. The text is drawn over each band, a border over the whole frame.
HUD = """
#include <fixel/all.h>
#include "cube_scene.h"
enum { ROWS = 16 };
static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY];
static uint16_t pixels[ROWS][320], colours[256];
static void clear(const fxl_band *band)
{
#ifdef BACKGROUND_OF_ITS_OWN
    for (int i = 0; i < band->rows * 320; i++) { pixels[i / 320][i % 320] = (uint16_t)(band->first_row + 7); }
#else
    fxl_frame_fill(&renderer, band, 0);
#endif
}
int main(void)
{
    const fxl_text_style style = {&fxl_font_5x7, 254, 0};
    fxl_config config = cube_config;
    for (int i = 0; i < 256; i++) { colours[i] = FXL_RGB565(cube_palette[i][0], cube_palette[i][1], cube_palette[i][2]); }
    colours[254] = 0xF81F;
    colours[255] = 0x07FF;
    config.target = &fxl_rgb565;
    config.palette = colours;
    if (fxl_renderer_init(&renderer, &cube_scene, &config, memory, sizeof memory)) { return 1; }
    for (int i = 0; i < 3; i++) {
        fxl_status status = fxl_frame_begin(&renderer, &cube_path[i]);
        for (uint16_t row = 0; status == FXL_OK && row < 240; row += ROWS) {
            const fxl_band band = {.pixels = (uint8_t *)pixels, .width = 320, .stride = 320, .first_row = row, .rows = ROWS,
                                   .palette = colours};
            clear(&band);
            status = fxl_frame_draw(&renderer, &band);
            if (fxl_draw_border(&band, 2, 2, 316, 236, 255) || fxl_draw_text(&band, 8, 8, "HUD", &style)) { return 2; }
        }
        if (status != FXL_OK) { return 3; }
    }
    return 0;
}
"""
# What a user adds to a scene: a planet that the program turns, a light that it moves, text over each band.
ADDED = """
static fxl_renderer *set_up(void);
static fxl_light_settings sun;
static uint16_t pixels[ROWS][320];
static fxl_status draw(fxl_renderer *renderer, const fxl_pose *eye, int frame)
{
    const fxl_text_style style = {&fxl_font_5x7, 1, 0};
    const char text[] = {'O', 'R', 'B', 'I', 'T', ' ', (char)('0' + frame), 0};
    fxl_status status = fxl_frame_begin(renderer, eye);
    for (uint16_t y = 0; status == FXL_OK && y < 240; y += ROWS) {
        const fxl_band band = {.pixels = (uint8_t *)pixels, .width = 320, .stride = 320, .first_row = y, .rows = ROWS, .palette = renderer->palette};
        fxl_frame_fill(renderer, &band, scene_config.background);
        status = fxl_frame_draw(renderer, &band);
        if (fxl_draw_border(&band, 2, 2, 316, 236, 2) || fxl_draw_text(&band, 8, 8, text, &style)) { return FXL_E_RANGE; }
    }
    return status;
}
int main(void)
{
    const fxl_point up = {0, 1, 0};
    fxl_renderer *const renderer = set_up();
    if (renderer == NULL) { return 1; }
    sun = scene_light;
    for (int frame = 0; frame < 3; frame++) {
        sun.ambient = scene_light.ambient + (frame << 27);
        if (fxl_orientation_from_axis(&up, (uint32_t)frame * FXL_DEGREES(40), &placement.orientation) ||
            fxl_attach_light(renderer, LIGHT, &sun) || draw(renderer, &scene_path[frame % SCENE_FRAMES], frame)) { return 2; }
    }
    return 0;
}
"""
INCLUDES = """#include <fixel.h>
#include <fixel/light.h>
#include <fixel/orientation.h>
#include <fixel/overlay.h>
#include "scene.h"
#define ROWS 16
static fxl_placement placement = FXL_PLACEMENT_NONE;
"""
PLANET_BY_SETUP = f"""{INCLUDES}
static fxl_setup it;
static uint64_t memory[SCENE_SETUP_MEMORY(ROWS)];
#define LIGHT &it.light
{ADDED}
static fxl_renderer *set_up(void)
{{
    if (fxl_setup_init(&it, &scene_setup, ROWS, memory, sizeof memory)) {{ return NULL; }}
    it.scene.placements = &placement;
    return &it.renderer;
}}
"""
PLANET_BY_HAND = f"""{INCLUDES}
static fxl_renderer renderer;
static fxl_scene scene;
static fxl_surfaces surfaces;
static fxl_lit_surfaces lit;
static fxl_light light;
static fxl_billboards stars;
static uint64_t memory[SCENE_MEMORY], cells[FXL_DEPTH_BYTES(320, ROWS, 16) / 8];
static uint16_t palette[256];
#define LIGHT &light
{ADDED}
static fxl_renderer *set_up(void)
{{
    fxl_config config = scene_config;
    for (int i = 0; i < 256; i++) {{ palette[i] = FXL_RGB565(scene_palette[i][0], scene_palette[i][1], scene_palette[i][2]); }}
    scene = scene_scene;
    scene.placements = &placement;
    config.target = &fxl_rgb565_depth_16;
    config.palette = palette;
    config.depth = cells;
    config.depth_size = sizeof cells;
    return fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory) ||
           fxl_attach_surfaces(&renderer, &surfaces, &scene_surfaces, FXL_SURFACES_OF(fxl_rgb565_depth_16)) ||
           fxl_attach_billboards(&renderer, &stars, &scene_billboards, FXL_SPRITES_OF(fxl_rgb565_depth_16)) ||
           fxl_attach_light(&renderer, &light, &scene_light) || fxl_attach_lit(&renderer, &lit) ? NULL : &renderer;
}}
"""
ON_STACK = """
#include <fixel.h>
#include "cube_scene.h"
static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY];
static int draw(const fxl_pose *eye)
{
    uint8_t pixels[40][60];
    fxl_config config = fxl_config_default(60, 40);
    return fxl_renderer_init(&renderer, &cube_scene, &config, memory, sizeof memory) || fxl_render(&renderer, eye, pixels[0], 60);
}
static int spoil(void)
{
    volatile uint8_t other[4000];
    for (int i = 0; i < 4000; i++) { other[i] = 3; }
    return other[7] - 3;
}
int main(void) { return draw(&cube_path[0]) || spoil(); }
"""


@pytest.fixture(name="folder", scope="module")
def fixture_folder(tmp_path_factory):
    """A folder with programs of the page, and the exported scene."""
    made = tmp_path_factory.mktemp("own")
    for name, text in BLOCKS.items():
        (made / name).write_text(text, encoding="utf-8")
    making.export(str(CHECKOUT / "examples/cube/cube.obj"), str(made / "cube_scene.h"), frames=60)
    return made


def run(folder, program, *words, text=None):
    """make run of a program: (what it said, its summary, its frames)."""
    if text:
        (folder / program).write_text(text, encoding="utf-8")
    out = folder / "out"
    done = run_make("run", f"PROGRAM={folder / program}", f"OUT={out}", *words)
    assert done.returncode == 0, done.stdout + done.stderr
    return done, json.loads((out / "summary.json").read_text()), dump.read_dump(out / "board.fxld").frames


@pytest.mark.parametrize("board", ["mps2-an385", "mps2-an505", "mps2-an500", "host"])
def test_a_program_draws_the_same_on_boards_of_each_kind(folder, board):
    done, summary, frames = run(folder, "loop.c", f"BOARD={board}", "FRAMES=3")
    assert summary["host_frames_equal"] and len(frames) == summary["frames"] == 3
    assert (summary["instructions_per_frame"]["min"] is None) == (board == "host")
    assert summary["frame_crc_all"] in done.stdout


def test_bands_and_whole_frames_are_one_picture(folder):
    _, whole, _ = run(folder, "main.c")
    _, bands, _ = run(folder, "bands.c")
    assert whole["frame_crc"] == bands["frame_crc"] and len(whole["frame_crc"]) == 1


def test_spilled_polygons_are_told_with_the_memory_that_ends_it(folder):
    """Of a program in bands; fxl_render computes each once."""
    for size, spills in (("LEAST", True), ("FAST", False)):
        done, summary, _ = run(folder, f"{size}.c", "BOARD=host", text=BLOCKS["bands.c"].replace("CUBE_MEMORY]", f"CUBE_MEMORY_{size}]"))
        assert (summary["polygons_spilled"] > 0) == spills == ("CUBE_MEMORY_FAST" in done.stdout), done.stdout
        assert done.stdout.splitlines()[-1].startswith(f"open {folder / 'out' / 'walk.gif'}")
    _, whole, _ = run(folder, "main.c", "BOARD=host")
    assert whole["polygons_spilled"] == 0


def test_what_is_drawn_over_a_frame_is_shown_and_a_loop_without_end_is_ended(folder):
    done, summary, frames = run(folder, "overlay.c", "BOARD=host", text=OVERLAY)
    assert summary["frames"] == 120 and "FRAMES= takes more than 120" in done.stdout
    assert all((frame.pixels[:, 10 * number:10 * number + 10] == 1).all() for number, frame in enumerate(frames[:30]))
    assert run(folder, "overlay.c", "BOARD=host", "FRAMES=130")[1]["frames"] == 130


def test_colours_of_16_bits_and_a_stride(folder):
    _, summary, frames = run(folder, "colours.c", text=RGB565)
    assert frames[0].pixels.dtype == numpy.uint16 and len(numpy.unique(frames[0].pixels)) > 3
    assert summary["host_frames_equal"]
    _, _, indices = run(folder, "loop.c", "FRAMES=1")
    assert len(numpy.unique(indices[0].pixels)) == len(numpy.unique(frames[0].pixels))


def test_what_is_drawn_over_bands_of_16_bits_is_shown(folder):
    """In each band, the last one of the last frame too."""
    _, summary, frames = run(folder, "hud.c", text=HUD)
    assert summary["host_frames_equal"] and len(frames) == 3
    for frame in frames:
        border = frame.pixels == 0x07FF
        assert border[2, 2:318].all() and border[237, 2:318].all() and border[2:238, 2].all() and border[2:238, 317].all()
        assert border.sum() == 2 * 316 + 2 * 234 and (frame.pixels[8:17, 8:40] == 0xF81F).sum() > 20
    assert len(numpy.unique(frames[0].pixels)) > 5, "the cube is there too"


@pytest.mark.parametrize("board", ["host", "mps2-an385"])
def test_a_display_shows_the_bands_of_a_program(folder, board):
    """What goes over the wires of DRIVER=, text over the bands too."""
    done, summary, frames = run(folder, "hud.c", f"BOARD={board}", "DRIVER=ili9341", text=HUD)
    assert summary["wires_frames_equal"] == 3 == len(frames) and "from the wires of an ili9341" in done.stdout
    assert summary["host_frames_equal"] and summary["sent_crc"] == summary["frame_crc"] and len(set(summary["frame_crc"])) == 3
    refused = run_make("run", f"PROGRAM={folder / 'hud.c'}", f"OUT={folder / 'small'}", f"BOARD={board}", "DRIVER=gc9a01")
    assert refused.returncode == 2 and "larger than it is" in refused.stdout + refused.stderr and not (folder / "small").exists()


def written_watch(folder, old="", new=""):
    """examples/watch, or a program with another text in it."""
    (folder / "watch").mkdir(exist_ok=True)
    text = (CHECKOUT / "examples/watch/main.c").read_text(encoding="utf-8")
    assert text.count(old) == 1 or not old
    (folder / "watch/main.c").write_text(text.replace("SECONDS = 60", "SECONDS = 12").replace(old, new), encoding="utf-8")
    return "watch"


def test_a_picture_is_made_of_the_boxes_that_changed(folder):
    """On the board, on the host and on the glass; it is that of the whole frame."""
    done, boxes, frames = run(folder, written_watch(folder), "BOARD=mps2-an385", "DRIVER=st7789_240x240")
    assert boxes["host_frames_equal"] and boxes["wires_frames_equal"] == 12 == len(set(boxes["wires_frame_sha256"]))
    drawn = [sum(columns * rows for _, columns, _, rows in frame.boxes) for frame in frames]
    assert drawn[0] == 240 * 240 and 0 < max(drawn[1:]) < drawn[0] // 2
    assert boxes["display_bytes"] == 115200 and boxes["display_bytes_by_boxes"] == round(2 * sum(drawn[1:]) / 11) and " came in boxes " in done.stdout
    _, whole, frames = run(folder, written_watch(folder, "fxl_pump_changed(&pump, &renderer, &eye, &changed)",
                                                 "fxl_pump_frame(&pump, &renderer, &eye)"), "BOARD=host", "DRIVER=st7789_240x240")
    assert whole["frame_crc"] == boxes["frame_crc"] and whole["wires_frame_sha256"] == boxes["wires_frame_sha256"]
    assert frames[1].boxes is None and whole["sent_crc"][0] == boxes["sent_crc"][0] and whole["sent_crc"][1:] != boxes["sent_crc"][1:]


# A watch of 128 x 64 or 128 x 128 pixels, whose seconds stand still every other frame.
SMALL = """
#define main watch_main
#include "WATCH"
#undef main
static fxl_renderer small;
static uint64_t room[512], sent[FXL_PUMP_MEMORY(128, 8, 8)];
int main(void)
{
    static const fxl_display_port port = {NULL, display_send, NULL, NULL, display_pause};
    const fxl_pose eye = {.position = {0, 0, FXL_UNITS(-10)}};
    const fxl_display_config module = fxl_display_config_default(&DRIVER_OF, 0);
    const fxl_config config = fxl_config_default(module.width, module.height);
    const fxl_pump_config pieces = {&display.pixels, module.width, module.height, 8, NULL};
    make_watch();
    if (fxl_scene_check(&scene, NULL) || fxl_renderer_init(&small, &scene, &config, room, sizeof room) ||
        fxl_display_open(&display, &module, &port, watch_palette[0]) || fxl_pump_init(&pump, &pieces, &display.sink, sent, sizeof sent) ||
        fxl_changed_init(&changed, kept, sizeof kept)) { return 1; }
    for (uint32_t i = 0; i < 6; i++) {
        set_hands(START + i / 2);
        if (fxl_pump_changed(&pump, &small, &eye, &changed)) { return 2; }
    }
    return 0;
}
"""


@pytest.mark.parametrize("driver", ["ssd1306", "sh1107", "ls013b7dh03", "ssd1327"])
def test_boxes_of_pages_greys_and_whole_rows_are_shown(folder, driver):
    """A frame in which nothing changed is one too."""
    text = SMALL.replace("WATCH", str(CHECKOUT / "examples/watch/main.c")).replace("DRIVER_OF", f"fxl_{driver}")
    _, summary, frames = run(folder, "small.c", "BOARD=host", f"DRIVER={driver}", text=text)
    assert summary["wires_frames_equal"] == 6 == len(frames) and len(set(summary["frame_crc"])) == 3
    assert [bool(frame.boxes) for frame in frames] == [True, False] * 3


# What a user puts into the program of an exported scene, so that it sends what changed.
SENDS_BOXES = """
static fxl_changed changed;
static fxl_pump pump;
static uint64_t kept[FXL_CHANGED_MEMORY(SCENE_INSTANCES, SCENE_PLACEMENTS, 0, 0)], sent[FXL_PUMP_MEMORY(128, ROWS, 0)];
static bool wait(void *user) { return user == NULL; }
static bool start(void *user, uint16_t row, uint16_t rows, const uint8_t *bytes, size_t size) { return row + rows > 0 && bytes != NULL && size > 0 && wait(user); }
static bool start_box(void *user, const fxl_screen_box *box, const uint8_t *bytes, size_t size) { return start(user, box->first_row, box->rows, bytes, size); }
static fxl_status draw_boxes(const fxl_pose *eye)
{
    const fxl_pump_sink sink = {NULL, start, wait, start_box, 0};
    const fxl_pump_config config = {NULL, 128, 64, ROWS, NULL};
    if (pump.buffer_size == 0 && (fxl_pump_init(&pump, &config, &sink, sent, sizeof sent) || fxl_changed_init(&changed, kept, sizeof kept))) { return FXL_E_ORDER; }
    return fxl_pump_changed(&pump, &it.renderer, eye, &changed);
}
int main(void)"""


def test_the_program_of_an_exported_scene_may_send_what_changed(tmp_path):
    """A thing that its motions turn, before a still eye."""
    (tmp_path / "still.toml").write_text(test_wires.STILL, encoding="utf-8")
    own = tmp_path / "own"
    own.mkdir()
    done = run_cli("export", "--c", tmp_path / "still.toml", "-o", own / "scene.h", "--name", "scene", "--program", own / "main.c")
    assert done.returncode == 0, done.stderr
    _, whole, frames = run(tmp_path, "own", "BOARD=host")
    assert all(frame.boxes is None for frame in frames) and whole["display_share_saved"] is None
    text = (own / "main.c").read_text(encoding="utf-8").replace('#include "scene.h"', '#include "scene.h"\n#include <fixel/all.h>')
    (own / "main.c").write_text(text.replace("if (draw(", "if (draw_boxes(").replace("static fxl_status draw(", "fxl_status draw(")
                                .replace("\nint main(void)", SENDS_BOXES), encoding="utf-8")
    _, boxes, frames = run(tmp_path, "own", "BOARD=mps2-an385")
    assert boxes["frame_crc"] == whole["frame_crc"] and len(set(whole["frame_crc"])) == len(frames) == 5
    assert boxes["host_frames_equal"] and boxes["display_share_saved"] > 0.5


def test_boxes_that_the_driver_does_not_take_are_refused(folder):
    text = SMALL.replace("WATCH", str(CHECKOUT / "examples/watch/main.c")).replace("DRIVER_OF", "fxl_ssd1327")
    (folder / "other.c").write_text(text, encoding="utf-8")
    done = run_make("run", f"PROGRAM={folder / 'other.c'}", f"OUT={folder / 'other'}", "BOARD=host", "DRIVER=sh1107")
    assert done.returncode == 2 and "own: a box could not be shown: DRIVER= may send other columns" in done.stdout + done.stderr


def test_columns_of_a_frame_that_is_not_compared_are_refused(folder):
    text = written_watch(folder, "fxl_pump_changed(&pump, &renderer, &eye, &changed)",
                         "fxl_frame_begin(&renderer, &eye) || fxl_pump_begin_box(&pump, &(fxl_screen_box){0, 120, 0, 240}) || "
                         "fxl_frame_draw(&renderer, fxl_pump_band(&pump))")
    done = run_make("run", f"PROGRAM={folder / text}", f"OUT={folder / 'other'}", "BOARD=host")
    assert done.returncode == 2 and "own: a band of some columns cannot be shown" in done.stdout + done.stderr


def test_a_background_of_the_programs_own_does_not_hide_a_band(folder):
    """Nobody sees when the program paints it into the next band: so the band is shown as the renderer has drawn it."""
    _, _, frames = run(folder, "sky.c", "BOARD=host", text="#define BACKGROUND_OF_ITS_OWN\n" + HUD)
    rows = numpy.arange(240) // 16 * 16 + 7
    assert (frames[2].pixels[:, 0] == rows).all() and (frames[2].pixels[:, 319] == rows).all()
    assert len(numpy.unique(frames[2].pixels)) >= 15 + 2


@pytest.mark.parametrize("board", ["host", "mps2-an385"])
def test_a_program_that_asks_for_keys_has_none_without_a_viewer(folder, board):
    text = BLOCKS["steer.c"].replace("for (;;) {", "for (int i = 0; i < 3; i++) {").replace("\n}\n", "\n    return 0;\n}\n")
    _, summary, frames = run(folder, "steered.c", f"BOARD={board}", text=text)
    assert summary["host_frames_equal"] and len(frames) == 3 and len(set(summary["frame_crc"])) == 1


@pytest.mark.parametrize("board", ["host", "mps2-an385"])
def test_pixels_on_the_stack_are_shown_before_they_are_gone(folder, board):
    _, _, frames = run(folder, "stack.c", f"BOARD={board}", text=ON_STACK)
    assert 1 < len(numpy.unique(frames[0].pixels)) and (frames[0].pixels != 3).mean() > 0.5


def test_a_folder_is_a_program(folder):
    """Also of files whose names differ only in what a name of an object cannot have, or has for something else."""
    inner = folder / "several"
    inner.mkdir()
    alike = {"a.b": "one", "a-b": "two", "a_b": "three"}
    for name, function in alike.items():
        (inner / f"{name}.c").write_text(f"void {function}(void); void {function}(void) {{ }}\n", encoding="utf-8")
    for name in ("bands.h", "cube_scene.h", "bands.c"):
        (inner / name).write_text((folder / name).read_text(encoding="utf-8"), encoding="utf-8")
    (inner / "display.c").write_text("#include <stdint.h>\nvoid one(void), two(void), three(void);\n"
                                     "void display_rows(uint16_t first, uint16_t rows, const uint8_t *pixels);\n"
                                     "void display_rows(uint16_t first, uint16_t rows, const uint8_t *pixels)\n"
                                     "{ (void)first; (void)rows; (void)pixels; one(); two(); three(); }\n", encoding="utf-8")
    _, summary, _ = run(folder, "several/")
    for source in inner.glob("*.c"):
        assert list((CHECKOUT / "build/boards").glob(f"*/own/{own_run.name_of(source)}.o")), source
    _, bands, _ = run(folder, "bands.c")
    assert summary["frame_crc"] == bands["frame_crc"], "with a display_rows of its own, too"


@pytest.mark.parametrize("name", own_tools.EXPORTED)
def test_the_program_of_an_exported_scene_draws_the_frames_of_make_run(tmp_path, name):
    own_tools.draw_exported("mps3-an547", tmp_path, name)


def test_a_setup_with_a_light_and_text_of_the_programs_own_draws_what_calls_by_hand_draw(tmp_path):
    """Smooth light, textures, billboards, RGB565 and depth in bands; what moves is the program's."""
    making.export(str(write_planet(tmp_path)), str(tmp_path / "scene.h"), "scene", 2)
    _, one, frames = run(tmp_path, "setup.c", "BOARD=mps3-an547", text=PLANET_BY_SETUP)
    _, other, _ = run(tmp_path, "hand.c", "BOARD=host", text=PLANET_BY_HAND)
    assert one["host_frames_equal"] and one["frame_crc"] == other["frame_crc"] and len(set(one["frame_crc"])) == 3
    assert all(len(numpy.unique(frame.pixels)) > 20 for frame in frames)


def test_pictures_have_the_colours_of_the_exported_scene(folder):
    run(folder, "main.c", "BOARD=host")
    with Image.open(folder / "out" / "frame_0000.png") as shown, Image.open(CHECKOUT / "docs" / "cube.png") as expected:
        assert numpy.array_equal(numpy.asarray(shown.convert("RGB")), numpy.asarray(expected.convert("RGB")))


@pytest.mark.parametrize("text, code, sentence", [
    ("int main(void) { return 3; }", 18, "own: main did not return 0"),
    ("int main(void) { return 0; }", 18, "own: main drew no frame"),
    # It waits until the watchdog ends it, in which an emulator takes no CPU time.
    ('#include "contract/system.h"\nint main(void) { system_text("mine\\n"); for (;;) {\n#ifdef __arm__\n__asm__ volatile("wfi");\n#endif\n} }', 50, "mine")])
def test_a_program_that_fails_says_so(folder, text, code, sentence):
    (folder / "failing.c").write_text(text, encoding="utf-8")
    done = run_make("run", f"PROGRAM={folder / 'failing.c'}", f"OUT={folder / 'failed'}", "BOARD=netduino2")
    assert done.returncode == 2 and f"Error {code}" in done.stderr and sentence in done.stdout + done.stderr, done.stderr
    assert not (folder / "failed").exists()


@pytest.mark.parametrize("linked, size, low, high", [(False, 100_000, 100_000, 100_000), (True, 16_000, 16_385, 30_000)])
def test_a_program_that_is_too_large_is_told_which_boards_have_the_room(folder, linked, size, low, high):
    """What it takes, what there is, and none of the linker's lines; where its arrays alone are too large, before it is linked."""
    (folder / "large.c").write_text(f"static char large[{size}]; int main(void) {{ large[7] = 1; return large[5]; }}", encoding="utf-8")
    done = run_make("run", f"PROGRAM={folder / 'large.c'}", "BOARD=microbit")
    errors = [line for line in done.stderr.splitlines() if not line.startswith(("make", "setup"))]
    assert done.returncode == 2 and len(errors) == 1 and "ld:" not in done.stderr, done.stderr
    needs, has = (int(each.replace(",", "")) for each in re.search(r"needs ([\d,]+) bytes of RAM, and BOARD=microbit has ([\d,]+);", errors[0]).groups())
    assert has == 16 * 1024 and low <= needs <= high
    assert (CHECKOUT / "build/boards/microbit" / f"own-{own_run.name_of(folder / 'large.c')}.map").exists() == linked
    named = errors[0].split("are: ")[1].split(";")[0].split()
    assert set(named) == {file.parent.name for file in (CHECKOUT / "boards").glob("*/board.mk") if file.parent.name != "host" and room.room(file.parent.name)["RAM"] >= needs}


def test_an_exported_scene_that_is_too_large_is_refused_before_it_is_linked(tmp_path):
    """Its tables are those of the header."""
    own = tmp_path / "own"
    own.mkdir()
    done = run_cli("export", "--c", CHECKOUT / "scenes/gallery.toml", "-o", own / "gallery.h", "--name", "gallery", "--program", own / "main.c", "--frames", "6000")
    assert done.returncode == 0, done.stderr
    done = run_make("run", f"PROGRAM={own}", "BOARD=microbit", f"OUT={tmp_path / 'out'}")
    error, = (line for line in done.stderr.splitlines() if line.startswith("error: "))
    needs, has = (int(each.replace(",", "")) for each in re.search(r"needs ([\d,]+) bytes of flash.* and BOARD=microbit has ([\d,]+)", error).groups())
    assert done.returncode == 2 and needs > 6000 * 24 and has == room.room("microbit")["FLASH"] and "mps2-an385" in error and "lm3s6965evb" not in error
    assert not list((CHECKOUT / "build/boards/microbit").glob(f"own-{own_run.name_of(own)}.*"))


def test_a_function_that_a_board_lacks_is_named_with_what_there_is_instead(folder):
    (folder / "prints.c").write_text('#include <stdio.h>\nint main(void) { return printf("%d", 7) < 0; }', encoding="utf-8")
    done = run_make("run", f"PROGRAM={folder / 'prints.c'}", "BOARD=microbit")
    (error,) = [line for line in done.stderr.splitlines() if line.startswith("error: ")]
    assert done.returncode == 2 and "prints.c:2" in done.stderr
    assert all(word in error for word in ("printf", "system_text", "contract/system.h", "BOARD=host")), error


def test_lines_of_the_linker_are_judged():
    has = room.room("microbit")
    stated, = re.findall(r"program_size=(\d+)K ", (CHECKOUT / "boards/microbit/board.mk").read_text(encoding="utf-8"))
    assert has == {"FLASH": int(stated) * 1024, "RAM": 16 * 1024}
    needs = room.needed("ld: region `FLASH' overflowed by 1000 bytes\nld: region `RAM' overflowed by 5000000 bytes", has)
    both = room.sentence("microbit", "x", needs, has)
    assert f"{has['FLASH'] + 1000:,} bytes of flash and 5,016,384 bytes of RAM" in both and "no board has so much" in both
    assert "docs/hello.md" in both and "docs/hello.md" not in room.sentence("microbit", "x", {"FLASH": needs["FLASH"]}, has)
    assert room.undefined("ld: `x' is in another section") == "" and room.undefined(2 * "undefined reference to `f'\n").count(" f,") == 1
    assert room.sentence("microbit", "x", room.needed("ld: undefined reference to `f'", has), has) is None


def test_lines_of_sizes_are_judged():
    """Functions may be left out, tables and arrays not; data that changes takes both."""
    said = "own.o  :\nsection  size  addr\n.text.main 900000 0\n.rodata 300000 0\n.rodata.str1.1 4000 0\n.data 10 0\n.bss 16380 0\n.debug_info 99999999 0\nTotal 1 \n"
    assert room.needed_by_objects(said, room.room("microbit")) == {"FLASH": 304_010, "RAM": 16_390}
    assert room.needed_by_objects(said, room.room("mps2-an385")) == {}


@pytest.mark.parametrize("words, sentence", [
    (["run", "PROGRAM=nowhere.c"], 'there is no PROGRAM "nowhere.c"; the programs are: walk game, and a C file or a folder'),
    (["run", "PROGRAM=docs"], 'there is no PROGRAM "docs"'),
    (["flash", "PROGRAM=examples/cube/main.c"], "make view, which show the pictures that it draws, and for make flash DRIVER="),
    (["view", "PROGRAM=nowhere.c"], 'there is no PROGRAM "nowhere.c"'),
    (["view", "PROGRAM=examples/cube/main.c", "SCENE=scenes/cube.toml"], "PROGRAM=examples/cube/main.c with SCENE=scenes/cube.toml"),
    (["view", "PROGRAM=examples/cube/main.c", "BOARD=pico"], "PROGRAM=examples/cube/main.c with BOARD=pico"),
    (["flash", "PROGRAM=examples/cube/main.c", "BOARD=pico", "DRIVER=st7789", "ROWS=8"], "PROGRAM=examples/cube/main.c chooses itself what it draws"),
    (["flash", "DRIVER=st7789"], "the boards that have one are: pico"), (["flash", "BOARD=pico", "DRIVER=st"], "the drivers are: gc9107"),
    (["run", "PROGRAM=examples/cube/main.c", "DEPTH=16"], "PROGRAM=examples/cube/main.c chooses itself what it draws")])
def test_what_make_refuses(words, sentence):
    done = run_make(*words)
    assert done.returncode == 2 and sentence in done.stderr and done.stdout == ""


@pytest.mark.parametrize("name", ["a b.c", "a;b.c", "a$b.c", "a%b.c", "a*.c", "a'b.c", "-a.c", "a:b.c"])
def test_a_path_that_the_shell_would_read_is_refused(tmp_path, name):
    (tmp_path / name).write_text("int main(void) { return 0; }\n")
    words = f"PROGRAM={name}" if name.startswith("-") else f"PROGRAM={tmp_path}/{name}"
    done = run_make("run", words)
    assert done.returncode == 2 and "there is no PROGRAM" in done.stderr and done.stdout == ""


@pytest.mark.parametrize("name", ["a b.c", "a;b.c", "a`b`.c", "a'b.c"])
def test_a_folder_with_a_file_that_the_shell_would_read_is_refused(tmp_path, name):
    (tmp_path / "main.c").write_text("int main(void) { return 0; }\n")
    (tmp_path / name).write_text("int other;\n")
    done = run_make("run", f"PROGRAM={tmp_path}")
    assert done.returncode == 2 and str(tmp_path) in done.stderr and "rename" in done.stderr and done.stdout == ""


def test_a_file_that_is_gone_is_not_linked(tmp_path):
    (tmp_path / "main.c").write_text("int more(void); int main(void) { return more(); }\n")
    (tmp_path / "more.c").write_text("int more(void); int more(void) { return 0; }\n")
    done = run_make("run", f"PROGRAM={tmp_path}", "BOARD=host")
    assert done.returncode == 2 and "drew no frame" in done.stderr
    (tmp_path / "more.c").unlink()
    done = run_make("run", f"PROGRAM={tmp_path}", "BOARD=host")
    assert done.returncode == 2 and "more" in done.stderr and "drew no frame" not in done.stderr
