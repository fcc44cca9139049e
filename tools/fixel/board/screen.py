# SPDX-License-Identifier: MIT
"""Saves a picture of an emulated board's screen after the last frame."""

import argparse
import pathlib
import re
import shutil

from fixel.base import children, output, scratch
from fixel.base.errors import ToolError, one_line
from fixel.base.progress import Progress
from fixel.base.reading import quoted
from fixel.board import methods
from fixel.commands import late
from fixel.scene import scene_options

Image = late("PIL.Image")
picture = late("fixel.base", "picture")
firmware, flash_memory, model_look, sessions = late("fixel.board", "firmware flash_memory model_look session")
image = late("fixel.image", "image")

DEVICE_TEXT = re.compile(r"[A-Za-z0-9][\w.-]*(,[\w.-]+=[^,]*)*")     # as QEMU's -device takes it
DEVICE = "screen"       # what an added display is called


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    scene_options.add_board(made)
    scene_options.add(made)
    methods.add_options(made)
    made.add_argument("--device", help="a display to add to the board, in the words of QEMU's -device")
    made.add_argument("--out", required=True, type=pathlib.Path, help="the picture (.png)")
    made.add_argument("--build", default="build", help="folder that make builds in")
    made.add_argument("--timeout", type=float, default=120.0, help="limit of the drawing time in seconds (120)")
    return made


def before(options):
    """Refuses a folder in the place of the picture, and a device that QEMU has not, where QEMU is installed already."""
    if options.out is not None and options.out.is_dir():
        raise ToolError(f"{options.out}: cannot be written: it is a folder; name a file")
    if not options.device:
        return
    if not DEVICE_TEXT.fullmatch(options.device):
        raise ToolError(f"DEVICE is {quoted(options.device)}; it must be like ssd0303 or name,property=value")
    qemu = shutil.which("qemu-system-arm")
    known = children.run([qemu, "-device", "help"], text=True).stdout if qemu else ""
    if known and f'name "{options.device.partition(",")[0]}"' not in known:
        raise ToolError(f"DEVICE is {quoted(options.device)}; QEMU has no such device: qemu-system-arm -device help lists them")


def photograph(options, folder):
    """The picture, and how many frames were drawn."""
    elf = methods.elf_of(options.board, options.build, methods.program(options))
    program = firmware.load(elf, options.board)
    if program.hosted:
        raise ToolError(f"board {options.board} has no screen of its own; BOARD= names an emulated one")
    scene = model_look.scene_image(options, elf, folder)
    methods.check_scene(options, image.load(scene))
    frames = options.frames or image.load(scene).frames
    flash_memory.flash(options.board, elf, scene, folder / "board.bin")
    device = ["-device", f"{options.device},id={DEVICE}"] if options.device else []
    with Progress(f"drawing {frames} frames on {options.board}"), \
            sessions.Session(program, folder / "board.bin", folder, [f"frames={frames}", "hold"], device) as session:
        session.wait_for_text(f"walk: done {frames} frames\n", options.timeout)
        return session.screen(DEVICE if device else None), frames


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    scene_options.check(options)
    methods.check(options)
    with scratch.folder("screen") as folder:
        pixels, frames = photograph(options, folder)
    output.write_file(options.out, picture.png_bytes(Image.fromarray(pixels)))
    print(f"{options.board}: its screen after frame {frames - 1}: {one_line(options.out)}")
    return 0
