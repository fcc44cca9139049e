# SPDX-License-Identifier: MIT
"""Saves a picture of an emulated board's screen after the last frame."""

import argparse
import pathlib

from PIL import Image

from fixel.base import output, picture, scratch
from fixel.scene import making
from fixel.board import firmware, flash_memory, methods
from fixel.base import bounded
from fixel.base.errors import ToolError, one_line
from fixel.image.image import load
from fixel.base.progress import Progress
from fixel.board.session import Session
from fixel.board.run import frame_count, make_scene_image

DEVICE = "screen"       # what an added display is called


def photograph(options, folder):
    """The picture, and how many frames were drawn."""
    elf = methods.elf_of(options.board, options.build, methods.program(options))
    program = firmware.load(elf, options.board)
    if program.hosted:
        raise ToolError(f"board {options.board} has no screen of its own; BOARD= names an emulated one")
    scene = make_scene_image(options.scene, folder, options.frames, options.screen, bounded.limits_of(options))
    frames = options.frames or load(scene).frames
    flash_memory.flash(options.board, elf, scene, folder / "board.bin")
    device = ["-device", f"{options.device},id={DEVICE}"] if options.device else []
    with Progress(f"drawing {frames} frames on {options.board}"), \
            Session(program, folder / "board.bin", folder, [f"frames={frames}", "hold"], device) as session:
        session.wait_for_text(f"walk: done {frames} frames\n", options.timeout)
        return session.screen(DEVICE if device else None), frames


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--board", required=True, help="an emulated board with a screen")
    parser.add_argument("--scene", required=True, help="a .toml, a model (.obj, .gltf, .glb, .stl), or a scene image (.fxls)")
    parser.add_argument("--screen", help="width and height, like 128x64 (default: the scene's)")
    bounded.add_options(parser)
    parser.add_argument("--frames", help="number of frames (default: the whole path)")
    methods.add_options(parser)
    parser.add_argument("--device", help="a display to add to the board, in the words of QEMU's -device")
    parser.add_argument("--out", required=True, type=pathlib.Path, help="the picture (.png)")
    parser.add_argument("--build", default="build", help="folder that make builds in")
    parser.add_argument("--timeout", type=float, default=120.0, help="limit of the drawing time in seconds (120)")
    options = parser.parse_args(argv)
    options.frames = frame_count(options.frames) if options.frames is not None else None
    options.screen = making.parse_screen(options.screen) if options.screen else None
    with scratch.folder("screen") as folder:
        pixels, frames = photograph(options, folder)
    output.write_file(options.out, picture.png_bytes(Image.fromarray(pixels)))
    print(f"{options.board}: its screen after frame {frames - 1}: {one_line(options.out)}")
    return 0
