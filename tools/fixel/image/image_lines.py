# SPDX-License-Identifier: MIT
"""The lines of a scene image's models: what the library asks of them (docs/formats.md, section 1.14)."""

from typing import NamedTuple

from fixel.image.c_text import braces, record, table
from fixel.image.fields import entry
from fixel.image.image_tree import fail

WIDTH_MAX = 16      # pixels
LINE, MAP = map(entry, ("lines", "line map"))
INCLUDE = "fixel/lines.h"


class Line(NamedTuple):
    """A line between two vertices of a model, or a point at one; faces: two numbers, counted from 1, or 0."""
    start: int
    end: int
    faces: tuple
    colour: int
    width: int


def _ends(models):
    """Where the lines of each model end, behind a 0."""
    ends = [0]
    for model in models:
        ends.append(ends[-1] + len(model.lines))
    return ends


def tables(models):
    """Lines and their map as packed bytes, by name; nothing without lines."""
    lines = [LINE.pack(line.start, line.end, *line.faces, line.colour, line.width, 0) for model in models for line in model.lines]
    return {"lines": lines, "line map": [MAP.pack(end) for end in _ends(models)]} if lines else {}


def read(found, models):
    """Gives the models of an image their lines. found: {name of a table: its entries}."""
    lines, ends = found["lines"], found["line map"]
    if not lines:
        return
    if ends[0] != 0 or ends[-1] != len(lines):
        fail("count", f"the line map goes from {ends[0]} to {ends[-1]}, and there are {len(lines)} lines")
    for i, model in enumerate(models):
        if not ends[i] <= ends[i + 1] <= len(lines):
            fail("count", f"model {i}: its lines go from {ends[i]} to {ends[i + 1]} of {len(lines)}")
        for number in range(ends[i], ends[i + 1]):
            start, end, first, second, colour, width, reserved = lines[number]
            if reserved:
                fail("reserved", f"line {number}: a reserved field is not zero")
            if not 1 <= width <= WIDTH_MAX:
                fail("range", f"line {number}: a width of {width} is outside 1..{WIDTH_MAX}")
            if max(start, end) >= len(model.vertices) or max(first, second) > len(model.faces):
                fail("index", f"line {number}: model {i} does not have one of its vertices or faces")
            model.lines.append(Line(start, end, (first, second), colour, width))


def text(scene, name):
    """The tables and the record of a scene's lines as text of C; nothing without."""
    lines = [line for model in scene.models for line in model.lines]
    if not lines:
        return []
    return [table("fxl_line", f"{name}_line_table", [braces(one.start, one.end, braces(*one.faces), one.colour, one.width, 0) for one in lines],
                  "Vertices, faces, colour, width, reserved."),
            table("uint32_t", f"{name}_line_map", [str(end) for end in _ends(scene.models)], "Where the lines of each model begin, and the last end."),
            record("fxl_line_set", f"{name}_lines", [f"{name}_line_table, {len(lines)}, {name}_line_map"], "For fxl_attach_lines.")]
