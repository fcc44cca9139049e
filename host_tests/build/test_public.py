# SPDX-License-Identifier: MIT
"""The public headers: which there are, what they include, and that programs or pages use each of their functions."""

import pathlib
import re

import pytest

from conftest import CHECKOUT

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
