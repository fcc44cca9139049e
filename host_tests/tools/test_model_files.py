# SPDX-License-Identifier: MIT
"""Models in scenes: materials, images, fit, mend, merge."""

import time

import pytest

from fixel.image import image, image_surface
from fixel.model import mesh
from fixel.model import obj as obj_reader
from fixel.base.errors import ToolError
from fixel.base.notes import Usual
from fixel.scene import compiler, surfaces
from model_files import SQUARE, TETRAHEDRON, glb, gltf, png, stl

BUILT_PROGRAMS = ()
PATH = "[path]\nkeys = [{ position = [0, 0, -4] }]\n"
QUADS = """\
mtllib paint.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 2 0 0
v 2 1 0
vt 0 0
vt 0.4 0
vt 0.4 1
vt 0 1
usemtl red
f 1 2 3 4
usemtl cloth
f 2/1 5/2 6/3 3/4
"""
PAINT = "# paint\nnewmtl red\nKd 1 0 0.2\nd 0.5\nnewmtl cloth\nKd 1 1 0.5\nmap_Kd -s 1 1 1 a skin.png\n"


def compiled(tmp_path, objects, **files):
    """A scene of these objects, whose files are given, and the tool's notes."""
    for name, data in files.items():
        name = name.replace("__", " ").replace("_", ".")
        (tmp_path / name).write_bytes(data.encode() if isinstance(data, str) else data)
    (tmp_path / "scene.toml").write_text(objects + PATH)
    made, notes = compiler.compile_scene(str(tmp_path / "scene.toml"))
    image.unpack(image.pack(made))
    return made, notes


def colours(made):
    return {made.palette[face.colour] for model in made.models for face in model.faces}


SKIN = png([[(200, 100, 50)] * 4 + [(0, 0, 255)] * 6])


def test_materials_of_an_obj_file(tmp_path):
    made, notes = compiled(tmp_path, '[[objects]]\nmodel = "m.obj"\nshade = false\n',
                           m_obj=QUADS, paint_mtl=PAINT, a__skin_png=SKIN)
    assert colours(made) == {(255, 0, 51), (200, 100, 25)}      # the image's left part, times Kd
    assert any("partly transparent are drawn opaque: 1" in note for note in notes)


def test_a_colour_of_the_scene_goes_before_those_of_the_file(tmp_path):
    made, _ = compiled(tmp_path, '[[objects]]\nmodel = "m.obj"\ncolour = "lime"\nshade = false\n',
                       m_obj=QUADS, paint_mtl=PAINT, a__skin_png=SKIN)
    assert colours(made) == {(0, 255, 0)}


def test_all_models_share_the_palette_without_its_reserved_entries(tmp_path):
    rainbow = png([[(17 * x, 17 * y, 255 - 17 * x) for x in range(16)] for y in range(16)])
    points = [(x, y, 0) for y in range(17) for x in range(17)]
    triangles = [t for y in range(16) for x in range(16) for i in [17 * y + x] for t in ((i, i + 1, i + 18), (i, i + 18, i + 17))]
    data = glb(*gltf(points, triangles, uvs=[(x / 16, y / 16) for x, y, _ in points], image=rainbow))
    objects = '[palette]\nreserve = 200\n[[objects]]\nmodel = "m.glb"\nshade = false\nfit = 2\n' \
              '[[objects]]\nmodel = "m.obj"\nshade = false\nposition = [0, 0, 5]\n'
    made, notes = compiled(tmp_path, objects, m_glb=data, m_obj=QUADS, paint_mtl=PAINT, a__skin_png=SKIN)
    used = {face.colour for model in made.models for face in model.faces}
    assert max(used) < 256 - 200 and len(used) == 55
    assert any("colours were merged" in note for note in notes)
    assert image.pack(made) == image.pack(compiled(tmp_path, objects)[0])


