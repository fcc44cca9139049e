# SPDX-License-Identifier: MIT
"""Fuzzes what the scene tool reads: whatever stands in a file, the answer is a scene that the loader takes, or one
ToolError with a short message. The seed is fixed; FUZZ_EXAMPLES (make fuzz) asks for more examples, by another
seed."""

import copy
import io
import json
import os
import pathlib
import tempfile

from hypothesis import given, strategies as st
from PIL import Image

from conftest import CHECKOUT
from fuzzing import fuzzed, short_refusals
from fixel.image import image
from fixel.model import texture_image
from fixel.scene import compiler, keys, toml_scene
from fixel.scene.toml_table import Several, Sub, inline
from model_files import glb, gltf, png, stl, stl_text
from test_checkers import mutant
from test_ply import binary as ply_binary, text as ply_text

BUILT_PROGRAMS = ()


def check(name, data, *beside, layers=None):
    """Compiles a file of these bytes, or reads it as an image. beside: (name, bytes) of other files of its folder.
    layers: those that are to have a tree."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / name
        for other, content in ((name, data), *beside):
            (pathlib.Path(folder) / os.path.normpath(other)).write_bytes(content)
        with short_refusals(folder) as notes:
            if file.suffix == ".fxls":
                image.unpack(image.pack(image.load(file)))
            else:
                compiled, more = compiler.compile_scene(str(file), layers=layers)
                notes += more
                image.unpack(image.pack(compiled))


# --- OBJ ---------------------------------------------------------------------------

NUMBERS = st.sampled_from(["0", "1", "-1", "2.5", "1e9", "1e-9", "-1e308", "1e1000000", "1e-9999999999", "nan", "inf",
                           "9" * 50, "9" * 5000, "1_0", "٣", ".", "-", "+", "0x10", "1/2", "\x1b", ""])
INDICES = st.one_of(st.integers(-9, 9).map(str), st.sampled_from(["1/1", "1//1", "2/1/1", "/", "//", "1/", "9" * 5000]))
WORDS = st.sampled_from(["v", "vt", "vn", "f", "g", "l", "lod", "usemtl", "#", "\\", "x", "\ufeff", "\0", "F", "v\\"])
SOUND = "v -1 0 0\nv 1 0 0\nv 1 2 0\nv -1 2 0\nv 0 1 3\nvt 0 0\nvn 0 0 1\n"


@st.composite
def obj_files(draw):
    """Lines of an OBJ file after sound ones. The first that is wrong ends the reading, so there are few."""
    line = st.one_of(
        st.builds(lambda number, rest: f"v {number} {rest}", NUMBERS, st.sampled_from(["0 0", "1 2 3", "1", ""])),
        st.builds(lambda numbers: "f " + " ".join(map(str, numbers)), st.lists(st.integers(1, 5), min_size=3, max_size=30)),
        st.builds(lambda parts: "f " + " ".join(parts), st.lists(INDICES, min_size=1, max_size=6)),
        st.builds(lambda word, rest: f"{word} {rest}", WORDS, st.text(max_size=9)))
    text = SOUND + draw(st.sampled_from(["\n", "\r\n", "\\\n", " \\\n", "\r"])).join(draw(st.lists(line, max_size=3)))
    return text.encode("utf-8", "replace")


@fuzzed(0.07)
@given(obj_files())
def test_any_obj_file(data):
    check("model.obj", data)


# --- glTF, STL, MTL, images --------------------------------------------------------

GLTF = gltf(uvs=[(0, 0), (1, 0), (1, 1), (0, 1)], colours=[(9, 99, 199, 255)] * 4, material={"baseColorFactor": [1, 0.5, 0, 1]},
            image=png([[(1, 2, 3), (40, 50, 60)]]), nodes=[{"children": [1], "scale": [1, 2, 3]}, {"mesh": 0, "matrix": [
                1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]}])
# Corners, colours of vertices and of faces, texture coordinates.
PLY_TEXT = ply_text(vertex=(("uchar red", "uchar green", "uchar blue", "float u", "float v"), [(1, 2, 3, 0.5, 1)] * 4),
                    face=(("float red", "float green", "float blue"), [(0.5, 0.25, 1)] * 4))
PLY_BINARY = ply_binary()
JSON = st.recursive(st.one_of(st.none(), st.booleans(), st.integers(-3, 9), st.floats(), st.sampled_from([
    1 << 31, 1 << 70, 1e300, "", "x", "VEC3", "SCALAR", "OPAQUE", "BLEND", "data:,", "data:;base64,AAAA", "/dev/zero", "../x", "\0",
    5120, 5121, 5123, 5125, 5126])), lambda inner: st.one_of(st.lists(inner, max_size=4), st.dictionaries(
        st.sampled_from(["mesh", "children", "uri", "index", "source", "bufferView", "POSITION", "TEXCOORD_0"]), inner, max_size=3)),
    max_leaves=5)


def places_of(value, before=()):
    """The paths of keys to all values below one."""
    below = enumerate(value) if isinstance(value, list) else value.items() if isinstance(value, dict) else ()
    return [before] * bool(before) + [path for key, each in below for path in places_of(each, (*before, key))]


@st.composite
def gltf_files(draw):
    """A sound file in which up to three values are others, or gone."""
    data, blob = copy.deepcopy(GLTF[0]), GLTF[1]
    for _ in range(draw(st.sampled_from([1, 1, 2, 3]))):
        *way, last = draw(st.sampled_from(places_of(data)[::-1]))
        place = data
        for key in way:
            place = place[key]
        change = draw(st.sampled_from(["near", "near", "gone", "other"]))
        if change == "near" and isinstance(place[last], (int, float)):
            place[last] = draw(st.floats(-9, 9) if isinstance(place, list) else st.integers(0, 3))
        elif change == "gone" and isinstance(place, dict):
            del place[last]
        else:
            place[last] = draw(JSON)
    return glb(data, blob)


@fuzzed(0.035)
@given(gltf_files())
def test_any_gltf_file(data):
    check("model.glb", data)


@fuzzed(0.03)
@given(gltf_files(), st.sampled_from(["images = true", "images = { size = 2, levels = 3 }",
                                      "images = { size = 1, bits = 4, levels = 2 }", "images = { bits = 16 }", "merge = true\nmend = true\nfit = 3"]))
def test_any_gltf_file_in_a_scene(data, keys):
    view = '[view]\npixels = "rgb565"\n' if "bits = 16" in keys else ""
    check("scene.toml", f'{view}[[objects]]\nmodel = "model.glb"\n{keys}\n'.encode(), ("model.glb", data))


@fuzzed(0.015)
@given(st.sampled_from([glb(*GLTF), stl(), stl_text(), PLY_BINARY, PLY_TEXT]), st.randoms(use_true_random=False), st.integers(1, 5),
       st.integers(0, 60))
def test_models_with_other_bytes(data, chance, changes, cut):
    blob = bytearray(data[:len(data) - cut])
    for _ in range(changes):
        blob[chance.randrange(len(blob))] = chance.randrange(256)
    check("model.glb" if data[:4] == b"glTF" else "model.ply" if data[:3] == b"ply" else "model.stl", bytes(blob))


MTL_WORDS = st.sampled_from(["newmtl a", "newmtl b", "Kd", "Kd 1", "Kd 0.1 0.2 0.3", "Kd nan 0 0", "Kd spectral x", "map_Kd a.png",
                             "map_Kd -s 1 1 1 a.png", "map_Kd /dev/zero", "map_Kd", "d 0.5", "d -halo 0.5", "d x", "Tr 0.1", "#", "Ks 1"])


@fuzzed(0.08)
@given(st.lists(MTL_WORDS, max_size=6), st.one_of(st.none(), st.binary(max_size=90), st.just(png([[(1, 2, 3)]]))))
def test_any_materials(lines, picture):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder)
        (file / "m.mtl").write_text("\n".join(lines))
        if picture is not None:
            (file / "a.png").write_bytes(picture)
        (file / "m.obj").write_text("mtllib m.mtl\nusemtl a\n" + SOUND + "f 1/1 2/1 3/1\n")
        with short_refusals(folder) as notes:
            notes += compiler.compile_scene(str(file / "m.obj"), None)[1]


# --- names of files ----------------------------------------------------------------

# What stands before the suffix. A name may be as long as a path, have a file system's 255 bytes, and control a terminal.
NAMES = st.one_of(
    st.sampled_from(["m", "./" * 1900 + "m", "x" * 240, "\x1b[31mm", "\x1b" * 200, "a b", "\x7f", '"', "ü", "\u202e", "a\\b"]),
    st.text(st.characters(exclude_categories=["Cs"], exclude_characters="/\0"), min_size=1, max_size=50))


def _named(kind, name, sound):
    """(scene, bytes, files beside it) of a scene or a model that names a file, which is sound or not."""
    damaged = b"xyz\n"
    model, text = (SOUND + "v 9 9 9\nf 1 2 3 4\n").encode(), json.dumps(name, ensure_ascii=False).replace("\x7f", "\\u007f")
    if kind in ("obj", "glb", "stl"):
        content = {"obj": model, "glb": glb(*GLTF), "stl": stl()}[kind]
        return "scene.toml", f"[[objects]]\nmodel = {text}\nfit = 3\n".encode(), [(name, content if sound else damaged)]
    if kind == "mtl":
        return "scene.obj", f"mtllib {name}\nusemtl a\n".encode() + model, [(name, b"newmtl a\nKd 1 0 0\n" if sound else b"Kd 1\n")]
    if kind == "png":
        return "scene.obj", b"mtllib m.mtl\nusemtl a\n" + model, [("m.mtl", f"newmtl a\nmap_Kd {name}\n".encode()),
                                                                  (name, png([[(1, 2, 3)]]) if sound else damaged)]
    data, blob = GLTF
    data = {**data, "buffers": [{**data["buffers"][0], "uri": name}]}
    return "scene.gltf", json.dumps(data).encode(), [(name, blob if sound else damaged)]


@fuzzed(0.1)
@given(st.sampled_from(["obj", "glb", "stl", "mtl", "png", "bin"]), NAMES, st.booleans())
def test_any_name_of_a_file(kind, stem, sound):
    scene, data, beside = _named(kind, f"{stem}.{kind}", sound)
    check(scene, data, *beside)


@fuzzed(0.1)
@given(st.sampled_from([("obj", (SOUND + "f 1 2 3 4\n").encode()), ("obj", b"xyz\n"), ("stl", stl()), ("glb", glb(*GLTF)),
                        ("toml", b'[[objects]]\nsolid = "box"\n'), ("toml", b"[[objects]]\n")]), NAMES)
def test_any_name_of_a_scene(kind, stem):
    check(f"{os.path.basename(stem)}.{kind[0]}", kind[1])


# --- TOML --------------------------------------------------------------------------

TABLES_OF_KEYS = [table for name, table in vars(keys).items() if isinstance(table, dict) and name.isupper()]
EVERY_KEY = sorted({name for table in TABLES_OF_KEYS for name in table})


SCALARS = st.sampled_from([
    "0", "1", "-1", "3", "64", "255", "1000", "1000001", "0.5", "-0.25", "1e9", "1e30", "1e31", "1e-31", "1e999999999",
    "1e-99999999999999999999", "nan", "inf", "-inf", "0x" + "f" * 5000, "9" * 5000, "1979-05-27", "true", "false",
    '""', '"1/3"', '"1/0"', '"box"', '"floor"', '"sphere"', '"red"', '"#fff"', '"3/512 turn"', '"origin"', '"convex"',
    '"open"', '"model.obj"', '"/dev/zero"', '"\\u0000"', '"\\u001b[31m"', '"forward"', '"smooth"',
    '"t"', '"b"', '"t.png"', '"bricks"', '"tree"', '"planar"', '"repeat"', '"half"', '"depth"', '"circle"', "[32, 32]", "[4, 4096]",
    '"' + "x" * 5000 + '"', "[1, 2, 3]", "[0, 0, 0]", "[1, 0, 0]", "[20, 20]", "[1000, 1000, 1000]", "[]", "{}", "[[]]"])
KEYS = st.sampled_from(EVERY_KEY)
VALUES = st.recursive(SCALARS, lambda inner: st.one_of(
    st.lists(inner, max_size=4).map(lambda items: "[" + ", ".join(items) + "]"),
    st.dictionaries(KEYS, inner, max_size=4).map(
        lambda pairs: "{" + ", ".join(f"{key} = {value}" for key, value in pairs.items()) + "}")), max_leaves=8)
# Values that keys take by their kinds (keys.py), small ones, and those in which one part must suit another or a name is that of something.
# place key: only if the fuzzer must know a name or parts that suit one another
SAID = {
    "name": ['"a"', '"the car"'], "texture": ['"t"'], "billboard": ['"b"'], "parent": ['"car"'], "file": ['"t.png"'],
    "obj": ['"t.obj"'], "model": ['"t.obj"'], "group": ['"g"', '"t"'], "without": ['"g"', '["t"]'], "tree": ['"all"', '"0"'],
    "spin": ["{ yaw = 3 }", "{ axis = [1, 1, 0], degrees = 2 }"], "fog": ["{ near = 2, far = 9 }"],
    "motion": ["{ circle = 3, degrees = 4 }", "{ by = [1, 0, 0], frames = 9, back = true }", "{ keys = [{ frames = 2 }, { turn = 9 }] }"],
    "keys": ["[{ position = [0, 0, 0] }, { position = [1, 0, 0], frames = 3 }]", "[{ frames = 3 }, {}]", '["forward"]'],
    "steps": ['[{ keys = ["forward"], frames = 9 }]'], "orbit": ["{ radius = 4 }"], "start": ["30", "{ position = [0, 1, 0] }"],
    "parts": ["[2, 1]"], "textures": ['["t", ""]']}
SOUND_VALUES = {name: SAID.get(name) or sorted({inline(value) for table in TABLES_OF_KEYS if name in table
                                                for value in table[name].kind.sound()}) for name in EVERY_KEY}


ODDS = [True] * 7 + [False]     # of a sound value


@st.composite
def tables(draw, keys, most=4):
    """Keys of a table with values, most of them sound ones."""
    chosen = draw(st.lists(st.sampled_from(sorted(keys)), unique=True, max_size=most))
    return {key: draw(st.sampled_from(SOUND_VALUES[key]) if key in SOUND_VALUES and draw(st.sampled_from(ODDS)) else VALUES)
            for key in chosen}


def headings(table, before=""):
    """The headings of tables in a table."""
    for name, key in table.items():
        rows = key.kind.kind if isinstance(key.kind, Several) else None
        inner = rows if isinstance(rows, Sub) else key.kind if isinstance(key.kind, Sub) else getattr(key.kind, "other", None)
        if isinstance(inner, Sub):
            yield f"[[{before}{name}]]" if rows else f"[{before}{name}]"
            yield from headings(inner.keys, f"{before}{name}.")


HEADINGS = ["[[objects]]", *headings(keys.TOP), *headings(keys.OBJECT, "objects.")]
TABLES = st.sampled_from(HEADINGS)


def test_every_key_has_sound_values_and_every_table_its_heading():
    assert set(SAID) <= set(EVERY_KEY) and all(SOUND_VALUES.values()) and "[2, 9]" in SOUND_VALUES["cells"]
    assert {"[screen]", "[[beams]]", "[path.orbit]", "[[path.keys]]", "[objects.ring]", "[[objects.motion.keys]]", "[[light.points]]",
            "[light.fog]", "[objects.images]"} <= set(HEADINGS)


KNOWN = st.sampled_from([
    '[[objects]]\nsolid = "box"\n', '[[objects]]\nsolid = "floor"\ncells = [3, 3]\n', "[path]\nkeys = [{ position = [0, 0, 0] }]\n",
    "[path]\norbit = { radius = 4 }\n", '[path]\nsteps = [{ keys = ["forward"], frames = 9 }]\n',
    "[[beams]]\ndirection = [1, -1, 0]\nwindow = [[0, 0, 0], [0, 1, 0], [0, 1, 1]]\n",
    '[[textures]]\nname = "t"\npattern = "bricks"\nsize = [8, 8]\n[[objects]]\nsolid = "box"\ntexture = "t"\n',
    '[[textures]]\nname = "t"\nfile = "t.png"\n[[objects]]\nsolid = "box"\ntexture = "t"\n',
    '[[billboards]]\nname = "b"\npattern = "tree"\npixels = [8, 8]\nsize = [1, 1]\n[[objects]]\nbillboard = "b"\n',
    '[[billboards]]\nname = "b"\nfile = "t.png"\nsize = [1, 1]\n[[objects]]\nbillboard = "b"\n',
    '[[objects]]\nname = "car"\nsolid = "box"\nspin = { yaw = 5 }\n[[objects]]\nsolid = "box"\nparent = "car"\n',
    '[[objects]]\nsolid = "box"\nmotion = { circle = 3, degrees = 4 }\n',
    '[light]\nlevels = 8\npoints = [{ position = [0, 1, 0], range = 4 }]\nfog = { near = 2, far = 9 }\n[[objects]]\nsolid = "box"\n'])
PICTURE = png([[(1, 2, 3), (40, 50, 60)], [(200, 1, 9), (255, 255, 255)]])


@st.composite
def toml_files(draw):
    """Tables of known keys with any values, after sound ones."""
    lines = []
    for part in draw(st.lists(st.one_of(KNOWN, KNOWN, TABLES), min_size=1, max_size=4, unique_by=lambda part: part.split("\n")[0])):
        lines.append(part)
        lines += [f"{key} = {value}" for key, value in draw(tables(EVERY_KEY, 1)).items()]
    return "\n".join(lines).encode()


@fuzzed(0.035)
@given(toml_files())
def test_any_toml_file(data):
    check("scene.toml", data, ("t.png", PICTURE))


# Tables of what is drawn with: the head, sound pairs of which some are replaced, more keys that it takes, what follows.
BRICKS = '[[textures]]\nname = "t"\npattern = "crate"\nsize = [4, 4]\n'
ROWS = [
    ("[[textures]]\n", {"name": '"t"', "file": '"t.png"'}, ["most_colours", "bits", "wrap", "levels", "size"],
     '[[objects]]\nsolid = "box"\ntexture = "t"\n'),
    ("[[textures]]\n", {"name": '"t"', "pattern": '"bricks"', "size": "[8, 8]"}, ["colours", "bits", "wrap", "levels", "file"],
     '[[objects]]\nsolid = "box"\ntexture = "t"\n'),
    ("[[billboards]]\n", {"name": '"b"', "file": '"t.png"', "size": "[1, 1]"}, ["most_colours", "bits", "key", "anchor", "pixels"],
     '[[objects]]\nbillboard = "b"\nposition = [0, 0, 5]\n'),
    ('[[objects]]\nsolid = "box"\n[objects.spin]\n', {"yaw": "5"}, ["pitch", "roll", "start"], ""),
    ('[[objects]]\nsolid = "box"\n[objects.spin]\n', {"axis": "[1, 2, 3]", "degrees": "2"}, ["start", "roll"], ""),
    ('[[objects]]\nsolid = "box"\n[objects.motion]\n', {"circle": "4", "degrees": "5"}, ["start", "facing", "back"], ""),
    ('[[objects]]\nsolid = "box"\n[objects.motion]\n', {"by": "[1, 0, 0]", "frames": "9"}, ["back", "repeats", "facing"], ""),
    ('[[objects]]\nsolid = "box"\n[objects.motion]\n', {"keys": "[{ turn = 9 }, {}]"}, ["repeats", "start"], ""),
    ("[light]\n", {"levels": "8"}, sorted({*keys.LIGHT} - {"colour", "sky"}), '[[objects]]\nsolid = "box"\n'),
    ("[light]\n", {}, ["colour", "sky", "direction", "ambient"], '[[objects]]\nsolid = "box"\n'),
    (BRICKS + '[[objects]]\nsolid = "box"\n', {"texture": '"t"'}, sorted({*keys.SURFACE, *keys.TURNED} - {"parent"}), "")]


@fuzzed(0.13)
@given(st.sampled_from(ROWS), st.data())
def test_any_table_of_what_is_drawn_with(row, data):
    table, pairs, more, after = row
    pairs = {**pairs, **data.draw(tables([*pairs, *more], 3))}
    text = table + "".join(f"{key} = {value}\n" for key, value in pairs.items()) + after
    check("scene.toml", text.encode(), ("t.png", PICTURE))


def _pictures():
    """A small picture in each format that is read, and one that is not."""
    found = [PICTURE]
    for name in (*texture_image.FORMATS, "DDS"):
        file = io.BytesIO()
        try:
            Image.new("RGB", (4, 4), (9, 99, 199)).save(file, name)
        except (KeyError, OSError):
            continue    # Pillow writes no such file
        found.append(file.getvalue())
    return found


@fuzzed(0.1)
@given(st.sampled_from(_pictures()), st.randoms(use_true_random=False), st.integers(0, 6),
       st.one_of(st.just(0), st.integers(0, 60)), st.sampled_from(["textures", "billboards"]))
def test_any_picture(picture, chance, changes, cut, table):
    blob = bytearray(picture[:max(1, len(picture) - cut)])
    for _ in range(changes):
        blob[chance.randrange(len(blob))] = chance.randrange(256)
    name = table[0]
    use = 'solid = "box"\ntexture = "t"' if table == "textures" else 'billboard = "b"'
    size = "size = [1, 1]\n" if table == "billboards" else ""
    check("scene.toml", f'[[{table}]]\nname = "{name}"\nfile = "t.png"\n{size}[[objects]]\n{use}\n'.encode(),
          ("t.png", bytes(blob)))


OF_A_SOLID = {*keys.OBJECT} - {*keys.MODEL, *keys.SOLID, "colour", "parent", "textures"}


@fuzzed(0.1)
@given(st.one_of(tables(OF_A_SOLID, 3), tables(keys.OBJECT)), st.sampled_from([{}, {"texture": '"t"'}, {"colour_index": "5"}]))
def test_any_object(pairs, more):
    text = "".join(f"{key} = {value}\n" for key, value in {"solid": '"box"', **more, **pairs}.items())
    check("scene.toml", f"{BRICKS}[[objects]]\n{text}[path]\nkeys = [{{ position = [0, 0, 0] }}]\n".encode())


CUTS = ["position", "rotation", "scale", "layer", "kind", "moves", "ring", "inside", "two_sided"]


@fuzzed(0.25)
@given(st.lists(st.tuples(st.sampled_from(["box", "pyramid", "floor", "octahedron"]), tables(CUTS, 3)), min_size=1, max_size=4),
       st.sampled_from(["all", "most", "0", "0,7", "7"]))
def test_any_tree(objects, layers):
    """Solids on one another, cut by planes."""
    text = "".join(f'[[objects]]\nsolid = "{solid}"\n' + "".join(f"{key} = {value}\n" for key, value in pairs.items())
                   for solid, pairs in objects)
    check("scene.toml", f"{text}[path]\nkeys = [{{ position = [0, 0, 0] }}]\n".encode(), layers=layers)


@fuzzed(0.15)
@given(st.sampled_from([("keys", "interpolation"), ("steps", "start"), ("orbit", "start")]), st.data())
def test_any_path(kind, data):
    pairs = {kind[0]: SOUND_VALUES[kind[0]][0], **data.draw(tables([*kind, "gait"]))}
    text = "".join(f"{key} = {value}\n" for key, value in pairs.items())
    check("scene.toml", f'[[objects]]\nsolid = "box"\n[path]\n{text}'.encode())


# --- bytes, and images -------------------------------------------------------------

@fuzzed(0)
@given(st.binary(max_size=400), st.sampled_from(["scene.toml", "model.obj", "model.glb", "model.gltf", "model.stl", "model.ply", "scene.fxls"]))
def test_any_bytes(data, name):
    check(name, data)


@fuzzed(0.25)
@given(st.randoms(use_true_random=False), st.integers(1, 4))
def test_any_image(chance, changes):
    check("scene.fxls", mutant(TINY, chance, changes))


TINY = image.pack(toml_scene.compile_file(str(CHECKOUT / "scenes" / "tiny.toml"))[0])
