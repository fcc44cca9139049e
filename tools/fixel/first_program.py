# SPDX-License-Identifier: MIT
"""The first program (examples/cube) and the other examples of its scene, drawn on this machine."""

import os
import pathlib

import numpy

from fixel import c_scene, children, framing, scratch
from fixel.errors import ToolError

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODEL = ROOT / "examples" / "cube" / "cube.obj"
PROGRAM = ROOT / "examples" / "cube" / "main.c"
CROWD = ROOT / "examples" / "crowd" / "main.c"
FRAME = ROOT / "host_tests" / "examples" / "frame.c"
WIDTH, HEIGHT = 320, 240


def write_scene(folder):
    """Writes cube_scene.h into a folder; answers the scene."""
    scene, _ = framing.compile_obj(str(MODEL), framing=framing.PROGRAM)
    (pathlib.Path(folder) / "cube_scene.h").write_text(c_scene.header(scene, "cube", MODEL.name), encoding="utf-8")
    return scene


def draw(library, program=PROGRAM):
    """The picture as an array of palette entries, and the palette. library: libfixel.a of this machine."""
    own_palette = 768 if program != PROGRAM else 0
    if not pathlib.Path(library).exists():
        raise ToolError(f"{library}: there is no such library; `make build/host/libfixel.a` makes one")
    with scratch.folder("first") as folder:
        scene = write_scene(folder)
        command = [os.environ.get("HOSTCC", "gcc"), "-std=c11", f'-DEXAMPLE="{program}"', f"-I{ROOT / 'lib' / 'include'}",
                   *(["-DEXAMPLE_PALETTE"] if own_palette else []),
                   f"-I{folder}", str(FRAME), str(library), "-o", f"{folder}/frame"]
        done = children.run(command, text=True)
        if done.returncode != 0:
            raise ToolError(f"{program} cannot be compiled with {library}: {done.stderr.strip()}")
        ran = children.run([f"{folder}/frame"])
    if ran.returncode != 0 or len(ran.stdout) != WIDTH * HEIGHT + own_palette:
        raise ToolError(f"{program} drew nothing: it ended with {ran.returncode}", exit_code=1)
    pixels = numpy.frombuffer(ran.stdout[own_palette:], dtype=numpy.uint8).reshape(HEIGHT, WIDTH)
    palette = numpy.frombuffer(ran.stdout[:own_palette], dtype=numpy.uint8).reshape(-1, 3)
    return pixels, palette if own_palette else numpy.array(scene.palette, dtype=numpy.uint8)
