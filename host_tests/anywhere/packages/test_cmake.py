# SPDX-License-Identifier: MIT
"""CMake and pkg-config, outside the checkout: the README's first program finds an installed Fixel and draws the cube, on this
machine, on a Cortex-M0+ and on RISC-V."""

import functools
import shutil
import subprocess

import pytest

from conftest import CHECKOUT
from fixel.base.version import version
from outside import LINKED, emulated, expected, first_program, need, run

# What draws, what it needs, CMake's options.
TARGETS = {
    "host": ([], []),
    "arm": (["arm-none-eabi-gcc", "qemu-system-arm"],
            [f"-DCMAKE_TOOLCHAIN_FILE={CHECKOUT}/cmake/arm-none-eabi.cmake", "-DFIXEL_CPU=cortex-m0plus"]),
    "riscv": (["riscv64-unknown-elf-gcc", "qemu-system-riscv32"], [f"-DCMAKE_TOOLCHAIN_FILE={CHECKOUT}/cmake/riscv-elf.cmake", "-DFIXEL_ARCH=rv32imc"]),
}
PROJECT = """cmake_minimum_required(VERSION 3.16)
project(cube LANGUAGES C ASM)
{found}
if(CMAKE_SYSTEM_NAME STREQUAL Generic)
    add_executable(cube chip.c memory_functions.c)
    target_link_options(cube PRIVATE -nostdlib "{linked}" -Wl,--gc-sections)
    target_link_libraries(cube PRIVATE fixel::fixel gcc)
else()
    add_executable(cube host.c)
    target_link_libraries(cube PRIVATE fixel::fixel)
endif()
"""


@pytest.fixture(scope="module", name="installed")
def fixture_installed(tmp_path_factory):
    """By a target: where cmake --install has put Fixel."""
    @functools.cache
    def installed(target):
        needs, options = TARGETS[target]
        need("cmake", *needs)
        folder = tmp_path_factory.mktemp(target)
        said = run("cmake", "-S", CHECKOUT, "-B", folder / "build", f"-DCMAKE_INSTALL_PREFIX={folder / 'prefix'}", *options)
        said += run("cmake", "--build", folder / "build", "--parallel", "2")
        assert "warning" not in said.lower(), said
        run("cmake", "--install", folder / "build")
        shutil.rmtree(folder / "build")
        return folder / "prefix"
    return installed


def project(folder, found, target):
    """A project of CMake outside the checkout, built; the program."""
    first_program(folder)
    (folder / "CMakeLists.txt").write_text(PROJECT.format(found=found, linked=LINKED.get(target, "")), encoding="utf-8")
    return folder / "build" / "cube"


@pytest.mark.parametrize("target", TARGETS)
def test_a_project_finds_it_and_draws_the_cube(installed, tmp_path, target):
    program = project(tmp_path / "project", f"find_package(fixel {version()} CONFIG REQUIRED)", target)
    run("cmake", "-S", tmp_path / "project", "-B", program.parent, f"-DCMAKE_PREFIX_PATH={installed(target)}", *TARGETS[target][1])
    run("cmake", "--build", program.parent)
    assert (run(program) if target == "host" else emulated(target, program)) == expected()


def test_a_program_for_a_cortex_m0_plus_has_its_instructions(installed):
    """The toolchain file's core is the one that the library is compiled for, and its kernels are in it."""
    attributes = run("arm-none-eabi-readelf", "-A", installed("arm") / "lib" / "libfixel.a")
    assert "Tag_CPU_arch: v6S-M" in attributes and "Tag_CPU_arch: v7" not in attributes
    assert "fxl_project_inside" in run("arm-none-eabi-nm", installed("arm") / "lib" / "libfixel.a")


def test_a_project_fetches_it_and_draws_the_cube(tmp_path):
    need("cmake")
    found = f"""include(FetchContent)
FetchContent_Declare(fixel SOURCE_DIR "{CHECKOUT}")
FetchContent_MakeAvailable(fixel)"""
    program = project(tmp_path / "project", found, "host")
    run("cmake", "-S", tmp_path / "project", "-B", program.parent)
    run("cmake", "--build", program.parent, "--parallel", "2")
    assert run(program) == expected()
    assert not (program.parent / "_deps" / "fixel-build" / "fixel.pc").exists(), "a project installs what is its own alone"


def test_pkg_config_knows_it(installed, tmp_path):
    need("pkg-config")
    first_program(tmp_path)
    where = {"PKG_CONFIG_PATH": str(installed("host") / "lib" / "pkgconfig")}
    assert run("pkg-config", "--modversion", "fixel", **where).strip() == version()
    flags = run("pkg-config", "--cflags", "--libs", "fixel", **where).split()
    assert f"-DFXL_POLYGON_CAPACITY=32" in flags
    run("gcc", tmp_path / "host.c", *flags, "-o", tmp_path / "cube")
    assert run(tmp_path / "cube") == expected()


def test_what_is_installed(installed):
    prefix = installed("host")
    files = {str(file.relative_to(prefix)) for file in prefix.rglob("*") if file.is_file()}
    headers = {f"include/{file.relative_to(CHECKOUT / 'lib' / 'include')}" for file in (CHECKOUT / "lib" / "include").rglob("*.h")}
    package = {f"lib/cmake/fixel/fixel-config{kind}.cmake" for kind in ("", "-noconfig", "-version")}
    assert files == headers | package | {"lib/libfixel.a", "lib/pkgconfig/fixel.pc"}
    for file in package | {"lib/pkgconfig/fixel.pc"}:
        text = (prefix / file).read_text(encoding="utf-8")
        assert str(CHECKOUT) not in text and str(prefix) not in text, f"{file} names a folder of the machine that built it"


@pytest.mark.parametrize("asked", ["0.8.0", "0.99.0", "1.0.0"])
def test_another_version_is_refused(installed, tmp_path, asked):
    program = project(tmp_path / "project", f"find_package(fixel {asked} CONFIG REQUIRED)", "host")
    done = subprocess.run(["cmake", "-S", tmp_path / "project", "-B", program.parent, f"-DCMAKE_PREFIX_PATH={installed('host')}"], text=True,
                          capture_output=True, check=False)
    assert done.returncode != 0 and version() in done.stderr
