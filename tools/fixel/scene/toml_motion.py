# SPDX-License-Identifier: MIT
"""Places and motions of a scene file's objects (docs/scenes.md): position, positions, ring and repeat, and from the keys of a motion to the
records of an image. Whatever has such a key is a turned object."""

import math
import operator
from dataclasses import dataclass, field, replace
from fractions import Fraction

from fixel.base.errors import ToolError
from fixel.base.reading import quoted
from fixel.image import image_placement
from fixel.image.image_placement import Key, Motion, Placement
from fixel.model import quantity
from fixel.model.quantity import matrix, sine_cosine
from fixel.scene import keys

def ring_is_turned(table):
    """Whether the copies on a ring are one model, each with a turn of its own."""
    return "ring" in table and table["ring"]["turned"]


def _ring_places(ring):
    """(offset, yaw) of each place on a ring about the position."""
    if ring is None:
        return [((0, 0, 0), 0)]
    places = []
    for i in range(ring["count"]):
        yaw = ring["start"] + Fraction(360 * i, ring["count"])
        sine, cosine = sine_cosine(yaw)
        places.append(((ring["radius"] * sine, 0, ring["radius"] * cosine), yaw if ring["turn"] else 0))
    return places


def _repeated(base, step, count):
    """The points of a grid, the first at base."""
    along = [[b + n * s for n in range(most)] for b, s, most in zip(base, step, count)]
    return [(x, y, z) for z in along[2] for y in along[1] for x in along[0]]


def count(table):
    """How many instances there are."""
    if "positions" in table and "position" in table:
        raise ToolError(f"{table.where}: both position and positions are given; keep one")
    ring, repeat = table["ring"], table["repeat"]
    return len(table.get("positions", "1")) * (ring["count"] if ring else 1) * (math.prod(repeat["count"]) if repeat else 1)


def places(table):
    """(position, extra yaw) of every instance, in order."""
    bases = table.get("positions", (table["position"],))
    if "ring" not in table and "repeat" not in table:
        return [(base, 0) for base in bases]
    repeat = table["repeat"]
    step, repeat = (repeat["step"], repeat["count"]) if repeat else ((0, 0, 0), (1, 1, 1))
    rings = _ring_places(table["ring"])
    return [(point, yaw) for base in bases for out, yaw in rings
            for point in _repeated(map(operator.add, base, out), step, repeat)]


SIZE_MIN, SIZE_MAX = keys.SIZE.kind.low, keys.SIZE.kind.high
FRAMES_MAX = image_placement.FRAME_MAX
STEP_MAX = 120      # degrees between two keys of the image: less than half a turn, which is the short way
_FINE = 1 << 156
ZEROS = keys.ZEROS


@dataclass
class Stop:
    """A key of a scene file: an offset from the object's position, angles in degrees, a size."""
    frame: int
    offset: tuple = ZEROS
    turn: tuple = ZEROS
    size: Fraction = Fraction(1)


@dataclass
class Life:
    """What the keys of an object say, as Fractions: degrees and units."""
    turn: tuple = ZEROS
    size: Fraction = Fraction(1)
    steps: tuple = ZEROS            # of yaw, pitch, roll, a frame
    axis: tuple = None              # 16.16
    spin: tuple = (Fraction(0),) * 2
    radius: Fraction = Fraction(0)
    circle: tuple = (Fraction(0),) * 2
    stops: list = field(default_factory=lambda: [Stop(0)])
    repeats: bool = False
    parent: str = None
    where: str = ""
    rise: int = 0                   # 16.16, of the middle above the base, at size 1

    def on_ring(self, yaw, rise):
        """The same for a copy on a ring."""
        return replace(self, turn=(self.turn[0] + yaw, *self.turn[1:]), rise=rise)

    @property
    def moves(self):
        return bool(any(self.steps) or self.axis or self.radius or len(self.stops) > 1 or self.parent)


def _read_spin(table, life):
    spin = table["spin"]
    angles = [key for key in ("yaw", "pitch", "roll") if key in spin]
    if ("axis" in spin) == bool(angles):
        raise ToolError(f"{spin.where}: give an axis and degrees, or some of yaw, pitch and roll, in degrees a frame")
    if angles:
        spin.refuse(("degrees", "start"), "belongs to an axis")
        life.steps = spin["yaw"], spin["pitch"], spin["roll"]
        return
    axis = spin["axis"]
    longest = max(map(abs, axis))
    if not longest:
        raise ToolError(f"{spin.at('axis')}: [0, 0, 0] is no axis")
    # Any length will do; a long one has the fewest roundings.
    life.axis = tuple(quantity.q16(c * 8191 / longest) for c in axis)
    life.spin = spin["start"], spin.need("degrees")


