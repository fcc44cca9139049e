# SPDX-License-Identifier: MIT
"""Programs of unit tests on boards: which files share one, what counts as passed, and that cores which share objects would get the same from the
compiler."""

import importlib.util
import json
import re
import subprocess

import pytest

from board_programs import BOARD, built, fake_qemu, ROOT
from conftest import CHECKOUT, run_make
from fixel.board import unit_tests

BUILT_PROGRAMS = ("core/*/unit/*.a", "boards/*/unit/*.elf")
@pytest.fixture(scope="module")
def programs():
    """firmware/unittest/programs.py"""
    spec = importlib.util.spec_from_file_location("programs", ROOT / "firmware/unittest/programs.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Fake:
    """Sizes of files of tests, and a linker with so much room."""

    def __init__(self, sizes, flash, ram):
        self.sizes, self.room, self.linked = sizes, (flash, ram), []
        self.needs = sizes

    def flash(self, tests):
        return sum(self.sizes[test][0] for test in tests)

    def ram(self, tests):
        return sum(self.sizes[test][1] for test in tests)

    def link(self, tests, file):
        self.linked.append((file, tests))
        over = [f"{name} overflowed by {taken - room} bytes" for name, taken, room in
                zip(("FLASH", "RAM"), (self.flash(tests), self.ram(tests)), self.room) if taken > room]
        return ", ".join(over) or None


def test_files_that_do_not_fit_are_cut_in_two_and_named(programs):
    fake = Fake({"test_a": (10, 1), "test_b": (20, 1), "test_c": (70, 1), "test_d": (101, 1), "test_e": (10, 120)}, 100, 100)
    linked, left_out = programs.link_all(fake, [["test_a", "test_b", "test_c", "test_d"], ["test_e"]])
    assert sorted(map(sorted, linked.values())) == [["test_a", "test_b"], ["test_c"]]
    assert left_out == {"test_d": "FLASH overflowed by 1 bytes", "test_e": "RAM overflowed by 20 bytes"}
    assert len(set(linked)) == 2


def test_files_share_a_program_where_they_leave_the_stack_alone(programs):
    kib = 1 << 10
    sizes = Fake({f"test_{number}": (10, kib) for number in range(8)}, 0, 0)
    assert len(programs.propose(sizes, 1000, 1024 * kib)) == 1
    assert len(programs.propose(sizes, 20, 1024 * kib)) == 4            # two have the flash
    assert len(programs.propose(sizes, 1000, 16 * kib)) == 3            # each has an eighth of the RAM less than alone
    assert sorted(sum(programs.propose(sizes, 1, 1), [])) == sorted(sizes.needs)    # too large: the linker says so


def test_a_fault_of_the_link_is_no_lack_of_room(programs, tmp_path):
    script = tmp_path / "ld"
    script.write_text("#!/bin/sh\necho 'undefined reference to `fxl_gone'\nexit 1\n")
    script.chmod(0o755)
    with pytest.raises(SystemExit, match="(?s)units-01.elf with test_a cannot be linked:.*fxl_gone"):
        programs.Linker([str(script)], tmp_path).link(["test_a"], "units-01.elf")


def test_the_objects_that_a_file_takes_are_found(programs):
    """Of real archives: the file's own object and what it calls, not the whole library."""
    folder = next((ROOT / "build/core").glob("cpu-cortex-m3_*unaligned-access/unit/libtests.a")) if \
        built(f"{BOARD}/unit/units.json") else None
    sizes = programs.Sizes(str(folder), [str(folder.with_name("libhelpers.a")), str(folder.with_name("libfixel.a"))],
                           "arm-none-eabi-")
    assert {"test_angle.o", "angle.o"} <= sizes.needs["test_angle"] and len(sizes.needs["test_angle"]) < 20
    assert sizes.flash(["test_angle"]) < sizes.flash(["test_angle", "test_arith"])


PROGRAM = f"{BOARD}/unit/units.json"


def elf_of(name):
    units = built(PROGRAM)
    linked = json.loads(units.read_text(encoding="utf-8"))["programs"]
    return next((units.parent / program, names) for program, names in linked.items() if name in names)


def test_files_run_by_name_on_the_board():
    elf, names = elf_of("test_angle")
    file, = unit_tests.run(elf, ["test_angle"], every=False)
    assert (file.name, file.failed) == ("test_angle", 0) and file.passed > 0 and len(names) > 1


def test_a_file_that_the_program_lacks_has_failed():
    file, = unit_tests.run(elf_of("test_angle")[0], ["test_gone"], every=False)
    assert (file.passed, file.failed) == (0, 1) and "has no test_gone" in file.output


@pytest.mark.parametrize("script, words", [
    ('"$REAL" "$@"; exit 0', "emulator ended without the program's exit code"),  # all passed, the agreed code is lost
    ('"$REAL" -S "$@" & sleep 0.5; kill -TERM $!; wait $!', ""),                  # SIGTERM: exit code 0, or 143
    (r'printf "unittest: test_angle\na.c:1:test_one:PASS\nunittest: test_angle done\nunittest: done\n"; exit 0', "exit"),
    (r'printf "unittest: test_angle\na.c:1:test_one:PASS\nunittest: test_angle done\n"; exit 93', "exit 93"),
    (r'printf "unittest: test_angle\na.c:1:test_one:FAIL\nunittest: test_angle done\nunittest: done\n"; exit 21', "FAIL"),
])
def test_unit_tests_that_do_not_end_as_agreed_have_failed(tmp_path, monkeypatch, script, words):
    elf, _ = elf_of("test_angle")
    monkeypatch.setenv("PATH", fake_qemu(tmp_path / "bin", script))
    file, = unit_tests.run(elf, ["test_angle"], every=False)
    assert file.failed == 1 and words in file.output


# Begins test_a, and test_b where test_a has ended, and ends inside the file that FAULT names.
ENDING = r"""case "$*" in *after=test_a*) ;; *) printf "unittest: test_a\na.c:1:test_one:PASS\n"
    test FAULT != test_a || { STACK; exit CODE; }
    printf "unittest: test_a done\n" ;; esac
printf "unittest: test_b\nb.c:1:test_two:PASS\nunittest: test_b done\nunittest: done\n"; exit 93"""


def scripted(code, stack=":"):
    return ENDING.replace("FAULT", "test_a").replace("CODE", str(code)).replace("STACK", stack)


def test_after_a_fault_the_next_file_runs(tmp_path, monkeypatch):
    elf, _ = elf_of("test_angle")
    monkeypatch.setenv("PATH", fake_qemu(tmp_path / "bin", scripted(44)))
    first, second = unit_tests.run(elf, ["test_a", "test_b"])
    assert (first.passed, first.failed, second.passed, second.failed) == (1, 1, 1, 0)
    assert "exit 44: fault: access through a null pointer" in first.output and "null" not in second.output


@pytest.mark.parametrize("stack, no_room", [(6888, "its stack takes more than 6888 bytes"), (65536, None)])
def test_a_stack_that_is_too_small_is_no_room_where_it_is_smaller_than_others(tmp_path, monkeypatch, stack, no_room):
    elf, _ = elf_of("test_angle")
    said = rf'printf "stack: {stack} of {stack} bytes; handlers: 0 of 320 bytes\n"'
    monkeypatch.setenv("PATH", fake_qemu(tmp_path / "bin", scripted(40, said)))
    first, second = unit_tests.run(elf, ["test_a", "test_b"])
    assert (first.no_room, first.failed) == (no_room, 0 if no_room else 1)
    assert (second.no_room, second.passed, second.failed) == (None, 1, 0)


# --- cores that share objects (CORE_SHARED in firmware/firmware.mk, UNIT_CORE in firmware/unittest/unittest.mk) 

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
                             "-Ilib/include", "-Ilib", "-DFXL_TARGET_FORMAT=FXL_PALETTE_PIXELS", "-x", "c", "-"], input=includes, cwd=CHECKOUT, text=True, capture_output=True,
                            check=True).stdout for core in ("cortex-m3", cpu)]
    assert texts[0] == texts[1] and texts[0].count("\n") > 2000


def test_no_two_files_of_unit_tests_share_a_name():
    """A suite is called after its file: of two with one name the second would hide what the first found."""
    names = [file.stem for file in (CHECKOUT / "host_tests").rglob("test_*.c")]
    assert sorted(names) == sorted(set(names)) and len(names) > 100
