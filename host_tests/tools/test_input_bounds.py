# SPDX-License-Identifier: MIT
"""Any input ends in a result or in one sentence, within limits of CPU time and memory, and never in a traceback.

What compiles a scene runs under limits of the operating system, smaller ones than the defaults: an input that once took
quadratic time is seen by them. An input that asks for ever more is ended by them, and nothing is written."""

import math
import os
import random
import re
import resource

import pytest
import warm_start

from conftest import CHECKOUT, LAUNCHER, environment
from model_files import TETRAHEDRON, glb, gltf, png, stl
# place field: images that are broken, for the tools
from scene_sections import replaced, section
from test_model_files import grid
from test_texture_image import big_png
from fixel.board import flash_memory
from fixel.image import image
from fixel.model import obj
from fixel.scene import making, toml_table
from fixel.base.errors import ToolError

BUILT_PROGRAMS = ()
PATH = "[path]\nkeys = [{ position = [0, 0, 0] }]\n"
BOX = '[[objects]]\nsolid = "box"\n'
SQUARE = [(0, 0, 0), (0, 0, 65536), (65536, 0, 65536), (65536, 0, 0)]


CPU = 20            # seconds: several times what any input of these tests takes
LITTLE = 1          # second, the least that there is, for an input that asks for as much as there is
MEMORY = 1024       # MiB
COMPILING = ("build", "export", "texture")


def run_bounded(*arguments, cpu=CPU):
    """A command with these arguments, under limits: code and words."""
    limits = ["--cpu-limit", cpu, "--memory-limit", MEMORY] if arguments[0] in COMPILING else []
    # The tool itself does little more than its process that compiles.
    own = [(resource.RLIMIT_CPU, cpu + 10), (resource.RLIMIT_AS, 2 * MEMORY << 20)]
    done = warm_start.run([str(LAUNCHER), *map(str, [*arguments, *limits])], CHECKOUT, environment(), limits=own)
    words = done.stdout + done.stderr
    assert "Traceback" not in words and "defect of the tool" not in words, words[-2000:]
    assert done.returncode in (0, 1, 2), f"{done.returncode}: {words[-2000:]}"
    assert len(re.findall(r"^(?:[\w. ]+: )?error: ", words, re.M)) == (done.returncode == 2), words[-2000:]
    return done.returncode, words


def assert_refused(tmp_path, file, *words):
    """A file is refused in one short sentence that has these words, and nothing is written."""
    code, said = run_bounded("build", file, "-o", tmp_path / "out.fxls")
    line = [line for line in said.splitlines() if line.startswith("error: ")]
    assert code == 2, said[-2000:]
    assert len(line[0]) < 500 + len(str(file)) and not (tmp_path / "out.fxls").exists()
    for word in words:
        assert word in line[0]


def assert_noted(tmp_path, file, *words):
    """A file is built, and one short note has these words."""
    code, said = run_bounded("build", file, "-o", tmp_path / "out.fxls")
    assert code == 0 and (tmp_path / "out.fxls").exists(), said[-2000:]
    lines = [line for line in said.splitlines() if line.startswith("note: ") and all(word in line for word in words)]
    assert len(lines) == 1 and len(lines[0]) < 500 + len(str(file)), said


def assert_built(tmp_path, file):
    """A file is compiled within the bound."""
    code, said = run_bounded("build", file, "-o", tmp_path / "out.fxls")
    assert code == 0, said[-2000:]
    return said


def assert_ended(tmp_path, file, *more):
    """A file that asks for very much is compiled, or a limit ends it in a sentence that names the limit's option."""
    code, said = run_bounded("build", file, "-o", tmp_path / "out.fxls", *more, cpu=LITTLE)
    assert (tmp_path / "out.fxls").exists() == (code == 0)
    if code:
        line = next(line for line in said.splitlines() if line.startswith("error: "))
        assert "at the stage" in line and "--cpu-limit" in line and "--memory-limit" in line and str(file) in line, line


