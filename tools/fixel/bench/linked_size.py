# SPDX-License-Identifier: MIT
"""What a program links of the library: the first program of README.md, for a core."""

import pathlib
import re

from fixel.base import scratch
from fixel.bench import link_map, stack
from fixel.report.examples import write_scene
from fixel.base.errors import ToolError

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = re.compile(r"```c\n(#include <fixel\.h>\n.*?)```", re.DOTALL)
FROM_LIBRARY = re.compile(r"libfixel\.a\(")
# What a system would bring; it gets an address and takes no bytes.
SYSTEM = ("memcpy", "memmove", "memset", "memcmp")


def first_program(readme=ROOT / "README.md"):
    """The text of README's first program."""
    found = PROGRAM.search(pathlib.Path(readme).read_text(encoding="utf-8"))
    if not found:
        raise ToolError(f"{readme}: there is no block of C that begins with #include <fixel.h>")
    return found[1]


def in_rgb565(program):
    """The first program, of which nothing is another but the format of its pixels."""
    changes = (("static uint8_t pixels", "static const uint16_t colours[256] = {1};\nstatic uint16_t pixels"),
               ("fxl_config_default(320, 240);", "fxl_config_for(320, 240, &fxl_rgb565);"),
               ("    if (fxl_renderer_init", "    config.palette = colours;\n    if (fxl_renderer_init"))
    for before, after in changes:
        if before not in program:
            raise ToolError(f"the first program of README.md has no '{before}'")
        program = program.replace(before, after)
    return program


def measure(core, library, cross, include=ROOT / "lib" / "include", program=None):
    """{"linked_flash", "linked_ram", "linked_helpers"}: bytes that a program, the first one, links of the library, of
    flash and of variables, and of the compiler's arithmetic. The scene's tables are the program's own."""
    return count(sections(core, library, cross, include, program))


def sections(core, library, cross, include=ROOT / "lib" / "include", program=None):
    """What a program, the first one, links: link_map.sections."""
    with scratch.folder("size") as folder:
        write_scene(folder)
        (folder / "first.c").write_text(program or first_program(), encoding="utf-8")
        stack.run([f"{cross}gcc", f"-mcpu={core}", "-mthumb", "-std=c11", "-O2", "-ffreestanding", "-fno-builtin",
                   "-fdata-sections", "-nostdlib", f"-I{folder}", f"-I{include}", str(folder / "first.c"), str(library), "-lgcc",
                   *(f"-Wl,--defsym={each}=0" for each in SYSTEM), "-Wl,--gc-sections", "-Wl,--entry=main",
                   f"-Wl,-Map={folder / 'first.map'}", "-o", str(folder / "first.elf")])
        return list(link_map.sections(folder / "first.map"))


def count(linked):
    """The same of a map's sections."""
    total = {"linked_flash": 0, "linked_ram": 0, "linked_helpers": 0}
    for section, size, file in linked:
        loaded = section.startswith((".text", ".rodata", ".data"))
        if FROM_LIBRARY.search(file):
            total["linked_flash"] += size if loaded else 0
            total["linked_ram"] += size if section.startswith((".data", ".bss")) else 0
        elif "libgcc.a(" in file and loaded:
            total["linked_helpers"] += size
    return total
