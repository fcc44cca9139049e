#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Which sources of the library a program needs, so that make compiles no others for it.

    needs.py LIBRARY_SOURCE... -- PROGRAM_SOURCE... > needs.mk

Writes a variable of make for each source of a program, and for each record of the library, by which make chooses a
clipper, a visibility method or a driver: LIB_NEEDS.<source or record> := the library's sources without lib/ and ending.
For a unit test another variable has the sources beside it whose headers it includes, which need the library too:
UNIT_HELPERS.<source> := their names without folder and ending.

A source needs another if it, or the code in a header that it includes, contains a name that the other defines. No
condition of the preprocessor is heeded, so a source may be named that no core needs. If one were missed, the program
would not link.
"""

import functools
import os
import pathlib
import re
import sys

FOLDERS = ("lib/include", "lib", "firmware/walk", "boards", "examples", "host_tests", "host_tests/judges", "host_tests/stages",
           "host_tests/unit")
UNIT_TESTS = "host_tests/unit"
COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*["<]([^">]+)[">]', re.MULTILINE)
DIRECTIVE = re.compile(r"^[ \t]*#(?:\\\n|[^\n])*", re.MULTILINE)
MACRO = re.compile(r"^[ \t]*#[ \t]*define\b(?:\\\n|[^\n])*", re.MULTILINE)
FOR_CPP = re.compile(r'extern\s+"C"\s*\{')
NAME = re.compile(r"\bfxl_\w+")
FUNCTION = re.compile(r"\b(fxl_\w+)\s*\([^;{}]*\)\s*\{")
RECORD = re.compile(r"\b(fxl_\w+)\s*(?:\[[^\]]*\]\s*)*=")
NAMED_BY_MACRO = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(\w+)[ \t]+(fxl_\w+)[ \t]*$", re.MULTILINE)
PASTES = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(\w+)\((\w+)\)[ \t]+\(&\2##(\w+)\)", re.MULTILINE)     # FXL_SURFACES_OF
IN_PLACE = re.compile(r"\bFXL_IN_PLACE(?:_LARGE)?\b[^;{}()]*\b(fxl_\w+)\s*\(")      # lib/math/arith.h
LABEL = re.compile(r"^\s*\.glob(?:a|)l\s+(fxl_\w+)", re.MULTILINE)


@functools.cache
def text_of(file):
    """A file without its comments."""
    return FOR_CPP.sub("", COMMENT.sub(" ", pathlib.Path(file).read_text(encoding="utf-8")))


@functools.cache
def split_at_braces(text):
    """(what stands outside of all braces, with {} for each pair, what stands inside)."""
    outside, inside, depth = [], [], 0
    for part in re.split(r"([{}])", DIRECTIVE.sub("", text)):
        if part == "{":
            outside += ["{"] * (not depth)
            depth += 1
        elif part == "}":
            depth -= 1
            outside += ["}"] * (not depth)
        else:
            (inside if depth > 0 else outside).append(part)
    return "".join(outside), " ".join(inside)


@functools.cache
def included(file):
    """The project's files that a file includes, those of its headers too, and the file."""
    found = {file}
    for name in INCLUDE.findall(text_of(file)):
        for folder in (os.path.dirname(file), *FOLDERS):
            path = os.path.normpath(os.path.join(folder, name))
            if os.path.isfile(path):
                found |= included(path)
                break
    return found


@functools.cache
def names_in_header(file):
    """The names in a header's code: it declares more than who includes it uses."""
    text = text_of(file)
    return set(NAME.findall(split_at_braces(text)[1])) | set(NAME.findall(" ".join(MACRO.findall(text))))


def pasted_names(file):
    """The names that the code of a source, and what it includes, makes of another, as FXL_SURFACES_OF(fxl_palette) does.
    Where a macro passes on an argument of its own, that may be any name in the file."""
    texts = [text_of(each) for each in included(file)]
    pastes = {macro: end for text in texts for macro, _, end in PASTES.findall(text)}
    found = set()
    for text in texts:
        for macro, end in pastes.items():
            for argument in re.findall(rf"(?<!define )\b{macro}\((\w+)\)", text):
                found |= {name + end for name in ([argument] if NAME.fullmatch(argument) else NAME.findall(text))}
    return found


@functools.cache
def names_in(file):
    """All names that the code of a source may use."""
    found = set(NAME.findall(text_of(file))) | pasted_names(file)
    return found.union(*(names_in_header(header) for header in included(file) - {file}))


def definitions(sources):
    """({name: sources that define it}, the names that are records). A kernel stands in a file for each family of cores. A
    source may define, by a macro, the name of what a header of code defines."""
    where, records = {}, set()
    for source in sources:
        text = {file: text_of(file) for file in included(source)}
        named = set(RECORD.findall(split_at_braces(text[source])[0]))
        for macro, name in NAMED_BY_MACRO.findall(text[source]):
            if any(re.search(rf"\b{macro}\s*(?:=|\([^;{{}}]*\)\s*\{{)", split_at_braces(code)[0]) for code in text.values()):
                named.add(name)
        records |= named
        if "#define FXL_HERE" in text[source]:
            named = named.union(*map(IN_PLACE.findall, text.values()))
        named = named.union(FUNCTION.findall(split_at_braces(text[source])[0]), *map(LABEL.findall, text.values()))
        for name in named:
            where.setdefault(name, set()).add(source)
    return where, records


def closure(names, where):
    """The library's sources that define these names, and those that they need."""
    needed, waiting = set(), list(names)
    while waiting:
        for source in where.get(waiting.pop(), set()) - needed:
            needed.add(source)
            waiting += names_in(source)
    return sorted(os.path.splitext(source)[0].removeprefix("lib/") for source in needed)


@functools.cache
def with_helpers(source):
    """A source of the unit tests, and the sources beside it of the headers that it and these include."""
    found, waiting = set(), [source]
    while waiting:
        each = waiting.pop()
        if each not in found:
            found.add(each)
            beside = (os.path.splitext(file)[0] + ".c" for file in included(each) if os.path.dirname(file) == UNIT_TESTS)
            waiting += filter(os.path.isfile, beside)
    return sorted(found)


def main(argv):
    division = argv.index("--")
    where, records = definitions(argv[:division])
    for source in argv[division + 1:]:
        program = with_helpers(source) if os.path.dirname(source) == UNIT_TESTS else [source]
        print(f"LIB_NEEDS.{source} := {' '.join(closure(set().union(*map(names_in, program)), where))}")
        if len(program) > 1:
            helpers = (os.path.splitext(os.path.basename(each))[0] for each in program if each != source)
            print(f"UNIT_HELPERS.{source} := {' '.join(helpers)}")
    for record in sorted(records):
        print(f"LIB_NEEDS.{record} := {' '.join(closure([record], where))}")


if __name__ == "__main__":
    main(sys.argv[1:])
