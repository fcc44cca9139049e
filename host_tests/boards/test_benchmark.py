# SPDX-License-Identifier: MIT
"""firmware/benchmark on the host: its lines, and the CRCs that docs/results.md promises for every board."""

import re
import subprocess

import pytest
from board_programs import ROOT, built
from fixel.base.errors import ToolError
from fixel.board import benchmark

BUILT_PROGRAMS = ()


def test_the_lines_have_the_crcs_of_the_page():
    page = (ROOT / "docs/results.md").read_text(encoding="utf-8")
    promised = dict(re.findall(r"^\| (\w+) \| `([0-9a-f]{8})` \|", page, re.MULTILINE))
    lines = [match.groupdict() for match in benchmark.LINE.finditer(benchmark.run(built("host/benchmark"), "host"))]
    assert {line["scene"]: line["crc"] for line in lines} == promised and len(promised) == 3
    assert all(line["board"] == "host" and line["clock"] == "0" for line in lines)


@pytest.mark.parametrize("said, code", [
    ("FIXEL,host,0,cube,1,00000000", 0), ("FIXEL,end", 0), ("FIXEL,host,0,cube,1,00000000\\nFIXEL,end", 1)])
def test_a_run_that_was_not_whole_is_refused(tmp_path, said, code):
    program = tmp_path / "program"
    program.write_text(f"#!/bin/sh\nprintf '{said}\\n'\nexit {code}\n", encoding="ascii")
    program.chmod(0o755)
    with pytest.raises(ToolError, match="did not end as it should"):
        benchmark.run(program, "host")


def test_a_board_without_a_main_is_refused():
    done = subprocess.run(["make", "benchmark", "BOARD=microbit"], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 2 and "that board has no main in firmware/benchmark; these have one:" in done.stderr and "pico" in done.stderr
