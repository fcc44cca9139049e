# SPDX-License-Identifier: MIT
"""docs/seeds.md: every numbered system of the sources has its row, and every name stands where the row says."""

import re

import pytest

from conftest import CHECKOUT

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
    assert len(cells) == 4, number
    here, twin, shown = map(names, cells[1:])
    for file, name in here:
        assert file.relative_to(CHECKOUT).parts[0] in ("lib", "firmware", "tools"), file
        assert is_defined(file, name), f"{number}: {file} has no {name}"
    for file, name in twin:
        assert "reference" in file.parts, file
        assert is_defined(file, name), f"{number}: {file} has no {name}"
    for file, name in shown:
        assert file.name.startswith("test_") and name.startswith("test_"), f"{number}: {name} is no test"
        assert is_defined(file, name), f"{number}: {file} has no {name}"


def test_a_name_that_is_only_called_or_declared_is_not_there(tmp_path):
    source, header = tmp_path / "x.c", tmp_path / "x.h"
    source.write_text("int gone(int);\nstatic int hidden(void)\n{\n    return called(1);\n}\n"
                      "int here(int a,\n         int b)\n{\n}\nconst fxl_clipper record = {0};\n", encoding="utf-8")
    header.write_text("int declared(int a);\ntypedef struct {\n    int x;\n} type;\n#define LIMIT 3\n",
                      encoding="utf-8")
    assert [name for name in ("gone", "hidden", "called", "here", "record", "other") if is_defined(source, name)] == \
        ["here", "record"]
    assert [name for name in ("declared", "type", "LIMIT") if is_defined(header, name)] == ["type", "LIMIT"]
