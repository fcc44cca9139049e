# SPDX-License-Identifier: MIT
"""Files that a model or a material names, as other computers write their names."""

import functools
import os
import unicodedata
import urllib.parse

from fixel.base.reading import Beside, quoted

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


def find(folder, name):
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