TOML = {
    "copies": ('[[objects]]\nsolid = "box"\nrepeat = { count = [1000, 1000, 1000], step = [1, 0, 0] }\n' + PATH,
               ["1,000,000,000 copies", "65,535"]),
    "copies of several objects": (('[[objects]]\nsolid = "box"\nrepeat = { count = [1000, 60, 1], '
                                   'step = ["1/100", "1/100", 0] }\n') * 2 + PATH, ["65,535", "60,000 stand"]),
    "faces that are made": ('[[objects]]\nsolid = "floor"\ncells = [200, 200]\nring = { count = 1000, radius = 9 }\n'
                            + PATH, None),
    "colours that are made": ('[[objects]]\nsolid = "floor"\ncells = [50, 50]\ncolour_index = 1\ncolour_next = 1\n'
                              'repeat = { count = [1000, 1, 1], step = [0, 0, 0] }\n' + PATH, None),
    "placed vertices": ('[[objects]]\nsolid = "floor"\ncells = [100, 100]\n'
                        'repeat = { count = [1000, 1, 1], step = [0, 0, 0] }\n' + PATH, ["4,000,000 vertices"]),
    "faces with clusters": ('[[objects]]\nsolid = "floor"\ncells = [200, 200]\nkind = "sorted"\nclusters = true\n' + PATH,
                            None),
    "frames": (BOX + "[path]\nkeys = [{ position = [0, 0, 0], frames = 1000000 }]\n", ["1,000,000 frames", "32,768"]),
    "orbit": (BOX + "[path]\norbit = { radius = 4, frames = 1000000 }\n", ["1,000,000 frames", "32,768"]),
    "deep": ("a = " + "[" * 50_000, ["nested"]),
    "deep and closed": ("a = " + "[" * 20_000 + "]" * 20_000, ["nested"]),
    "deep tables": ("a = " + "{ a = " * 50_000, ["nested"]),
    "dotted": ("a." * 200_000 + "a = 1\n", ["16 parts"]),
    "dotted table": ('["a".' + "'b'." * 200_000 + "a]\n", ["16 parts"]),
    "exponent": (BOX + PATH + "[view]\nnear = 1e" + "9" * 400 + "\n", ["out of every range"]),
    "exponent of the other sign": (BOX + PATH + "[view]\nnear = 1e-" + "9" * 400 + "\n", ["out of every range"]),
    "exponent in a string": (BOX + PATH + '[view]\nnear = "1e' + "9" * 400 + '"\n', ["is not a number"]),
    "digits": (BOX + PATH + "[view]\nnear = " + "9" * 5000 + "\n", ["more than 24 characters"]),
    "decimals": (BOX + PATH + "[view]\nnear = 1." + "9" * 900_000 + "\n", ["more than 24 characters"]),
    "long key": (BOX + PATH + "k" * 900_000 + " = 1\n", ['unknown key "kkk']),
    "long text": ('background = "' + "\\u0007" * 100_000 + '"\n' + BOX + PATH, ["is not a colour"]),
}


@pytest.mark.parametrize("kind", TOML)
def test_scene_files_beyond_a_limit(tmp_path, kind):
    text, words = TOML[kind]
    file = tmp_path / "scene.toml"
    file.write_text(text)
    if words:
        assert_refused(tmp_path, file, *words)
    else:
        assert_ended(tmp_path, file)


@pytest.mark.parametrize("where", ['name = {}', 'colour = {}', 'layer = {}', 'solid = {}', 'moves = {}', 'scale = {}',
                                   'two_sided = {}', 'positions = [{}]', 'cells = [{0}, {0}]'])
@pytest.mark.parametrize("value", ["0x" + "f" * 5000, "[" * 200 + "]" * 200, '"' + "\\u001b" * 900 + '"'],
                         ids=["digits", "deep", "escapes"])
def test_values_of_a_wrong_kind_are_quoted_short(tmp_path, where, value):
    file = tmp_path / "scene.toml"
    lines = [line for line in ('solid = "floor"', where.format(value)) if where[:5] != "solid" or "floor" not in line]
    file.write_text("[[objects]]\nunknown_key = 1\n" + "\n".join(lines) + "\n" + PATH)
    assert_refused(tmp_path, file, "unknown")
    file.write_text("[[objects]]\n" + "\n".join(lines) + "\n" + PATH)
    if (where[:4], value[0]) != ("name", '"'):  # a name may be any text
        assert_refused(tmp_path, file, where.split(" ")[0])


@pytest.mark.parametrize("table", ["screen", "path"])
def test_numbers_of_5000_digits(tmp_path, table):
    file, number = tmp_path / "scene.toml", "0x" + "f" * 5000
    file.write_text(BOX + (f"[path]\nkeys = [{{ position = [0, 0, 0], frames = {number} }}]\n" if table == "path" else
                           PATH + f"[screen]\nwidth = {number}\n"))
    assert_refused(tmp_path, file, "out of every range")