def _read_circle(motion, life):
    life.radius = motion["circle"]
    step, start = motion.need("degrees"), motion["start"]
    life.circle = start, step
    if motion["facing"]:
        # Along the circle: a quarter turn ahead of the way from its middle, or behind it.
        ahead = 90 if step > 0 else -90
        life.turn = (life.turn[0] + start + ahead, *life.turn[1:])
        life.steps = (life.steps[0] + step, *life.steps[1:])


def _read_way(motion, life):
    frames = motion.need("frames")
    life.stops = [Stop(0), Stop(frames, motion["by"])]
    life.repeats = motion["repeats"]
    if motion["back"]:
        life.stops.append(Stop(2 * frames))


def _read_stops(motion, life):
    frame, life.stops = 0, []
    life.repeats = motion["repeats"] and len(motion["keys"]) > 1
    for key in motion["keys"]:
        life.stops.append(Stop(frame, key["offset"], key["turn"], key["size"]))
        frame += key["frames"]
        if frame > FRAMES_MAX:
            raise ToolError(f"{motion.at('keys')}: more than {FRAMES_MAX:,} frames")
    if life.repeats:
        life.stops.append(replace(life.stops[0], frame=frame))


def _read_motion(table, life):
    known = {"circle": {"degrees", "start", "facing"}, "by": {"frames", "back", "repeats"}, "keys": {"repeats"}}
    motion = table["motion"]
    kind = motion.only_one(*known)
    for key in motion.data:
        if key != kind and key not in known[kind]:
            raise ToolError(f"{motion.at(key)}: does not belong to {kind}")
    {"circle": _read_circle, "by": _read_way, "keys": _read_stops}[kind](motion, life)


def read(table):
    """What an object's keys say, or None: it is not turned."""
    if not any(key in table for key in keys.TURNED):
        return None
    life = Life(table["turn"], table["size"], parent=table["parent"], where=table.where)
    if "spin" in table:
        _read_spin(table, life)
    if "motion" in table:
        _read_motion(table, life)
    return life


def _pieces(a, b):
    """In how many pieces the way between two stops is cut."""
    most = max(abs(q - p) for p, q in zip(a.turn, b.turn))
    return min(max(1, math.ceil(most / STEP_MAX)), b.frame - a.frame)


def _count_keys(stops):
    return 1 + sum(_pieces(a, b) for a, b in zip(stops, stops[1:]))


