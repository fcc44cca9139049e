# SPDX-License-Identifier: MIT
"""The files that a release and its readers need: the changelog, the citation, the issue templates, the way to report a defect."""

import re

import pytest

from conftest import CHECKOUT
from fixel.base.version import version

TEMPLATES = sorted((CHECKOUT / ".github" / "ISSUE_TEMPLATE").glob("*.md"))
KINDS = {"Added", "Changed", "Deprecated", "Removed", "Fixed", "Security"}
FIRST = "0.9.0"     # its changes stand by subject


def page(name):
    return (CHECKOUT / name).read_text(encoding="utf-8")


def complaints(changelog, current):
    """What is wrong with the headings of a changelog, as sentences."""
    found = re.findall(r"^## (.*)$", changelog, re.MULTILINE)
    wrong = [] if found[:1] == ["[Unreleased]"] else ["[Unreleased] is not the first heading"]
    numbers = []
    for heading in found[1:]:
        parts = re.fullmatch(r"\[(\d+)\.(\d+)\.(\d+)\] - (\d{4}-\d\d-\d\d|not released)", heading)
        if not parts:
            wrong.append(f"{heading} is no version with a date")
            continue
        numbers.append(tuple(map(int, parts.groups()[:3])))
        if parts[4] == "not released" and len(numbers) > 1:
            wrong.append(f"{heading}: a later version has been released")
    if not numbers or ".".join(map(str, numbers[0])) != current:
        wrong.append(f"{current} is not the newest version")
    if numbers != sorted(set(numbers), reverse=True):
        wrong.append("the versions do not go down")
    later = changelog.split(f"\n## [{FIRST}]", 1)[0]
    wrong += [f"{name} is no kind of change" for name in re.findall(r"^### (.*)$", later, re.MULTILINE) if name not in KINDS]
    return wrong


def test_the_changelog_has_the_headings_of_keep_a_changelog():
    assert complaints(page("CHANGELOG.md"), version()) == []


@pytest.mark.parametrize("text, wrong", [
    ("## [0.9.0] - 2030-01-02\n", "[Unreleased] is not the first heading"),
    ("## [Unreleased]\n\n## 0.9.0\n", "0.9.0 is no version with a date"),
    ("## [Unreleased]\n\n## [0.8.0] - 2030-01-02\n", "0.9.0 is not the newest version"),
    ("## [Unreleased]\n\n## [0.9.0] - 2030-01-02\n\n## [0.10.0] - 2030-01-02\n", "the versions do not go down"),
    ("## [Unreleased]\n\n## [0.9.0] - 2030-01-02\n\n## [0.8.0] - not released\n", "[0.8.0] - not released: a later version has been released"),
    ("## [Unreleased]\n\n### Models\n\n## [0.9.0] - 2030-01-02\n\n### Models\n", "Models is no kind of change"),
])
def test_a_wrong_heading_is_seen(text, wrong):
    assert wrong in complaints(f"# Changelog\n\n{text}", "0.9.0")


def test_the_citation_has_what_the_format_demands_and_the_version():
    found = dict(re.findall(r"^([a-z-]+):(?: +(.*))?$", page("CITATION.cff"), re.MULTILINE))
    assert {"cff-version", "message", "title", "authors"} <= set(found), "the format's required keys"
    assert found["cff-version"] == "1.2.0" and found["type"] == "software"
    assert found["version"] == version() and found["license"] == "MIT"
    assert re.search(r"^authors:\n  - name: \S", page("CITATION.cff"), re.MULTILINE)


@pytest.mark.parametrize("template", TEMPLATES, ids=lambda file: file.stem)
def test_an_issue_template_begins_with_its_name(template):
    head, body = re.fullmatch(r"---\n(.*?)\n---\n\n(.*)", template.read_text(encoding="utf-8"), re.DOTALL).groups()
    fields = dict(line.split(": ", 1) for line in head.splitlines())
    assert set(fields) == {"name", "about", "labels"} and all(fields.values())
    assert body.count("**") >= 6, "it asks for three things at least"
    for name in re.findall(r"\b(?:[\w-]+/)*[\w-]+\.md\b", body + head):
        assert (CHECKOUT / name).is_file(), name


def test_a_defect_that_others_could_attack_by_is_told_in_private():
    assert [file.stem for file in TEMPLATES] == ["defect", "result", "wish"]
    assert "SECURITY.md" in TEMPLATES[0].read_text(encoding="utf-8")
    told = page("SECURITY.md").split("\n## Telling us\n", 1)[1]
    assert "Report a vulnerability" in told and re.search(r"^2\. ", told, re.MULTILINE)
