# SPDX-License-Identifier: MIT
"""The live window's page in a headless browser: frames, figures, keys, what is shown beside.

A machine that runs other tests meanwhile may be slow: nothing here is timed, only waited for.
build/view/<board>.png is how the page looked.
"""

import base64
import io
import re
import socket
import time

import numpy
import pytest
from PIL import Image
from conftest import assert_one_sentence, environment, run_cli

from board_programs import ROOT, built
from fixel.scene import making
from fixel.view import browser
from fixel.image import image as scene_image
from viewers import BOARDS, HEIGHT, SCREEN, WIDTH, left, own_build, plaza_image, port_of, ready, ready_board, wait_for_rest   # two are fixtures

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "boards/lm3s6965evb/walk.elf", "host/live")
MARK = (255, 0, 160)    # of a pixel that differs, in templates/view_picture.js
LINE = (255, 211, 77)   # of an outline
FIGURES = ("x", "y", "z", "yaw", "pitch", "roll")
# What a key changes, and which way.
KEYS = {"ArrowUp": ("z", 1), "ArrowRight": ("yaw", 1), "ArrowLeft": ("yaw", -1), "ArrowDown": ("z", -1),
        "KeyR": ("pitch", 1), "KeyF": ("pitch", -1), "KeyQ": ("roll", 1), "KeyE": ("roll", -1)}
# Other keys that mean the same: bits of fixel/player.h.
SAME = {"KeyW": 1, "KeyS": 2, "KeyA": 4, "KeyD": 8, "PageUp": 16, "PageDown": 32}

TURNING = 10    # frames for which a key is held there: the model stays in sight


# For what the page does by itself: the board is one of the two.
on_one_board = pytest.mark.parametrize("board", BOARDS[:1], indirect=True)


@pytest.fixture(scope="module")
def window(board, scene, chromium, build):
    """(its process, its address, its page), live."""
    with browser.viewing(board, scene, build) as (process, address), \
            browser.page(chromium, address, WIDTH, HEIGHT) as page:
        page.set_default_timeout(0)
        page.wait_for_function("() => document.getElementById('board-rate').textContent !== '–'")
        yield process, address, page
        assert page.complaints == []


@pytest.fixture
def page(window):
    return window[2]


def figure(page, name):
    """A number that the page shows."""
    return float(re.sub(r"[^\d.-]", "", page.inner_text(f"#{name}")))


def numbers(page, name):
    """The whole numbers in a sentence of the page's."""
    return [int(number.replace(",", "")) for number in re.findall(r"\d[\d,]*", page.inner_text(f"#{name}"))]


def canvases(page, *names):
    """What canvases show, all of one moment: arrays of rows of RGB."""
    urls = page.evaluate("names => names.map((name) => document.getElementById(name).toDataURL())", names)
    blocks = [base64.b64decode(url.partition(",")[2]) for url in urls]
    return [numpy.asarray(Image.open(io.BytesIO(block)).convert("RGB")) for block in blocks]


def wait_for_frames(page, count):
    number = figure(page, "number")
    page.wait_for_function("until => Number(document.getElementById('number').textContent.replace(/,/g, '')) >= until",
                           arg=number + count)


def stand_still(page):
    """Waits until the viewer does; the figures of its pose then."""
    before = None
    while (pose := {name: figure(page, name) for name in FIGURES}) != before:
        wait_for_frames(page, 10)
        before = pose
    return pose


def go_back(page):
    """To the start."""
    number = figure(page, "number")
    page.keyboard.press("Home")
    page.wait_for_function("before => Number(document.getElementById('number').textContent.replace(/,/g, '')) < before", arg=number)


def around(degrees):
    return (degrees + 180) % 360 - 180


# --- what is shown ------------------------------------------------------------------

def test_frames_and_figures(page, board):
    wait_for_frames(page, 5)
    assert page.inner_text("#board") == board and "plaza.fxls, 160 × 120" in page.inner_text("#scene")
    assert figure(page, "board-rate") > 0 and figure(page, "page-rate") > 0
    assert board == "host" or 1e5 < figure(page, "instructions") < 1e8      # the host counts none
    assert stand_still(page)["z"] == -32
    (frame,) = canvases(page, "fixed")
    assert frame.shape == (*reversed(SCREEN), 3) and len(numpy.unique(frame.reshape(-1, 3), axis=0)) > 30


