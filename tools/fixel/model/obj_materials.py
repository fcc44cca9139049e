# SPDX-License-Identifier: MIT
"""What stands behind the faces of an OBJ file: their materials by mtllib and usemtl, wherever in the file they stand, and the colours of its
vertices, behind x, y, z or in comments as ZBrush writes them.

Three numbers are red, green and blue, of 0..1 or of 0..255. Four are these and alpha, or w, red, green and blue."""

import os
import re

from fixel.base.errors import ToolError
from fixel.base.reading import quoted
from fixel.model import model_text, mtl
from fixel.model.surface import GREY, MEAN_NOTE, MISSING_NOTE, Material, Surfaces, WHITE, mean_tint

LIBRARIES_MAX = 256         # of a file
_WORDS_MAX = 64             # of one mtllib
_MISSING_MAX = 4            # that a note names
_SUFFIX = ".mtl"


def _plain(name):
    """A name without the comment behind it."""
    return name.split(" #", 1)[0]


class Materials:
    """What usemtl and mtllib of a file say."""

    def __init__(self, path, name, sources):
        folder, file = os.path.split(os.fspath(path))
        self.reader, self.name, self.own = mtl.Reader(folder, sources), name, os.path.splitext(file)[0] + _SUFFIX
        self.libraries, self.missing, self.notes, self.too_many = set(), {}, [], None
        self.faces, self.names, self.used, self.current = [], {}, 0, None

    @property
    def are_known(self):
        """Whether there are materials."""
        return bool(self.reader.materials)

    def _names(self, words):
        """The names of files: each is as many words as make one that is there, else those up to one that ends in .mtl."""
        found, at = [], 0
        while at < len(words):
            ends = [end for end in range(len(words), at, -1) if self.reader.exists(" ".join(words[at:end]))]
            ends += [end for end in range(at + 1, len(words) + 1) if words[end - 1].strip("\"'").lower().endswith(_SUFFIX)]
            end = ends[0] if ends else len(words)
            found.append(" ".join(words[at:end]))
            at = end
        return found

    def library(self, words, where):
        """mtllib: the names of files, which may have blanks."""
        named = tuple(words[:_WORDS_MAX])
        if len(words) > _WORDS_MAX or (len(self.libraries) >= LIBRARIES_MAX and named not in self.libraries):
            self.too_many = self.too_many or where
        if not words or named in self.libraries or len(self.libraries) >= LIBRARIES_MAX:
            return
        self.libraries.add(named)
        for each in self._names(named):
            if self.reader.exists(each):
                self.reader.read(each, where)
            else:
                self.missing.setdefault(each, where)

    def use(self, words, where):
        """usemtl: the material of the faces from here on."""
        self.current = " ".join(words) or None
        self.names.setdefault(self.current, where)
        self.used += 1

    def add(self, coordinates, bare):
        """One more face with these texture coordinates, None where a corner has none. bare: it names some that do not
        exist."""
        self.faces.append((self.current, coordinates, bare))

    def _read_own(self):
        """Reads the materials that have the model's name, where no others are there and it names some."""
        if self.are_known or not (self.missing or self.used) or not self.reader.exists(self.own):
            return
        said = f"{self.name}: there is no {quoted(next(iter(self.missing)))}" if self.missing else f"{self.name}: no mtllib is named"
        self.notes.append(f"{said}: {quoted(self.own)}, which has the model's name, is read instead")
        self.missing = {}
        self.reader.read(self.own, self.name)

    def _material(self, name):
        """The material of a name; None without one."""
        known = self.reader.materials
        return None if name is None else known.get(name) or known.get(_plain(name))

    def result(self):
        """(the Surfaces of all faces, notes)."""
        self._read_own()
        made, numbers, unknown, bare_ones = Surfaces(), {}, [], 0
        materials = {name: self._material(name) for name in {None, *self.names}}
        for name, coordinates, bare in self.faces:
            material = materials[name]
            if material is None and name is not None:
                unknown.append(name)
            key = id(material)
            if key not in numbers:
                numbers[key] = len(made.materials)
                made.materials.append(material or Material("none"))
            if material and material.image:
                bare_ones += bare
                if material.moves and coordinates:
                    coordinates = [material.moves(*each) for each in coordinates]
            made.add(numbers[key], coordinates)
        return made, self.reader.notes + self.notes + self._notes(unknown, bare_ones) + self._seen(made)

    def _notes(self, unknown, bare):
        notes = []
        if self.too_many:
            notes.append(f"{self.too_many}: left out what is behind {_WORDS_MAX} words of an mtllib, or {LIBRARIES_MAX} different ones: take out "
                         "what is not used")
        if self.missing:
            shown = ", ".join(map(quoted, list(self.missing)[:_MISSING_MAX])) + (
                f" and {len(self.missing) - _MISSING_MAX:,} others" if len(self.missing) > _MISSING_MAX else "")
            notes.append(f"{next(iter(self.missing.values()))}: there is no {shown}: {MISSING_NOTE}")
        if unknown and self.are_known:
            notes.append(f"{self.name}: faces whose material no mtllib has: {len(unknown):,} (first: {quoted(unknown[0])}, "
                         f"{self.names[unknown[0]]})")
        if bare:
            notes.append(f"{self.name}: faces that name a vt that does not exist, and show their colour instead of an image: {bare:,}")
        return notes

    def _seen(self, made):
        """A note where all faces would be wholly transparent: they are drawn opaque."""
        if any(round(16 * material.opacity) for material in made.materials):
            return []
        for material in made.materials:
            material.opacity = 1.0
        return [f"{self.name}: the materials of all faces are wholly transparent: all are drawn opaque"]


