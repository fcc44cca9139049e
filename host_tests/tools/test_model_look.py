# SPDX-License-Identifier: MIT
"""A model without a scene file looks as its author made it: what is chosen, on which board, and how one chooses otherwise."""

import json
import re
import types

import numpy
import pytest

from conftest import CHECKOUT, assert_one_sentence, dry_run, run_cli, run_make, without_progress
from fixel.base.errors import ToolError
from fixel.board import firmware, model_look, order_check
from fixel.image import image
from fixel.model.mesh import cross, dot
from fixel.scene import compiler, corner_normals, look, making, target, toml_scene, toml_table
from model_files import glb, gltf, png, stl, stl_text
from test_model_files import grid

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "boards/microbit/walk.elf", "boards/netduino2/walk.elf", "host/judge", "host/raycast", "host/predict")
CASES = CHECKOUT / "host_tests" / "tools" / "models"
CUBE = CHECKOUT / "examples" / "cube" / "cube.obj"
IMAGE = png([[(4 * x, 4 * y, 40) for x in range(64)] for y in range(64)])
BALL = [(x, y) for y in range(17) for x in range(17)]


def round_model(path, uvs=True):
    """A bowl of 512 triangles with an image."""
    points, triangles = grid(16, lambda x, y: -((x - 8) ** 2 + (y - 8) ** 2) / 16)
    data, blob = gltf(points, triangles, uvs=[(x / 16, y / 16) for x, y in BALL] if uvs else None, image=IMAGE if uvs else None,
                      material={})
    data["materials"][0]["doubleSided"] = True
    path.write_bytes(glb(data, blob))
    return path


def compiled(path, wanted=look.Look(), **more):
    made, _ = compiler.compile_scene(str(path), 2, look=wanted, **more)
    assert image.unpack(image.pack(made)) == made
    return made


def test_a_model_has_its_textures_smooth_light_rgb565_and_depth(tmp_path):
    made = compiled(round_model(tmp_path / "m.glb"))
    assert (made.pixel_bits, made.depth_bits) == (16, 16) and made.light and len(made.surfaces.textures) == 1
    assert made.surfaces.textures[0].format == 2 and len(made.surfaces.normals) > 100
    plain, _ = compiler.compile_scene(str(tmp_path / "m.glb"), 2)       # as a scene file's defaults
    assert (plain.pixel_bits, plain.depth_bits, plain.light, plain.surfaces) == (8, 0, None, None)


def test_a_convex_model_alone_needs_no_depth_and_a_flat_one_no_light_at_run_time():
    made = compiled(CUBE)
    assert (made.pixel_bits, made.depth_bits, made.light, made.surfaces) == (16, 0, None, None)
    bars = compiled(CASES / "raised_bars.obj")
    assert bars.depth_bits == 16 and bars.surfaces is None


def notes_of(path, wanted=look.Look()):
    return compiler.compile_scene(str(path), 2, look=wanted)[1]


def test_coordinates_on_an_image_that_no_file_names_are_told(tmp_path):
    text = "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 3/3 2/2\nf 1/1 2/2 4/3\n"
    said = {name: [note for note in notes_of(path) if "no image is named" in note] for name, path in (
        ("bare", tmp_path / "bare.obj"), ("missing", tmp_path / "missing.obj"), ("plain", CUBE))
        if name == "plain" or path.write_text(("mtllib none.mtl\n" if name == "missing" else "") + text)}
    assert {name: len(notes) for name, notes in said.items()} == {"bare": 1, "missing": 0, "plain": 0}
    assert "bare.obj" in said["bare"][0] and "map_Kd" in said["bare"][0]
    assert not [note for note in notes_of(tmp_path / "bare.obj", look.Look(texels=0)) if "no image is named" in note]


