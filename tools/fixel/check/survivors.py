# SPDX-License-Identifier: MIT
"""Mutants that change no result, with the reason of each, as a file of the project keeps them.

An entry names the file, the text of the line, the change as a mutant's name has it, and why it changes no result. One
whose line or change is no longer there is refused, so that no reason outlives what it was about.
"""

import hashlib
import pathlib
import tomllib

from fixel.base.errors import ToolError

KEYS = {"file", "line", "change", "reason"}


def change_of(mutant):
    """What an entry calls a mutant's change."""
    return str(mutant).partition(": ")[2]


def keyed(mutants, text):
    """[((file, line's text, change, number), mutant)] of a file's mutants: no two keys are equal. number: of those with
    the same line and change."""
    lines, found, before = text.split("\n"), [], {}
    for mutant in mutants:
        key = (mutant.file, lines[mutant.line - 1].strip(), change_of(mutant))
        before[key] = before.get(key, 0) + 1
        found.append(((*key, before[key]), mutant))
    return found


def place_of(seed, key):
    """Where the order of a seed has a mutant: a hash of its key, so that a change of one line moves no other mutant."""
    return hashlib.sha256(repr((seed, key)).encode()).digest()


def find(checkout, key, mutants_of):
    """The mutant of a key of keyed()."""
    text = (pathlib.Path(checkout) / key[0]).read_text(encoding="utf-8")
    return dict(keyed(mutants_of(key[0], text), text))[tuple(key)]


def load(path, checkout, mutants_of):
    """{(file, line's text, change): reason} of a file of survivors. mutants_of(file, text): all mutants of a file."""
    entries = tomllib.loads(pathlib.Path(path).read_text(encoding="utf-8")).get("survivors", [])
    known, there = {}, {}
    for number, entry in enumerate(entries, 1):
        if set(entry) != KEYS or not all(isinstance(value, str) and value.strip() for value in entry.values()):
            raise ToolError(f"{path}: survivor {number}: it needs {', '.join(sorted(KEYS))}, each a text")
        file = entry["file"]
        if file not in there:
            there[file] = keys_of(checkout, file, mutants_of)
        key = (file, entry["line"].strip(), entry["change"])
        if key not in there[file]:
            raise ToolError(f"{path}: survivor {number}: {file} no longer has the line '{key[1]}' with the change "
                            f"{key[2]}; look at the line, and take the entry out or write it anew")
        known[key] = entry["reason"]
    return known


def keys_of(checkout, file, mutants_of):
    """{(file, line's text, change)} of all mutants of a file; none where it is gone."""
    path = pathlib.Path(checkout) / file
    if not path.is_file():
        return set()
    text = path.read_text(encoding="utf-8")
    return {key[:3] for key, _ in keyed(mutants_of(file, text), text)}
