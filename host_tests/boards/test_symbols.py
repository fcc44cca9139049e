# SPDX-License-Identifier: MIT
"""Names for addresses: what a fault, a lockup and a hang say of the function
they happened in, and with what the tools end."""

import re
import subprocess
import sys

import pytest
from elftools.elf.elffile import ELFFile

from board_programs import BOARD, ROOT, built
from fixel.board import emulator, execute, flash_memory
from fixel.board.symbols import Symbols

BUILT_PROGRAMS = ()
SOURCE = "firmware/faults/core_cases.c"
ENDLESS = "firmware/faults/ending_cases.c"


@pytest.fixture(scope="module")
def faults():
    return built(f"{BOARD}/faults.elf")


def function(elf, name):
    """Where a function begins and its size, by another way than the tool's."""
    with open(elf, "rb") as file:
        symbol = ELFFile(file).get_section_by_name(".symtab").get_symbol_by_name(name)[0]
        return symbol["st_value"] & ~1, symbol["st_size"]


def line_of(call):
    """The number of the one source line that reads so."""
    lines = (ROOT / SOURCE).read_text(encoding="utf-8").splitlines()
    (number,) = [number for number, line in enumerate(lines, 1) if line.strip() == call]
    return number


def run(elf, case, timeout=20):
    return emulator.run_text(elf, ["faults", case], timeout)


def test_a_fault_names_function_and_line(faults):
    output = run(faults, "divide").output
    found = re.search(r"^  pc  0x([0-9a-f]{8})  in divide\+0x([0-9a-f]+) \((\S+):(\d+)\)$", output, re.MULTILINE)
    assert found, output
    start, size = function(faults, "divide")
    assert int(found[1], 16) == start + int(found[2], 16) < start + size
    assert (found[3], int(found[4])) == (SOURCE, line_of("sink = 100u / zero;"))
    caller = re.search(r"^  lr  0x([0-9a-f]{8})  in main\+0x", output, re.MULTILINE)
    assert caller, output
    start, size = function(faults, "main")
    assert start < int(caller[1], 16) <= start + size


def test_the_other_registers_stay(faults):
    output = run(faults, "divide").output
    for register in ("xpsr", "r0", "r4", "r11", "cfsr", "psp"):
        assert len(re.findall(rf"\b{register} +0x[0-9a-f]{{8}}", output)) == 1, output


def test_a_lockup_names_the_function(faults):
    output = run(faults, "lockup").output
    found = re.search(r"^  pc  0x([0-9a-f]{8})  in (\w+)\+", output, re.MULTILINE)
    assert found, output
    start, size = function(faults, found[2])
    assert start <= int(found[1], 16) < start + size


def test_a_hang_names_the_function(faults):
    hung = run(faults, "hang", timeout=0.5)
    words = execute.describe(hung)
    assert words.startswith("nothing new came while it used 0.5 s of CPU time: it hangs\n  pc  0x")
    assert re.search(rf"^  pc  0x[0-9a-f]{{8}}  in hang\+0x\d \({ENDLESS}:\d+\)$", words, re.MULTILINE), words
    assert re.search(r"^  lr  0x[0-9a-f]{8}  in main\+0x", words, re.MULTILINE), words


def test_endless_text_names_the_function(faults):
    assert re.search(r"prints without end\n  pc  0x[0-9a-f]{8}  in \w+\+", execute.describe(run(faults, "chatter")))


def test_text_that_is_no_fault_stays_as_it_is(faults):
    start, _ = function(faults, "divide")
    symbols = Symbols(faults)
    for text in ("", f"  pc  0x{start:08x}\n", f"pc 0x{start:08x}: a fault\nno fault: \n  pc  0x{start:08x}\n"):
        assert symbols.name_faults(text) == text
    text = f"fault: here\n  pc is lost\n  pc  0x{start:08x}  lr  0xfffffff1\n  r0  0x{start:08x}\n"
    assert symbols.name_faults(text) == ("fault: here\n  pc is lost\n"
                                         f"  pc  0x{start:08x}  {symbols.place('pc', start)}\n"
                                         f"  lr  0xfffffff1\n  r0  0x{start:08x}\n")


def test_places(faults):
    symbols = Symbols(faults)
    start, size = function(faults, "divide")
    after, _ = function(faults, "main")
    assert symbols.place("pc", start).startswith("in divide+0x0 (")
    assert symbols.place("pc", start + 1).startswith("in divide+0x0 (")  # Thumb
    assert symbols.place("lr", start + size).startswith(f"in divide+{size:#x}")  # a call that is the last instruction
    assert not symbols.place("lr", after).startswith("in main")
    assert symbols.place("pc", 0xFFFFFFF0) == ""
    assert symbols.place("address", 0x20000000) == ""


def test_a_remark_beside_an_address_stays_behind_its_name(faults):
    start, _ = function(faults, "divide")
    line = f"  pc  0x{start:08x}  "
    named = Symbols(faults).name_faults(f"fault: x\n{line}as it was\n").splitlines()[1]
    assert named.startswith(f"{line}in divide+0x0 (") and named.endswith("), as it was")


def test_a_program_without_symbols(tmp_path, faults):
    stripped = tmp_path / "stripped.elf"
    subprocess.run(["arm-none-eabi-strip", "-o", stripped, faults], check=True)
    start, _ = function(faults, "divide")
    plain = f"fault: x\n  pc  0x{start:08x}\n"
    assert "in divide+" in Symbols(faults).name_faults(plain)
    assert Symbols(stripped).name_faults(plain) == plain
    assert Symbols(tmp_path / "none").name_faults(plain) == plain


@pytest.fixture(scope="module")
def image(tmp_path_factory, faults):
    folder = tmp_path_factory.mktemp("flash")
    from fixel.scene import making
    making.build(str(ROOT / "scenes" / "tiny.toml"), str(folder / "tiny.fxls"))
    flash_memory.flash(BOARD, faults, folder / "tiny.fxls", folder / "board.bin")
    return folder / "board.bin"


@pytest.mark.parametrize("case, code", [("divide", "DIVIDE"), ("stack", "STACK"), ("nonsense", "ARGUMENT"),
                                        ("hang", 124), ("lockup", 134), ("reset", 1), ("mute", 1)])
def test_with_what_a_tool_ends(image, faults, tmp_path, monkeypatch, capsys, case, code):
    """The program's own code where it has one."""
    from fixel.board import boot
    from fixel.base.errors import run_main

    real = emulator.run
    monkeypatch.setattr(emulator, "run", lambda *arguments: real(*arguments, extra=[case]))
    monkeypatch.setattr(sys, "argv", ["fixel boot", "--board", BOARD, "--image", str(image), "--elf", str(faults),
                                      "--dump", str(tmp_path / "x.fxld"), "--timeout", "1"])
    with pytest.raises(SystemExit) as caught:
        run_main(boot.main)
    assert caught.value.code == (execute.exit_code(code) if isinstance(code, str) else code)
    assert capsys.readouterr().err.startswith("error: board mps2-an385 failed: ")


def test_the_codes_of_tools_and_programs_differ():
    assert not {execute.BAD, execute.HANG, execute.LOCKUP, 0, 2, 130} & set(execute.exit_meanings())
