# SPDX-License-Identifier: MIT
"""Reading the materials of Wavefront OBJ files: newmtl, Kd, map_Kd, d and Tr of an MTL file."""

from fixel.base import reading
from fixel.base.errors import ToolError
from fixel.base.reading import Beside, quoted
from fixel.model import number_text
from fixel.model.surface import Material

FILE_MAX = 1 << 20          # bytes
MATERIALS_MAX = 4096
_OPTIONS = {"-blendu": 1, "-blendv": 1, "-cc": 1, "-clamp": 1, "-texres": 1, "-bm": 1, "-boost": 1, "-imfchan": 1,
            "-mm": 2, "-o": 3, "-s": 3, "-t": 3}


def _number(words, where, what):
    try:
        value = number_text.decimal(words[0])
    except (IndexError, ValueError):
        raise ToolError(f"{where}: {what} needs a number, found {quoted(words[0] if words else '')}") from None
    return min(max(value, 0.0), 1.0)


def _colour(words, where):
    if words[:1] in (["spectral"], ["xyz"]):
        raise ToolError(f"{where}: Kd {words[0]} is not read; give red, green and blue")
    parts = [_number(words[i:i + 1], where, "Kd") for i in range(3 if len(words) > 1 else 1)]
    return tuple(round(255 * part) for part in (parts * 3)[:3])


def _image_name(words, where):
    """The file's name, which stands behind the options and may have blanks."""
    place = 0
    while place < len(words) and words[place] in _OPTIONS:
        place += 1 + _OPTIONS[words[place]]
    if place >= len(words):
        raise ToolError(f"{where}: map_Kd names no file")
    return " ".join(words[place:]).replace("\\", "/")


class Reader:
    """Reads the MTL files of one OBJ file, each once. sources: where their bytes and images come from."""

    def __init__(self, folder, sources):
        self.folder, self.sources, self.materials = folder, sources, {}
        self.known, self.images, self.done = {}, {}, set()  # by name whether there is such a file, its image; what was read

    def _image(self, name, where):
        if name not in self.images:
            self.images[name] = self._read_image(name, where)
        return self.images[name]

    def _read_image(self, name, where):
        file = Beside(self.folder, name)
        if not file.exists():
            raise ToolError(f"{where}: there is no image {quoted(name)}; the path is taken from the model's folder. "
                            "Put the image there, or take map_Kd out")
        return self.sources.image_of_file(file, f"{where}: {file}")

    def exists(self, name):
        """Whether there is a file of this name."""
        if name not in self.known:
            self.known[name] = bool(name) and Beside(self.folder, name).exists()
        return self.known[name]

    def read(self, name):
        """Adds the materials of a file to self.materials, by name. One that was read already adds nothing."""
        if name in self.done:
            return
        file = Beside(self.folder, name)
        known = {name, reading.identity(file)}
        if known & self.done:
            self.done |= known
            return
        self.done |= known
        blob = self.sources.read(file, FILE_MAX, "take out what the model does not use")
        current = None
        for number, line in enumerate(blob.decode("utf-8", "replace").splitlines(), 1):
            word, *rest = line.split("#", 1)[0].split() or [""]
            where = f"{file}:{number}"
            if word == "newmtl":
                current = Material(" ".join(rest))
                self.materials[current.name] = current
                if len(self.materials) > MATERIALS_MAX:
                    raise ToolError(f"{where}: more than {MATERIALS_MAX:,} materials; take out what is not used")
            elif word in ("Kd", "map_Kd", "d", "Tr") and current is None:
                raise ToolError(f"{where}: {word} stands before the first newmtl")
            elif word == "Kd":
                current.colour = _colour(rest, where)
            elif word == "map_Kd":
                current.image = self._image(_image_name(rest, where), where)
            elif word in ("d", "Tr"):
                value = _number(rest[1:] if rest[:1] == ["-halo"] else rest, where, word)
                current.opacity = value if word == "d" else 1 - value
