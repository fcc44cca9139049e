# SPDX-License-Identifier: MIT
"""make view's page that draws in the browser: what is dropped on it, or on the live window, is checked, compiled, drawn and predicted."""

import contextlib
import pathlib
import re
import signal
import subprocess
import urllib.error
import urllib.request

import pytest

from conftest import CHECKOUT, environment
from fixel.scene import making
from fixel.view import browser
from outside import need, run
from pages import DESKTOP, NARROW, assert_accessible, crc, drop, drop_each, fixture_chromium, opened, paused, shows      # one is a fixture

HOSTILE = "<img src=x onerror=alert(1)>"


@contextlib.contextmanager
def make_view(*words):
    """make view as a user runs it: yields its page's address, and ends it by Ctrl-C."""
    process = subprocess.Popen(["make", "view", "BOARD=host", *words], cwd=CHECKOUT, env=environment(), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, text=True, start_new_session=True)
    said = []
    with process:
        for line in process.stdout:
            said.append(line)
            address = browser.ADDRESS.search(line)
            if address:
                yield address[0]
                break
        else:
            raise AssertionError("".join(said))
        process.send_signal(signal.SIGINT)
        subprocess.run(["kill", "-INT", "--", f"-{process.pid}"], check=False)


@pytest.fixture(scope="module", name="address")
def fixture_address():
    need("clang", "wasm-ld", "chromium")
    with make_view("SCENE=scenes/spin.toml", "SCREEN=160x120") as address:
        yield address


def test_it_draws_what_the_board_draws(chromium, address, tmp_path):
    """The scene of the live window as that has it, with its options; and each scene of the tree, compiled when it is chosen."""
    making.build(str(CHECKOUT / "scenes" / "spin.toml"), str(tmp_path / "spin.fxls"), screen=(160, 120))
    with opened(chromium, f"{address}draw.html#scene=spin&frame=7") as page:
        found = crc(page)
        assert page.evaluate("document.getElementById('screen').width") == 160
        shows(page, "#cost", r"^[\d,]+ instructions$")
        drop(page, "mine.fxls", (tmp_path / "spin.fxls").read_bytes())
        shows(page, "#scene-name", "^mine.fxls, a file of yours$")
        for _ in range(7):
            page.click("#step")
        assert crc(page) == found
        page.select_option("#scene", "cube")
        shows(page, "#cost", r"^[\d,]+ instructions$")
        page.select_option("#view", "differ")
        shows(page, "#view-words", "differ from double precision")
        assert not [url for url in page.asked if "esbuild" in url or "documents" in url]


@pytest.mark.parametrize("size", [DESKTOP, NARROW])
def test_each_kind_of_file_is_compiled_drawn_and_predicted(chromium, address, size, tmp_path):
    with opened(chromium, f"{address}draw.html#frame=3", size) as page:
        paused(page)
        drop_each(page, tmp_path)
        page.select_option("#board", "microbit")
        shows(page, "#cost-words", "^An estimate, as make predict BOARD=microbit|room|partition")
        assert page.evaluate("document.documentElement.scrollWidth") <= size[0]


def test_a_file_that_is_dropped_on_the_live_window_is_opened_there(chromium, address):
    with opened(chromium, address, waits=False) as page:
        page.wait_for_selector("#state.live")
        drop(page, f"{HOSTILE}#&.obj", (CHECKOUT / "examples" / "cube" / "cube.obj").read_bytes())
        shows(page, "#scene-name", r"#&\.obj, a file of yours$")
        assert page.inner_text("#scene-name").startswith(HOSTILE) and not page.query_selector("figcaption img")
        page.click("text=on the board, live")
        page.wait_for_selector("#state.live")


def press_and_choose(page, key, file):
    """Presses a key, and chooses a file where the browser asks for one. The browser hears after the first evaluation that Playwright waits for that."""
    page.once("filechooser", lambda chooser: chooser.set_files(file))
    page.evaluate("1")
    page.keyboard.press(key)


def test_a_file_is_opened_by_the_keyboard_alone(chromium, address):
    with opened(chromium, f"{address}draw.html") as page:
        press_and_choose(page, "o", CHECKOUT / "examples" / "cube" / "cube.obj")
        shows(page, "#scene-name", "^cube.obj, a file of yours$")
        page.focus("#open")
        press_and_choose(page, "Enter", CHECKOUT / "examples" / "model" / "model.glb")
        shows(page, "#scene-name", "^model.glb, a file of yours$")
    with opened(chromium, address, waits=False) as page:
        page.wait_for_selector("#state.live")
        press_and_choose(page, "o", CHECKOUT / "examples" / "model" / "model.glb")
        shows(page, "#scene-name", "^model.glb, a file of yours$")


