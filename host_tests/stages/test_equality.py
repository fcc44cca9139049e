# SPDX-License-Identifier: MIT
"""Each core's kernels against the portable ones, on the emulated core; fewer inputs than make equality."""

import json
import re

import pytest

from board_programs import ROOT, made
from conftest import run_cli
from fixel.check import kernel_equality

OF_WHOLE_ARMV7M = ("depth-outlines", "smooth-outlines", "smooth-planes", "depth-runs")
CORES = ("m0", "m3", "m4f", "m55", "m0-small", "m3-small", "m3-os")


def equality(core, journal, *more):
    return run_cli("equality", made(f"build/equality/{core}.elf"), "--journal", str(journal), *more)


def kernels_of(core):
    """The tests that a core's program lists. With FXL_SMALL no kernel is in assembly, so that list is shorter; outlines,
    small planes and rows with a depth buffer have kernels on Armv7-M alone, and none by -Os."""
    file = ROOT / "firmware/equality" / ("tests_small.c" if core.endswith("-small") else "tests.c")
    names = re.findall(r'^    \{"([\w-]+)", test_\w+\},$', file.read_text(encoding="utf-8"), re.MULTILINE)
    assert len(names) >= 8
    return [name for name in names if name not in OF_WHOLE_ARMV7M or not (core == "m0" or core.endswith("-os"))]


@pytest.mark.parametrize("core", CORES)
def test_kernels_are_equal(core, tmp_path):
    done = equality(core, tmp_path / "journal.json", "--thousands", "10")
    assert done.returncode == 0, done.stdout + done.stderr
    lines = re.findall(rf"^{core} +(\S+) +([0-9,]+) inputs  0 differ", done.stdout, re.MULTILINE)
    assert sorted(name for name, _ in lines) == sorted(kernels_of(core)), done.stdout
    assert all(int(cases.replace(",", "")) >= 10000 for _, cases in lines), done.stdout


def test_what_is_done_is_not_done_again(tmp_path):
    journal = tmp_path / "journal.json"
    first = equality("m3", journal, "--thousands", "1")
    assert first.returncode == 0 and "(before)" not in first.stdout, first.stdout + first.stderr
    again = equality("m3", journal, "--thousands", "1")
    assert again.stdout.count("(before)") == first.stdout.count(" inputs  0 differ")
    rows = json.loads(journal.read_text(encoding="utf-8"))["rows"]
    rows[0]["program"] = "another"
    journal.write_text(json.dumps({"rows": rows}), encoding="utf-8")
    third = equality("m3", journal, "--thousands", "1")
    assert third.stdout.count("(before)") == again.stdout.count("(before)") - 1
    more = equality("m3", journal, "--thousands", "2")
    assert "(before)" not in more.stdout


def test_nothing_is_refused():
    done = run_cli("equality", "no-such.elf", "--thousands", "0")
    assert done.returncode == 2
    assert "--thousands is 1 to 1,000,000" in done.stderr


def test_a_journal_has_one_row_of_each_kernel_and_core(tmp_path, capsys):
    def row(core, kernel, program="p", thousands=1):
        return {"core": core, "kernel": kernel, "program": program, "thousands": thousands, "inputs": 1, "differ": 0, "seconds": 0.5}
    journal = kernel_equality.Journal(tmp_path / "journal.json")
    for each in (row("m3", "b"), row("m3", "a"), row("m0", "a"), row("m3", "a", "q", 7)):
        journal.keep(each)
    assert len(capsys.readouterr().out.splitlines()) == 4
    kept = kernel_equality.Journal(tmp_path / "journal.json")
    assert kept.rows == [row("m0", "a"), row("m3", "a", "q", 7), row("m3", "b")]
    assert kept.find("m3", "a", "q", 7) == kept.find("m3", "a", "q", 6) == row("m3", "a", "q", 7)
    assert [kept.find(*of) for of in (("m3", "a", "q", 8), ("m3", "a", "p", 1), ("m0", "b", "p", 1))] == 3 * [None]