PAINTED_PLY = "\n".join(["ply", "format ascii 1.0", "element vertex 4", *(f"property float {axis}" for axis in "xyz"), "property uchar red",
                         "property uchar green", "property uchar blue", "element face 4", "property list uchar int vertex_indices", "end_header",
                         "0 0 0 255 0 0", "1 0 0 0 255 0", "0 1 0 0 0 255", "0 0 1 9 9 9", "3 0 2 1", "3 0 1 3", "3 0 3 2", "3 1 2 3", ""])


def coloured(folder, kind):
    """A model whose faces or vertices have colours of their own; obj and ply without materials."""
    path = folder / f"m.{kind}"
    if kind == "glb":
        data, blob = gltf(colours=[(255, 0, 0, 255), (0, 255, 0, 255), (0, 0, 255, 255), (255, 255, 0, 255)], material={"baseColorFactor": [1, 0.5, 1, 1]})
        path.write_bytes(glb(data, blob))
    elif kind == "stl":
        blob = bytearray(stl())
        for face, value in enumerate((0x8000, 0xFC00, 0x83E0, 0)):
            blob[84 + 50 * face + 48:84 + 50 * face + 50] = value.to_bytes(2, "little")
        path.write_bytes(blob)
    else:
        path.write_text(PAINTED_PLY if kind == "ply" else (CASES / "vertex_colours.obj").read_text())
    return path


@pytest.mark.parametrize("kind", ["glb", "stl", "ply", "obj"])
def test_no_colours_leaves_out_those_of_faces_and_vertices(tmp_path, kind):
    path = coloured(tmp_path, kind)
    with_them, without = compiled(path), compiled(path, look.Look(colours=False))
    assert with_them.palette != without.palette and without.surfaces is None
    for red, green, blue in {without.palette[face.colour] for model in without.models for face in model.faces}:    # the tool's colour, or that of the material, in some light
        assert red > green < blue if kind == "glb" else red > green > blue
    notes = [notes_of(path, look.Look(colours=each)) for each in (True, False)]
    assert [sum("--no-colours: the colours" in note for note in each) for each in notes] == [0, 1]
    assert not any("have colours" in note for note in notes[1])
    assert run_cli("build", path, "-o", tmp_path / "a.fxls", "--no-colours", "--write", tmp_path / "s.toml").returncode == 0
    assert run_cli("build", tmp_path / "s.toml", "-o", tmp_path / "b.fxls").returncode == 0
    assert (tmp_path / "a.fxls").read_bytes() == (tmp_path / "b.fxls").read_bytes()
    assert run_cli("build", path, "-o", tmp_path / "c.fxls", "--look=--no-colours").returncode == 0
    assert (tmp_path / "a.fxls").read_bytes() == (tmp_path / "c.fxls").read_bytes()


def test_faces_are_told_to_be_sorted_where_there_is_no_depth(tmp_path):
    said = {depth: [note for note in notes_of(CASES / "raised_bars.obj", look.Look(depth=depth)) if "sorted far to near" in note]
            for depth in (0, 16)}
    assert len(said[0]) == 1 and not said[16]


@pytest.mark.parametrize("words, expected", [
    ([], ("rgb565", 16, 256, 40)), (["--palette"], ("palette", 16, 256, 40)), (["--flat"], ("rgb565", 16, 256, 0)),
    (["--no-textures"], ("rgb565", 16, 0, 40)), (["--sorted"], ("rgb565", 0, 256, 40)), (["--smooth", "20"], ("rgb565", 16, 256, 20)),
    (["--look", "--palette --flat"], ("palette", 16, 256, 0)), (["--look", "--smooth 7", "--sorted"], ("rgb565", 0, 256, 7)),
    (["--pixels", "palette"], ("palette", 16, 256, 40)), (["--depth", "32"], ("rgb565", 32, 256, 40)),
    (["--order", "tree"], ("rgb565", 0, 256, 40))])
def test_options_choose_otherwise(words, expected):
    import argparse
    parser = argparse.ArgumentParser()
    look.add_options(parser)
    target.add_options(parser)
    options = parser.parse_args(words)
    chosen = look.best(look.of_options(options), target.of_options(options), False)
    assert (chosen.pixels, chosen.depth, chosen.texels, chosen.smooth) == expected