def test_what_is_refused_is_a_sentence_and_what_was_drawn_stays(chromium, address, tmp_path):
    making.build(str(CHECKOUT / "scenes" / "cube.toml"), str(tmp_path / "cube.fxls"))
    image = (tmp_path / "cube.fxls").read_bytes()
    sly = re.sub(r'"[^"]+[.]obj"', f'"{CHECKOUT}/examples/cube/cube.obj"', (CHECKOUT / "scenes" / "w3.toml").read_text(encoding="utf-8"))
    with opened(chromium, f"{address}draw.html#scene=spin&frame=5") as page:
        for name, data, words in (("broken.glb", b"glTF", "^broken.glb"), ("sly.toml", sly.encode(), "is outside the folder of sly.toml, and what lies below it; make view SCENE= draws"),
                                  (f"{HOSTILE}.fxls", image[:-5] + bytes(5), "scene refused"), (f"{HOSTILE}.txt", b"words", "no model and no scene file")):
            drop(page, name, data)
            shows(page, "#banner", words)
            assert "fixel-" not in page.inner_text("#banner") and not page.query_selector("#banner *")
            assert page.input_value("#scene") == "spin"
            said, number = page.inner_text("#banner"), page.inner_text("#number")
            page.click("#step")
            assert (page.inner_text("#banner"), page.inner_text("#number") != number) == (said, True)
        page.evaluate("location.hash = '#scene=nowhere'")
        shows(page, "#banner", "“nowhere”, which this site does not have")


def test_beside_a_program_of_ones_own_there_are_the_scenes_of_the_tree(chromium):
    with make_view("PROGRAM=examples/horizon") as address, opened(chromium, f"{address}draw.html") as page:
        assert page.input_value("#scene") == "plaza" and page.locator("#scene option").count() > 20
        drop(page, "mine.glb", (CHECKOUT / "examples" / "model" / "model.glb").read_bytes())
        shows(page, "#scene-name", "^mine.glb, a file of yours$")


def test_without_a_compiler_for_it_the_page_says_what_to_install(chromium, tmp_path):
    folder = tmp_path / "bin"
    folder.mkdir()
    for file in pathlib.Path("/usr/bin").iterdir():
        if not file.name.startswith(("clang", "wasm-ld")):
            (folder / file.name).symlink_to(file)
    run("make", "build/boards/host/walk", "build/host/live", folder=CHECKOUT)
    with browser.viewing("host", "scenes/tiny.toml", str(CHECKOUT / "build"), cwd=CHECKOUT, env=environment(PATH=str(folder))) as (_, address), \
            opened(chromium, f"{address}draw.html", waits=False) as page:
        shows(page, "#banner", "^walk.wasm is compiled by clang .*: run 'sudo apt-get install clang lld ")
        assert not page.is_visible("#unserved")


def asked(address, data=None, **headers):
    """The code of an answer, and its text."""
    try:
        with urllib.request.urlopen(urllib.request.Request(address, data, headers), timeout=60) as answer:
            return answer.status, answer.read().decode(errors="replace")
    except urllib.error.HTTPError as error:
        with error:
            return error.code, error.read().decode()


def test_who_has_not_the_token_or_comes_from_another_page_gets_nothing(address):
    cube = (CHECKOUT / "examples" / "cube" / "cube.obj").read_bytes()
    root = "/".join(address.split("/")[:3])
    for path in ("draw.html", "walk.wasm", "scenes/spin.fxls", "kept"):
        assert asked(f"{address}{path}")[0] == 200
        assert asked(f"{root}/{path}")[0] == asked(f"{root}/x/{path}")[0] == asked(f"{address}{path}", Origin="http://example.org")[0] == 403
    for path in ("compile?name=cube.obj", "predict?board=pico", "keep"):
        assert asked(f"{root}/x/{path}", cube)[0] == asked(f"{address}{path}", cube, Origin="http://example.org")[0] == 403
    assert asked(f"{address}compile?name=cube.obj", cube)[1].startswith("FXLS")
    assert asked(f"{address}predict?board=/etc", cube) == (200, "no such board")
    assert asked(f"{address}compile?name=../../broken.glb", b"glTF")[1].startswith("_.._broken.glb:")
    for path in ("scenes/..%2F..%2FMakefile.fxls", "scenes/none.fxls", "Makefile.wasm", "..%2Fhost%2Flive.wasm"):
        assert asked(f"{address}{path}")[0] == 404, path


def test_a_file_is_bounded(address):
    """64 MiB; more ends the connection, or is refused."""
    most = 64 << 20
    assert asked(f"{address}keep", bytes(most))[0] == 200
    try:
        assert asked(f"{address}keep", bytes(most + 1))[0] == 413
    except (urllib.error.URLError, ConnectionError):
        pass
    assert len(asked(f"{address}kept")[1]) == most


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nothing_serious_keeps_anybody_out(chromium, address, scheme):
    assert_accessible(chromium, f"{address}draw.html", scheme)
    assert_accessible(chromium, address, scheme, waits=False)
