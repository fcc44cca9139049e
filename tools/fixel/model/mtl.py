# SPDX-License-Identifier: MIT
"""Reading the materials of Wavefront OBJ files: newmtl, Kd, Ke, map_Kd, map_d, d and Tr of an MTL file.

Tr is transparency, and some programs write the opacity there. The one or the other is chosen for a whole file
(_means_opacity), and said."""

from dataclasses import dataclass, field, replace

import numpy as np

from fixel.base import reading
from fixel.base.errors import ToolError
from fixel.base.notes import Usual
from fixel.base.reading import quoted
from fixel.model import model_text
from fixel.model.sources import PLAIN_FACES, find_named, plain
from fixel.model.surface import GREY, Material, WHITE
from fixel.model.texture_image import Texture

FILE_MAX = 1 << 20          # bytes
MATERIALS_MAX = 4096
_NAME_WORDS_MAX = 16        # of a name, and what stands before it
_OPTIONS_READ = {"-o", "-s", "-clamp"}
_WORDS = {"-blendu": 1, "-blendv": 1, "-cc": 1, "-clamp": 1, "-texres": 1, "-bm": 1, "-boost": 1, "-imfchan": 1, "-mm": 2,
          "-type": 1}
_ON = "on"
_NUMBERS = {"-o": 0.0, "-s": 1.0, "-t": 0.0}    # up to three of them, and what those left out are
# What statements do that are not read: what most files have, and others.
_USUAL = {"Ka": "a colour in light from everywhere", "Ks": "the colour of highlights", "Ns": "how small highlights are", "Ni": "how glass bends light",
          "illum": "which kinds of light count", "Tf": "the colour of light through it", "sharpness": "how sharp reflections are",
          "Pr": "how rough it is", "Pm": "how metallic it is", "Ps": "sheen", "Pc": "a clear coat", "Pcr": "how rough a clear coat is",
          "aniso": "highlights in one direction", "anisor": "the direction of highlights"}
_OTHERS = {**dict.fromkeys(("map_Bump", "map_bump", "bump", "norm", "map_Kn"), "bumps of the surface"), "disp": "moves the surface",
           "refl": "an image of what it mirrors", "decal": "an image over the others", "map_Ka": "an image of light from everywhere",
           "map_Ks": "an image of highlights", "map_Ns": "an image of how small highlights are", "map_Ke": "an image of what shines by itself",
           "map_Pr": "an image of roughness", "map_Pm": "an image of metal", "map_aat": "smooth edges of images"}
_READ = {word.lower(): word for word in ("newmtl", "Kd", "map_Kd", "map_d", "Ke", "d", "Tr")}      # in any case


def _number(words, where, what):
    try:
        return model_text.decimal(words[0])
    except (IndexError, ValueError):
        raise ToolError(f"{where}: {what} needs a number, found {quoted(words[0] if words else '')}") from None


def _share(value):
    return min(max(value, 0.0), 1.0)


def _colour(words, where, what="Kd"):
    """Red, green and blue as they are written."""
    if words[:1] in (["spectral"], ["xyz"]):
        raise ToolError(f"{where}: {what} {words[0]} is not read; give red, green and blue")
    parts = [_number(words[i:i + 1], where, what) for i in range(3 if len(words) > 1 else 1)]
    return tuple((parts * 3)[:3])


def _scaled(colour, most=1):
    """A colour of 0..255. most: what stands for full brightness in the file."""
    return tuple(round(255 * _share(part / most)) for part in colour)


def _brightness(entries):
    """What stands for full brightness in the Kd of a file: 255 where all are whole numbers and some are larger than 1."""
    parts = [part for entry in entries for part in entry.colour or ()]
    return 255 if max(parts, default=0) > 1 and all(part == int(part) for part in parts) else 1


def _numbers(words, least):
    """(three numbers that words begin with, how many there are). least: what those left out are."""
    found = []
    for word in words[:3]:
        if not model_text.is_decimal(word):
            break
        found.append(model_text.decimal(word))
    return found + [least] * (3 - len(found)), len(found)