def _fine(stops):
    """With stops between, so that the image's angles, which take the short way, go through the numbers as written."""
    result = [stops[0]]
    for a, b in zip(stops, stops[1:]):
        pieces, frames = _pieces(a, b), b.frame - a.frame
        for i in range(1, pieces + 1):
            part = Fraction(frames * i // pieces, frames)

            def between(p, q):
                return p + (q - p) * part
            result.append(Stop(a.frame + frames * i // pieces, tuple(map(between, a.offset, b.offset)),
                               tuple(map(between, a.turn, b.turn)), between(a.size, b.size)))
    return result


def _key(stop, life, position):
    size = quantity.q16(life.size * stop.size)
    centre = [quantity.q16(p + o) for p, o in zip(position, stop.offset)]
    centre[1] += quantity.q16(life.rise * life.size * stop.size / 65536)
    if not image_placement.SCALE_MIN <= size <= image_placement.SCALE_MAX:
        quantity.in_range(life.size * stop.size, SIZE_MIN, SIZE_MAX, f"{life.where}: size")
    if any(abs(c) > image_placement.PLACE_MAX for c in centre):
        raise ToolError(f"{life.where}: a key's offset is out of range")
    angles = tuple(quantity.angle(a + b) for a, b in zip(life.turn, stop.turn))
    return Key(stop.frame, tuple(centre), angles, size)


def _motion(instance, parent):
    life = instance.life
    stops = [_key(stop, life, instance.centre) for stop in _fine(life.stops)]
    return Motion(stops, tuple(map(quantity.angle, life.steps)), life.axis or (0, 0, 0),
                  tuple(map(quantity.angle, life.spin)) if life.axis else (0, 0), quantity.q16(life.radius),
                  tuple(map(quantity.angle, life.circle)) if life.radius else (0, 0), parent, int(life.repeats))


def _degrees(angle):
    return Fraction(angle * 360, quantity.TURN)


def _about_axis(axis, angle):
    """x towards y about +z; as floats."""
    length = math.sqrt(sum(c * c for c in axis))
    a, turn = [c / length for c in axis], math.radians(float(_degrees(angle)))
    s, c = math.sin(turn), math.cos(turn)
    across = [[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]]
    return [[c * (i == j) + s * across[i][j] + (1 - c) * a[i] * a[j] for j in range(3)] for i in range(3)]


def _rows(motion):
    """The orientation in frame 0, in the parent, as numbers."""
    rows = matrix((1, 1, 1), tuple(map(_degrees, motion.keys[0].angles)))
    if any(motion.axis):
        rows = quantity.product([[float(c) for c in row] for row in rows], _about_axis(motion.axis, motion.spin[0]))
    return rows


def _start(motion, above):
    """centre, rows and scale in frame 0; above: those of the parent, or None."""
    key, (sine, cosine) = motion.keys[0], sine_cosine(_degrees(motion.circle[0]))
    x, y, z = key.centre
    centre, rows, scale = (x + motion.radius * sine, y, z + motion.radius * cosine), _rows(motion), key.scale
    if above:
        origin, axes, size = above
        centre = tuple(o + sum(a * c for a, c in zip(row, centre)) * size / 65536 for o, row in zip(origin, axes))
        rows, scale = [list(map(_rounded, row)) for row in quantity.product(axes, rows)], quantity.q16(Fraction(scale * size, 65536 ** 2))
    return tuple(quantity.q16(Fraction(c) / 65536) for c in centre), rows, scale


def _rounded(number):
    """A Fraction to 2^-156, which one turn alone has: the numbers of a chain would be ever longer."""
    return number if isinstance(number, float) else Fraction(round(number * _FINE), _FINE)


def _in_2_30(rows):
    return tuple(quantity.q30(c) for row in rows for c in row)


def _parent_of(instance, named):
    """The instance that another is attached to; named: those before it, by name."""
    name = instance.life.parent
    found = named.get(name, [])
    if not found:
        raise ToolError(f"{instance.where}: parent: no object before this one has the name {quoted(name)} and one of "
                        f"{', '.join(sorted(keys.TURNED))}")
    if len(found) > 1:
        raise ToolError(f"{instance.where}: parent: {len(found)} objects have the name {quoted(name)}")
    return found[0]


def _check_depth(item, parents, depths):
    """Refuses more parents, one after the other, than an image may have; depths: those of the instances before."""
    depth = depths[id(item)] = 1 + depths[id(parents[id(item)])] if id(item) in parents else 0
    if depth > image_placement.DEPTH_MAX:
        raise ToolError(f"{item.where}: parent: it has more than {image_placement.DEPTH_MAX} parents, one after the other")


def _parents(lively):
    """{id of an instance: its parent}; and those that move, themselves or as parents, in order."""
    parents, named, depths, stops = {}, {}, {}, 0
    for item in lively:
        if item.life.parent is not None:
            parents[id(item)] = _parent_of(item, named)
        named.setdefault(item.name, []).append(item)
        _check_depth(item, parents, depths)
        stops += _count_keys(item.life.stops)
        if stops > image_placement.KEYS_MAX:
            raise ToolError(f"{item.where}: the motions have more than {image_placement.KEYS_MAX:,} keys together, with those that "
                            "large turns need; turn less between two keys, or give fewer objects keys")
    needed = {id(parent) for parent in parents.values()}
    return parents, [item for item in lively if item.life.moves or id(item) in needed]


def settle(instances):
    """The instances in the order of an image: those that stand still, those that are turned, those that move;
    and the placements and motions of the last."""
    lively = [item for item in instances if item.life is not None]
    parents, moving = _parents(lively)
    known = {id(item) for item in moving}
    ordered = [item for item in instances if item.life is None]
    placements, motions, starts, numbers = [], [], [], {}
    for item in [item for item in lively if id(item) not in known] + moving:
        above = numbers[id(parents[id(item)])] if id(item) in parents else None
        motion = _motion(item, 0 if above is None else above + 1)
        start = _start(motion, None if above is None else starts[above])
        if id(item) in known:
            numbers[id(item)] = len(motions)
            motions.append(motion)
            starts.append(start)
        placements.append(Placement(_in_2_30(start[1]), start[2]))
        ordered.append(replace(item, centre=start[0]))
    return ordered, placements, motions
