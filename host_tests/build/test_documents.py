# SPDX-License-Identifier: MIT
"""What the recipes and DESIGN.md say of files, where files can tell: the fill rule, a new board, the reference renderer."""

import os
import re
import shutil
import subprocess

from conftest import CHECKOUT, environment
from fixel.check import recipes


def test_whoever_asks_for_pixel_centres_or_dividends_is_a_place_of_the_fill_rule():
    """The files that obey the fill rule, as DESIGN.md says."""
    asks = re.compile(r'^#include "(?:[\w./]*/)?(pixel_centre|edge|edge_divide)\.h"', re.MULTILINE)
    known, _ = recipes.load()
    places = {tag.file for tag in recipes.tags(known) if tag.word == "fill-rule"} | set(known["fill-rule"].beside)
    asked = {file: asks.findall(file.read_text(encoding="utf-8")) for file in (CHECKOUT / "lib").rglob("*.[ch]")}
    users = [file.relative_to(CHECKOUT).as_posix() for file, headers in asked.items() if headers]
    assert {header for headers in asked.values() for header in headers} == {"pixel_centre", "edge", "edge_divide"}
    assert len(users) > 6
    assert [file for file in users if file not in places] == []


def test_nobody_has_a_grid_of_pixel_centres_of_his_own():
    own = re.compile(r"#define \w*HALF_PIXEL\b")
    assert [file.name for file in (CHECKOUT / "lib").rglob("*.[ch]") if own.search(file.read_text(encoding="utf-8"))] == \
        ["pixel_centre.h"]


def test_a_new_board_changes_no_other_file(tmp_path):
    for entry in CHECKOUT.iterdir():
        if entry.name not in ("boards", "build", ".git"):
            (tmp_path / entry.name).symlink_to(entry)
    (tmp_path / "boards").mkdir()
    for entry in (CHECKOUT / "boards").iterdir():
        (tmp_path / "boards" / entry.name).symlink_to(entry)
    new = shutil.copytree(CHECKOUT / "boards" / "netduino2", tmp_path / "boards" / "own-board")
    settings = (new / "board.mk").read_text(encoding="utf-8")
    (new / "board.mk").write_text(settings.replace("boards/netduino2/", "boards/own-board/"), encoding="utf-8")
    done = subprocess.run(["make", "-n", "BOARD=own-board", "build/boards/own-board/walk.elf"], cwd=tmp_path,
                          env=environment(), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "boards/own-board/board.c" in done.stdout and "boards/own-board" in done.stdout
    assert not os.path.exists(tmp_path / "build" / "boards" / "own-board" / "walk.elf")


def boards_named(page):
    """The boards in the first column of the README's table of boards."""
    table = page.split("\n## Boards\n", 1)[1].split("\n## ", 1)[0]
    return {name for row in re.findall(r"^\| ([^|]*) \|", table, re.MULTILINE) for name in re.findall(r"`([\w-]+)`", row)}


def test_the_pages_know_every_board():
    boards = {file.parent.name for file in (CHECKOUT / "boards").glob("*/board.mk")}
    assert boards_named((CHECKOUT / "README.md").read_text(encoding="utf-8")) == boards
    count = re.search(r"is a whole program for (\w+) boards", (CHECKOUT / "docs" / "hello.md").read_text(encoding="utf-8"))[1]
    words = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")
    assert words.index(count) == len(boards) - 1    # without the host


def test_a_board_that_the_readme_does_not_name_is_seen():
    assert boards_named("# F\n\n## Boards\n\n| board | core |\n| --- | --- |\n| `a`, `b-1` | `M3` |\n\n## Next\n| `c` |\n") == {"a", "b-1"}


def test_the_reference_renderer_includes_its_own_headers_and_those_of_c():
    folder = CHECKOUT / "host_tests" / "judges" / "reference"
    included = {name for file in folder.glob("*.[ch]")
                for name in re.findall(r'^\s*#\s*include\s+([<"][^>"]+)', file.read_text(encoding="utf-8"), re.MULTILINE)}
    assert len(included) > 20
    assert not [name for name in included if not name.startswith('"reference/') and not re.fullmatch(r"<[a-z]+\.h", name)]


def test_the_numbers_of_the_stipple_are_those_of_the_specification():
    numbers = re.compile(r"((?:\d+, ){15}\d+)")
    told = (CHECKOUT / "SPEC.md").read_text(encoding="utf-8").split("the pattern's number, nothing is drawn.", 1)[1]
    table = (CHECKOUT / "lib/paint/texel_place.h").read_text(encoding="utf-8").split("stipple[16] = {", 1)[1]
    assert numbers.search(told)[1] == numbers.match(table)[1]
