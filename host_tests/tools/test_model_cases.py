# SPDX-License-Identifier: MIT
"""Models as other programs write them, in the folder models: what each must look like, and what must be said of it."""

import pathlib
import shutil

import numpy
import pytest

from conftest import run_cli
from fixel.base.errors import ToolError
from fixel.board import dump
from fixel.image import image, image_surface
from fixel.model import obj, t_junctions
from fixel.scene import compiler, look
from model_files import glb, gltf, png
from test_model_files import grid

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "host/frames", "host/judge", "host/raycast", "host/predict")
MODELS = pathlib.Path(__file__).parent / "models"


def compiled(name):
    """The scene of a file of the folder, and the tool's notes."""
    made, notes = compiler.compile_scene(str(MODELS / name), None if str(name).endswith(".toml") else 4)
    assert image.unpack(image.pack(made)) == made
    return made, notes


def colours(made):
    """The colours of all faces."""
    return {made.palette[face.colour] for model in made.models for face in model.faces}


def as_made(name):
    """The scene of a model as its author made it, and the notes."""
    made, notes = compiler.compile_scene(str(MODELS / name), 4, look=look.Look())
    assert image.unpack(image.pack(made)) == made
    return made, notes


def in_a_scene(folder, text, *files):
    """The scene of a scene file beside files of the folder of models, and the notes."""
    for file in files:
        shutil.copy(MODELS / file, folder)
    (folder / "s.toml").write_text(text)
    made, notes = compiler.compile_scene(str(folder / "s.toml"), 4)
    assert image.unpack(image.pack(made)) == made
    return made, notes


def said(notes, *words):
    """How many notes have all of these words."""
    return sum(all(word in note for word in words) for note in notes)


def test_colours_of_vertices_are_kept():
    made, notes = compiled("vertex_colours.obj")
    assert len(colours(made)) == 6 and said(notes, "vertices have colours", "mean of its corners' colours") == 1


OF_CORNERS = {(-1, -1, -1): (255, 0, 0), (1, -1, -1): (0, 255, 0), (1, 1, -1): (0, 0, 255), (-1, 1, -1): (255, 255, 0), (-1, -1, 1): (255, 0, 255),
              (1, -1, 1): (0, 255, 255), (1, 1, 1): (255, 255, 255), (-1, 1, 1): (51, 51, 51)}


