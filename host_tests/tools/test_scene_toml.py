# SPDX-License-Identifier: MIT
"""Scene files: every key, every refusal, and the scenes that come with Fixel."""

from decimal import Decimal
from fractions import Fraction
import json
from pathlib import Path
import re
import subprocess
import sys
import tomllib

import pytest

from model_files import png
from fixel.image import c_scene, image, image_header
from fixel.scene import keys, toml_motion, toml_object, toml_scene
from fixel.base.errors import ToolError
from fixel.scene.toml_table import REQUIRED, Table, inline

BUILT_PROGRAMS = ()
ROOT = Path(__file__).resolve().parents[2]
BOX = '[[objects]]\nsolid = "box"\nposition = [0, 0, 5]\n'
PATH = "[path]\nkeys = [{ position = [0, 0, 0] }]\n"


def build(tmp_path, text, frames=None):
    file = tmp_path / "scene.toml"
    file.write_text(text)
    return toml_scene.compile_file(str(file), frames)


def refused(tmp_path, text, *parts):
    with pytest.raises(ToolError) as caught:
        build(tmp_path, text)
    for part in ("scene.toml", *parts):
        assert part in str(caught.value)


def test_least_scene_uses_the_defaults(tmp_path):
    scene, notes = build(tmp_path, BOX + PATH)
    assert (scene.width, scene.height, scene.inset) == (320, 240, 0)
    assert len(scene.models[0].faces) == 6 and scene.objects[0].centre == (0, 0, 5 << 16)
    assert scene.models[0].kind == image.CONVEX and scene.frames == 1 and not notes
    assert image.unpack(image.pack(scene)) == scene


@pytest.mark.parametrize("text, parts", [
    (BOX + "colr = 'red'\n" + PATH, ['unknown key "colr"', '"colour"']),
    ("backround = 'red'\n" + BOX + PATH, ['"backround"', '"background"']),
    (BOX + "solid2 = 1\n" + PATH, ["object 0", "solid2"]),
    (BOX.replace("box", "piramid") + PATH, ["piramid", '"pyramid"']),
    (BOX.replace("box", "bocks") + PATH, ["bocks", "one of: box, pyramid"]),
    (BOX + f"scale = {10**400}\n" + PATH, ["scale", "out of every range"]),
    (BOX.replace("[0, 0, 5]", "[0, 9000, 5]") + PATH, ["object 0", "position[1] = 9000", "8191"]),
    (BOX.replace("[0, 0, 5]", "[0, 8191, 5]") + PATH, ["object 0", "vertex", "at y", "8191.5"]),
    (BOX + "scale = nan\n" + PATH, ["scale", "out of every range"]),
    (BOX + "rotation = ['x', 0, 0]\n" + PATH, ["rotation[0]", '"x"']),
    (BOX + "quaternion = [1, 2, 3]\n" + PATH, ["quaternion", "[w, x, y, z]"]),
    (BOX + "quaternion = [0, 0, 0, 0]\n" + PATH, ["quaternion", "[1, 0, 0, 0]"]),
    (BOX + "quaternion = [1, 0, 0, 1073741825]\n" + PATH, ["quaternion[3]", "1073741824"]),
    (BOX + "quaternion = [1, 0, 0, 1]\nrotation = 5\n" + PATH, ["rotation", "quaternion"]),
    (BOX + "colour = 'crimsn'\n" + PATH, ["crimsn", "crimson"]),
    (BOX + "colour = 'red'\ncolour_index = 3\n" + PATH, ["exclude"]),
    (BOX + "colour_step = 2\n" + PATH, ["needs colour_index"]),
    (BOX + "sides = 5\n" + PATH, ["sides", "box"]),
    (BOX + "obj = 'x.obj'\n" + PATH, ["both obj and solid"]),
    ("[[objects]]\nobj = 'none.obj'\n" + PATH, ["object 0: obj", "none.obj", "no file"]),
    ("[view]\nfocal = 2000\n" + BOX + PATH, ["view: focal", "10..150"]),
    ("[view]\nfov = 60\nfocal = 200\n" + BOX + PATH, ["both fov and focal"]),
    ("[view]\nnear = 3\nfar = 3\n" + BOX + PATH, ["not below"]),
    ("[light]\ndirection = [0, 0, 0]\n" + BOX + PATH, ["no direction"]),
    (BOX + "[path]\n", ["path", "none is given"]),
    (BOX + "[path]\nkeys = [{ position = [0, 0, 8192] }]\n", ["keys[0]", "position[2] = 8192"]),
    (BOX + "[path]\nkeys = [{ position = [0, 0, 0], look_at = [0, 0, 0] }]\n", ["look_at"]),
    (BOX + "[path]\nkeys = [{ position = [0, 0, 0], look_at = [0, 0, 1], yaw = 1 }]\n",
     ["keys[0]", "one or the other"]),
    (BOX + "[path]\nsteps = [{ keys = ['forwards'] }]\n", ["forwards", '"forward"']),
    (BOX + "[path]\norbit = { radius = 9000 }\n", ["orbit", "frame 0"]),
    ("objects = 3\n" + PATH, ["objects", "list"]),
    ("a = \n", ["not TOML"]),
])
def test_refusals_say_where_and_what(tmp_path, text, parts):
    refused(tmp_path, text, *parts)


