# SPDX-License-Identifier: MIT
"""make test's own driver: counts what ran, and no ending passes for a success without being one."""

import stat

import pytest
from conftest import run_cli

GOOD = "a.c:1:test_one:PASS\na.c:2:test_two:PASS\n\n-----------------------\n2 Tests 0 Failures 0 Ignored \nOK"
BAD = "a.c:1:test_one:PASS\na.c:2:test_two:FAIL: Expected 1 Was 2\n\n2 Tests 1 Failures 0 Ignored \nFAIL"
SKIPPED = "a.c:1:test_one:PASS\na.c:2:test_two:IGNORE: no\n\n2 Tests 0 Failures 1 Ignored \nOK"


def program(folder, name, text, code):
    """A program that prints a text and ends with a code."""
    file = folder / name
    file.write_text(f"#!/bin/sh\ncat <<'END'\n{text}\nEND\nexit {code}\n")
    file.chmod(file.stat().st_mode | stat.S_IXUSR)
    return file


def drive(*programs):
    done = run_cli("test", "--only", "host/", "--host-unit", *programs)
    return done.returncode, done.stdout.splitlines(), done


def test_last_line_adds_up(tmp_path):
    code, lines, _ = drive(program(tmp_path, "one", GOOD, 0), program(tmp_path, "two", GOOD, 0))
    assert (code, lines[-1]) == (0, "4 passed, 0 failed")
    assert len(lines) == 3


def test_failure_is_shown_whole(tmp_path):
    code, lines, done = drive(program(tmp_path, "one", GOOD, 0), program(tmp_path, "two", BAD, 1))
    assert (code, lines[-1]) == (1, "3 passed, 1 failed")
    assert "test_two:FAIL: Expected 1 Was 2" in done.stdout
    assert "PASS" not in done.stdout


def test_skipped_are_counted(tmp_path):
    code, lines, _ = drive(program(tmp_path, "one", SKIPPED, 0))
    assert (code, lines[-1]) == (0, "1 passed, 0 failed, 1 skipped")


@pytest.mark.parametrize("text, code", [
    ("a.c:1:test_one:PASS", 0),                 # ended before its summary
    ("a.c:1:test_one:PASS", 139),               # crashed
    ("", 0),                                    # said nothing
    (GOOD, 1),                                  # a sanitizer's complaint at the end
    (GOOD.replace("2 Tests", "3 Tests"), 0),    # a test that printed nothing
])
def test_endings_that_look_like_success(tmp_path, text, code):
    exit_code, lines, done = drive(program(tmp_path, "one", text, code))
    assert exit_code == 1 and lines[-1].endswith(" 1 failed")
    assert "one" in done.stdout


def test_a_program_that_is_not_there(tmp_path):
    exit_code, lines, _ = drive(tmp_path / "none")
    assert (exit_code, lines[-1]) == (1, "0 passed, 1 failed")


def test_nothing_ran():
    exit_code, lines, done = drive()
    assert (exit_code, lines[-1]) == (1, "0 passed, 0 failed")
    assert "no test ran" in done.stderr