def test_counters(page):
    rows = page.eval_on_selector_all("#polygons tr", "rows => rows.map((row) => [row.dataset.name, "
                                     "Number(row.cells[1].textContent.replace(/,/g, ''))])")
    counters = dict(rows)
    assert counters["in"] == sum(counters[name] for name in
                                 ("backfacing", "outside", "degenerate", "refused", "drawn"))
    assert counters["drawn"] > 500 and counters["clipped"] > 0 and counters["refused"] == 0


def test_frames_a_second(page):
    """As many as come: on a busy machine that may be one."""
    page.click("[data-rate='0']")
    page.wait_for_selector("[data-rate='0'][aria-pressed='true']")
    wait_for_frames(page, 5)
    page.wait_for_function("() => Number(document.getElementById('board-rate').textContent.replaceAll(',', '')) > 0")    # 1,020.3 of a quick one
    page.click("[data-rate='30']")
    page.wait_for_selector("[data-rate='30'][aria-pressed='true']")


# --- keys ---------------------------------------------------------------------------

@pytest.mark.parametrize("key", KEYS)
def test_a_key_moves_the_viewer_and_the_picture(page, key):
    name, sign = KEYS[key]
    before, (picture,) = stand_still(page), canvases(page, "fixed")
    page.keyboard.down(key)
    page.wait_for_function(
        """([name, sign, before]) => {
            const change = parseFloat(document.getElementById(name).textContent) - before;
            return sign * (name === "z" ? change : (change + 540) % 360 - 180) >= 1;
        }""", arg=[name, sign, before[name]])
    page.keyboard.up(key)
    after = stand_still(page)
    changed = {each for each in FIGURES if after[each] != before[each]}
    assert name in changed and changed <= ({"x", "z"} if name == "z" else {name})
    (moved,) = canvases(page, "fixed")
    assert numpy.mean((moved != picture).any(axis=2)) > 0.01


@on_one_board
def test_every_key_is_known_to_the_page(page):
    for key, bit in SAME.items():
        button = f"[data-bit='{bit}']"
        page.keyboard.down(key)
        assert page.get_attribute(button, "aria-pressed") == "true", key
        page.keyboard.up(key)
        assert page.get_attribute(button, "aria-pressed") == "false", key
    stand_still(page)


def test_keys_on_the_page_and_keys_that_are_let_go_elsewhere(page):
    """Frame by frame: a busy machine holds the key for no longer than another."""
    before = stand_still(page)
    page.keyboard.press("p")
    state(page, "paused")
    wait_for_rest(page)
    page.hover("[data-bit='8']")
    page.mouse.down()
    while figure(page, "yaw") == before["yaw"]:
        step_by_key(page)
        assert page.get_attribute("[data-bit='8']", "aria-pressed") == "true", "another key lets it go"
    page.evaluate("window.dispatchEvent(new Event('blur'))")    # another window is on top now
    turned = None
    while (yaw := figure(page, "yaw")) != turned:
        turned = yaw
        for _ in range(10):
            step_by_key(page)
    page.keyboard.press("p")
    state(page, "live")
    after = stand_still(page)
    page.mouse.up()
    assert around(after["yaw"] - before["yaw"]) > 0 and after["z"] == before["z"]


# --- beside it ----------------------------------------------------------------------

def show_beside(page, key, what):
    page.keyboard.press(key)
    page.wait_for_selector(f"[data-beside='{what}'][aria-pressed='true']")
    page.wait_for_function("() => document.getElementById('other-number').textContent !== '–'")
    fixed, other = page.evaluate("['number', 'other-number'].map((name) => document.getElementById(name).textContent)")
    assert fixed == other


def test_double(page):
    """From the start: where the tests of the keys end depends on how long a busy machine holds them."""
    go_back(page)
    show_beside(page, "1", "double")
    fixed, double = canvases(page, "fixed", "other")
    differ = (fixed != double).any(axis=2).sum()
    assert fixed.shape == double.shape and differ <= 5      # of 19,200; mostly none
    assert len(numpy.unique(double.reshape(-1, 3), axis=0)) > 30


