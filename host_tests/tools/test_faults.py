# SPDX-License-Identifier: MIT
"""What a fault on a board looks like from outside, and what the clock says."""

import re

import pytest

from board_programs import BOARD, built
from fixel import emulator


@pytest.fixture(scope="module")
def faults():
    return built(f"{BOARD}/faults.elf")


def run(elf, case, timeout=20):
    return emulator.run_text(elf, ["faults", case], timeout)


@pytest.mark.parametrize("case, code, words", [
    ("stack", "STACK", ["stack overflow", "DACCVIOL", "pc and r0 to r3 are lost"]),
    ("leap", "STACK", ["stack overflow", "DACCVIOL"]),
    ("divide", "DIVIDE", ["division by zero", "DIVBYZERO", "pc  0x"]),
    ("unaligned", "UNALIGNED", ["misaligned address", "UNALIGNED", "pc  0x"]),
    ("flash", "FLASH", ["write to flash", "DACCVIOL", "address 0x00080040"]),
    ("null", "NULL", ["null pointer", "address 0x00000004"]),
    ("unmapped", "BUS", ["nothing at this address", "PRECISERR", "address 0x70000000"]),
    ("undefined", "USAGE", ["UNDEFINSTR"]),
    ("interrupt", "INTERRUPT", ["unexpected interrupt (exception 11)"]),
])
def test_a_fault_names_itself_and_has_a_code_of_its_own(faults, case, code, words):
    ending = run(faults, case)
    assert ending.code == emulator.exit_code(code), ending.output
    for word in words:
        assert word in ending.output
    for register in ("r4", "r11", "cfsr", "psp"):
        assert re.search(rf"\b{register} +0x[0-9a-f]{{8}}", ending.output), register
    assert emulator.exit_meanings()[ending.code][1] in emulator.describe(ending)


def test_the_program_counter_points_at_the_culprit(faults):
    from elftools.elf.elffile import ELFFile

    output = run(faults, "divide").output
    address = int(re.search(r"pc  0x([0-9a-f]{8})", output).group(1), 16)
    with open(faults, "rb") as file:
        symbol = ELFFile(file).get_section_by_name(".symtab").get_symbol_by_name("divide")[0]
        start = symbol["st_value"] & ~1
        assert start <= address < start + symbol["st_size"]


def test_a_lockup(faults):
    ending = run(faults, "lockup")
    assert ending.code not in (0, emulator.exit_code("DONE"))
    assert "locked up" in emulator.describe(ending)


def test_a_hang(faults):
    ending = run(faults, "hang", timeout=1)
    assert ending.code is None
    assert "hangs" in emulator.describe(ending)


def test_endless_text(faults):
    ending = run(faults, "chatter")
    assert ending.code is None
    assert len(ending.output) <= emulator.OUTPUT_MAX
    assert "prints without end" in emulator.describe(ending)


def test_a_reset_is_not_a_success(faults):
    ending = run(faults, "reset")
    assert ending.code == 0  # what makes it deceptive
    assert "reset" in emulator.describe(ending)


def test_exit_codes_can_be_told_apart():
    meanings = emulator.exit_meanings()
    names = [name for name, _ in meanings.values()]
    text = emulator.CONTRACT.read_text(encoding="utf-8")
    assert len(names) == text.count("    SYSTEM_EXIT_") >= 20  # none overlooked, none twice
    assert emulator.exit_code("DONE") == 93
    # 0: reset or SIGTERM; 1: QEMU refused; 2: make; 124: timeout; 126 and more: the shell.
    assert not set(meanings) & {0, 1, 2, 124, *range(126, 256)}
    assert all(sentence for _, sentence in meanings.values())


def test_the_clock_counts_across_wraps(faults):
    """Two million instructions are 50,000 ticks of 40, whatever the period;
    only the wrap's own interrupt, some ten instructions, comes on top."""
    output = run(faults, "clock").output
    rows = [tuple(map(int, row)) for row in
            re.findall(r"clock: reload (\d+) ticks (\d+) backward (\d+)", output)]
    assert [reload for reload, _, _ in rows] == [16777215, 999, 99, 19]
    for reload, ticks, backward in rows:
        assert backward == 0
        wraps = ticks // (reload + 1)
        assert 50000 <= ticks <= 50001 + wraps * 16 // 40 + 1, (reload, ticks)


def test_the_clock_counts_across_a_wrap_of_all_24_bits(faults):
    output = run(faults, "clock-long", timeout=120).output
    ticks = int(re.search(r"clock: ticks (\d+)", output).group(1))
    assert ticks > 1 << 24
    assert 20_000_000 <= ticks <= 20_000_002


def test_the_same_run_counts_the_same_instructions(faults):
    assert run(faults, "clock").output == run(faults, "clock").output