def test_an_obj_file_without_its_materials_is_drawn_in_one_colour(tmp_path):
    made, notes = compiled(tmp_path, '[[objects]]\nmodel = "m.obj"\nshade = false\n', m_obj=QUADS)
    assert colours(made) == {(0xc8, 0xc0, 0xb0)}
    assert any('m.obj:1: there is no "paint.mtl"' in note for note in notes)


BAD = {
    "Kd": ("newmtl red\nKd 1 x 0\n", {}, ["paint.mtl:2", '"x"']),
    "NaN": ("newmtl red\nd nan\n", {}, ["paint.mtl:2", '"nan"']),
    "order": ("Kd 1 1 1\n", {}, ["paint.mtl:1", "before the first newmtl"]),
    "name": ("newmtl red\nmap_Kd -o 1 1 1\n", {}, ["paint.mtl:2", "names no file"]),
}


def painted(tmp_path, paint, name="paint.mtl", obj=QUADS, **files):
    """The materials' opacities and the faces' colours of an OBJ file with these materials, and the notes."""
    for file, data in {name: paint, "m.obj": obj, **files}.items():
        (tmp_path / file).parent.mkdir(exist_ok=True)
        (tmp_path / file).write_bytes(data.encode() if isinstance(data, str) else data)
    made, notes = obj_reader.read(str(tmp_path / "m.obj"), "m.obj")
    return {each.name: each.opacity for each in made.surfaces.materials}, made.surfaces.colours(), notes


@pytest.mark.parametrize("red, cloth, opacities", [
    ("Tr 0.25", "Tr 0", (0.75, 1)),                 # transparency
    ("Tr 1", "Tr 0.25", (1, 0.25)),                 # the opacity: the one would be invisible
    ("d 0.25\nTr 0.25", "Tr 0.75", (0.25, 0.75)),   # the opacity too
    ("d 0.25\nTr 0.75", "Tr 0.75", (0.25, 0.25)),
    ("d 0.5\nTr 0.5", "Tr 0.75", (0.5, 0.25)),
    ("Tr 0.9\nd 1", "d 0.5", (1, 0.5)),
    ("d 0", "d 0.5", (0, 0.5)),
    ("d 0", "d 0", (1, 1)),                         # a model is not invisible
])
def test_tr_in_both_readings(tmp_path, red, cloth, opacities):
    found, _, notes = painted(tmp_path, f"newmtl red\n{red}\nnewmtl cloth\n{cloth}\n")
    assert tuple(found[name] for name in ("red", "cloth")) == opacities
    said = any("Tr is read as the opacity" in note or "all are drawn opaque" in note for note in notes)
    assert said == (opacities in ((1, 0.25), (0.25, 0.75), (1, 1)))


@pytest.mark.parametrize("options, width", [("-s 2 2", 1), ("-o 0.5", 0.5), ("-s 2 -o 0.5 0 0", 0.5), ("-mm 0 1 -clamp on", 0)])
def test_options_of_map_kd_with_one_two_or_three_numbers(tmp_path, options, width):
    """The face has u from 0 to 0.4 and v from 0 to 1, upward; the image is red up to 0.4, then blue."""
    quad = QUADS.replace("vt 0.4", "vt 0.2")
    _, colours, notes = painted(tmp_path, f"newmtl cloth\nKd 1 1 1\nmap_Kd {options} a skin.png\n", obj=quad,
                                **{"a skin.png": SKIN})
    red = {1: 1, 0.5: 0, 0: 1}[width]
    assert colours[1] == ((200, 100, 50) if red else (0, 0, 255))
    assert any("ignored 1 x \"-mm\" (first: paint.mtl:3)" in note for note in notes) == (width == 0)


@pytest.mark.parametrize("named, there, said", [
    ('"paint.mtl"', "paint.mtl", None), (".\\paint.mtl", "paint.mtl", None), ("parts\\paint.mtl", "parts/paint.mtl", None),
    ("C:\\Users\\someone\\paint.mtl", "paint.mtl", '"paint.mtl" is read instead'),
    ("D:/x/Paint.MTL", "paint.mtl", '"paint.mtl" is read instead'), ("Parts/Paint.mtl", "parts/PAINT.MTL", '"parts/PAINT.MTL" is read'),
    ("my paint.mtl", "my paint.mtl", None)])
