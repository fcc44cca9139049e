# SPDX-License-Identifier: MIT
"""docs/examples.md and docs/looks.md: each program draws its picture, compiles for a small core and is as short as it says; each pair of
pictures is what its two commands draw, and the two halves differ."""

import re
import subprocess

import numpy
import own_tools
import pytest
from PIL import Image

from conftest import CHECKOUT
from fixel.base import picture
from fixel.image import image_surface
from fixel.report import examples, first_program
from fixel.scene import compiler, look

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "host/judge", "host/libfixel.a", "host/frames")
PAGE = (CHECKOUT / "docs" / "examples.md").read_text(encoding="utf-8")
ROWS = re.findall(r"^\| !\[(\w+)\]\(([\w./]+)\) \| \[(\w+)\]\(\.\./examples/(\w+)/(\w+\.c)\) \| (\d+) \| ", PAGE, re.MULTILINE)
NAMES = [row[0] for row in ROWS]
FLAGS = ["-std=c11", "-Wall", "-Wextra", "-Werror", f"-I{CHECKOUT / 'lib' / 'include'}"]
# Follows the walker of examples/maze: it keeps its radius from each wall, and ends beyond the maze.
WALK = """
#define main maze_main
#include "MAZE"
#undef main
#include <stdio.h>
static int frames, inside;
int show(const uint8_t *shown)
{
    (void)shown;
    for (int i = 0; i < SIDE * SIDE; i++) {
        const int64_t x = walker.centre.x - FXL_UNITS(i % SIDE * 2), z = walker.centre.z - FXL_UNITS(i / SIDE * 2);
        const int64_t beside_x = x < 0 ? -x - 65536 : x - 65536, beside_z = z < 0 ? -z - 65536 : z - 65536;
        const int64_t out_x = beside_x > 0 ? beside_x : 0, out_z = beside_z > 0 ? beside_z : 0;
        inside += map[i / SIDE][i % SIDE] == '#' && out_x * out_x + out_z * out_z < (int64_t)walker.radius * walker.radius;
    }
    return ++frames == 1000;
}
int main(void)
{
    const int failed = maze_main();
    printf("%d %d %d %d", failed, frames, inside, walker.centre.x > FXL_UNITS(2 * SIDE));
    return 0;
}
"""


def test_the_page_has_every_example_once():
    assert len(NAMES) >= 12 and sorted(NAMES) == sorted(folder.name for folder in (CHECKOUT / "examples").iterdir() if folder.is_dir())
    drawn = {*examples.PICTURES, *examples.BAND_PICTURES, *examples.BOX_PICTURES, *examples.PUMP_PICTURES, *examples.SIDE_PICTURES, *examples.WIDE_PICTURES}
    assert drawn == set(NAMES) - {"game"}
    assert sorted(file.stem for file in (CHECKOUT / "docs" / "examples").glob("*.png")) == \
        sorted(name for name in NAMES if examples.picture_of(name).parent.name == "examples")


@pytest.mark.parametrize("name, picture, same, folder, source, lines", ROWS, ids=NAMES)
def test_a_row_names_its_files(name, picture, same, folder, source, lines):
    assert name == same == folder and CHECKOUT / "docs" / picture == examples.picture_of(name)
    text = (CHECKOUT / "examples" / name / source).read_text(encoding="utf-8")
    assert len([line for line in text.splitlines() if line.strip()]) == int(lines)
    assert set(re.findall(r"(\d+) lines", text.partition("#include")[0])) <= {lines}    # what its own comment says


# More colours than this: of many cubes, of grain and light, of texels and smooth light, and more than a palette has.
COLOURS = {"crowd": 100, "crate": 20, "model": 100, "neon": 256}


@pytest.mark.parametrize("name", [*examples.PICTURES, *examples.BAND_PICTURES, *examples.BOX_PICTURES, *examples.PUMP_PICTURES, *examples.WIDE_PICTURES])
def test_an_example_draws_its_picture(build, name):
    if name in examples.WIDE_PICTURES:
        pixels = examples.draw_wide(build / "host" / "libfixel.a", name)
        drawn = picture.as_rgb(pixels, picture.rgb565_colours())
    else:
        pixels, palette = examples.draw_example(build / "host" / "libfixel.a", name)
        drawn = palette[pixels]
    assert len(numpy.unique(pixels)) > COLOURS.get(name, 1)
    assert numpy.array_equal(drawn, numpy.array(Image.open(examples.picture_of(name)).convert("RGB")))


