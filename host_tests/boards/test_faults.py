# SPDX-License-Identifier: MIT
"""What a fault on a board looks like from outside: each names itself, the
address, the function, and has a code of its own; and none passes for success.

Three boards stand for the three kinds of cores."""

import functools
import re

import pytest
from elftools.elf.elffile import ELFFile

from board_programs import BOARD, EVERY_BOARD, built
from fixel.board import emulator

BUILT_PROGRAMS = ()
ARMV6M, ARMV7M, ARMV8M = "microbit", BOARD, "mps2-an505"
CORES = [ARMV6M, ARMV7M, ARMV8M]
NOWHERE = 0xE8000000    # of firmware/faults


@functools.cache
def program(board):
    return built(f"{board}/faults.elf")


def run(board, case, timeout=60):
    return emulator.run_text(program(board), ["faults", case], timeout)


def symbol(board, name):
    """A symbol's address and size; of an absolute one the address is the value."""
    with open(program(board), "rb") as file:
        found = ELFFile(file).get_section_by_name(".symtab").get_symbol_by_name(name)
    assert found and len(found) == 1, name
    return found[0]["st_value"], found[0]["st_size"]


def printed(output, word):
    """A register or address as the report has it; None where it has none."""
    found = re.search(rf"^  (?:.* )?{word} +0x([0-9a-f]{{8}})", output, re.MULTILINE)
    return int(found[1], 16) if found else None


def check(ending, code, words):
    assert ending.code == emulator.exit_code(code), ending.output
    for word in words:
        assert word in ending.output
    assert emulator.exit_meanings()[ending.code][1] in emulator.describe(ending)


def assert_names_function(ending, word, function):
    """The tool's name for an address of the report."""
    assert re.search(rf"^  {word} +0x[0-9a-f]{{8}}  in {function}\+0x", ending.output, re.MULTILINE), ending.output


def cannot_show(ending, why):
    """A board says that it has no such fault: neither silence nor success."""
    assert ending.code == emulator.exit_code("BOARD"), ending.output
    assert f"this board cannot show that: {why}" in ending.output


# --- the stack ---------------------------------------------------------------

@pytest.mark.parametrize("board", EVERY_BOARD)
def test_a_stack_that_overflows_slowly(board):
    ending = run(board, "stack")
    check(ending, "STACK", ["fault: stack overflow"])
    (limit, _), (size, _) = symbol(board, "fxl_stack_limit"), symbol(board, "fxl_stack_size")
    # Where a register holds the limit, the pointer stays where it was: above, by less than a frame.
    assert limit - 1024 <= printed(ending.output, "address") <= limit + 96
    assert_names_function(ending, "from" if "pc and r0 to r3 are lost" in ending.output else "pc", "overflow_slowly")
    used, of = map(int, re.search(r"^stack: (\d+) of (\d+) bytes", ending.output, re.MULTILINE).groups())
    assert of == size and size - 256 <= used <= size


@pytest.mark.parametrize("board", EVERY_BOARD)
def test_a_stack_that_leaps_over_its_guard(board):
    ending = run(board, "leap")
    check(ending, "STACK", ["fault: stack overflow"])
    assert printed(ending.output, "address") is not None


@pytest.mark.parametrize("board", CORES)
def test_a_stack_used_to_the_brim_where_nothing_guards_it(board):
    ending = run(board, "brim")
    if board != ARMV6M:
        cannot_show(ending, "the stack's end is guarded")
        return
    check(ending, "STACK", ["stack overflow"])
    assert printed(ending.output, "address") == symbol(board, "fxl_stack_limit")[0]
    assert_names_function(ending, "from", "brim")


def test_the_stack_limit_of_armv8m_is_what_stops_it():
    assert "STKOF" in run(ARMV8M, "stack").output
    assert "STKOF" in run(ARMV8M, "leap").output


@pytest.mark.parametrize("board", EVERY_BOARD)
def test_a_program_that_lives_is_left_alone_and_says_how_deep_its_stack_went(board):
    """It feeds the watchdog for many times as long as that waits."""
    ending = run(board, "alive")
    assert ending.code == emulator.exit_code("DONE") and "alive" in ending.output, ending.output
    used, of = map(int, re.search(r"^stack: (\d+) of (\d+) bytes", ending.output, re.MULTILINE).groups())
    assert 0 < used < of == symbol(board, "fxl_stack_size")[0]


# --- what the core catches ---------------------------------------------------

@pytest.mark.parametrize("board", EVERY_BOARD)
@pytest.mark.parametrize("case, function", [
    ("divide", "divide"),
    ("divide-long", "divide_long"),
    ("divide-long-signed", "divide_long_signed"),
])
def test_a_division_by_zero(board, case, function):
    """By the core, or by the compiler's run-time: the culprit is who divides."""
    ending = run(board, case)
    check(ending, "DIVIDE", ["fault: division by zero"])
    assert_names_function(ending, "pc", function)
    start, size = symbol(board, function)
    assert (start & ~1) <= printed(ending.output, "pc") < (start & ~1) + size


def misaligned_cases(board):
    """The cases that a board's program has, by the names in it."""
    data = program(board).read_bytes()
    return sorted({name.decode() for name in re.findall(rb"misaligned-[a-z-]+(?=\0)", data)})


