# SPDX-License-Identifier: MIT
"""The public headers: which there are, what they include, that programs or pages use each of their functions, and the statuses in their
docstrings: one a line, each with its reason."""

import pathlib
import re

import pytest

from conftest import CHECKOUT

BUILT_PROGRAMS = ()
PUBLIC = CHECKOUT / "lib" / "include"
COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*["<]([^">]+)[">]', re.MULTILINE)
FUNCTION = re.compile(r"^(?!typedef|static_assert)[a-z][\w \t*]*?\b(fxl_\w+)\([^;{}]*\)\s*[;{]", re.MULTILINE)
PROGRAMS = ("examples/*/*.[ch]", "firmware/walk/*.[ch]", "firmware/game/*.[ch]", "boards/*/*.[ch]")
# Pages that tell a reader how to use something. The others are indices: they name whatever there is.
PAGES = ("README.md", "docs/*.md", "docs/extras/*.md")
INDICES = {"seeds.md", "performance.md", "opengl.md", "accuracy.md"}
CODE = re.compile(r"^```c\n(.*?)^```", re.MULTILINE | re.DOTALL)


def public_headers():
    return sorted(file for file in PUBLIC.rglob("*") if file.is_file())


def files(patterns):
    return sorted(file for pattern in patterns for file in CHECKOUT.glob(pattern) if file.name not in INDICES)


def code_of(text):
    return COMMENT.sub(" ", text)


def functions(header):
    """The functions that the text of a header declares."""
    return list(dict.fromkeys(FUNCTION.findall(code_of(header))))


def programs():
    """{where: text} of what a reader may take for a model: programs, and those in the pages."""
    found = {str(file.relative_to(CHECKOUT)): file.read_text(encoding="utf-8") for file in files(PROGRAMS)}
    for page in files(PAGES):
        found[str(page.relative_to(CHECKOUT))] = "\n".join(CODE.findall(page.read_text(encoding="utf-8")))
    return found


def inside(name):
    """Whether an include names a header of a room of the library: one that is not public."""
    return (CHECKOUT / "lib" / name).is_file() or "lib/" in name


def test_public_headers_include_public_ones_alone():
    strange = [f"{header.relative_to(PUBLIC)} includes {name}" for header in public_headers()
               for name in INCLUDE.findall(header.read_text(encoding="utf-8"))
               if not (PUBLIC / name).is_file() and name not in ("stdbool.h", "stddef.h", "stdint.h")]
    assert strange == []


def test_all_h_includes_every_public_header():
    text = (PUBLIC / "fixel" / "all.h").read_text(encoding="utf-8")
    reached, waiting = set(), INCLUDE.findall(text)
    while waiting:
        name = waiting.pop()
        if (PUBLIC / name).is_file() and name not in reached:
            reached.add(name)
            waiting += INCLUDE.findall((PUBLIC / name).read_text(encoding="utf-8"))
    assert reached == {str(header.relative_to(PUBLIC)) for header in public_headers()} - {"fixel/all.h"}


def test_programs_include_public_headers_alone():
    """The study's header is for programs that link the study."""
    strange = [f"{where} includes {name}" for where, text in programs().items() for name in INCLUDE.findall(text)
               if inside(name) and not name.startswith("study/")]
    assert strange == []


def unused(headers, texts):
    """["header: function"] that none of the texts names."""
    words = set(re.findall(r"\bfxl_\w+", "\n".join(texts)))
    return [f"{name}: {function}" for name, text in headers.items() for function in functions(text) if function not in words]


def test_a_program_or_a_page_uses_each_public_function():
    headers = {str(header.relative_to(PUBLIC)): header.read_text(encoding="utf-8") for header in public_headers()}
    assert sum(len(functions(text)) for text in headers.values()) > 80
    texts = [code_of(file.read_text(encoding="utf-8")) for file in files(PROGRAMS)]
    texts += [page.read_text(encoding="utf-8") for page in files(PAGES)]
    assert unused(headers, texts) == []


@pytest.mark.parametrize("header, found", [
    ("fxl_status fxl_new(int a,\n                   int b);\n", ["h: fxl_new"]), ("static inline bool fxl_new(int a)\n{\n}\n", ["h: fxl_new"]),
    ("const fxl_x *fxl_new(void);", ["h: fxl_new"]), ("/* void fxl_new(void); */", []), ("typedef void (*fxl_new)(int);", []),
    ("void fxl_used(void);", [])])
def test_a_function_that_nobody_uses_is_seen(header, found):
    assert unused({"h": header}, ["fxl_used(); fxl_other"]) == found


@pytest.mark.parametrize("name, expected", [("draw/stages.h", True), ("../../lib/math/arith.h", True), ("fixel/render.h", False),
                                            ("fixel.h", False), ("stdio.h", False), ("cube_scene.h", False)])
def test_an_include_of_a_room_is_seen(name, expected):
    assert inside(name) == expected


# --- statuses, and the sentences that explain them ----------------------------------

# Those of the study's archive are beside their code. types.h defines the statuses.
HEADERS = [file for file in sorted([*PUBLIC.rglob("*.h"), *(CHECKOUT / "lib" / "study").glob("*.h")]) if file.name != "types.h"]
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


STATUSES = re.findall(r"^    (FXL_E_\w+)", (PUBLIC / "fixel" / "types.h").read_text(encoding="utf-8"), re.MULTILINE)
DECLARED = re.compile(r"/\*((?:(?!\*/).)*)\*/\s*((?:(?:static inline )?fxl_status fxl_\w+\([^;{]*[;{]\s*)+)", re.DOTALL)
ANSWERED = re.compile(r"^ \* (FXL_E_\w+): ", re.MULTILINE)
AS_OTHERS = re.compile(r"The statuses of (fxl_[^:,.]*)|Otherwise as\s(?:\* )?(fxl_\w+)")


def answers():
    """{header: {function: statuses}} of the public functions that answer one, by their docstrings, those of others included."""
    found, others = {}, {}
    for file in HEADERS:
        if file.is_relative_to(PUBLIC):
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
        assert f"fxl_{header}_reasons[]" in (PUBLIC / "fixel" / f"{header}.h").read_text(encoding="utf-8")
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
