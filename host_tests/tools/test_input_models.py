# SPDX-License-Identifier: MIT
"""Models that take much for their size: the same file or image by many names, parts without values, many faces that
cost more than others; and large models as people have them, which compile within the default limits, and which no count refuses. On a
machine of 2026 each takes less than 10 s of CPU time; make test takes a sample of them. The limits are those of test_input_bounds.py."""

import json
import os
import random
import subprocess
import sys

import pytest

import honest_models
from conftest import CHECKOUT, LAUNCHER, environment, run_cli, sampled
from fixel.base.errors import ToolError
from fixel.base.reading import Beside, QUOTE_MAX
from fixel.image import image
from fixel.model import gltf_check, model_file, solids, sources, suffixes
from fixel.model.mesh import FACES_MAX, shape
from fixel.model.quantity import matrix
from fixel.scene import making, parts
from model_files import SQUARE, TETRAHEDRON, glb, gltf, gltf_text, png
from test_input_bounds import PATH, assert_ended, run_bounded

BUILT_PROGRAMS = ()
CORNERS = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
FACES = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
LARGE = png([[(1, 2, 3)] * 2048] * 2048)     # 17 kB


def build(tmp_path, name, code=0, *more):
    """Builds a file of the folder within the limits; answers what was said."""
    found, said = run_bounded("build", tmp_path / name, "-o", tmp_path / "out.fxls", *more)
    assert found == code and (tmp_path / "out.fxls").exists() == (code == 0), said[-2000:]
    lines = [line for line in said.splitlines() if line.startswith(("error: ", "note: "))]
    assert max(map(len, lines), default=0) < 500 and (code == 0 or len(lines) == 1)
    return said


def write(tmp_path, **files):
    """Files of the folder; the last underscore of a name stands for a dot."""
    for name, data in files.items():
        (tmp_path / ".".join(name.rsplit("_", 1))).write_bytes(data if isinstance(data, bytes) else data.encode())


# --- glTF --------------------------------------------------------------------------

def test_primitives_without_values_count(tmp_path):
    data, blob = gltf(*TETRAHEDRON, nodes=[{"mesh": 0}] + [{"mesh": 1}] * 1000)
    data["accessors"].append({**data["accessors"][0], "count": 0})
    data["meshes"].append({"primitives": [{"attributes": {"POSITION": len(data["accessors"]) - 1}}] * 3000})
    data["scenes"][0]["nodes"] = list(range(1001))
    write(tmp_path, m_glb=glb(data, blob))
    assert "65,535 primitives" in build(tmp_path, "m.glb", code=2)


def test_a_list_of_gltf_is_checked_once(tmp_path):
    data, blob = gltf(*TETRAHEDRON, nodes=[{"mesh": 0}] * 3000)
    data["scenes"][0]["nodes"] = list(range(3000))
    data["bufferViews"] += [{}] * 1_000_000
    write(tmp_path, m_gltf=gltf_text(data, blob))
    build(tmp_path, "m.gltf")


def test_a_buffer_view_is_not_copied(tmp_path):
    """It may be 64 MB, and each primitive asks for four."""
    write(tmp_path, m_glb=glb(*gltf()))
    checked = gltf_check.open_file(str(tmp_path / "m.glb"), "m.glb", sources.Sources())
    views = [checked.view({"bufferView": 0}, "here")[0] for _ in range(2)]
    assert views[0].obj is views[1].obj


def with_images(count, shorter):
    """A GLB file of so many materials, each with an image of its own; each begins at the same byte and is so many bytes
    shorter than the one before."""
    data, blob = gltf(uvs=[(0, 0)] * 4, image=LARGE + bytes(count * shorter))
    part, view = data["meshes"][0]["primitives"][0], data["bufferViews"][-1]
    first = len(data["bufferViews"])
    data["bufferViews"] += [{**view, "byteLength": view["byteLength"] - i * shorter} for i in range(count)]
    data["images"] = [{"bufferView": first + i} for i in range(count)]
    data["textures"] = [{"source": i} for i in range(count)]
    data["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": i}}} for i in range(count)]
    data["meshes"][0]["primitives"] = [{**part, "material": i} for i in range(count)]
    return glb(data, blob)