@pytest.mark.parametrize("board, least", [(ARMV6M, 11), (ARMV7M, 23), (ARMV8M, 23)])
def test_a_misaligned_access_by_every_instruction(board, least):
    cases = misaligned_cases(board)
    assert len(cases) >= least
    target = symbol(board, "misaligned_words")[0] + 65
    for case in cases:
        ending = run(board, case)
        check(ending, "UNALIGNED", ["fault: misaligned address"])
        assert printed(ending.output, "address") == target, case
        assert_names_function(ending, "pc", case.removeprefix("misaligned-").replace("-", "_"))


@pytest.mark.parametrize("board", EVERY_BOARD)
def test_a_write_to_flash(board):
    ending = run(board, "flash")
    if board == ARMV6M:
        cannot_show(ending, "no memory protection, and its flash ignores writes")
        return
    check(ending, "FLASH", ["fault: write to flash"])
    assert printed(ending.output, "address") == symbol(board, "fxl_scene_base")[0] + 64
    assert_names_function(ending, "pc", "flash_write")


@pytest.mark.parametrize("board", CORES)
def test_a_null_pointer(board):
    ending = run(board, "null")
    if board == ARMV6M:
        cannot_show(ending, "no memory protection, and address 0 is memory")
        return
    check(ending, "NULL", ["fault: null pointer"])
    assert printed(ending.output, "address") == 4
    assert_names_function(ending, "pc", "null_read")


@pytest.mark.parametrize("board", CORES)
def test_a_call_of_null(board):
    ending = run(board, "null-call")
    check(ending, "NULL", ["fault: null pointer"])
    assert printed(ending.output, "address") == printed(ending.output, "pc") == 0


@pytest.mark.parametrize("board", CORES)
def test_an_address_where_nothing_is(board):
    ending = run(board, "unmapped")
    check(ending, "BUS", ["fault: nothing at this address"])
    assert printed(ending.output, "address") == NOWHERE
    assert_names_function(ending, "pc", "unmapped")


def test_a_board_that_answers_everywhere_says_so():
    cannot_show(run("lm3s6965evb", "unmapped"), "it answers 0 where it has nothing")


@pytest.mark.parametrize("board, code", [(ARMV6M, "BUS"), (ARMV7M, "PROTECTION"), (ARMV8M, "PROTECTION")])
def test_a_jump_to_nowhere(board, code):
    """That memory is for devices: the cores that know it do not even ask it."""
    ending = run(board, "jump")
    check(ending, code, [])
    assert printed(ending.output, "address") == printed(ending.output, "pc") == NOWHERE
    assert_names_function(ending, "lr", "jump|main")


@pytest.mark.parametrize("board", CORES)
def test_an_undefined_instruction(board):
    ending = run(board, "undefined")
    check(ending, "USAGE", ["fault: instruction that the core cannot execute"])
    assert_names_function(ending, "pc", "undefined")


@pytest.mark.parametrize("board", CORES)
def test_an_interrupt_that_nobody_asked_for(board):
    ending = run(board, "interrupt")
    check(ending, "INTERRUPT", ["fault: unexpected interrupt (exception 11)"])
    assert_names_function(ending, "pc", "interrupt")


@pytest.mark.parametrize("case", ["divide", "flash", "undefined"])
def test_the_report_has_the_registers(case):
    output = run(ARMV7M, case).output
    for register in ("r0", "r4", "r11", "r12", "cfsr", "hfsr", "psp", "xpsr"):
        assert printed(output, register) is not None, output


# --- hangs -------------------------------------------------------------------

@pytest.mark.parametrize("board", EVERY_BOARD)
def test_a_hang_is_reported_by_the_watchdog(board):
    ending = run(board, "hang-shortly")
    check(ending, "HANG", ["fault: the program hung: the watchdog was not fed"])
    assert_names_function(ending, "pc", "hang")


def test_a_hang_after_a_sign_of_life():
    ending = run(ARMV7M, "hang-watched")
    check(ending, "HANG", ["fault: the program hung: the watchdog was not fed"])
    assert_names_function(ending, "pc", "hang_at_work")


@pytest.mark.parametrize("board", CORES)
def test_a_hang_with_interrupts_masked(board):
    """Only an interrupt that cannot be masked tells of it; where QEMU has no such
    watchdog, the tools do."""
    ending = run(board, "hang-masked", timeout=1 if board == ARMV6M else 60)
    if board == ARMV6M:
        assert ending.code is None
        assert "it hangs" in emulator.describe(ending)
    else:
        check(ending, "HANG", [])


def test_a_hang_masked_from_a_watchdog_with_an_interrupt_is_reset():
    """On the chip, too: nothing goes on as if all were well."""
    ending = run("lm3s6965evb", "hang-masked")
    assert ending.code == 0
    assert "reset" in emulator.describe(ending)


# --- endings that deceive ----------------------------------------------------

@pytest.mark.parametrize("board", CORES)
def test_a_lockup(board):
    ending = run(board, "lockup")
    assert ending.code not in (0, emulator.exit_code("DONE"))
    assert "locked up" in emulator.describe(ending)


def test_a_hang_that_nobody_watches():
    ending = run(ARMV7M, "hang", timeout=1)
    assert ending.code is None
    assert "hangs" in emulator.describe(ending)


def test_endless_text():
    ending = run(ARMV7M, "chatter")
    assert ending.code is None
    assert len(ending.output) <= emulator.OUTPUT_MAX
    assert "prints without end" in emulator.describe(ending)


@pytest.mark.parametrize("board", CORES)
def test_a_reset_is_not_a_success(board):
    ending = run(board, "reset")
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
