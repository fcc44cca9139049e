# SPDX-License-Identifier: MIT
"""What a program links of the library: the first program of README.md, for a core; whole programs, [[programs]] of bench/bench.toml,
on the M3; and how many bytes any program takes, by who brought them: the linker's map.

A whole program is built with the scene of the first one, by the library that make compiled for few bytes. Counted are code and
constants of the library, and the kernels of the pixels that the program does not draw: the linker must leave them out.
"""

import collections
import os
import pathlib
import re

from fixel.base import parallel, scratch
from fixel.base.errors import ToolError
from fixel.bench import stack
from fixel.report.examples import write_scene

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = re.compile(r"```c\n(#include <fixel\.h>\n.*?)```", re.DOTALL)
FROM_LIBRARY = re.compile(r"libfixel\.a\(")
# What a system would bring; it gets an address and takes no bytes.
SYSTEM = ("memcpy", "memmove", "memset", "memcmp")
CORE = "m3"
FOLDERS = {"-O2": "o2", "-Os": "os", "-Os -DFXL_SMALL": "small"}
SHOW = "\nint show(const {pixel} *pixels) {{ return pixels[0] & 1; }}\n"
# What makes RGB565 of a program with a texture that shows its frames: (before, after).
TO_RGB565 = (("const uint8_t *pixels)", "const uint16_t *pixels)"),
             ("static uint8_t pixels[240][320], ", "static const uint16_t colours[256] = {1};\nstatic uint16_t pixels[240][320];\nstatic uint8_t "),
             ("const fxl_config config = fxl_config_default(320, 240);", "fxl_config config = fxl_config_for(320, 240, &fxl_rgb565);"),
             ("    for (int i = 0; i < 768;", "    config.palette = colours;\n    for (int i = 0; i < 768;"),
             ("FXL_TEXTURES_OF(fxl_palette)", "FXL_TEXTURES_OF(fxl_rgb565)"), (".ramp = ramp, ", ""),
             ("&eye, pixels[0], 320)", "&eye, (uint8_t *)pixels[0], 320)"))
# What gives the same a depth buffer, and a crate that does not turn.
TO_DEPTH = (("&fxl_rgb565);", "&fxl_rgb565_depth_16);"), ("FXL_TEXTURES_OF(fxl_rgb565)", "FXL_TEXTURES_OF(fxl_rgb565_depth_16)"),
            ("static uint16_t pixels[240][320];", "static uint16_t pixels[240][320], cells[240 * 320];"),
            ("config.palette = colours;", "config.palette = colours; config.depth = cells; config.depth_size = sizeof cells;"),
            ("    scene.placements = &placement;\n    scene.placement_code = &fxl_turned_instances;\n", ""),
            ("fxl_orientation_from_axis(&axis, frame * FXL_DEGREES(3), &placement.orientation) ||\n", ""))
# Kernels that write pixels of one size, each in a section of its name.
WRITES = {8: re.compile(r"\.text\.fxl_(draw_outline|fill_rows|fill_trapezoid|paint_(lit_)?segments)$"),
          16: re.compile(r"\.text\.fxl_\w*_(rgb)?565$")}
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
    """What a program, the first one, links: [(section, bytes, input file)]."""
    with scratch.folder("size") as folder:
        write_scene(folder)
        (folder / "first.c").write_text(program or first_program(), encoding="utf-8")
        stack.run([f"{cross}gcc", f"-mcpu={core}", "-mthumb", "-std=c11", "-O2", "-ffreestanding", "-fno-builtin",
                   "-fdata-sections", "-nostdlib", f"-I{folder}", f"-I{include}", str(folder / "first.c"), str(library), "-lgcc",
                   *(f"-Wl,--defsym={each}=0" for each in SYSTEM), "-Wl,--gc-sections", "-Wl,--entry=main",
                   f"-Wl,-Map={folder / 'first.map'}", "-o", str(folder / "first.elf")])
        return sections_of_map(folder / "first.map")


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


def text_of(entry):
    """A program's text; README's is the first program."""
    file = ROOT / entry["source"]
    text = first_program(file) if file.suffix == ".md" else file.read_text(encoding="utf-8")
    shows = "int show(" in text
    if entry["bits"] == 16 and not shows:
        text = in_rgb565(text)
    elif entry["bits"] == 16:
        for before, after in TO_RGB565 + (TO_DEPTH if entry.get("depth") else ()):
            if before not in text:
                raise ToolError(f"{entry['source']} has no '{before}'")
            text = text.replace(before, after)
    return text + (SHOW.format(pixel=f"uint{entry['bits']}_t") if shows else "")


def _measure_program(plan, entry):
    library = plan.build / "bench" / CORE / "programs" / FOLDERS[entry["flags"]] / "libfixel.a"
    if not library.exists():
        raise ToolError(f"{library} is not built: make bench builds it")
    linked = sections("cortex-m3", library, os.environ.get("CROSS", "arm-none-eabi-"), program=text_of(entry))
    ours = [(name, size) for name, size, file in linked if FROM_LIBRARY.search(file)]
    others = WRITES[24 - entry["bits"]]
    return {"flash": count(linked)["linked_flash"],
            "of_other_pixels": [name.removeprefix(".text.") for name, size in ours if size and others.match(name)]}


def measure_programs(plan, cores):
    """{name: {"flash", "of_other_pixels"}}; nothing where the core was not measured, or workloads were named."""
    if CORE not in cores or plan.kept:
        return {}
    return parallel.run("measuring programs", {entry["name"]: (_measure_program, plan, entry) for entry in plan.programs})


def sizes_of_map(path):
    """{"code", "constants", "run_time", "ram", "helpers", "files"}: bytes of code and of constants by
    the program's own files, of both by the run-time libraries, of variables by all; the names of the
    compiler's arithmetic that was linked; and {file: bytes} of the program's own, the largest first."""
    total = {"code": 0, "constants": 0, "run_time": 0, "ram": 0}
    helpers, files = set(), collections.Counter()
    for name, size, file in sections_of_map(path):
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


def sections_of_map(path):
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
