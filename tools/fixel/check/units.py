# SPDX-License-Identifier: MIT
"""The unit tests that make has built, as the Makefile names them to a tool.

It names a folder and the tests in it, not a path for each: there are over a thousand programs, and Linux gives one
command 128 KiB.
"""

import pathlib


def add_options(parser):
    """--board-units and --left-out."""
    parser.add_argument("--board-units", nargs="+", action="append", default=[], metavar=("BOARD", "FOLDER"),
                        help="a board, the folder of its Unity programs, their names without .elf")
    parser.add_argument("--left-out", nargs="+", action="append", default=[], metavar=("BOARD", "TEST"),
                        help="a board and the tests that it has no room for")


def of_boards(options):
    """[(board, program)] of --board-units."""
    return [(board, pathlib.Path(folder) / f"{name}.elf")
            for board, folder, *names in options.board_units for name in names]


def left_out(options, board):
    """The names of the tests that a board has no room for."""
    return [name for other, *names in options.left_out if other == board for name in names]
