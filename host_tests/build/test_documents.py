# SPDX-License-Identifier: MIT
"""What the documents say of files, where files can tell: recipes and DESIGN.md, cross references, docs/safety, docs/opengl.md and
docs/formats.md."""

import functools
import os
import re
import shutil
import subprocess

import pytest

from conftest import CHECKOUT, environment
from fixel.check import places as recipes
from fixel.image import fields, formats

BUILT_PROGRAMS = ()


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
    done = subprocess.run(["make", "-n", "BOARD=own-board", "build/boards/own-board/walk.elf"], cwd=tmp_path,
                          env=environment(), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert sorted(file.name for file in new.iterdir()) == ["board.mk"]
    assert "boards/own-board/boards/parts/defaults.o" in done.stdout and "boards/own-board/walk.elf" in done.stdout
    assert not os.path.exists(tmp_path / "build" / "boards" / "own-board" / "walk.elf")


def boards_named(page):
    """The boards in the first column of the table of docs/boards.md."""
    table = page.split("\n## Boards\n", 1)[1].split("\n## ", 1)[0]
    return {name for row in re.findall(r"^\| ([^|]*) \|", table, re.MULTILINE) for name in re.findall(r"`([\w-]+)`", row)}


def test_the_pages_know_every_board():
    boards = {file.parent.name for file in (CHECKOUT / "boards").glob("*/board.mk")}
    assert boards_named((CHECKOUT / "docs" / "boards.md").read_text(encoding="utf-8")) == boards
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


# --- cross references: each page, section and heading that is cited is there --------

SUFFIXES = {".md", ".c", ".h", ".S", ".py", ".toml", ".mk", ".ld", ".inc"}
SAME_PAGE = "the page itself"
# What a line of a comment begins with, of which the sentence knows nothing.
BEGINNING = re.compile(r"\s*\n\s*(?:\*(?= )|#+(?= )|//|--)?\s*")
NUMBER = r"\d+(?:\.\d+)?"
NUMBERS = rf"{NUMBER}(?:(?:,? and |,? or |, | to ){NUMBER})*(?![\d.]*\d)"
PAGE = r"(?P<page>[\w./-]*\w\.md)"
CITATIONS = (
    re.compile(rf"{PAGE}(?:[)`\]]|'s)*,? sections? (?P<numbers>{NUMBERS})"),
    re.compile(rf"[Ss]ections? (?P<numbers>{NUMBERS}) of (?:\[[^\]]*\]\()?{PAGE}"),
    re.compile(rf"(?<!\.md, )(?<!\.md\), )(?<!\.md\) )(?<!\.md )(?<!\.md`, )(?<!\.md's )\b[Ss]ections? (?P<numbers>{NUMBERS})"
               r"(?! of (?:\[[^\]]*\]\()?[\w./-]*\w\.md)"),
)
TITLE = re.compile(rf'{PAGE}\)?,? \(?"(?P<title>[A-Z][^"]+)"')
# In the specification and its pages the number of a clause may stand alone: (4.2), by 8.5, with 9.3.
CLAUSE = re.compile(r"(?:\b(?:[Bb]y|[Ww]ith|of|to) |\()(?P<numbers>[1-9]\d*\.\d+)(?=[):;,. ])(?!\.\d)")
FORMATS = {"16.16", "2.30", "1.31", "18.46", "0.32"}


def files():
    """The text files of the project, but for this one and the record of what is past."""
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=CHECKOUT,
                            capture_output=True, text=True, check=True).stdout.split("\0")
    return [CHECKOUT / name for name in listed if name and (CHECKOUT / name).suffix in SUFFIXES and (CHECKOUT / name).is_file()
            and name not in ("CHANGELOG.md", "host_tests/build/test_documents.py")]


def sentences(text):
    """A file's text in one line, without what comments begin a line with."""
    return BEGINNING.sub(" ", text)


@functools.cache
def clauses(page):
    """The numbers of the sections and clauses of a page."""
    text = page.read_text(encoding="utf-8")
    return frozenset(re.findall(r"^#+ (\d+(?:\.\d+)?)\.? ", text, re.MULTILINE) +
                     re.findall(r"^(?:\* )?\*\*(\d+\.\d+)[ *]", text, re.MULTILINE))


