# SPDX-License-Identifier: MIT
"""What packages carry draws the frames on record: firmware/walk with a package's sources in the place of the library,
on emulated cores, and as WebAssembly in Node."""

import functools
import json
import re
import shlex
import shutil

import pytest

from board_programs import ROOT, built
from conftest import run_make
from fixel.board import dump, emulator, flash_memory
from fixel.check import frame_hashes
from outside import FOLDER, need, run
from test_frame_hashes import SCENES, TIMEOUT, fixture_scene  # noqa: F401: the fixture of a record's scene
from test_layouts import compiled, fixture_packages  # noqa: F401

# By the core: the board that executes it, and the flags. No emulated board with a Cortex-M0+ has the memory: an M3 executes its code.
CORES = {"m0plus": ("mps2-an385", ["-mcpu=cortex-m0plus", "-mthumb"]), "m3": ("mps2-an385", ["-mcpu=cortex-m3", "-mthumb", "-mno-unaligned-access"]),
         "rv32": ("rv32", ["-march=rv32imc", "-mabi=ilp32", "-mcmodel=medany", "-msmall-data-limit=0"])}
COMPILERS = {"mps2-an385": "arm-none-eabi-gcc", "rv32": "riscv64-unknown-elf-gcc"}


# The walk and a board of WebAssembly, with rv32's room.
WEB = [*sorted(file for file in (ROOT / "firmware" / "walk").glob("*.c") if file.name != "main.c"), ROOT / "firmware" / "web" / "page.c", ROOT / "firmware" / "web" / "web.c",
       ROOT / "boards" / "parts" / "memory_functions.c"]
ROOM = ["-DWALK_IN_PARTS", "-DWALK_BAND_BYTES=1048576", "-DWALK_ORDER_ENTRIES=65536", "-DWALK_LIST_BYTES=262144", "-DWALK_CACHE_ENTRIES=1024"]


def of_an_emulated_core(core, source, folder):
    """Draws by the walk of the core's board, linked with a package's sources instead of lib/."""
    board, flags = CORES[core]
    compiler, elf = COMPILERS[board], folder / "walk.elf"
    need(compiler)
    how = [*flags, "-O2", "-std=c11", "-ffreestanding", "-ffunction-sections", "-fdata-sections"]
    objects = compiled(source, folder / "objects", how, flags if compiler.startswith("arm") else (), compiler)
    own = f"build/boards/{board}/walk.elf"
    built(f"{board}/walk.elf")
    steps = run_make("-n", f"BOARD={board}", "-W", f"build/boards/{board}/firmware/walk/walk.o", own).stdout
    link, = re.findall(rf"{compiler} [^;]*(?= -o {re.escape(own)})", steps)
    words = [word for word in shlex.split(link) if "/lib/" not in word]
    assert len(words) < len(shlex.split(link)) - 50, "the library's objects are left out"
    run(*[f"-Wl,-Map,{folder}/walk.map" if word.startswith("-Wl,-Map") else word for word in words], *objects, "-lgcc", "-o", elf, folder=ROOT)
    shutil.rmtree(folder / "objects")

    def draw(image, folder):
        flash_memory.flash(board, elf, image, folder / "flash.bin")
        emulator.run(board, folder / "flash.bin", elf, folder / "frames.fxld", timeout=TIMEOUT)
        return frame_hashes.record_of(dump.read_dump(folder / "frames.fxld"))
    return draw


def of_webassembly(source, folder):
    """Draws by the walk as a module, which has no C library and imports nothing."""
    need("clang", "wasm-ld", "node")
    how = ["--target=wasm32", "-O2", "-std=c11", "-ffreestanding", "-fno-builtin", "-Wall", "-Wextra", "-Werror"]
    objects = compiled(source, folder / "library", how, compiler="clang")
    (folder / "walk").mkdir()
    # Of lib/ only study/, which no package has.
    includes = [f"-I{path}" for path in (source, ROOT / "boards", ROOT / "lib", ROOT / "firmware" / "walk")]
    run("clang", *how, *ROOM, *includes, "-c", *WEB, folder=folder / "walk")
    run("wasm-ld", "--no-entry", "--gc-sections", "--fatal-warnings", "--stack-first", "-z", "stack-size=65536", *objects,
        *sorted((folder / "walk").glob("*.o")), "-o", folder / "walk.wasm")
    return lambda image, _: json.loads(run("node", FOLDER / "packages" / "webassembly.mjs", folder / "walk.wasm", image))


@pytest.fixture(scope="module", name="walks")
def fixture_walks(packages, tmp_path_factory):
    """By a core: what draws an image, and gives the record of its frames."""
    @functools.cache
    def walk(core):
        source, folder = packages / "esp-idf" / "src", tmp_path_factory.mktemp(core)
        return of_webassembly(source, folder) if core == "wasm32" else of_an_emulated_core(core, source, folder)
    return walk


@pytest.mark.parametrize("scene", SCENES, indirect=True)
@pytest.mark.parametrize("core", [*CORES, "wasm32"])
def test_a_package_draws_what_is_on_record(walks, core, scene, tmp_path):
    name, image = scene
    assert walks(core)(image, tmp_path) == frame_hashes.load()[name]
