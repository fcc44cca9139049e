# SPDX-License-Identifier: MIT
"""What the tools know of the board pico without its emulator: UF2 files, what is missing, and that make test leaves it out."""

import os
import shutil
import subprocess

import pytest
from board_programs import ROOT, read_uf2
from fixel.base.errors import ToolError
from fixel.board import uf2


def test_what_is_missing_is_said(tmp_path):
    """A machine with sh, Python and no node."""
    for name in ("sh", "dirname", "python3"):
        (tmp_path / name).symlink_to(shutil.which(name))
    done = subprocess.run([ROOT / "tools/setup.sh", "--missing", "pico"], env={"PATH": str(tmp_path)}, capture_output=True, text=True,
                          check=True)
    assert {"nodejs", "npm", "gcc-arm-none-eabi"} <= set(done.stdout.split())


def test_make_test_leaves_the_board_out():
    """So a machine needs none of its tools for make test."""
    environment = {key: value for key, value in os.environ.items() if not key.startswith(("MAKE", "MFLAGS", "FIXEL_EXTRA"))}
    said = subprocess.run(["make", "--dry-run", "test"], cwd=ROOT, env=environment, capture_output=True, text=True, check=True).stdout
    assert "boards/microbit" in said and "boards/pico" not in said


@pytest.mark.parametrize("at, value, sentence", [
    (0, 0, "no marks"), (508, 0, "no marks"), (28, 0, "another chip"), (20, 9, "out of order"), (12, 1, "cannot be for")])
def test_damaged_uf2_blocks_are_refused(at, value, sentence):
    good = uf2.encode([(0x10000000, bytes(range(256)) * 2)], 0xE48BFF56)
    assert uf2.decode(good, 0xE48BFF56) == {0x10000000: bytes(range(256)), 0x10000100: bytes(range(256))} == read_uf2(good)
    with pytest.raises(ToolError, match=sentence):
        uf2.decode(good[:at] + bytes([value]) + good[at + 1:], 0xE48BFF56)
    with pytest.raises(ToolError, match="does not end"):
        uf2.decode(good[:-1], 0xE48BFF56)
