# SPDX-License-Identifier: MIT
"""Colours: names, baked light, and 256 palette entries for all of them; of a scene that is lit at run time also the ramp, for each colour
the entries of its levels.

A colour that the light at run time changes is (red, green, blue, 1), any other (red, green, blue), or an index that is asked for."""

import colorsys
import difflib
import re

import numpy as np
from PIL import ImageColor

from fixel.base.errors import ToolError
from fixel.base.reading import QUOTE_MAX, quoted

ENTRIES = 256


def parse(value, where):
    """"#rgb", "#rrggbb" or a CSS name as (red, green, blue)."""
    if isinstance(value, str):
        if re.fullmatch(r"#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})", value):
            return ImageColor.getrgb(value)[:3]
        name = value.lower()
        if name in ImageColor.colormap:
            return ImageColor.getrgb(name)[:3]
        near = difflib.get_close_matches(name[:QUOTE_MAX], ImageColor.colormap, 1)
        hint = f'; did you mean "{near[0]}"?' if near else ""
        raise ToolError(f'{where}: {quoted(value)} is not a colour (like "#d8a050" or "teal"){hint}')
    raise ToolError(f'{where}: expected a colour like "#d8a050" or "teal", found {quoted(value)}')


# place pixel-format: a colour of the format
def rgb565(colour):
    """Red, green, blue of 0..255 as a colour of RGB565, whose lower bits are lost."""
    red, green, blue = colour
    return red >> 3 << 11 | green >> 2 << 5 | blue >> 3


def wheel(index):
    """A colour of its own for a palette index that a scene asks for by number."""
    hue = index * 0.6180339887498949 % 1.0
    value = (0.95, 0.80, 0.65)[index % 3]
    return tuple(round(255 * c) for c in colorsys.hsv_to_rgb(hue, 0.55, value))


class Light:
    """One far light and an even glow. direction is the way the light travels. bakes_all: it changes the colours of textures
    however many directions their faces look in."""

    def __init__(self, direction, ambient, colour, sky, bakes_all=False):
        self.bakes_all = bakes_all
        length = sum(c * c for c in direction) ** 0.5
        self.direction = [c / length for c in direction]
        self.ambient = ambient
        self.colour = [c / 255 for c in colour]
        self.sky = [c / 255 for c in sky]

    def bake(self, colour, normal):
        """The colour of a face with this normal (2.30). The light falls off as
        (1 + cosine)/2 to the power of 1.5, so that sides turned from it keep their
        shape; the glow comes from above, and a face that looks down gets three
        quarters of it."""
        (x, y, z), (u, v, w) = self.direction, normal
        facing = -(x * u + y * v + z * w) / 2 ** 30
        glow = self.ambient * (0.875 + 0.125 * v / 2 ** 30)
        direct = (1 - self.ambient) * max(0.0, (1 + facing) / 2) ** 1.5
        # Written out: every face comes here.
        (red, green, blue), (a, b, c), (d, e, f) = colour, self.sky, self.colour
        red, green, blue = (round(red * (glow * a + direct * d)), round(green * (glow * b + direct * e)),
                            round(blue * (glow * c + direct * f)))
        return (min(255, max(0, red)), min(255, max(0, green)), min(255, max(0, blue)))


def lit(colour, strength, tint):
    """A baked colour in a beam of light: what it sends back of the light comes to it."""
    return tuple(min(255, round(c * (1 + strength * t / 255))) for c, t in zip(colour, tint))


def median_cut(weights, count):
    """Distinct colours merged into count groups: {colour: group's mean}."""
    ordered = sorted(weights)
    colours = np.array(ordered)
    groups = [np.arange(len(ordered))]      # numbers of colours in their order
    spreads = [np.ptp(colours, axis=0).tolist()]
    while len(groups) < count:
        widest = max(range(len(groups)), key=lambda i: (max(spreads[i]), len(groups[i]), -i))
        group, ranges = groups.pop(widest), spreads.pop(widest)
        values = colours[group, ranges.index(max(ranges))]
        is_low = 2 * values <= values.min() + values.max()
        groups += [group[is_low], group[~is_low]]
        spreads += [np.ptp(colours[half], axis=0).tolist() for half in groups[-2:]]
    merged = {}
    heavy = np.array([weights[colour] for colour in ordered])
    for group in groups:
        total = int(heavy[group].sum())
        sums = (heavy[group, None] * colours[group]).sum(axis=0)
        merged.update(dict.fromkeys((ordered[number] for number in group.tolist()), tuple(round(int(each) / total) for each in sums)))
    return merged


def allocate(background, wanted, reserved=()):
    """Palette and index of each wanted colour. wanted counts faces by colour:
    an int is a palette index asked for, a tuple is red, green, blue. reserved:
    the colours of the last entries, which no face gets. Answers
    (palette, {colour: index}, number of distinct baked colours that were
    merged with others, or 0)."""
    fixed = {c for c in wanted if isinstance(c, int)}
    baked = {c: n for c, n in wanted.items() if not isinstance(c, int)}
    end = ENTRIES - len(reserved)
    palette = [background] + [(0, 0, 0)] * (end - 1) + list(reserved)
    for index in fixed - {0}:
        if index >= end:
            raise ToolError(f"colour_index {index} is one of the entries {end}..{ENTRIES - 1} that palette.reserve "
                            "keeps for the program")
        palette[index] = wheel(index)
    free = [i for i in range(1, end) if i not in fixed]
    if baked and not free:
        raise ToolError(f"colour_index and palette.reserve use up all {ENTRIES - 1} palette entries; "
                        "nothing is left for objects with colour")
    merged = {c: c for c in baked}
    if len(baked) > len(free):
        merged = median_cut(baked, len(free))
    entries = {mean: free[i] for i, mean in enumerate(sorted(set(merged.values())))}
    for mean, index in entries.items():
        palette[index] = mean
    indices = {c: entries[merged[c]] for c in baked}
    indices.update({i: i for i in fixed})
    return palette, indices, len(baked) if len(baked) > len(free) else 0


_CHUNK = 1024       # colours at a time


# place light: between: the formula of fxl_mix_colours in the tools; Light.bake: light that the tools bake into colours
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
    return {c: c for c in weights} if len(weights) <= count else median_cut(weights, count)


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


def allocate_lit(background, wanted, reserved, light, glow):
    """Palette, index of each wanted colour, number of colours that were merged or 0, ramp, and for each entry the one
    that it is in a beam. light has dark and levels; glow: what becomes of a colour in a beam, or None."""
    fixed = {c: n for c, n in wanted.items() if isinstance(c, int)}
    made, indices, _ = allocate(background, fixed, reserved)
    end = ENTRIES - len(reserved)
    free = [i for i in range(1, end) if i not in fixed]
    plain = {c: n for c, n in wanted.items() if c not in fixed and len(c) == 3}
    shaded = {c[:3]: n for c, n in wanted.items() if c not in fixed and len(c) == 4}
    if (plain or shaded) and len(free) < 2:
        raise ToolError(f"colour_index and palette.reserve use up all {ENTRIES - 1} palette entries; "
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
            list(range(ENTRIES)) for level in range(light.levels)]
    in_beam = list(range(ENTRIES))
    for i in range(end) if glow else ():
        in_beam[i], = nearest.of_all([glow(made[i])])
    return made, indices, merged, ramp, bytes(in_beam)
