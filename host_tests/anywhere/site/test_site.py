# SPDX-License-Identifier: MIT
"""make site: the first page in Chromium, served below a prefix and opened as a file; its frames, its links, its documents."""

import contextlib
import dataclasses
import functools
import gzip
import hashlib
import html
import html.parser
import http.server
import json
import pathlib
import queue
import re
import shutil
import threading
import urllib.parse
import zlib

import numpy
import pytest
from PIL import Image

from conftest import CHECKOUT
from fixel.base.errors import ToolError
from fixel.board import dump, programs
from fixel.bench import frame_costs, predict
from fixel.report import showcase_models
from fixel.scene import scene_options
from fixel.site import costs, packing, programs as programs_of
from fixel.view import view_reference
from outside import need, run
from pages import DESKTOP, NARROW, PATIENCE, assert_accessible, crc, drop, fixture_chromium, opened, paused, shows     # one is a fixture

PREFIX = "/some/place/"
FIRST_REQUESTS = 8
FIRST_BYTES, FIRST_PACKED = 1 << 20, 400_000
JUDGED, DIFFERS = 4, 17  # frames a scene; a frame of the plaza that differs from double precision
STEPS = """async (count) => {
    const found = [];
    for (let i = 0; i < count; i++) {
        found.push(document.getElementById("crc").textContent);
        document.getElementById("step").click();
    }
    return found;
}"""


@pytest.fixture(scope="module", name="site")
def fixture_site(tmp_path_factory):
    need("clang", "wasm-ld", "node", "doxygen", "chromium")
    folder = tmp_path_factory.mktemp("site") / "site"
    run("make", "site", f"OUT={folder}", folder=CHECKOUT)
    return folder


class Quiet(http.server.SimpleHTTPRequestHandler):
    """Serves a folder below a prefix."""

    def translate_path(self, path):
        return super().translate_path(path.removeprefix(PREFIX.rstrip("/"))) if path.startswith(PREFIX) else "/nowhere"

    def log_message(self, *_):
        pass


@pytest.fixture(scope="module", name="address")
def fixture_address(site):
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=str(site))) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}{PREFIX}"
        server.shutdown()


# --- the first page -----------------------------------------------------------------

def test_the_first_frame_needs_few_requests_and_bytes(chromium, address, site, record_property):
    with opened(chromium, address) as page:
        first = [url for url in page.asked if not url.startswith("data:")]
        assert len(first) <= FIRST_REQUESTS, first
        names = {urllib.parse.urlparse(url).path.removeprefix(PREFIX) or "index.html" for url in first}
        taken, packed = packing.sizes(site / name for name in names)
        assert taken <= FIRST_BYTES and packed <= FIRST_PACKED
        record_property("figure", f"{len(first)} requests, {taken:,} bytes before the first frame, {packed:,} packed")


def test_the_site_is_within_its_bytes_as_a_server_packs_it(site, record_property):
    files = [file for file in site.rglob("*") if file.is_file()]
    total, packed = sum(file.stat().st_size for file in files), 0
    for file in files:
        data = file.read_bytes()
        is_picture = data.startswith(b"\x89PNG") or data[8:12] == b"WEBP"
        packed += len(data) if is_picture else len(gzip.compress(data, 9))
    assert total <= 12 << 20 and packed <= 4 << 20 and packing.sizes(files) == (total, packed)
    record_property("figure", f"{total:,} bytes in all, {packed:,} packed")


@pytest.mark.parametrize("total, packed, said", [((12 << 20) + 1, 0, r"12,582,913 bytes, of at most 12,582,912"),
                                                 (1, (4 << 20) + 1, r"4,194,305 bytes as a server packs it, of at most 4,194,304")])
def test_a_site_that_is_too_large_is_refused(total, packed, said):
    packing.check(12 << 20, 4 << 20)
    with pytest.raises(ToolError, match=f"^the site has {said}$"):
        packing.check(total, packed)


