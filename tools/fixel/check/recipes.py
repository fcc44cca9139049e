# SPDX-License-Identifier: MIT
"""The recipes of CONTRIBUTING.md, as text: their commands, and the places that they name.

A recipe begins with its commands, git grep -lE '...'. Each file that a command finds must be named: in the second column of a
table, or in the paragraph "Not places:". A name is a path from the checkout, or stands after its folder; * is any text.
"""

import fnmatch
import pathlib
import re
import shlex

from fixel.base import children
from fixel.base.errors import ToolError

ROOT = pathlib.Path(__file__).resolve().parents[3]
COMMAND = re.compile(r"`(git grep -lE '[^'`]*'(?: -- [^`]*)?)`")
NAME = re.compile(r"`((?:[\w*-]+/)*(?:[\w*.-]+\.(?:c|h|S|py|toml|md|mk|txt|ld|rs)|[\w-]+\*|Makefile)|(?:[\w-]+/)+)`|\]\(([\w./-]+)\)")
# What no recipe names, though its command may find it: a pattern of files, and why. The text above the recipes says the same.
NEVER_PLACES = {
    "CONTRIBUTING.md": "the recipes themselves",
    "CHANGELOG.md": "the past, which stays as it was",
    "*.json": "records, which commands write",
    "host_tests/unit/uncovered.toml": "quotes of conditions of the library; make coverage names those that a change breaks",
    "host_tests/breaks/*": "quotes of lines of the library; test_seeded_bugs.py names those that a change breaks",
    "host_tests/build/trace/*": "ids and first words of clauses; make trace names those that a change breaks",
    "host_tests/proofs/*": "names of functions, and proofs of them; make prove names those that a change breaks",
    "tools/fixel/prove/*": "it unwinds loops, and no polygons",
}


def section(folder=ROOT):
    """The text of the recipes."""
    text = (folder / "CONTRIBUTING.md").read_text(encoding="utf-8")
    return text.split("\n## Recipes\n", 1)[1].split("\n## ", 1)[0]


def recipes(folder=ROOT):
    """{the title of a recipe, or of a part of it that has a command of its own: its text}."""
    found = {}
    for text in re.split(r"^### ", section(folder), flags=re.MULTILINE)[1:]:
        title, text = text.split("\n", 1)
        parts = re.split(r"^#### ", text, flags=re.MULTILINE)
        found[title] = parts[0]
        for part in parts[1:]:
            heading, text = part.split("\n", 1)
            found[f"{title}: {heading}"] = text
    return {title: text for title, text in found.items() if COMMAND.search(text)}


def commands(text):
    """The commands of a recipe."""
    return COMMAND.findall(text)


def listed(*arguments, folder=ROOT):
    """The paths that a git command prints. Exit code 1 of git grep means that it found none."""
    done = children.run(["git", *arguments], cwd=folder, text=True)
    if done.returncode not in (0, 1) or done.stderr:
        raise ToolError(f"git {arguments[0]}: {done.stderr.strip()}")
    return done.stdout.splitlines()


def found_by(command, folder=ROOT):
    """The files that a recipe's command finds, also among new ones."""
    _git, _grep, *rest = shlex.split(command)
    return listed("grep", "--untracked", *rest, folder=folder)


def names(text):
    """The paths and patterns, from the checkout, that a recipe names in the second column of its tables and as no places."""
    return named_places(text) + _names_in(part for part in text.split("\n\n") if part.startswith("Not places: "))


def named_places(text):
    """The paths and patterns in the second column of its tables."""
    return _names_in(line.split("|")[2] for line in text.splitlines() if line.startswith("| "))


def _names_in(parts):
    found = []
    for part in parts:
        folder = ""
        for match in NAME.finditer(part):
            name = match[1] or match[2]
            if name.endswith("/"):
                folder = name
            else:
                found.append(name if "/" in name or match[2] or not folder else folder + name)
    return found


def is_named(path, patterns):
    """Whether one of the patterns is the path's."""
    return any(fnmatch.fnmatchcase(path, pattern) for pattern in patterns)


def unnamed(text, command, folder=ROOT):
    """The files that a command of a recipe finds and the recipe does not name."""
    named = (*names(text), *NEVER_PLACES)
    return [path for path in found_by(command, folder) if not is_named(path, named)]
