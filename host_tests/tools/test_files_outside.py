# SPDX-License-Identifier: MIT
"""Files outside the folder of the file that the user named: refused, and read with --allow-outside."""

import base64
import json
import os
import subprocess
import sys

import pytest
from conftest import LAUNCHER, run_make

from fixel.base import bounded, make
from fixel.base.errors import ToolError
from fixel.scene import making
from model_files import gltf, png, stl

BUILT_PROGRAMS = ()
OBJ = "mtllib {}\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n"
MTL = "newmtl red\nKd 1 0 0\n"
PATH = "[path]\nkeys = [{{ position = [0, 0, -4] }}]\n"
TEXTURE = '[[textures]]\nname = "t"\nfile = "{}"\n[[objects]]\nsolid = "box"\nscale = 1\ntexture = "t"\n' + PATH
BILLBOARD = ('[[billboards]]\nname = "b"\nsize = [1, 1]\nfile = "{}"\n[[objects]]\nbillboard = "b"\nposition = [0, 0, 0]\n' + PATH)


def _gltf(uri, image=None):
    """(text, binary part) of a model whose buffer is at a URI; image: a URI for its image."""
    data, blob = gltf(uvs=[(0, 0), (1, 0), (1, 1), (0, 1)], image=png([[(1, 2, 3)]]))
    data["buffers"][0]["uri"] = uri
    if image:
        data["images"][0] = {"uri": image}
    return json.dumps(data), blob


def _gltf_image(uri):
    """The text of a model that has its buffer, and an image at a URI."""
    return _gltf("data:;base64," + base64.b64encode(_gltf("")[1]).decode(), uri)[0]


SKIN = png([[(1, 2, 3), (4, 5, 6)]] * 2)
# What names a file: the file that the user names, its text with {} for the name, other files beside it, the named file's end
# and bytes.
KINDS = {
    "mtllib": ("m.obj", OBJ.format, lambda name: {}, ".mtl", MTL.encode()),
    "map_Kd": ("m.obj", lambda name: OBJ.format("m.mtl"), lambda name: {"m.mtl": MTL + f"map_Kd {name}\n"}, ".png", SKIN),
    "buffer": ("m.gltf", lambda name: _gltf(name)[0], lambda name: {}, ".bin", _gltf("")[1]),
    "image": ("m.gltf", _gltf_image, lambda name: {}, ".png", SKIN),
    "model": ("s.toml", ('[[objects]]\nmodel = "{}"\n' + PATH).format, lambda name: {}, ".stl", stl()),
    "obj": ("s.toml", ('[[objects]]\nobj = "{}"\n' + PATH).format, lambda name: {}, ".obj", OBJ.replace("mtllib {}\n", "").encode()),
    "texture": ("s.toml", TEXTURE.format, lambda name: {}, ".png", SKIN),
    "billboard": ("s.toml", BILLBOARD.format, lambda name: {}, ".png", SKIN),
}


def place(tmp_path, kind, way):
    """The files of a kind, its file outside; the path of the file that the user names."""
    named, text, beside, end, data = KINDS[kind]
    inside, outside = tmp_path / "inside", tmp_path / "outside"
    for folder in (inside, outside):
        folder.mkdir()
    target = (outside if way != "below" else inside) / f"secret{end}"
    target.write_bytes(data)
    name = {"link": f"link{end}", "folder link": f"down/secret{end}", "dots": f"../outside/secret{end}", "absolute": str(target),
            "below": f"secret{end}"}[way]
    if way == "link":
        (inside / name).symlink_to(target)
    if way == "folder link":
        (inside / "down").symlink_to(outside)
    for other, words in beside(name).items():
        (inside / other).write_text(words)
    (inside / named).write_text(text(name))
    return inside / named


