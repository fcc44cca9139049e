# SPDX-License-Identifier: MIT
"""The recipes of CONTRIBUTING.md: each names all places of its change.

Each recipe has a command, git grep -lE '...'. What it finds is a place, or the recipe says that it is none: all of it must be
named there. A name is a path from the checkout, or stands after its folder in the same line; * is a pattern.
"""

import fnmatch
import functools
import re
import subprocess

import pytest

from conftest import CHECKOUT

CONTRIBUTING = (CHECKOUT / "CONTRIBUTING.md").read_text(encoding="utf-8")
RECIPES = CONTRIBUTING.split("\n## Recipes\n", 1)[1].split("\n## ", 1)[0]
COMMAND = re.compile(r"`git grep -lE '([^'`]*)'`")
NAME = re.compile(r"`((?:[\w*-]+/)*(?:[\w*.-]+\.(?:c|h|S|py|toml|md|mk|txt|ld)|[\w-]+\*|Makefile)|(?:[\w-]+/)+)`|\]\(([\w./-]+)\)")
# The text of the recipes, what is past, what breaks lines on purpose, and this test.
NO_PLACES = ("CONTRIBUTING.md", "CHANGELOG.md", "host_tests/build/seeded_bugs/*", "host_tests/build/survivors.toml",
             "host_tests/build/test_recipes.py", "host_tests/build/test_documents.py", "*.json")


def recipes():
    """{the title of a recipe, or of a part of it that has a command of its own: its text}."""
    found = {}
    for text in re.split(r"^### ", RECIPES, flags=re.MULTILINE)[1:]:
        title, text = text.split("\n", 1)
        parts = re.split(r"^#### ", text, flags=re.MULTILINE)
        found[title] = parts[0]
        for part in parts[1:]:
            found[f"{title}: {part.splitlines()[0]}"] = part
    return {title: text for title, text in found.items() if COMMAND.search(text)}


@functools.cache
def texts():
    """{path: text} of the files of the checkout that have text."""
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=CHECKOUT,
                            capture_output=True, text=True, check=True).stdout.split("\0")
    files = {name: (CHECKOUT / name).read_bytes() for name in listed if name and (CHECKOUT / name).is_file()}
    return {name: data.decode("utf-8", "replace") for name, data in files.items() if b"\0" not in data}


def names(text):
    """The paths and patterns, from the checkout, that a recipe names: in the second column of its table, where a name stands in the
    folder before it, and below its command."""
    table = [line.split("|")[2] for line in text.splitlines() if line.startswith("| ")]
    found, folder = [], ""
    for part in [*table, text[COMMAND.search(text).end():]]:
        for match in NAME.finditer(part):
            name = match[1] or match[2]
            if name.endswith("/"):
                folder = name
            else:
                found.append(name if "/" in name or match[2] or not folder else folder + name)
        folder = ""
    return found


def unnamed(text, files):
    """The files that a recipe's command finds and the recipe does not name."""
    pattern = re.compile(COMMAND.search(text)[1])
    named = names(text)
    return [path for path, content in files.items()
            if pattern.search(content) and not any(fnmatch.fnmatchcase(path, name) for name in (*named, *NO_PLACES))]


def test_each_recipe_has_a_command():
    titles = re.findall(r"^### (.*)$", RECIPES, re.MULTILINE)
    assert len(titles) == 10
    assert [title for title in titles if not any(name.startswith(title) for name in recipes())] == []


@pytest.mark.parametrize("title", recipes())
def test_a_recipe_names_all_places(title):
    found = unnamed(recipes()[title], texts())
    assert not found, f'CONTRIBUTING.md, "{title}": name these files in the table, or below the command that finds them: {found}'


@pytest.mark.parametrize("title", recipes())
def test_what_a_recipe_names_is_there(title):
    assert [name for name in names(recipes()[title]) if not fnmatch.filter(texts(), name)] == []


@pytest.mark.parametrize("title", recipes())
def test_a_recipe_has_what_computes_what_checks_and_what_says(title):
    groups = re.findall(r"^\| (computes|checks|says) \|", recipes()[title], re.MULTILINE)
    assert list(dict.fromkeys(groups)) == ["computes", "checks", "says"]


def test_a_file_that_is_not_named_is_seen():
    text = "| computes | `lib/a/`: `x.c`, `y_*.c`; `docs/z.md` |\n\nAll places: `git grep -lE 'first_(one|two)'`.\n"
    assert names(text) == ["lib/a/x.c", "lib/a/y_*.c", "docs/z.md"]
    found = {"lib/a/x.c": "first_one", "lib/b/x.c": "first_two", "lib/a/y_1.c": "first_one", "lib/a/other.c": "one"}
    assert unnamed(text, found) == ["lib/b/x.c"]