def test_files_are_found_as_other_computers_write_their_names(tmp_path, named, there, said):
    _, colours, notes = painted(tmp_path, "newmtl red\nKd 1 0 0\nnewmtl cloth\nKd 0 0 1\n", there,
                                QUADS.replace("mtllib paint.mtl", f"mtllib {named}"))
    assert colours == [(255, 0, 0), (0, 0, 255)]
    found = [note for note in notes if "is read instead" in note]
    assert [said in note for note in found] == ([True] if said else [])
    _, colours, notes = painted(tmp_path, "newmtl cloth\nKd 1 1 1\nmap_Kd C:\\tex\\Skin.PNG\n", **{"skin.png": SKIN})
    assert colours[1] == (200, 100, 50) and any('m.obj:1: there is no' in note or '"skin.png" is read instead' in note for note in notes)


@pytest.mark.parametrize("words, said", [
    ("skin.png -s 1 1", None), ("-colorspace sRGB skin.png", '1 x "-colorspace"'), ("my  skin.png", None), ("two  blanks.png", '"two  blanks.png" is read'),
    ("my%20skin.png", '"my skin.png" is read instead'), ("skin#1.png", None), ("skin.png # of the cloth", None), ("-s 1 1 -x.png", None),
    ("HA\u0308UT.png", "is read instead"), ("-clamp off \"my skin.png\"", None)])
def test_names_of_images_as_people_write_them(tmp_path, words, said):
    """Options behind the name, options that nobody knows, blanks, signs of an address, #, accents in two parts."""
    _, colours, notes = painted(tmp_path, f"newmtl cloth\nKd 1 1 1\nmap_Kd {words}\n",
                                **{name: SKIN for name in ("skin.png", "my skin.png", "skin#1.png", "-x.png", "two  blanks.png", "h\u00e4ut.png")})
    assert colours[1] == (200, 100, 50) and not any("no image" in note for note in notes)
    found = [note for note in notes if "ignored" in note or "is read instead" in note]
    assert [said in note for note in found] == ([True] if said else [])


def test_a_clamped_image_shows_its_edge_beyond_it(tmp_path):
    quad = QUADS.replace("vt 0.4", "vt 3.4")
    _, repeats, _ = painted(tmp_path, "newmtl cloth\nmap_Kd skin.png\n", obj=quad, **{"skin.png": SKIN})
    _, clamps, notes = painted(tmp_path, "newmtl cloth\nmap_Kd -clamp on skin.png\n", obj=quad, **{"skin.png": SKIN})
    assert clamps[1][2] > repeats[1][2] and not any("clamp" in note for note in notes)


@pytest.mark.parametrize("rows, colours, said", [(("255 0 51", "0 0 128"), [(255, 0, 51), (0, 0, 128)], True), (("1 0 0", "0 0 1"), [(255, 0, 0), (0, 0, 255)], False),
                                                 (("1.5 0 0", "0 0 1"), [(255, 0, 0), (0, 0, 255)], False)])
def test_kd_of_0_to_255(tmp_path, rows, colours, said):
    _, found, notes = painted(tmp_path, f"newmtl red\nKd {rows[0]}\nnewmtl cloth\nKd {rows[1]}\n")
    assert found == colours and any("Kd is read as 0..255" in note for note in notes) == said


@pytest.mark.parametrize("line, files, missing", [
    ("a.mtl b.mtl", ("a.mtl", "b.mtl"), []), ("my a.mtl b.mtl", ("my a.mtl", "b.mtl"), []), ("a.mtl my b.mtl", ("a.mtl", "my b.mtl"), []),
    ("C:\\my things\\a.mtl \"b.mtl\"", ("a.mtl", "b.mtl"), []), ("a.mtl x y.mtl b.mtl z", ("a.mtl", "b.mtl"), ['"x y.mtl"', '"z"'])])
