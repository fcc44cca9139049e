# SPDX-License-Identifier: MIT
"""What packages carry draws the frames on record: firmware/walk with a package's sources in the place of the library."""

import functools
import re
import shlex
import shutil

import pytest

from board_programs import ROOT, built
from conftest import run_make
from fixel.board import dump, emulator, flash_memory
from fixel.check import frame_hashes
from outside import need, run
from test_frame_hashes import SCENES, TIMEOUT, fixture_scene  # noqa: F401: the fixture of a record's scene
from test_layouts import compiled, fixture_packages  # noqa: F401

# By the core: the board that executes it, and the flags. No emulated board with a Cortex-M0+ has the memory: an M3 executes its code.
CORES = {"m0plus": ("mps2-an385", ["-mcpu=cortex-m0plus", "-mthumb"]), "m3": ("mps2-an385", ["-mcpu=cortex-m3", "-mthumb", "-mno-unaligned-access"]),
         "rv32": ("rv32", ["-march=rv32imc", "-mabi=ilp32", "-mcmodel=medany", "-msmall-data-limit=0"])}
COMPILERS = {"mps2-an385": "arm-none-eabi-gcc", "rv32": "riscv64-unknown-elf-gcc"}


@pytest.fixture(scope="module", name="walks")
def fixture_walks(packages, tmp_path_factory):
    """By a core: the walk of its board, linked with a package's sources instead of lib/."""
    @functools.cache
    def walk(core):
        board, flags = CORES[core]
        compiler = COMPILERS[board]
        need(compiler)
        folder = tmp_path_factory.mktemp(core)
        how = [*flags, "-O2", "-std=c11", "-ffreestanding", "-ffunction-sections", "-fdata-sections"]
        objects = compiled(packages / "esp-idf" / "src", folder / "objects", how, flags if compiler.startswith("arm") else (), compiler)
        elf = f"build/boards/{board}/walk.elf"
        built(f"{board}/walk.elf")
        steps = run_make("-n", f"BOARD={board}", "-W", f"build/boards/{board}/firmware/walk/walk.o", elf).stdout
        link, = re.findall(rf"{compiler} [^;]*(?= -o {re.escape(elf)})", steps)
        words = [word for word in shlex.split(link) if "/lib/" not in word]
        assert len(words) < len(shlex.split(link)) - 50, "the library's objects are left out"
        run(*[f"-Wl,-Map,{folder}/walk.map" if word.startswith("-Wl,-Map") else word for word in words], *objects, "-lgcc", "-o", folder / "walk.elf", folder=ROOT)
        shutil.rmtree(folder / "objects")
        return board, folder / "walk.elf"
    return walk


@pytest.mark.parametrize("scene", SCENES, indirect=True)
@pytest.mark.parametrize("core", CORES)
def test_a_package_draws_what_is_on_record(walks, core, scene, tmp_path):
    name, image = scene
    board, elf = walks(core)
    flash_memory.flash(board, elf, image, tmp_path / "flash.bin")
    emulator.run(board, tmp_path / "flash.bin", elf, tmp_path / "frames.fxld", timeout=TIMEOUT)
    assert frame_hashes.difference(frame_hashes.load()[name], dump.read_dump(tmp_path / "frames.fxld")) == ""
