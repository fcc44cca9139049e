# SPDX-License-Identifier: MIT
"""OBJ files: every index form, every complaint, and which way things face."""

import math
from pathlib import Path
import time
from types import SimpleNamespace

import numpy as np
import pytest

from fixel.image import image
from fixel.model import mesh, obj
from fixel.scene import framing, toml_scene
from fixel.base.errors import ToolError
from fixel.model.mesh import UNIT
from test_scene_mesh import ONE, check_faces

BUILT_PROGRAMS = ()
MODELS = Path(__file__).resolve().parents[3] / "shared" / "models"

# A cube of edge 2, right-handed, counter-clockwise from outside.
CUBE = """# a cube
o cube
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
vt 0 0
vn 0 0 1
usemtl grey
f 1 2 3 4
f 6/1 5/1 8/1 7/1
f 5//1 1//1 4//1 8//1
f 2/1/1 6/1/1 7/1/1 3/1/1
f -5 -6 -2 -1
f 5 6 2 \\
  1
"""


def read(tmp_path, text):
    file = tmp_path / "model.obj"
    file.write_text(text)
    return obj.read(str(file), "model.obj")


def test_a_right_handed_cube_faces_outward_and_is_not_mirrored(tmp_path):
    made, notes = read(tmp_path, CUBE)
    # The corner at the right, top and towards the viewer (+z there) is at -z here.
    assert made.vertices[2] == (UNIT, UNIT, -UNIT)
    shape = mesh.shape(made, ONE, "cube")
    check_faces(shape)
    assert not shape.notes, "no face was turned round: reading alone made them right"
    assert shape.open_edges == 0
    assert shape.faces[0].normal == (0, 0, -(1 << 30))
    assert all(mesh.dot(f.normal, shape.vertices[f.corners[0]]) > 0 for f in shape.faces)
    assert any("z was negated" in note for note in notes)
    assert any("1 x usemtl" in note for note in notes)


def test_a_corner_that_is_named_twice_counts_once(tmp_path):
    made, _ = read(tmp_path, CUBE + "f 1 2 3 3\nf 1 1 2 2\n")
    shape = mesh.shape(made, ONE, "cube")
    assert sorted(len(face.corners) for face in shape.faces) == [3, 4, 4, 4, 4, 4, 4]
    assert any("1 face without area dropped" in note for note in shape.notes)


@pytest.mark.parametrize("line, parts", [
    ("f 1 2 9", ["model.obj:20", "v 9 does not exist", "8 stand above"]),
    ("f 1 2 0", ["model.obj:20", "v 0"]),
    ("f 1 2 -9", ["v -9"]),
    ("f 1 2 x", ['"x"']),
    ("f 1 2 3/1/1/1", ["3/1/1/1"]),
    ("f 1 2 /1", ["/1"]),
    ("f 1 2 1.5", ["1.5"]),
    ("v 1 2", ["v needs 3"]),
    ("v 1 2 nan", ['"nan" is not a number']),
    ("v 1 2 1e30", ["out of every range"]),
    ("v 1 2 three", ['"three"']),
    ("v 1 2 3 red green blue", ['"red green blue" is no colour']),
    ("f 1/x 2/1 3/1", ['"x"']),
    ("f 1//x 2//1 3//1", ['"x"']),
])
def test_complaints_name_file_and_line(tmp_path, line, parts):
    text = CUBE.replace("\\\n  1\n", "1\n") + line + "\n"
    with pytest.raises(ToolError) as caught:
        read(tmp_path, text)
    for part in ("model.obj:", *parts):
        assert part in str(caught.value)


def test_normals_and_coordinates_out_of_range_are_no_fault_where_nothing_needs_them(tmp_path):
    made, notes = read(tmp_path, CUBE + "f 1/2 2/1 3/1\nf 1//0 2//2 3//-9\nf 1/1/7 2/1/7 3/1/7\n")
    assert len(made.faces) == 9 and made.uvs[6:8] == [None, None] and made.uvs[8] == [(0, 1)] * 3
    assert not any("vt" in note for note in notes)


