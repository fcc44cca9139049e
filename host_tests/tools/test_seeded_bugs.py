# SPDX-License-Identifier: MIT
"""A test of the tests: bugs put into the library on purpose must each be seen."""

import tomllib

from conftest import CHECKOUT, run_cli

BUGS = tomllib.loads((CHECKOUT / "host_tests/seeded_bugs/bugs.toml").read_text(encoding="utf-8"))["bug"]


def test_there_are_bugs_of_every_kind():
    assert {"rounding", "sign", "carry", "fill rule", "shift"} <= {bug["kind"] for bug in BUGS}


def test_every_seeded_bug_is_caught():
    done = run_cli("seeded_bugs", timeout=600)
    assert done.returncode == 0, done.stdout + done.stderr
    assert f"{len(BUGS)} of {len(BUGS)} bugs caught" in done.stdout + done.stderr