def test_several_mtllib_and_names_with_blanks(tmp_path, line, files, missing):
    for name, text in zip(files, ("newmtl red\nKd 1 0 0\n", "newmtl cloth\nKd 0 0 1\n")):
        (tmp_path / name).write_text(text)
    _, colours, notes = painted(tmp_path, "", "unused.mtl", QUADS.replace("mtllib paint.mtl", f"mtllib {line}"))
    assert colours == [(255, 0, 0), (0, 0, 255)]
    note = next((note for note in notes if "there is no" in note and "left out" in note), "")
    assert all(each in note for each in missing) and bool(note) == bool(missing)


@pytest.mark.parametrize("obj, said", [
    (QUADS.replace("mtllib paint.mtl\n", "") + "mtllib paint.mtl\n", None),       # behind the faces
    (QUADS.replace("mtllib paint.mtl\n", ""), 'no mtllib is named: "m.mtl"'), (QUADS.replace("paint", "gone"), 'no "gone.mtl": "m.mtl"')])
def test_materials_that_stand_elsewhere(tmp_path, obj, said):
    if said:
        (tmp_path / "m.mtl").write_text(PAINT)
    _, colours, notes = painted(tmp_path, PAINT, "paint.mtl" if not said else "other.mtl", obj)
    assert colours == [(255, 0, 51), (255, 255, 128)]
    assert any("has the model's name" in note and said in note for note in notes) if said else not any("left out" in note for note in notes)


def test_a_sign_in_a_name_of_a_material(tmp_path):
    """A # may be a part of a name, or begin a comment: the other file says which."""
    quads = QUADS.replace("usemtl red", "usemtl Material #1").replace("usemtl cloth", "usemtl Material #2")
    _, colours, _ = painted(tmp_path, "newmtl Material #1\nKd 1 0 0\nnewmtl Material #2\nKd 0 0 1\n", obj=quads)
    assert colours == [(255, 0, 0), (0, 0, 255)]
    _, colours, _ = painted(tmp_path, "newmtl red # as a rose\nKd 1 0 0\nnewmtl cloth\nKd 0 0 1\n", obj=QUADS.replace("cloth", "cloth # of it"))
    assert colours == [(255, 0, 0), (0, 0, 255)]


@pytest.mark.parametrize("red, cloth", [("d 0", "d 0.02"), ("Tr 0.99", "d 0.001")])
def test_a_model_whose_used_materials_are_all_clear_is_opaque(tmp_path, red, cloth):
    found, _, notes = painted(tmp_path, f"newmtl red\n{red}\nnewmtl cloth\n{cloth}\nnewmtl unused\nd 1\nTr 0\n")
    assert (found["red"], found["cloth"]) == (1, 1) and any("materials of all faces are wholly transparent" in note for note in notes)


def test_the_first_material_that_is_not_there_is_named(tmp_path):
    _, _, notes = painted(tmp_path, "newmtl red\nKd 1 0 0\n")
    assert any('faces whose material no mtllib has: 1 (first: "cloth", m.obj:' in note for note in notes)


@pytest.mark.parametrize("lines, line", [(["mtllib paint.mtl" + " a" * 64], 1), ([f"mtllib x{number}" for number in range(300)], 257)])
def test_mtllib_of_absurd_lengths(tmp_path, lines, line):
    _, colours, notes = painted(tmp_path, PAINT, obj="\n".join(lines) + "\n" + QUADS.replace("mtllib paint.mtl\n", ""), **{"m.mtl": PAINT})
    assert colours == [(255, 0, 51), (255, 255, 128)] and any(f"m.obj:{line}: left out what is behind" in note for note in notes)


def test_thousands_of_options_take_no_time(tmp_path):
    started = time.process_time()
    _, colours, _ = painted(tmp_path, f"newmtl cloth\nmap_Kd {'-s ' * 150_000}{'-o 0 ' * 50_000}skin.png\n", **{"skin.png": SKIN})
    assert colours[1] == (200, 100, 50) and time.process_time() - started < 8


