# SPDX-License-Identifier: MIT
"""The statuses in the docstrings of public headers: one a line, each with its reason."""

import re

import pytest

from conftest import CHECKOUT

INCLUDE = CHECKOUT / "lib" / "include"
# Those of the study's archive are beside their code. types.h defines the statuses.
HEADERS = [file for file in sorted([*INCLUDE.rglob("*.h"), *(CHECKOUT / "lib" / "study").glob("*.h")]) if file.name != "types.h"]
OWN_LINE = re.compile(r"FXL_E_[A-Z_]+: \S.*")
IN_A_SENTENCE = re.compile(r"\b(?:answers?|refuses \w+ with) FXL_E_[A-Z_]+")


def badly_placed(text):
    """Lines of comments in which a status neither begins the line with its reason nor is what a named function answers."""
    wrong = []
    for comment in re.findall(r"/\*.*?\*/", text, re.DOTALL):
        for line in comment.splitlines():
            words = re.sub(r"^\s*/?\*+ ?|\s*\*/$", "", line)
            left = IN_A_SENTENCE.sub("", words)
            if "FXL_E_" in left and not (OWN_LINE.fullmatch(left) and left.count("FXL_E_") == 1):
                wrong.append(words)
    return wrong


@pytest.mark.parametrize("file", HEADERS, ids=lambda file: str(file.relative_to(CHECKOUT / "lib")))
def test_each_status_has_a_line_and_a_reason(file):
    assert badly_placed(file.read_text(encoding="utf-8")) == []


def test_what_is_not_so_is_found():
    assert badly_placed("/* Draws.\n * FXL_E_RANGE: the eye.\n * With each of these statuses: pixels untouched. */") == []
    assert badly_placed("/* fxl_frame_begin answers FXL_E_ORDER until both are set. */") == []
    for text in ("/* Draws. FXL_E_RANGE: the eye. */", "/* FXL_E_ARGUMENT, FXL_E_RANGE (eye): untouched. */", "/* FXL_E_RANGE. */",
                 "/* Draws.\n * FXL_E_RANGE */", "/* FXL_E_RANGE: the eye. FXL_E_ORDER: no frame. */"):
        assert badly_placed(text), text


def test_there_are_many():
    lines = [line for file in HEADERS for line in file.read_text(encoding="utf-8").splitlines()
             if re.match(r"\s*(?:/\*|\*) FXL_E_", line)]
    assert len(lines) > 150