def test_many_images_of_gltf_that_are_one(tmp_path):
    write(tmp_path, m_glb=with_images(60, 0))
    build(tmp_path, "m.glb")


def test_very_many_pixels(tmp_path):
    """200 images of 2048 x 2048 pixels in 4 MB."""
    write(tmp_path, m_glb=with_images(200, 1))
    assert_ended(tmp_path, tmp_path / "m.glb")


def test_a_name_of_a_material_that_is_no_text(tmp_path):
    data, blob = gltf(material={})
    data["materials"][0]["name"] = ["x"] * 9
    write(tmp_path, m_glb=glb(data, blob))
    assert model_file.reader_of("m.glb")(str(tmp_path / "m.glb"))[0].surfaces.materials[0].name == "0"


# --- OBJ and MTL -------------------------------------------------------------------

def test_an_mtl_file_is_read_once(tmp_path):
    write(tmp_path, m_mtl="newmtl a\nKd 1 0 0\n" + "# x\n" * 260_000,
          m_obj=CORNERS + "".join(f"mtllib {'./' * (i % 30)}m.mtl\n" for i in range(300)) + "usemtl a\n" + FACES)
    build(tmp_path, "m.obj")


def test_500_000_names_of_mtl_files(tmp_path):
    write(tmp_path, m_obj=CORNERS + FACES + "mtllib " + "a " * 500_000 + "\n")
    assert "there is no" in build(tmp_path, "m.obj")


def test_many_names_of_mtl_files(tmp_path):
    names = [f"{first}/{second}" for first in range(100) for second in range(1000)]
    write(tmp_path, m_obj=CORNERS + FACES + f"mtllib {' '.join(names)}\n")
    assert "there is no" in build(tmp_path, "m.obj")


def test_an_image_of_mtl_is_decoded_once(tmp_path):
    names = ["t.png"] + ["./" * i + "t.png" for i in range(99)]
    write(tmp_path, t_png=LARGE, m_mtl="".join(f"newmtl m{i}\nmap_Kd {name}\n" for i, name in enumerate(names)),
          m_obj=CORNERS + "mtllib m.mtl\nusemtl m0\n" + FACES)
    build(tmp_path, "m.obj")


def many_materials(count):
    """(OBJ, MTL) of faces of which each has a material of its own, all with one image."""
    return (CORNERS + "vt 0 0\nvt 1 0\nvt 0 1\nmtllib m.mtl\n" +
            "".join(f"usemtl m{i}\nf {i % 4 + 1}/1 {(i + 1) % 4 + 1}/2 {(i + 2) % 4 + 1}/3\n" for i in range(count)),
            "".join(f"newmtl m{i}\nKd {i / count:.4f} 0.5 {i % 7 / 7:.2f}\nmap_Kd t.png\n" for i in range(count)))


@pytest.mark.parametrize("size", [256, 1])
def test_one_image_of_4096_colours(tmp_path, size):
    obj, mtl = many_materials(4096)
    noise = png([[((x * 79 + y * 104) % 256, (x * 31 + y * 17) % 256, (x * x + y) % 256) for x in range(256)]
                 for y in range(256)])
    write(tmp_path, t_png=noise if size > 1 else LARGE, m_mtl=mtl, m_obj=obj, scene_toml=PATH + '[[objects]]\nmodel = "m.obj"\n'
          f"fit = 9\nimages = {{ size = {size}, colours = 255, levels = 9 }}\n")
    assert_ended(tmp_path, tmp_path / "scene.toml")


def test_faces_of_thousands_of_corners_that_cross_themselves(tmp_path):
    chance = random.Random(4)
    write(tmp_path, m_obj="".join(f"v {chance.random():.2f} {chance.random():.2f} 0\n" for _ in range(99)) +
          "".join("f " + " ".join(str(chance.randrange(1, 100)) for _ in range(4000)) + "\n" for _ in range(16)))
    build(tmp_path, "m.obj")


