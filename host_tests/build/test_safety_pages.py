# SPDX-License-Identifier: MIT
"""docs/safety: each row of constraints and anomalies has an id of its own, and the place that it cites says something of it."""

import re

import pytest

from conftest import CHECKOUT

PAGES = {"constraints.md": 6, "anomalies.md": 4}     # cells of a row
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


@pytest.mark.parametrize("page", PAGES)
def test_each_row_is_whole_and_cites_what_is_there(page):
    found = rows(page)
    assert len(found) >= 12 and len({row[0] for row in found}) == len(found)
    wrong = [row[0] for row in found if len(row) != PAGES[page] or not ID.fullmatch(row[0])
             or not all(row) or not is_there(row[-1])]
    assert wrong == []


@pytest.mark.parametrize("place, there", [
    ("`fixel/render.h` `fxl_render`", True), ("`fixel/render.h` `fxl_no_such_name`", False), ("`SPEC` 3.1", True), ("`SPEC` 3.99", False), ("`SPEC` 11", True),
    ('`docs/results.md` "Boards"', True), ('`docs/results.md` "Board"', False), ("docs/results.md", False)])
def test_a_place_that_is_not_there_is_found(place, there):
    assert is_there(place) is there


def test_the_pages_promise_no_certificate():
    for page in (*PAGES, "rules.md"):
        text = (CHECKOUT / "docs" / "safety" / page).read_text(encoding="utf-8")
        assert "evidence for your argument" in text and not re.search(r"\bcertified\b|\bcompliant\b", text)
