# SPDX-License-Identifier: MIT
"""How many bytes a program takes, by who brought them: the linker's map."""

import pathlib
import re

from fixel.errors import ToolError

# A section of an input file; a long name stands on a line of its own.
SECTION = re.compile(r"^ (\.[a-zA-Z]\S*)\s+0x([0-9a-f]+)\s+0x([0-9a-f]+)\s+(\S.*)$", re.MULTILINE)
FLASH = (".text", ".rodata", ".data")
RAM = (".data", ".bss")
# The compiler's and the C library's archives, and the memory functions that stand in for the
# latter: bytes that come along.
RUN_TIME = re.compile(r"/lib(gcc|c|m|g)(_nano)?\.a\(|/memory_functions\.o$")


def measure(path):
    """{"own", "run_time", "ram"}: bytes of code and constants by the program's own files and by the
    run-time libraries', and bytes of variables by both."""
    try:
        text = pathlib.Path(path).read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise ToolError(f"cannot read {path}: {error.strerror}; build it again") from error
    _, found, text = text.partition("Linker script and memory map")
    if not found:
        raise ToolError(f"{path} is not a linker's map")
    text = re.sub(r"^( \.\S+)\n +0x", r"\1 0x", text, flags=re.MULTILINE)
    total = {"own": 0, "run_time": 0, "ram": 0}
    for name, address, size, file in SECTION.findall(text):
        if int(address, 16) == 0 and not int(size, 16):
            continue
        if _is(name, FLASH):
            total["run_time" if RUN_TIME.search(file) else "own"] += int(size, 16)
        if _is(name, RAM):
            total["ram"] += int(size, 16)
    return total


def _is(name, kinds):
    return any(name == kind or name.startswith(kind + ".") for kind in kinds)
