# SPDX-License-Identifier: MIT
"""A program of the user's own in the live window: it is stepped and steered, says which face is at a pixel, and is built anew
when one of its files changes. build/view/own*.png is how the page looked."""

import base64
import io
import itertools
import re
import signal
import subprocess

import numpy
import pytest
from PIL import Image

from fixel.base import interpreter
from fixel.base.children import start
from fixel.board import own_run
from fixel.image import image as scene_image
from fixel.scene import making
from fixel.view import browser, view_own
from conftest import CHECKOUT
from viewers import HEIGHT, WIDTH, children, left, wait_for_rest

BUILT_PROGRAMS = ("host/live",)
SCENE = """
screen = { width = 320, height = 240 }
view = { fov = 60, near = 0.5, far = 40, inset = "4/65536", pixels = "rgb565" }
background = "#203040"
light = { direction = [0.3, -1, 0.7], ambient = 0.3 }
palette = { colours = ["#ff00ff"] }
path = { steps = [{ keys = [], frames = 1 }], start = { position = [0, 0, 0] } }
[[objects]]
solid = "box"
colour = "#e8a860"
position = [-1.2, 0.6, 5]
rotation = [20, 30, 0]
[[objects]]
solid = "box"
colour = "#60a8e8"
position = [1.2, 0.2, 6]
rotation = [-20, -30, 0]
"""
# In bands of RGB565. A key turns the eye. The first box is out of sight in every other frame if it MOVES.
PROGRAM = """
#include <fixel/all.h>
#include "cubes_scene.h"
#include "changed.h"
enum { ROWS = 16 };
uint32_t keys_held(void);
static fxl_setup it;
static uint64_t memory[CUBES_SETUP_MEMORY(ROWS)];
static uint16_t pixels[ROWS][320];
static fxl_instance instances[2];
static fxl_status draw(const fxl_pose *eye)
{
    const uint16_t width = cubes_config.width, height = cubes_config.height;
    fxl_status status = fxl_frame_begin(&it.renderer, eye);
    for (uint16_t row = 0; status == FXL_OK && row < height; row += ROWS) {
        const fxl_band band = {.pixels = (uint8_t *)pixels[0], .width = width, .stride = 320, .first_row = row,
                               .rows = ROWS < height - row ? ROWS : (uint16_t)(height - row), .palette = it.renderer.palette};
        fxl_frame_fill(&it.renderer, &band, cubes_config.background);
        status = fxl_frame_draw(&it.renderer, &band);
        (void)fxl_draw_rectangle(&band, 0, TOP, 320, 4, CUBES_RESERVED);
    }
    return status;
}
int main(void)
{
    fxl_pose eye = *cubes_setup.start;
    if (fxl_setup_init(&it, &cubes_setup, ROWS, memory, sizeof memory)) { return 1; }
    for (int i = 0; i < 2; i++) { instances[i] = cubes_scene.instances[i]; }
    it.scene.instances = instances;
    for (uint32_t frame = 0; frame != LAST; frame++) {
        if (keys_held() & FXL_KEY_RIGHT) { eye.yaw += FXL_DEGREES(2); }
        if (frame == CRASH) { *(volatile int *)0 = 1; }
        instances[0].centre.y = cubes_scene.instances[0].centre.y + (MOVES * frame % 2 ? FXL_UNITS(100) : 0);
        if (draw(&eye)) { return 2; }
    }
    return 0;
}
"""
CHANGED = {"TOP": "8", "MOVES": "0", "LAST": "0xFFFFFFFF", "CRASH": "0xFFFFFFFF"}
HUD = (255, 0, 255)
PIXEL = re.compile(r"Pixel \d+, \d+: colour (\d+), RGB (\d+) (\d+) (\d+); (?:instance (\d+), face (\d+)|background)$")


def change(folder, text="", **macros):
    """Writes the header that the program includes; not what it is already: the program would begin anew at any time."""
    lines, header = [f"#define {name} {value}\n" for name, value in {**CHANGED, **macros}.items()], folder / "changed.h"
    if not header.exists() or header.read_text(encoding="utf-8") != "".join(lines) + text:
        header.write_text("".join(lines) + text, encoding="utf-8")


def export(folder, screen=None):
    making.export(str(folder / "cubes.toml"), str(folder / "cubes_scene.h"), screen=screen)


@pytest.fixture(name="folder", scope="module")
def fixture_folder(tmp_path_factory):
    made = tmp_path_factory.mktemp("own")
    (made / "cubes.toml").write_text(SCENE, encoding="utf-8")
    (made / "cubes.c").write_text(PROGRAM, encoding="utf-8")
    export(made)
    change(made)
    return made


@pytest.fixture(name="programs", scope="module")
def fixture_programs(build, tmp_path_factory):
    """A folder of programs built, in which no other test builds a program meanwhile."""
    made = tmp_path_factory.mktemp("build")
    (made / "host").symlink_to(build / "host")
    return made