def _options(words):
    """({option: its numbers or words}, the words of the file's name) of a map; options stand before or behind the name."""
    place, found, name = 0, {}, []
    while place < len(words):
        option = words[place]
        place += 1
        if option in _NUMBERS:
            found[option], count = _numbers(words[place:place + 3], _NUMBERS[option])
        elif option in _WORDS:
            count = _WORDS[option]
            found[option] = words[place:place + count]
        else:
            name.append(option)
            count = 0
        place += count
    return found, name


def _moves(options):
    """What -s and -o of a map make of a face's coordinates; None where they leave them as they are."""
    (along, up, _), (right, above, _) = options.get("-s", [1.0] * 3), options.get("-o", [0.0] * 3)
    if (along, up, right, above) == (1, 1, 0, 0):
        return None
    # v is downward here, and upward in the file.
    return lambda u, v: (u * along + right, 1 - ((1 - v) * up + above))


class Reader:
    """Reads the MTL files of one OBJ file, each once. sources: where their bytes and images come from. notes: what there
    is to say about them."""

    def __init__(self, folder, sources):
        self.folder, self.sources, self.materials = folder, sources, {}
        self.known, self.images, self.done = {}, {}, set()  # by name the file and what to say; its image; what was read
        self.notes, self.left_out = [], model_text.LeftOut()

    def _find(self, name):
        if name not in self.known:
            self.known[name] = find_named(self.folder, name)
        return self.known[name]

    def _image(self, name, where, without):
        """The image of a name, None where there is no such file or it cannot be read. without: what there is to say then."""
        if name not in self.images:
            file, said = self._find(name)
            if said:
                self.notes.append(f"{where}: {said}")
            self.images[name] = self.sources.image(lambda: self.sources.image_named(file, name, where), self.notes, without)
        return self.images[name]

    def exists(self, name):
        """Whether there is a file of this name."""
        return self._find(name)[0] is not None

    def read(self, name, where):
        """Adds the materials of a file to self.materials, by name. One that was read already adds nothing. where: what
        names it."""
        if name in self.done:
            return
        file, said = self._find(name)
        known = {name, reading.identity(file)}
        is_new = not known & self.done
        self.done |= known
        if is_new:
            self.notes += [f"{where}: {said}"] if said else []
            self._read(file)

    def _read(self, file):
        blob = self.sources.read(file, FILE_MAX, "take out what the model does not use")
        current, begun, left_out = None, [], model_text.LeftOut()
        for number, line in model_text.statements(blob):
            word, *rest = line.split("#", 1)[0].split() or [""]
            word, where = _READ.get(word.lower(), word), f"{file}:{number}"
            if word == "newmtl":
                current = _Entry(" ".join(line.split()[1:]))
                begun.append(current)
                if len(self.materials) + len(begun) > MATERIALS_MAX:
                    raise ToolError(f"{where}: more than {MATERIALS_MAX:,} materials; take out what is not used")
            elif word in _READ.values():
                if current is None:
                    raise ToolError(f"{where}: {word} stands before the first newmtl")
                self._statement(current, word, model_text.words_of(line)[1:] if word.startswith("map_") else rest, where, left_out)
            elif word:
                left_out.add(word, where)
        self._finish(begun, file, left_out)
        usual = left_out.taken(_USUAL)
        self.notes += [*map(Usual, usual.notes(file, "ignored", meanings=_USUAL)), *left_out.notes(file, "ignored", meanings=_OTHERS)]

    def _statement(self, entry, word, rest, where, left_out):
        if word == "Kd":
            entry.colour = _colour(rest, where)
        elif word == "Ke":
            entry.glow, entry.glow_where = _scaled(_colour(rest, where, "Ke")), where
        elif word == "map_Kd":
            entry.map = self._map(word, rest, where, left_out, PLAIN_FACES)
        elif word == "map_d":
            entry.mask, entry.mask_where = self._map(word, rest, where, left_out, "Nothing is cut out of the faces"), where
        elif word == "d":
            entry.d = _share(_number(rest[1:] if rest[:1] == ["-halo"] else rest, where, word))
        else:
            entry.tr = _share(_number(rest, where, word))

    def _map(self, word, rest, where, left_out, without):
        """The _Map of a material: its options, and the name of a file, which may have blanks."""
        options, name = ({}, rest) if self.exists(" ".join(rest)) else _options(rest)
        if not name:
            raise ToolError(f"{where}: {word} names no file")
        for option in options:
            if option not in _OPTIONS_READ:
                left_out.add(option, where)
        known = self._known(name)
        if len(known) < len(name):
            left_out.add(name[0], where)
        lies = {option: options[option] for option in ("-s", "-o") if option in options}
        return _Map(self._image(plain(" ".join(known)), where, without), lies, options.get("-clamp") == [_ON])

    def _known(self, words):
        """The words of a name; only the last ones if there is a file of these, and options that nobody knows stand before them."""
        last = range(1, min(len(words), _NAME_WORDS_MAX)) if words[0].startswith("-") and not self.exists(" ".join(words)) else ()
        return next((words[place:] for place in last if self.exists(" ".join(words[place:]))), words)

    def _finish(self, entries, file, left_out):
        """Makes materials of what a file says."""
        means_opacity = _means_opacity(entries)
        if means_opacity:
            self.notes.append(f"{file}: Tr is read as the opacity, as which the material {quoted(means_opacity)} has it")
        opacities = [entry.opacity(bool(means_opacity)) for entry in entries]
        if opacities and not any(opacities):
            self.notes.append(f"{file}: every material is wholly transparent: all are drawn opaque")
            opacities = [1.0] * len(opacities)
        most = _brightness(entries)
        if most > 1:
            self.notes.append(f"{file}: Kd is read as 0..255: all are whole numbers, and some are larger than 1")
        for entry, opacity in zip(entries, opacities):
            colour = _scaled(entry.colour, most) if entry.colour else WHITE if entry.map.image else GREY
            if entry.map.image and colour == (0, 0, 0):
                self.notes.append(f"{file}: the material {quoted(entry.name)} has an image and is black: the image is shown as it is")
                colour = WHITE
            if entry.map.image and any(entry.glow):
                left_out.add("Ke beside an image", entry.glow_where)
            elif any(entry.glow):
                entry.is_unlit = colour == (0, 0, 0)
                colour = tuple(min(255, a + b) for a, b in zip(colour, entry.glow))
            shown = entry.cut(left_out)
            self.materials[entry.name] = Material(entry.name, colour, opacity, shown.image, _moves(shown.lies), shown.clamps, entry.is_unlit)
            if " #" in entry.name:      # a comment, or a part of the name: usemtl says which
                self.materials.setdefault(entry.name.split(" #", 1)[0], self.materials[entry.name])