def test_pictures_become_smaller_and_equal_ones_one(tmp_path):
    """The pages follow; a picture of the theme stays, and each pixel does."""
    noise = numpy.random.default_rng(1).integers(0, 4, (40, 50, 3), dtype=numpy.uint8)
    for name in ("a/one", "b/same", "b/_static/icon"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        Image.fromarray(noise).save(tmp_path / f"{name}.png")
    (tmp_path / "b" / "page.html").write_text('<img src="same.png"><a href="../a/one.png"><img src="_static/icon.png"><a href="none.png">', encoding="utf-8")
    packing.pack_pictures(tmp_path)
    assert (tmp_path / "b" / "page.html").read_text(encoding="utf-8") == '<img src="../a/one.webp"><a href="../a/one.webp"><img src="_static/icon.png"><a href="none.png">'
    assert sorted(file.name for file in tmp_path.rglob("*.*p*g") if file.is_file()) == ["icon.png"] and not (tmp_path / "b" / "same.webp").exists()
    with Image.open(tmp_path / "a" / "one.webp") as made:
        assert (numpy.asarray(made.convert("RGB")) == noise).all()


@pytest.mark.parametrize("size", [DESKTOP, NARROW])
def test_it_fits_and_draws(chromium, address, size, tmp_path):
    with opened(chromium, address, size) as page:
        shows(page, "#number", r"^([3-9]|\d\d+) of")
        assert page.evaluate("document.documentElement.scrollWidth") <= size[0]
        page.screenshot(path=str(tmp_path / "page.png"))
        if size == DESKTOP:
            bottom = page.evaluate("Math.max(...[...document.querySelectorAll('main *')].map(each => each.getBoundingClientRect().bottom))")
            assert bottom <= size[1], "it fits a laptop's screen"


MODEL = "model-"


def all_scenes_of(site):
    text = (site / "index.html").read_text(encoding="utf-8")
    return json.loads(re.search(r'id="data">(.*?)</script>', text)[1])["scenes"]


def scenes_of(site):
    """Those of scenes/."""
    return [each for each in all_scenes_of(site) if not each["name"].startswith(MODEL)]


def crcs_of_host(image, folder):
    """The frames' CRC as build/host/frames draws them on this machine: what fxl_band_crc gives."""
    out = folder / "frames.fxld"
    programs.run_program([CHECKOUT / "build" / "host" / "frames", image, out])
    return [f"{zlib.crc32(frame.pixels.astype('>u2' if frame.pixels.dtype.itemsize == 2 else 'u1').tobytes()):08x}" for frame in dump.read_dump(out).frames]


def test_every_frame_of_every_scene_is_that_of_a_board(chromium, address, site, tmp_path, record_property):
    count, scenes = 0, all_scenes_of(site)
    for scene in scenes:
        expected = crcs_of_host(site / "scenes" / f"{scene['name']}.fxls", tmp_path)
        with opened(chromium, f"{address}#scene={scene['name']}&frame=0") as page:
            assert page.evaluate(STEPS, len(expected)) == expected, scene["name"]
            count += len(expected)
    record_property("figure", f"{count} frames of {len(scenes)} scenes and models")


def judged_by_host(image, frames):
    """For each of the first frames, a pixel of which is spoilt: SHA-256 of what double precision draws, and of the verdict."""
    found, wants = queue.Queue(), view_reference.FRAME | view_reference.VERDICT
    asked = view_reference.Reference(CHECKOUT / "build" / "host" / "live", image, found.put, found.put)
    with contextlib.closing(asked):
        for number, frame in enumerate(frames):
            pixels = frame.pixels.copy()
            pixels.flat[number] ^= 1
            asked.ask(dataclasses.replace(frame, pixels=pixels), wants)
            answer = found.get(timeout=PATIENCE / 1000)
            yield " ".join(hashlib.sha256(answer.parts[i]).hexdigest() for i in (0, 3))


def test_the_page_judges_as_the_host_does(site, tmp_path, record_property):
    for program in ("frames", "live"):
        run("make", f"build/host/{program}", folder=CHECKOUT)
    count = 0
    for scene in scenes_of(site):
        image, out = site / "scenes" / f"{scene['name']}.fxls", tmp_path / "frames.fxld"
        programs.run_program([CHECKOUT / "build" / "host" / "frames", image, out])
        frames = dump.read_dump(out).frames[:JUDGED]
        said = run("node", CHECKOUT / "host_tests" / "anywhere" / "site" / "judged.mjs", site / "walk.wasm", site / "judge.wasm", image, len(frames), folder=tmp_path)
        assert said.splitlines() == list(judged_by_host(image, frames)), scene["name"]
        count += len(frames)
    record_property("figure", f"{count} frames of {len(scenes_of(site))} scenes, a pixel of each spoilt")


@pytest.mark.parametrize("board", ["mps2-an385", "microbit"])
def test_the_page_counts_as_the_host_does(site, tmp_path, board):
    options = costs.settings(board, CHECKOUT / "build")
    settings = [options.band, options.order, options.list, options.cache, options.list_most]
    refused = 0
    for scene in scenes_of(site):
        image = site / "scenes" / f"{scene['name']}.fxls"
        said = json.loads(run("node", CHECKOUT / "host_tests" / "anywhere" / "site" / "counted.mjs", site / "walk.wasm", site / "counter.wasm", image, JUDGED,
                              *settings, folder=tmp_path))
        try:
            names, counts = frame_costs.count(CHECKOUT / "build", image, *settings, JUDGED, scene["name"])
        except frame_costs.NoRoom as error:
            assert said["noRoom"] and said["noRoom"] in str(error), scene["name"]
            refused += 1
            continue
        assert said == {"noRoom": "", "names": names, "frames": counts.tolist()}, scene["name"]
    assert (refused > 0) == (board == "microbit")


def test_what_differs_from_double_precision_is_shown(chromium, address):
    with opened(chromium, f"{address}#scene=plaza&frame={DIFFERS}") as page:
        page.select_option("#view", "differ")
        shows(page, "#view-words", r"^1 pixel of 76,800 pixels differ from double precision; 0 beyond the bound")
        box = page.locator("#screen").bounding_box()
        page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] * 0.6)
        shows(page, "#pixel", r"^Pixel 160, 144: colour \d+, RGB \d+ \d+ \d+; instance \d+, face \d+, [\d.]+ away$")
        for view, words in (("outlines", r"^\d+ polygons that are drawn"), ("overdraw", r"^Polygons a pixel: 1[.]\d\d on the mean, \d at most"),
                            ("double", "^What the reference renderer draws in double precision"), ("board", "^$")):
            page.select_option("#view", view)
            shows(page, "#view-words", words)
        assert sum("judge" in url for url in page.asked) == 2, "the worker and its module, once"
        page.select_option("#view", "outlines")
        page.click("#pause")
        shows(page, "#view-words", "^$")
        assert page.input_value("#view") == "board"