_NO_NUMBER = re.compile(r"[+-]?(nan(\(\w*\))?|inf|infinity|1\.#\w+)", re.IGNORECASE)     # as programs write what is none
_PAINT = re.compile(r"#MRGB\s+((?:[0-9A-Fa-f]{8})+)")      # a mask, red, green and blue of each vertex in turn
_WRITTEN = 3        # numbers of a colour


def _scaled(colour, most):
    """A vertex's colour, 0..255. most: what stands for full brightness in the file."""
    return tuple(round(255 * min(max(part / most, 0), 1)) for part in colour)


def _tint(found):
    """What a face's colour is multiplied by: the mean of its vertices' colours; None where it is white."""
    mean = mean_tint(found)
    return None if mean == WHITE else mean


class Colours:
    """name: of the file, for messages."""

    def __init__(self, name):
        self.name, self.found, self.paint, self.wrong = name, [], [], (0, None)

    def add(self, words, where):
        """One more vertex. words: what stands behind its x, y and z."""
        if len(words) < _WRITTEN:
            self.found.append(None)
            return
        words = words[:_WRITTEN + 1]
        try:
            self.found.append(tuple(map(model_text.decimal, words)))
        except ValueError:
            if not all(model_text.is_decimal(word) or _NO_NUMBER.fullmatch(word) for word in words):
                raise ToolError(f"{where}: {quoted(' '.join(words))} is no colour of a vertex") from None
            self.found.append(None)
            self.wrong = self.wrong[0] + 1, self.wrong[1] or where

    def comment(self, line):
        """A line that is a comment."""
        paint = _PAINT.fullmatch(line)
        if paint:
            numbers = bytes.fromhex(paint[1])
            self.paint += [tuple(numbers[at + 1:at + 4]) for at in range(0, len(numbers), 4)]

    def _written(self):
        """(the colour of each vertex as it is written, what stands for full brightness, whether alpha is left out)."""
        if self.paint and not any(self.found):
            return [*self.paint, *[None] * len(self.found)][:len(self.found)], 255, False
        longer = [colour for colour in self.found if colour and len(colour) > _WRITTEN]
        most = 255 if any(max(colour) > 1 for colour in self.found if colour) else 1
        has_weight = all(colour[0] == 1 for colour in longer) and any(colour[-1] != most for colour in longer)
        return [colour and (colour[1:] if has_weight and len(colour) > _WRITTEN else colour[:_WRITTEN]) for colour in self.found], most, \
            not has_weight and any(colour[-1] < most for colour in longer)

    def tint(self, surfaces, faces, has_materials):
        """Multiplies the colours of faces by those of their vertices: (whether there are some, notes)."""
        colours, most, is_clear = self._written()
        notes = [f"{self.name}: colours of vertices that are no numbers: {self.wrong[0]:,} (first: {self.wrong[1]})"] if self.wrong[0] else []
        if not any(colours):
            return False, notes
        # One without a colour is as all would be without: white times the material, or grey.
        bare = WHITE if has_materials else GREY
        scaled = [_scaled(colour, most) if colour else bare for colour in colours]
        without = sum(colours[corner] is None for corner in {corner for face in faces for corner in face})
        if without:
            notes.append(f"{self.name}: vertices without a colour beside those with one: {without:,}, which are {'white' if has_materials else 'grey'}")
        surfaces.tints = [_tint([scaled[corner] for corner in face]) for face in faces]
        surfaces.give_corners([[scaled[corner] for corner in face] for face in faces])
        surfaces.has_materials = has_materials
        if not has_materials:   # the vertices' colours are the faces'
            surfaces.materials = [Material(each.name, WHITE) for each in surfaces.materials]
        if is_clear:
            notes.append(f"{self.name}: left out alpha of the colours: every face is opaque")
        return True, [f"{self.name}: {MEAN_NOTE}", *notes]
