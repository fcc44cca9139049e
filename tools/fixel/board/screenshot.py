# SPDX-License-Identifier: MIT
"""What the screen of a board shows after the last frame, as a picture."""

from PIL import Image

from fixel.base import output, picture, scratch
from fixel.board import firmware, flash_memory, methods, model_look
from fixel.base.errors import ToolError, one_line
from fixel.image.image import load
from fixel.base.progress import Progress
from fixel.board.session import Session
from fixel.scene import scene_options

DEVICE = "screen"       # what an added display is called


def photograph(options, folder):
    """The picture, and how many frames were drawn."""
    elf = methods.elf_of(options.board, options.build, methods.program(options))
    program = firmware.load(elf, options.board)
    if program.hosted:
        raise ToolError(f"board {options.board} has no screen of its own; BOARD= names an emulated one")
    scene = model_look.scene_image(options, elf, folder)
    methods.check_scene(options, load(scene))
    frames = options.frames or load(scene).frames
    flash_memory.flash(options.board, elf, scene, folder / "board.bin")
    device = ["-device", f"{options.device},id={DEVICE}"] if options.device else []
    with Progress(f"drawing {frames} frames on {options.board}"), \
            Session(program, folder / "board.bin", folder, [f"frames={frames}", "hold"], device) as session:
        session.wait_for_text(f"walk: done {frames} frames\n", options.timeout)
        return session.screen(DEVICE if device else None), frames


def command(options):
    """The command; its exit code."""
    scene_options.check(options)
    methods.check(options)
    with scratch.folder("screen") as folder:
        pixels, frames = photograph(options, folder)
    output.write_file(options.out, picture.png_bytes(Image.fromarray(pixels)))
    print(f"{options.board}: its screen after frame {frames - 1}: {one_line(options.out)}")
    return 0