@pytest.mark.parametrize("scene", ["plaza", "car", "room", "game"])
def test_an_emulated_pico_sends_the_frames_of_the_page(chromium, address, scene):
    with opened(chromium, f"{address}pico.html#{scene}", waits=False) as page:
        shows(page, "#words", r"^(\d+) of \1 frames equal")
        shows(page, "#verdict", r"^frame [1-9]\d*: equal")
        page.click("#pause")
        # The library draws a frame after it has come by the wires.
        page.wait_for_function("document.querySelector('#wires-crc').textContent === document.querySelector('#library-crc').textContent")


def test_a_frame_of_the_pico_that_differs_is_said(chromium, address):
    with opened(chromium, f"{address}documents/index.html", waits=False) as page:
        page.add_init_script("""const Real = Worker; window.Worker = class extends Real {
            addEventListener(name, take) { super.addEventListener(name, (event) => { event.data.picture?.pixels.fill(0); take(event); }); } };""")
        page.goto(f"{address}pico.html#cube")
        shows(page, "#verdict", r"^frame \d+ differs")
        shows(page, "#words", r"^0 of \d+ frames equal")


def test_a_pico_that_does_not_start_says_why(chromium, address, site):
    with opened(chromium, f"{address}documents/index.html", waits=False) as page:
        flash = bytearray((site / "pico.bin").read_bytes())
        flash[4] ^= 1
        page.route("**/pico.bin", lambda route: route.fulfill(body=bytes(flash)))
        page.goto(f"{address}pico.html")
        shows(page, "#banner", "^the boot ROM does not start it")


def test_keys_alone_walk_pause_and_go_back(chromium, address):
    with opened(chromium, f"{address}#frame=5") as page:
        start = crc(page)
        page.keyboard.press("p")
        page.keyboard.down("w")
        shows(page, "#number", "^of your walk$")
        page.keyboard.up("w")
        page.keyboard.press("p")
        assert page.get_attribute("#pause", "aria-pressed") == "true" and crc(page) != start
        page.keyboard.press("Home")
        assert page.inner_text("#number").startswith("0 of ")
        for _ in range(5):
            page.keyboard.press(".")
        assert crc(page) == start


