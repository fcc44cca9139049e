# SPDX-License-Identifier: MIT
"""The turned instances of a scene image and their motions: what the loader asks of them
(docs/formats.md, sections 1.9 and 1.10)."""

from dataclasses import dataclass
from math import isqrt

from fixel.base.vectors import dot
from fixel.image.fields import entry
from fixel.image.image_tree import COORDINATE_MAX, fail

SCALE_MIN, SCALE_MAX = 256, 256 << 16
KEYS_MAX, FRAME_MAX = 1_000_000, 1_000_000
DEPTH_MAX = 8
PLACE_MAX = (1 << 30) - 1       # of a coordinate of a place, and of an axis
SLACK = 32                      # FXL_PLACEMENT_SLACK
TOLERANCE = 1 << 32             # 2^-28 in units of 2^-60
PLACEMENT, MOTION, KEY = map(entry, ("placements", "motions", "motion keys"))
assert (PLACEMENT.size, MOTION.size, KEY.size) == (40, 76, 32)


@dataclass
class Placement:
    """How an object is turned and scaled."""
    rows: tuple         # nine entries in 2.30, row by row
    scale: int          # 16.16

    def pack(self):
        return PLACEMENT.pack(*self.rows, self.scale)


@dataclass
class Key:
    """Of a motion: a place in a frame."""
    frame: int
    centre: tuple       # 16.16, in the world or in the parent's model
    angles: tuple       # yaw, pitch, roll, binary
    scale: int          # 16.16

    def pack(self):
        return KEY.pack(self.frame, *self.centre, *self.angles, self.scale)


@dataclass
class Motion:
    """How an object moves."""
    keys: list
    steps: tuple = (0, 0, 0)        # what a frame adds to yaw, pitch, roll
    axis: tuple = (0, 0, 0)         # of the spin; zeros: none
    spin: tuple = (0, 0)            # binary angle in frame 0, and what a frame adds
    radius: int = 0                 # 16.16, of the circle
    circle: tuple = (0, 0)          # as spin
    parent: int = 0                 # 1 + the number of a motion before this one; 0: none
    repeats: int = 0
    extent: tuple = None            # the largest |coordinate| of a key
    scales: tuple = None            # the least and the largest of a key

    def __post_init__(self):
        if self.extent is None:
            self.extent = tuple(max(abs(key.centre[i]) for key in self.keys) for i in range(3))
            self.scales = min(key.scale for key in self.keys), max(key.scale for key in self.keys)

    def pack(self, first_key):
        return MOTION.pack(*self.steps, *self.axis, *self.spin, self.radius, *self.circle, *self.extent,
                           *self.scales, first_key, len(self.keys), self.parent, self.repeats, 0)

    def place_extent(self):
        """The largest |coordinate| of the place: of the keys, and the radius along x and z."""
        x, y, z = self.extent
        return x + self.radius, y, z + self.radius


def tables(placements, motions):
    """Placements, motions and their keys as packed bytes, by name."""
    packed, keys = [], []
    for motion in motions:
        packed.append(motion.pack(len(keys)))
        keys += [key.pack() for key in motion.keys]
    return {"placements": [placement.pack() for placement in placements], "motions": packed, "motion keys": keys}


def _is_rotation(rows):
    """x and y of unit length and at right angles, to within 2^-28, and z their cross product, to within 2^-26."""
    x, y, z = rows[:3], rows[3:6], rows[6:]
    narrow = dot(x, x) - (1 << 60), dot(y, y) - (1 << 60), dot(x, y)
    wide = [x[(i + 1) % 3] * y[(i + 2) % 3] - x[(i + 2) % 3] * y[(i + 1) % 3] - (z[i] << 30) for i in range(3)]
    return all(-TOLERANCE <= value < TOLERANCE for value in narrow) and \
        all(-4 * TOLERANCE <= value < 4 * TOLERANCE for value in wide)


def _is_scale(scale):
    return SCALE_MIN <= scale <= SCALE_MAX


