# SPDX-License-Identifier: MIT
"""Fuzzes what the scene tool reads: whatever stands in a file, the answer is a scene that the loader takes, or one
ToolError with a short message. The seed is fixed; FUZZ_EXAMPLES (make fuzz) asks for more examples, by another
seed."""

import copy
import io
import os
import pathlib
import re
import tempfile

from hypothesis import HealthCheck, given, seed, settings, strategies as st
from PIL import Image

import scene as scene_tool
from conftest import CHECKOUT
from fixel import image, texture_image, toml_billboard, toml_light, toml_motion, toml_object, toml_scene, toml_texture
from fixel.errors import ToolError
from model_files import glb, gltf, png, stl, stl_text
from test_checkers import mutant

EXAMPLES = int(os.environ.get("FUZZ_EXAMPLES", "150"))
SEED = int(os.environ.get("FUZZ_SEED", "13"))
MESSAGE_MAX = 600       # characters: two quotes, the known keys, the file's name


def fuzzed(test):
    """A test with a fixed number of examples by a fixed seed."""
    quiet = [HealthCheck.too_slow, HealthCheck.data_too_large, HealthCheck.filter_too_much]
    return seed(SEED)(settings(max_examples=EXAMPLES, deadline=None, database=None, derandomize=False,
                               suppress_health_check=quiet)(test))


