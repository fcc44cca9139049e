# SPDX-License-Identifier: MIT
"""What the models of one build read: their files, the images of their materials, and what these name, as other computers write their names.
All models of a scene share one Sources."""

import functools
import hashlib
import os
import unicodedata
import urllib.parse

from fixel.base import reading
from fixel.base.errors import ToolError
from fixel.base.reading import Beside, quoted
from fixel.model import texture_image

_QUOTES = "\"'"
ENTRIES_MAX = 65_536    # of a folder in which a name of another case is looked for


def plain(name):
    """A name without the quotes around it, and with / between folders."""
    if len(name) > 1 and name[0] in _QUOTES and name[-1] == name[0]:
        name = name[1:-1]
    return name.replace("\\", "/")


def _folded(name):
    """What names have in common that differ by case, by how an accent is written, or by the number of blanks."""
    return " ".join(unicodedata.normalize("NFC", name).casefold().split())


@functools.lru_cache(maxsize=64)
def _entries(folder, _):
    """{what names have in common: the first of these names, in order} of a folder that was changed at this time."""
    found = {}
    with os.scandir(folder) as entries:
        for _, entry in zip(range(ENTRIES_MAX), entries):
            key = _folded(entry.name)
            found[key] = min(entry.name, found.get(key, entry.name))
    return found


def _entry(folder, name):
    """The entry of a folder whose name differs by case, accents or blanks alone; None without one. Of several the first in order."""
    folder = folder or "."
    try:
        return _entries(folder, os.stat(folder).st_mtime_ns).get(_folded(name))
    except (OSError, ValueError):
        return None


def _in_another_case(folder, name):
    """A name below a folder of which parts are written in another case; None where there is none."""
    parts = []
    for part in name.split("/"):
        if part in ("", ".", ".."):
            return None
        part = _entry(os.path.join(folder, *parts), part)
        if part is None:
            return None
        parts.append(part)
    return "/".join(parts)


def _other(folder, name):
    """The name under which a file is there that has another one: its base name beside the model, or another case. None without one."""
    base = name.rpartition("/")[2]
    if base and base != name and Beside(folder, base).exists():
        return base
    return _in_another_case(folder, name) or _in_another_case(folder, base)


def find_named(folder, name):
    """(Beside, "") of a file that is there; (Beside, what to say) of one that is there under another name: its base name
    beside the model, another case, or without the signs of an address such as %20; (None, "") without one."""
    name = plain(name)
    if name and Beside(folder, name).exists():
        return Beside(folder, name), ""
    other = _other(folder, name)
    if not other and "%" in name:
        bare = urllib.parse.unquote(name)
        other = bare if Beside(folder, bare).exists() else _other(folder, bare)
    if not other:
        return None, ""
    return Beside(folder, other), f"there is no {quoted(name)}: {quoted(other)} is read instead"


PLAIN_FACES = "The faces have the colour of their material"


def _once(known, key, make):
    """known[key], made if it is not there. What failed to be made fails again without an attempt."""
    if key not in known:
        try:
            known[key] = make()
        except ToolError as error:
            known[key] = error
    if isinstance(known[key], ToolError):
        raise known[key]
    return known[key]


class Sources:
    """Reads files, and decodes each image once, by whatever name it is asked for. unread: what is wrong with each image that cannot
    be read."""

    def __init__(self):
        self.by_path, self.by_content, self.unread = {}, {}, []

    def read(self, path, most, advice):
        """The bytes of a file of a model; one of more than so many is refused."""
        return reading.read_whole(path, most, advice)

    def image(self, obtain, notes, without=PLAIN_FACES):
        """The texture_image.Texture that obtain() answers; None, and a note, where it cannot be read. A file that may not be opened
        (reading.confine) is refused. notes: gets what there is to say. without: what is without the image."""
        found, said = None, []
        try:
            found = obtain()
            said = found.notes
        except reading.OutsideError:
            raise
        except ToolError as error:
            said = [f"{error.message}. {without}"]
            self.unread.append(error.message)
        notes += [note for note in said if note not in notes]
        return found

    def image_named(self, file, name, where):
        """The texture_image.Texture of a file that a model names. file: that of the name, None where there is none. where: for messages."""
        if file is None:
            raise ToolError(f"{where}: there is no image {quoted(name)}; the path is taken from the model's folder")
        return self.image_of_file(file, f"{where}: {file}")

    def image_of_file(self, path, where):
        """The texture_image.Texture in a file."""
        def make():
            try:
                blob = self.read(path, texture_image.FILE_MAX, "make the image smaller")
            except reading.OutsideError:
                raise
            except ToolError as error:
                raise ToolError(f"{where}: {error.message.removeprefix(f'{path}: ')}") from error
            return self.image_of_bytes(blob, where)
        return _once(self.by_path, reading.identity(path), make)

    def image_of_bytes(self, blob, where):
        """The texture_image.Texture in bytes of a file that was read already."""
        return _once(self.by_content, hashlib.sha256(blob).digest(), lambda: texture_image.decode(bytes(blob), where))
