# SPDX-License-Identifier: MIT
"""What each frame of a scene's path costs on a board, for the site: the figures of fixel predict, frame by frame."""

import functools
import pathlib
import re

from fixel.bench import badge, frame_costs, predict, stage_costs
from fixel.image import image

CORE = re.compile(r"-m(?:cpu|arch)=([\w-]+)")
FIRST = "pico"      # the board that the first page begins with


def boards(build):
    """{a board of bench/costs.json: what people call it, its core, its clock in MHz or None, and the cycles of an instruction of each part or None}, the first page's first."""
    found = {}
    for board in sorted(frame_costs.load()["boards"], key=lambda board: board != FIRST):
        options = settings(board, build)
        model = stage_costs.model_of(options.core)
        entry, code = predict.board_of(options, frame_costs.load())
        found[board] = {"name": badge.name_of(board), "core": CORE.search(options.core)[1], "clock": options.clock, "paces": model and stage_costs.paces_of(model), "code": code,
                        "settings": [options.band, options.order, options.list, options.cache, options.list_most], "without": options.without,
                        "memory": frame_costs.memory(entry, 0)}
    return found


def cores():
    """{a core of bench/costs.json: {count: instructions of one, all and then those of each of stage_costs.PARTS, where these are known}}."""
    known = frame_costs.load()
    return {core: {name: [cost, *(cost * share for share in known["stages"][core][name])] if core in known["stages"] else [cost] for name, cost in costs.items()}
            for core, costs in known["cores"].items()}


@functools.cache
def settings(board, build):
    """The options of predict for a board."""
    options = predict.parser().parse_args(["--board", board, "--build", str(build)])
    predict.complete(options)
    return options


def of_scene(scene, file, board, build):
    """What a scene image takes on a board: bytes of flash and RAM, and of each frame the instructions: [all, then those of each of
    stage_costs.PARTS]; or why the board has no room."""
    options = settings(board, build)
    options.scene = scene.name
    known = frame_costs.load()
    entry, core = predict.board_of(options, known)
    loaded, size = image.load(file), pathlib.Path(file).stat().st_size
    memory = frame_costs.memory(entry, size)
    found = {"flash": memory["flash"], "ram": memory["ram"]}
    try:
        names, counts = predict.count(options, loaded, size, entry, file)
    except frame_costs.NoRoom as error:
        return {**found, "why_not": str(error)}
    taken = frame_costs.instructions(known["cores"][core], names, counts)
    timed = predict.timed(options, core, names, counts)
    parts = stage_costs.instructions(core, names, counts)
    found["mean"] = {"instructions": round(taken.mean()), "cycles": timed["cycles"] and timed["cycles"]["mean"]}
    found["instructions"] = [[round(total), *(parts[number].astype(int).tolist() if parts is not None else ())] for number, total in enumerate(taken)]
    return found
