# SPDX-License-Identifier: MIT
"""docs/seeds.md: every numbered system of the sources has its row, every name stands where the row says, and the commands
of the last column run."""

import json
import re
import tomllib

import pytest

from conftest import CHECKOUT, clipper_names, run_make

from fixel.board import methods

BUILT_PROGRAMS = ()
PAGE = CHECKOUT / "docs" / "seeds.md"
NUMBERS = [f"{letter}{number}" for letter, count in (("A", 14), ("B", 4), ("C", 8), ("D", 6))
           for number in range(1, count + 1)]
PLACE = re.compile(r"\[([^]]+)\]\(([^)]+)\): ((?:`\w+`(?:, )?)+)")
# What a name looks like where it is defined, by the kind of its file.
DEFINED = {
    ".c": r"^(?!static|extern)\w[\w \*]*\b{name}\((?:[^;{{]*)\)\s*\{{|^const \w+ {name} = ",
    ".h": r"^\}} {name};|^typedef .*\b{name};|^\s*#\s*define {name}\b|^struct {name} \{{|\b{name}\([^;{{]*\)\s*\{{",
    ".py": r"^(?:def|class) {name}\(",
}


def rows():
    """[(number, [cell])] of all tables."""
    cells = [[cell.strip() for cell in line.strip("| \n").split(" | ")]
             for line in PAGE.read_text(encoding="utf-8").splitlines() if re.match(r"\| [A-D]\d+ \|", line)]
    return [(row[0], row[1:]) for row in cells]


def names(cell):
    """[(file, name)] of a cell; it must say nothing else."""
    places = [PLACE.fullmatch(place) for place in cell.split("; ")]
    assert all(places), cell
    for place in places:
        assert place[2].endswith("/" + place[1]), place[0]
    return [((PAGE.parent / place[2]).resolve(), name) for place in places for name in re.findall(r"`(\w+)`", place[3])]


def is_defined(file, name):
    """Whether a file defines a function, a type, a constant or a test of that name."""
    pattern = DEFINED[file.suffix].format(name=name)
    return re.search(pattern, file.read_text(encoding="utf-8"), re.MULTILINE) is not None


def test_no_number_is_missing_and_none_is_there_twice():
    assert [number for number, _ in rows()] == NUMBERS


@pytest.mark.parametrize("number, cells", rows())
def test_names_stand_where_the_page_says(number, cells):
    assert len(cells) == 5, number
    here, twin, shown = map(names, cells[1:4])
    for file, name in here:
        assert file.relative_to(CHECKOUT).parts[0] in ("lib", "firmware", "tools"), file
        assert is_defined(file, name), f"{number}: {file} has no {name}"
    for file, name in twin:
        assert "reference" in file.parts, file
        assert is_defined(file, name), f"{number}: {file} has no {name}"
    for file, name in shown:
        assert file.name.startswith("test_") and name.startswith("test_"), f"{number}: {name} is no test"
        assert is_defined(file, name), f"{number}: {file} has no {name}"


def public_headers():
    """The text of what a program may include: the public headers, those of the study with its archive; and, by -Ilib as tests and
    benches do, those of the stages."""
    lib = CHECKOUT / "lib"
    files = [*sorted((lib / "include").rglob("*.h")), *sorted(lib.glob("*/*.h"))]
    return "\n".join(file.read_text(encoding="utf-8") for file in files)


def names_of(setting):
    """What CLIPPER= or VISIBILITY= may be."""
    if setting == "VISIBILITY":
        return list(methods.rows())
    return clipper_names()


def is_reachable(text, headers):
    """Whether a command, a scene, a C call, a type or a constant of the last column is there for a user."""
    if text.startswith("make "):
        target, *settings = text.split()[1:]
        makefile = (CHECKOUT / "Makefile").read_text(encoding="utf-8")
        rule = re.search(rf"^{target}:.*## .*$", makefile, re.MULTILINE)
        return rule is not None and all(
            is_reachable(value, headers) if name == "SCENE" else
            name == "LIB_FLAGS" or (f"{name}=" in rule[0] and value in names_of(name))
            for name, value in (setting.split("=", 1) for setting in settings))
    if text.startswith("scenes/"):
        return (CHECKOUT / text).is_file()
    return re.search(rf"\b{text}\b", headers) is not None and re.match("(?i)fxl_", text) is not None