@dataclass
class _Map:
    """An image of a material: the image, or None; the options by which it lies on faces; whether it clamps."""
    image: object = None
    lies: dict = field(default_factory=dict)
    clamps: bool = False


class _Entry:
    """A material as a file says it."""

    def __init__(self, name):
        self.name, self.colour, self.map, self.mask, self.d, self.tr = name, None, _Map(), _Map(), None, None
        self.glow, self.glow_where, self.mask_where, self.is_unlit = (0, 0, 0), None, None, False

    def cut(self, left_out):
        """The _Map that shows: that of map_Kd, or white, without what map_d cuts out."""
        if self.mask.image is None:
            return self.map
        if self.map.image is None:
            white = Texture(self.mask.image.name, np.full((1, 1, 4), 255, dtype=np.uint8))
            return _Map(white.cut(self.mask.image), self.mask.lies, self.mask.clamps)
        if (self.map.lies, self.map.clamps) != (self.mask.lies, self.mask.clamps):
            left_out.add("map_d that does not lie as map_Kd does", self.mask_where)
            return self.map
        return replace(self.map, image=self.map.image.cut(self.mask.image))

    def opacity(self, tr_is_opacity):
        """0..1. d goes before Tr."""
        if self.d is not None:
            return self.d
        if self.tr is None:
            return 1.0
        return self.tr if tr_is_opacity else 1 - self.tr


def _means_opacity(entries):
    """The name of a material by which Tr of a file can only be the opacity: one that would be invisible, or whose d is the
    same; None without one."""
    for entry in entries:
        if entry.tr is not None and (entry.tr == 1 if entry.d is None else entry.d == entry.tr != 0.5):
            return entry.name
    return None