@pytest.mark.parametrize("words, said", [
    (["--flat", "--smooth", "3"], "--flat and --smooth exclude"), (["--palette", "--pixels", "rgb565"], "exclude"),
    (["--sorted", "--depth", "16"], "exclude"), (["--look=--x"], "LOOK"), (["--look='"], "quote"), (["--look=--smooth x"], "LOOK")])
def test_options_that_exclude_each_other(tmp_path, words, said):
    assert_one_sentence(run_cli("build", CUBE, "-o", tmp_path / "a.fxls", *words), said)


def test_options_of_a_model_are_refused_for_a_scene_file(tmp_path):
    (tmp_path / "scene.toml").write_text('[[objects]]\nsolid = "box"\n')
    done = run_cli("build", tmp_path / "scene.toml", "-o", tmp_path / "a.fxls", "--flat")
    assert_one_sentence(done, "--flat is for a model without a scene file", "scene.toml")


@pytest.mark.parametrize("words", [[], ["--palette", "--smooth", "10"], ["--flat"], ["--no-textures", "--sorted"]])
@pytest.mark.parametrize("far", [0, 900])
def test_the_scene_file_that_is_written_gives_the_same_frames(tmp_path, words, far):
    points, triangles = grid(6, lambda x, y: x * y / 9)
    points = [(x + far, y, z) for x, y, z in points]
    (tmp_path / "a b").mkdir()
    (tmp_path / "a b" / 'm"1.glb').write_bytes(glb(*gltf(points, triangles, uvs=[(x / 6, y / 6) for x, y, _ in points], image=IMAGE)))
    done = run_cli("build", tmp_path / "a b" / 'm"1.glb', "-o", tmp_path / "one.fxls", "--frames", 3, "--write", tmp_path / "s.toml", *words)
    assert done.returncode == 0, done.stderr
    done = run_cli("build", tmp_path / "s.toml", "-o", tmp_path / "two.fxls")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "one.fxls").read_bytes() == (tmp_path / "two.fxls").read_bytes()


def test_a_scene_file_that_somebody_changed_is_not_written_over(tmp_path):
    words = "build", CUBE, "-o", tmp_path / "one.fxls", "--write", tmp_path / "s.toml"
    for _ in range(2):
        assert "the same as a scene file" in run_cli(*words).stdout
    mine = (tmp_path / "s.toml").read_text() + "# mine\n"
    (tmp_path / "s.toml").write_text(mine)
    (tmp_path / "one.fxls").write_text("before")
    assert_one_sentence(run_cli(*words), "s.toml", "is there already", "--write")
    assert (tmp_path / "s.toml").read_text() == mine and (tmp_path / "one.fxls").read_text() == "before"


@pytest.mark.parametrize("command", [["build"], ["export", "--c"]])
@pytest.mark.parametrize("out, write, words", [("a folder", "s.toml", ["a folder", "cannot be written"]), ("out", "a folder", ["a folder", "cannot be written"]),
                                               ("out", "out", ["out", "one file", "--write"]), ("out", "file/s.toml", ["file/s.toml"])])
def test_both_results_are_written_or_neither(tmp_path, command, out, write, words):
    (tmp_path / "a folder").mkdir()
    (tmp_path / "file").touch()
    assert_one_sentence(run_cli(*command, CUBE, "-o", tmp_path / out, "--write", tmp_path / write), *words)
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["a folder", "file"]


def test_export_has_the_surfaces_that_run_shows(tmp_path):
    round_model(tmp_path / "m.glb")
    for words, wanted in (([], True), (["--flat", "--no-textures"], False)):
        done = run_cli("export", "--c", tmp_path / "m.glb", "-o", tmp_path / "m.h", *words)
        assert done.returncode == 0, done.stderr
        assert ("m_surfaces" in (tmp_path / "m.h").read_text()) == wanted