@pytest.mark.parametrize("number, cells", rows())
def test_a_user_reaches_it(number, cells):
    found = re.findall(r"`([^`]+)`", cells[4])
    assert found, number
    headers = public_headers()
    for text in found:
        assert is_reachable(text, headers), f"{number}: {text}"


# What is added to a listed command, so that it takes little time and shows what it shows: two frames, on the host.
SMALL = {"run": ["BOARD=host", "FRAMES=2"], "wire": ["FRAMES=2"], "lib": ["CORE=cortex-m3"]}
# Commands that test_commands.py and its table run, because they do not end or take minutes.
ELSEWHERE = {"view", "clippers"}


def commands():
    """The commands of the last column, each once."""
    return sorted({text for _, cells in rows() for text in re.findall(r"`make ([^`]+)`", cells[4])})


def test_commands_are_listed_and_run():
    table = tomllib.loads((CHECKOUT / "host_tests" / "build" / "commands.toml").read_text(encoding="utf-8"))
    assert {text.split()[0] for text in commands()} == set(SMALL) | ELSEWHERE
    assert ELSEWHERE <= set(table)


@pytest.mark.parametrize("text", [text for text in commands() if text.split()[0] in SMALL])
def test_a_listed_command_runs_and_shows_it(text, tmp_path):
    command, *settings = text.split()
    # The library is compiled as a whole: without the optimiser, which takes most of the time.
    settings = [f"{each} -O0" if each.startswith("LIB_FLAGS=") else each for each in settings]
    place = f"BUILD={tmp_path}" if command == "lib" else f"OUT={tmp_path / 'out'}"
    done = run_make(command, *settings, *SMALL[command], place)
    assert done.returncode == 0, done.stdout + done.stderr
    if command == "lib":
        assert (tmp_path / "lib" / "cortex-m3" / "libfixel.a").is_file()
        return
    summary = json.loads((tmp_path / "out" / "summary.json").read_text(encoding="utf-8"))
    assert summary["frames"] == 2 and summary["pixels_unexplained"] == 0
    if command == "wire":
        assert summary["pixels_drawn"] > 0
        return
    assert summary["polygons"]["drawn"] > 0
    asked = dict(setting.split("=", 1) for setting in settings)
    for name in {"CLIPPER", "VISIBILITY"} & set(asked):
        assert summary[name.lower()] == asked[name]
    if asked.get("SCENE") == "scenes/knot.toml":
        assert summary["order_wrong_pixels"] == 0, "an order by distance is wrong here: the tree is not used"


def test_what_is_not_there_is_not_reachable():
    headers = public_headers()
    for text in ("make walk", "make run SCENE=scenes/none.toml", "make run CLIPPER=none", "make wire CLIPPER=once",
                 "scenes/none.toml", "fxl_none", "fxl_clip", "stdbool"):
        assert not is_reachable(text, headers), text


def test_a_name_that_is_only_called_or_declared_is_not_there(tmp_path):
    source, header = tmp_path / "x.c", tmp_path / "x.h"
    source.write_text("int gone(int);\nstatic int hidden(void)\n{\n    return called(1);\n}\n"
                      "int here(int a,\n         int b)\n{\n}\nconst fxl_clipper record = {0};\n", encoding="utf-8")
    header.write_text("int declared(int a);\ntypedef struct {\n    int x;\n} type;\n#define LIMIT 3\n",
                      encoding="utf-8")
    assert [name for name in ("gone", "hidden", "called", "here", "record", "other") if is_defined(source, name)] == \
        ["here", "record"]
    assert [name for name in ("declared", "type", "LIMIT") if is_defined(header, name)] == ["type", "LIMIT"]