def test_rationals_and_turns_are_exact(tmp_path):
    text = ('[[objects]]\nsolid = "box"\nscale = "1/512"\nposition = ["-360/512", "1.5", 1e2]\n'
            '[path]\nkeys = [{ position = [0, 0, 0], yaw = "472/512 turn", pitch = -90 }]\n')
    scene, _ = build(tmp_path, text)
    assert scene.objects[0].centre == (-360 * 128, 98304, 100 << 16)
    assert scene.models[0].vertices[0] == (-64, -64, -64)
    assert scene.path[0][3:] == (472 << 23, 3 << 30, 0)


def test_focal_and_range_ends_of_the_field_of_view(tmp_path):
    assert build(tmp_path, "[view]\nfocal = 160\n" + BOX + PATH)[0].fov == 1 << 30
    assert build(tmp_path, "[view]\nfov = 10\n" + BOX + PATH)[0].fov == image_header.FOV_MIN
    assert build(tmp_path, "[view]\nfov = 150\n" + BOX + PATH)[0].fov == image_header.FOV_MAX
    scene, _ = build(tmp_path, "[view]\nfocal = 277.25\nnear = 1\n" + BOX + PATH)
    assert round(image_header.focal_pixels(320, scene.fov) * 65536) == 277.25 * 65536


def test_the_centre_of_the_lens(tmp_path):
    assert build(tmp_path, BOX + PATH)[0].centre is None
    assert build(tmp_path, "[view]\ncentre = [160, 120.0]\n" + BOX + PATH)[0].centre is None
    assert build(tmp_path, "[view]\ncentre = [-0.5, '481/2']\n" + BOX + PATH)[0].centre == (-32768, 481 << 15)


def test_an_export_names_the_centre(tmp_path):
    scene, _ = build(tmp_path, "[view]\ncentre = [-0.5, 60]\n" + BOX + PATH)
    text = c_scene.header(scene, "x", "x.toml")
    assert "#define X_CENTRE_X (-32768)\n#define X_CENTRE_Y 3932160\n" in text
    assert "fxl_renderer_set_centre(&renderer," in text
    assert "CENTRE" not in c_scene.header(build(tmp_path, BOX + PATH)[0], "x", "x.toml")


def test_another_screen_keeps_the_perspective(tmp_path):
    """Half as wide: half of the focal length, so the centre is half as far from the middle."""
    file = tmp_path / "x.toml"
    file.write_text("[view]\ncentre = [200, 60]\n" + BOX + PATH)
    scene, _ = toml_scene.compile_file(str(file), screen=(160, 200))
    assert scene.centre == ((80 + 20) << 16, (100 - 30) << 16)


@pytest.mark.parametrize("view, words", [
    ("centre = [641, 120]", "the centre's x = 641 is farther from the middle"),
    ("centre = [160, -241]", "the centre's y = -241 is farther"), ("fov = 150\ncentre = [340, 0]", "four focal lengths"),
    ("centre = [0, 0]\ninset = 0.1", "has no inset")])
def test_a_centre_that_cannot_be_is_refused(tmp_path, view, words):
    with pytest.raises(ToolError, match=words):
        build(tmp_path, f"[view]\n{view}\n" + BOX + PATH)


@pytest.mark.parametrize("near", ["0.2", "0.07", "1/256"])
def test_a_small_near_plane_is_no_matter_for_the_default_clipper(tmp_path, near):
    assert not build(tmp_path, f'[view]\nfocal = 160\nnear = "{near}"\n' + BOX + PATH)[1]


