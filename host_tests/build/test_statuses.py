# SPDX-License-Identifier: MIT
"""The statuses in the docstrings of public headers: one a line, each with its reason; and the sentences that explain them."""

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


STATUSES = re.findall(r"^    (FXL_E_\w+)", (INCLUDE / "fixel" / "types.h").read_text(encoding="utf-8"), re.MULTILINE)
DECLARED = re.compile(r"/\*((?:(?!\*/).)*)\*/\s*((?:(?:static inline )?fxl_status fxl_\w+\([^;{]*[;{]\s*)+)", re.DOTALL)
ANSWERED = re.compile(r"^ \* (FXL_E_\w+): ", re.MULTILINE)
AS_OTHERS = re.compile(r"The statuses of (fxl_[^:,.]*)|Otherwise as\s(?:\* )?(fxl_\w+)")


def answers():
    """{header: {function: statuses}} of the public functions that answer one, by their docstrings, those of others included."""
    found, others = {}, {}
    for file in HEADERS:
        if file.is_relative_to(INCLUDE):
            for text, functions in DECLARED.findall(file.read_text(encoding="utf-8")):
                for name in re.findall(r"\bfxl_status (fxl_\w+)\(", functions):
                    found.setdefault(file.stem, {})[name] = set(ANSWERED.findall(text))
                    others[name] = re.findall(r"fxl_\w+", " ".join("".join(pair) for pair in AS_OTHERS.findall(text)))
    own = {name: statuses for functions in found.values() for name, statuses in functions.items()}
    for _ in range(4):  # the longest chain: fxl_pump_frame, fxl_pump_send, fxl_pixels_convert
        for name, statuses in own.items():
            statuses.update(status for other in others[name] for status in own[other])
    return found


def lists():
    """{header: {status: sentence}} of the library."""
    text = "".join(file.read_text(encoding="utf-8") for file in sorted((CHECKOUT / "lib").glob("*/reasons*.[ch]")))
    names = dict(re.findall(r'^#define (\w+)\s+("\\\d{3}")$', text, re.MULTILINE))
    number = {f'"\\{index:03o}"': status for index, status in enumerate(STATUSES, 1)}
    found = {}
    for header, body in re.findall(r"^const char fxl_(\w+)_reasons\[\] =\n(.*?);$", text, re.MULTILINE | re.DOTALL):
        rows = re.findall(r'^    (\w+) ((?:\s*"[^"\n]*")+)', body, re.MULTILINE)
        sentences = {number[names[name]]: "".join(re.findall(r'"([^"]*)"', said)) for name, said in rows}
        assert [name.replace("ON_", "FXL_E_") for name, _ in rows] == list(sentences), header
        found[header] = sentences
    return found


def test_each_status_of_each_public_function_has_a_sentence():
    by_header = answers()
    assert sum(len(functions) for functions in by_header.values()) > 80
    wanted = {header: set().union(*functions.values()) for header, functions in by_header.items()}
    assert {header: set(sentences) for header, sentences in lists().items()} == wanted


def test_each_sentence_says_what_must_be():
    for header, sentences in lists().items():
        assert f"fxl_{header}_reasons[]" in (INCLUDE / "fixel" / f"{header}.h").read_text(encoding="utf-8")
        for status, said in sentences.items():
            assert said.endswith("\\0") and re.search(r"\bmust\b", said), (header, status)


def test_each_conflict_has_a_sentence_that_begins_with_both_names():
    draw = CHECKOUT / "lib" / "draw"
    text = (draw / "conflict.c").read_text(encoding="utf-8")
    names = {part: name for name, part in re.findall(r'"([^"]+)", /\* (FXL_HAS_\w+) \*/', text)}
    pairs = re.findall(r"\{(FXL_HAS_\w+), (FXL_HAS_\w+)\}", (draw / "combination.c").read_text(encoding="utf-8"))
    said = {(first, second): "".join(re.findall(r'"([^"]*)"', words)) for first, second, words in
            re.findall(r'\{(FXL_HAS_\w+), (FXL_HAS_\w+),((?:\s*"[^"]*")+)\}', text)}
    assert len(pairs) >= 10 and set(said) == set(pairs)
    for (first, second), words in said.items():
        assert re.match(rf"{names[first]} and {names[second]} do not go together: \S", words)