@pytest.mark.parametrize("way", ["link", "folder link", "dots", "absolute"])
@pytest.mark.parametrize("kind", KINDS)
def test_a_file_outside_is_refused_and_allowed(tmp_path, kind, way):
    named, out = place(tmp_path, kind, way), tmp_path / "out.fxls"
    with pytest.raises(ToolError) as caught:
        making.build(named, out, frames=None)
    assert {"link": "link.", "folder link": "down/secret."}.get(way, "secret.") in str(caught.value)
    assert f"is outside {named.parent}, the folder of {named}" in str(caught.value)
    assert "--allow-outside" in str(caught.value) and not out.exists()
    assert making.build(named, out, frames=None, limits=bounded.Limits(outside=True)).size == out.stat().st_size


@pytest.mark.parametrize("kind", KINDS)
def test_a_file_of_the_folder_is_read(tmp_path, kind):
    assert making.build(place(tmp_path, kind, "below"), tmp_path / "out.fxls").size


def test_a_model_below_names_files_of_the_scene_s_folder(tmp_path):
    (tmp_path / "models").mkdir()
    (tmp_path / "m.mtl").write_text(MTL)
    (tmp_path / "models" / "m.obj").write_text(OBJ.format("../m.mtl"))
    (tmp_path / "s.toml").write_text(('[[objects]]\nmodel = "{}"\n' + PATH).format("models/m.obj"))
    made = making.build(tmp_path / "s.toml", tmp_path / "out.fxls")
    assert not any("no \"../m.mtl\"" in note for note in made.notes)
    with pytest.raises(ToolError, match="is outside"):
        making.build(tmp_path / "models" / "m.obj", tmp_path / "out.fxls")


def test_the_named_file_may_be_a_link(tmp_path):
    place(tmp_path, "model", "below")
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "m.stl").symlink_to(tmp_path / "inside" / "secret.stl")
    assert making.build(tmp_path / "other" / "m.stl", tmp_path / "out.fxls").size
    (tmp_path / "way").symlink_to(tmp_path / "inside")      # the folder may be named by a link, too
    assert making.build(tmp_path / "way" / "s.toml", tmp_path / "out.fxls").size


@pytest.mark.parametrize("command", [["build"], ["export", "--c"]])
def test_the_option_of_the_commands(tmp_path, command):
    named = place(tmp_path, "model", "dots")
    words = [sys.executable, LAUNCHER, *command, named.name, "-o", tmp_path / "out"]
    refused = subprocess.run(words, cwd=named.parent, capture_output=True, text=True, check=False)
    assert refused.returncode == 2 and "is outside ., the folder of s.toml" in refused.stderr, refused.stderr
    assert not os.path.exists(tmp_path / "out")
    subprocess.run([*words, "--allow-outside"], cwd=named.parent, capture_output=True, check=True)


@pytest.mark.parametrize("command", ["run", "view", "flash", "predict", "report", "wire", "screen"])
def test_each_command_that_compiles_has_the_option(command):
    said = subprocess.run([sys.executable, LAUNCHER, command, "--help"], capture_output=True, text=True, check=True).stdout
    assert "--allow-outside" in said


def test_each_command_of_make_that_takes_a_scene_has_the_variables():
    taking = [command for command, names in make.variables().items() if "SCENE" in names]
    assert "run" in taking
    for command in taking:
        given = {"ALLOW_OUTSIDE": "1", "CPU_LIMIT": "9", "MEMORY_LIMIT": "300"}
        assert sorted(make.options(command, given)) == ["--allow-outside", "--cpu-limit=9", "--memory-limit=300"], command


def test_make_draws_a_scene_with_files_outside(tmp_path):
    words = ["wire", f"SCENE={place(tmp_path, 'model', 'dots')}", f"OUT={tmp_path / 'out'}", "FRAMES=1"]
    refused = run_make(*words)
    assert refused.returncode and "--allow-outside" in refused.stderr, refused.stderr
    assert "--cpu-limit is '0'" in run_make(*words, "CPU_LIMIT=0").stderr
    done = run_make(*words, "ALLOW_OUTSIDE=1")
    assert done.returncode == 0 and (tmp_path / "out/frame_0000.png").exists(), done.stderr