def words(folder):
    """Those of the command; make gives the program's name."""
    path = folder / "cubes.c"
    return "--program", f"own-{own_run.name_of(path)}", "--source", path


@pytest.fixture(name="window", scope="module")
def fixture_window(chromium, folder, programs):
    with browser.viewing("host", None, programs, words(folder)) as (process, address), \
            browser.page(chromium, address, WIDTH, HEIGHT) as page:
        page.set_default_timeout(0)
        yield process, address, page
        assert page.complaints == []
    assert not left(programs)


@pytest.fixture(name="page")
def fixture_page(window, folder):
    """The page, live, with the program as it was at first."""
    change(folder)
    page = window[2]
    page.wait_for_function("() => document.getElementById('state').textContent === 'live' && document.getElementById('banner').hidden")
    wait_for_row(page, 8)
    return page


@pytest.fixture(name="paused")
def fixture_paused(page):
    page.click("#pause")
    page.wait_for_selector("#state.paused")
    wait_for_rest(page)
    yield page
    page.click("#pause")
    page.wait_for_selector("#state.paused", state="detached")


def shown(page):
    """The picture: rows of RGB."""
    url = page.evaluate("document.getElementById('fixed').toDataURL()")
    return numpy.asarray(Image.open(io.BytesIO(base64.b64decode(url.partition(",")[2]))).convert("RGB"))


def number(page):
    return int(page.inner_text("#number").replace(",", ""))


def wait_for_row(page, row):
    """Until the program's own colour fills the row and the next three, and no row above."""
    while not ((picture := shown(page))[row:row + 4] == HUD).all() or (picture[:row] == HUD).all(axis=2).any():
        page.wait_for_timeout(50)


def wait_for_frame(page, least):
    page.wait_for_function("least => Number(document.getElementById('number').textContent.replace(/,/g, '')) >= least", arg=least)


def banner(page, word):
    """What the page says, once the word is in it."""
    page.wait_for_function("word => !document.getElementById('banner').hidden && "
                           "document.getElementById('banner').textContent.includes(word)", arg=word)
    return page.inner_text("#banner")


def told(page, x, y):
    """What the page says of a pixel: its colour, and (instance, face) or None."""
    width = page.eval_on_selector("#fixed", "canvas => canvas.getBoundingClientRect().width")
    page.hover("#fixed", position={"x": (x + 0.5) * width / 320, "y": (y + 0.5) * width / 320})
    page.wait_for_function(f"words => /^Pixel {x}, {y}:.*(face|background)/.test(document.getElementById('pixel-words').textContent)")
    colour, *rest = PIXEL.match(page.inner_text("#pixel-words")).groups()
    rgb, picked = tuple(map(int, rest[:3])), rest[3:]
    return int(colour), rgb, None if picked[0] is None else tuple(map(int, picked))


def test_what_the_program_draws_over_its_bands_is_in_the_picture(page, build):
    picture = shown(page)
    assert page.inner_text("#board") == "host" and "cubes.c, 320 × 240" in page.inner_text("#scene")
    assert (picture[8:12] == HUD).all() and not (picture[12:] == HUD).all(axis=2).any()
    assert page.is_hidden("#beside-choice")
    (build / "view").mkdir(exist_ok=True)
    page.screenshot(path=str(build / "view" / "own.png"))


def test_a_pixel_is_told_with_its_face(paused, folder):
    """Of the frame that is shown, the first: the program has moved a box out of sight for the next one when it is asked. The
    scene has light of its tool alone, so a pixel has its face's colour."""
    change(folder, MOVES="1", TOP="20")
    wait_for_row(paused, 20)
    assert number(paused) == 0
    image = folder / "cubes.fxls"
    making.build(str(folder / "cubes.toml"), str(image))
    scene, faces = scene_image.load(image), set()
    for x, y in ((70, 80), (100, 60), (110, 95), (200, 100), (230, 110), (220, 140), (5, 200), (160, 30)):
        colour, rgb, face = told(paused, x, y)
        assert rgb == tuple(map(int, shown(paused)[y, x]))
        expected = scene.palette[scene.background if face is None else
                                 scene.models[scene.objects[face[0]].model].faces[face[1]].colour]
        assert colour == int(expected[0]) >> 3 << 11 | int(expected[1]) >> 2 << 5 | int(expected[2]) >> 3
        faces.add(face)
    assert None in faces and {face[0] for face in faces if face} == {0, 1} and len(faces) >= 5
    assert told(paused, 100, 21)[0] == 0xF81F, "the colour is that of the picture"
    paused.mouse.move(0, 0)


def test_a_step_is_one_frame_and_a_key_turns_the_eye(paused):
    yaw = paused.inner_text("#yaw")
    paused.keyboard.down("ArrowRight")
    before = number(paused)
    for step in range(1, 4):
        paused.click("#step")
        wait_for_frame(paused, before + step)
        assert number(paused) == before + step
    paused.wait_for_function("before => document.getElementById('yaw').textContent !== before", arg=yaw)
    paused.keyboard.up("ArrowRight")


