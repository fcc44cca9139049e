# SPDX-License-Identifier: MIT
"""Each core's kernels against the portable ones, on the emulated core; fewer inputs than make equality."""

import re

import pytest

from board_programs import made
from conftest import run_cli

CORES = ("m0", "m3", "m4f", "m55")


@pytest.mark.parametrize("core", CORES)
def test_kernels_are_equal(core):
    done = run_cli("equality", made(f"build/equality/{core}.elf"), "--thousands", "20")
    assert done.returncode == 0, done.stdout + done.stderr
    lines = re.findall(rf"^{core} +(\S+) +([0-9,]+) inputs  0 differ$", done.stdout, re.MULTILINE)
    assert len(lines) >= 10, done.stdout
    assert all(int(cases.replace(",", "")) >= 15000 for _, cases in lines), done.stdout


def test_nothing_is_refused():
    done = run_cli("equality", "no-such.elf", "--thousands", "0")
    assert done.returncode == 2
    assert "--thousands is 1 to 1,000,000" in done.stderr
