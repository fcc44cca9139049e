#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Which sources of the library a program needs, so that make compiles no others for it.

    needs.py LIBRARY_SOURCE... -- PROGRAM_SOURCE... > needs.mk
    needs.py --conditions FILE LIBRARY_SOURCE...

Writes a variable of make for each source of a program, and for each record of the library, by which make chooses a
clipper, a visibility method or a driver: LIB_NEEDS.<source or record> := the library's sources without lib/ and ending.
For a unit test another variable has the sources beside it whose headers it includes, which need the library too:
UNIT_HELPERS.<source> := their names without folder and ending.

A source needs another if it, or the code in a header that it includes, contains a name that the other defines. No
condition of the preprocessor is heeded, so a source may be named that no core needs. If one were missed, the program
would not link.

Of the sources all of whose lines stand under conditions, some have none for a core. --conditions writes FILE.c and FILE.S, with the
conditions of those in C and of those in assembly, and FILE.mk: LIB_CONDITIONAL := their names. In what a compiler's preprocessor prints
of FILE.c and FILE.S, "fxl_text_of" stands before the name of each source that has lines for its core, and at the end before FILE.c and FILE.S.
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
CALL = re.compile(r"(?<!define )\b(\w+)\((\w+)\)")      # of a macro with one name
NAMED_BY_MACRO = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(\w+)[ \t]+(fxl_\w+)[ \t]*$", re.MULTILINE)
PASTES = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(\w+)\((\w+)\)[ \t]+\(&\2##(\w+)\)", re.MULTILINE)     # FXL_SURFACES_OF
IN_PLACE = re.compile(r"\bFXL_IN_PLACE(?:_LARGE)?\b[^;{}()]*\b(fxl_\w+)\s*\(")      # lib/math/arith.h
STRING = re.compile(r'"(?:\\.|[^"\\\n])*"')
WORD = re.compile(r"\w+")
ATTRIBUTE = re.compile(r"__attribute__\s*\(\(.*?\)\)", re.DOTALL)
OWN_FUNCTION = re.compile(r"\b(?:static|FXL_IN_PLACE|FXL_IN_PLACE_LARGE|FXL_ONCE|FXL_APART)\b[^()]*?(\w+)\s*\(")
LABEL = re.compile(r"^\s*\.glob(?:a|)l\s+(fxl_\w+)", re.MULTILINE)


@functools.cache
def text_of(file):
    """A file without its comments."""
    return FOR_CPP.sub("", COMMENT.sub(" ", pathlib.Path(file).read_text(encoding="utf-8")))


@functools.cache
def split_at_braces(text):
    """(what stands outside of all braces, with {} for each pair, what stands inside: [(the text before the brace, the text inside)])."""
    outside, inside, depth = [], [], 0
    for part in re.split(r"([{}])", DIRECTIVE.sub("", text)):
        if part == "{":
            if depth == 0:
                inside.append((outside[-1] if outside else "", []))
                outside.append("{")
            depth += 1
        elif part == "}":
            depth -= 1
            outside += ["}"] * (not depth)
        else:
            (inside[-1][1] if depth > 0 else outside).append(part)
    return "".join(outside), [(before, " ".join(parts)) for before, parts in inside]


@functools.cache
def included(file):
    """The project's files that a file includes, those of its headers too, and the file."""
    return {file} | included_by(file, text_of(file))


def included_by(file, text):
    """The project's files that a part of a file includes, those of its headers too."""
    found = set()
    for name in INCLUDE.findall(text):
        path = path_of(file, name)
        found |= included(path) if path else set()
    return found


def path_of(file, name):
    """The project's file that an #include of another names, or None."""
    paths = (os.path.normpath(os.path.join(folder, name)) for folder in (os.path.dirname(file), *FOLDERS))
    return next(filter(os.path.isfile, paths), None)


@functools.cache
def words_of(text):
    """The words of a text that stand in no string."""
    return frozenset(WORD.findall(STRING.sub(" ", text)))


@functools.cache
def parts_of(header):
    """{a macro, or a function that each source has for itself: the words of what it stands for; None: those of the rest of the code}."""
    found = {None: set()}
    for macro in MACRO.findall(text_of(header)):
        name, *words = WORD.findall(STRING.sub(" ", macro))[1:]
        found.setdefault(name, set()).update(words)
    for before, body in split_at_braces(text_of(header))[1]:
        own = OWN_FUNCTION.search(ATTRIBUTE.sub("", before.rpartition(";")[2])) if not before.rstrip().endswith("=") else None
        found.setdefault(own and own[1], set()).update(words_of(body))
    return found


@functools.cache
def found_in(text, pattern):
    return frozenset(pattern.findall(text))


def pasted_names(file):
    """The names that the code of a source, and what it includes, makes of another, as FXL_SURFACES_OF(fxl_palette) does.
    Where a macro passes on an argument of its own, that may be any name in the file."""
    texts = [text_of(each) for each in included(file)]
    pastes = {macro: end for text in texts for macro, _, end in found_in(text, PASTES)}
    found = set()
    for text in texts:
        for macro, argument in found_in(text, CALL):
            if macro in pastes:
                found |= {name + pastes[macro] for name in ([argument] if NAME.fullmatch(argument) else found_in(text, NAME))}
    return found


@functools.cache
def names_in(file):
    """All names that the code of a source may use. A header has more than who includes it uses: of its macros, and of the functions
    that each source has for itself, those count that are named."""
    parts = [parts_of(header) for header in included(file) - {file}]
    meant = {}
    for each in parts:
        for word, words in each.items():
            meant.setdefault(word, []).append(words)
    words = set(words_of(text_of(file))).union(*meant.pop(None, ()))
    waiting = list(words & meant.keys())
    while waiting:
        more = set().union(*meant[waiting.pop()]) - words
        words |= more
        waiting += more & meant.keys()
    return {word for word in words if word.startswith("fxl_")} | pasted_names(file)


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
        before, _, after = text[source].partition("#define FXL_HERE")
        named = named.union(*(IN_PLACE.findall(text[file]) for file in included_by(source, after) - included_by(source, before)))
        named = named.union(FUNCTION.findall(split_at_braces(text[source])[0]), *map(LABEL.findall, text.values()))
        for name in named:
            where.setdefault(name, set()).add(source)
    return where, records


def closure(names, where, needs):
    """The library's sources that define these names, and those that they need. needs: {source: what it needs}, which is filled in."""
    needed, waiting = set(), set().union(*(where[name] for name in names if name in where))
    while waiting:
        needed |= waiting
        for source in waiting - needs.keys():
            needs[source] = set().union(*(where[name] for name in names_in(source) if name in where))
        waiting = set().union(*map(needs.get, waiting)) - needed
    return sorted(_name(source) for source in needed)


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


def _lines(source):
    """The directives of a source, with None for other lines; one in assembly may include another, whose lines stand there."""
    for line in re.split(r"(?<!\\)\n", text_of(source)):
        include = INCLUDE.match(line)
        if include and include[1].endswith(".S"):
            yield from _lines(os.path.normpath(os.path.join(os.path.dirname(source), include[1])))
        elif line.lstrip().startswith("#"):
            yield line.strip()
        elif line.strip() and not line.lstrip().startswith(".global"):
            yield None


def conditions(source):
    """What of a source its preprocessor must read to find whether it has lines for a core, or nothing: it has some for each."""
    found, depth, defined = [], 0, set()
    for line in _lines(source):
        word = re.match(r"#\s*(\w+)\s*(\w*)", line or "#")
        if line is None:
            if depth == 0:
                return []
            found += [f"fxl_text_of {_name(source)}"] * (not found[-1].startswith("fxl_text_of"))
            continue
        if word[1] == "include":
            path = path_of(source, INCLUDE.match(line)[1])
            line = f'#include "{path}"' if path else line
        depth += word[1].startswith("if") - (word[1] == "endif")
        defined |= {word[2]} if word[1] == "define" else set()
        found.append(line)
    return [*found, *(f"#undef {name}" for name in sorted(defined))] if any(line.startswith("fxl_text_of") for line in found) else []


def _name(source):
    return os.path.splitext(source)[0].removeprefix("lib/")


def write_conditions(file, sources):
    """FILE.c, FILE.S and FILE.mk. A make may read them while another writes them."""
    found = {source: lines for source in sources if (lines := conditions(source))}
    texts = {".mk": [f"LIB_CONDITIONAL := {' '.join(map(_name, found))}"]}
    for ending in (".c", ".S"):
        texts[ending] = [*(line for source in found if source.endswith(ending) for line in found[source]),
                         f"fxl_text_of {os.path.basename(file)}{ending}"]
    for ending in (".c", ".S", ".mk"):
        new = f"{file}{ending}.{os.getpid()}"
        pathlib.Path(new).write_text("\n".join([*texts[ending], ""]), encoding="utf-8")
        os.replace(new, file + ending)


def main(argv):
    if argv[0] == "--conditions":
        write_conditions(argv[1], argv[2:])
        return
    division = argv.index("--")
    (where, records), needs = definitions(argv[:division]), {}
    for source in argv[division + 1:]:
        program = with_helpers(source) if os.path.dirname(source) == UNIT_TESTS else [source]
        print(f"LIB_NEEDS.{source} := {' '.join(closure(set().union(*map(names_in, program)), where, needs))}")
        if len(program) > 1:
            helpers = (os.path.splitext(os.path.basename(each))[0] for each in program if each != source)
            print(f"UNIT_HELPERS.{source} := {' '.join(helpers)}")
    for record in sorted(records):
        print(f"LIB_NEEDS.{record} := {' '.join(closure([record], where, needs))}")


if __name__ == "__main__":
    main(sys.argv[1:])
