# SPDX-License-Identifier: MIT
"""Surfaces of faces that a tree cuts when the scene is built: each part shows the texels and the light of the whole face."""

import json

import numpy
import pytest
from conftest import CHECKOUT, run_cli
from host_frames import drawn, judged
from drawn_scenes import head
from scene_sections import section

from fixel.board import dump
from fixel.image import image
from fixel.scene import compiler
from fixel.scene.target import VALUES

BUILT_PROGRAMS = ("host/frames", "boards/host/walk", "boards/microbit/walk.elf", "boards/mps2-an385/walk.elf", "host/judge", "host/raycast", "host/predict")
TARGETS = VALUES["pixels"]
TEXTURES = [("stones", "stones", 32), ("planks", "planks", 32, "bits = 4"), ("grille", "grille", 16)]
SCREEN = 'background = "#203040"\n' + head(128, 96, ['pixels = "%s"', "near = 0.125", "far = 64"], TEXTURES) + """
[light]
levels = 16
direction = [0.3, -1, 0.8]
ambient = 0.35
fog = { near = 4, far = 30 }
points = [{ position = [1, 2, -2], range = 9, strength = 0.7 }]
"""

# Boxes through each other and through the floor, each with a surface of its own.
CROSSING = """
[[objects]]
solid = "tile"
scale = [16, 1, 16]
position = [0, -1, 2]
texture = "planks"
texels_per_unit = 8
[[objects]]
solid = "box"
scale = [5, 1.2, 1.2]
position = [0, 0, 1]
rotation = 25
texture = "stones"
[[objects]]
solid = "box"
scale = [1.1, 5, 1.1]
position = [0.4, 0, 1]
rotation = [10, 40, 0]
texture = "planks"
smooth = true
[[objects]]
solid = "box"
scale = [1, 1, 6]
position = [-1, 0.3, 1.5]
texture = "grille"
two_sided = true
[[objects]]
solid = "tile"
scale = [4, 1, 3]
position = [1, 0.4, 0]
rotation = [0, 0, 30]
colour = "#78c8d8"
two_sided = true
%s
[path]
keys = [{ position = [2.5, 2, -4], look_at = [0, 0, 1], frames = 6 }, { position = [-4, 1, -2], look_at = [0, 0, 1] }]
"""

# A floor that fills the screen, and panes through it that are turned away from all eyes of the path: the tree cuts the floor by them.
FLOOR = """
[[objects]]
solid = "tile"
scale = [40, 1, 40]
position = [0, -3, 8]
texture = "stones"
texels_per_unit = 4
division = %s
%s
[[objects]]
solid = "tile"
scale = [60, 1, 9]
rotation = [%s, -90, 0]
colour = "#ff0000"
shade = false
positions = [%s]
[path]
keys = [{ position = [0, 0, 0], pitch = -50, frames = 5 }, { position = [0.5, 0.6, 0.2], yaw = 4, pitch = -47 }]
"""


def compiled(folder, text, layers):
    """(the scene, its image)."""
    file = folder / "scene.toml"
    file.write_text(text)
    scene, _ = compiler.compile_scene(str(file), layers=layers)
    made = folder / f"{layers}.fxls"
    made.write_bytes(image.pack(scene))
    return scene, made


def pictures(dumped):
    return [frame.pixels for frame in dump.read_dump(dumped).frames]


def tree_faces(scene):
    """The faces of the tree's model that have a surface, and their records."""
    faces = [face for face in scene.models[scene.objects[scene.tree.object].model].faces if face.mapped]
    return faces, {face.mapped for face in faces}


@pytest.mark.parametrize("pixels", TARGETS)
@pytest.mark.parametrize("last", ["opacity = 6", "blend = true"])
def test_parts_are_those_of_the_reference(build, tmp_path, pixels, last):
    scene, made = compiled(tmp_path, SCREEN % pixels + CROSSING % last, "all")
    faces, records = tree_faces(scene)
    assert len(faces) > len(records) + 10 and scene.surfaces.normals
    out = drawn(build, made, made.stem)
    verdict = judged(build, made, out)
    assert verdict["pixels_unexplained"] == 0 < verdict["texel_pixels"]
    whole = pictures(out)
    for options in (("--rows", "7"), ("--rows", "7", "--list", "60"), ("--rows", "7", "--cores", "2")):
        assert all(map(numpy.array_equal, whole, pictures(drawn(build, made, made.stem, *options)))), options


@pytest.mark.parametrize("pixels", TARGETS)
def test_a_board_draws_the_host_s_frames(build, tmp_path, pixels):
    (tmp_path / "scene.toml").write_text('tree = "all"\n' + SCREEN % pixels + CROSSING % "opacity = 6")
    done = run_cli("run", "--board", "mps2-an385", "--scene", tmp_path / "scene.toml", "--frames", 3, "--out", tmp_path / "out")
    assert done.returncode == 0, done.stdout + done.stderr
    summary = json.loads((tmp_path / "out" / "summary.json").read_text(encoding="utf-8"))
    assert summary["host_frames_equal"] and summary["pixels_unexplained"] == 0 and summary["frames"] == 3
    assert summary["pixels_differing"] < summary["pixels"] / 20