def test_quads_that_are_not_flat_and_share_their_vertices(tmp_path, count=30_000):
    chance = random.Random(7)
    points = [(chance.random(), chance.random(), chance.random()) for _ in range(99)]
    write(tmp_path, m_obj="".join("v {:.2f} {:.2f} {:.2f}\n".format(*point) for point in points) +
          "".join("f {} {} {} {}\n".format(*chance.sample(range(1, 100), 4)) for _ in range(count)))
    build(tmp_path, "m.obj")


# --- models of a scene -------------------------------------------------------------

def test_a_model_by_many_names_is_read_once(tmp_path):
    write(tmp_path, m_obj=CORNERS + FACES + "v 0 0 0\n" * 125_000,
          scene_toml=PATH + "".join(f'[[objects]]\nobj = "{"./" * i}m.obj"\n' for i in range(30)))
    (tmp_path / "link.obj").symlink_to("m.obj")
    with (tmp_path / "scene.toml").open("a") as scene:
        scene.write('[[objects]]\nmodel = "link.obj"\nfit = 3\n')
    assert build(tmp_path, "scene.toml").count("left out vertices") == 1


def test_a_model_that_is_fitted_4000_times(tmp_path):
    """Its extent is computed once: it has many vertices, and few that are not equal."""
    write(tmp_path, m_obj=CORNERS + FACES + "v 0 0 0\n" * 9000 + "".join(f"f {i} {i} 1\n" for i in range(5, 9005)),
          scene_toml=PATH + '[[objects]]\nobj="m.obj"\nfit=1\n' * 4000)
    build(tmp_path, "scene.toml")


def test_models_of_very_many_bytes(tmp_path):
    for i in range(3):
        with (tmp_path / f"m{i}.obj").open("w") as file:
            file.write(CORNERS + FACES + "# ")
            file.write(" " * (50 << 20))
    write(tmp_path, scene_toml=PATH + "".join(f'[[objects]]\nobj = "m{i}.obj"\n' for i in range(3)))
    build(tmp_path, "scene.toml")


SURFACED = PATH + '[light]\nlevels = 8\n[[textures]]\nname = "t"\npattern = "checker"\n[[objects]]\nobj = "m.obj"\nfit = 9\n'
LOOKS = {"smooth": "smooth = true\nlit = true\n", "texture": 'texture = "t"\nsmooth = true\n',
         "opacity": "lit = false\nopacity = 8\n"}


def loose_triangles(count):
    """An OBJ file of triangles of which no two share a vertex: about 88 bytes each."""
    chance = random.Random(5)
    lines = [f"v {chance.gauss(0, 1):.4f} {chance.gauss(0, 1):.4f} {chance.gauss(0, 1):.4f}\n" for _ in range(3 * count)]
    return "".join("".join(lines[i:i + 3]) + "f -1 -2 -3\n" for i in range(0, 3 * count, 3))


@pytest.mark.parametrize("look", sampled("loose triangles", LOOKS, 1))
def test_20_000_loose_triangles_with_surfaces(tmp_path, look):
    write(tmp_path, m_obj=loose_triangles(20_000), scene_toml=SURFACED + LOOKS[look])
    build(tmp_path, "scene.toml")


@pytest.mark.parametrize("count, look", sampled("shared vertices", [(count, look) for count in (11_000, 65_000) for look in LOOKS], 2))
def test_faces_with_surfaces_that_share_their_vertices(tmp_path, count, look):
    chance = random.Random(6)
    points = [(chance.random(), chance.random(), chance.random()) for _ in range(99)]
    write(tmp_path, m_obj="".join("v {:.2f} {:.2f} {:.2f}\n".format(*point) for point in points) +
          "".join("f {} {} {}\n".format(*chance.sample(range(1, 100), 3)) for _ in range(count)),
          scene_toml=SURFACED + LOOKS[look])
    if count < 20_000:
        build(tmp_path, "scene.toml")
    else:
        assert_ended(tmp_path, tmp_path / "scene.toml")


