# SPDX-License-Identifier: MIT
"""Tables as text of C: constant arrays that are laid out for people."""

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


def table(kind, name, items, about=None, dimensions=None):
    """static const KIND NAME[dimensions] = {...}; with a comment above it. dimensions: where they are
    not the number of items; items beyond those that are given are 0."""
    sizes = "".join(f"[{size}]" for size in dimensions or [len(items)])
    return "\n".join([*(comment(about) if about else []),
                      f"static const {kind} {name}{sizes} = {{", *lines(items), "};", ""])


def split64(value):
    """A number of 64 bits as two halves: low, high."""
    value &= (1 << 64) - 1
    return f"0x{value & 0xFFFFFFFF:08X}u", f"0x{value >> 32:08X}u"
