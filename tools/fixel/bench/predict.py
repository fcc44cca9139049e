# SPDX-License-Identifier: MIT
"""Predicts flash, RAM, stack and instructions a frame of a scene on a board, before anything is built for the board.

Exit: 0 the board has room for the scene, 1 it has not, 2 there is no prediction.
"""

import argparse
import json
import os
import pathlib
import shlex

from fixel import commands
from fixel.base import children
from fixel.base.errors import ToolError
from fixel.scene import scene_options

ROOT = pathlib.Path(__file__).resolve().parents[3]
COSTS = ROOT / "bench" / "costs.json"
# What make knows of a board, and what it is.
SETTINGS = {"band": "bytes of a band", "order": "entries of the order", "list": "bytes of the display list", "cache": "entries of the vertex cache"}


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--board", required=True)
    made.add_argument("--core", default="", help="the compiler's flags for the board's core")
    scene_options.add(made, targets=False)
    for name, what in SETTINGS.items():
        made.add_argument(f"--{name}", type=int, help=f"{what} (default: the board's)")
    made.add_argument("--list-most", type=int, default=0, help="bytes that limit the display list alone")
    made.add_argument("--without", default="", metavar="NAME,...",
                      help="what the board's program leaves out: surfaces, depth, billboards")
    made.add_argument("--json", help="write the prediction to this file too; - for the terminal, and nothing else")
    made.add_argument("--build", default="build", help="folder that make builds in")
    return made


def refuse_board(board):
    """Refuses a board of which there are no costs."""
    known = json.loads(COSTS.read_text(encoding="utf-8"))["boards"]
    if board not in known:
        raise ToolError(f"nothing can be predicted for board {board}: {COSTS.name} has no costs of its core, flags and program; "
                        f"the boards are: {', '.join(known)}. make run BOARD={board} draws there and says what it took")


def before(_):
    """Refuses the board of make."""
    refuse_board(os.environ.get("BOARD", scene_options.BOARD))


def complete(options):
    """Options that were not given are those of the board, as make hands them on."""
    lacking = [name for name in SETTINGS if getattr(options, name) is None]
    if not lacking:
        return
    refuse_board(options.board)
    done = children.run(["make", "-n", "MAKE=:", "predict", f"BOARD={options.board}"], cwd=ROOT)
    words = shlex.split(next((line for line in done.stdout.decode().replace("\\\n", " ").splitlines() if " make predict --board " in line), ""))
    if not words:
        raise ToolError(f"the settings of {options.board} are needed, which make knows in a checkout alone: give "
                        f"{', '.join(f'--{name} ({SETTINGS[name]})' for name in lacking)}, or run make predict BOARD={options.board} SCENE=...")
    known = parser().parse_args(words[words.index("predict") + 1:])
    for name in lacking:
        setattr(options, name, getattr(known, name))
    options.core = options.core or known.core
    options.list_most = options.list_most or known.list_most
    options.without = options.without or known.without


main = commands.main_of(parser, "fixel.bench.prediction")
