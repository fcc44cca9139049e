# SPDX-License-Identifier: MIT
"""What a scene asks for by itself: a depth buffer; objects in parts; an island, a torus."""

import math
import re

import pytest
from conftest import CHECKOUT, assert_one_sentence, run_cli
from drawn_scenes import head
from test_surface_frames import built, drawn, judged

from fixel.board import dump
from fixel.image import image
from fixel.model import mesh, solids
from fixel.scene import corner_normals, parts, toml_scene
from fixel.base.errors import ToolError
from fixel.board.programs import HostPrograms
from test_scene_mesh import ONE

BUILT_PROGRAMS = ("host/frames", "host/judge", "host/raycast")


# A bar through a ball, and a ring about it.
SOLIDS = head(96, 72, ["near = 1", "far = 32"]) + """
%s
[[objects]]
solid = "sphere"
scale = 2
colour = "crimson"
[[objects]]
solid = "box"
scale = [0.5, 4, 0.5]
colour = "gold"
[[objects]]
solid = "torus"
scale = [4, 1, 4]
colour = "teal"
[path]
orbit = { centre = [0, 0, 0], radius = 6, height = 2, frames = 12 }
"""
ISLAND = head(96, 72, ["near = 0.5", "far = 64"]) + """
[[objects]]
solid = "island"
cells = [12, 9]
seed = 5
scale = [20, 5, 15.3]
anchor = "base"
colours = ["khaki", "green", "brown", "white"]
%s
[path]
orbit = { centre = [0, 1, 0], radius = 14, height = 5, frames = 12 }
"""


def scene_of(folder, text, name="scene"):
    file = folder / f"{name}.toml"
    file.write_text(text)
    return file


def pixels(file):
    return [frame.pixels.tobytes() for frame in dump.read_dump(file).frames]


# --- the visibility method --------------------------------------------------------------

def test_a_scene_that_asks_for_a_depth_buffer_is_drawn_with_one(build, tmp_path):
    image_file = built(scene_of(tmp_path, SOLIDS % 'visibility = "depth"'), tmp_path)
    unasked = drawn(build, image_file, "unasked")
    assert pixels(unasked) == pixels(drawn(build, image_file, "depth", "--hidden", "depth"))
    assert pixels(unasked) != pixels(drawn(build, image_file, "sorted", "--hidden", "sorted"))
    assert judged(build, image_file, unasked)["pixels_unexplained"] == 0, "the judge goes by the scene too"


def test_a_scene_that_asks_for_nothing_is_drawn_by_distance(build, tmp_path):
    image_file = built(scene_of(tmp_path, SOLIDS % ""), tmp_path)
    assert pixels(drawn(build, image_file, "unasked")) == pixels(drawn(build, image_file, "sorted", "--hidden", "sorted"))


# place pixel-format: what the image says of pixels
def test_the_image_has_the_wish_in_one_byte(tmp_path):
    blobs = [image.pack(toml_scene.compile_file(str(scene_of(tmp_path, SOLIDS % text)))[0])
             for text in ("", 'visibility = "default"\npixels = "palette"\ndepth = 0', 'visibility = "depth"', "depth = 16",
                          'depth = 32\npixels = "rgb565"\norder = "distance"')]
    assert blobs[0] == blobs[1] and blobs[2] == blobs[3] and len(blobs[2]) == len(blobs[4])
    assert [at for at in range(16, len(blobs[2])) if blobs[2][at] != blobs[4][at]] == [37]
    wishes = [(scene.depth_bits, scene.pixel_bits, scene.by_distance) for scene in map(image.unpack, blobs)]
    assert wishes == [(0, 8, False)] * 2 + [(16, 8, False)] * 2 + [(32, 16, True)]
    assert [blob[37] for blob in blobs] == [0, 0, 1, 1, 2 + 4 + 8]