def test_colours_of_vertices_are_linear_over_faces_in_rgb565():
    """Each vertex has its own colour in every face, and a face on which they are not affine is two triangles."""
    made, notes = as_made("vertex_colours.obj")
    model, surfaces = made.models[0], made.surfaces.surfaces
    assert made.pixel_bits == 16 and not said(notes, "mean of its corners' colours")
    assert len(model.faces) == 11       # the lower face's are affine
    for face in model.faces:
        assert surfaces[face.mapped.surface].flags & image_surface.COLOURS and not surfaces[face.mapped.surface].texture
        for number, (colour, rest) in zip(face.mapped.vertices, face.mapped.texels):
            x, y, z = model.vertices[number]
            # The file's z points the other way.
            red, green, blue = OF_CORNERS[x // abs(x), y // abs(y), -z // abs(z)]
            assert (colour, rest) == (red << 16 | green << 8 | blue, 0)


def test_corners_that_are_nearly_alike_have_one_colour(tmp_path):
    corner = "v {0} {1} 0 {2}\n"
    for most, is_flat in ((4, True), (5, False)):
        (tmp_path / "s.obj").write_text(corner.format(0, 0, "0.2 0.2 0.2") + corner.format(1, 0, "0.2 0.2 0.2") +
                                        corner.format(0, 1, f"0.2 {(51 + most) / 255:.6f} 0.2") + "f 1 2 3\n")
        made, _ = compiler.compile_scene(str(tmp_path / "s.obj"), 4, look=look.Look())
        flags = [made.surfaces.surfaces[face.mapped.surface].flags & image_surface.COLOURS if face.mapped else 0
                 for face in made.models[0].faces]
        assert (not any(flags)) == is_flat


def test_a_palette_shows_no_colours_at_corners(tmp_path):
    text = '%s[[objects]]\nmodel = "vertex_colours.obj"\nvertex_colours = true\n'
    in_a_scene(tmp_path, text % '[view]\npixels = "rgb565"\n', "vertex_colours.obj")
    with pytest.raises(ToolError, match='cannot show colours at corners: give pixels = "rgb565" under \\[view\\], or vertex_colours = false'):
        in_a_scene(tmp_path, text % "", "vertex_colours.obj")
    with pytest.raises(ToolError, match="leave colour out"):
        in_a_scene(tmp_path, text % '[view]\npixels = "rgb565"\n' + 'colour = "red"\n', "vertex_colours.obj")


def test_colours_at_corners_have_a_division(tmp_path):
    """surfaces 1.4f."""
    text = '[view]\npixels = "rgb565"\n[[objects]]\nmodel = "vertex_colours.obj"\n%sdivision = %s\n'
    for words, kind in (("16", image_surface.DIVIDE_16), ("8", image_surface.DIVIDE_8), ("1", image_surface.DIVIDE_1),
                        ('"affine"', image_surface.AFFINE)):
        made, _ = in_a_scene(tmp_path, text % ("vertex_colours = true\n", words), "vertex_colours.obj")
        assert {each.division for each in made.surfaces.surfaces if each.flags & image_surface.COLOURS} == {kind}
    with pytest.raises(ToolError, match=r"division.*texture"):
        in_a_scene(tmp_path, text % ("", "8"), "vertex_colours.obj")


def test_an_image_that_is_not_there():
    made, notes = compiled("missing_image.obj")
    red, green, blue = max(colours(made))
    assert red > green > blue and said(notes, "missing_image.mtl:3", "wood.png", "the colour of their material") == 1


def test_a_file_whose_name_has_another_case():
    made, notes = compiled("case.obj")
    red, green, blue = max(colours(made))
    assert blue > green > red and said(notes, 'no "Case.MTL": "case.mtl" is read instead') == 1


def test_a_text_of_stl_in_capitals():
    made, _ = compiled("capitals.stl")
    assert sum(len(model.faces) for model in made.models) == 6


def test_a_statement_that_is_not_known():
    made, notes = compiled("unknown_statement.obj")
    assert len(made.models[0].faces) == 6 and said(notes, "not known", "1 x vw", "unknown_statement.obj:9") == 1


def test_a_ball_with_an_image_is_lit_from_one_side():
    for name in ("lit_images.toml", "lit_images_levels.toml"):
        made, _ = compiled(name)
        assert made.light or len({(face.colour, face.normal) for face in made.models[0].faces}) > 4 * len({"red", "green", "blue", "yellow"})
    made, _ = compiled("lit_images.toml")
    bright = {face.normal: sum(made.palette[face.colour]) for face in made.models[0].faces if face.mapped is None}
    towards, away = ([bright[normal] for normal in bright if sign * (0.8 * normal[0] - normal[1] + 0.4 * normal[2]) > 1 << 30]
                     for sign in (-1, 1))
    assert min(towards) > max(away) - 120 and sum(towards) / len(towards) > 1.3 * sum(away) / len(away)


QUARTERS = {(True, True): (220, 40, 40), (True, False): (40, 180, 60), (False, True): (50, 80, 220), (False, False): (230, 210, 60)}


@pytest.mark.parametrize("scene", [None, '[light]\nlevels = 16\n[[objects]]\nmodel = "ball_textured.obj"\nimages = true\n'])
def test_a_ball_shows_the_quarters_of_its_image_and_is_lit(tmp_path, scene):
    """Each face lies in one quarter, so it has its colour and needs no texture."""
    made, _ = as_made("ball_textured.obj") if scene is None else in_a_scene(tmp_path, scene, "ball_textured.obj", "ball.mtl", "quarters.png")
    model = made.models[0]
    for face in model.faces:
        _, y, z = (sum(model.vertices[corner][axis] for corner in face.corners) for axis in range(3))
        assert made.palette[face.colour] == QUARTERS[y > 0, z > 0]
    assert made.light and len(made.light.ramp) >= 16 and len(model.faces) >= 72


def test_textures_that_no_light_can_be_baked_into_are_lit_at_run_time(tmp_path):
    image_of = png([[(4 * x, 4 * y, 40) for x in range(64)] for y in range(64)])
    points, triangles = grid(8, lambda x, y: x * y / 9)
    (tmp_path / "m.glb").write_bytes(glb(*gltf(points, triangles, uvs=[(x / 8, y / 8) for x, y, _ in points], image=image_of)))
    scene = '[light]\ndirection = [0.8, -1, 0.4]\ncolour = "#fff0e0"\n{}[[objects]]\nmodel = "m.glb"\nimages = true\n'
    (tmp_path / "s.toml").write_text(scene.format(""))
    (tmp_path / "t.toml").write_text(scene.replace('colour = "#fff0e0"\n', "").format("levels = 16\n"))
    made, notes = compiled(tmp_path / "s.toml")
    assert said(notes, "more than 16 directions", "light.levels = 16", "without light.colour") == 1 and len(made.light.ramp) == 16
    levels, more = compiled(tmp_path / "t.toml")
    assert image.pack(made) == image.pack(levels) and not said(more, "directions")


def test_greys_of_16_bits_are_four():
    made, _ = compiled("grey16.toml")
    one, = made.surfaces.textures
    found = {made.palette[entry] for entry in one.texels}
    assert len(found) == 4 and all(red == green == blue for red, green, blue in found)


def cracks(frames):
    """Pixels of the background between two of a face, over all frames."""
    bare = [numpy.pad(frame.pixels == 0, 1, constant_values=True) for frame in frames]
    return sum(int((each[1:-1, 1:-1] & (~each[1:-1, 2:] & ~each[1:-1, :-2] | ~each[2:, 1:-1] & ~each[:-2, 1:-1])).sum()) for each in bare)


def test_no_background_shows_at_a_t_junction(build, tmp_path, monkeypatch):
    _, notes = compiled("t_junction.toml")
    assert said(notes, "t_junction.obj: 1 edges had vertices of other faces on them") == 1
    found = {}
    for name, mend in (("mended", t_junctions.mend), ("as it is", lambda *_: None)):
        monkeypatch.setattr(t_junctions, "mend", mend)
        made, _ = compiled("t_junction.toml")
        (tmp_path / "scene.fxls").write_bytes(image.pack(made))
        done = run_cli("run", "--board", "host", "--scene", tmp_path / "scene.fxls", "--out", tmp_path / name, "--build", build)
        assert done.returncode == 0, done.stderr
        frames = dump.read_dump(tmp_path / name / "board.fxld").frames
        found[name] = len(frames), cracks(frames)
    assert found == {"mended": (40, 0), "as it is": (40, 1)}


# --- glTF -----------------------------------------------------------------------------------

def texels(made):
    """The texels of the only texture's largest level, None where it is clear."""
    one, = made.surfaces.textures
    found = [int.from_bytes(one.texels[2 * i:2 * i + 2], "little") for i in range(1 << one.log_width + one.log_height)]
    return [None if one.flags & 2 and value == one.key_565 else value for value in found]


def test_a_texture_alone_is_shown():
    made, _ = as_made("plain_texture.glb")
    assert all(face.mapped for face in made.models[0].faces) and len(set(texels(made))) == 4


def test_alpha_of_an_opaque_material_is_left_out_of_account():
    made, _ = as_made("opaque_with_alpha.glb")
    shown = [face for face in made.models[0].faces if face.mapped]
    assert not any(made.surfaces.textures[made.surfaces.surfaces[face.mapped.surface].texture - 1].flags & 2 for face in shown)
    assert len(made.models[0].faces) == 12


def test_alpha_of_a_mask_makes_holes():
    made, _ = as_made("mask_with_alpha.glb")
    found = texels(made)
    side = 1 << made.surfaces.textures[0].log_width
    assert all((found[row * side + column] is None) == (2 * column >= side) for row in range(side) for column in range(side))


IMAGES = '[view]\npixels = "rgb565"\n[light]\nlevels = 16\n[[objects]]\nmodel = "{}"\nimages = {{ size = 64, bits = 16 }}\n'


@pytest.mark.parametrize("name, clear", [("plain_texture.glb", 0), ("opaque_with_alpha.glb", 0), ("mask_with_alpha.glb", 64 * 32)])
def test_images_of_a_scene_file_show_the_same(tmp_path, name, clear):
    made, _ = in_a_scene(tmp_path, IMAGES.format(name), name)
    assert len(made.models[0].faces) == 12 and all(face.mapped for face in made.models[0].faces)
    assert texels(made).count(None) == clear


def test_a_texture_transform_of_a_scene_file_shows_one_quarter(tmp_path):
    made, notes = in_a_scene(tmp_path, IMAGES.format("texture_transform.glb"), "texture_transform.glb")
    assert colours(made) == {QUARTERS[True, True]} and made.surfaces is None and not said(notes, "KHR_texture_transform")


def test_a_texture_transform_moves_the_coordinates():
    """The sides show the quarter that is red alone, so no texture is left."""
    made, notes = as_made("texture_transform.glb")
    assert made.surfaces is None and len(colours(made)) <= 6
    assert all(red > 2 * max(green, blue) for red, green, blue in colours(made)) and not said(notes, "KHR_texture_transform")


def test_an_animation_turns_the_model_and_is_left_out_with_a_note_where_nothing_moves():
    made, notes = as_made("animated.glb")
    motion, = made.motions
    assert motion.repeats and len(motion.keys) > 2 and len({key.angles for key in motion.keys}) > 2
    assert said(notes, "the animation takes 60 frames and moves 1 of 1 parts") == 1 and not said(notes, "left out animations (1)")
    still, more = compiled("animated.glb")
    assert not still.motions and said(more, "animated.glb: left out animations (1)") == 1


def test_a_material_that_shines_is_as_bright_on_every_side():
    made, _ = as_made("emissive.glb")
    assert colours(made) == {(255, 203, 89)} and made.light is None


def test_a_mirrored_node_is_not_inside_out():
    _, notes = as_made("mirrored.glb")
    assert not said(notes, "inside out") and not said(notes, "turned round")


def test_quantized_vertices_are_read():
    made, _ = as_made("quantized.glb")
    assert len(made.models[0].vertices) == 8 and made.models[0].kind == image.CONVEX


@pytest.mark.parametrize("suffix, words", [
    ("fbx", ["FBX", "Blender", ".glb"]), ("dae", ["Collada", ".glb"]), ("3mf", ["3MF", "STL"]), ("vox", ["MagicaVoxel", "OBJ"]),
    ("blend", ["Blender", ".glb"]), ("ZIP", ["archive", "unpack"]), ("usdz", ["USD", ".glb"])])
def test_formats_that_are_not_read_are_refused_by_name_with_the_way_to_go(tmp_path, suffix, words):
    (tmp_path / f"model.{suffix}").write_bytes(b"x")
    (tmp_path / "scene.toml").write_text(f'[[objects]]\nmodel = "model.{suffix}"\n')
    for name in (f"model.{suffix}", "scene.toml"):
        with pytest.raises(ToolError) as caught:
            compiler.compile_scene(str(tmp_path / name))
        assert all(word in str(caught.value) for word in (f"model.{suffix}", *words)) and "\n" not in str(caught.value)


def test_every_model_of_the_folder_has_a_test():
    tests = "".join((pathlib.Path(__file__).parent / name).read_text() for name in ("test_model_cases.py", "test_model_look.py"))
    files = {file.name for file in MODELS.iterdir() if file.suffix not in (".png", ".mtl")}
    assert len(files) >= 20 and [name for name in sorted(files) if f'"{name}"' not in tests and f"{name}: " not in tests] == []


# --- glass, cut-outs, size, what is told ----------------------------------------------------------

@pytest.mark.parametrize("factor, mode, opacity", [(0, "OPAQUE", 1), (1, "OPAQUE", 0.25), (0.5, "OPAQUE", 0.625), (7, "OPAQUE", 0.25), (1, "BLEND", 0.125),
                                                   (-1, "OPAQUE", 1)])
def test_glass_by_transmission_is_seen_through(tmp_path, factor, mode, opacity):
    data, blob = gltf(material={"baseColorFactor": [1, 1, 1, 0.5]})
    data["materials"][0] |= {"alphaMode": mode, "extensions": {"KHR_materials_transmission": {"transmissionFactor": factor}}}
    data["extensionsUsed"] = ["KHR_materials_transmission", "KHR_materials_volume"]
    (tmp_path / "m.glb").write_bytes(glb(data, blob))
    made, notes = compiler.compile_scene(str(tmp_path / "m.glb"), 4, look=look.Look())
    found = {made.surfaces.surfaces[face.mapped.surface].opacity if face.mapped else 16 for model in made.models for face in model.faces}
    assert found == {16 * opacity} and said(notes, 'left out what the extensions "KHR_materials_volume" say') == 1
    data["materials"][0]["extensions"]["KHR_materials_transmission"]["transmissionTexture"] = {"index": 0}
    (tmp_path / "m.glb").write_bytes(glb(data, blob))
    assert said(compiler.compile_scene(str(tmp_path / "m.glb"), 4)[1], "maps of transmission") == 1


GREEN, HALF = [[(0, 200, 0)] * 8] * 8, [[(255,) * 3] * 4 + [(0,) * 3] * 4] * 8     # a half that is seen


def leaf(folder, paint, **files):
    """The material of a square with these statements, and the notes."""
    for name, data in {"green.png": png(GREEN), "half.png": png(HALF), **files}.items():
        (folder / name).write_bytes(data)
    (folder / "m.mtl").write_text("newmtl leaf\n" + paint)
    (folder / "m.obj").write_text("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl leaf\nf 1/1 2/2 3/3 4/4\n")
    mesh, notes = obj.read(str(folder / "m.obj"))
    return mesh.surfaces.materials[0], notes


def shows(material):
    """The alpha of the left and of the right end of a material's image."""
    return tuple(int(material.image.pixels[0, column, 3]) for column in (0, -1))


def test_map_d_cuts_out_what_it_does_not_show(tmp_path):
    clear = numpy.array([[(255, 0, 0, 255)] * 4 + [(255, 0, 0, 0)] * 4] * 8)
    for paint, colour in (("map_Kd green.png\nmap_d half.png\n", (0, 200, 0)), ("Kd 0.2 0.4 0.6\nmap_d half.png\n", (255, 255, 255)),
                          ("map_d alpha.png\nmap_kd green.png\n", (0, 200, 0)), ("map_Kd alpha.png\nmap_d alpha.png\n", (255, 0, 0)),
                          ("map_Kd -s 2 2 green.png\nmap_D -s 2 2 half.png\n", (0, 200, 0))):
        material, notes = leaf(tmp_path, paint, **{"alpha.png": png(clear)})
        assert shows(material) == (255, 0) and tuple(material.image.pixels[0, 0, :3]) == colour and not said(notes, "as map_Kd") and not said(notes, "ignored")
    assert leaf(tmp_path, "Kd 0.2 0.4 0.6\nmap_d half.png\n")[0].colour == (51, 102, 153)
    assert leaf(tmp_path, "Kd 0 0 0\nmap_d half.png\n")[0].colour == (0, 0, 0)
    made, _ = compiler.compile_scene(str(tmp_path / "m.obj"), 4, look=look.Look())
    assert made.surfaces and image.unpack(image.pack(made)) == made
    for paint, words in (("map_Kd green.png\nmap_d -s 2 2 half.png\n", ("map_d that does not lie as map_Kd does", "m.mtl:3")),
                         ("map_Kd green.png\nmap_d none.png\n", ("none.png", "Nothing is cut out", "m.mtl:3"))):
        material, notes = leaf(tmp_path, paint)
        assert shows(material) == (255, 255) and said(notes, *words) == 1


@pytest.mark.parametrize("radius, fits", [(10 ** 9, True), (4e-9, True), (1e-9, False), (0, False)])
def test_a_model_of_any_size_of_a_file_is_framed_or_refused_with_the_way_out(tmp_path, radius, fits):
    corners = "".join(f"v {x * radius:.15f} {y * radius:.15f} {z * radius:.15f}\n" for x in (-1, 1) for y in (-1, 1) for z in (-1, 1))
    (tmp_path / "m.obj").write_text(corners + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n")
    if fits:
        made, _ = compiler.compile_scene(str(tmp_path / "m.obj"), 4, look=look.Look())
        assert image.unpack(image.pack(made)) == made and max(max(map(abs, vertex)) for vertex in made.models[0].vertices) > 2 << 16
        return
    with pytest.raises(ToolError, match=r"m.obj: .*radius of .* is outside .*\.\.2e\+09: scale the model"):
        compiler.compile_scene(str(tmp_path / "m.obj"), 4, look=look.Look())


@pytest.mark.parametrize("command", ["build", "export"])
def test_what_is_the_same_for_every_file_is_told_with_v_alone(tmp_path, command):
    usual = ("right-handed", "welded to", "framed by default")
    (tmp_path / "s.toml").write_text('[[objects]]\nmodel = "capitals.stl"\n')
    shutil.copy(MODELS / "capitals.stl", tmp_path)
    how = ["--c"] if command == "export" else []
    for scene, words in (("capitals.stl", usual), ("s.toml", usual[:2])):
        said_by = {option: run_cli(command, *how, tmp_path / scene, "-o", tmp_path / "out", *option.split()) for option in ("", "-v", "--verbose")}
        assert all(done.returncode == 0 for done in said_by.values())
        for word in words:
            assert [word in done.stderr for done in said_by.values()] == [False, True, True]
    assert "framed by default" in run_cli(command, *how, tmp_path / "capitals.stl", "-o", tmp_path / "out", "--look=-v").stderr
