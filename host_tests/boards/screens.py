# SPDX-License-Identifier: MIT
"""For the tests of screens: flash images of scenes, the host's frames, and what a screen shows."""

import dataclasses
import pathlib

from board_programs import ROOT, built
from fixel.scene import making
from fixel.board import dump, emulator, firmware, flash_memory, session


@dataclasses.dataclass(frozen=True)
class Flashed:
    """A scene in a board's flash, and the host's frames of its path."""
    program: firmware.Program
    image: pathlib.Path     # the flash image
    scene: pathlib.Path     # the scene image
    host: dump.Dump


def flashed(board, scene, folder, screen=None):
    """scenes/<scene>.toml in the flash of a board, at a screen of its own where one is given."""
    folder = pathlib.Path(folder)
    image, bin_file, frames = folder / "scene.fxls", folder / "board.bin", folder / "host.fxld"
    making.build(str(ROOT / "scenes" / f"{scene}.toml"), str(image), screen=screen)
    elf = built(f"{board}/walk.elf")
    flash_memory.flash(board, elf, image, bin_file)
    emulator.run(firmware.HOST, image, built("host/walk"), frames)
    return Flashed(firmware.load(elf, board), bin_file, image, dump.read_dump(frames))


def screen_after(flashed_scene, frames, folder, device=None, options=()):
    """What a screen shows when so many frames were drawn, and the board's own dump of them."""
    with session.Session(flashed_scene.program, flashed_scene.image, folder, [f"frames={frames}", "hold"],
                         options) as board:
        board.wait_for_text(f"walk: done {frames} frames\n")
        return board.screen(device), dump.read_dump(pathlib.Path(folder) / emulator.DUMP_NAME)
