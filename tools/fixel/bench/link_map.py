# SPDX-License-Identifier: MIT
"""How many bytes a program takes, by who brought them: the linker's map."""

import collections
import pathlib
import re

from fixel.base.errors import ToolError

# A section of an input file; a long name stands on a line of its own.
SECTION = re.compile(r"^ (\.[a-zA-Z]\S*)\s+0x([0-9a-f]+)\s+0x([0-9a-f]+)\s+(\S.*)$", re.MULTILINE)
CODE, CONSTANTS = (".text",), (".rodata", ".data")
RAM = (".data", ".bss")
# The compiler's and the C library's archives, and the memory functions that stand in for the
# latter: bytes that come along.
RUN_TIME = re.compile(r"/lib(gcc|c|m|g)(_nano)?\.a\(|/memory_functions\.o$")
# A function of the compiler's arithmetic: a member of its archive.
HELPER = re.compile(r"/libgcc\.a\((\w+)\.o\)$")
# What -flto makes of all files: a temporary one, whose name is new with each link.
TOGETHER = re.compile(r"^\w+\.(ltrans\d+)\.ltrans$")


def measure(path):
    """{"code", "constants", "run_time", "ram", "helpers", "files"}: bytes of code and of constants by
    the program's own files, of both by the run-time libraries, of variables by all; the names of the
    compiler's arithmetic that was linked; and {file: bytes} of the program's own, the largest first."""
    total = {"code": 0, "constants": 0, "run_time": 0, "ram": 0}
    helpers, files = set(), collections.Counter()
    for name, size, file in sections(path):
        kind = "code" if _is(name, CODE) else "constants" if _is(name, CONSTANTS) else None
        if kind:
            helpers.update(HELPER.findall(file))
            if RUN_TIME.search(file):
                kind = "run_time"
            else:
                files[TOGETHER.sub(r"\1", pathlib.PurePath(file).stem)] += size
            total[kind] += size
        if _is(name, RAM):
            total["ram"] += size
    return {**total, "helpers": sorted(helpers),
            "files": dict(sorted(files.items(), key=lambda item: (-item[1], item[0])))}


def sections(path):
    """[(section, bytes, input file)] that went into the program."""
    try:
        text = pathlib.Path(path).read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise ToolError(f"cannot read {path}: {error.strerror}; build it again") from error
    _, found, text = text.partition("Linker script and memory map")
    if not found:
        raise ToolError(f"{path} is not a linker's map")
    text = re.sub(r"^( \.\S+)\n +0x", r"\1 0x", text, flags=re.MULTILINE)
    return [(name, int(size, 16), file) for name, _, size, file in SECTION.findall(text) if int(size, 16)]


def _is(name, kinds):
    return any(name == kind or name.startswith(kind + ".") for kind in kinds)
