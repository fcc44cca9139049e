# SPDX-License-Identifier: MIT
"""Where the copies of a scene file's object are placed: position, positions, ring and repeat."""

from fractions import Fraction
import math
import operator

from fixel.model import quantity
from fixel.base.errors import ToolError
from fixel.model.turning import sine_cosine

# place key: a key of an object's places: ring, repeat, position
_RING = {"count", "radius", "start", "turn", "turned"}


def _ring_count(table):
    return table.table("ring", _RING).whole("count", None, 1, 1000) if "ring" in table else 1


def ring_is_turned(table):
    """Whether the copies on a ring are one model, each with a turn of its own."""
    return "ring" in table and table.table("ring", _RING).switch("turned", False)


def _ring_places(table, count):
    """(offset, yaw) of each place on a ring about the position."""
    if "ring" not in table:
        return [((0, 0, 0), 0)]
    ring = table.table("ring", _RING)
    radius = ring.number("radius", None, 0, 16382, "world units")
    start, turn = ring.degrees("start"), ring.switch("turn", True)
    places = []
    for i in range(count):
        yaw = start + Fraction(360 * i, count)
        sine, cosine = sine_cosine(yaw)
        places.append(((radius * sine, 0, radius * cosine), yaw if turn else 0))
    return places


def _repeat_count(table):
    if "repeat" not in table:
        return 1, 1, 1
    return table.table("repeat", {"count", "step"}).wholes("count", 3, 1000)


def _repeat_step(table):
    if "repeat" not in table:
        return 0, 0, 0
    repeat = table.table("repeat", {"count", "step"})
    return quantity.vector(repeat.need("step"), repeat.at("step"))


def _repeated(base, step, count):
    """The points of a grid, the first at base."""
    along = [[b + n * s for n in range(most)] for b, s, most in zip(base, step, count)]
    return [(x, y, z) for z in along[2] for y in along[1] for x in along[0]]


def count(table):
    """How many instances there are."""
    if "positions" in table and "position" in table:
        raise ToolError(f"{table.where}: both position and positions are given; keep one")
    return (len(table.rows("positions")) if "positions" in table else 1) * _ring_count(table) * math.prod(_repeat_count(table))


def places(table):
    """(position, extra yaw) of every instance, in order."""
    if "positions" in table:
        bases = [quantity.position(p, f"{table.at('positions')}[{i}]") for i, p in enumerate(table.rows("positions"))]
    else:
        bases = [table.position("position") if "position" in table else (0, 0, 0)]
    if "ring" not in table and "repeat" not in table:
        return [(base, 0) for base in bases]
    rings, step, repeat = _ring_places(table, _ring_count(table)), _repeat_step(table), _repeat_count(table)
    return [(point, yaw) for base in bases for out, yaw in rings
            for point in _repeated(map(operator.add, base, out), step, repeat)]