def test_a_model_that_an_image_cannot_hold_as_it_is_gets_smaller_textures_and_then_flat_faces(tmp_path, monkeypatch):
    from fixel.scene import worker
    round_model(tmp_path / "m.glb")
    asked = {"scene": str(tmp_path / "m.glb"), "frames": 2, "screen": None, "layers": None, "framed": "walk", "target": {},
             "write": None, "looks": [vars(each) for each in look.smaller(look.Asked(), "rgb565", 16)]}
    sizes = [len(image.pack(compiled(tmp_path / "m.glb", look.Look(**each)))) for each in asked["looks"]]
    assert sizes == sorted(sizes, reverse=True)
    for number, size in enumerate(sizes):
        monkeypatch.setattr(image, "IMAGE_MAX", size)
        blob, _, notes = worker._build(asked, compiler.Quiet())
        first = sizes.index(size)
        assert len(blob) == size and any("no more" in note for note in notes) == bool(first)


def test_text_of_a_scene():
    from fractions import Fraction
    import tomllib
    from fixel.model import quantity
    for number, written in ((Fraction(4, 5), "0.8"), (Fraction(-3, 8), "-0.375"), (Fraction(1, 3), '"1/3"'), (Fraction(7), "7"),
                            (Fraction(1, 2 ** 14), "0.00006103515625"), (Fraction(1, 2 ** 15), '"1/32768"'), (Fraction(0), "0")):
        assert toml_table.text({"x": number}) == f"x = {written}\n"
        assert quantity.fraction(tomllib.loads(f"x = {written}", parse_float=quantity.decimal)["x"], "x") == number
    data = {"a": "q\"\\\n\x7fü𝄞", "v": {"x": Fraction(1, 3), "y": Fraction(4), "z": True}, "o": [{"b": [1, "c"], "d": {"e": 2.5}}, {"b": []}]}
    assert tomllib.loads(toml_table.text(data)) == {**data, "v": {"x": "1/3", "y": 4, "z": True}}


# --- smooth = degrees ---------------------------------------------------------------------

def shape_of(text, degrees):
    """The corners' normals of a scene's first object, by its faces."""
    scene, _ = toml_scene.compile_data({"light": {"levels": 8}, "objects": [{**text, "smooth": degrees}]}, "s", "")
    return scene


def test_edges_that_bend_more_than_the_crease_show():
    """A prism of 12 sides: 30 degrees from side to side, 90 to its ends."""
    sides = {"solid": "prism", "sides": 12}
    for degrees, smooth in ((29, 0), (31, 12), (89, 12), (91, 2 * 12 + 2 * 10)):
        faces = shape_of(sides, degrees).models[0].faces
        assert sum(face.mapped is not None for face in faces) == smooth, degrees
    scene = shape_of(sides, 31)
    for face in scene.models[0].faces:
        for number in face.mapped.normals if face.mapped else ():
            normal = scene.surfaces.normals[number]
            assert normal[1] == 0 and dot(normal, face.normal) > 2 ** 60 * numpy.cos(numpy.radians(15.1))


def test_a_crease_of_180_degrees_is_smooth_as_true_is():
    made = toml_scene.compile_data({"objects": [{"solid": "sphere"}]}, "s", "")[0].models[0]
    shape = types.SimpleNamespace(vertices=made.vertices, faces=made.faces, smoothing=None)
    assert corner_normals.smooth_normals(shape, 180) == corner_normals.smooth_normals(shape)
    assert corner_normals.smooth_normals(shape, 1) == [[face.normal] * len(face.corners) for face in made.faces]
    assert all(any(cross(a, b)) for face in corner_normals.smooth_normals(shape, 60) for a, b in zip(face, face[1:]))