def test_a_link_is_the_frame_and_the_pose(chromium, address):
    with opened(chromium, f"{address}#scene=gallery&frame=7") as page:
        frame = crc(page)
        page.keyboard.down("ArrowUp")
        shows(page, "#number", "^of your walk$")
        page.keyboard.up("ArrowUp")
        walked = paused(page)
        page.click("#link")
        link = page.url
    with opened(chromium, link) as page:
        assert crc(page) == walked and "pose=" in link
    with opened(chromium, f"{address}#scene=gallery&frame=7") as page:
        assert crc(page) == frame


@pytest.mark.parametrize("link, said", [
    ("scene=<img src=x onerror=alert(1)>", "<img src=x onerror=alert(1)>"), ("scene=plaza&frame=120", "120"), ("scene=plaza&frame=-1", "-1"),
    ("scene=plaza&pose=1,2,3", "six numbers"), ("scene=plaza&pose=2147483647,0,0,0,0,0", "range")])
def test_a_wrong_link_opens_the_first_scene_with_a_sentence(chromium, address, link, said):
    with opened(chromium, f"{address}#{urllib.parse.quote(link, safe='=&')}") as page:
        assert said in page.inner_text("#banner") and page.input_value("#scene") == "plaza" and not page.query_selector("#banner *")
        assert re.fullmatch("[0-9a-f]{8}", crc(page))


def test_an_image_that_is_dropped_is_checked_by_the_library_and_drawn(chromium, address, site):
    image = (site / "scenes" / "w3.fxls").read_bytes()
    with opened(chromium, f"{address}#frame=3") as page:
        paused(page)
        before = crc(page)
        drop(page, "broken<b>.fxls", image[:-5] + bytes(5))
        shows(page, "#banner", ".")
        assert "scene refused" in page.inner_text("#banner") and not page.query_selector("#banner *")
        drop(page, "my<b>.glb", b"glTF")
        shows(page, "#banner", "make view")
        assert "my<b>.glb" in page.inner_text("#banner") and not page.query_selector("#banner *")
        drop(page, "mine.fxls", image)
        shows(page, "#scene-name", "mine.fxls")
        mine = crc(page)
    with opened(chromium, f"{address}#scene=w3&frame=0") as page:
        assert crc(page) == mine != before


def whole(text):
    """The number that a text begins with."""
    return int(re.match(r"[\d,]+", text)[0].replace(",", ""))


@pytest.mark.parametrize("board", ["pico", "mps2-an385", "rv32"])
def test_what_a_frame_costs_is_what_predict_says(chromium, address, board, tmp_path):
    run("make", "predict", f"BOARD={board}", "SCENE=scenes/spin.toml", f"JSON={tmp_path}/cost.json", f"BADGE={tmp_path}/badge.svg", folder=CHECKOUT)
    result = json.loads((tmp_path / "cost.json").read_text(encoding="utf-8"))
    cost, cycles = result["instructions_per_frame"], result["cycles"]
    with opened(chromium, f"{address}#scene=spin&frame=0") as page:
        page.select_option("#board", board)
        shows(page, "#cost", "instructions")
        taken, spent, parts = [], [], []
        for _ in range(int(page.inner_text("#number").split(" of ")[1])):
            taken.append(whole(page.inner_text("#cost")))
            if cycles:
                spent.append(whole(page.inner_text("#cycles")))
                parts.append([whole(text) for text in page.locator("#parts tbody td:nth-child(2)").all_inner_texts()])
            page.click("#step")
        with page.expect_download() as download:
            page.click("#badge")
        assert pathlib.Path(download.value.path()).read_text(encoding="utf-8") == (tmp_path / "badge.svg").read_text(encoding="utf-8")
        words = page.inner_text("#cost-words")
        assert f"{-(-result['ram']['program'] // 1024):,} of" in words and f"of {result['flash']['of'] // 1024:,} KB of flash" in words
        if not cycles:
            assert page.inner_text("#cycles") == "" and "no rate" in words and page.is_disabled("#clock")
    assert (min(taken), max(taken)) == (cost["min"], cost["max"])
    if cycles:
        assert (min(spent), max(spent)) == (cycles["min"], cycles["max"])
        means = [sum(each) / len(parts) for each in zip(*parts)]
        assert all(abs(mean - stage) <= 0.5 for mean, stage in zip(means, result["stages"].values())) and len(means) == 5


