# SPDX-License-Identifier: MIT
"""The palette of a scene that is lit at run time, and the ramp: for each colour the entries of its levels.

A colour that the light changes is (red, green, blue, 1), any other (red, green, blue), or an index that is asked for."""

import numpy as np

from fixel.scene import palette
from fixel.base.errors import ToolError

_CHUNK = 1024       # colours at a time


# light 3.3
def between(dark, full, level, top):
    """A level of a colour: dark at 0, full at top; to the nearest, halves upward, as fxl_light_make_ramp has it."""
    return tuple((2 * (a * (top - level) + b * level) + top) // (2 * top) for a, b in zip(dark, full))


class Nearest:
    """Which entry of a palette is nearest to a colour; of several the one of the lowest number."""

    def __init__(self, entries):
        self.entries = np.array(entries, dtype=np.int32)
        self.found = {}

    def of_all(self, colours):
        """The number for each of some colours."""
        missing = [colour for colour in dict.fromkeys(colours) if colour not in self.found]
        for start in range(0, len(missing), _CHUNK):
            some = missing[start:start + _CHUNK]
            away = np.array(some, dtype=np.int32)[:, None] - self.entries
            self.found.update(zip(some, (away * away).sum(axis=2).argmin(axis=1).tolist()))
        return [self.found[colour] for colour in colours]


def _merge(weights, count):
    """{colour: what is drawn for it}, of at most so many different ones."""
    return {c: c for c in weights} if len(weights) <= count else palette.median_cut(weights, count)


def _shares(plain, shaded, room):
    """How many entries each of the two gets."""
    if len(plain) + len(shaded) <= room:
        return len(plain), len(shaded)
    share = min(max(room * len(plain) // (len(plain) + len(shaded)), 1 if plain else 0), room - (1 if shaded else 0))
    return share, room - share


def _shades(weights, light, glow):
    """The colours of all levels below the top, and of what a beam makes of all levels."""
    shades, top = {}, light.levels - 1
    for colour, weight in weights.items():
        for level in range(light.levels):
            shade = between(light.dark, colour, level, top)
            for wanted in ([shade] if level < top else []) + ([glow(shade)] if glow else []):
                shades[wanted] = shades.get(wanted, 0) + weight
    return shades


# light 3.3
def _level(made, lit, nearest, shades):
    """A level of the ramp: of what is lit the entry nearest to its shade, of any other its own."""
    return [shown for _, shown in sorted({**dict(enumerate(range(len(made)))), **dict(zip(lit, nearest.of_all(shades)))}.items())]


def allocate(background, wanted, reserved, light, glow):
    """Palette, index of each wanted colour, number of colours that were merged or 0, ramp, and for each entry the one
    that it is in a beam. light has dark and levels; glow: what becomes of a colour in a beam, or None."""
    fixed = {c: n for c, n in wanted.items() if isinstance(c, int)}
    made, indices, _ = palette.allocate(background, fixed, reserved)
    end = palette.ENTRIES - len(reserved)
    free = [i for i in range(1, end) if i not in fixed]
    plain = {c: n for c, n in wanted.items() if c not in fixed and len(c) == 3}
    shaded = {c[:3]: n for c, n in wanted.items() if c not in fixed and len(c) == 4}
    if (plain or shaded) and len(free) < 2:
        raise ToolError(f"colour_index and palette.reserve use up all {palette.ENTRIES - 1} palette entries; "
                        "nothing is left for objects with colour")
    lit, merged = dict(fixed), 0

    def place(weights, count, marks=()):
        """Gives colours entries of their own; answers the entries."""
        nonlocal merged
        drawn = _merge(weights, count)
        merged += len(weights) if len(weights) > count else 0
        entries = {colour: free.pop(0) for colour in sorted(set(drawn.values()))}
        for colour, index in entries.items():
            made[index] = colour
        indices.update({(*c, *marks): entries[drawn[c]] for c in weights})
        return entries

    shares = _shares(plain, shaded, len(free))
    place(plain, shares[0])
    place(shaded, shares[1], (1,))
    for colour in shaded:
        index = indices[(*colour, 1)]
        lit[index] = lit.get(index, 0) + shaded[colour]
    shades = _shades({made[index]: n for index, n in lit.items()}, light, glow)
    for entry in made[:end]:
        shades.pop(entry, None)
    if shades and free:
        drawn = _merge(shades, len(free))
        merged += len(shades) if len(shades) > len(free) else 0
        for colour in sorted(set(drawn.values())):
            made[free.pop(0)] = colour
    nearest = Nearest(made[:end])
    top = light.levels - 1
    ramp = [_level(made, lit, nearest, [between(light.dark, made[i], level, top) for i in lit]) if level < top else
            list(range(palette.ENTRIES)) for level in range(light.levels)]
    in_beam = list(range(palette.ENTRIES))
    for i in range(end) if glow else ():
        in_beam[i], = nearest.of_all([glow(made[i])])
    return made, indices, merged, ramp, bytes(in_beam)