@pytest.mark.parametrize("value", ["0", "181", '"x"', "[1]"])
def test_a_crease_that_is_wrong(tmp_path, value):
    (tmp_path / "s.toml").write_text(f'[light]\nlevels = 8\n[[objects]]\nsolid = "box"\nsmooth = {value}\n')
    with pytest.raises(ToolError, match="smooth"):
        toml_scene.compile_file(str(tmp_path / "s.toml"))


# --- what a board has room for --------------------------------------------------------------

ALL = frozenset((bits, depth) for bits in (8, 16) for depth in (0, 16, 32))
LARGE = model_look.Room(1 << 20, 65_536, 1 << 18, 1024, 3 << 20, 0, True, ALL, "m3")


def options_of(tmp_path, monkeypatch, asked=look.Asked(), model=None):
    """The options of a command that draws the bowl."""
    monkeypatch.setattr(model_look.bounded, "limits_of", lambda _: None)
    return types.SimpleNamespace(scene=str(model or round_model(tmp_path / "m.glb")), frames=2, screen=None, cpu_limit=None,
                                 memory_limit=None, allow_outside=False, target=target.Target(), look=asked)


def chosen(tmp_path, room, monkeypatch=None, costs=None, asked=look.Asked(), model=None):
    """(Drawn, why not better) of the bowl in a room. costs: {(bits, depth): (whether the list holds it, instructions)}."""
    options = options_of(tmp_path, monkeypatch, asked, model)
    monkeypatch.setattr(model_look, "_predicted", lambda room, build, file: (costs or {}).get(
        (lambda made: (made.pixel_bits, made.depth_bits))(image.load(file)), (True, 1000.0)))
    return model_look._Chooser(options, room, tmp_path, tmp_path).choose()


def replaced(**changes):
    import dataclasses
    return dataclasses.replace(LARGE, **changes)


def kind(drawn):
    return drawn.scene.pixel_bits, drawn.scene.depth_bits, drawn.look.texels, drawn.look.smooth


ROW = 2 * 320


@pytest.mark.parametrize("room, costs, expected", [
    (LARGE, {}, (16, 16, 256, 40)),
    (replaced(band=16 * ROW), {}, (16, 16, 256, 40)),                                       # bands, and the list holds the frame
    (replaced(band=15 * ROW), {(16, 16): (True, 2001.0)}, (8, 16, 256, 40)),                 # 30 rows of a palette
    (replaced(band=15 * ROW), {(16, 16): (True, 2000.0)}, (16, 16, 256, 40)),                # at most twice as dear
    (replaced(band=16 * ROW), {(16, 16): (False, 2001.0), (8, 16): (False, 1999.0)}, (8, 16, 256, 40)),
    (replaced(band=16 * ROW), {(16, 16): (False, 2001.0), (8, 16): (False, 2001.0)}, (8, 0, 256, 40)),
    (replaced(band=4 * ROW, is_host=True), {(16, 16): (False, 9999.0)}, (16, 16, 256, 40)),
    (replaced(targets=frozenset({(8, 0), (8, 16)})), {}, (8, 16, 256, 40)),
    (replaced(targets=frozenset({(8, 0)})), {}, (8, 0, 256, 40)),
    (replaced(targets=frozenset({(8, 0)}), has_surfaces=False), {}, (8, 0, 0, 0)),
    (replaced(scene=55_000), {}, (16, 16, 0, 0)),
])
def test_what_a_board_draws_by_its_memory_and_by_predicted_instructions(tmp_path, monkeypatch, room, costs, expected):
    drawn, why = chosen(tmp_path, room, monkeypatch, costs)
    assert kind(drawn) == expected
    targets, less = [(16, 16), (8, 16), (8, 0)].index(expected[:2]), [each for each in why if each.startswith("with ")]
    assert len(why) == targets + len(less) and len(less) == (expected[2:] != (256, 40)), why
    assert all("light at run time: " in each and ("no surfaces" in each or "room for 55,000" in each) for each in less) or expected[3], less