def _check_place(centre, scale, radius, what):
    """That a turned object's sphere lies in the world."""
    if not _is_scale(scale):
        fail("range", f"{what}: a scale of {scale / 65536:.6g} is outside 1/256..256")
    reach = -(-scale * radius // 65536) + SLACK
    if any(abs(c) > COORDINATE_MAX - reach for c in centre):
        fail("range", f"{what}: its centre ({', '.join(f'{c / 65536:.6g}' for c in centre)}) and its radius of "
             f"{reach / 65536:.6g} leave -8191..8191")


def read_placements(table, objects, radii):
    """The placements of the last objects. radii: of each object's model."""
    first, placements = len(objects) - len(table), []
    for i, (*rows, scale) in enumerate(table, first):
        _check_place(objects[i].centre, scale, radii[i], f"instance {i}")
        if not _is_rotation(rows):
            fail("placement", f"instance {i}: the rows of its placement are those of no rotation")
        placements.append(Placement(tuple(rows), scale))
    return placements


def _unpack(fields, number, keys, next_key):
    """A motion and its keys, which begin at next_key."""
    *numbers, low, high, first, count, parent, repeats, reserved = fields
    if repeats > 1 or reserved or parent > number:
        fail("reserved", f"motion {number}: a flag or reserved field is not what it may be, or its parent is not "
             "before it")
    if first != next_key or not 1 <= count <= len(keys) - next_key:
        fail("index", f"motion {number}: its keys do not follow those of the motion before")
    own = [Key(frame, (x, y, z), tuple(angles), scale)
           for frame, x, y, z, *angles, scale in keys[first:first + count]]
    return Motion(own, tuple(numbers[:3]), tuple(numbers[3:6]), tuple(numbers[6:8]), numbers[8], tuple(numbers[9:11]),
                  parent, repeats, tuple(numbers[11:14]), (low, high))


def _check_own(motion, number):
    """What a motion says of itself, and its keys."""
    if any(c < 0 for c in (*motion.extent, motion.radius)) or any(c > PLACE_MAX for c in motion.place_extent()) or \
            any(abs(c) > PLACE_MAX for c in motion.axis) or not all(map(_is_scale, motion.scales)):
        fail("range", f"motion {number}: an extent, a radius, an axis or a scale is out of range")
    last = -1
    for i, key in enumerate(motion.keys):
        if (key.frame != 0 if i == 0 else key.frame <= last) or key.frame > FRAME_MAX:
            fail("index", f"key {i} of motion {number}: frame {key.frame} does not follow")
        last = key.frame
        if any(abs(c) > most for c, most in zip(key.centre, motion.extent)) or \
                not motion.scales[0] <= key.scale <= motion.scales[1]:
            fail("range", f"key {i} of motion {number} is outside what the motion says of its keys")


def _reach(scale, length):
    return (scale * length + 65535) // 65536 + SLACK


def _length(place):
    square = sum(c * c for c in place)
    root = isqrt(square)
    return root + (square - root * root > root) + 1


def _check_chain(motions, number, radius):
    """That no frame leaves the world, and no scale its range."""
    chain = [motions[number]]
    while chain[0].parent:
        chain.insert(0, motions[chain[0].parent - 1])
        if len(chain) > DEPTH_MAX + 1:
            fail("count", f"motion {number} has more than {DEPTH_MAX} parents, one after the other")
    (low, high), reach = chain[0].scales, 0
    for motion in chain[1:]:
        reach += _reach(high, _length(motion.place_extent()))
        low, high = ((scale * own + 32768) >> 16 for scale, own in zip((low, high), motion.scales))
        if low < SCALE_MIN or high > SCALE_MAX:
            fail("range", f"motion {number}: with its parents a scale of {low / 65536:.6g} or {high / 65536:.6g} is "
                 "outside 1/256..256")
    reach += _reach(high, radius)
    if max(chain[0].place_extent()) + reach > COORDINATE_MAX:
        fail("range", f"motion {number} may leave -8191..8191: it reaches "
             f"{(max(chain[0].place_extent()) + reach) / 65536:.6g}")


def read_motions(table, keys, radii):
    """The motions of the last objects. radii: of each object's model."""
    motions, next_key, radii = [], 0, radii[len(radii) - len(table):]
    for i, (fields, radius) in enumerate(zip(table, radii)):
        motions.append(_unpack(fields, i, keys, next_key))
        next_key += len(motions[-1].keys)
        _check_own(motions[-1], i)
        _check_chain(motions, i, radius)
    if next_key != len(keys):
        fail("count", f"{len(keys)} keys, but the motions have {next_key}")
    return motions