@on_one_board
def test_difference(page):
    show_beside(page, "2", "difference")
    (shown,) = canvases(page, "other")
    pixels, together, frames, within = numbers(page, "other-name")
    assert pixels == together == (shown == MARK).all(axis=2).sum() == 0 and frames > 0 and within <= 20
    assert (shown.max(axis=2) == shown.min(axis=2)).all() and len(numpy.unique(shown)) > 10


@on_one_board
def test_wireframe(page):
    stand_still(page)
    show_beside(page, "3", "wireframe")
    lines, (shown,) = numbers(page, "other-name")[0], canvases(page, "other")
    drawn = figure(page, "polygons tr[data-name='drawn'] td:nth-child(2)")
    assert abs(lines - drawn) <= 0.01 * drawn   # those that only one of the two draws have hardly an area
    assert shown.shape[0] % SCREEN[1] == 0 and (numpy.abs(shown.astype(int) - LINE).sum(axis=2) < 12).sum() > 1000


def test_nothing_beside_it(page, board, build):
    (build / "view").mkdir(exist_ok=True)
    page.screenshot(path=build / "view" / f"{board}.png")
    page.keyboard.press("0")
    page.wait_for_selector("#beside", state="hidden")
    wait_for_frames(page, 5)


# --- frame by frame -------------------------------------------------------------------

def state(page, name):
    page.wait_for_function("name => document.getElementById('state').textContent === name", arg=name)


def step(page):
    """One frame more: the board's number is one higher, however long that takes."""
    step_by(page, lambda: page.click("#step"))


def step_by_key(page):
    """The same, while the pointer stays where it is."""
    step_by(page, lambda: page.keyboard.press("."))


def step_by(page, how):
    number, text = figure(page, "number"), page.inner_text("#number")
    how()
    page.wait_for_function("before => document.getElementById('number').textContent !== before", arg=text)
    assert figure(page, "number") == number + 1


@pytest.fixture
def paused(page):
    """The page while the board is paused; it goes on after the test."""
    stand_still(page)
    page.click("#pause")
    state(page, "paused")
    wait_for_rest(page)
    yield page
    page.keyboard.press("p")
    state(page, "live")
    stand_still(page)


def test_pause_and_step(paused, board):
    for _ in range(5):
        step(paused)
    assert paused.get_attribute("#pause", "aria-pressed") == "true" and paused.inner_text("#board-rate") == "–"
    yaw = figure(paused, "yaw")
    paused.keyboard.down("ArrowRight")
    for _ in range(60 if board == "lm3s6965evb" else 6):    # its buttons are believed after some frames
        step(paused)
    paused.keyboard.up("ArrowRight")
    paused.wait_for_function("before => parseFloat(document.getElementById('yaw').textContent) !== before", arg=yaw)


def test_back_to_the_start(page):
    page.keyboard.down("ArrowRight")
    wait_for_frames(page, 20)
    page.keyboard.up("ArrowRight")
    stand_still(page)
    go_back(page)
    pose = stand_still(page)
    assert (pose["x"], pose["z"], pose["yaw"]) == (0, -32, 0)


@on_one_board
def test_a_page_that_comes_while_the_board_is_paused(paused, window, chromium):
    with browser.page(chromium, window[1], WIDTH, HEIGHT) as other:
        state(other, "paused")
        other.wait_for_function("number => document.getElementById('number').textContent === number",
                                arg=paused.inner_text("#number"))


# --- pixels ---------------------------------------------------------------------------

PIXEL = re.compile(r"Pixel (\d+), (\d+): colour (\d+), RGB (\d+) (\d+) (\d+); (?:instance (\d+), face (\d+), [\d.]+ away(?:, texel \d+, \d+ of \d+ × \d+)?|background)$")


def pixel_told(page, x, y):
    """What the page says of pixel x, y of a frame: (x, y), colour, RGB, (instance, face) or None."""
    width = page.eval_on_selector("#fixed", "canvas => canvas.getBoundingClientRect().width")
    page.hover("#fixed", position={"x": (x + 0.5) * width / SCREEN[0], "y": (y + 0.5) * width / SCREEN[0]})
    page.wait_for_function(f"words => /^Pixel {x}, {y}:.*(away|background)/.test(document.getElementById('pixel-words').textContent)")
    at_x, at_y, colour, *rest = (None if each is None else int(each)
                                 for each in PIXEL.match(page.inner_text("#pixel-words")).groups())
    return (at_x, at_y), colour, tuple(rest[:3]), None if rest[3] is None else tuple(rest[3:])