# --- names -------------------------------------------------------------------------

LONG = "./" * 1900
ESCAPE = "\x1b[31mx"
NAMES = {"long": LONG + "m", "escape": ESCAPE, "lines": "a\nerror: b", "text": "x" * 240}


@pytest.mark.parametrize("kind", NAMES)
@pytest.mark.parametrize("sound", [True, False])
def test_names_of_models_in_messages(tmp_path, kind, sound):
    name = NAMES[kind] + ".obj"
    (tmp_path / os.path.normpath(name)).write_text(CORNERS + FACES + "v 0 0 0\n" if sound else "xyz\n")
    write(tmp_path, scene_toml=PATH + f"[[objects]]\nobj = {json.dumps(name)}\nfit = 9\n")
    assert_escaped(build(tmp_path, "scene.toml", code=0 if sound else 2), kind)


def assert_escaped(said, kind):
    """What was said has no raw escape, and no long piece of a name."""
    assert "\x1b" not in said and "\nerror: b" not in said
    assert ("\\x1b[31m" in said) == (kind == "escape") and "./" * 40 not in said and "x" * (QUOTE_MAX + 1) not in said


@pytest.mark.parametrize("kind", ["long", "escape", "text"])
@pytest.mark.parametrize("text, words", [("Kd x\n", "stands before"), (None, "is a folder"),
                                         ("newmtl a\nmap_Kd {}\n", "is a folder")])
def test_names_of_mtl_files_and_images_in_messages(tmp_path, kind, text, words):
    name = NAMES[kind] + ".mtl"
    write(tmp_path, m_obj=f"mtllib {name}\n" + CORNERS + FACES)
    place = tmp_path / os.path.normpath(name)
    if text is None:
        place.mkdir()
    else:
        place.write_text(text.format(name.replace(".mtl", ".png")))
        (tmp_path / os.path.normpath(name.replace(".mtl", ".png"))).mkdir()
    said = build(tmp_path, "m.obj", code=0 if text and "map_Kd" in text else 2)     # an image that cannot be read is a note
    assert words in said
    assert_escaped(said, kind)


@pytest.mark.parametrize("kind", NAMES)
def test_names_of_buffers_in_messages(tmp_path, kind):
    name = NAMES[kind] + ".bin"
    (tmp_path / os.path.normpath(name)).mkdir()
    data, blob = gltf(*SQUARE)
    write(tmp_path, m_gltf=gltf_text(data, blob).replace(
        gltf_text(data, blob).split(b'"uri": ')[1].split(b"}")[0], json.dumps(name).encode()))
    said = build(tmp_path, "m.gltf", code=2)
    assert "is a folder" in said
    assert_escaped(said, kind)


@pytest.mark.parametrize("kind", ["escape", "text", "lines"])
def test_names_of_bare_models_in_messages(tmp_path, kind):
    for text, code in ((CORNERS + FACES, 0), ("xyz\n", 2)):
        (tmp_path / (NAMES[kind] + ".obj")).write_text(text)
        lines = [line.replace(str(tmp_path), "") for line in build(tmp_path, NAMES[kind] + ".obj", code, "-v").splitlines()]
        assert_escaped("\n".join(lines), kind)
        (tmp_path / "out.fxls").unlink(missing_ok=True)


def test_a_beside_is_a_path_and_a_short_text(tmp_path):
    file = Beside(tmp_path, LONG + "m.obj")
    assert os.fspath(file) == os.path.join(tmp_path, LONG + "m.obj") and not file.exists()
    assert len(f"{file}") <= QUOTE_MAX and f"{file}".endswith("m.obj") and suffixes.suffix_of(file) == ".obj"
    assert not Beside(tmp_path, "a\0b").exists()