def test_a_walk_and_a_file_of_yours_are_counted_in_the_page(chromium, address, site, tmp_path):
    """The counted frame is one of the path of the first scene, whose costs the site has on the first board."""
    def told(page):
        shows(page, "#cost-words", f"BOARD={costs.FIRST}")
        shows(page, "#cost", "instructions$")
        return [page.inner_text(f"#{name}") for name in ("cost", "cycles", "parts")]

    with opened(chromium, f"{address}#scene=plaza&frame=3") as page:
        of_path, words = told(page), page.inner_text("#cost-words")
        programs.run_program([CHECKOUT / "build" / "host" / "frames", site / "scenes" / "plaza.fxls", tmp_path / "frames.fxld"])
        frame = dump.read_dump(tmp_path / "frames.fxld").frames[3]
        pose = ",".join(str(number) for number in (*frame.position, *frame.angles))
        assert not any("counter.wasm" in url for url in page.asked)
        page.evaluate(f"location.hash = '#scene=plaza&frame=3&pose={pose}'")
        shows(page, "#number", "of your walk")
        assert told(page) == of_path and page.inner_text("#cost-words") == words
        drop(page, "mine.fxls", (site / "scenes" / "plaza.fxls").read_bytes())
        for _ in range(3):
            page.click("#step")
        shows(page, "#number", "^3 of")
        assert told(page) == of_path and page.inner_text("#cost-words") == words
        page.select_option("#board", "microbit")
        shows(page, "#cost-words", "^fixel predict says")
        drop(page, "large.fxls", (site / "scenes" / "gallery.fxls").read_bytes())
        assert sum("counter.wasm" in url for url in page.asked) == 1


def test_a_rate_is_of_the_clock_and_says_what_it_is_of(chromium, address):
    with opened(chromium, f"{address}#scene=spin&frame=0") as page:
        page.fill("#clock", "250")
        cycles = whole(page.inner_text("#cycles"))
        assert page.inner_text("#cycles").endswith(f": {250e6 / cycles:.0f} frames a second of drawing alone, by the model, code in RAM")
        page.fill("#clock", "")
        assert "second" not in page.inner_text("#cycles") and "by the model" in page.inner_text("#cycles")
        page.select_option("#board", "microbit")
        shows(page, "#cost", "instructions|no room")
        assert page.inner_text("#cycles") == "" and page.is_disabled("#clock")


def test_a_board_without_room_says_so(chromium, address):
    with opened(chromium, f"{address}#scene=gallery&frame=0") as page:
        page.select_option("#board", "microbit")
        shows(page, "#cost", "^no room$")
        assert "/" not in page.inner_text("#cost-words").split(":")[0] and page.inner_text("#cost-words").endswith(".")


def test_it_stands_still_for_who_asks_for_less_motion(chromium, address):
    with opened(chromium, address, reduced_motion="reduce") as page:
        assert page.get_attribute("#pause", "aria-pressed") == "true" and page.inner_text("#number").startswith("0 of ")


def test_without_script_there_are_a_picture_and_the_words(chromium, address):
    with opened(chromium, address, waits=False, java_script_enabled=False) as page:
        assert page.is_visible("noscript img") and page.is_visible("#unserved") and "http.server" in page.inner_text("#unserved")


def test_opened_as_a_file_it_says_which_command_serves_it(chromium, site):
    with contextlib.closing(chromium.new_page()) as page:
        page.goto((site / "index.html").as_uri())
        assert page.is_visible("#unserved") and "http.server" in page.inner_text("#unserved")


def test_in_a_frame_of_another_page_there_is_the_picture_alone(chromium, address):
    with opened(chromium, f"{address}?embed#scene=spin&frame=4", (320, 272)) as page:
        assert page.evaluate("document.documentElement.scrollHeight") <= 272 and page.is_visible("#screen")
        for selector in ("header", "#words", "#pause", "#keys"):
            assert not page.is_visible(selector), selector
        frame = page.text_content("#crc")
        with page.context.expect_page() as whole:
            page.click("#whole")
        whole.value.wait_for_selector("#unserved", state="hidden")
        assert whole.value.inner_text("#crc") == frame and whole.value.is_visible("#words")


# --- scenes -------------------------------------------------------------------------

