# SPDX-License-Identifier: MIT
"""What the parts of make test-anywhere share: the README's first program in a folder of its own, and what it must draw."""

import re
import shutil
import subprocess
import zlib

import pytest

from conftest import CHECKOUT, environment

FOLDER = CHECKOUT / "host_tests" / "anywhere"
# Machines of QEMU that run a program, and how it is linked for them. mps2-an385 has a Cortex-M3, which executes the instructions of
# a Cortex-M0+ too; mps2-an386 has a Cortex-M4.
ARM = "-Wl,-u,vectors,-e,start,--section-start=.vectors=0,-Ttext=0x100,-Tdata=0x20000000"
LINKED = {"arm": ARM, "arm-m4": ARM, "riscv": "-Wl,--section-start=.vectors=0x80000000,-Ttext=0x80000100,-e,begin"}
EMULATOR = {"arm": ["qemu-system-arm", "-M", "mps2-an385"], "arm-m4": ["qemu-system-arm", "-M", "mps2-an386"],
            "riscv": ["qemu-system-riscv32", "-M", "virt", "-bios", "none"]}


def need(*programs):
    """Skips a test where a program is not installed."""
    missing = [name for name in programs if shutil.which(name) is None]
    if missing:
        pytest.skip(f"needs {', '.join(missing)}")


def run(*command, folder=None, **changes):
    """What a command printed; it must end with 0."""
    done = subprocess.run([str(word) for word in command], cwd=folder, env=environment(**changes), stdin=subprocess.DEVNULL, text=True,
                          capture_output=True, check=False)
    assert done.returncode == 0, f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}"
    return done.stdout + done.stderr


def need_cargo(version):
    """Skips a test without this cargo or a later one, as (1, 85)."""
    need("cargo")
    found = re.search(r"cargo (\d+)\.(\d+)", run("cargo", "--version"))
    if (int(found[1]), int(found[2])) < version:
        pytest.skip(f"needs cargo {version[0]}.{version[1]} or later")


def cargo(*words, folder, **changes):
    """What cargo printed; a test is not run where the registry of crates does not answer."""
    done = subprocess.run(["cargo", *map(str, words)], cwd=folder, env=environment(CARGO_TERM_COLOR="never", **changes), stdin=subprocess.DEVNULL,
                          text=True, capture_output=True, check=False)
    said = done.stdout + done.stderr
    if done.returncode and re.search(r"failed to (download|get|fetch|query)|Could not resolve|spurious network error", said):
        pytest.skip("needs the registry of crates")
    assert done.returncode == 0, said
    return said


def first_program(folder):
    """Writes the README's first program with its scene into a folder, and what prints its picture's CRC."""
    from fixel.report import examples
    folder.mkdir(parents=True, exist_ok=True)
    readme = (CHECKOUT / "README.md").read_text(encoding="utf-8")
    (folder / "main.c").write_text(re.search(r"```c\n(.*?)```", readme, re.DOTALL)[1], encoding="utf-8")
    examples.write_scene(folder)
    for name in ("host.c", "chip.c"):
        shutil.copy(FOLDER / name, folder)
    shutil.copy(CHECKOUT / "boards" / "parts" / "memory_functions.c", folder)
    return folder


def expected():
    """The line that such a program prints: the CRC of the picture as the library of the checkout draws it."""
    from fixel.report import examples
    pixels, _ = examples.draw(CHECKOUT / "build" / "host" / "libfixel.a")
    assert len(set(pixels.flat)) >= 4, "a cube shows three sides before a background"
    return f"crc {zlib.crc32(pixels.tobytes()):08x}\n"


def emulated(machine, elf):
    """What a program prints on an emulated machine."""
    need(EMULATOR[machine][0])
    return run(*EMULATOR[machine], "-kernel", elf, "-display", "none", "-monitor", "none", "-serial", "none", "-semihosting-config",
               "enable=on,target=native")
