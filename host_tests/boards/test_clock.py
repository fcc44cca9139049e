# SPDX-License-Identifier: MIT
"""Whether a board's clock counts instructions, whatever SysTick's frequency is."""

import re

import pytest

from board_programs import BOARD, EVERY_BOARD, built
from fixel.board import emulator

BUILT_PROGRAMS = ()
WRAP = 40               # instructions that the interrupt of a wrap takes, at most


def output_of(board, case, timeout=60):
    ending = emulator.run_text(built(f"{board}/faults.elf"), ["faults", case], timeout)
    assert ending.code == emulator.exit_code("DONE"), ending.output
    return ending.output


def frequency(output):
    """Ticks a second, as the program was built."""
    return int(re.search(r"^clock: hz (\d+)$", output, re.MULTILINE)[1])


@pytest.mark.parametrize("board", EVERY_BOARD)
def test_n_instructions_count_as_n_within_a_tick(board):
    """Each reading may be early by a tick; what a reading itself takes is told beside."""
    output = output_of(board, "clock-instructions")
    hertz = frequency(output)
    tick = 10**9 / hertz
    rows = [tuple(map(int, row)) for row in
            re.findall(r"^clock: spun (\d+) counted (\d+) reading (\d+)$", output, re.MULTILINE)]
    assert [spun for spun, _, _ in rows] == [2, 200, 24690, 2_000_000, 100_000_000]
    reading = min(reading for _, _, reading in rows)
    for spun, counted, _ in rows:
        wraps = 1 + spun * hertz // 10**9 // 2**24
        assert -2 * tick <= counted - reading - spun <= 2 * tick + wraps * WRAP, (spun, counted, reading)


@pytest.mark.parametrize("board", EVERY_BOARD)
def test_the_clock_counts_across_wraps(board):
    """The same work takes the same ticks, whatever the period; only the wrap's
    own interrupt comes on top."""
    output = output_of(board, "clock")
    hertz = frequency(output)
    expected = 2_000_000 * hertz / 10**9
    rows = [tuple(map(int, row)) for row in
            re.findall(r"^clock: reload (\d+) ticks (\d+) backward (\d+)$", output, re.MULTILINE)]
    assert [reload for reload, _, _ in rows] == [16777215, 999, 99, 39]
    for reload, ticks, backward in rows:
        assert backward == 0
        wraps = ticks // (reload + 1) + 1
        reading = 600 * hertz / 10**9       # instructions, on the slowest core
        assert expected - 1 <= ticks <= expected + reading + wraps * WRAP * hertz / 10**9 + 2, (reload, ticks)


def test_the_clock_counts_across_a_wrap_of_all_24_bits():
    output = output_of(BOARD, "clock-long", timeout=120)
    ticks, instructions = map(int, re.search(r"clock: ticks (\d+) instructions (\d+)", output).groups())
    assert ticks > 1 << 24
    assert 800_000_000 <= instructions <= 800_000_000 + 400 + ticks // (1 << 24) * WRAP


def test_the_same_run_counts_the_same_instructions():
    assert output_of(BOARD, "clock") == output_of(BOARD, "clock")