def test_each_scene_has_a_picture_a_page_its_code_and_its_command(chromium, address, site):
    """So has each program of examples/ and each model of make showcase."""
    with opened(chromium, f"{address}gallery.html", waits=False) as page:
        groups = [section.locator("article b").all_inner_texts() for section in page.locator("main section").all()]
        links = [link.get_attribute("href") for link in page.locator("article a").all()]
    names = [each["name"] for each in scenes_of(site)]
    folders = {file.parent.name for file in (CHECKOUT / "examples").glob("*/*.c")}
    assert [sorted(group) for group in groups] == [sorted(names), sorted(folders), sorted(each.name for each in showcase_models.MODELS)]
    assert len(names) > 20 and groups[0][-1] != "plaza"     # what the bench draws comes last
    for link in links:
        page, name = (site / link).read_text(encoding="utf-8"), pathlib.Path(link).stem
        assert re.search(r"(^|&amp;&amp; |>)make run BOARD=\w", page) and Image.open((site / link).parent / re.search(r'<figure>.*?<img src="([^"]+)"', page, re.DOTALL)[1]).width >= 96, link
        if link.startswith("scenes/"):
            assert f'href="../index.html#scene={name}"' in page and name in {each["name"] for each in all_scenes_of(site)}
        source = pathlib.Path("examples") / name / ("game.c" if name == "game" else "main.c") if link.startswith("examples/") else pathlib.Path("scenes") / f"{name}.toml"
        if not name.startswith(MODEL):
            assert html.escape((CHECKOUT / source).read_text(encoding="utf-8")) in page and f"{source.parent if name != 'game' else 'PROGRAM=game'}" in page, link
    with opened(chromium, f"{address}scenes/plaza.html", waits=False) as page:
        page.click("text=Draw it")
        page.wait_for_selector("#unserved", state="hidden")
        assert page.input_value("#scene") == "plaza"


def test_the_command_of_a_model_draws_its_scene(site, tmp_path):
    """What make run has of the model that make showcase makes, on the board of the command."""
    model = next(each for each in showcase_models.MODELS if each.name == "rainbow")
    page = html.unescape((site / "scenes" / f"{MODEL}{model.name}.html").read_text(encoding="utf-8"))
    words = re.search(r"<code>(make showcase ONLY=rainbow && make run BOARD=pico SCENE=build/showcase/rainbow.obj)</code>", page)
    file = showcase_models.write(model, tmp_path)
    options = predict.parser().parse_args(["--board", "pico", "--scene", str(file), "--build", str(CHECKOUT / "build")])
    scene_options.check(options)
    predict.complete(options)
    assert words and predict.image_of(options, tmp_path).read_bytes() == (site / "scenes" / f"{MODEL}{model.name}.fxls").read_bytes()


# --- programs -----------------------------------------------------------------------

PROGRAMS = [each for each in programs_of.of_the_tree() if (CHECKOUT / "examples" / each.name / programs_of.MAIN).exists()]


@pytest.mark.parametrize("program", PROGRAMS, ids=[each.name for each in PROGRAMS])
def test_a_program_draws_in_the_page_what_make_run_draws(chromium, address, program, tmp_path):
    own = tmp_path / program.name
    shutil.copytree(CHECKOUT / "examples" / program.name, own)
    programs_of.write_headers(program, own)
    run("make", "run", "BOARD=host", f"PROGRAM={own}", f"OUT={tmp_path}/out", folder=CHECKOUT)
    expected = json.loads((tmp_path / "out" / "summary.json").read_text(encoding="utf-8"))["frame_crc"]
    with opened(chromium, f"{address}examples/{program.name}.html") as page:
        paused(page)
        while not page.inner_text("#number").startswith("0 of "):
            page.click("#step")
        assert page.evaluate(STEPS, len(expected)) == expected and page.inner_text("#number") == f"0 of {len(expected)}"


def test_a_program_that_cannot_run_in_a_page_is_named_with_the_reason(chromium, address, tmp_path, monkeypatch):
    assert {each.name for each in programs_of.of_the_tree()} - {each.name for each in PROGRAMS} == {"game"}
    with opened(chromium, f"{address}examples/game.html", waits=False) as page:
        assert "It does not run in a page: it has no main.c" in page.inner_text("main") and not any(url.endswith(".wasm") for url in page.asked)
    monkeypatch.setattr(programs_of, "EXAMPLES", tmp_path)
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "main.c").write_text("int read_sensor(void);\nint main(void)\n{\n    return read_sensor();\n}\n", encoding="utf-8")
    mine = programs_of.Program("mine", "reads", tmp_path / "no.png")
    assert programs_of.compiled(mine, CHECKOUT / "build" / "web" / "own", tmp_path / "mine.wasm").why_not == "it needs read_sensor, which you write"