def test_copies_share_models_and_colours_part_them(tmp_path):
    text = ('[[objects]]\nsolid = "box"\nrepeat = { count = [2, 1, 3], step = [2, 0, 4] }\n'
            + BOX + BOX + 'colour = "red"\n' + PATH)
    scene, _ = build(tmp_path, text)
    assert len(scene.objects) == 8 and len(scene.models) == 2
    assert [o.centre for o in scene.objects[:3]] == [(0, 0, 0), (2 << 16, 0, 0), (0, 0, 4 << 16)]


def test_copies_of_all_objects_together_have_a_limit(tmp_path, monkeypatch):
    monkeypatch.setattr(toml_object, "INSTANCES_MAX", 5)

    def copies(count):
        return f"{BOX}repeat = {{ count = [{count}, 1, 1], step = [2, 0, 0] }}\n"
    assert len(build(tmp_path, copies(3) + copies(2) + PATH)[0].objects) == 5
    refused(tmp_path, copies(3) + copies(3) + PATH, "object 1", "3 copies", "at most 5 objects", "3 stand before these")
    refused(tmp_path, copies(6) + PATH, "6 copies", "0 stand before these")


def test_ring_turns_its_copies(tmp_path):
    text = ('[[objects]]\nsolid = "box"\nscale = [1, 1, 3]\nring = { count = 4, radius = 5 }\n'
            + PATH)
    scene, _ = build(tmp_path, text)
    assert [o.centre for o in scene.objects] == [(0, 0, 5 << 16), (5 << 16, 0, 0),
                                                 (0, 0, -5 << 16), (-5 << 16, 0, 0)]
    extents = [max(v[2] for v in scene.models[o.model].vertices) for o in scene.objects]
    assert extents == [98304, 32768, 98304, 32768]


def test_an_object_turned_like_a_camera_looks_where_the_camera_looks():
    # SPEC.md, section 1: yaw turns +z towards +x, pitch raises it, roll lifts the right side.
    def axes(*rotation):
        rows = toml_object.matrix((1, 1, 1), [Fraction(a) for a in rotation])
        return [tuple(row[i] for row in rows) for i in range(3)]
    right, _, forward = axes(90, 0, 0)
    assert forward == (1, 0, 0) and right == (0, 0, -1)
    assert axes(0, 90, 0)[2] == (0, 1, 0)
    assert axes(0, 0, 90)[0] == (0, 1, 0)


def test_a_quaternion_turns_as_rotation_does(tmp_path):
    """orientation 1.5, 1.7: of any norm and either sign, exactly; and copies on a ring turn after it."""
    def vertices(turn):
        scene, _ = build(tmp_path, f'[[objects]]\nsolid = "box"\nscale = [1, 2, 3]\n{turn}\nring = {{ count = 4, radius = 5 }}\n' + PATH)
        return [scene.models[each.model].vertices for each in scene.objects]
    for one, other in (("[90, 0, 0]", "[1, 0, 1, 0]"), ("[0, 90, 0]", "[5, -5, 0, 0]"), ("[0, 0, 90]", "[-0.5, 0, 0, -0.5]"),
                       ("[180, 0, 0]", "[0, 0, 16384, 0]"), ("[0, 0, 0]", "[-7, 0, 0, 0]")):
        assert vertices(f"rotation = {one}") == vertices(f"quaternion = {other}")
    rows = toml_object.matrix((1, 1, 1), [Fraction(0)] * 3, tuple(map(Fraction, (1, 2, 3, 4))))
    assert rows == [[Fraction(n, 15) for n in row] for row in ((-10, 2, 11), (10, -5, 10), (5, 14, 2))]


def test_anchor_base_stands_on_the_ground_with_its_centre_in_the_middle(tmp_path):
    text = ('[[objects]]\nsolid = "pyramid"\nscale = 2\nposition = [0, 3, 0]\nanchor = "base"\n'
            + PATH)
    scene, _ = build(tmp_path, text)
    assert scene.objects[0].centre == (0, 4 << 16, 0)
    assert min(v[1] for v in scene.models[0].vertices) == -65536


def test_colour_index_gives_exact_palette_entries(tmp_path):
    text = ('[[objects]]\nsolid = "box"\ncolour_index = 253\ncolour_step = 1\ncolour_next = 6\n'
            "positions = [[0, 0, 5], [9, 0, 5]]\n" + PATH)
    scene, _ = build(tmp_path, text)
    colours = [[f.colour for f in scene.models[o.model].faces] for o in scene.objects]
    assert colours == [[253, 254, 255, 1, 2, 3], [4, 5, 6, 7, 8, 9]]


