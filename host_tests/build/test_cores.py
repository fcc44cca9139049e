# SPDX-License-Identifier: MIT
"""Cores that share the objects of the library (CORE_SHARED in firmware/firmware.mk) would get the same from the
compiler."""

import re
import subprocess

import pytest
from conftest import CHECKOUT, run_make

CORE = "cpu-cortex-m4_float-abi-soft_no-unaligned-access"
SOURCES = ("study/clip_once", "view/order", "raster/scan")


def compiling(source, cpu, target):
    """The command by which make compiles a source for the shared core, for this core instead."""
    folder = target.parent / "build"
    done = run_make("-n", "V=1", f"BUILD={folder}", f"{folder}/core/{CORE}/lib/{source}.o")
    [command] = [line for line in done.stdout.splitlines() if f" -c lib/{source}.c" in line]
    words = [word for word in command.split() if word not in ("-MMD", "-MP", "-fstack-usage")]
    assert words[-2] == "-o" and "-mcpu=cortex-m4" in words
    return [word.replace("-mcpu=cortex-m4", f"-mcpu={cpu}") for word in words[:-1]] + [str(target)]


def said(command):
    return subprocess.run(command, cwd=CHECKOUT, text=True, capture_output=True, check=True).stdout


def test_a_cortex_m7_is_compiled_as_a_cortex_m4(tmp_path):
    """All that the compiler decides by is equal: macros, flags of the target, optimisations and their limits."""
    answers = []
    for cpu in ("cortex-m4", "cortex-m7"):
        options = compiling(SOURCES[0], cpu, tmp_path / "x.o")[:-4]
        text = said([*options, "-dM", "-E", "-x", "c", "/dev/null"])
        for kind in ("target", "optimizers", "params"):
            text += said([*options, "-Q", f"--help={kind}"])
        assert text.count(cpu) == 1 and len(text.splitlines()) > 500
        answers.append(text.replace(cpu, ""))
    assert answers[0] == answers[1]


def test_objects_of_a_cortex_m7_are_those_of_a_cortex_m4(tmp_path):
    for source in SOURCES:
        codes = []
        for cpu in ("cortex-m4", "cortex-m7"):
            target = tmp_path / f"{cpu}.o"
            said(compiling(source, cpu, target))
            listing = said(["arm-none-eabi-objdump", "-dr", target])
            codes.append(re.sub(r"^.*file format.*$", "", listing, flags=re.MULTILINE))
        assert codes[0] == codes[1] and codes[0].count("\n") > 50


@pytest.mark.parametrize("cpu", ["cortex-m4", "cortex-m55"])
def test_the_text_of_the_unit_tests_is_that_of_a_cortex_m3(cpu):
    """The headers of the library, and so its functions that a test has inline, ask for nothing in which these cores
    differ: UNIT_CORE in firmware/unittest/unittest.mk has their boards link the tests of an M3."""
    includes = "".join(f'#include "{file.relative_to(CHECKOUT)}"\n' for file in sorted(CHECKOUT.glob("lib/**/*.h")))
    texts = [subprocess.run(["arm-none-eabi-gcc", "-std=c11", f"-mcpu={core}", "-mthumb", "-mfloat-abi=soft", "-O1", "-E", "-P", "-I.",
                             "-Ilib/include", "-Ilib", "-x", "c", "-"], input=includes, cwd=CHECKOUT, text=True, capture_output=True,
                            check=True).stdout for core in ("cortex-m3", cpu)]
    assert texts[0] == texts[1] and texts[0].count("\n") > 2000