def test_a_model_of_more_faces_than_a_board_can_order_is_refused_with_what_helps(tmp_path, monkeypatch):
    drawn, _ = chosen(tmp_path, LARGE, monkeypatch)
    faces = len(drawn.scene.models[0].faces)
    assert faces >= 512 and not chosen(tmp_path, replaced(order=faces + 1), monkeypatch)[0].why_not
    with pytest.raises(ToolError) as error:
        model_look.choose(options_of(tmp_path, monkeypatch), replaced(order=faces), tmp_path, tmp_path)
    assert f"its {faces:,} faces need {faces + 1:,} entries" in str(error.value)
    assert faces % 2 == 0   # the bowl shows both sides: each triangle of the file is two faces
    assert f"LOOK='--simplify {(faces - 1) // 2 // 10 * 10}'" in str(error.value)


@pytest.mark.parametrize("room", [301, 200, 57])
def test_as_many_faces_as_a_refusal_names_are_drawn(tmp_path, monkeypatch, room):
    options = options_of(tmp_path, monkeypatch)
    with pytest.raises(ToolError) as error:
        model_look.choose(options, replaced(order=room), tmp_path, tmp_path)
    named, = re.findall(r"--simplify (\d+)'", str(error.value))
    options.look = look.Asked(simplify=int(named))
    scene = image.load(model_look.choose(options, replaced(order=room), tmp_path, tmp_path))
    assert room // 2 < len(scene.models[0].faces) < room


def test_a_model_of_too_many_faces_is_refused_soon(tmp_path, monkeypatch):
    """Each size of its textures need not be tried."""
    made, build = [], making.build
    monkeypatch.setattr(model_look.making, "build", lambda *words, **more: made.append(more["looks"]) or build(*words, **more))
    with pytest.raises(ToolError, match="entries of the order"):
        model_look.choose(options_of(tmp_path, monkeypatch), replaced(order=10), tmp_path, tmp_path)
    assert len(made) == 4   # with and without smooth light; two other targets


@pytest.mark.parametrize("program, core", [
    ({"cpu": "cortex-m3"}, "m3"), ({"cpu": "cortex-m0"}, "m0"), ({"cpu": "cortex-m0plus"}, "m0"), ({"cpu": "cortex-m55"}, "m3"),
    ({"cpu": "cortex-m3", "code": "own"}, None), ({"cpu": "rv32imc"}, "rv32"), ({"cpu": "host"}, None)])
def test_instructions_are_told_of_code_that_has_been_measured(tmp_path, monkeypatch, program, core):
    made = firmware.Program(tmp_path, "b", qemu=(), openocd=(), segments=(), **program)
    assert model_look._core_of(made) == core
    options = options_of(tmp_path, monkeypatch)
    monkeypatch.setattr(model_look, "_predicted", lambda *_: (True, 1000.0))
    drawn, _ = model_look._Chooser(options, replaced(core=core), tmp_path, tmp_path).choose()
    assert ("1.0 K instructions" in model_look._line(drawn, drawn, "")) == bool(core) == ("--palette: 1.0 K" in model_look._line(drawn, drawn, ""))


def test_a_board_built_for_size_says_so_in_its_program(build):
    assert {name: firmware.load(build / "boards" / name / "walk.elf").code for name in ("netduino2", "mps2-an385")} == \
        {"netduino2": "own", "mps2-an385": ""}


def test_a_scene_is_named_without_an_option_and_a_board_need_not_be(build, tmp_path):
    done = run_cli("run", CUBE, "--frames", 1, "--out", tmp_path / "run", "--allow-outside")
    assert done.returncode == 0 and "mps2-an385" in done.stdout, done.stderr
    assert_one_sentence(run_cli("run", CUBE, "--scene", "other.obj"), "cube.obj", "other.obj", "one scene")
    assert_one_sentence(run_cli("run"), "no scene is named", ".glb")
    assert_one_sentence(run_cli("run", CUBE, "--build", tmp_path), "walk.elf", "no such program", "make run BOARD=")


