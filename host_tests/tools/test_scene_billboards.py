# SPDX-License-Identifier: MIT
"""Scene files with billboards: the image, refusals, and frames before the reference renderer."""

import json
import subprocess

import pytest
from PIL import Image

from conftest import CHECKOUT, run_cli
from fixel.board import dump
from fixel.image import image
from fixel.base.errors import ToolError
from fixel.scene.target import VALUES
# place field: images that are broken, for the tools
from scene_sections import section
from model_files import build

BUILT_PROGRAMS = ("host/frames", "host/judge")
BOARD = '[[billboards]]\nname = "b"\npattern = "tree"\npixels = [5, 6]\nsize = [2, 3]\n'
OBJECT = '[[objects]]\nbillboard = "b"\nposition = [0, 0, 9]\n'
ONE = 65536
SCENES = ("scenes/grove.toml", "host_tests/fuzz/scenes/billboards.toml")


def refused(folder, text):
    with pytest.raises(ToolError) as error:
        build(folder, text)
    return str(error.value)


# --- the image -----------------------------------------------------------------------------------

def test_a_billboard_stands_on_its_foot(tmp_path):
    scene = build(tmp_path, BOARD + OBJECT)
    board, = scene.billboards.boards
    assert scene.billboards.model_map == [1]
    assert (board.width, board.height, board.anchor_x, board.anchor_y) == (2 * ONE, 3 * ONE, ONE, 0)
    assert (board.pixel_width, board.pixel_height, board.bits, board.key) == (5, 6, 8, 0)
    model, = scene.models
    assert sorted(model.vertices) == [(-ONE, 0, 0), (-ONE, 3 * ONE, 0), (ONE, 0, 0), (ONE, 3 * ONE, 0)]
    assert model.faces[0].normal == (0, 0, -1 << 30)


def test_without_billboards_an_image_is_as_before(tmp_path):
    blob = image.pack(build(tmp_path, '[[objects]]\nsolid = "box"\nposition = [0, 0, 9]\n'))
    assert [section(blob, name) for name in ("billboards", "billboard map", "sprite pixels")] == [(0, 0)] * 3


def test_copies_share_a_model_and_pictures_their_pixels(tmp_path):
    """formats 1.13b."""
    scene = build(tmp_path, BOARD + BOARD.replace('"b"', '"c"').replace("[2, 3]", "[1, 1]") +
                  OBJECT.replace("position = [0, 0, 9]", "positions = [[0, 0, 9], [1, 0, 9]]") + OBJECT.replace('"b"', '"c"'))
    assert len(scene.objects) == 3 and scene.billboards.model_map == [1, 2]
    blob = image.pack(scene)
    assert len(blob) < len(image.pack(build(tmp_path, BOARD + OBJECT))) + 400      # 5 x 6 bytes once


def values(scene):
    """The values of the pixels of the first billboard, row by row."""
    board = scene.billboards.boards[0]
    length = (board.pixel_width * board.bits + 7) // 8
    rows = []
    for y in range(board.pixel_height):
        number = int.from_bytes(board.pixels[y * length:(y + 1) * length], "big")
        shift = 8 * length - board.bits
        rows.append([number >> (shift - x * board.bits) & ((1 << board.bits) - 1) for x in range(board.pixel_width)])
    return rows


@pytest.mark.parametrize("bits", [1, 4, 8])
def test_pixels_of_a_file(tmp_path, bits):
    red, blue = (255, 0, 0), (0, 0, 255)
    picture = Image.new("RGB", (11, 2), red)
    picture.putpixel((2, 0), blue)
    picture.putpixel((10, 1), blue)
    picture.save(tmp_path / "p.png")
    text = BOARD.replace('pattern = "tree"\npixels = [5, 6]', f'file = "p.png"\nbits = {bits}')
    scene = build(tmp_path, text.replace("size", "most_colours = 2\nsize") + OBJECT)
    board = scene.billboards.boards[0]
    shown = [[scene.palette[v if bits == 8 else board.colours[v]] for v in row] for row in values(scene)]
    assert board.key == 256
    assert shown == [[blue if (x, y) in ((2, 0), (10, 1)) else red for x in range(11)] for y in range(2)]
    keyed = build(tmp_path, text.replace("size", 'key = "#0000ff"\nmost_colours = 1\nsize') + OBJECT)
    board = keyed.billboards.boards[0]
    assert [[v == board.key for v in row] for row in values(keyed)] == [[p == blue for p in row] for row in shown]


def test_what_is_clear_is_not_drawn(tmp_path):
    picture = Image.new("RGBA", (3, 1), (9, 8, 7, 255))
    picture.putpixel((1, 0), (9, 8, 7, 100))
    picture.save(tmp_path / "p.png")
    scene = build(tmp_path, BOARD.replace('pattern = "tree"\npixels = [5, 6]', 'file = "p.png"\nbits = 1') + OBJECT)
    assert values(scene) == [[0, 1, 0]] and scene.billboards.boards[0].key == 1


def test_an_object_with_a_billboard_moves(tmp_path):
    scene = build(tmp_path, BOARD + OBJECT + 'size = 2\nmotion = { circle = 2, degrees = 5 }\n')
    assert len(scene.motions) == 1 and scene.placements[0].scale == 2 * ONE


