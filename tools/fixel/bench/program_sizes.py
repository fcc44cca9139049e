# SPDX-License-Identifier: MIT
"""What whole programs link of the library on the M3: [[programs]] of bench/bench.toml.

A program is built with the scene of the first one, by the library that make compiled for few bytes. Counted are code and
constants of the library, and the kernels of the pixels that the program does not draw: the linker must leave them out.
"""

import os
import re

from fixel.base import parallel
from fixel.base.errors import ToolError
from fixel.bench import linked_size

CORE = "m3"
FOLDERS = {"-Os": "os", "-Os -DFXL_SMALL": "small"}
SHOW = "\nint show(const {pixel} *pixels) {{ return pixels[0] & 1; }}\n"
# What makes RGB565 of a program with a texture that shows its frames: (before, after).
TO_RGB565 = (("const uint8_t *pixels)", "const uint16_t *pixels)"),
             ("static uint8_t pixels[240][320], ", "static const uint16_t colours[256] = {1};\nstatic uint16_t pixels[240][320];\nstatic uint8_t "),
             ("const fxl_config config = fxl_config_default(320, 240);", "fxl_config config = fxl_config_for(320, 240, &fxl_rgb565);"),
             ("    for (int i = 0; i < 768;", "    config.palette = colours;\n    for (int i = 0; i < 768;"),
             ("FXL_SURFACES_OF(fxl_palette)", "FXL_SURFACES_OF(fxl_rgb565)"), (".ramp = ramp, ", ""),
             ("&eye, pixels[0], 320)", "&eye, (uint8_t *)pixels[0], 320)"))
# Kernels that write pixels of one size, each in a section of its name.
WRITES = {8: re.compile(r"\.text\.fxl_(draw_outline|fill_rows|fill_trapezoid|paint_(lit_)?segments)$"),
          16: re.compile(r"\.text\.fxl_\w*_(rgb)?565$")}


def text_of(entry):
    """A program's text; README's is the first program."""
    file = linked_size.ROOT / entry["source"]
    text = linked_size.first_program(file) if file.suffix == ".md" else file.read_text(encoding="utf-8")
    shows = "int show(" in text
    if entry["bits"] == 16 and not shows:
        text = linked_size.in_rgb565(text)
    elif entry["bits"] == 16:
        for before, after in TO_RGB565:
            if before not in text:
                raise ToolError(f"{entry['source']} has no '{before}'")
            text = text.replace(before, after)
    return text + (SHOW.format(pixel=f"uint{entry['bits']}_t") if shows else "")


def _measure(plan, entry):
    library = plan.build / "bench" / CORE / "programs" / FOLDERS[entry["flags"]] / "libfixel.a"
    if not library.exists():
        raise ToolError(f"{library} is not built: make bench builds it")
    sections = linked_size.sections("cortex-m3", library, os.environ.get("CROSS", "arm-none-eabi-"), program=text_of(entry))
    ours = [(name, size) for name, size, file in sections if linked_size.FROM_LIBRARY.search(file)]
    others = WRITES[24 - entry["bits"]]
    return {"flash": linked_size.count(sections)["linked_flash"],
            "of_other_pixels": [name.removeprefix(".text.") for name, size in ours if size and others.match(name)]}


def measure(plan, cores):
    """{name: {"flash", "of_other_pixels"}}; nothing where the core was not measured, or workloads were named."""
    if CORE not in cores or plan.kept:
        return {}
    return parallel.run("measuring programs", {entry["name"]: (_measure, plan, entry) for entry in plan.programs})