@pytest.mark.parametrize("pixels", TARGETS)
def test_the_stack_of_the_smallest_board_holds_the_deepest_scene(tmp_path, pixels):
    """Beams on lit textures, some of which move among a tree; the board notices an overflow."""
    text = (CHECKOUT / "bench" / "costs_deepest_tree.toml").read_text(encoding="utf-8")
    (tmp_path / "scene.toml").write_text(text.replace("[view]", f'[view]\npixels = "{pixels}"'))
    done = run_cli("run", "--board", "microbit", "--scene", tmp_path / "scene.toml", "--out", tmp_path / "out")
    assert done.returncode == 0, done.stdout + done.stderr
    summary = json.loads((tmp_path / "out" / "summary.json").read_text(encoding="utf-8"))
    assert summary["host_frames_equal"] and summary["pixels_unexplained"] == 0 and summary["frames"] == 4


def test_parts_share_the_record_of_the_whole(tmp_path):
    """Its vertices stay in the model, also where no part has them for corners. formats 1.12c."""
    text = SCREEN % "palette" + CROSSING % "opacity = 6"
    whole, _ = compiled(tmp_path, text, "none")
    scene, made = compiled(tmp_path, text, "all")
    planted = scene.models[scene.objects[scene.tree.object].model]
    lost = [face for face in planted.faces if face.mapped and not set(face.mapped.vertices) & set(face.corners)]
    assert lost
    faces, records = tree_faces(scene)
    assert len(records) == sum(len([face for face in whole.models[item.model].faces if face.mapped]) for item in whole.objects)
    for face in faces:
        points = [planted.vertices[vertex] for vertex in face.mapped.vertices]
        height = sum(n * c for n, c in zip(face.normal, planted.vertices[face.corners[0]]))
        assert all(abs(sum(n * c for n, c in zip(face.normal, point)) - height) < 16 << 30 for point in points)
    again = image.load(made)
    assert [face.mapped for face in again.models[-1].faces] == [face.mapped for face in planted.faces]


@pytest.mark.parametrize("pixels", TARGETS)
@pytest.mark.parametrize("division, more, yaw", [("16", "smooth = true", "0"), ("8", "lit = false", "20"), ("1", "", "-35"), ("16", "opacity = 9", "12")])
def test_a_cut_moves_no_texel(build, tmp_path, pixels, division, more, yaw):
    """A face cut and whole, bit for bit: all pixels of the frame are the face's."""
    text = SCREEN % pixels + FLOOR % (division, more, yaw, ", ".join(f"[0, -3, {0.7 * i + 1.5:.1f}]" for i in range(9)))
    scene, cut = compiled(tmp_path, text, "all")
    faces, records = tree_faces(scene)
    assert len(records) == 1 and len(faces) >= 4
    _, whole = compiled(tmp_path, text, "none")
    one, other = (pictures(drawn(build, made, made.stem)) for made in (cut, whole))
    assert len(one) == 6 and all(map(numpy.array_equal, one, other))
    assert all(len(numpy.unique(picture)) >= 3 for picture in one)


@pytest.mark.parametrize("pixels", TARGETS)
def test_the_parts_of_a_face_without_a_surface_have_its_colour(build, tmp_path, pixels):
    """Light takes the middle of the whole face: each frame has one colour. By their own middles the parts have others.
    formats 1.2ba-bb."""
    text = SCREEN % pixels + FLOOR % ("16", "", "20", ", ".join(f"[0, -3, {0.7 * i + 1.5:.1f}]" for i in range(9)))
    text = text.replace('texture = "stones"\ntexels_per_unit = 4\ndivision = 16\n', 'colour = "#d0c0b0"\n')
    scene, cut = compiled(tmp_path, text, "all")
    parts = [face for face in scene.models[scene.objects[scene.tree.object].model].faces if face.whole]
    assert len({face.corners for face in parts if face.normal == (0, 1 << 30, 0)}) >= 4
    assert [face.whole for face in image.load(cut).models[-1].faces] == \
        [face.whole for face in scene.models[scene.objects[scene.tree.object].model].faces]
    _, whole = compiled(tmp_path, text, "none")
    one, other = (pictures(drawn(build, made, made.stem)) for made in (cut, whole))
    assert len(one) == 6 and all(map(numpy.array_equal, one, other))
    assert all(len(numpy.unique(picture)) == 1 for picture in one)
    assert judged(build, cut, drawn(build, cut, "cut"))["pixels_unexplained"] == 0
    assert section(cut.read_bytes(), "wholes")[1] > 0
    text = "\n".join(line for line in text.splitlines() if not line.startswith(("levels", "fog", "points")))
    unlit, plain = compiled(tmp_path, text, "all")
    assert unlit.light is None and section(plain.read_bytes(), "wholes")[1] == 0
    for face in parts:
        face.whole = ()
    cut.write_bytes(image.pack(scene))
    assert any(len(numpy.unique(picture)) > 1 for picture in pictures(drawn(build, cut, "cut")))
