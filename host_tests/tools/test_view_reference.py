# SPDX-License-Identifier: MIT
"""What the reference renderer says in the live window of a board's frame: which face a pixel shows, and whether it
differs beyond the bound of `make run`; against the judge, which reads the same frames from a file."""

import json
import queue
import subprocess

import numpy
import pytest

from board_programs import ROOT
from test_view_page import MARK, TURNING, canvases, numbers, show_beside, state, step
from fixel.scene import making
from fixel.board import dump
from fixel.image import image
from fixel.view import browser
from fixel.view.view_reference import FACES, FRAME, OUTLINES, Reference, VERDICT, WANTS_ALL
from viewers import HEIGHT, WIDTH, ready

BUILT_PROGRAMS = ("boards/mps2-an385/walk.elf", "host/frames", "host/judge", "host/live")
FRAMES = 4
NO_FACE = 0xFFFF
EQUAL, WITHIN, BEYOND = range(3)


class Case:
    """Frames that the library drew of a scene, and what the judge says of them."""

    def __init__(self, build, folder, name, *methods):
        self.build, self.methods = build, [] if "--pixels" in methods else methods   # the image asks for its pixels
        self.image = folder / f"{name}.fxls"
        making.build(str(ROOT / "scenes" / f"{name}.toml"), str(self.image), None, (160, 120))
        frames, names, verdict = (folder / each for each in ("frames.fxld", "names.fxld", "verdict.json"))
        self.run("frames", self.image, frames, "--frames", str(FRAMES), *methods)
        self.run("judge", self.image, frames, "--json", verdict, "--names", names, *self.methods)
        self.verdict = json.loads(verdict.read_text())
        self.frames, self.names = dump.read_dump(frames).frames, dump.read_dump(names).frames

    def run(self, program, *words):
        subprocess.run([self.build / "host" / program, *words], check=True, stderr=subprocess.DEVNULL)

    def answers(self, frames, wants):
        found = queue.Queue()
        reference = Reference(self.build / "host" / "live", self.image, found.put, found.put, self.methods)
        try:
            for frame in frames:
                reference.ask(frame, wants)     # a frame that is not begun would be replaced, so each is waited for
                yield found.get()
        finally:
            reference.close()


FACE = numpy.dtype([("face", "<u2", 2), ("distance", "<f4"), ("texel", "<u2", 2), ("level", "<u2", 2)])


def shown_of(answer):
    """What each pixel shows, as FACE."""
    return numpy.frombuffer(answer.parts[2], FACE).reshape(answer.frame.pixels.shape)


def faces_of(answer):
    """[instance, face] of each pixel."""
    return shown_of(answer)["face"]


def verdict_of(answer):
    return numpy.frombuffer(answer.parts[3], numpy.uint8).reshape(answer.frame.pixels.shape)


def names_of(faces):
    """What host_tests/judges/reference calls these faces in a dump of names: ref_face_name; 0 for the background."""
    mixed = (faces[..., 0] * numpy.uint32(2654435761)) ^ (faces[..., 1] * numpy.uint32(2246822519))
    return numpy.where(faces[..., 0] == NO_FACE, 0, 1 + (mixed >> 16) % 255)


@pytest.mark.parametrize("name, methods", [("plaza", ()), ("spin", ()), ("beam", ()), ("knot", ("--hidden", "depth")),
                                           ("w3", ("--clipper", "near"))])
def test_the_faces_of_a_frame(name, methods, build, tmp_path):
    """The judge's names of faces are those that rays find (test_surface_frames.py and `make run`)."""
    case = Case(build, tmp_path, name, *methods)
    for answer, names in zip(case.answers(case.frames, FRAME | FACES), case.names):
        faces = faces_of(answer)
        assert numpy.array_equal(names_of(faces.astype(numpy.uint32)), names.pixels)
        assert len(numpy.unique(faces.reshape(-1, 2), axis=0)) > 5


# A wall of 80 texels a unit, five units away, and a post before it.
WALL = """
screen = {{ width = 160, height = 120 }}
view = {{ focal = 160, near = 0.5, far = 20{more} }}

[[textures]]
name = "wall"
pattern = "bricks"
size = [16, 32]

[[objects]]
solid = "box"
scale = [6, 6, 2]
position = [0, 0, 6]
texture = "wall"
texels_per_unit = 80

[[objects]]
solid = "box"
scale = [0.5, 6, 1]
position = [0, 0, 3.5]
colour = "teal"
layer = 1

[path]
keys = [{{ position = [0, 0, 0] }}]
"""


@pytest.mark.parametrize("more", ["", ", depth = 16", ', pixels = "rgb565"'])
def test_how_far_away_and_which_texel(build, tmp_path, more):
    (tmp_path / "wall.toml").write_text(WALL.format(more=more), encoding="utf-8")
    case = Case(build, tmp_path, tmp_path / "wall", *(["--pixels", "rgb565"] if "rgb565" in more else []))
    (answer,) = case.answers(case.frames, FRAME | FACES)
    shown = shown_of(answer)
    wall, post = (shown["face"][..., 0] == number for number in (0, 1))
    assert wall.sum() + post.sum() == 160 * 120 and 0 < post.sum() < wall.sum()
    assert numpy.allclose(shown["distance"][wall], 5, rtol=1e-6) and numpy.allclose(shown["distance"][post], 3, rtol=1e-6)
    assert (shown["level"][post] == 0).all() and (shown["level"][wall] == (16, 32)).all()
    assert (shown["texel"][wall] < (16, 32)).all()
    # A pixel is 5 / 160 units wide there, which are two texels and a half.
    columns = shown["texel"][2, :20, 0].astype(int)
    assert set(numpy.diff(columns) % 16) <= {2, 3, 13, 14} and len(set(numpy.diff(columns) % 16)) == 2