def test_a_missing_image_is_a_note_and_kd_is_the_colour(tmp_path):
    _, colours, notes = painted(tmp_path, PAINT)
    assert colours == [(255, 0, 51), (255, 255, 128)]
    note, = [note for note in notes if "no image" in note]
    assert "paint.mtl:7" in note and '"a skin.png"' in note and "colour of their material" in note


def test_an_image_is_not_darkened_by_a_colour_that_nobody_wrote(tmp_path):
    for kd, said in (("", False), ("Kd 0 0 0\n", True)):
        _, colours, notes = painted(tmp_path, f"newmtl cloth\n{kd}map_kd skin.png\n", **{"skin.png": SKIN})
        assert colours[1] == (200, 100, 50) and any("is black" in note for note in notes) == said


def test_statements_of_materials_that_are_not_read_are_told_once(tmp_path):
    _, _, notes = painted(tmp_path, "newmtl red\nKs 1 1 1\nKs 0 0 0\nillum 2\nnewmtl cloth\nmap_bump x.png\n")
    usual, other = ([note for note in notes if isinstance(note, Usual) == is_usual and "paint.mtl: ignored" in note] for is_usual in (True, False))
    assert len(usual) == len(other) == 1 and "map_bump" not in usual[0]
    for words in ("2 x Ks (the colour of highlights)", "1 x illum (", "first: paint.mtl:2"):
        assert words in usual[0]        # most files have them: told with -v alone
    assert "1 x map_bump (bumps of the surface)" in other[0] and "first: paint.mtl:6" in other[0]


@pytest.mark.parametrize("kind", BAD)
def test_materials_that_are_wrong(tmp_path, kind):
    paint, files, words = BAD[kind]
    with pytest.raises(ToolError) as caught:
        compiled(tmp_path, '[[objects]]\nmodel = "m.obj"\n', m_obj=QUADS, paint_mtl=paint, **files)
    for word in words:
        assert word in str(caught.value)


# --- fit, mend, merge -----------------------------------------------------------------

def test_fit_makes_the_largest_extent_so_many_units(tmp_path):
    made, _ = compiled(tmp_path, '[[objects]]\nmodel = "m.stl"\nfit = 3\n', m_stl=stl([(0, 0, 0), (700, 0, 0), (0, 90, 0),
                                                                                  (0, 0, 50)]))
    ends = [max(axis) - min(axis) for axis in zip(*made.models[0].vertices)]
    assert abs(max(ends) - 3 * 65536) <= 4


def grid(cells, height=lambda x, y: 0.0):
    """A square of so many cells by so many, each of two triangles."""
    side = cells + 1
    points = [(x, y, height(x, y)) for y in range(side) for x in range(side)]
    return points, [t for y in range(cells) for x in range(cells) for i in [side * y + x]
                    for t in ((i, i + 1, i + side + 1), (i, i + side + 1, i + side))]


def test_faces_in_one_plane_are_merged(tmp_path):
    made, notes = compiled(tmp_path, '[[objects]]\nmodel = "m.glb"\n', m_glb=glb(*gltf(*grid(1))))
    assert [len(face.corners) for face in made.models[0].faces] == [4]
    assert any("1 faces merged" in note for note in notes)


def test_merging_keeps_area_corners_and_whole_edges(tmp_path):
    points, triangles = grid(6, lambda x, y: float(max(0, x - 3)))      # two planes
    made, _ = compiled(tmp_path, '[[objects]]\nmodel = "m.glb"\n', m_glb=glb(*gltf(points, triangles)))
    model = made.models[0]
    assert len(model.faces) < 30
    areas = {}
    for face in model.faces:
        outline = [model.vertices[c] for c in face.corners]
        area = mesh.newell(outline)
        assert mesh.is_convex_outline(outline, area) and mesh.is_flat(outline, face.normal)
        assert all(mesh.dot(area, mesh.minus(point, outline[0])) == 0 for point in outline)
        areas[face.normal] = areas.get(face.normal, 0) + mesh.dot(area, area) ** 0.5
    unit = 65536.0 ** 2
    assert sorted(round(area / unit, 3) for area in areas.values()) == sorted([2 * 18.0, round(2 * 18 * 2 ** 0.5, 3)])
    edges = {}
    for face in model.faces:
        for a, b in zip(face.corners, face.corners[1:] + face.corners[:1]):
            edges[a, b] = edges.get((a, b), 0) + 1
    open_edges = [edge for edge in edges if edge[::-1] not in edges]
    assert len(open_edges) == 24 and set(edges.values()) == {1}     # the border, of 6 on each side