def test_textures_get_smaller_before_they_go(tmp_path, monkeypatch):
    points, triangles = grid(2, lambda x, y: x * y)
    wide = png(numpy.random.default_rng(1).integers(0, 255, (128, 128, 3), dtype=numpy.uint8))
    (tmp_path / "m.glb").write_bytes(glb(*gltf(points, triangles, uvs=[(x / 2, y / 2) for x, y, _ in points], image=wide)))
    sizes = [kind(chosen(tmp_path, replaced(scene=size), monkeypatch, model=tmp_path / "m.glb")[0])[2]
             for size in (60_000, 30_000, 16_000, 12_000)]
    assert sizes == [256, 64, 32, 16]   # the image itself has 128


def test_the_room_is_that_of_the_boards_program(build):
    room = model_look.room_of(build / "boards" / "mps2-an385" / "walk.elf")
    assert (room.band, room.order, room.list, room.cache, room.ram) == (1 << 20, 65_536, 1 << 18, 1024, 4 << 20)
    assert room.targets == ALL and room.has_surfaces and room.core == "m3"
    assert model_look.room_of(build / "boards" / "microbit" / "walk.elf").ram == 16 << 10
    assert not room.is_host and model_look.room_of(build / "boards" / "host" / "walk").is_host
    host = model_look.room_of(build / "boards" / "host" / "walk")
    assert (host.band, host.order, host.list, host.cache) == (8192, 131_072, 69_632, 32) and host.targets == ALL


@pytest.mark.parametrize("name", ["raised_bars.obj", "ball_textured.obj", "plain_texture.glb"])
def test_a_bare_model_is_drawn_as_double_draws_it_and_in_the_right_order(build, tmp_path, name):
    done = run_cli("run", "--board", "mps2-an385", "--scene", CASES / name, "--frames", 3, "--out", tmp_path / "run",
                   "--write", tmp_path / "s.toml", "--allow-outside")
    assert done.returncode == 0, done.stderr
    summary = json.loads((tmp_path / "run" / "summary.json").read_text())
    assert summary["pixels_unexplained"] == 0 and summary["order_wrong_pixels"] == 0 and summary["host_frames_equal"]
    line, = [line for line in without_progress(done.stderr) if "RAM for pixels" in line]
    assert "RGB565" in line and "whole frame 320x240" in line and re.search(r": (150|300) KB of 4 MB of RAM for pixels", line)
    number, unit = re.search(r"; ([0-9.]+) ([MK]) instructions a frame", line).groups()
    told, taken = float(number) * {"M": 1e6, "K": 1e3}[unit], summary["instructions_per_frame"]["mean"]
    assert abs(told / taken - 1) < 0.15, (told, taken)      # what make predict promises
    again = run_cli("run", "--board", "mps2-an385", "--scene", tmp_path / "s.toml", "--out", tmp_path / "again", "--allow-outside")
    assert again.returncode == 0, again.stderr
    assert json.loads((tmp_path / "again" / "summary.json").read_text())["frame_sha256"] == summary["frame_sha256"]


def test_the_host_draws_the_best_look_in_whole_frames(tmp_path):
    done = run_make("run", "BOARD=host", f"SCENE={round_model(tmp_path / 'm.glb')}", "ALLOW_OUTSIDE=1", "FRAMES=2", f"OUT={tmp_path / 'out'}")
    assert done.returncode == 0, done.stderr
    line, = [line for line in without_progress(done.stderr) if "RAM for pixels" in line]
    assert all(words in line for words in ("RGB565, depth 16", "whole frame 320x240", "textures of at most", "light at run time", " 300 KB of RAM"))
    assert json.loads((tmp_path / "out" / "summary.json").read_text())["host_frames_equal"]