def test_statements_that_are_not_known_are_told_once(tmp_path):
    made, notes = read(tmp_path, CUBE.replace("\\\n  1\n", "1\n") + "hello there\nvw 0 1 0.5\nhello again\n\u2028\u0000x 1\n")
    assert len(made.faces) == 6
    note, = [note for note in notes if "not known" in note]
    assert "2 x hello, 1 x vw" in note and "model.obj:20" in note and note.isprintable()
    _, notes = read(tmp_path, CUBE + "".join(f"word{number}\n" for number in range(40)))
    note, = [note for note in notes if "not known" in note]
    assert len(note) < 400 and "20 other words" in note


def test_faces_of_few_corners_points_and_lines_are_left_out_by_name(tmp_path):
    made, notes = read(tmp_path, CUBE + "f 1 2\nf\nl 1 2 3\np 4\ncstype bezier\ndeg 3\nfo 1 2 3\n")
    assert len(made.faces) == 7
    note, = [note for note in notes if "left out" in note]
    assert note == 'model.obj: left out 2 x "faces of fewer than three corners", 1 x lines, 1 x points, 2 x "statements of curves and surfaces ' \
        'of free form" (first: model.obj:21)'


@pytest.mark.parametrize("text, what", [("p 1 2 3\n", "only points"), ("l 1 2\nf 1 2\n", "only lines and faces of fewer than three corners"),
                                        ("surf 0 1 0 1 1\n", "surfaces of free form"), ("", "only vertices")])
def test_a_file_of_other_things_than_faces_is_told_what_it_has(tmp_path, text, what):
    with pytest.raises(ToolError, match=f"there is no face in this file.*{what}.*Blender"):
        read(tmp_path, CUBE.split("vt")[0] + text)


def test_a_last_line_that_goes_on_is_read(tmp_path):
    made, _ = read(tmp_path, CUBE + "f 1 2 3 \\\n 4 \\")
    assert len(made.faces) == 7 and len(made.faces[6]) == 4


@pytest.mark.parametrize("rows, expected", [
    (["1 0 0 1", "0 1 0 0.5", "0 0 1 1"], True), (["255 0 0 255", "0 255 0 255", "0 0 255 255"], False), (["1 1 0 0", "1 0 1 0", "1 0 0 1"], False),
    (["1 0 0", "0 1 0", "0 0 1"], False)])
def test_colours_of_four_numbers(tmp_path, rows, expected):
    """With alpha behind, or with w before; what each is holds for the whole file."""
    made, notes = read(tmp_path, "".join(f"v {place} {row}\n" for place, row in zip(("0 0 0", "1 0 0", "0 1 0"), rows)) + "f 1 2 3\n")
    assert made.surfaces.corners == [[(0, 0, 255), (0, 255, 0), (255, 0, 0)]]
    assert any("left out alpha" in note for note in notes) == expected


def test_colours_that_are_no_numbers_are_none(tmp_path):
    lines = [f"v {x} {y} 0 {colour}\n" for x, y, colour in ((0, 0, "1 0 0"), (1, 0, "1 0 0"), (0, 1, "1 0 0"), (1, 1, "nan -nan(ind) 1.#QNAN"))]
    made, notes = read(tmp_path, "".join(lines) + "f 1 2 3\nf 2 4 3\n")
    assert made.surfaces.colours() == [(255, 0, 0), (237, 64, 59)]
    assert any("colours of vertices that are no numbers: 1 (first: model.obj:4)" in note for note in notes)


def test_colours_as_zbrush_paints_them(tmp_path):
    text = "v 0 0 0\nv 1 0 0\n#MRGB ffff0000ff00ff00\nv 0 1 0\nv 1 1 0\n#MRGB ff0000ffff102030\nf 1 2 3\nf 4 4 4\n#MRGB zz\n"
    made, _ = read(tmp_path, text)
    assert made.surfaces.corners[0] == [(0, 0, 255), (0, 255, 0), (255, 0, 0)] and made.surfaces.colours()[1] == (16, 32, 48)


