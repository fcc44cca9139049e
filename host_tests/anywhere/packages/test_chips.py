# SPDX-License-Identifier: MIT
"""make lib CORE= of a chip: it says what that means, and the README's first program links with the chip's flags and draws."""

import re

import pytest

from conftest import CHECKOUT, run_make
from outside import LINKED, emulated, expected, first_program, need, run

# The machine of QEMU that executes the chip's instructions; none: linked alone.
MACHINES = {"rp2040": "arm", "rp2350": None, "stm32f103": "arm", "stm32f4": "arm-m4", "nrf52840": "arm-m4", "esp32c3": "riscv",
            "rv32imc_zba_zbb": "riscv"}


def test_every_chip_is_tried():
    said = run_make("lib", "CORE=z80").stderr
    assert said.split(" host ")[1].split(".")[0].split()[:len(MACHINES)] == list(MACHINES)
    page = (CHECKOUT / "docs" / "packages.md").read_text(encoding="utf-8")
    assert re.findall(r"^\| `(\w+)` \| `-", page, re.MULTILINE) == list(MACHINES)


@pytest.mark.parametrize("chip", MACHINES)
def test_a_chip(tmp_path, chip):
    compiler = "riscv64-unknown-elf-gcc" if MACHINES[chip] == "riscv" else "arm-none-eabi-gcc"
    need(compiler)
    done = run_make("lib", f"CORE={chip}")
    assert done.returncode == 0, done.stderr
    means = re.search(rf"^  {chip} means (\S+) (.*) -O2$", done.stdout, re.MULTILINE)
    assert means[1] == compiler
    assert f"| `{chip}` | `{means[2]}` |" in (CHECKOUT / "docs" / "packages.md").read_text(encoding="utf-8")
    first_program(tmp_path)
    library = CHECKOUT / "build" / "lib" / chip
    machine = MACHINES[chip] or "arm"
    run(compiler, *means[2].split(), "-ffreestanding", "-O2", f"-I{library / 'include'}", "chip.c", "memory_functions.c", library / "libfixel.a",
        "-nostdlib", "-lgcc", *LINKED[machine].split(), "-Wl,--gc-sections", "-o", "cube.elf", folder=tmp_path)
    if MACHINES[chip]:
        assert emulated(machine, tmp_path / "cube.elf") == expected()
