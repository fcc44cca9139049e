# SPDX-License-Identifier: MIT
"""make changed: how many steps each process takes, and what is said of a wrong picture."""

import pytest

from fixel.base.errors import ToolError
from fixel.check import changed

BUILT_PROGRAMS = ()
PROGRAM = """#!/bin/sh
echo "$FIXEL_CHANGED_STEPS $FIXEL_CHANGED_SEED" >>"$(dirname "$0")/asked"
echo "test_changed.c:7:test_the_boxes:PASS"
test "$FIXEL_CHANGED_SEED" != 4 && exit 0
echo "test_changed.c:9:test_the_boxes:FAIL: Memory Mismatch"
exit 1
"""


@pytest.fixture(name="units")
def fixture_units(tmp_path):
    """A folder with a program that finds a wrong picture for the seed 4."""
    (tmp_path / "test_changed").write_text(PROGRAM, encoding="utf-8")
    (tmp_path / "test_changed").chmod(0o755)
    return tmp_path


def test_steps_are_shared_out_with_a_seed_each(units, capsys):
    assert changed.main(["--units", str(units), "--steps", "25000", "--seed", "1"]) == 0
    assert sorted((units / "asked").read_text().splitlines()) == ["10000 1", "10000 2", "5000 3"]
    assert "25,000, seeds 1 to 3" in capsys.readouterr().out


def test_a_wrong_picture_fails_and_is_told_with_its_seed(units, capsys):
    assert changed.main(["--units", str(units), "--steps", "30000", "--seed", "3"]) == 1
    said = capsys.readouterr().out
    assert "FIXEL_CHANGED_SEED=4 " in said and "FAIL: Memory Mismatch" in said and "FIXEL_CHANGED_SEED=5 " not in said


def test_what_is_refused(units):
    for words in (["--steps", "0"], ["--seed", "x"]):
        with pytest.raises(ToolError):
            changed.main(["--units", str(units), *words])
    with pytest.raises(ToolError, match="is not built"):
        changed.main(["--units", str(units / "nowhere")])