def test_a_change_of_a_header_builds_and_starts_the_program_anew(page, folder):
    wait_for_frame(page, 30)
    change(folder, TOP="60")
    wait_for_row(page, 60)
    assert page.is_hidden("#banner")


def test_a_scene_of_another_size_is_taken_over(page, folder):
    export(folder, (160, 120))
    page.wait_for_function("() => document.getElementById('scene').textContent.includes('160 × 120')")
    while shown(page).shape != (120, 160, 3):
        page.wait_for_timeout(50)
    export(folder)
    page.wait_for_function("() => document.getElementById('scene').textContent.includes('320 × 240')")
    wait_for_row(page, 8)


def test_a_compile_error_is_told_while_the_program_before_runs_on(page, folder, build):
    change(folder, "int broken = nowhere;\n")
    said = banner(page, "changed.h")
    assert "changed.h:5" in said and "nowhere" in said and "cubes.c was not built" in said
    wait_for_frame(page, number(page) + 5)
    page.screenshot(path=str(build / "view" / "own-broken.png"))
    change(folder, TOP="100")
    wait_for_row(page, 100)
    page.wait_for_selector("#banner", state="hidden")


def test_a_program_that_crashes_says_so_and_its_last_frame_stays(page, folder, build):
    change(folder, CRASH="5")
    assert "SIGSEGV" in banner(page, "crashed")
    assert page.inner_text("#state") == "stopped" and number(page) == 3, "frame 4 would be shown when the next one begins"
    assert (shown(page)[8:12] == HUD).all()
    page.screenshot(path=str(build / "view" / "own-crashed.png"))
    page.keyboard.press("Home")     # it crashes again
    banner(page, "crashed")
    change(folder)
    page.wait_for_selector("#banner", state="hidden")
    wait_for_frame(page, 10)


def test_a_program_that_ends_says_so(page, folder):
    change(folder, LAST="1")
    said = banner(page, "ended")
    assert "1 frame:" in said and "main returned 0" in said
    page.wait_for_function("document.getElementById('number').textContent === '0'")     # frames of the one before may still come
    change(folder, LAST="0")    # now it draws none
    assert "main drew no frame" in banner(page, "drew no frame")


def test_a_program_that_has_ended_begins_again(paused, folder):
    change(folder, LAST="2", TOP="28")
    wait_for_row(paused, 28)
    for next_one in ("1", "0", "1", "0"):
        paused.click("#step")
        paused.wait_for_function("one => document.getElementById('number').textContent === one", arg=next_one)
    change(folder)
    wait_for_row(paused, 8)


def test_copies_that_keep_frames_end_with_their_frames(page, window):
    """One of the program and one of its newest frame."""
    wait_for_frame(page, 30)
    found = [command for command in children(window[0].pid).values() if "own-" in command]
    assert 1 <= len(found) <= 3, found


def test_a_program_that_does_not_compile_at_first_is_waited_for(folder, programs, tmp_path):
    for name in ("cubes.c", "cubes_scene.h"):
        (tmp_path / name).write_bytes((folder / name).read_bytes())
    before = left(programs)
    process = start([*interpreter.command("view"), "--board", "host", "--build", programs, *words(tmp_path)], signal.SIGTERM,
                    stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    try:
        lines = iter(process.stdout.readline, "")
        assert "changed.h" in " ".join(itertools.takewhile(lambda line: "Waiting until" not in line, lines))
        change(tmp_path, LAST="0")
        assert any("main drew no frame" in line for line in itertools.takewhile(lambda line: "Waiting until" not in line, lines))
        change(tmp_path)
        assert any(browser.ADDRESS.search(line) for line in lines)
    finally:
        process.send_signal(signal.SIGINT)
        process.wait()
        process.stdout.close()
    assert left(programs) <= before


def test_a_program_that_draws_boxes_is_watched_and_picked(programs, tmp_path):
    """Each frame is the one before with its boxes; the seconds' hand is over the middle."""
    source = view_own.Source("examples/watch", f"own-{own_run.name_of('examples/watch')}", programs)
    assert source.make().returncode == 0
    making.build(str(CHECKOUT / "scenes/tiny.toml"), str(tmp_path / "tiny.fxls"), 2)
    own = view_own.Own(source, tmp_path / "tiny.fxls", tmp_path)
    try:
        frames = [own.frame() for _ in range(3)]
        assert own.pick(120, 120) == (0, 15, 0)
    finally:
        own.close()
    for before, frame in zip(frames, frames[1:]):
        kept = numpy.ones(frame.pixels.shape, bool)
        for column, columns, row, rows in frame.boxes:
            kept[row:row + rows, column:column + columns] = False
        assert kept.mean() > 0.5 and (frame.pixels != before.pixels).any() and (frame.pixels == before.pixels)[kept].all()