@pytest.mark.parametrize("option", ["--frames", "--tree", "--screen", "--name"])
def test_options_of_5000_digits(tmp_path, option):
    file = tmp_path / "scene.toml"
    file.write_text(BOX + PATH)
    verb = ["export", "--c"] if option == "--name" else ["build"]
    code, said = run_bounded(*verb, file, "-o", tmp_path / "out", option, "9" * 5000)
    assert code == 2 and max(map(len, said.splitlines())) < 400
    assert not (tmp_path / "out").exists()


def polygon(points):
    """An OBJ file of one face."""
    return "".join(f"v {x:.6f} {y:.6f} 0\n" for x, y in points) + \
        "f " + " ".join(map(str, range(1, len(points) + 1))) + "\n"


def spiral(count):
    """A band that winds inward: far from convex, and sound."""
    half = count // 2
    ways = [((1 + i / half) * math.cos(i / 20), (1 + i / half) * math.sin(i / 20), i) for i in range(half)]
    return [(x, y) for x, y, _ in ways] + [(x * 1.003, y * 1.003) for x, y, _ in reversed(ways)]


@pytest.mark.parametrize("kind", ["spiral", "random"])
def test_a_face_of_3000_corners(tmp_path, kind):
    chance = random.Random(3)
    points = spiral(3000) if kind == "spiral" else [(chance.random(), chance.random()) for _ in range(3000)]
    (tmp_path / "face.obj").write_text(polygon(points))
    said = assert_built(tmp_path, tmp_path / "face.obj")
    assert ("fans" in said) == (kind == "random")


def test_as_many_faces_with_clusters_as_there_may_be(tmp_path):
    (tmp_path / "scene.toml").write_text('[[objects]]\nsolid = "floor"\ncells = [200, 100]\nkind = "sorted"\n'
                                         "clusters = true\nscale = 99\n" + PATH)
    assert_built(tmp_path, tmp_path / "scene.toml")