@pytest.mark.parametrize("text, words", [
    ('visibility = "deep"', ("view: visibility", "depth")), ('pixels = "rgb888"', ("view: pixels", "rgb565")),
    ("depth = 24", ("depth", "0, 16 or 32", "24")), ('depth = "16"', ("depth", "0, 16 or 32")), ("depth = true", ("0, 16 or 32",)),
    ('visibility = "depth"\ndepth = 32', ("visibility", "only one of")),
    ('order = "depth"', ("view: order", "distance")), ('order = "tree"', ("order", 'tree = "all"'))])
def test_an_unknown_wish_is_refused(tmp_path, text, words):
    done = run_cli("build", scene_of(tmp_path, SOLIDS % text), "-o", tmp_path / "out.fxls")
    assert_one_sentence(done, *words)


def test_the_dark_of_a_lit_scene_is_told_in_16_bits(tmp_path):
    lit = SOLIDS % "" + '\n[light]\nlevels = 8\ndark = "#204080"\n'
    assert image.pack(toml_scene.compile_file(str(scene_of(tmp_path, lit)))[0])[38:40] == (4 << 11 | 16 << 5 | 16).to_bytes(2, "little")


def test_a_tree_and_a_depth_buffer_exclude_each_other(tmp_path):
    done = run_cli("build", scene_of(tmp_path, SOLIDS % 'visibility = "depth"'), "-o", tmp_path / "out.fxls",
                   "--tree", "all")
    assert_one_sentence(done, "depth buffer", "--tree")


def test_a_header_of_c_says_what_the_scene_asks_for(tmp_path):
    for text, said in (('visibility = "depth"', "fxl_palette_depth_16"), ('depth = 32\npixels = "rgb565"', "fxl_rgb565_depth_32"),
                       ('pixels = "rgb565"', "fxl_rgb565"), ("", "fxl_palette")):
        out = tmp_path / "scene.h"
        done = run_cli("export", "--c", scene_of(tmp_path, SOLIDS % text), "-o", out)
        assert done.returncode == 0, done.stderr
        config = re.search(r"fxl_config \w+ = \{(.*?)\}", out.read_text(), re.DOTALL)[1]
        assert re.findall(r"&(\w+), NULL, (\w+)", config) == [(said, "scene_palette_565" if "rgb565" in text else "NULL")]


@pytest.mark.parametrize("name", ["gallery", "car"])
def test_what_the_new_scenes_show_is_explained(build, tmp_path, name):
    image_file = built(CHECKOUT / "scenes" / f"{name}.toml", tmp_path)
    verdict = judged(build, image_file, drawn(build, image_file, "unasked"))
    assert verdict["pixels_unexplained"] == 0


# --- the tree ---------------------------------------------------------------------------

def built_by_cli(folder, text, *options):
    """The image of a scene, as fixel build makes it."""
    out = folder / "scene.fxls"
    done = run_cli("build", scene_of(folder, text), "-o", out, *options)
    assert done.returncode == 0, done.stderr
    return out.read_bytes()


def test_a_scene_asks_for_its_tree_and_the_command_line_has_the_last_word(tmp_path):
    solids = SOLIDS % ""
    plain, planted = built_by_cli(tmp_path, solids), built_by_cli(tmp_path, solids, "--tree", "all")
    assert image.unpack(plain).tree is None and image.unpack(planted).tree.nodes
    assert built_by_cli(tmp_path, 'tree = "all"' + solids) == planted
    assert built_by_cli(tmp_path, 'tree = "most"' + solids) == planted, "one layer"
    assert built_by_cli(tmp_path, 'tree = "none"' + solids) == plain
    assert built_by_cli(tmp_path, 'tree = "all"' + solids, "--tree", "none") == plain
    assert built_by_cli(tmp_path, 'tree = "none"' + solids, "--tree", "0") == planted
    assert built_by_cli(tmp_path, 'tree = "all"' + SOLIDS % 'visibility = "depth"', "--tree", "none") == \
        built_by_cli(tmp_path, SOLIDS % 'visibility = "depth"')