def test_a_channel_of_a_picture_is_rounded_to_nearest():
    image = picture.as_rgb(numpy.array([[0xFFFF, 0, 1 << 11 | 1 << 5 | 1, 16 << 11 | 32 << 5 | 16]], "<u2"), picture.rgb565_colours())
    assert image.tolist() == [[[255, 255, 255], [0, 0, 0], [8, 4, 8], [132, 130, 132]]]


@pytest.mark.parametrize("name, least, most", [("crate", 50, 50), ("neon", 69, 69), ("turn", 1, 25)])
def test_it_is_as_short_as_a_document_says(name, least, most):
    lines = (CHECKOUT / "examples" / name / "main.c").read_text(encoding="utf-8").splitlines()
    assert least <= len([line for line in lines if line.strip() and not line.startswith("/*")]) <= most


def test_the_model_is_the_one_that_the_tool_makes(tmp_path):
    examples.write_own_scene(tmp_path)
    stored = (tmp_path / "model_scene.h").read_text(encoding="utf-8")
    assert "&fxl_rgb565_depth_16," in stored and "fxl_attach_surfaces" in stored and "fxl_attach_lit" in stored
    examples.write_model(tmp_path / "model.glb")
    examples.write_own_scene(tmp_path, tmp_path / "model.glb")
    assert (tmp_path / "model_scene.h").read_text(encoding="utf-8") == stored


@pytest.mark.parametrize("name", [*examples.PICTURES, *examples.BAND_PICTURES, *examples.BOX_PICTURES, *examples.PUMP_PICTURES, *examples.WIDE_PICTURES])
def test_an_example_compiles_for_a_small_core(tmp_path, name):
    examples.write_scene(tmp_path)
    examples.write_own_scene(tmp_path)
    examples.write_board_scene(tmp_path)
    subprocess.run(["arm-none-eabi-gcc", "-mcpu=cortex-m0", "-mthumb", *FLAGS, "-c", f"-I{tmp_path}",
                    str(CHECKOUT / "examples" / name / "main.c")], cwd=tmp_path, check=True)


@pytest.mark.parametrize("name", own_tools.INSTRUMENTS)
def test_an_instrument_draws_the_hosts_frames_in_16_kb(tmp_path, name):
    own_tools.draw_example("microbit", tmp_path, name)


@pytest.mark.parametrize("name", own_tools.WHOLE)
def test_whole_frames_of_an_example_are_the_hosts(tmp_path, name):
    own_tools.draw_example("mps2-an385", tmp_path, name)


# A whole turn, and the first frame of the next.
TURN_FRAMES = 121
TURN_SHOW = f"""
#include <stdint.h>
#include <stdio.h>
int show(const uint8_t *pixels);
int show(const uint8_t *pixels)
{{
    static int calls;
    if (calls > 0) {{ fwrite(pixels, 1, 320 * 240, stdout); }}
    return calls++ == {TURN_FRAMES};
}}
"""


def test_the_cube_turns(build, tmp_path):
    examples.write_scene(tmp_path)
    (tmp_path / "show.c").write_text(TURN_SHOW, encoding="utf-8")
    subprocess.run(["gcc", *FLAGS, f"-I{tmp_path}", str(CHECKOUT / "examples/turn/main.c"), "show.c", str(build / "host/libfixel.a"),
                    "-o", "turn"], cwd=tmp_path, check=True)
    done = subprocess.run([tmp_path / "turn"], capture_output=True, check=True)
    frames = numpy.frombuffer(done.stdout, numpy.uint8).reshape(TURN_FRAMES, 240, 320)
    assert (frames[0] == frames[120]).all() and len({frame.tobytes() for frame in frames[:120]}) == 120
    assert all((frame != frame[0, 0]).sum() > 3000 for frame in frames)