def check(name, data, *beside):
    """Compiles a file of these bytes, or reads it as an image. beside: (name, bytes) of other files of its folder."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / name
        for other, content in ((name, data), *beside):
            (pathlib.Path(folder) / other).write_bytes(content)
        try:
            if file.suffix == ".fxls":
                image.unpack(image.pack(image.load(file)))
            else:
                image.unpack(image.pack(scene_tool.compile_scene(str(file), 3)[0]))
        except ToolError as error:
            text = str(error).replace(folder, "")
            assert 0 < len(text) <= MESSAGE_MAX and text.isprintable(), text


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


@fuzzed
@given(obj_files())
def test_any_obj_file(data):
    check("model.obj", data)


# --- glTF, STL, MTL, images --------------------------------------------------------

GLTF = gltf(uvs=[(0, 0), (1, 0), (1, 1), (0, 1)], colours=[(9, 99, 199, 255)] * 4, material={"baseColorFactor": [1, 0.5, 0, 1]},
            image=png([[(1, 2, 3), (40, 50, 60)]]), nodes=[{"children": [1], "scale": [1, 2, 3]}, {"mesh": 0, "matrix": [
                1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]}])
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
    """A sound file in which one to three values are others, or gone."""
    data, blob = copy.deepcopy(GLTF[0]), GLTF[1]
    for _ in range(draw(st.integers(1, 3))):
        *way, last = draw(st.sampled_from(places_of(data)))
        place = data
        for key in way:
            place = place[key]
        if draw(st.booleans()) and isinstance(place, dict):
            del place[last]
        else:
            place[last] = draw(JSON)
    return glb(data, blob)


@fuzzed
@given(gltf_files())
def test_any_gltf_file(data):
    check("model.glb", data)


@fuzzed
@given(gltf_files(), st.sampled_from(["images = true", "images = { size = 2, levels = 3 }", "images = { size = 1, bits = 4, levels = 2 }", "merge = true\nmend = true\nfit = 3"]))
def test_any_gltf_file_in_a_scene(data, keys):
    check("scene.toml", f'[[objects]]\nmodel = "model.glb"\n{keys}\n'.encode(), ("model.glb", data))


@fuzzed
@given(st.sampled_from([glb(*GLTF), stl(), stl_text()]), st.randoms(use_true_random=False), st.integers(1, 5),
       st.integers(0, 60))
def test_models_with_other_bytes(data, chance, changes, cut):
    blob = bytearray(data[:len(data) - cut])
    for _ in range(changes):
        blob[chance.randrange(len(blob))] = chance.randrange(256)
    check("model.glb" if data[:4] == b"glTF" else "model.stl", bytes(blob))


MTL_WORDS = st.sampled_from(["newmtl a", "newmtl b", "Kd", "Kd 1", "Kd 0.1 0.2 0.3", "Kd nan 0 0", "Kd spectral x", "map_Kd a.png",
                             "map_Kd -s 1 1 1 a.png", "map_Kd /dev/zero", "map_Kd", "d 0.5", "d -halo 0.5", "d x", "Tr 0.1", "#", "Ks 1"])


@fuzzed
@given(st.lists(MTL_WORDS, max_size=6), st.one_of(st.none(), st.binary(max_size=90), st.just(png([[(1, 2, 3)]]))))
def test_any_materials(lines, picture):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder)
        (file / "m.mtl").write_text("\n".join(lines))
        if picture is not None:
            (file / "a.png").write_bytes(picture)
        (file / "m.obj").write_text("mtllib m.mtl\nusemtl a\n" + SOUND + "f 1/1 2/1 3/1\n")
        try:
            scene_tool.compile_scene(str(file / "m.obj"), 3)
        except ToolError as error:
            text = str(error).replace(folder, "")
            assert 0 < len(text) <= MESSAGE_MAX and text.isprintable(), text


# --- TOML --------------------------------------------------------------------------

def _keys():
    """Every key that a table of a scene may have: the sets of names in what reads scenes, and the names of the sets."""
    found = {"count", "step"}
    for source in sorted((CHECKOUT / "tools" / "fixel").glob("toml_*.py")):
        text = source.read_text(encoding="utf-8")
        found.update(*(re.findall("[a-z_]+", names) for names in re.findall(r"\{((?:\s*\"[a-z_]+\",?)+)", text)))
    return sorted(found)


def test_the_keys_are_those_of_all_that_reads_scenes():
    assert {*toml_object.KEYS, *toml_scene.TOP_KEYS, *toml_texture.KEYS, *toml_motion.KEYS, *toml_light.KEYS,
            *toml_billboard.OBJECT_KEYS, "pattern", "wrap", "key", "anchor", "yaw", "offset", "facing", "fog", "visibility",
            "reserve"} <= set(_keys())


SCALARS = st.sampled_from([
    "0", "1", "-1", "3", "64", "255", "1000", "1000001", "0.5", "-0.25", "1e9", "1e30", "1e31", "1e-31", "1e999999999",
    "1e-99999999999999999999", "nan", "inf", "-inf", "0x" + "f" * 5000, "9" * 5000, "1979-05-27", "true", "false",
    '""', '"1/3"', '"1/0"', '"box"', '"floor"', '"sphere"', '"red"', '"#fff"', '"3/512 turn"', '"origin"', '"convex"',
    '"open"', '"model.obj"', '"/dev/zero"', '"\\u0000"', '"\\u001b[31m"', '"forward"', '"smooth"',
    '"t"', '"b"', '"t.png"', '"bricks"', '"tree"', '"planar"', '"repeat"', '"half"', '"depth"', '"circle"', "[32, 32]", "[4, 4096]",
    '"' + "x" * 5000 + '"', "[1, 2, 3]", "[0, 0, 0]", "[1, 0, 0]", "[20, 20]", "[1000, 1000, 1000]", "[]", "{}", "[[]]"])
KEYS = st.sampled_from(_keys())
VALUES = st.recursive(SCALARS, lambda inner: st.one_of(
    st.lists(inner, max_size=4).map(lambda items: "[" + ", ".join(items) + "]"),
    st.dictionaries(KEYS, inner, max_size=4).map(
        lambda pairs: "{" + ", ".join(f"{key} = {value}" for key, value in pairs.items()) + "}")), max_leaves=8)
TABLES = st.sampled_from(["[screen]", "[view]", "[light]", "[[objects]]", "[path]", "[path.orbit]", "[path.gait]",
                          "[path.start]", "[[beams]]", "[glow]", "[[path.keys]]", "[[path.steps]]", "[objects.ring]",
                          "[objects.repeat]", "[palette]", "[[textures]]", "[[billboards]]", "[objects.spin]", "[objects.motion]",
                          "[[objects.motion.keys]]", "[[light.points]]", "[light.fog]"])
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
    for part in draw(st.lists(st.one_of(KNOWN, TABLES), min_size=1, max_size=6)):
        lines.append(part)
        lines += [f"{key} = {value}" for key, value in draw(st.dictionaries(KEYS, VALUES, max_size=3)).items()]
    return "\n".join(lines).encode()


@fuzzed
@given(toml_files())
def test_any_toml_file(data):
    check("scene.toml", data, ("t.png", PICTURE))


# What a table of each kind must have, and keys that it takes.
ROWS = {
    '[[textures]]\nname = "t"\n': (["file", "pattern", "size", "colours", "most_colours", "bits", "wrap", "levels"],
                                  '[[objects]]\nsolid = "box"\ntexture = "t"\n'),
    '[[billboards]]\nname = "b"\n': (["file", "pattern", "pixels", "colours", "most_colours", "bits", "key", "size", "anchor"],
                                    '[[objects]]\nbillboard = "b"\nposition = [0, 0, 5]\n'),
    '[[objects]]\nsolid = "box"\n[objects.spin]\n': (["axis", "degrees", "start", "yaw", "pitch", "roll"], ""),
    '[[objects]]\nsolid = "box"\n[objects.motion]\n': (["circle", "by", "keys", "degrees", "start", "facing", "frames", "back",
                                                      "repeats"], ""),
    "[light]\n": (sorted(toml_light.KEYS), '[[objects]]\nsolid = "box"\n'),
    '[[textures]]\nname = "t"\npattern = "crate"\nsize = [4, 4]\n[[objects]]\nsolid = "box"\n':
        (sorted(toml_texture.KEYS | toml_motion.KEYS), ""),
}


@fuzzed
@given(st.sampled_from(sorted(ROWS)), st.data())
def test_any_table_of_what_is_drawn_with(table, data):
    keys, after = ROWS[table]
    pairs = data.draw(st.dictionaries(st.sampled_from(keys), VALUES, max_size=4))
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


@fuzzed
@given(st.sampled_from(_pictures()), st.randoms(use_true_random=False), st.integers(0, 6), st.integers(0, 60),
       st.sampled_from(["textures", "billboards"]))
def test_any_picture(picture, chance, changes, cut, table):
    blob = bytearray(picture[:max(1, len(picture) - cut)])
    for _ in range(changes):
        blob[chance.randrange(len(blob))] = chance.randrange(256)
    name = table[0]
    use = 'solid = "box"\ntexture = "t"' if table == "textures" else 'billboard = "b"'
    size = "size = [1, 1]\n" if table == "billboards" else ""
    check("scene.toml", f'[[{table}]]\nname = "{name}"\nfile = "t.png"\n{size}[[objects]]\n{use}\n'.encode(),
          ("t.png", bytes(blob)))


@fuzzed
@given(st.dictionaries(st.sampled_from(sorted(toml_object.KEYS)), VALUES, max_size=4))
def test_any_object(pairs):
    text = "".join(f"{key} = {value}\n" for key, value in {"solid": '"box"', **pairs}.items())
    check("scene.toml", f"[[objects]]\n{text}[path]\nkeys = [{{ position = [0, 0, 0] }}]\n".encode())


@fuzzed
@given(st.dictionaries(st.sampled_from(["keys", "steps", "orbit", "start", "gait", "interpolation"]), VALUES, max_size=3))
def test_any_path(pairs):
    text = "".join(f"{key} = {value}\n" for key, value in pairs.items())
    check("scene.toml", f'[[objects]]\nsolid = "box"\n[path]\n{text}'.encode())


# --- bytes, and images -------------------------------------------------------------

@fuzzed
@given(st.binary(max_size=400), st.sampled_from(["scene.toml", "model.obj", "model.glb", "model.gltf", "model.stl", "scene.fxls"]))
def test_any_bytes(data, name):
    check(name, data)


@fuzzed
@given(st.randoms(use_true_random=False), st.integers(1, 4))
def test_any_image(chance, changes):
    check("scene.fxls", mutant(TINY, chance, changes))


TINY = image.pack(toml_scene.compile_file(str(CHECKOUT / "scenes" / "tiny.toml"))[0])