def test_merge_keeps_materials_and_bent_faces_apart(tmp_path):
    bent = glb(*gltf(*grid(1, lambda x, y: x * y / 65536)))
    assert len(compiled(tmp_path, '[[objects]]\nmodel = "m.glb"\n', m_glb=bent)[0].models[0].faces) == 2
    painted = QUADS.replace("usemtl cloth\n", "")
    for text, faces in ((QUADS, 2), (painted, 1)):
        made, _ = compiled(tmp_path, '[[objects]]\nmodel = "m.obj"\nmerge = true\n', m_obj=text, paint_mtl=PAINT,
                           a__skin_png=SKIN)
        assert len(made.models[0].faces) == faces
    made, _ = compiled(tmp_path, '[[objects]]\nmodel = "m.obj"\n', m_obj=painted)
    assert len(made.models[0].faces) == 2       # not unless asked for


def test_no_face_gets_more_than_24_corners(tmp_path):
    made, _ = compiled(tmp_path, '[[objects]]\nmodel = "m.glb"\n', m_glb=glb(*gltf(*grid(30))))
    assert max(len(face.corners) for face in made.models[0].faces) <= 24


def test_what_was_welded_and_how_far_rounding_went_is_said(tmp_path):
    third = [(c / 3 for c in point) for point in TETRAHEDRON[0]]
    _, notes = compiled(tmp_path, '[[objects]]\nmodel = "m.stl"\n', m_stl=stl([tuple(point) for point in third]))
    assert any("12 vertices welded to 4; rounded to 16.16, a coordinate is at most 0.33/65536 unit off" in note for note in notes)


def test_a_band_that_has_no_front_is_left_as_it_is(tmp_path):
    """A Moebius band: its faces cannot agree."""
    points = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 1), (1, 1, 2)]
    band = [(i, (i + 1) % 5, (i + 2) % 5) for i in range(5)]
    _, notes = compiled(tmp_path, '[[objects]]\nmodel = "m.stl"\n', m_stl=stl(points, band))
    assert not any("turned round: they" in note for note in notes)


@pytest.mark.parametrize("text, words", [
    ('model = "m.glb"\nsolid = "box"', ["both model and solid"]), ('solid = "box"\nfit = 3', ["fit", "means nothing"]),
    ('model = "m.glb"\nfit = 1\nscale = 2', ["both fit and scale"]), ('model = "m.unknown"', ["m.unknown", "there is no file"]),
    ('obj = "m.glb"', ["no OBJ file"]), ('model = "m.glb"\nfit = 0', ["fit"]), ('model = "m.glb"\nmerge = 1', ["merge"]),
    ('model = "scene.toml"', ["a model is an .obj, .gltf, .glb, .stl or .ply file"])])
def test_keys_that_are_wrong(tmp_path, text, words):
    with pytest.raises(ToolError) as caught:
        compiled(tmp_path, f"[[objects]]\n{text}\n", m_glb=glb(*gltf(*SQUARE)))
    for word in words:
        assert word in str(caught.value)


# --- images as textures --------------------------------------------------------------------

CLOTH = png([[(250, 0, 0)] * 8 + [(0, 0, 250)] * 8] * 4)