def test_what_would_help_where_colours_are_merged_in_rgb565(tmp_path):
    many = "".join(f'[[objects]]\nsolid = "tile"\nposition = [{i}, 0, 9]\ncolour = "#{i * 7 % 256:02x}{i // 2:02x}{i % 2 * 99:02x}"\n' for i in range(300))
    for light, words in (("", "light at run time"), ("[light]\nlevels = 4\n", "bits = 16")):
        notes = build(tmp_path, '[view]\npixels = "rgb565"\n' + light + many + PATH)[1]
        assert any("colours were merged into the 255 " in note and words in note for note in notes)


def test_all_colours_fit_the_palette(tmp_path):
    many = "".join(f'[[objects]]\nsolid = "sphere"\nposition = [{i}, 0, 9]\n'
                   f'colour = "#{i * 40 % 256:02x}{i * 70 % 256:02x}{i * 110 % 256:02x}"\n'
                   for i in range(12))
    scene, notes = build(tmp_path, many + PATH)
    assert any("colours were merged into the 255 " in note and 'pixels = "rgb565"' in note for note in notes)
    assert len(scene.palette) == 256
    assert all(1 <= f.colour <= 255 for m in scene.models for f in m.faces)
    full = '[[objects]]\nsolid = "floor"\ncells = [16, 16]\ncolour_index = 1\ncolour_step = 1\n'
    refused(tmp_path, full + BOX + PATH, "255 palette entries")


def test_a_model_that_is_not_convex_is_sorted_or_refused(tmp_path):
    (tmp_path / "two.obj").write_text(
        "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\nv 0 1 1\nv 1 0 1\nf 1 3 2\nf 4 6 5\n")
    text = '[[objects]]\nobj = "two.obj"\nposition = [0, 0, 5]\n'
    scene, notes = build(tmp_path, text + PATH)
    assert scene.models[0].kind == image.SORTED
    assert any("not convex" in note for note in notes)
    assert any("open" in note for note in notes)
    refused(tmp_path, text + 'kind = "convex"\n' + PATH, "object 0", "not convex")
    scene, _ = build(tmp_path, BOX + 'kind = "sorted"\n' + PATH)
    assert scene.models[0].kind == image.SORTED


def test_steps_become_strides_and_frames_cut_them(tmp_path):
    text = BOX + ("[path]\nsteps = [{ keys = ['forward', 'left'], frames = 3 }, "
                  "{ keys = ['pitch_up', 'roll_right'], frames = 4 }]\n"
                  "[path.start]\nposition = [1, 2, 3]\nyaw = 90\n[path.gait]\nturn = 45\n"
                  "acceleration = 1\nfriction = 0.5\nspeed_max = 2\n")
    scene, _ = build(tmp_path, text)
    assert scene.path == [(5, 3), (16 | 128, 4)] and scene.frames == 7
    assert scene.start == (65536, 131072, 196608, 1 << 30, 0, 0)
    assert scene.gait == (65536, 32768, 131072, 1 << 29)
    assert build(tmp_path, text, 5)[0].path == [(5, 3), (144, 2)]
    assert build(tmp_path, text, 3)[0].path == [(5, 3)]
    with pytest.raises(ToolError, match="8 frames are asked for, and the path has 7"):
        build(tmp_path, text, 8)


def _examples():
    return re.findall(r"```toml\n(.*?)```", (ROOT / "docs" / "scenes.md").read_text(), re.S)


def test_the_documents_examples_compile(tmp_path):
    examples = _examples()
    assert len(examples) >= 2
    for text in examples:
        scene, _ = build(tmp_path, text)
        assert image.unpack(image.pack(scene)) == scene