def page_of(name, file):
    """The page that a file names: beside it, or in the checkout, in docs or in docs/extras; None if there is none."""
    places = (file.parent / name, CHECKOUT / name, CHECKOUT / "docs" / name, CHECKOUT / "docs" / "extras" / name)
    return next((place.resolve() for place in places if place.is_file()), None)


def cited(text):
    """[(page or SAME_PAGE, number)] of a text."""
    found = []
    for pattern in CITATIONS:
        for match in pattern.finditer(text):
            page = match.groupdict().get("page") or SAME_PAGE
            found += [(page, number) for number in re.findall(NUMBER, match["numbers"])]
    return found


def wrong_references(file, text):
    """What a file's text cites that is not there, as sentences."""
    wrong = []
    if "ection" not in text and ".md" not in text:
        return wrong
    text = sentences(text)
    for name, number in cited(text):
        if name == SAME_PAGE and file.suffix != ".md":
            continue
        page = file if name == SAME_PAGE else page_of(name, file)
        if page is None:
            wrong.append(f"there is no {name}")
        elif number not in clauses(page):
            wrong.append(f"{page.name} has no section {number}")
    for match in TITLE.finditer(text):
        page = page_of(match["page"], file)
        if page is None or not re.search(rf"^#+ (?:[\d.]+ )?{re.escape(match['title'])}$", page.read_text(encoding="utf-8"),
                                         re.MULTILINE):
            wrong.append(f'{match["page"]} has no heading "{match["title"]}"')
    return wrong


def test_what_is_cited_is_there():
    wrong = [f"{file.relative_to(CHECKOUT)}: {text}" for file in files()
             for text in wrong_references(file, file.read_text(encoding="utf-8"))]
    assert not wrong, "\n".join(wrong)


def clauses_cited(page):
    """The numbers of clauses that stand alone in a page."""
    text = sentences(re.sub(r"^\|.*$", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE))
    return {match["numbers"] for match in CLAUSE.finditer(text)} - FORMATS


PAGES = [page for page in (CHECKOUT / "SPEC.md", *sorted((CHECKOUT / "docs").rglob("*.md")))
         if any("." in number for number in clauses(page))]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_a_page_of_the_specification_cites_clauses_that_are_there(page):
    assert clauses_cited(page) <= clauses(page), sorted(clauses_cited(page) - clauses(page))


def test_clauses_are_found():
    assert {"4.2", "8.2", "8.5", "9.3"} <= clauses_cited(CHECKOUT / "SPEC.md")
    assert len(PAGES) > 10


@pytest.mark.parametrize("text, wrong", [
    ("/* As SPEC.md, section 4.7,\n * says. */", []),
    ("/* As SPEC.md, section\n * 4.77, says. */", ["SPEC.md has no section 4.77"]),
    ("([SPEC.md](../SPEC.md), sections 4.2 and 8.6)", ["SPEC.md has no section 8.6"]),
    ("the order of section 60 of SPEC.md", ["SPEC.md has no section 60"]),
    ("docs/none.md, section 1", ["there is no docs/none.md"]),
    ('[docs/scenes.md](docs/scenes.md), "No heading"', ['docs/scenes.md has no heading "No heading"']),
])
def test_a_wrong_reference_is_found(text, wrong):
    assert wrong_references(CHECKOUT / "README.md", text) == wrong


def test_a_page_cites_itself_by_the_number_alone():
    page = CHECKOUT / "docs" / "extras" / "motion.md"
    assert wrong_references(page, "Section 5 and section 2.2, section 9") == ["motion.md has no section 9"]


# --- docs/safety: each row has an id of its own and cites what says something of it -

SAFETY_PAGES = {"constraints.md": 6, "anomalies.md": 4}     # cells of a row
ID = re.compile(r"[A-Z]\d+")
HEADER = re.compile(r"`(fixel/\w+\.h)` `([^`]+)`")
SECTION = re.compile(r'`(SPEC|[\w/]+\.md)` (?:([\d.]+)|"([^"]+)")')


def rows(page):
    """The cells of a page's rows."""
    text = (CHECKOUT / "docs" / "safety" / page).read_text(encoding="utf-8")
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines() if re.match(r"\| [A-Z]\d", line)]


