# SPDX-License-Identifier: MIT
"""What each frame of a scene's path costs on a board, for the site: the figures of fixel predict, frame by frame."""

import functools
import pathlib
import re

from fixel.bench import frame_costs, predict
from fixel.image import image
from fixel.scene import scene_options

CORE = re.compile(r"-m(?:cpu|arch)=([\w-]+)")


def boards(build):
    """{a board for each core that bench/costs.json has costs of: its core}, the one that make takes by itself first."""
    found = {}
    for board in sorted(frame_costs.load()["boards"], key=lambda board: board != scene_options.BOARD):
        found.setdefault(CORE.search(settings(board, build).core)[1], board)
    return {board: core for core, board in found.items()}


@functools.cache
def settings(board, build):
    """The options of predict for a board."""
    options = predict.parser().parse_args(["--board", board, "--build", str(build)])
    predict.complete(options)
    return options


def of_scene(scene, file, board, build):
    """{instructions: [a frame each], flash: bytes} or {why_not: a sentence} of a scene image."""
    options = settings(board, build)
    options.scene = str(scene)
    known = frame_costs.load()
    entry, core = predict.board_of(options, known)
    size = pathlib.Path(file).stat().st_size
    try:
        names, counts = predict.count(options, image.load(file), size, entry, file)
    except frame_costs.NoRoom as error:
        return {"why_not": str(error)}
    taken = frame_costs.instructions(known["cores"][core], names, counts)
    return {"instructions": [round(each) for each in taken], "flash": entry["flash_bytes"] + size}
