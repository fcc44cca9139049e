# SPDX-License-Identifier: MIT
"""Polygons that the display list of a frame in bands has no room for: how many, what they cost, and which size ends it."""

import pathlib
from dataclasses import dataclass

from fixel.base.table import count_of
from fixel.bench import frame_costs
from fixel.board import methods, model_look
from fixel.image import image as images, memory_needed

@dataclass(frozen=True)
class Lists:
    """Of a scene's path on a board: bytes of the display list that the board has, and of the least one that holds every frame;
    BOARD_LIST_BYTES of it; how many times the instructions a mean frame takes with the board's."""
    has: int
    holds: int
    setting: int
    times: float


def lists(options, room, file, band):
    """The Lists of a scene image, predicted; None where make predict's program does not draw as the board does, or is not built."""
    if room.is_host or methods.program(options).partition("-rows")[0].partition("-on-")[0] != methods.WALK or \
            not (pathlib.Path(options.build) / "host" / "predict").exists():
        return None

    def count(size, most):
        return frame_costs.counted(options.build, file, band, room.order, size, room.cache, most, options.frames or 0)
    size = room.list + memory_needed.WORD * memory_needed.most_words(images.load(file))
    names, counts, has = count(room.list, room.list_most)
    _, ample, largest = count(size, 0)
    costs = frame_costs.load()["cores"][room.core or model_look.CORE]
    taken, least = (frame_costs.instructions(costs, names, each).mean() for each in (counts, ample))
    holds = memory_needed.WORD * int(ample[:, names.index("list_words")].max())
    return Lists(has, holds, -(-(size - largest + holds) // 8) * 8, float(taken / least))


def note(options, elf, file, polygons):
    """What to say of the spilled polygons of a run; "" where nothing was computed twice. polygons: how many."""
    room, scene = model_look.room_of(elf), images.load(file)
    band, rows = model_look.band_of(room, scene, options.band_rows)
    number = -(-scene.height // rows)
    if not polygons or number == 1:
        return ""
    found = lists(options, room, file, band)
    if found is None:
        size = memory_needed.WORD * memory_needed.most_words(scene)
        return _sentence(polygons, f"{number} bands", f"A display list of {size:,} bytes holds every polygon of any frame and ends it")
    beyond = f", more than its RAM of {room.ram:,} bytes" if found.setting > room.ram else ""
    return _sentence(polygons, f"{number} bands", f"That takes {found.times:.2f} times the instructions of a list that holds them, as make "
                     f"predict counts. A list of {found.holds:,} bytes ends it, instead of {found.has:,}: BOARD_LIST_BYTES := {found.setting} "
                     f"in boards/{options.board}/board.mk{beyond}")


def of_own(polygons, name):
    """The same of a program of the user's own. name: what the names of its exported scene begin with, or ""."""
    ends = f"{name.upper()}_MEMORY_FAST of the exported header for {name.upper()}_MEMORY" if name else \
        "A larger block for fxl_renderer_init, which becomes its display list,"
    return _sentence(polygons, "bands", f"{ends} ends it, which takes more RAM and fewer instructions (docs/setup.md)")


def _sentence(polygons, bands, what):
    return f"Spilled: the display list had no room for {count_of(polygons, 'polygon')}, so each of the {bands} of a frame computes " \
           f"what of them it reaches again. {what}"
