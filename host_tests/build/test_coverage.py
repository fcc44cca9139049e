# SPDX-License-Identifier: MIT
"""What make coverage counts: of an export of llvm-cov, and of programs that fail."""

import sys

from fixel.check import clang_coverage

SUMMARY = {"lines": {"count": 10, "covered": 9}, "branches": {"count": 4, "covered": 3}, "mcdc": {"count": 3, "covered": 1}}


def file(name, records=()):
    return {"filename": name, "summary": SUMMARY, "mcdc_records": list(records)}


def test_files_and_rooms(tmp_path):
    records = [[7, 9, 8, 20, 0, 5, [True, False]], [30, 1, 30, 9, 0, 5, [False]]]
    files = clang_coverage.of_files([file(f"{tmp_path}/lib/math/a.c", records), file("lib/math/b.c"), file("lib/include/fixel/c.h"),
                               file("lib/include/fixel/d.h"), file("host_tests/unit/e.c"), file("/usr/include/f.h")], tmp_path)
    assert list(files) == ["lib/math/a.c", "lib/math/b.c", "lib/include/fixel/c.h", "lib/include/fixel/d.h"]
    assert files["lib/math/a.c"] == {"lines": [9, 10], "branches": [3, 4], "conditions": [1, 3],
                                         "unreached": [[7, 2], [30, 1]]}
    rooms = clang_coverage.by_room(files)
    assert list(rooms) == ["lib/include/fixel", "lib/math", "all together"]
    assert rooms["lib/math"] == {"lines": [18, 20], "branches": [6, 8], "conditions": [2, 6]}
    assert rooms["all together"] == {"lines": [36, 40], "branches": [12, 16], "conditions": [4, 12]}
    assert clang_coverage.rows(rooms)[-1] == ["all together", "36 of 40   90.0 %", "12 of 16   75.0 %", "4 of 12   33.3 %"]


def test_a_room_without_decisions():
    assert clang_coverage.rows({"lib/a": {"lines": [1, 1], "branches": [0, 0], "conditions": [0, 0]}}) == \
        [["lib/a", "1 of 1  100.0 %", "0 of 0", "0 of 0"]]


def test_programs_that_fail_are_named_and_the_others_counted(tmp_path):
    write = "import os, sys; open(os.environ['LLVM_PROFILE_FILE'], 'w').close(); "
    programs = []
    for name, words in (("good", write), ("bad", write + "sys.exit('no pixel')"), ("worse", "raise SystemExit(3)")):
        program = tmp_path / name
        program.write_text(f"#!{sys.executable}\n{words}\n", encoding="utf-8")
        program.chmod(0o755)
        programs.append([program])
    counts, failed = clang_coverage.run_programs(programs, tmp_path, 2)
    assert [each.name for each in counts] == ["0.profraw", "1.profraw"]
    assert failed == {"bad": "no pixel\n", "worse": ""}
