# SPDX-License-Identifier: MIT
"""The recipes of CONTRIBUTING.md: each names all places of its change.

A recipe begins with its commands, git grep -lE '...', which this test runs as they stand there. Each file that a command finds
must be named: in the second column of a table, or in the paragraph "Not places:". A name is a path from the checkout, or stands
after its folder; * is any text.
"""

import fnmatch
import functools
import re
import shlex
import subprocess

import pytest

from conftest import CHECKOUT

CONTRIBUTING = (CHECKOUT / "CONTRIBUTING.md").read_text(encoding="utf-8")
RECIPES = CONTRIBUTING.split("\n## Recipes\n", 1)[1].split("\n## ", 1)[0]
COMMAND = re.compile(r"`(git grep -lE '[^'`]*'(?: -- [^`]*)?)`")
NAME = re.compile(r"`((?:[\w*-]+/)*(?:[\w*.-]+\.(?:c|h|S|py|toml|md|mk|txt|ld|rs)|[\w-]+\*|Makefile)|(?:[\w-]+/)+)`|\]\(([\w./-]+)\)")
# What no recipe names, though its command may find it: a pattern of files, and why. The text above the recipes says the same.
NEVER_PLACES = {
    "CONTRIBUTING.md": "the recipes themselves",
    "CHANGELOG.md": "the past, which stays as it was",
    "*.json": "records, which commands write",
    "host_tests/unit/uncovered.toml": "quotes of conditions of the library; make coverage names those that a change breaks",
    "host_tests/build/seeded_bugs/*": "quotes of lines of the library; test_seeded_bugs.py names those that a change breaks",
    "host_tests/build/breaks.toml": "quotes of lines of the library; make breaks names those that a change breaks",
    "host_tests/build/trace/*": "ids and first words of clauses; make trace names those that a change breaks",
    "host_tests/proofs/*": "names of functions, and proofs of them; make prove names those that a change breaks",
    "tools/fixel/prove/*": "it unwinds loops, which is no winding of a polygon",
}


def recipes():
    """{the title of a recipe, or of a part of it that has a command of its own: its text}."""
    found = {}
    for text in re.split(r"^### ", RECIPES, flags=re.MULTILINE)[1:]:
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


def listed(*arguments, folder=CHECKOUT):
    """The paths that a git command prints. Exit code 1 of git grep means that it found none."""
    done = subprocess.run(["git", *arguments], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode in (0, 1) and not done.stderr, done.stderr
    return done.stdout.splitlines()


@functools.cache
def files(folder=CHECKOUT):
    """The files of a checkout, also new ones that are not committed yet."""
    return [name for name in listed("ls-files", "--cached", "--others", "--exclude-standard", folder=folder) if (folder / name).is_file()]


@functools.cache
def found_by(command, folder=CHECKOUT):
    """The files that a recipe's command finds, also among new ones."""
    git, grep, *rest = shlex.split(command)
    assert (git, grep) == ("git", "grep")
    return listed("grep", "--untracked", *rest, folder=folder)


def names(text):
    """The paths and patterns, from the checkout, that a recipe names in the second column of its tables and as no places."""
    cells = [line.split("|")[2] for line in text.splitlines() if line.startswith("| ")]
    others = [part for part in text.split("\n\n") if part.startswith("Not places: ")]
    found = []
    for part in (*cells, *others):
        folder = ""
        for match in NAME.finditer(part):
            name = match[1] or match[2]
            if name.endswith("/"):
                folder = name
            else:
                found.append(name if "/" in name or match[2] or not folder else folder + name)
    return found


def is_named(path, patterns):
    return any(fnmatch.fnmatchcase(path, pattern) for pattern in patterns)


def unnamed(text, command, folder=CHECKOUT):
    """The files that a command of a recipe finds and the recipe does not name."""
    named = (*names(text), *NEVER_PLACES)
    return [path for path in found_by(command, folder) if not is_named(path, named)]


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
    assert [name for name in names(recipes()[title]) if not fnmatch.filter(files(), name)] == []


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
    contents = {"lib/a/x.c": "first_one", "lib/b/x.c": "first_two", "lib/a/y_1.c": "first_one", "lib/a/other.c": "one",
                "lib/c/used.c": "first_two", "lib/b/number.S": "a + 7", "lib/b/more.c": "a + 77", "lib/b/text.md": "a + 7",
                "CHANGELOG.md": "first_one"}
    for path, content in contents.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(content + "\n", encoding="utf-8")
    listed("init", "--quiet", folder=tmp_path)
    names_of, numbers_of = commands(text)
    assert unnamed(text, names_of, tmp_path) == ["lib/b/x.c"]
    assert unnamed(text, numbers_of, tmp_path) == ["lib/b/number.S"]
    assert "lib/a/x.c" in files(tmp_path)


@pytest.mark.parametrize("title, command", COMMANDS)
def test_a_recipe_without_its_names_fails_for_each_command(title, command):
    assert unnamed("", command), title
