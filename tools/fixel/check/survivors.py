# SPDX-License-Identifier: MIT
"""Mutants that change no result, with the reason of each, as a file of the project keeps them.

An entry names the file, the text of the line, the change as a mutant's name has it, and why it changes no result. One
whose line or change is no longer there is refused, so that no reason outlives what it was about.
"""

import pathlib
import tomllib

from fixel.base.errors import ToolError

KEYS = {"file", "line", "change", "reason"}


def change_of(mutant):
    """What an entry calls a mutant's change."""
    return str(mutant).partition(": ")[2]


def line_of(mutant, text):
    """The text of a mutant's line."""
    return text.split("\n")[mutant.line - 1].strip()


def load(path, checkout, mutants_of):
    """{(file, line's text, change)} of a file of survivors. mutants_of(file, text): all mutants of a file."""
    entries = tomllib.loads(pathlib.Path(path).read_text(encoding="utf-8")).get("survivors", [])
    known, there = set(), {}
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
        known.add(key)
    return known


def keys_of(checkout, file, mutants_of):
    """{(file, line's text, change)} of all mutants of a file; none where it is gone."""
    path = pathlib.Path(checkout) / file
    if not path.is_file():
        return set()
    text = path.read_text(encoding="utf-8")
    return {(file, line_of(mutant, text), change_of(mutant)) for mutant in mutants_of(file, text)}