@pytest.mark.parametrize("text, says", [
    (BOARD + OBJECT.replace('"b"', '"c"'), 'there is no billboard "c"; the scene\'s billboards: b'),
    (BOARD + BOARD + OBJECT, 'there is a billboard "b" already'),
    (BOARD + "anchor = [3, 0]\n" + OBJECT, "anchor"),
    (BOARD + "bits = 1\n" + OBJECT, "3 colours and what is not drawn do not go into 1 bits a pixel"),
    (BOARD + 'key = "red"\n' + OBJECT, "belongs to a file"),
    (BOARD.replace('pattern = "tree"\npixels = [5, 6]', 'file = "none.png"') + OBJECT, "there is no file"),
    (BOARD + OBJECT + "rotation = 5\n", 'unknown key "rotation"'),
    (BOARD + OBJECT + "ring = { count = 2, radius = 1, turned = true }\n", "turned means nothing for a billboard"),
])
def test_wrong_billboards_are_refused(tmp_path, text, says):
    assert says in refused(tmp_path, text)


def test_a_tree_keeps_billboards(tmp_path):
    """They are no part of the tree's object, and go to its layer."""
    file, whole = tmp_path / "grove.fxls", tmp_path / "whole.fxls"
    for path, options in ((whole, ()), (file, ("--tree", "all"))):
        done = run_cli("build", CHECKOUT / SCENES[0], "-o", path, *options)
        assert done.returncode == 0, done.stderr
    made, before = (image.unpack(path.read_bytes()) for path in (file, whole))

    def shown(scene):
        numbers = scene.billboards.model_map
        return [(item.centre, numbers[item.model]) for item in scene.objects if numbers[item.model]]

    assert shown(made) == shown(before) and len(shown(made)) > 10
    layer = made.objects[made.tree.object].layer
    assert {item.layer for item in made.objects if made.billboards.model_map[item.model]} == {layer}
    assert made.billboards.model_map[made.objects[made.tree.object].model] == 0


# --- frames --------------------------------------------------------------------------------------

@pytest.fixture(scope="module", params=SCENES, ids=lambda name: name.split("/")[-1], name="built")
def fixture_built(request, tmp_path_factory):
    """A scene's image."""
    file = tmp_path_factory.mktemp("billboards") / "scene.fxls"
    done = run_cli("build", CHECKOUT / request.param, "-o", file)
    assert done.returncode == 0, done.stderr
    return file


def drawn(build, built, folder, *options):
    out = folder / f"{'-'.join(options) or 'plain'}.fxld"
    done = subprocess.run([build / "host" / "frames", built, out, *options], text=True, capture_output=True, check=False)
    return done, out


@pytest.fixture(scope="module", name="planted")
def fixture_planted(tmp_path_factory):
    """The image of a scene with a tree."""
    file = tmp_path_factory.mktemp("planted") / "scene.fxls"
    done = run_cli("build", CHECKOUT / SCENES[0], "-o", file, "--tree", "all")
    assert done.returncode == 0, done.stderr
    return file


@pytest.mark.parametrize("pixels", VALUES["pixels"])
def test_frames_by_a_tree_are_those_of_the_reference(build, planted, tmp_path, pixels):
    done, out = drawn(build, planted, tmp_path, "--pixels", pixels)
    assert done.returncode == 0, done.stderr
    subprocess.run([build / "host" / "judge", planted, out, "--json", tmp_path / "judged.json"], check=True)
    verdict = json.loads((tmp_path / "judged.json").read_text())
    assert verdict["pixels_unexplained"] == 0 and verdict["pixels"] > 0
    _, banded = drawn(build, planted, tmp_path, "--pixels", pixels, "--rows", "7", "--list", "300")
    frames = [[bytes(frame.pixels) for frame in dump.read_dump(file).frames] for file in (out, banded)]
    assert frames[0] == frames[1]


@pytest.mark.parametrize("method", [None, "sorted", "tree", "surfaces", "depth", "depth-32"])
def test_frames_are_those_of_the_reference(build, built, tmp_path, method):
    options = ["--hidden", method] if method else []
    done, out = drawn(build, built, tmp_path, *options)
    assert done.returncode == 0, done.stderr
    subprocess.run([build / "host" / "judge", built, out, "--json", tmp_path / "judged.json", *options], check=True)
    verdict = json.loads((tmp_path / "judged.json").read_text())
    assert verdict["pixels_unexplained"] == 0
    _, banded = drawn(build, built, tmp_path, *options, "--rows", "7", "--list", "300")
    pixels = [[bytes(frame.pixels) for frame in dump.read_dump(file).frames] for file in (out, banded)]
    assert pixels[0] == pixels[1]


def test_a_missing_billboard_would_be_seen(build, built, tmp_path):
    """The judge does not take a frame whose billboards are faces. It takes long where much is wrong: a part of the path."""
    scene = image.load(str(built))
    scene.path = scene.path[:3]
    whole, without = tmp_path / "whole.fxls", tmp_path / "without.fxls"
    whole.write_bytes(image.pack(scene))
    scene.billboards = None
    without.write_bytes(image.pack(scene))
    _, out = drawn(build, without, tmp_path)
    subprocess.run([build / "host" / "judge", whole, out, "--json", tmp_path / "judged.json"], check=False)
    assert json.loads((tmp_path / "judged.json").read_text())["pixels_unexplained"] > 100


@pytest.mark.parametrize("method", ["spans", "tree-spans"])
def test_other_methods_refuse_the_scene(build, built, tmp_path, method):
    done, _ = drawn(build, built, tmp_path, "--hidden", method)
    assert done.returncode == 2 and "do not go together" in done.stderr
