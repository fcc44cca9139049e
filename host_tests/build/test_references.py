# SPDX-License-Identifier: MIT
"""Cross references: each page, section and heading that a document, a comment or a message cites is there."""

import functools
import re
import subprocess

import pytest

from conftest import CHECKOUT

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
            and name not in ("CHANGELOG.md", "host_tests/build/test_references.py")]


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