def test_a_long_line_of_paint_takes_no_time(tmp_path):
    started = time.process_time()
    made, _ = read(tmp_path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n#MRGB " + "ff102030" * 400_000 + "\n")
    assert made.surfaces.colours() == [(16, 32, 48)] and time.process_time() - started < 8


def test_names_that_are_not_utf_8_are_those_of_latin_1(tmp_path):
    (tmp_path / "h\u00e4user.mtl").write_bytes("newmtl gr\u00fcn\nKd 0 1 0\n".encode("latin-1"))
    (tmp_path / "model.obj").write_bytes(("mtllib h\u00e4user.mtl\n" + CUBE.replace("usemtl grey", "usemtl gr\u00fcn")).encode("latin-1"))
    made, _ = obj.read(str(tmp_path / "model.obj"), "model.obj")
    assert made.surfaces.colours() == [(0, 255, 0)] * 6


def test_a_text_of_another_kind_is_refused(tmp_path):
    with pytest.raises(ToolError, match="model.obj: there is no face in this file; is this an OBJ file?"):
        read(tmp_path, "<html>\n<body>\n")


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16"])
def test_a_byte_order_mark_says_the_encoding(tmp_path, encoding):
    (tmp_path / "paint.mtl").write_bytes("newmtl gr\u00fcn\nKd 0 1 0\n".encode(encoding))
    (tmp_path / "model.obj").write_bytes(("mtllib paint.mtl\n" + CUBE.replace("usemtl grey", "usemtl gr\u00fcn")).encode(encoding))
    made, notes = obj.read(str(tmp_path / "model.obj"), "model.obj")
    assert len(made.faces) == 6 and made.surfaces.colours() == [(0, 255, 0)] * 6
    assert not any("not known" in note for note in notes)


@pytest.mark.parametrize("words, colour, is_unlit", [("Kd 0 0 0\nKe 1 0.6 0", (255, 153, 0), True), ("Ke 0 0.6 0\nKd 1 0.6 0", (255, 255, 0), False),
                                                     ("Kd 0 1 0\nKe 0 0 0", (0, 255, 0), False)])
def test_an_emissive_colour_is_added_and_alone_is_not_lit(tmp_path, words, colour, is_unlit):
    (tmp_path / "m.mtl").write_text(f"newmtl a\n{words}\n")
    made, notes = read(tmp_path, "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    assert made.surfaces.colours() == [colour] and made.surfaces.are_unlit() == is_unlit and not any("Ke" in note for note in notes)


@pytest.mark.parametrize("most", [1, 255])
def test_colours_of_vertices_are_a_faces_mean(tmp_path, most):
    """Of 0..1 or of 0..255. A file without materials takes them as they are, others multiply."""
    lines = [f"v {x} {y} 0 {r * most} {g * most} {b * most}" for x, y, r, g, b in
             ((0, 0, 1, 0, 0), (1, 0, 0, 1, 0), (0, 1, 0, 0, 1), (1, 1, 1, 1, 1))] + ["v 5 5 5", "v 6 6 6 1", ""]
    faces = "f 1 2 3\nf 4 4 4\nf 1 2 5\nf 1 2 6\n"
    made, notes = read(tmp_path, "\n".join(lines) + faces)
    assert made.surfaces.colours() == [(85, 85, 85), (255, 255, 255), (152, 149, 59), (152, 149, 59)]
    assert any("vertices without a colour beside those with one: 2, which are grey" in note for note in notes)
    assert sum("mean of its corners' colours" in note for note in notes) == 1
    (tmp_path / "m.mtl").write_text("newmtl a\nKd 1 0.6 0\n")
    made, _ = read(tmp_path, "mtllib m.mtl\nusemtl a\n" + "\n".join(lines) + faces)
    assert made.surfaces.colours() == [(85, 51, 0), (255, 153, 0), (170, 102, 0), (170, 102, 0)]


def test_a_file_without_faces_is_refused(tmp_path):
    with pytest.raises(ToolError, match="no face"):
        read(tmp_path, "v 0 0 0\n")
    with pytest.raises(ToolError, match="cannot be read"):
        obj.read(str(tmp_path / "none.obj"))


def compiled(tmp_path, text, frames=8):
    """A bare OBJ file as scene.py build compiles it: the scene and the notes."""
    (tmp_path / "model.obj").write_text(text)
    return framing.compile_model(str(tmp_path / "model.obj"), frames)


def test_a_byte_order_mark_and_display_attributes_are_skipped(tmp_path):
    made, notes = read(tmp_path, "\ufeff" + CUBE + "lod 2\nbevel on\nshadow_obj other.obj\ntrace_obj x\nmg 1 2\n"
                       "c_interp on\nd_interp on\n")
    assert len(made.faces) == 6
    assert any("1 x lod" in note and "1 x bevel" in note and "1 x shadow_obj" in note for note in notes)


GROUPS = """v 9 9 9
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
f 2 3 4
o lower half
g a b b c
f 2 3 4
o upper
f 2 4 5
f 3 4 5
g
f 2 3 5
o empty
o
"""


def test_o_and_g_name_groups_of_faces(tmp_path):
    made, notes = read(tmp_path, GROUPS)
    assert made.groups == {"lower half": [(1, 2)], "upper": [(2, 5)], "a": [(1, 4)], "b": [(1, 4)], "c": [(1, 4)]}
    part = made.part("lower half")
    assert part.faces == [[2, 1, 0]] and part.vertices == made.vertices[:3] and part.places == [made.places[1]]
    assert len(made.part("a").faces) == 3 and len(made.part("a").vertices) == 4
    assert not any("ignored" in note for note in notes)


def test_a_g_with_many_names_keeps_the_first(tmp_path):
    names = [f"n{i}" for i in range(20)]
    made, _ = read(tmp_path, CUBE.replace("o cube", "g " + " ".join(names)))
    assert list(made.groups) == names[:obj.GROUPS_MAX]


def test_a_name_of_o_and_of_g_is_one_group(tmp_path):
    made, _ = read(tmp_path, GROUPS.replace("g a b b c", "g upper"))
    assert sorted(made.groups["upper"]) == [(1, 4), (2, 5)] and len(made.part("upper").faces) == 4


def test_a_bare_model_is_seen_from_its_front_which_is_lit(tmp_path):
    scene, _ = compiled(tmp_path, CUBE, 60)
    x, _, z, *_ = scene.path[0]
    assert z < 0 and abs(x) < abs(z), "the eye stands at -z here, which is +z in the file"
    # Of the faces to the front and to the back, the front is brighter.
    brightness = {face.normal: sum(scene.palette[face.colour]) for face in scene.models[0].faces}
    assert brightness[0, 0, -(1 << 30)] > brightness[0, 0, 1 << 30]


def test_an_open_bare_model_shows_both_sides_and_says_so(tmp_path):
    scene, notes = compiled(tmp_path, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
    normals = sorted(face.normal for face in scene.models[0].faces)
    assert normals == [(0, 0, -(1 << 30)), (0, 0, 1 << 30)]
    assert any("the model is open" in note and "both sides" in note for note in notes)
    scene, notes = compiled(tmp_path, CUBE.replace("\\\n  1\n", "1\n"))
    assert len(scene.models[0].faces) == 6 and not any("open" in note for note in notes)


@pytest.mark.parametrize("sides, faces", [("true", 2), ("false", 1), ('"open"', 2)])
def test_a_scene_file_says_which_sides_show(tmp_path, sides, faces):
    text = (f'[[objects]]\nsolid = "tile"\ntwo_sided = {sides}\n'
            '[path]\nkeys = [{ position = [0, 1, 0] }]\n')
    (tmp_path / "scene.toml").write_text(text)
    scene, _ = toml_scene.compile_file(str(tmp_path / "scene.toml"))
    assert len(scene.models[0].faces) == faces and scene.models[0].kind == image.CONVEX


@pytest.mark.parametrize("far", ["", "v 1e6 0 0\n"])
def test_a_bare_model_far_from_its_origin_is_centred(tmp_path, far):
    lines = [line.split() for line in CUBE.splitlines()]
    moved = [" ".join(["v", *(str(float(c) + (0 if far else 7200)) for c in line[1:])]) if line[0] == "v" else
             " ".join(line) for line in lines]
    # A vertex that no face has goes last, so that the others keep their numbers.
    text = "\n".join(moved).replace("-5 -6 -2 -1", "4 3 7 8") + "\n" + far
    scene, notes = compiled(tmp_path, text)
    expected, _ = compiled(tmp_path, CUBE)
    assert sorted(scene.models[0].vertices) == sorted(expected.models[0].vertices)
    assert scene.path == expected.path
    assert any("left out vertices that no face has: 1" in note for note in notes) == bool(far)
    _check_in_view(scene)


def test_a_model_far_from_its_origin_is_told_so_in_a_scene_file(tmp_path):
    (tmp_path / "model.obj").write_text("v 20000 0 0\nv 20001 0 0\nv 20000 1 0\nf 1 2 3\n")
    (tmp_path / "scene.toml").write_text('[[objects]]\nobj = "model.obj"\n[path]\nkeys = [{ position = [0, 1, 0] }]\n')
    with pytest.raises(ToolError, match="lies up to 20001 units from its own origin.*move it to the origin"):
        toml_scene.compile_file(str(tmp_path / "scene.toml"))


def test_a_bare_model_is_framed(tmp_path):
    (tmp_path / "cube.obj").write_text(CUBE)
    scene, notes = framing.compile_model(str(tmp_path / "cube.obj"), 8)
    assert scene.frames == 8 and (scene.width, scene.height) == (320, 240)
    assert len(scene.models[0].faces) == 6
    assert any("framed" in note for note in notes)
    assert image.unpack(image.pack(scene)) == scene
    _check_in_view(scene)


def _view(pose, points):
    x, y, z, *turns = pose
    yaw, pitch, _ = (t * np.pi / 2 ** 31 for t in turns)
    forward = np.array([np.cos(pitch) * np.sin(yaw), np.sin(pitch), np.cos(pitch) * np.cos(yaw)])
    right = np.array([np.cos(yaw), 0, -np.sin(yaw)])
    rows = np.array([right, np.cross(forward, right), forward])
    return (points - np.array([x, y, z]) / 65536) @ rows.T


def _check_in_view(scene):
    """Every vertex on the screen in every frame, and the model not tiny."""
    points = np.array(scene.models[0].vertices) / 65536
    slope = np.tan(scene.fov * np.pi / 2 ** 32)
    filled = 0
    for pose in scene.path:
        view = _view(pose, points)
        assert (view[:, 2] > scene.near / 65536).all() and (view[:, 2] < scene.far / 65536).all()
        across = np.abs(view[:, 0] / view[:, 2]).max() / slope
        along = np.abs(view[:, 1] / view[:, 2]).max() / slope * scene.width / scene.height
        assert across < 1 and along < 1
        filled = max(filled, across, along)
    assert filled > 0.6
    return filled


@pytest.mark.parametrize("size", [(8, 1, 1), (1, 8, 1), (1, 1, 8), (5, 3, 1)])
@pytest.mark.parametrize("screen", [(320, 240), (128, 160)])
def test_a_framed_model_of_any_shape_touches_the_margin_of_the_screen(tmp_path, size, screen):
    def scaled(line):
        return " ".join(["v", *(str(float(c) * s + 2) for c, s in zip(line.split()[1:], size))]) if line.startswith("v ") else line
    (tmp_path / "box.obj").write_text("\n".join(map(scaled, CUBE.splitlines())) + "\n")
    scene, _ = framing.compile_model(str(tmp_path / "box.obj"), 8, screen=screen)
    assert (scene.width, scene.height) == screen and scene.names == []
    assert abs(_check_in_view(scene) - 0.9) < 0.01
    reach = np.linalg.norm(np.array(scene.models[0].vertices) / 65536, axis=1)
    assert abs(reach.max() - 4) < 0.01


def test_the_camera_stays_outside_the_ball_about_a_model():
    # A bar that points at the camera, on a screen so high that the bar alone would let it come nearer.
    along = [round(UNIT * part(math.radians(framing.WALK.start))) for part in (math.sin, math.cos)]
    bar = SimpleNamespace(vertices=[(sign * along[0], 0, sign * along[1]) for sign in (-1, 1)], surfaces=[], scenery=None)
    data, _ = framing.scene_data(bar, "bar.obj", 1, (64, 1024))
    distance = math.hypot(data["path"]["orbit"]["radius"], data["path"]["orbit"]["height"])
    assert abs(distance - 1.1 * 4) < 0.02
    assert 0.3 <= data["view"]["near"] < distance - 4 and data["view"]["far"] > distance + 4


@pytest.mark.parametrize("name", ["spot.obj", "teapot.obj"])
def test_models_by_others_stand_upright_and_face_outward(name):
    if not (MODELS / name).exists():
        pytest.skip(f"the model {name} is not beside this checkout")
    scene, notes = framing.compile_model(str(MODELS / name))
    assert scene.frames == 60 and not any("inside out" in note for note in notes)
    image.pack(scene)
    _check_in_view(scene)
    model = scene.models[0]
    assert model.kind == image.SORTED
    # The teapot is open, and shows each face from both sides: its fronts are the first half.
    fronts = model.faces[:len(model.faces) // (2 if any("both sides" in note for note in notes) else 1)]
    assert [mesh.turned(face).corners for face in fronts] == [face.corners for face in model.faces[len(fronts):]] or \
        fronts == model.faces
    assert mesh._volume(model.vertices, fronts) > 0
    # Upright: the highest point of the mesh is the highest vertex of the file.
    lines = [line.split() for line in (MODELS / name).read_text().splitlines()]
    top = max((line for line in lines if line[:1] == ["v"]), key=lambda line: float(line[2]))
    scale = (max(v[1] for v in model.vertices) - min(v[1] for v in model.vertices))
    heights = [float(line[2]) for line in lines if line[:1] == ["v"]]
    assert float(top[2]) == max(heights) and scale > 65536
    # The vertex at the file's greatest z comes nearest to the eye at -z.
    made, _ = obj.read(str(MODELS / name))
    depths = [float(line[3]) for line in lines if line[:1] == ["v"]]
    assert made.vertices[depths.index(max(depths))][2] == min(v[2] for v in made.vertices)


@pytest.mark.parametrize("statement, meaning", [("usemap brick", "map_Kd"), ("lod 2", "level of detail"), ("mg 1 2", "surfaces of free form"), ("bevel on", "bevelled"),
                                                ("c_interp on", "colours"), ("d_interp on", "opacity"), ("shadow_obj a.obj", "shadow"), ("trace_obj a.obj", "mirrors"),
                                                ("maplib a.map", "usemap"), ("call b.obj", "another file"), ("csh rm x", "program"), ("usemtl red", "no MTL file")])
def test_a_note_on_a_statement_says_what_it_would_do(tmp_path, statement, meaning):
    _, notes = read(tmp_path, statement + "\n" + CUBE + statement + "\n")
    note, = [note for note in notes if "ignored" in note]
    assert f" x {statement.split()[0]} (" in note and meaning in note
