# SPDX-License-Identifier: MIT
"""Colours of the vertices of an OBJ file: what stands behind x, y, z, or in comments as ZBrush writes them.

Three numbers are red, green and blue, of 0..1 or of 0..255. Four are these and alpha, or w, red, green and blue."""

import re

from fixel.base.errors import ToolError
from fixel.base.reading import quoted
from fixel.model import number_text
from fixel.model.surface import GREY, MEAN_NOTE, WHITE, Material, mean_tint

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
            self.found.append(tuple(map(number_text.decimal, words)))
        except ValueError:
            if not all(number_text.is_decimal(word) or _NO_NUMBER.fullmatch(word) for word in words):
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
