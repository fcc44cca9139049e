# SPDX-License-Identifier: MIT
"""The frames that a board draws of a scene: by the board, or as an earlier command kept them."""

from fixel.board import emulator, firmware, flash_memory, qemu

TIMEOUT = 60.0      # seconds of CPU time without a new frame


def draw(kept, part, board, elf, scene, folder, frames=None, timeout=TIMEOUT, progress=None, record=None):
    """Draws a scene image's path on a board: the file of the dump, which is made in folder. kept: a base.kept.Kept. part:
    what the frames are called in it. frames, timeout, progress, record: as for emulator.run."""
    program = firmware.load(elf, board)
    file, image = folder / f"{board}.fxld", folder / f"{board}.bin"

    def compute():
        # The host has no flash: the scene image itself is what it boots from.
        flash_memory.flash(board, elf, scene, image)
        emulator.run(board, image, elf, file, frames, timeout, progress, record=record)
        image.unlink()

    made = [file, record] if record else [file]
    kept.obtain(part, [elf, scene, frames or 0, len(made), "" if program.hosted else qemu.version(program.emulator)], made, compute)
    return file
