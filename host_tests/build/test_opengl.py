# SPDX-License-Identifier: MIT
"""docs/opengl.md: each file that the table names is there, and declares or mentions the names of its row."""

import re

import pytest

from conftest import CHECKOUT

PAGE = CHECKOUT / "docs" / "opengl.md"
ROWS = [line.strip("| \n").split(" | ") for line in PAGE.read_text(encoding="utf-8").splitlines()
        if line.startswith("| ") and "OpenGL |" not in line and "---" not in line]
HEADERS = "\n".join(file.read_text(encoding="utf-8") for file in sorted((CHECKOUT / "lib").rglob("*.h")) if file.parent.name != "study")


def names_of(row):
    """The C names that a row has in its middle column."""
    return re.findall(r"`((?:fxl|FXL)_\w+)`", row[1])


def files_of(row):
    return [(PAGE.parent / target).resolve() for target in re.findall(r"\]\(([^)]+)\)", row[2])]


def is_declared(name, text):
    """Whether a header declares a function, a type, a record or a constant of that name."""
    return re.search(rf"\b{name}\(|^\}} {name};|^typedef [^;]*\b{name};|\b{name}\b\s*=|#define {name}\b|^extern const .*\b{name};"
                     rf"|^\s*{name},", text, re.MULTILINE) is not None


def test_the_table_is_read():
    assert len(ROWS) > 30 and all(len(row) == 3 and files_of(row) for row in ROWS)
    assert len({name for row in ROWS for name in names_of(row)}) > 40


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row[0])
def test_files_and_names_are_there(row):
    files = files_of(row)
    assert [file for file in files if not file.is_file()] == []
    text = "\n".join(file.read_text(encoding="utf-8") for file in files)
    for name in names_of(row):
        assert is_declared(name, HEADERS), f"no header declares {name}"
        assert re.search(rf"\b{name}\b", text), f"{name} does not stand in {', '.join(file.name for file in files)}"


def test_a_name_that_is_only_mentioned_is_not_declared():
    assert not is_declared("fxl_gone", "/* fxl_gone draws. */\n")
    assert is_declared("fxl_here", "} fxl_here;\n") and is_declared("fxl_here", "fxl_status fxl_here(int a);")