def test_the_colours_of_faces(build, tmp_path):
    """In a scene without light, beams and surfaces a pixel has the colour of its face."""
    case = Case(build, tmp_path, "plaza")
    scene = image.load(case.image)
    (answer,) = case.answers(case.frames[:1], FRAME | FACES)
    colours = {(NO_FACE, NO_FACE): scene.background}
    for number, each in enumerate(scene.objects):
        colours.update({(number, place): face.colour for place, face in enumerate(scene.models[each.model].faces)})
    shown = numpy.frombuffer(answer.parts[0], numpy.uint8)
    assert [colours[tuple(face)] for face in faces_of(answer).reshape(-1, 2).tolist()] == shown.tolist()


@pytest.mark.parametrize("name", ["room", "car", "plaza"])
def test_the_verdict_is_the_judges(name, build, tmp_path):
    case = Case(build, tmp_path, name)
    for answer, judged in zip(case.answers(case.frames, VERDICT), case.verdict["frames"]):
        verdict = verdict_of(answer)
        assert (verdict != EQUAL).sum() == judged["pixels_differing"]
        assert (verdict == BEYOND).sum() == judged["pixels_unexplained"] == 0
    assert name == "plaza" or case.verdict["pixels_differing"] > 0


def test_a_pixel_of_another_colour_is_beyond_the_bound(build, tmp_path):
    case = Case(build, tmp_path, "room")
    frame = case.frames[0]
    pixels = frame.pixels.copy()
    pixels[60, 80] = next(colour for colour in range(256) if colour not in pixels)
    changed = dump.Frame(frame.number, frame.position, frame.angles, pixels, frame.counters, 0, 0)
    before, after = map(verdict_of, case.answers([frame, changed], VERDICT))
    assert before[60, 80] != BEYOND and after[60, 80] == BEYOND
    before, after = before.copy(), after.copy()
    before[60, 80] = after[60, 80] = 0
    assert numpy.array_equal(before, after)


def test_parts_that_come_together_are_those_that_come_alone(build, tmp_path):
    case = Case(build, tmp_path, "car")
    (whole,) = case.answers(case.frames[:1], WANTS_ALL)
    for place, wants in enumerate((FRAME, OUTLINES, FACES, VERDICT)):
        (alone,) = case.answers(case.frames[:1], wants)
        assert alone.parts[place] == whole.parts[place] and alone.parts[place]
        assert not any(alone.parts[:place] + alone.parts[place + 1:])


def begin_paused(page):
    """Has the board draw its first frame, and no other before step: what keys do then depends on no time."""
    page.click("#pause")
    state(page, "paused")
    page.click("#restart")
    page.wait_for_function("() => document.getElementById('number').textContent === '0'")


def wait_for_beside(page):
    """Until what is beside the frame is of the same one."""
    page.wait_for_function("() => document.getElementById('number').textContent === "
                           "document.getElementById('other-number').textContent")


# Pixels of a frame that may show another texel or level than the reference does: within their bounds of
# docs/extras/surfaces.md, which `make run` judges.
SURFACES = {"landscape": 20, "gallery": 1000, "car": 50, "room": 1000}


@pytest.mark.parametrize("name", SURFACES)
def test_a_scene_with_surfaces_is_walked_beside_the_reference(name, chromium, build, tmp_path):
    """build/view/<scene>.png is how it looked."""
    ready("mps2-an385", build)
    image = tmp_path / f"{name}.fxls"
    making.build(str(ROOT / "scenes" / f"{name}.toml"), str(image), None, (160, 120))
    with browser.viewing("mps2-an385", image, build) as (_, address), \
            browser.page(chromium, address, WIDTH, HEIGHT) as page:
        page.set_default_timeout(0)
        begin_paused(page)
        show_beside(page, "1", "double")
        first, _ = canvases(page, "fixed", "other")
        page.keyboard.down("ArrowRight")
        for _ in range(TURNING):
            step(page)
        page.keyboard.up("ArrowRight")
        step(page)
        wait_for_beside(page)
        fixed, double = canvases(page, "fixed", "other")
        assert (fixed != first).any(axis=2).mean() > 0.01
        assert len(numpy.unique(fixed.reshape(-1, 3), axis=0)) > 10
        assert fixed.shape == double.shape and (fixed != double).any(axis=2).sum() <= SURFACES[name]
        (build / "view").mkdir(exist_ok=True)
        page.screenshot(path=str(build / "view" / f"{name}.png"))
        assert page.complaints == []


def test_a_pixel_within_the_bound_is_no_difference(chromium, build, tmp_path):
    """Surfaces show other texels than the reference does, all of them within the bound of `make run`."""
    ready("mps2-an385", build)
    image = tmp_path / "room.fxls"
    making.build(str(ROOT / "scenes" / "room.toml"), str(image), None, (160, 120))
    with browser.viewing("mps2-an385", image, build) as (_, address), \
            browser.page(chromium, address, WIDTH, HEIGHT) as page:
        page.set_default_timeout(0)
        begin_paused(page)
        show_beside(page, "2", "difference")
        seen = set()
        page.keyboard.down("ArrowRight")
        for _ in range(20):
            step(page)
            wait_for_beside(page)
            pixels, together, _, within = numbers(page, "other-name")
            (shown,) = canvases(page, "other")
            assert pixels == together == (shown == MARK).all(axis=2).sum() == 0
            seen.add(within)
        assert max(seen) > 0
        assert page.complaints == []