def is_there(place, root=CHECKOUT):
    """Whether a place names a header and words in it, or a page and a clause, section or heading of it."""
    if (found := HEADER.fullmatch(place)):
        text = (root / "lib" / "include" / found[1]).read_text(encoding="utf-8")
        return found[2] in " ".join(text.replace(" * ", " ").split())
    found = SECTION.fullmatch(place)
    if not found:
        return False
    text = (root / ("SPEC.md" if found[1] == "SPEC" else found[1])).read_text(encoding="utf-8")
    if found[3]:
        return re.search(rf"^#+ {re.escape(found[3])}$", text, re.MULTILINE) is not None
    return re.search(rf"^(?:#+ {re.escape(found[2])}\.? |\*\*{re.escape(found[2])}[ *])", text, re.MULTILINE) is not None


@pytest.mark.parametrize("page", SAFETY_PAGES)
def test_each_row_is_whole_and_cites_what_is_there(page):
    found = rows(page)
    assert len(found) >= 12 and len({row[0] for row in found}) == len(found)
    wrong = [row[0] for row in found if len(row) != SAFETY_PAGES[page] or not ID.fullmatch(row[0])
             or not all(row) or not is_there(row[-1])]
    assert wrong == []


@pytest.mark.parametrize("place, there", [
    ("`fixel/render.h` `fxl_render`", True), ("`fixel/render.h` `fxl_no_such_name`", False), ("`SPEC` 3.1", True), ("`SPEC` 3.99", False), ("`SPEC` 11", True),
    ('`docs/results.md` "Boards"', True), ('`docs/results.md` "Board"', False), ("docs/results.md", False)])
def test_a_place_that_is_not_there_is_found(place, there):
    assert is_there(place) is there


def test_the_pages_promise_no_certificate():
    for page in (*SAFETY_PAGES, "rules.md"):
        text = (CHECKOUT / "docs" / "safety" / page).read_text(encoding="utf-8")
        assert "evidence for your argument" in text and not re.search(r"\bcertified\b|\bcompliant\b", text)


# --- docs/opengl.md: each file of the table is there, with the names of its row -----

OPENGL = CHECKOUT / "docs" / "opengl.md"
ROWS = [line.strip("| \n").split(" | ") for line in OPENGL.read_text(encoding="utf-8").splitlines()
        if line.startswith("| ") and "OpenGL |" not in line and "---" not in line]
HEADERS = "\n".join(file.read_text(encoding="utf-8") for file in sorted((CHECKOUT / "lib").rglob("*.h")) if file.parent.name != "study")


def names_of(row):
    """The C names that a row has in its middle column."""
    return re.findall(r"`((?:fxl|FXL)_\w+)`", row[1])


def files_of(row):
    return [(OPENGL.parent / target).resolve() for target in re.findall(r"\]\(([^)]+)\)", row[2])]


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


# --- docs/formats.md: the fields of a scene image are stated once -------------------

@pytest.mark.parametrize("file", list(formats.texts()))
def test_what_was_written_is_what_the_table_says(file):
    assert (CHECKOUT / file).read_text(encoding="utf-8") == formats.texts()[file], "fixel formats renews it"


# place field: that fixel formats has been run
def test_another_field_changes_all_that_is_written(monkeypatch):
    other = fields.Section("other", "other table", (fields.Field("3i", "x", "an x"),), 7, record="fxl_point")
    before = formats.texts()
    monkeypatch.setattr(formats, "SECTIONS", (*fields.SECTIONS, other))
    after = formats.texts()
    assert "SECTION_OTHER = 38," in after["lib/scene/scene_sections.h"] and "| 38 | other | yes | 1..7 | i32 × 3 an x | 12 |" in \
        after["docs/formats.md"]
    assert before["lib/paint/surface_sections.h"] == after["lib/paint/surface_sections.h"]


def test_kinds_and_limits_fit_those_of_the_library():
    assert len(fields.SECTIONS) < 256
    limits = {(section.limit, section.most) for section in fields.SECTIONS if section.limit}
    assert len(limits) == len(dict(limits))     # a limit of C is one number
    assert fields.HEAD.size % 4 == 0 and fields.ENTRY.size % 4 == 0