OBJ = {
    "corners": (polygon([(math.cos(i / 3000), math.sin(i / 3000)) for i in range(18_000)]), ["18,000 corners", "4,096"]),
    "exponent": ("v 1e1000000 0 0\n", ["scene.obj:1", "out of every range"]),
    "tiny exponent": ("v 1e-99999999999999999999999 0 0\n", ["scene.obj:1"]),
    "digits of an index": ("v 0 0 0\nf " + "9" * 5000 + " 1 1\n", ["scene.obj:2", "is not an index"]),
    "long word": ("x" * 5_000_000, ["scene.obj", "no face", "is this an OBJ file?"]),
    "faces": ("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + "f 1 2 3\n" * 1_100_000, ["1,048,576 faces"]),
    "escapes": ("\x1b[31m\x07 1\n", ["no face", "is this an OBJ file?"]),
    "no text": ("\0" * 100_000, ["scene.obj", "no face", "is this an OBJ file?"]),
}


@pytest.mark.parametrize("kind", OBJ)
def test_models_beyond_a_limit(tmp_path, kind):
    text, words = OBJ[kind]
    (tmp_path / "scene.obj").write_text(text)
    assert_refused(tmp_path, tmp_path / "scene.obj", *words)


def test_200_000_continued_lines(tmp_path):
    (tmp_path / "scene.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\ng a" + "\\\n a" * 200_000 + "\n")
    assert_built(tmp_path, tmp_path / "scene.obj")


@pytest.mark.parametrize("name, most", [("scene.obj", obj.FILE_MAX), ("scene.toml", toml_table.FILE_MAX)])
def test_a_file_of_more_bytes_than_the_limit_is_not_read(tmp_path, name, most):
    """1 GB without a line's end; a hole in a file takes no space."""
    with (tmp_path / name).open("wb") as file:
        file.truncate(1 << 30)
    code, said = run_bounded("build", tmp_path / name, "-o", tmp_path / "out.fxls")
    assert code == 2 and f"the limit of {most:,}" in said


def test_an_image_of_more_bytes_than_the_limit_is_not_flashed(tmp_path):
    file = tmp_path / "scene.fxls"
    making.build(str(CHECKOUT / "scenes/tiny.toml"), str(file))
    with file.open("r+b") as image:
        image.truncate(8 << 30)
    with pytest.raises(ToolError, match="the limit of"):
        flash_memory.read_scene(file)


def waves(cells):
    """A square of triangles of which no two lie in one plane."""
    return grid(cells, lambda x, y: math.sin(x * 0.1) * math.cos(y * 0.13) * 3)


def test_many_triangles_of_gltf_with_an_image(tmp_path):
    points, triangles = waves(90)
    noise = png([[((x * 79 + y * 104) % 256, (x * 31 + y * 17) % 256, (x * x + y) % 256) for x in range(64)] for y in range(64)])
    file = tmp_path / "scene.glb"
    file.write_bytes(glb(*gltf(points, triangles, uvs=[(x / 90, y / 90) for x, y, _ in points], image=noise)))
    assert_built(tmp_path, file)


def test_many_faces_with_images(tmp_path):
    points, triangles = waves(63)
    noise = png([[((x * 79 + y * 104) % 256, (x * 31 + y * 17) % 256, (x * x + y) % 256) for x in range(256)] for y in range(256)])
    (tmp_path / "m.glb").write_bytes(glb(*gltf(points, triangles, uvs=[(x / 63, y / 63) for x, y, _ in points], image=noise)))
    (tmp_path / "scene.toml").write_text('[[objects]]\nmodel = "m.glb"\nfit = 9\nimages = { size = 256, colours = 255, levels = 9 }\n')
    code, said = run_bounded("build", tmp_path / "scene.toml", "-o", tmp_path / "out.fxls")
    assert code == 0, said[-2000:]


def test_many_nodes_of_gltf(tmp_path):
    data, blob = gltf(*TETRAHEDRON, nodes=[{"mesh": 0, "translation": [i, i % 7, 0]} for i in range(4096)])
    data["scenes"][0]["nodes"] = list(range(4096))
    (tmp_path / "scene.glb").write_bytes(glb(data, blob))
    assert_built(tmp_path, tmp_path / "scene.glb")


def test_many_triangles_of_stl(tmp_path):
    (tmp_path / "scene.stl").write_bytes(stl(*waves(180)))
    assert_built(tmp_path, tmp_path / "scene.stl")


GLTF = {
    "image": (glb(*gltf(uvs=[(0, 0)] * 4, image=big_png(60_000, 60_000))), ["image 0", "both sides must be"]),
    "nodes": (glb(*gltf(nodes=[{}] * 66_000)), ["66,000", "65,535"]),
    "deep nodes": (glb(*gltf(nodes=[{"children": [i + 1]} for i in range(2000)] + [{"mesh": 0}])), ["1,000 nodes deep"]),
    "JSON": (b'{"asset": {"version": "2.0"}, "x": "' + b"x" * 9_000_000 + b'"}', ["no face"]),
    "nested": (b'{"asset": ' + b"[" * 500_000, ["nested"]),
}


@pytest.mark.parametrize("kind", GLTF)
def test_gltf_files_beyond_a_limit(tmp_path, kind):
    data, words = GLTF[kind]
    (tmp_path / "scene.glb").write_bytes(data)
    if kind == "image":     # not read: its faces have the colour of their material
        assert_noted(tmp_path, tmp_path / "scene.glb", *words)
    else:
        assert_refused(tmp_path, tmp_path / "scene.glb", *words)


@pytest.mark.parametrize("suffix", ["obj", "glb", "stl", "toml", "fxls"])
@pytest.mark.parametrize("kind", ["FIFO", "device", "folder"])
def test_files_that_are_not_regular(tmp_path, suffix, kind):
    file = tmp_path / f"scene.{suffix}"
    {"FIFO": lambda: os.mkfifo(file), "device": lambda: file.symlink_to("/dev/zero"), "folder": file.mkdir}[kind]()
    verb = ["info", file] if suffix == "fxls" else ["build", file, "-o", tmp_path / "out.fxls"]
    code, said = run_bounded(*verb)
    assert code == 2 and f"is a {kind}; give a regular file" in said


@pytest.mark.parametrize("name, text", [
    ("scene.toml", '[[textures]]\nname = "t"\nfile = "it.png"\n[[objects]]\nsolid = "box"\ntexture = "t"\n'),
    ("scene.toml", '[[billboards]]\nname = "b"\nfile = "it.png"\nsize = [1, 1]\n[[objects]]\nbillboard = "b"\n'),
    ("scene.toml", '[[objects]]\nmodel = "it.glb"\n'),
    ("scene.obj", "mtllib it.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"),
    ("scene.obj", "mtllib sound.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nf 1/1 2/1 3/1\n")],
    ids=["texture", "billboard", "model", "materials", "material's picture"])
def test_files_of_a_file_that_are_not_regular(tmp_path, name, text):
    (tmp_path / "sound.mtl").write_text("newmtl a\nmap_Kd it.png\n")
    for suffix in ("png", "glb", "mtl"):
        os.mkfifo(tmp_path / f"it.{suffix}")
    (tmp_path / name).write_text(text)
    if "sound" in text:     # a picture that cannot be read is left out, unless a scene asks for it
        assert_noted(tmp_path, tmp_path / name, "sound.mtl:2", "is a FIFO; give a regular file")
        (tmp_path / "scene.toml").write_text('[[objects]]\nmodel = "scene.obj"\nimages = true\n')
        (tmp_path / "out.fxls").unlink()
        assert_refused(tmp_path, tmp_path / "scene.toml", "no material with an image that can be read", "is a FIFO")
    else:
        assert_refused(tmp_path, tmp_path / name, "is a FIFO; give a regular file")


def test_an_image_of_65535_models_that_share_faces(tmp_path):
    model = image.Model(SQUARE, [image.Face((0, 1 << 30, 0), (0, 1, 2, 3), 1)] * 1000)
    made = image.SceneImage(320, 240, 1 << 30, 65536, 64 << 16, 0, 0, [(0, 0, 0)] * 256, [model],
                            [image.Object((0, 0, 0), 0)], image.POSES, [(0,) * 6])
    blob = image.pack(made)
    offset, _ = section(blob, "models")
    file = tmp_path / "shared.fxls"
    file.write_bytes(replaced(blob, models=blob[offset:offset + 28] * 65_535))
    code, said = run_bounded("info", file)
    assert code == 2 and "model 1 does not begin where the one before it ends" in said


BDF_HEAD = "STARTFONT 2.1\nFONTBOUNDINGBOX 8 8 0 -2\nFONT_ASCENT 6\nFONT_DESCENT 2\n"
BDF_GLYPH = "STARTCHAR a\nENCODING {}\nDWIDTH 8 0\nBBX 8 2 0 0\nBITMAP\nFF\n81\nENDCHAR\n"


@pytest.mark.parametrize("text, code, words", [
    ("".join(BDF_GLYPH.format(300 + i) for i in range(30_000)) + BDF_GLYPH.format(65), 0, "1 characters"),
    ("COMMENT " + "x" * 2_000_000 + "\n" + BDF_GLYPH.format(65), 0, "1 characters"),
    ("\n" * 2_000_000 + BDF_GLYPH.format(65), 0, "1 characters"),
    (BDF_GLYPH.format(65).replace("FF", "F" * 2_000_000), 2, "hexadecimal"),
    (BDF_GLYPH.format("6" * 2_000_000), 2, "ENCODING must have 1 whole number"),
    ("STARTCHAR a\n" * 200_000, 2, "does not end"),
    (BDF_GLYPH.format(65) * 30_000, 2, "a second time")],
    ids=["characters", "line", "empty lines", "row", "digits", "beginnings", "one character"])
def test_fonts_of_any_size(tmp_path, text, code, words):
    file, out = tmp_path / "font.bdf", tmp_path / "font.h"
    file.write_text(BDF_HEAD + text + "ENDFONT\n")
    found, said = run_bounded("font", file, "-o", out)
    assert found == code and words in said and len(said) < 500 + len(str(out)), said[-900:]
    assert out.exists() == (code == 0)


def test_a_font_beyond_the_limit_or_no_file(tmp_path):
    file, fifo = tmp_path / "font.bdf", tmp_path / "fifo.bdf"
    with file.open("w") as big:
        big.truncate((16 << 20) + 1)
    os.mkfifo(fifo)
    for path, words in ((file, "limit of 16,777,216"), (fifo, "is a FIFO"), ("/dev/zero", "is a device")):
        code, said = run_bounded("font", path, "-o", tmp_path / "font.h")
        assert code == 2 and words in said and not (tmp_path / "font.h").exists()
