# SPDX-License-Identifier: MIT
"""Fuzzes what the scene tool reads: whatever stands in a file, the answer is a scene that the loader takes, or one
ToolError with a short message. The seed is fixed; FUZZ_EXAMPLES (make fuzz) asks for more examples, by another
seed."""

import os
import pathlib
import re
import tempfile

from hypothesis import HealthCheck, given, seed, settings, strategies as st

import scene as scene_tool
from conftest import CHECKOUT
from fixel import image, toml_object, toml_scene
from fixel.errors import ToolError
from test_checkers import mutant

EXAMPLES = int(os.environ.get("FUZZ_EXAMPLES", "150"))
SEED = int(os.environ.get("FUZZ_SEED", "13"))
MESSAGE_MAX = 600       # characters: two quotes, the known keys, the file's name


def fuzzed(test):
    """A test with a fixed number of examples by a fixed seed."""
    quiet = [HealthCheck.too_slow, HealthCheck.data_too_large, HealthCheck.filter_too_much]
    return seed(SEED)(settings(max_examples=EXAMPLES, deadline=None, database=None, derandomize=False,
                               suppress_health_check=quiet)(test))


def check(name, data):
    """Compiles a file of these bytes, or reads it as an image."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / name
        file.write_bytes(data)
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


# --- TOML --------------------------------------------------------------------------

def _keys():
    """Every key that a scene may have."""
    source = (CHECKOUT / "tools" / "fixel" / "toml_scene.py").read_text(encoding="utf-8")
    groups = re.findall(r"\{(\"[a-z_]+\"(?:, \"[a-z_]+\")+)\}", source)
    return sorted({*toml_object.KEYS, *toml_scene.TOP_KEYS, *re.findall("[a-z_]+", " ".join(groups)), "count", "step"})


SCALARS = st.sampled_from([
    "0", "1", "-1", "3", "64", "255", "1000", "1000001", "0.5", "-0.25", "1e9", "1e30", "1e31", "1e-31", "1e999999999",
    "1e-99999999999999999999", "nan", "inf", "-inf", "0x" + "f" * 5000, "9" * 5000, "1979-05-27", "true", "false",
    '""', '"1/3"', '"1/0"', '"box"', '"floor"', '"sphere"', '"red"', '"#fff"', '"3/512 turn"', '"origin"', '"convex"',
    '"open"', '"model.obj"', '"/dev/zero"', '"\\u0000"', '"\\u001b[31m"', '"forward"', '"smooth"',
    '"' + "x" * 5000 + '"', "[1, 2, 3]", "[0, 0, 0]", "[1, 0, 0]", "[20, 20]", "[1000, 1000, 1000]", "[]", "{}", "[[]]"])
KEYS = st.sampled_from(_keys())
VALUES = st.recursive(SCALARS, lambda inner: st.one_of(
    st.lists(inner, max_size=4).map(lambda items: "[" + ", ".join(items) + "]"),
    st.dictionaries(KEYS, inner, max_size=4).map(
        lambda pairs: "{" + ", ".join(f"{key} = {value}" for key, value in pairs.items()) + "}")), max_leaves=8)
TABLES = st.sampled_from(["[screen]", "[view]", "[light]", "[[objects]]", "[path]", "[path.orbit]", "[path.gait]",
                          "[path.start]", "[[beams]]", "[glow]", "[[path.keys]]", "[[path.steps]]", "[objects.ring]",
                          "[objects.repeat]", "[palette]"])
KNOWN = st.sampled_from([
    '[[objects]]\nsolid = "box"\n', '[[objects]]\nsolid = "floor"\ncells = [3, 3]\n', "[path]\nkeys = [{ position = [0, 0, 0] }]\n",
    "[path]\norbit = { radius = 4 }\n", '[path]\nsteps = [{ keys = ["forward"], frames = 9 }]\n',
    "[[beams]]\ndirection = [1, -1, 0]\nwindow = [[0, 0, 0], [0, 1, 0], [0, 1, 1]]\n"])


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
    check("scene.toml", data)


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
@given(st.binary(max_size=400), st.sampled_from(["scene.toml", "model.obj", "scene.fxls"]))
def test_any_bytes(data, name):
    check(name, data)


@fuzzed
@given(st.randoms(use_true_random=False), st.integers(1, 4))
def test_any_image(chance, changes):
    check("scene.fxls", mutant(TINY, chance, changes))


TINY = image.pack(toml_scene.compile_file(str(CHECKOUT / "scenes" / "tiny.toml"))[0])