def textured(tmp_path, objects, **material):
    data, blob = gltf(*SQUARE, uvs=[(0, 0), (2, 0), (2, 1), (0, 1)], image=CLOTH, material=material)
    return compiled(tmp_path, f'[[objects]]\nmodel = "m.glb"\nshade = false\n{objects}', m_glb=glb(data, blob))[0]


def test_an_image_becomes_a_texture_at_the_files_coordinates(tmp_path):
    made = textured(tmp_path, "images = true\nfit = 4\n")
    texture, = made.surfaces.textures
    assert (texture.log_width, texture.log_height, texture.levels) == (4, 2, 1)
    assert [made.palette[entry] for entry in texture.texels[:16]] == [(250, 0, 0)] * 8 + [(0, 0, 250)] * 8
    found = {}      # vertex -> texel, in texels from the upper left corner
    for face in made.models[0].faces:
        for vertex, texel in zip(face.mapped.vertices, face.mapped.texels):
            found[made.models[0].vertices[vertex]] = texel
    left, right = (end(x for x, _, _ in found) for end in (min, max))
    top, bottom = (end(y for _, y, _ in found) for end in (max, min))
    # The file's (0, 0, 0) is at u = 0, v = 0, its (1, 1, 0) at u = 2, v = 1; its y is up. Each is within the image's edge by what
    # keeps the edge on its side.
    margin = round(65536 * surfaces.edge_margin(16, 1, image_surface.DIVIDE_16))
    low, right_texel, bottom_texel = margin, (32 << 16) - margin, (4 << 16) - margin
    assert found == {(left, bottom, 0): (low, low), (right, bottom, 0): (right_texel, low), (right, top, 0): (right_texel, bottom_texel),
                     (left, top, 0): (low, bottom_texel)}


def test_images_are_scaled_by_a_box_filter_and_have_levels(tmp_path):
    made = textured(tmp_path, "images = { size = 2, levels = 2 }\n", baseColorFactor=[1, 1, 1, 1])
    texture, = made.surfaces.textures
    assert (texture.log_width, texture.log_height, texture.levels) == (1, 1, 2)
    assert [made.palette[entry] for entry in texture.texels] == [(250, 0, 0), (0, 0, 250)] * 2 + [(125, 0, 125)]


def test_images_of_4_bits(tmp_path):
    made = textured(tmp_path, "images = { size = 8, bits = 4, levels = 4 }\n")
    texture, = made.surfaces.textures
    assert (texture.format, texture.log_width, texture.log_height, texture.levels) == (1, 3, 2, 4)
    first = [number for byte in texture.texels[:4] for number in (byte & 15, byte >> 4)]
    assert [made.palette[texture.colours[number]] for number in first] == [(250, 0, 0)] * 4 + [(0, 0, 250)] * 4
    with pytest.raises(ToolError, match="colours = 16 is outside 1..15"):
        textured(tmp_path, "images = { bits = 4, colours = 16 }\n")


def test_what_is_clear_in_an_image_is_not_drawn_and_opacity_is_a_pattern(tmp_path):
    from PIL import Image
    import io
    out = io.BytesIO()
    Image.new("RGBA", (4, 4), (9, 99, 199, 0)).save(out, "PNG")
    data, blob = gltf(*SQUARE, uvs=[(0, 0), (1, 0), (1, 1), (0, 1)], image=out.getvalue(), material={"baseColorFactor": [1, 1, 1, 0.5]})
    data["materials"][0]["alphaMode"] = "BLEND"
    made, notes = compiled(tmp_path, '[[objects]]\nmodel = "m.glb"\nimages = true\n', m_glb=glb(data, blob))
    assert made.surfaces.textures[0].flags & 2 and made.surfaces.surfaces[0].opacity == 8
    assert not any("drawn opaque" in note for note in notes)


