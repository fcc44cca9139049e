# SPDX-License-Identifier: MIT
"""The unit tests of boards, as firmware/unittest/programs.py linked them: units.json."""

import json
import pathlib

from fixel.base.errors import ToolError


def add_options(parser):
    """--units."""
    parser.add_argument("--units", nargs=2, action="append", default=[], metavar=("BOARD", "FILE"),
                        help="a board and its units.json, which names its programs of unit tests")


def _read(file):
    try:
        return json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ToolError(f"{file}: cannot be read: {error}; run 'make boards-programs'") from error


def of_boards(options):
    """[(board, program, names of its files of tests)] of --units."""
    return [(board, pathlib.Path(file).parent / program, names)
            for board, file in options.units for program, names in _read(file)["programs"].items()]


def left_out(options, board):
    """{name: why} of the files of tests that a board has no room for, as its linker said."""
    return {name: why for other, file in options.units if other == board
            for name, why in _read(file)["left_out"].items()}


def with_reasons(no_room):
    """"test_a (why), ..." of {name: why}."""
    return ", ".join(f"{name} ({why})" for name, why in sorted(no_room.items()))
