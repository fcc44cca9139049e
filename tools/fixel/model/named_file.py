# SPDX-License-Identifier: MIT
"""Files that a model or a material names, as other computers write their names."""

import os

from fixel.base.reading import Beside, quoted

_QUOTES = "\"'"
ENTRIES_MAX = 65_536    # of a folder in which a name of another case is looked for


def plain(name):
    """A name without the quotes around it, and with / between folders."""
    if len(name) > 1 and name[0] in _QUOTES and name[-1] == name[0]:
        name = name[1:-1]
    return name.replace("\\", "/")


def _entry(folder, name):
    """The entry of a folder whose name differs by case alone; None without one. Of several the first in order."""
    wanted, found = name.casefold(), []
    try:
        with os.scandir(folder or ".") as entries:
            for _, entry in zip(range(ENTRIES_MAX), entries):
                if entry.name.casefold() == wanted:
                    found.append(entry.name)
    except (OSError, ValueError):
        return None
    return min(found, default=None)


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


def find(folder, name):
    """(Beside, "") of a file that is there; (Beside, what to say) of one that is there under another name: its base name
    beside the model, or another case; (None, "") without one."""
    name = plain(name)
    if name and Beside(folder, name).exists():
        return Beside(folder, name), ""
    base = name.rpartition("/")[2]
    if base and base != name and Beside(folder, base).exists():
        other = base
    else:
        other = _in_another_case(folder, name) or _in_another_case(folder, base)
    if not base or not other:
        return None, ""
    return Beside(folder, other), f"there is no {quoted(name)}: {quoted(other)} is read instead"