def test_faces_without_an_image_keep_their_colour(tmp_path):
    made, _ = compiled(tmp_path, '[[objects]]\nmodel = "m.obj"\nimages = true\nshade = false\n',
                       m_obj=QUADS, paint_mtl=PAINT, a__skin_png=SKIN)
    red, cloth = made.models[0].faces
    assert made.palette[red.colour] == (255, 0, 51) and red.mapped is not None      # d = 0.5 is a surface too
    assert made.surfaces.surfaces[red.mapped.surface].texture == 0 and made.surfaces.surfaces[red.mapped.surface].opacity == 8
    assert made.palette[cloth.colour] == (200, 100, 25) and cloth.mapped is None        # of one colour: no texture
    made, _ = compiled(tmp_path, '[[objects]]\nmodel = "m.obj"\nimages = true\nshade = false\n', m_obj=QUADS.replace("vt 0.4", "vt 0.6"))
    assert made.surfaces.surfaces[made.models[0].faces[1].mapped.surface].texture == 1


@pytest.mark.parametrize("text, words", [
    ("images = true\ntexture = 'x'", ["texture", "keep one or the other"]), ("images = { sides = 4 }", ["sides"])])
def test_images_that_are_wrong(tmp_path, text, words):
    with pytest.raises(ToolError) as caught:
        textured(tmp_path, text + "\n")
    for word in words:
        assert word in str(caught.value)


def test_images_where_there_are_none(tmp_path):
    for objects, files in (('solid = "box"', {}), ('model = "m.stl"', {"m_stl": stl()})):
        with pytest.raises(ToolError, match="no material with an image"):
            compiled(tmp_path, f"[[objects]]\n{objects}\nimages = true\n", **files)


def test_images_on_more_faces_than_8192(tmp_path):
    points, triangles = grid(65)
    data = glb(*gltf(points, triangles, uvs=[(x / 65, y / 65) for x, y, _ in points], image=CLOTH))
    made, _ = compiled(tmp_path, '[[objects]]\nmodel = "m.glb"\nimages = true\nmerge = false\n', m_glb=data)
    assert sum(len(model.faces) for model in made.models) == 8450 and made.surfaces


GROUPED = QUADS.replace("usemtl red\n", "o left\nusemtl red\n").replace("usemtl cloth\n", "o right\nusemtl cloth\n")


def test_an_object_takes_a_group_of_an_obj_file(tmp_path):
    """Its faces alone, with their materials, and its own middle."""
    files = {"m_obj": GROUPED, "paint_mtl": PAINT, "a__skin_png": png([[(255, 0, 0)]])}
    made, _ = compiled(tmp_path, "".join(f'[[objects]]\nmodel = "m.obj"\ngroup = "{name}"\nanchor = "middle"\nshade = false\n'
                                         for name in ("left", "right")), **files)
    assert [len(model.faces) for model in made.models] == [1, 1] and len(made.objects) == 2
    whole, _ = compiled(tmp_path, '[[objects]]\nmodel = "m.obj"\nshade = false\n')
    assert colours(made) == colours(whole) and len(colours(made)) == 2
    assert made.models[0].faces[0].colour != made.models[1].faces[0].colour


@pytest.mark.parametrize("text, parts", [
    ('model = "m.obj"\ngroup = "lefd"\n', ["group", "m.obj", 'has no group "lefd"', '"left"']),
    ('model = "m.obj"\ngroup = "%s"\n' % ("x" * 9000), ["group", 'nearest name is "']),
    ('model = "m.obj"\ngroup = 7\n', ["group"]),
    ('model = "p.obj"\ngroup = "left"\n', ["group", "p.obj has no groups", "OBJ"]),
    ('model = "m.stl"\ngroup = "left"\n', ["group", "m.stl has no groups", "OBJ"]),
    ('solid = "box"\ngroup = "left"\n', ["group", "means nothing for a solid"])])
def test_a_group_that_is_not_there_is_refused(tmp_path, text, parts):
    with pytest.raises(ToolError) as caught:
        compiled(tmp_path, "[[objects]]\n" + text, m_obj=GROUPED, paint_mtl="newmtl red\nKd 1 0 0\n", p_obj=QUADS, m_stl=stl())
    said = str(caught.value)
    assert all(part in said for part in parts) and "\n" not in said and len(said) < 400, said