# place key: how the key is tried, if its table is new or it needs another beside it
# Of each table of keys: what stands before its keys in a scene file, keys beside the one that is tried, what stands after them, and the keys
# that are tried so; none: all of them.
MODEL = '[[objects]]\nmodel = "m.obj"\n'
TEXTURED = '[[textures]]\nname = "t"\npattern = "bricks"\nsize = [8, 8]\n[[objects]]\nsolid = "box"\n'
TRIED = [
    (keys.TOP, "", {}, BOX + PATH, {"background", "tree"}),
    (keys.TOP, "", {"objects": [{"solid": "box"}]}, "", {*keys.TOP} - {"background", "tree"}),
    (keys.SCREEN, "[screen]\n", {}, BOX + PATH, None), (keys.VIEW, "[view]\n", {}, BOX + PATH, None),
    (keys.GLOW, "[glow]\n", {}, "[[beams]]\ndirection = [1, -1, 0]\nwindow = [[0, 0, 0], [0, 1, 0], [0, 1, 1]]\n" + BOX + PATH, None),
    (keys.PALETTE, "[palette]\n", {"reserve": 9}, TEXTURED + 'blend = true\n' + PATH, None),
    (keys.HORIZON, "[horizon]\n", {"degrees": [0], "colours": ["red", "blue"]}, BOX + PATH, None),
    (keys.BEAM, "[[beams]]\n", {"direction": [1, -1, 0], "window": [[0, 0, 0], [0, 1, 0], [0, 1, 1]]}, BOX + PATH, {"direction", "window"}),
    (keys.BEAM, "[[beams]]\n", {"window": [[0, 0, 0], [0, 1, 0], [0, 1, 1]]}, BOX + PATH, {"position"}),
    (keys.PATH, BOX + "[path]\n", {}, "", {"keys", "orbit", "steps"}), (keys.PATH, BOX + "[path]\n", {"keys": [{"position": [0, 0, 0]}]}, "", {"interpolation"}),
    (keys.PATH, BOX + "[path]\n", {"steps": [{"keys": []}]}, "", {"start", "gait"}),
    (keys.PATH_KEY, BOX + "[[path.keys]]\n", {"position": [0, 0, 0]}, "", None), (keys.STEP, BOX + "[[path.steps]]\n", {"keys": []}, "", None),
    (keys.ORBIT, BOX + "[path.orbit]\n", {"radius": 9}, "", None),
    (keys.START, BOX + "[path]\nsteps = [{ keys = [] }]\n[path.start]\n", {}, "", None),
    (keys.GAIT, BOX + "[path]\nsteps = [{ keys = [] }]\n[path.gait]\n", {}, "", None),
    (keys.LIGHT, "[light]\n", {}, BOX + PATH, {"levels", *keys.BAKED}),
    (keys.LIGHT, "[light]\n", {"levels": 8}, BOX + PATH, {"direction", "ambient", *keys.AT_RUN_TIME}),
    (keys.POINT, "[light]\nlevels = 8\n[[light.points]]\n", {"position": [0, 0, 0], "range": 5}, BOX + PATH, None),
    (keys.FOG, "[light]\nlevels = 8\n[light.fog]\n", {"near": 1, "far": 2}, BOX + PATH, None),
    (keys.OBJECT, BOX.replace("position = [0, 0, 5]\n", ""), {}, PATH, {*keys.PLACES, *keys.TURNED, "sides", "seed", *(
        "name layer moves scale rotation quaternion anchor colour colours shade colour_index kind two_sided inside clusters parts opacity blend smooth".split())}),
    (keys.OBJECT, '[[objects]]\nsolid = "sphere"\n', {}, PATH, {"rings"}), (keys.OBJECT, '[[objects]]\nsolid = "prism"\n', {}, PATH, {"taper"}),
    (keys.OBJECT, '[[objects]]\nsolid = "island"\n', {}, PATH, {"cells", "sea"}), (keys.OBJECT, "[[objects]]\n", {}, PATH, {"solid", "obj", "model"}),
    (keys.OBJECT, BOX, {"colour_index": 3}, PATH, {"colour_step", "colour_next"}),
    (keys.OBJECT, MODEL, {}, PATH, {*keys.MODEL, "images", "vertex_colours"} - {"obj", "model"}),
    (keys.OBJECT, TEXTURED, {}, PATH, {"texture", "textures"}),
    (keys.OBJECT, TEXTURED, {"texture": "t"}, PATH, {"mapping", "tiles", "texels_per_unit", "texel_offset", "division"}),
    (keys.OBJECT, "[light]\nlevels = 8\n" + BOX, {}, PATH, {"lit"}),
    (keys.RING, BOX + "[objects.ring]\n", {"count": 2, "radius": 4}, PATH, None),
    (keys.REPEAT, BOX + "[objects.repeat]\n", {"count": [1, 1, 1], "step": [1, 1, 1]}, PATH, None),
    (keys.SPIN, BOX + "[objects.spin]\n", {"axis": [0, 1, 0], "degrees": 4}, PATH, {"axis", "degrees", "start"}),
    (keys.SPIN, BOX + "[objects.spin]\n", {}, PATH, {"yaw", "pitch", "roll"}),
    (keys.MOTION, BOX + "[objects.motion]\n", {"circle": 2, "degrees": 4}, PATH, {"circle", "degrees", "start", "facing"}),
    (keys.MOTION, BOX + "[objects.motion]\n", {"by": [1, 0, 0], "frames": 4}, PATH, {"by", "frames", "back", "repeats"}),
    (keys.MOTION, BOX + "[objects.motion]\n", {}, PATH, {"keys"}), (keys.MOTION_KEY, BOX + "[[objects.motion.keys]]\n", {}, PATH, None),
    (keys.IMAGES, MODEL + "[objects.images]\n", {}, PATH, None),
    (keys.OBJECT, BOX, {}, PATH, {*keys.LINES}), (keys.EDGES, BOX + "[objects.edges]\n", {}, PATH, None),
    (keys.POLYLINE, BOX + "[[objects.lines]]\n", {"at": [[0, 0, 0], [1, 0, 0]]}, PATH, None), (keys.DOTS, BOX + "[[objects.points]]\n", {"at": [[0, 0, 0]]}, PATH, None),
    (keys.TEXTURE, "[[textures]]\n", {"name": "u", "pattern": "bricks"}, BOX + PATH, {*keys.TEXTURE} - {"file", "most_colours"}),
    (keys.TEXTURE, "[[textures]]\n", {"name": "u"}, BOX + PATH, {"file"}),
    (keys.TEXTURE, "[[textures]]\n", {"name": "u", "file": "m.png"}, BOX + PATH, {"most_colours"}),
    (keys.BILLBOARD, "[[billboards]]\n", {"name": "u", "pattern": "tree", "size": [1, 1]}, BOX + PATH,
     {*keys.BILLBOARD} - {"file", "key", "most_colours"}),
    (keys.BILLBOARD, "[[billboards]]\n", {"name": "u", "size": [1, 1]}, BOX + PATH, {"file"}),
    (keys.BILLBOARD, "[[billboards]]\n", {"name": "u", "size": [1, 1], "file": "m.png"}, BOX + PATH, {"key", "most_colours"}),
    (keys.SPRITE, '[[billboards]]\nname = "b"\npattern = "tree"\nsize = [1, 1]\n[[objects]]\n', {"billboard": "b"}, PATH, None)]