def test_a_header_of_c_has_the_tree_that_the_scene_asks_for(tmp_path):
    done = run_cli("export", "--c", scene_of(tmp_path, 'tree = "all"' + SOLIDS % ""), "-o", tmp_path / "scene.h")
    assert done.returncode == 0 and re.search(r"fxl_bsp_node scene_\w+\[\d+\] = ", (tmp_path / "scene.h").read_text())


@pytest.mark.parametrize("value, words", [
    ('"7"', ("tree: the layers of the tree are", "all, most or none")), ('"trees"', ("tree: the layers of the tree are", "of 0")),
    ('""', ("tree: the layers of the tree are",))])
def test_a_wrong_tree_is_refused(tmp_path, value, words):
    done = run_cli("build", scene_of(tmp_path, f"tree = {value}" + SOLIDS % ""), "-o", tmp_path / "out.fxls")
    assert_one_sentence(done, "scene.toml", *words)


def test_a_scene_that_asks_for_a_tree_and_a_depth_buffer_is_refused(tmp_path):
    done = run_cli("build", scene_of(tmp_path, 'tree = "all"' + SOLIDS % 'visibility = "depth"'), "-o", tmp_path / "out.fxls")
    assert_one_sentence(done, "scene.toml: tree", "depth buffer", "leave the tree out")
    assert image.unpack(built_by_cli(tmp_path, 'tree = "all"' + SOLIDS % 'order = "distance"\ndepth = 16')).by_distance


# --- parts ------------------------------------------------------------------------------

def placed_faces(scene):
    """The outlines of all faces in the world, with their colours."""
    made = []
    for thing in scene.objects:
        model = scene.models[thing.model]
        for face in model.faces:
            made.append((tuple(tuple(a + b for a, b in zip(thing.centre, model.vertices[c])) for c in face.corners),
                         scene.palette[face.colour]))
    return sorted(made)


def test_parts_are_the_same_faces_in_the_same_places(tmp_path):
    whole, _ = toml_scene.compile_file(str(scene_of(tmp_path, ISLAND % "")))
    divided, _ = toml_scene.compile_file(str(scene_of(tmp_path, ISLAND % "parts = [4, 3]")))
    assert len(whole.objects) == 1 and 8 < len(divided.objects) <= 12
    assert placed_faces(whole) == placed_faces(divided)
    assert max(len(model.faces) for model in divided.models) <= 18
    assert {thing.centre[1] for thing in divided.objects} == {whole.objects[0].centre[1]}


def test_a_part_is_at_the_middle_of_its_cell(tmp_path):
    divided, _ = toml_scene.compile_file(str(scene_of(tmp_path, ISLAND.replace("%s", "sea = 0\nparts = [2, 1]"))))
    places = sorted(thing.centre[0] for thing in divided.objects)
    assert len(places) == 2 and places[0] == -places[1] and abs(places[1] - 5 * 65536) < 65536


def test_parts_show_the_same_picture_with_a_depth_buffer(build, tmp_path):
    files = [built(scene_of(tmp_path, ISLAND % text, name), tmp_path, name)
             for name, text in (("whole", ""), ("parts", "parts = [4, 3]"))]
    assert pixels(drawn(build, files[0], "a", "--hidden", "depth")) == pixels(drawn(build, files[1], "b", "--hidden", "depth"))


@pytest.mark.parametrize("text, word", [("parts = [0, 2]", "parts"), ("parts = 4", "parts"), ("parts = [2, 2]\nturn = 5", "parts"),
                                        ("parts = [2, 2, 2]", "parts"), (f"parts = [{parts.MOST + 1}, 2]", "parts")])
def test_wrong_parts_are_refused(tmp_path, text, word):
    with pytest.raises(ToolError, match=word):
        toml_scene.compile_file(str(scene_of(tmp_path, ISLAND % text)))


# --- solids -----------------------------------------------------------------------------

def test_heights_of_an_island():
    rows = solids.heights((16, 12), 7, 0.25)
    assert len(rows) == 13 and {len(row) for row in rows} == {17}
    border = rows[0] + rows[-1] + [row[0] for row in rows] + [row[-1] for row in rows]
    assert set(border) == {0} and max(map(max, rows)) == 1 and min(map(min, rows)) == 0
    assert rows == solids.heights((16, 12), 7, 0.25) != solids.heights((16, 12), 8, 0.25)


