# SPDX-License-Identifier: MIT
"""The materials of an OBJ file's faces: mtllib and usemtl, wherever in the file they stand."""

import os

from fixel.base.reading import quoted
from fixel.model import mtl, named_file
from fixel.model.surface import MISSING_NOTE, Material, Surfaces

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