@pytest.mark.parametrize("arguments", [
    ["info", "{name}.fxls"], ["texture", "t.png", "-o", "{name}.h", "--name", "t"],
    ["build", "{name}.toml", "-o", "{name}.fxls"], ["build", "{name}.obj", "-o", "{name}.fxls"],
    ["build", "none-{name}.toml", "-o", "o.fxls"]])
def test_names_that_are_no_text_are_printed_escaped(tmp_path, arguments):
    name = os.fsdecode(b"\xff")
    write(tmp_path, t_png=png([[(1, 2, 3)] * 4] * 4))
    (tmp_path / f"{name}.toml").write_text(PATH + '[[objects]]\nsolid = "box"\n')
    (tmp_path / f"{name}.obj").write_text(CORNERS + FACES)
    making.build(CHECKOUT / "scenes" / "tiny.toml", tmp_path / f"{name}.fxls")
    done = subprocess.run([sys.executable, str(LAUNCHER), *(each.format(name=name) for each in arguments)], cwd=tmp_path,
                          capture_output=True, check=False, env=environment(PYTHONIOENCODING="utf-8:strict"))
    assert done.returncode == (2 if "none" in arguments[1] else 0) and b"Traceback" not in done.stderr, done.stderr
    assert b"\\udcff" in done.stdout + done.stderr


SPHERES = [(suffix, count) for suffix in ("obj", "glb", "stl") for count in (40_000, 65_535)]
# Name: how its files are made, and at least so many faces are drawn, in so many objects.
MODELS = {f"sphere of {count:,} faces, {suffix}": ((lambda folder, suffix=suffix, count=count: honest_models.sphere_file(
    folder, suffix, count)), 30_000, 1) for suffix, count in SPHERES} | {
        "terrain": (honest_models.terrain, 200_000, 4),
        "objects": (honest_models.many_objects, 20_000 * 6, 20_000),
        "materials": (honest_models.many_materials, 800, 1),
        "concave faces": (honest_models.concave_faces, 29_980, 1),
        "nodes": (honest_models.many_nodes, 20_000, 1)}


@pytest.mark.parametrize("name", sampled("honest models", MODELS, 3))
def test_a_large_model_is_compiled(tmp_path, name):
    make, faces, objects = MODELS[name]
    done = run_cli("build", make(tmp_path), "-o", tmp_path / "out.fxls")
    assert done.returncode == 0, done.stderr[-2000:]
    made = image.load(tmp_path / "out.fxls")
    assert len(made.objects) == objects and max(len(model.faces) for model in made.models) <= FACES_MAX
    assert sum(len(made.models[item.model].faces) for item in made.objects) >= faces


def test_there_are_eleven():
    assert len(MODELS) == 11


def test_a_model_that_turns_is_not_divided(tmp_path):
    honest_models.terrain(tmp_path)
    (tmp_path / "scene.toml").write_text('[[objects]]\nmodel = "model.obj"\nfit = 9\nturn = 3\n')
    done = run_cli("build", tmp_path / "scene.toml", "-o", tmp_path / "out.fxls")
    assert done.returncode == 2 and "200000 faces; a model has at most 65535 of each, so split it" in done.stderr, done.stderr


def test_a_model_is_divided_into_the_fewest_cells_that_do(tmp_path, monkeypatch):
    """Of a grid of as many cells across as along; no face is lost."""
    made = shape(solids.make("floor", {"cells": (20, 20)}, "here"), matrix((9, 9, 9), (0, 0, 0)), "here")
    for most, wanted in ((441, None), (440, (2, 2)), (121, (2, 2)), (120, (3, 3)), (9, (10, 10))):     # vertices of a part
        monkeypatch.setattr(parts, "FACES_MAX", most)
        assert parts.fitting(made, "here") == wanted
    monkeypatch.setattr(parts, "FACES_MAX", 3)
    with pytest.raises(ToolError, match="here: 400 faces and 441 vertices are more than the 3 of a model"):
        parts.fitting(made, "here")
    found, _ = parts._grouped(made, (3, 3))
    assert sorted(number for numbers in found.values() for number in numbers) == list(range(400)) and len(found) == 9
