# SPDX-License-Identifier: MIT
"""The conditions of lib/ that no test reaches, against those that have a proof or a reason: host_tests/unit/uncovered.toml.

A gap is named by its file, its function and its text, so it stays the same where lines move.
"""

import collections
import tomllib

from fixel.base.errors import ToolError

SIDES = ("true", "false", "alone")


def read(path):
    """{(file, function, condition): (the sides that are stated, the reason)}."""
    stated = {}
    for number, entry in enumerate(tomllib.loads(path.read_text(encoding="utf-8")).get("reason", []), 1):
        if entry.keys() != {"why", "gaps"} or not entry["why"].strip():
            raise ToolError(f"{path.name}: reason {number} needs why and gaps, and nothing else")
        for line in entry["gaps"]:
            key, sides = parsed(line, path.name)
            if key in stated:
                raise ToolError(f'{path.name}: "{" | ".join(key)}" stands there twice')
            stated[key] = (sides, entry["why"].strip())
    return stated


def parsed(line, name):
    """((file, function, condition), sides) of a line. A condition may have a | of its own."""
    parts = line.split(" | ", 2)
    parts[2:] = parts[2].rsplit(" | ", 1) if len(parts) == 3 else []
    sides = tuple(parts[-1].split())
    if len(parts) != 4 or not sides or not set(sides) <= set(SIDES):
        raise ToolError(f'{name}: a gap is "file | function | condition | {" ".join(SIDES)}", not "{line}"')
    return tuple(parts[:3]), sides


def found(files):
    """{(file, function, condition): Gap} of what was measured."""
    return {(name, gap.function, gap.condition): gap for name, counted in files.items() for gap in counted["open"]}


def sentences(files, stated):
    """(what is open without a reason, what has a reason and is not open), as lines with places."""
    measured = found(files)
    new, gone = [], []
    for key, gap in measured.items():
        left = [side for side in gap.open if side not in stated.get(key, ((), ""))[0]]
        if left:
            new.append(f"{key[0]}:{gap.line}: {' | '.join(key)} | {' '.join(left)}")
    for key, (sides, _) in stated.items():
        left = [side for side in sides if key not in measured or side not in measured[key].open]
        if left:
            gone.append(f"{' | '.join(key)} | {' '.join(left)}")
    return new, gone


def with_reasons(files, stated):
    """{kind: how many have a reason}: branches and conditions that are open and have one."""
    counted = collections.Counter()
    for key, gap in found(files).items():
        for side in set(gap.open) & set(stated.get(key, ((), ""))[0]):
            counted["conditions" if side == "alone" else "branches"] += 1
    return counted


def as_rows(files, stated):
    """The gaps as JSON has them."""
    return [{"file": key[0], "line": gap.line, "function": key[1], "condition": key[2], "open": list(gap.open),
             "why": stated.get(key, ((), None))[1]} for key, gap in found(files).items()]