@pytest.mark.parametrize("number", range(len(TRIED)))
def test_a_value_that_a_key_may_not_have_is_refused_by_the_keys_name(tmp_path, number):
    table, before, beside, after, tried = TRIED[number]
    (tmp_path / "m.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    (tmp_path / "m.png").write_bytes(png([[(1, 2, 3)]]))

    def lines(pairs):
        return before + "".join(f"{key} = {inline(value)}\n" for key, value in pairs.items()) + after
    for name in sorted(table if tried is None else tried):
        kind = table[name].kind
        if table[name].default is REQUIRED:
            refused(tmp_path, lines({key: value for key, value in beside.items() if key != name}), f'"{name}" is missing')
        for value in kind.wrong():
            with pytest.raises(ToolError) as caught:
                build(tmp_path, lines({**beside, name: value}))
            said = str(caught.value)
            assert said.startswith("scene.toml: ") and re.search(rf": {name}\b", said), (name, value, said)
            if type(value) is type(getattr(kind, "low", None)):
                assert re.search(rf"{re.escape(f'{float(kind.low):.10g}..{float(kind.high):.10g}')}", said), (name, value, said)


def test_every_key_of_every_table_is_tried_and_its_kind_reads_its_own_examples():
    """So the fuzzer's values are sound, and a new table or key is in TRIED."""
    tables = {name: table for name, table in vars(keys).items() if isinstance(table, dict) and name.isupper()}
    tried = {id(table): set() for table in tables.values()}
    for table, _, _, _, names in TRIED:
        tried[id(table)] |= set(table if names is None else names)
    parts = {"ANGLES", "PLACES", "TURNED", "MODEL", "SURFACE", "SOLID", "ANY_OBJECT", "STROKE", "MARK", "LINES"}       # of OBJECT and others
    assert {name: set(table) - tried[id(table)] for name, table in tables.items() if name not in parts} == \
        {name: set() for name in tables if name not in parts}
    for table in tables.values():
        for key in table.values():
            ends = [end for end in (getattr(key.kind, "low", None), getattr(key.kind, "high", None)) if end is not None]
            for value in [*key.kind.sound(), *(ends[1:] if getattr(key.kind, "above", False) else ends)]:
                key.kind.read(tomllib.loads(f"x = {inline(value)}", parse_float=Decimal)["x"], "here")


# place key: that the page says what each key means
def test_the_page_says_what_each_key_means():
    """test_documents.py asks whether `fixel formats` has made the page's rows."""
    page = (ROOT / "docs" / "scenes.md").read_text(encoding="utf-8")
    rows = [re.split(r"(?<!\\)\|", row) for block in re.findall(r"<!-- keys: \w+ -->\n(.*?)<!-- end -->", page, re.S) for row in block.splitlines()]
    assert len(rows) > 150 and not [row[1] for row in rows if not row[4].strip()]


RESERVED = """
[palette]
reserve = 250
colours = ["red", "#0f0"]
"""
FACES = """
[[objects]]
solid = "sphere"
rings = 8
sides = 16
colour = "white"
"""
ORBIT = "[path.orbit]\nradius = 9\nframes = 1\n"


def test_reserved_entries_are_last_and_no_face_has_one(tmp_path):
    scene, notes = build(tmp_path, RESERVED + FACES + ORBIT)
    assert scene.palette[6:8] == [(255, 0, 0), (0, 255, 0)] and set(scene.palette[8:]) == {(0, 0, 0)}
    assert {face.colour for model in scene.models for face in model.faces} <= set(range(1, 6))
    assert any("merged" in note for note in notes)
    free, _ = build(tmp_path, FACES + ORBIT)
    assert max(face.colour for model in free.models for face in model.faces) > 5
    text = c_scene.header(scene, "x", "x.toml")
    assert "#define X_RESERVED 6\n" in text and "RESERVED" not in c_scene.header(free, "x", "x.toml")


@pytest.mark.parametrize("palette, words", [
    ("reserve = 255", "use up all 255"),
    ("reserve = 1\ncolours = ['red', 'blue']", "2 colours are more than reserve = 1"),
    ("reserved = 1", "unknown")])
def test_a_palette_that_cannot_be_is_refused(tmp_path, palette, words):
    with pytest.raises(ToolError, match=words):
        build(tmp_path, f"[palette]\n{palette}\n" + FACES + ORBIT)


def test_an_entry_asked_for_is_not_a_reserved_one(tmp_path):
    with pytest.raises(ToolError, match="colour_index 250 is one of the entries 250..255"):
        build(tmp_path, "[palette]\nreserve = 6\n" + FACES.replace('colour = "white"', "colour_index = 250") + ORBIT)
    build(tmp_path, "[palette]\nreserve = 5\n" + FACES.replace('colour = "white"', "colour_index = 250") + ORBIT)


@pytest.mark.parametrize("name", ["plaza", "w1", "w3", "tiny", "cube", "window"])
def test_own_scenes_compile_and_fit(name):
    scene, _ = toml_scene.compile_file(str(ROOT / "scenes" / f"{name}.toml"))
    assert image.unpack(image.pack(scene)) == scene


def test_plaza_is_what_it_promises():
    scene, _ = toml_scene.compile_file(str(ROOT / "scenes" / "plaza.toml"))
    assert scene.frames == 120 and (scene.width, scene.height) == (320, 240)
    assert len(scene.objects) >= 30 and len(scene.models) >= 8
    assert all(m.kind == image.CONVEX for m in scene.models)
    # Frames 0 and 15 look along +z with vertices exactly on the far and the near
    # plane, inset and all, and inside the screen.
    slope = 160 / image_header.focal_pixels(320, scene.fov)
    for frame, depth in ((0, scene.far - scene.inset), (15, scene.near + scene.inset)):
        x, y, z, *turn = scene.path[frame]
        assert turn == [0, 0, 0]
        world = [[a + b for a, b in zip(v, o.centre)] for o in scene.objects
                 for v in scene.models[o.model].vertices]
        on_plane = [v for v in world if v[2] - z == depth and abs(v[0] - x) < slope * depth
                    and abs(v[1] - y) < slope * depth * 0.75]
        assert len(on_plane) >= 4
    behind = [o for o in scene.objects
              if all(v[2] + o.centre[2] < z for v in scene.models[o.model].vertices)]
    assert behind


def _workload(name):
    file = ROOT.parent / "shared" / "workloads" / name
    if not file.exists():
        pytest.skip(f"the workload {name} is not beside this checkout")
    return json.loads(file.read_text())


def _clockwise_set(outline):
    first = outline.index(min(outline))
    return tuple(outline[first:] + outline[:first])


def test_w1_holds_the_workloads_numbers():
    data = _workload("w1.json")
    scene, _ = toml_scene.compile_file(str(ROOT / "scenes" / "w1.toml"))
    assert [o.centre for o in scene.objects] == [tuple(128 * c for c in p)
                                                 for p in data["cube_centres"]]
    assert scene.path == [(*(128 * c for c in k["position"]), k["yaw"] % 512 << 23,
                           k["pitch"] % 512 << 23, 0) for k in data["camera"]]
    assert (scene.fov, scene.near, scene.far) == (1 << 30, 4096, 64 << 16)
    corners = [tuple(128 * c for c in v) for v in data["cube_vertices"]]
    for k, item in enumerate(scene.objects):
        model = scene.models[item.model]
        for i, (face, wanted) in enumerate(zip(model.faces, data["cube_faces_clockwise"])):
            assert face.colour == 1 + (6 * k + i) % 255
            assert (_clockwise_set([model.vertices[c] for c in face.corners])
                    == _clockwise_set([corners[c] for c in wanted]))


def test_w3_holds_the_workloads_numbers():
    data = _workload("w3.json")
    scene, _ = toml_scene.compile_file(str(ROOT / "scenes" / "w3.toml"))
    assert scene.objects[0].centre == tuple(128 * c for c in data["centre"])
    vertices = [tuple(128 * c for c in v) for v in data["vertices"]]
    model = scene.models[0]
    assert len(model.faces) == len(data["triangles_clockwise"]) == 1008
    for i, (face, wanted) in enumerate(zip(model.faces, data["triangles_clockwise"])):
        assert face.colour == 1 + i % 255
        assert (_clockwise_set([model.vertices[c] for c in face.corners])
                == _clockwise_set([vertices[c] for c in wanted]))


def _tool(*arguments):
    return subprocess.run([sys.executable, str(ROOT / "tools" / "scene.py"), *arguments],
                          capture_output=True, text=True, check=False)


def test_command_line_builds_tells_and_refuses(tmp_path):
    out = tmp_path / "cube.fxls"
    made = _tool("build", str(ROOT / "scenes" / "cube.toml"), "-o", str(out), "--frames", "4")
    assert made.returncode == 0, made.stderr
    told = json.loads(_tool("info", str(out), "--json").stdout)
    assert told["frames"] == 4 and told["faces"] == 6 and told["bytes"] == out.stat().st_size
    assert "4 frames" in _tool("info", str(out)).stdout
    bad = tmp_path / "bad.toml"
    bad.write_text(BOX + "colr = 1\n" + PATH)
    failed = _tool("build", str(bad), "-o", str(tmp_path / "bad.fxls"))
    assert failed.returncode == 2 and failed.stderr.count("\n") == 1
    assert "colr" in failed.stderr and "Traceback" not in failed.stderr
    assert _tool("build", str(bad.with_suffix(".txt")), "-o", str(out)).returncode == 2
    assert sorted(p.name for p in tmp_path.iterdir()) == ["bad.toml", "cube.fxls"]


def test_an_unwritable_out_leaves_nothing(tmp_path):
    (tmp_path / "file").write_text("in the way")
    failed = _tool("build", str(ROOT / "scenes" / "cube.toml"), "-o",
                   str(tmp_path / "file" / "out.fxls"))
    assert failed.returncode == 2 and "cannot be written" in failed.stderr
    assert [p.name for p in tmp_path.iterdir()] == ["file"]
    (tmp_path / "folder").mkdir()
    failed = _tool("build", str(ROOT / "scenes" / "cube.toml"), "-o", str(tmp_path / "folder"))
    assert failed.returncode == 2 and "cannot be written" in failed.stderr
    assert sorted(p.name for p in tmp_path.iterdir()) == ["file", "folder"]


@pytest.mark.parametrize("text, most", [
    ({"repeat": {"count": [1, 1000, 1], "step": [0, 0, 0]}}, 1000), ({"ring": {"count": 1000, "radius": 1}}, 1000),
    ({"ring": {"count": 2, "radius": 1}, "repeat": {"count": [3, 4, 5], "step": [1, 0, 0]}, "positions": [[0, 0, 0]] * 2}, 240)])
def test_how_many_copies_there_may_be(text, most):
    assert toml_motion.count(Table(text, "here", keys.OBJECT)) == most


@pytest.mark.parametrize("text", [{"repeat": {"count": [1, 1001, 1], "step": [0, 0, 0]}}, {"ring": {"count": 1001, "radius": 1}}])
def test_more_copies_than_there_may_be(text):
    with pytest.raises(ToolError, match="1000"):
        toml_motion.count(Table(text, "here", keys.OBJECT))