def test_more_sea_leaves_fewer_faces():
    counts = [len(solids.island((16, 16), 3, sea).faces) for sea in (0, 0.3, 0.6)]
    assert 512 >= counts[0] > counts[1] > counts[2] > 0


def test_an_island_has_the_colours_of_its_heights():
    made = solids.island((16, 16), 3, 0.2)
    colours = solids.by_height(made, ("low", "middle", "high"))
    height = {c: [] for c in colours}
    for face, colour in zip(made.faces, colours):
        height[colour].append(sum(made.vertices[c][1] for c in face))
    assert set(height) == {"low", "middle", "high"}
    assert max(height["low"]) < min(height["middle"]) and max(height["middle"]) < min(height["high"])


@pytest.mark.parametrize("text", ["seed = -1", "sea = 1", 'sides = 5'])
def test_wrong_islands_are_refused(tmp_path, text):
    with pytest.raises(ToolError):
        toml_scene.compile_file(str(scene_of(tmp_path, ISLAND.replace("seed = 5\n", "") % text)))


def test_a_torus_is_closed_and_has_one_hole():
    made = mesh.shape(solids.make("torus", {"sides": 12, "rings": 6}, "torus"), ONE, "torus")
    edges = {frozenset(pair) for face in made.faces for pair in zip(face.corners, face.corners[1:] + face.corners[:1])}
    assert made.open_edges == 0 and not made.notes
    assert len(made.vertices) - len(edges) + len(made.faces) == 0
    assert min(math.hypot(x, z) for x, _, z in made.vertices) > 65536 // 4


# --- both sides -------------------------------------------------------------------------

def test_fronts_and_backs_are_smooth_each_for_itself():
    one = mesh.shape(solids.make("sphere", {}, "sphere"), ONE, "sphere")
    both = mesh.two_sided(one)
    normals = corner_normals.smooth_normals(both)
    count = len(one.faces)
    assert normals[:count] == corner_normals.smooth_normals(one)
    for front, back in zip(normals[:count], normals[count:]):
        assert [tuple(-c for c in normal) for normal in front[::-1]] == back


# --- models that are no part of the project: where they are not, the tests are left out ----------

def documented(start):
    """The scene file of docs/scenes.md that stands indented after a line that begins so."""
    lines = (CHECKOUT / "docs/scenes.md").read_text(encoding="utf-8").splitlines()
    first = next(i for i, line in enumerate(lines) if start in line) + 1
    end = next(i for i in range(first, len(lines)) if lines[i] and not lines[i].startswith("    "))
    return "\n".join(line[4:] for line in lines[first:end])


@pytest.mark.parametrize("name", ["teapot", "spot"])
def test_a_model_of_yours_is_drawn_as_the_document_says(build, tmp_path, name):
    source = CHECKOUT.parent / "shared/models" / f"{name}.obj"
    if not source.exists():
        pytest.skip(f"{source} is not there")
    (tmp_path / source.name).write_bytes(source.read_bytes())
    text = documented("draws a smooth teapot").replace("teapot.obj", source.name).replace("frames = 24", "frames = 4")
    if name == "spot":
        text = text.replace("smooth = true", 'smooth = true\ntexture = "patches"\nmapping = "file"') + \
            "\n" + documented("patterns lies on the model's coordinates")
    image_file = built(scene_of(tmp_path, text), tmp_path)
    shown = drawn(build, image_file, "unasked", "--frames", "4")
    verdict = judged(build, image_file, shown, "--names", tmp_path / "names.fxld")
    assert verdict["pixels_unexplained"] == 0 and verdict["pixels_differing"] < verdict["pixels"] / 100
    rays = HostPrograms(build).raycast(image_file, tmp_path / "names.fxld", tmp_path / "rays.json", 2, "opaque")
    assert rays["pixels_unexplained"] == 0