@on_one_board
def test_the_pixel_under_the_pointer(paused, scene):
    """The plaza has neither light nor surfaces: a pixel has the colour of the face that is told."""
    compiled = scene_image.load(scene)
    (frame,) = canvases(paused, "fixed")
    faces = set()
    for x, y in ((80, 50), (5, 2), (30, 75), (154, 117), (0, 0), (100, 60)):
        place, colour, rgb, face = pixel_told(paused, x, y)
        assert place == (x, y) and rgb == tuple(frame[y, x]) == tuple(compiled.palette[colour])
        instance, number = face
        assert compiled.models[compiled.objects[instance].model].faces[number].colour == colour
        faces.add(face)
    assert len(faces) > 3
    paused.mouse.move(0, 0)


@on_one_board
def test_zoom(paused):
    show_beside(paused, "1", "double")
    before = pixel_told(paused, 50, 30)
    for factor in (2, 4, 8):
        paused.keyboard.press("+")
        assert paused.inner_text("#zoom") == f"{factor}×"
        ports = paused.eval_on_selector_all(".port", "ports => ports.map((each) => [each.scrollLeft, each.scrollTop, "
                                            "each.clientWidth, each.firstElementChild.clientWidth])")
        assert ports[0] == ports[1] and ports[0][0] > 0 and ports[0][1] > 0
        assert ports[0][3] == factor * paused.eval_on_selector("figure", "each => each.clientWidth")
        assert paused.inner_text("#pixel-words").startswith(f"Pixel {before[0][0]}, {before[0][1]}:")
    assert paused.is_disabled("#larger")
    for _ in range(3):
        paused.click("#smaller")
    assert paused.inner_text("#zoom") == "1×" and paused.is_disabled("#smaller")
    assert pixel_told(paused, 50, 30) == before
    paused.keyboard.press("0")
    paused.mouse.move(0, 0)


@on_one_board
def test_save_png(paused, board):
    (frame,) = canvases(paused, "fixed")
    with paused.expect_download() as download:
        paused.click("#save")
    assert download.value.suggested_filename == f"{board}-plaza-{figure(paused, 'number'):.0f}.png"
    with Image.open(download.value.path()) as picture:
        assert numpy.array_equal(numpy.asarray(picture.convert("RGB")), frame)


# --- the layout -----------------------------------------------------------------------

def test_picture_and_keys_are_on_one_screen(chromium, build, tmp_path):
    """Of a frame of 320 x 240, whatever is shown beside it, and wherever the scene is. build/view/mps2-an385-390.png is how the narrow page looked."""
    ready("mps2-an385", build)
    image = tmp_path / ("folder" * 20) / "plaza.fxls"
    image.parent.mkdir()
    making.build(str(ROOT / "scenes" / "plaza.toml"), str(image))
    with browser.viewing("mps2-an385", image, build) as (_, address), \
            browser.page(chromium, address, WIDTH, HEIGHT) as page:
        page.set_default_timeout(0)
        page.wait_for_function("() => document.getElementById('board-rate').textContent !== '–'")
        for beside in "0123":
            page.keyboard.press(beside)
            for width, height in ((390, 844), (1280, 800)):
                page.set_viewport_size({"width": width, "height": height})
                wait_for_frames(page, 2)
                boxes = [page.locator(name).bounding_box() for name in ("#fixed", "#bar", "#keys")]
                assert all(box["x"] >= 0 and box["y"] >= 0 and box["x"] + box["width"] <= width
                           and box["y"] + box["height"] <= height for box in boxes), boxes
                assert page.evaluate("document.documentElement.scrollWidth") <= width
                if (width, beside) == (390, "2"):
                    (build / "view").mkdir(exist_ok=True)
                    page.screenshot(path=build / "view" / "mps2-an385-390.png")
            assert page.evaluate("document.documentElement.scrollHeight") <= HEIGHT
        assert page.complaints == []


@on_one_board
def test_whose_rate_it_is(page):
    assert "rates of the emulator on this machine, not of a board" in page.inner_text("#choices")


# --- others that look on ------------------------------------------------------------