def test_the_walker_finds_out_of_the_maze(build, tmp_path):
    (tmp_path / "walk.c").write_text(WALK.replace("MAZE", str(CHECKOUT / "examples" / "maze" / "main.c")), encoding="utf-8")
    subprocess.run(["gcc", *FLAGS, "walk.c", str(build / "host/libfixel.a"), "-o", "walk"], cwd=tmp_path, check=True)
    said = subprocess.run(["./walk"], cwd=tmp_path, text=True, capture_output=True, check=True).stdout
    failed, frames, inside, out = map(int, said.split())
    assert failed == 0 and 100 < frames < 1000 and inside == 0 and out == 1, said


def test_show_of_the_page_writes_a_frame(build, tmp_path):
    show, = re.findall(r"```c\n(.*?)```", PAGE, re.DOTALL)
    (tmp_path / "show.c").write_text(show, encoding="utf-8")
    examples.write_scene(tmp_path)
    subprocess.run(["gcc", *FLAGS, f"-I{tmp_path}", str(CHECKOUT / "examples/turn/main.c"), "show.c", str(build / "host/libfixel.a"),
                    "-o", "turn"], cwd=tmp_path, check=True)
    subprocess.run(["./turn"], cwd=tmp_path, check=True)
    assert (tmp_path / "frame.pgm").read_bytes().startswith(b"P5 320 240 255\n")
    assert (tmp_path / "frame.pgm").stat().st_size == 15 + 320 * 240


# --- docs/looks.md ------------------------------------------------------------------

LOOKS_PAGE = (CHECKOUT / "docs" / "looks.md").read_text(encoding="utf-8")
LOOKS = re.findall(r"^\| !\[(\w+)\]\(looks/(\w+)\.png\) \| .* \| `([^`]+)`; `([^`]+)` \|$", LOOKS_PAGE, re.MULTILINE)


def test_the_page_has_every_pair_with_its_commands():
    assert [(name, wrong, right) for name, _, wrong, right in LOOKS] == [(name, wrong, right) for name, (wrong, right, _) in first_program.LOOKS.items()]
    assert all(name == file for name, file, *_ in LOOKS) and len(LOOKS) > 5
    assert sorted(file.stem for file in (CHECKOUT / "docs" / "looks").glob("*.png")) == sorted(first_program.LOOKS)


def test_the_page_shows_the_commands_of_a_half():
    assert f".venv/bin/fixel build docs/looks/open.toml --screen {first_program.SCREEN} --frames {first_program.FRAMES} -o open.fxls" in LOOKS_PAGE
    assert "--look backs" in LOOKS_PAGE and list(first_program.LOOKS).index("backs") == 2


@pytest.mark.parametrize("name", list(first_program.LOOKS))
def test_a_pair_is_what_the_page_shows(build, name):
    drawn = numpy.array(first_program.pair(build / "host" / "frames", name))
    assert numpy.array_equal(drawn, numpy.array(Image.open(CHECKOUT / "docs" / "looks" / f"{name}.png").convert("RGB")))
    width = (drawn.shape[1] - first_program.GAP) // 2
    differs = (drawn[:, :width] != drawn[:, -width:]).any(axis=2)
    assert differs.mean() > 0.01


CONE = "v 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nv 0 0 3\ng cone\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\nf 4 3 2 1\n"    # z points upward
STRAY = CONE + "v 90 0 0\nv 91 0 0\nv 90 1 0\nv 90 0 1\ng stray\nf 6 8 7\nf 6 7 9\nf 7 8 9\nf 8 6 9\n"


def cured(folder, text, cure="", key="[[objects]]\n"):
    """A SceneImage of the scene file that --write writes of a model, with a line of the table in it."""
    (folder / "m.obj").write_text(text, encoding="utf-8")
    written, _ = compiler.compile_scene(str(folder / "m.obj"), 4, look=look.Look(), write=str(folder / "s.toml"))
    assert key in written.text and cure.partition(" = ")[0] in LOOKS_PAGE
    made = written.text.replace(key, key + cure + "\n", 1) if key == "[[objects]]\n" else written.text.replace(key, cure, 1)
    (folder / "s.toml").write_text(made, encoding="utf-8")
    return compiler.compile_scene(str(folder / "s.toml"))[0]