@pytest.mark.parametrize("name, words", [("raised_bars.obj", ["--palette", "--sorted"]), ("raised_bars.obj", ["--sorted"]), ("emissive.glb", ["--sorted"])])
def test_the_line_says_what_the_order_by_distance_makes_wrong(build, tmp_path, name, words):
    done = run_cli("run", "--board", "host", "--scene", CASES / name, "--frames", order_check.FRAMES, "--out", tmp_path / "run", *words)
    assert done.returncode == 0, done.stderr
    summary = json.loads((tmp_path / "run" / "summary.json").read_text())
    line, = [line for line in without_progress(done.stderr) if "RAM for pixels" in line]
    if name == "raised_bars.obj":
        assert f"the order by distance shows a wrong face at {summary['order_wrong_pixels']:,} of {summary['order_judged_pixels']:,} pixels" in line
        assert summary["order_wrong_pixels"] > 100 and line.endswith(f"of {order_check.FRAMES} frames")
    else:
        assert summary["order_wrong_pixels"] == 0 and "the order by distance" not in line     # one convex model


def test_of_a_long_path_some_frames_are_judged_for_the_order(build, tmp_path):
    made, _ = compiler.compile_scene(str(CASES / "raised_bars.obj"), 60, look=look.Look("palette", 0))
    (tmp_path / "m.fxls").write_bytes(image.pack(made))
    wrong, judged, frames = order_check.count(build, tmp_path / "m.fxls")
    assert order_check.text(build, tmp_path / "m.fxls").endswith(f" of {order_check.FRAMES} of the path's 60 frames")
    assert frames == order_check.FRAMES and judged == frames * 320 * 240 and 0 < wrong < judged / 50
    assert order_check.count(tmp_path, tmp_path / "m.fxls") is None and order_check.text(tmp_path, tmp_path / "m.fxls") == ""
    made.depth_bits = 16
    (tmp_path / "m.fxls").write_bytes(image.pack(made))
    assert order_check.text(build, tmp_path / "m.fxls") == ""


@pytest.mark.parametrize("suffix, is_model", [("stl", True), ("STL", True), ("glb", True), ("OBJ", True), ("toml", False)])
def test_make_builds_what_predicts_for_a_model_under_any_name(suffix, is_model):
    assert ("build/host/predict" in dry_run("run", f"SCENE=a b.{suffix}").stdout) == is_model


def test_stl_in_millimetres_is_framed_and_lit(tmp_path):
    (tmp_path / "m.stl").write_bytes(stl([(0, 0, 0), (120, 0, 0), (0, 80, 0), (0, 0, 45)]))
    (tmp_path / "t.stl").write_bytes(stl_text([(0, 0, 0), (120, 0, 0), (0, 80, 0), (0, 0, 45)]))
    assert image.pack(compiled(tmp_path / "m.stl")) == image.pack(compiled(tmp_path / "t.stl"))
    assert making.build(str(tmp_path / "m.stl"), str(tmp_path / "m.fxls"), looks=(look.Look(),)).objects == 1


def test_a_model_of_micrometres_is_seen_as_one_of_metres(tmp_path):
    for name, unit in (("small.obj", "0.000001"), ("large.obj", "1")):
        (tmp_path / name).write_text("v 0 0 0\n" + "".join(f"v {' '.join(row)}\n" for row in (
            (unit, "0", "0"), ("0", unit, "0"), ("0", "0", unit))) + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n")
    small, large = (compiled(tmp_path / name).models[0].vertices for name in ("small.obj", "large.obj"))
    assert len(small) == 4 and all(abs(a - b) <= 8 for one, other in zip(small, large) for a, b in zip(one, other))


def test_a_scene_file_that_names_no_order_keeps_its_look_and_is_told_what_helps(build, tmp_path):
    done = run_cli("run", "--board", "host", "--scene", CASES / "raised_bars.toml", "--frames", 3, "--out", tmp_path / "run")
    assert done.returncode == 0, done.stderr
    summary = json.loads((tmp_path / "run" / "summary.json").read_text())
    assert summary["order_wrong_pixels"] > 1000
    assert "Where the order of drawing is wrong" in done.stdout and "DEPTH=16" in done.stdout and "tree" in done.stdout