@on_one_board
def test_another_tab_sees_and_walks_the_same(window, chromium):
    _, address, page = window
    before = stand_still(page)
    with browser.page(chromium, address, WIDTH, HEIGHT) as other:
        other.keyboard.down("ArrowUp")
        page.wait_for_function("before => Number(document.getElementById('z').textContent) > before + 1",
                               arg=before["z"])
        # Closed with the key down: whoever leaves lets go.
    assert stand_still(page)["z"] > before["z"]


@on_one_board
def test_it_listens_on_this_machine_alone(window):
    port = port_of(window[1])
    socket.create_connection(("127.0.0.1", port)).close()
    with pytest.raises(ConnectionRefusedError):
        socket.create_connection(("127.0.0.2", port))


@on_one_board
def test_another_viewer_has_a_port_of_its_own(window, board, scene, build):
    with browser.viewing(board, scene, build) as (_, address):
        assert address != window[1]


@on_one_board
def test_the_page_is_opened(board, scene, build, tmp_path):
    """By a file with the address, which no other user may read."""
    opened, program = tmp_path / "opened", tmp_path / "browser"
    program.write_text(f'#!/bin/sh\nstat -c %a "$(dirname "${{1#file://}}")" > {tmp_path}/mode\ncp "${{1#file://}}" {opened}.part\nmv {opened}.part {opened}\n')
    program.chmod(0o755)
    with browser.viewing(board, scene, build, ("--open",), env=environment(BROWSER=f"{program} %s")) as (_, address):
        while not opened.exists():
            time.sleep(0.05)
    assert f"url={address}" in opened.read_text() and (tmp_path / "mode").read_text() == "700\n"


@on_one_board
def test_a_port_in_use_is_refused(window, board, scene, build, tmp_path):
    port, programs = port_of(window[1]), own_build(build, tmp_path)
    refused = run_cli("view", "--board", board, "--scene", scene, "--build", programs, "--port", port)
    assert_one_sentence(refused, f"port {port} of 127.0.0.1", "PORT=")
    assert not left(programs)
    wait_for_frames(window[2], 1)


# --- other scenes ---------------------------------------------------------------------


# --- the recording ------------------------------------------------------------------

def test_the_game_is_played_in_it(chromium, build, tmp_path):
    """Keys aim and shoot; nothing is offered to compare it with. build/view/game.png is how it looked."""
    ready("mps2-an385", build)
    built("mps2-an385/game.elf")
    image = tmp_path / "game.fxls"
    making.build(str(ROOT / "examples" / "game" / "game.toml"), str(image), None, (160, 120))
    with browser.viewing("mps2-an385", image, build, ("--program", "game")) as (_, address), \
            browser.page(chromium, address, WIDTH, HEIGHT) as page:
        page.set_default_timeout(0)
        page.wait_for_function("() => document.getElementById('board-rate').textContent !== '–'")
        wait_for_frames(page, 3)
        page.keyboard.down("ArrowDown")     # begins a new game each time that rocks have ended one, so nothing here hurries
        for key, sign in (("ArrowRight", 1), ("ArrowLeft", -1)):
            before, (picture,) = figure(page, "yaw"), canvases(page, "fixed")
            page.keyboard.down(key)
            page.wait_for_function("""([sign, before]) => sign * (((parseFloat(document.getElementById("yaw").textContent)
                                      - before + 540) % 360) - 180) >= 3""", arg=[sign, before])
            page.keyboard.up(key)
            wait_for_frames(page, 2)
            (moved,) = canvases(page, "fixed")
            assert numpy.mean((moved != picture).any(axis=2)) > 0.001
        drawn = "() => Number(document.querySelector('#polygons tr[data-name=in]').cells[1].textContent.replace(/,/g, ''))"
        seen = {page.evaluate(drawn)}
        page.keyboard.down("ArrowUp")
        for _ in range(40):     # shots come and go
            wait_for_frames(page, 2)
            seen.add(page.evaluate(drawn))
        page.keyboard.up("ArrowUp")
        page.keyboard.up("ArrowDown")
        assert len(seen) > 1
        assert page.is_hidden("#beside-choice")
        page.hover("#fixed")
        assert re.fullmatch(r"Pixel \d+, \d+: colour \d+, RGB \d+ \d+ \d+", page.inner_text("#pixel-words"))
        page.screenshot(path=str(build / "view" / "game.png"))
        assert page.complaints == []
