# SPDX-License-Identifier: MIT
"""Tables as text of C: constant arrays that are laid out for people, and headers that several files may include."""

import typing

WIDTH = 100     # columns of a line
INDENT = "    "


def braces(*parts):
    """An initialiser: {1, 2, {3, 4}}."""
    return "{" + ", ".join(map(str, parts)) + "}"


def lines(items):
    """Items with commas, as many to a line as fit."""
    made, line = [], INDENT
    for i, item in enumerate(items):
        text = item if i == len(items) - 1 else item + ","
        if line != INDENT and len(line) + 1 + len(text) > WIDTH:
            made.append(line)
            line = INDENT
        line += text if line == INDENT else " " + text
    return made + [line]


def comment(text):
    """A comment of one or more lines; a line that is too long is broken between two words."""
    made, line = [], "/*"
    for word in f"{text} */".split():
        if len(line) + 1 + len(word) > WIDTH and line != " *":
            made.append(line)
            line = " *"
        line += " " + word
    return made + [line]


class Table(typing.NamedTuple):
    """A constant array or record of a header: its declaration with a comment above it, and its definition."""
    declaration: str
    definition: str


def _table(kind, declarator, about, body):
    return Table("\n".join([*(comment(about) if about else []), f"extern const {kind} {declarator};"]),
                 "\n".join([f"FXL_SHARED const {kind} {declarator} = {{", *body, "};", ""]))


def table(kind, name, items, about=None, dimensions=None):
    """const KIND NAME[dimensions] = {...}; dimensions: where they are not the number of items; items beyond those that
    are given are 0."""
    sizes = "".join(f"[{size}]" for size in dimensions or [len(items)])
    return _table(kind, f"{name}{sizes}", about, lines(items))


def record(kind, name, rows, about=None):
    """const KIND NAME = {...}; of rows of members."""
    return _table(kind, name, about, [f"{INDENT}{row}," for row in rows[:-1]] + [INDENT + rows[-1]])


def header(about, guard, includes, parts):
    """The text of a header. about: what it holds; parts: Tables, and other text, which goes before the tables."""
    declare = f"{guard.removesuffix('_H')}_DECLARE"
    tables = [part for part in parts if isinstance(part, Table)]
    return "\n".join([
        *comment(f"{about} Several files of a program, in C or C++, may include this header: the linker keeps one of "
                 f"each table. A file that defines {declare} before it includes the header gets the declarations alone."),
        f"#ifndef {guard}", f"#define {guard}", "", *(f"#include <{name}>" for name in includes), "",
        *(part for part in parts if isinstance(part, str)),
        *_as_c([each.declaration for each in tables] + [""]), f"#endif /* {guard} */", "",
        f"#if !defined {declare} && !defined {guard}_TABLES", f"#define {guard}_TABLES", "",
        *_as_c([each.definition for each in tables]), "#endif", ""])


def _as_c(texts):
    """Declarations whose names are those of C, in C++ too."""
    return ["#ifdef __cplusplus", 'extern "C" {', "#endif", "", *texts, "#ifdef __cplusplus", "}", "#endif", ""]


def split64(value):
    """A number of 64 bits as two halves: low, high."""
    value &= (1 << 64) - 1
    return f"0x{value & 0xFFFFFFFF:08X}u", f"0x{value >> 32:08X}u"