def test_the_list_for_models_leads_to_every_document(site):
    text = (site / "llms.txt").read_text(encoding="utf-8")
    assert text.startswith("# Fixel\n\n> 3-D for")
    links = re.findall(r"^- \[[^]]+\]\(([^)]+)\)$", text, re.MULTILINE)
    assert len(links) > 80 and all((site / link).is_file() for link in links)


# --- the documents ------------------------------------------------------------------

def test_the_documents_and_their_search_work_as_files(chromium, site):
    with opened(chromium, (site / "documents" / "index.html").as_uri(), waits=False) as page:
        page.fill("input[name=q]", "fxl_band_crc")
        page.press("input[name=q]", "Enter")
        page.wait_for_selector("#search-results li a")
        assert "crc" in " ".join(page.locator("#search-results li").all_inner_texts()).lower()


@pytest.mark.parametrize("document", ["pico", "gallery", "scenes/plaza", "scenes/beam", "scenes/model-scan", "examples/turn", "examples/game", *(f"documents/{name}" for name in (
    "index", "README", "SPEC", "docs/scenes", "docs/performance", "reference/fixel-scene", "docs/safety/rules"))])
def test_no_document_scrolls_sideways(chromium, address, document):
    with opened(chromium, f"{address}{document}.html", NARROW, waits=False) as page:
        assert page.evaluate("document.documentElement.scrollWidth") <= NARROW[0]


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("page", ["index", "gallery", "scenes/plaza", "examples/turn", "pico", "documents/index", "documents/README", "documents/SPEC", "documents/docs/performance",
                                  "documents/reference/fixel-render"])
def test_nothing_serious_keeps_anybody_out(chromium, address, page, scheme):
    assert_accessible(chromium, f"{address}{page}.html", scheme, waits=page in ("index", "examples/turn"))


class Links(html.parser.HTMLParser):
    """The links of a page, and the places in it that links may lead to."""

    def __init__(self):
        super().__init__()
        self.links, self.places = set(), set()

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if name in ("href", "src") and value is not None:
                self.links.add(value)
            elif name in ("id", "name") and value:
                self.places.add(value)


def test_every_link_leads_somewhere(site, record_property):
    pages = {}
    for file in site.rglob("*.html"):
        pages[file] = Links()
        pages[file].feed(file.read_text(encoding="utf-8"))
    count, dead = 0, []
    for file, found in pages.items():
        for link in found.links:
            address = urllib.parse.urlparse(link)
            if address.scheme or link.startswith("//"):
                continue
            count += 1
            target = pathlib.Path(file.parent / urllib.parse.unquote(address.path)).resolve() if address.path else file
            place = urllib.parse.unquote(address.fragment)
            is_scene = place.startswith("scene=") and (site / "scenes" / f"{place.removeprefix('scene=')}.fxls").exists()
            if not target.exists() or (place and target in pages and place not in pages[target].places and not is_scene):
                dead.append(f"{file.relative_to(site)}: {link}")
    assert not dead, dead[:20]
    record_property("figure", f"{count} links of {len(pages)} pages")


def test_every_public_function_and_document_is_in_what_docs_writes(site, tmp_path):
    run("make", "docs", f"OUT={tmp_path}/docs", folder=CHECKOUT)
    assert sorted(file.relative_to(tmp_path / "docs") for file in (tmp_path / "docs").rglob("*.html")) == \
        sorted(file.relative_to(site / "documents") for file in (site / "documents").rglob("*.html"))
    texts = {name: (CHECKOUT / "lib" / "include" / name).read_text(encoding="utf-8")
             for name in (str(file.relative_to(CHECKOUT / "lib" / "include")) for file in (CHECKOUT / "lib" / "include").rglob("*.h"))}
    named = {name for text in texts.values() for name in re.findall(r"^\w[\w ]*[ *](fxl_\w+)\(", text, re.MULTILINE)}
    pages = "".join(file.read_text(encoding="utf-8") for file in (site / "documents" / "reference").glob("*.html"))
    assert len(named) > 110 and not [name for name in named if f">{name}</span>" not in pages]
    assert (site / "documents" / "SPEC.html").exists() and (site / "documents" / "docs" / "tutorials" / "model.html").exists()