def test_cures_without_a_picture(tmp_path):
    lying, standing = (max(cured(tmp_path, CONE, *cure).models[0].vertices, key=lambda vertex: vertex[1]) for cure in ((), ("rotation = [0, -90, 0]",)))
    assert standing[1] > 1.4 * lying[1] and abs(standing[0]) + abs(standing[2]) < 100     # the tip
    before, after = (cured(tmp_path, CONE, *cure).path[0] for cure in ((), ("start = 210", "start = 30")))
    assert all(abs(one + other) < 100 for one, other in zip((before[0], before[2]), (after[0], after[2])))
    assert [len(cured(tmp_path, STRAY, *cure).models[0].faces) for cure in ((), ('without = ["stray"]',))] == [9, 5]
    assert not cured(tmp_path, CONE).surfaces
    assert [kind.flags & image_surface.BLENDED for kind in cured(tmp_path, CONE, "blend = true").surfaces.surfaces] == [image_surface.BLENDED]


# The bands of examples/toolpath, each once it is drawn: when the next one is filled, and at the end.
TOOLPATH = """
#define main toolpath_main
#include "TOOLPATH"
#undef main
#include <stdio.h>
void __real_fxl_frame_fill(const fxl_renderer *of, const fxl_band *band, uint8_t colour);
void __wrap_fxl_frame_fill(const fxl_renderer *of, const fxl_band *band, uint8_t colour);
void __wrap_fxl_frame_fill(const fxl_renderer *of, const fxl_band *band, uint8_t colour)
{
    if (band->first_row > 0) { fwrite(pixels, 1, sizeof pixels, stdout); }
    __real_fxl_frame_fill(of, band, colour);
}
int main(void)
{
    const int failed = toolpath_main();
    fwrite(pixels, 1, sizeof pixels, stdout);
    return failed;
}
"""
RAM = 16 << 10      # of examples/toolpath, with 2 KB of it for the stack


def toolpath(build, folder, *flags):
    """The picture of examples/toolpath as entries of the palette."""
    (folder / "toolpath.c").write_text(TOOLPATH.replace("TOOLPATH", str(CHECKOUT / "examples" / "toolpath" / "main.c")), encoding="utf-8")
    subprocess.run(["gcc", *FLAGS, "-O2", *flags, f"-I{folder}", "toolpath.c", str(build / "host/libfixel.a"), "-Wl,--wrap=fxl_frame_fill",
                    "-o", "toolpath"], cwd=folder, check=True)
    return numpy.frombuffer(subprocess.run(["./toolpath"], cwd=folder, capture_output=True, check=True).stdout, numpy.uint8).reshape(128, 128)


def test_a_tool_path_of_any_length_is_drawn_in_bands(build, tmp_path):
    """Bands of any rows have the pixels of the frame that is drawn whole. The part in the vase is hidden by the moves before it."""
    examples.write_scene(tmp_path)
    drawn = toolpath(build, tmp_path)
    whole, palette = examples.draw_example(build / "host" / "libfixel.a", "toolpath")
    assert numpy.array_equal(drawn, whole)
    assert numpy.array_equal(palette[drawn], numpy.array(Image.open(examples.picture_of("toolpath")).convert("RGB")))
    assert not numpy.array_equal(drawn, toolpath(build, tmp_path, "-DMOVES=1000u"))


def test_a_tool_path_takes_16_kb_of_ram(tmp_path):
    examples.write_scene(tmp_path)
    subprocess.run(["arm-none-eabi-gcc", "-mcpu=cortex-m0", "-mthumb", *FLAGS, "-O2", "-c", f"-I{tmp_path}",
                    str(CHECKOUT / "examples" / "toolpath" / "main.c"), "-o", "toolpath.o"], cwd=tmp_path, check=True)
    said = subprocess.run(["arm-none-eabi-size", "toolpath.o"], cwd=tmp_path, text=True, capture_output=True, check=True).stdout
    _, data, bss, *_ = map(int, said.splitlines()[1].split()[:4])
    assert data + bss + (2 << 10) <= RAM, said
