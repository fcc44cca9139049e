# SPDX-License-Identifier: MIT
"""The recipes of CONTRIBUTING.md: each names all places of its change (fixel.check.recipes)."""

import fnmatch
import re

import pytest

from conftest import write_files
from fixel.check.recipes import (COMMAND, NEVER_PLACES, commands, found_by, listed, named_places, names, recipes, section, unnamed)

RECIPES = section()
FILES = listed("ls-files", "--cached", "--others", "--exclude-standard")


COMMANDS = [(title, command) for title, text in recipes().items() for command in commands(text)]


def test_each_recipe_has_a_command_before_all_else():
    titles = re.findall(r"^### (.*)$", RECIPES, re.MULTILINE)
    assert len(titles) == 10
    assert [title for title in titles if not any(name.startswith(title) for name in recipes())] == []
    for title, text in recipes().items():
        assert COMMAND.search(text.strip().split("\n\n")[0]), f'CONTRIBUTING.md, "{title}": its first paragraph has no command'


@pytest.mark.parametrize("title, command", COMMANDS)
def test_a_recipe_names_all_places(title, command):
    found = unnamed(recipes()[title], command)
    assert not found, f'CONTRIBUTING.md, "{title}": name these files in a table, or after "Not places:": {found}'


@pytest.mark.parametrize("title, command", COMMANDS)
def test_a_command_finds_places(title, command):
    assert len(found_by(command)) > 1, f'CONTRIBUTING.md, "{title}": {command} finds nothing'


@pytest.mark.parametrize("title", recipes())
def test_what_a_recipe_names_is_there(title):
    assert [name for name in names(recipes()[title]) if not fnmatch.filter(FILES, name)] == []


@pytest.mark.parametrize("title", recipes())
def test_a_recipe_has_code_then_tests_then_documents(title):
    kinds = []
    for line in recipes()[title].splitlines():
        if line.startswith("| | "):
            kinds.append([])
        elif line.startswith("| ") and not line.startswith("| --- "):
            kinds[-1].append(line.split("|")[1].strip())
    assert list(dict.fromkeys(kinds[0])) == ["code", "tests", "documents"]
    for table in kinds:     # the others are of changes that not every one makes
        assert table == sorted(table, key=("code", "tests", "documents").index)


def test_what_is_never_a_place_is_said():
    above = RECIPES.split("\n### ", 1)[0]
    for pattern in NEVER_PLACES:
        assert f"`{pattern}`" in above, pattern


def test_a_file_that_is_not_named_is_seen(tmp_path):
    text = ("Find: `git grep -lE 'first_(one|two)'` and `git grep -lE '\\+ 7\\b' -- '*.[chS]'`.\n\n"
            "| | files | about |\n| --- | --- | --- |\n| code | `lib/a/`: `x.c`, `y_*.c`; `docs/z.md` | |\n\nNot places: `lib/c/used.c`.\n\nThen `lib/b/x.c`.\n")
    assert names(text) == ["lib/a/x.c", "lib/a/y_*.c", "docs/z.md", "lib/c/used.c"]
    assert named_places(text) == ["lib/a/x.c", "lib/a/y_*.c", "docs/z.md"]
    contents = {"lib/a/x.c": "first_one", "lib/b/x.c": "first_two", "lib/a/y_1.c": "first_one", "lib/a/other.c": "one",
                "lib/c/used.c": "first_two", "lib/b/number.S": "a + 7", "lib/b/more.c": "a + 77", "lib/b/text.md": "a + 7",
                "CHANGELOG.md": "first_one"}
    write_files(tmp_path, {path: content + "\n" for path, content in contents.items()})
    listed("init", "--quiet", folder=tmp_path)
    names_of, numbers_of = commands(text)
    assert unnamed(text, names_of, tmp_path) == ["lib/b/x.c"]
    assert unnamed(text, numbers_of, tmp_path) == ["lib/b/number.S"]


@pytest.mark.parametrize("title, command", COMMANDS)
def test_a_recipe_without_its_names_fails_for_each_command(title, command):
    assert unnamed("", command), title
