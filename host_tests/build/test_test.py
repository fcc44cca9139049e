# SPDX-License-Identifier: MIT
"""The drivers of make test and make test-anywhere: they count what ran, and no ending passes for a success without being one."""

import json
import os
import re
import shlex
import signal
import stat
import subprocess
import sys
import types

import named_programs
import pytest
import warm_start

from board_programs import built, EVERY_BOARD, ROOT
from conftest import assert_one_sentence, CHECKOUT, dry_run, environment, run_cli, run_make, TOOLS, write_files
from fixel.base.errors import ToolError
from fixel.check import test_anywhere, pytest_client, pytest_server, test as check_test

BUILT_PROGRAMS = ("host/judge", "boards/*/unit/units.json")
GOOD = "a.c:1:test_one:PASS\na.c:2:test_two:PASS\n\n-----------------------\n2 Tests 0 Failures 0 Ignored \nOK"
BAD = "a.c:1:test_one:PASS\na.c:2:test_two:FAIL: Expected 1 Was 2\n\n2 Tests 1 Failures 0 Ignored \nFAIL"
SKIPPED = "a.c:1:test_one:PASS\na.c:2:test_two:IGNORE: no\n\n2 Tests 0 Failures 1 Ignored \nOK"


def program(folder, name, text, code):
    """A program that prints a text and ends with a code."""
    file = folder / name
    file.write_text(f"#!/bin/sh\ncat <<'END'\n{text}\nEND\nexit {code}\n")
    file.chmod(file.stat().st_mode | stat.S_IXUSR)
    return file


def host_units(*programs):
    """The options that name programs of one folder."""
    return ["--host-units", programs[0].parent, *(file.name for file in programs)] if programs else []


def drive(*programs):
    done = run_cli("test", "--only", "host/", *host_units(*programs))
    return done.returncode, done.stdout.splitlines(), done


def test_last_line_adds_up(tmp_path):
    code, lines, _ = drive(program(tmp_path, "one", GOOD, 0), program(tmp_path, "two", GOOD, 0))
    assert (code, lines[-1]) == (0, "4 passed, 0 failed")
    assert len(lines) == 6, "two programs, the slowest of them, the sum"


def test_the_ten_slowest_are_named_by_their_cpu_time(tmp_path):
    """Those that work, not those that wait; the slowest first. What they start counts."""
    files = [program(tmp_path, f"quick{number}", GOOD, 0) for number in range(11)]
    busy = ["i=0; while [ $i -lt {} ]; do i=$((i + 1)); done", "sh -c 'i=0; while [ $i -lt {} ]; do i=$((i + 1)); done'"]
    for name, work in (("waits", "sleep 1"), ("works", busy[0].format(200_000)), ("starts", busy[1].format(800_000))):
        files.append(program(tmp_path, name, GOOD, 0))
        files[-1].write_text(files[-1].read_text().replace("exit", f"{work}\nexit"))
    _, lines, _ = drive(*files)
    first = next(number for number, line in enumerate(lines) if re.fullmatch(r"slowest of \d+ s of CPU:", line))
    named = [re.fullmatch(r" +(\d+\.\d) s  host/(\w+)", line) for line in lines[first + 1:-1]]
    assert [each[2] for each in named][:2] == ["starts", "works"] and len(named) == 10
    assert float(named[0][1]) > float(named[1][1]) > 0


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


def units_json(folder, programs, left_out):
    folder.mkdir()
    file = folder / "units.json"
    file.write_text(json.dumps({"programs": programs, "left_out": left_out}))
    return file


def test_what_a_board_has_no_room_for_is_said_and_not_counted(tmp_path):
    small = units_json(tmp_path / "small", {}, {"test_long": "RAM overflowed by 9 bytes", "test_big": "FLASH overflowed"})
    arguments = [*host_units(program(tmp_path, "one", GOOD, 0)), "--units", "small", small]
    done = run_cli("test", "--only", "host/", *arguments)
    assert done.returncode == 0
    assert [line for line in done.stdout.splitlines()[1:] if "slowest" not in line and "0.0 s" not in line] == [
        "left out, no room: small: test_big (FLASH overflowed), test_long (RAM overflowed by 9 bytes)", "2 passed, 0 failed"]
    done = run_cli("test", "--board", "host", *arguments)
    assert done.stdout.splitlines()[-1] == "2 passed, 0 failed" and "left out" not in done.stdout


def test_one_board_alone(tmp_path):
    """The programs of the others, and the tools' tests, are not even started."""
    first = units_json(tmp_path / "first", {"units-01.elf": ["test_a"]}, {})
    second = units_json(tmp_path / "second", {"units-01.elf": ["test_b", "test_c"]}, {})
    done = run_cli("test", "--board", "second", "--units", "first", first, "--units", "second", second)
    assert "second/test_b" in done.stdout and "second/test_c" in done.stdout and "first" not in done.stdout
    assert done.stdout.splitlines()[-1] == "0 passed, 2 failed"


def test_files_of_a_program_are_chosen_by_name(tmp_path):
    only = units_json(tmp_path / "b", {"units-01.elf": ["test_a", "test_b"], "units-02.elf": ["test_c"]}, {})
    done = run_cli("test", "--only", "b/test_b", "--units", "b", only)
    assert "b/test_b" in done.stdout and "test_a" not in done.stdout and "test_c" not in done.stdout


def test_several_words_choose(tmp_path):
    only = units_json(tmp_path / "b", {"units-01.elf": ["test_a", "test_b"], "units-02.elf": ["test_c"]}, {})
    done = run_cli("test", "--only", "b/test_a b/test_c", "--units", "b", only)
    assert "b/test_a" in done.stdout and "b/test_c" in done.stdout and "b/test_b" not in done.stdout
    assert "on b: BOARD= names another" in done.stdout.splitlines()[-2]


@pytest.mark.parametrize("only, unknown", [("test_scan host/test_walk tools/test_stl", None), ("test_scan nothing", "nothing")])
def test_each_word_must_choose_something(only, unknown):
    options = types.SimpleNamespace(only=only)
    if unknown is None:
        check_test.before(options)
    else:
        with pytest.raises(ToolError, match=f"'{unknown}'"):
            check_test.before(options)


def compiled(tmp_path, only, *settings):
    """The sources that make test ONLY= would compile from nothing."""
    done = run_make("-n", "test-programs", f"BUILD={tmp_path}", "V=1", *settings, ONLY=only)
    assert done.returncode == 0, done.stderr
    return re.findall(r" -c (\S+) -o (\S+)", done.stdout.replace("\\\n", " "))


def test_a_unit_test_is_built_with_what_it_needs(tmp_path):
    """On the host and on the default board, or on the board that is named."""
    built = compiled(tmp_path, "test_pixels")
    sources = {source for source, _ in built}
    assert {"host_tests/unit/test_pixels.c", "lib/screen/grey4.c"} <= sources and len(built) <= 250
    assert not sources & {"lib/order/outlines.c", "lib/game/slide.c", "host_tests/unit/test_scan.c", "lib/screen/pages.c"}
    assert sum("/core/" in target for _, target in built) > 10 and not any("/boards/microbit/" in target for _, target in built)
    other = compiled(tmp_path, "test_pixels", "BOARD=microbit")
    assert {target.partition("/boards/")[2].partition("/")[0] for _, target in other} == {"", "microbit"}


def test_several_files_of_tests_are_built_together(tmp_path):
    targets = {target for _, target in compiled(tmp_path, "host/test_scan host/test_slide")}
    assert {f"{tmp_path}/host/unit/test_{name}.o" for name in ("scan", "slide")} <= targets
    assert all(target.startswith(str(tmp_path / "host")) for target in targets)


def test_each_file_names_its_programs(tmp_path):
    own = tmp_path / "test_own.py"
    own.write_text("A, B = 1, 2\nBUILT_PROGRAMS = ('host/judge', 'bench/*')\n")
    assert check_test.programs_of(own) == ("host/judge",)
    own.write_text("A, B = 1, 2\n")
    with pytest.raises(ToolError, match="test_own.py: .*BUILT_PROGRAMS"):
        check_test.programs_of(own)
    assert "build/host/judge" in check_test.needs(types.SimpleNamespace(only="", board="", host_units=[], units=[]))


def command_of(board):
    """What make test of one board would call, as words."""
    done = dry_run("test", f"BOARD={board}")
    assert done.returncode == 0, done.stderr
    whole = done.stdout.replace("\\\n", " ")
    return shlex.split(next(line for line in whole.splitlines() if "--units" in line))


def core_of(board):
    """The flags of a board's core. An M7 has the M4's objects (test_unit_tests.py)."""
    setting = (ROOT / "boards" / board / "board.mk").read_text(encoding="utf-8")
    return re.search(r"^BOARD_CORE := (.*)$", setting, re.MULTILINE)[1].replace("cortex-m7", "cortex-m4")


# The cores whose unit tests make boards alone builds and runs.
NOT_TESTED = {core_of("netduino2")}


@pytest.mark.parametrize("board", [board for board in EVERY_BOARD if core_of(board) not in NOT_TESTED])
def test_every_unit_test_runs_on_a_board_or_is_named(board):
    """Each file of host_tests/unit once; the linker says why one is left out."""
    words = command_of(board)
    file = words[words.index("--units") + 2]
    assert file == f"build/boards/{board}/unit/units.json" and words.count("--units") == 1
    linked = json.loads(built(f"{board}/unit/units.json").read_text(encoding="utf-8"))
    run = [name for names in linked["programs"].values() for name in names]
    assert sorted([*run, *linked["left_out"]]) == sorted(file.stem for file in (ROOT / "host_tests/unit").glob("test_*.c"))
    assert run and all(re.search(r"(RAM|FLASH) overflowed by \d+ bytes", why) for why in linked["left_out"].values())


def test_unit_tests_run_on_a_board_for_each_build_of_the_library():
    """Once for each that is not by -Os alone; make boards runs them on every board."""
    def boards(*command):
        words = shlex.split(dry_run(*command).stdout.replace("\\\n", " "))
        return [words[at + 1] for at, word in enumerate(words) if word == "--units"]
    tested = boards("test")
    assert sorted(map(core_of, tested)) == sorted({core_of(board) for board in EVERY_BOARD} - NOT_TESTED)
    assert boards("test", "ONLY=test_pixels") == ["mps2-an385"]
    assert [board for board in sorted(boards("boards")) if board != "rv32"] == EVERY_BOARD     # rv32: where its tools are


def test_make_test_links_what_make_boards_links():
    """Every program, those of boards too on which make test runs no unit tests; but those of a core that it does not test."""
    words = shlex.split(dry_run("test").stdout.replace("\\\n", " "))
    built, = [word.partition("=")[2].split() for word in words if word.startswith("FIXEL_BUILT=")]
    for board in EVERY_BOARD:
        assert f"build/boards/{board}/walk.elf" in built
        assert (f"build/boards/{board}/unit/units.json" in built) == (core_of(board) not in NOT_TESTED)


def test_make_test_of_one_board_runs_nothing_else():
    one, other = EVERY_BOARD[:2]
    words = command_of(one)
    assert words[words.index("--board") + 1] == one
    assert other not in " ".join(words)


def test_a_board_that_is_none_is_refused():
    done = run_make("test", "BOARD=nonesuch")
    assert done.returncode == 2 and done.stdout == ""
    assert 'there is no board "nonesuch"; the boards are: host ' in done.stderr
    for board in EVERY_BOARD:
        assert board in done.stderr


@pytest.mark.parametrize("code, failures, failed", [(0, 0, 0), (1, 2, 2), (3, 0, 1)])
def test_a_run_of_pytest_that_fails_itself_counts_as_a_test_that_failed(tmp_path, code, failures, failed):
    report = tmp_path / "report.xml"
    report.write_text(f'<testsuites><testsuite tests="5" skipped="1" failures="{failures}" errors="0"/></testsuites>')
    outcome = check_test._pytest_outcome("f", report, code, "words")
    assert (outcome.passed, outcome.failed, outcome.skipped, outcome.output) == (4 - failed, failed, 1, "words")


def test_a_run_of_tests_is_answered_by_its_process_and_then_by_how_it_ended(monkeypatch, capsys):
    monkeypatch.setattr(pytest_server, "warm_start", None, raising=False)
    monkeypatch.setattr(pytest_server.sys, "stdin", ["{}\n", "{}\n"])
    monkeypatch.setattr(pytest_server.os, "fork", lambda: 4321)
    used = types.SimpleNamespace(ru_utime=1.5, ru_stime=0.25)
    monkeypatch.setattr(pytest_server.os, "wait4", lambda process, _: (process, 2 << 8, used))
    pytest_server.answer()
    assert capsys.readouterr().out == 2 * "4321\n2 1.75\n"


# --- processes that end -------------------------------------------------------

ENDS = {"leaves_with_0": "os._exit(0)", "leaves_with_1": "os._exit(1)", "kills_itself": "os.kill(os.getpid(), signal.SIGKILL)",
        "kills_its_parent": "os.kill(os.getppid(), signal.SIGKILL)"}


def test_a_file_whose_process_ends_is_a_failure_and_the_others_run(tmp_path):
    """Each of these is followed by one that passes."""
    files = {}
    for number, (name, body) in enumerate(ENDS.items()):
        files[f"room/test_{number}_{name}.py"] = f"import os, signal\ndef test_it():\n    {body}\n"
        files[f"room/test_{number}_then.py"] = "def test_it():\n    pass\n"
    write_files(tmp_path, files)
    program = (f"import pathlib, sys\nsys.path.insert(0, {str(TOOLS)!r})\nfrom fixel.check import test\n"
               f"test.TESTS = pathlib.Path({str(tmp_path)!r})\nsys.exit(test.main(['--only', 'room/', '--workers', '1']))")
    done = subprocess.run([sys.executable, "-c", program], env=environment(), stdin=subprocess.DEVNULL, capture_output=True,
                          text=True, check=False)
    lines = done.stdout.splitlines()
    assert (done.returncode, lines[-1]) == (1, f"{len(ENDS)} passed, {len(ENDS)} failed"), done.stderr
    for number, name in enumerate(ENDS):
        assert re.search(rf"FAIL room/test_{number}_{name} +0 passed, 1 failed", done.stdout)
        assert re.search(rf"ok   room/test_{number}_then +1 passed", done.stdout)
        assert re.search(rf"test_{number}_{name}\.py: .*ended with", done.stdout), "why"


@pytest.mark.parametrize("noticed", [True, False])
def test_a_process_that_ends_between_two_runs_is_started_anew(tmp_path, noticed):
    """Also if it ends just when it is asked."""
    (tmp_path / "test_it.py").write_text("def test_it():\n    pass\n")
    request = {"folder": str(tmp_path), "words": ["-q", "-p", "no:cacheprovider", "test_it.py"], "said": str(tmp_path / "said")}
    client = pytest_client.Client()
    try:
        assert client.run(request, 100)[0] == 0
        first = client._process
        first.kill()
        first.wait()
        if not noticed:
            first.poll = lambda: None
        assert client.run(request, 100)[0] == 0
        assert client._process is not first
    finally:
        client.close()


def test_a_job_that_cannot_be_done_is_a_failure_of_each_of_its_suites(capsys):
    def cannot(_argument):
        raise OSError("no more processes")
    jobs = [check_test.Job(("board/a", "board/b"), cannot, None), check_test.Job(("c",), lambda _: check_test.Outcome(passed=1), None)]
    outcomes, _ = check_test.run_jobs(jobs, 1)
    assert {name: outcome.failed for name, outcome in outcomes.items()} == {"board/a": 1, "board/b": 1, "c": 0}
    assert capsys.readouterr().out.count("OSError: no more processes") == 2


def test_a_test_that_runs_what_its_file_does_not_name_fails(monkeypatch, tmp_path):
    """A program below build/, and one that is handed to another or read: a sentence names it. What a test had made may run."""
    monkeypatch.setattr(named_programs, "BUILD", tmp_path)
    monkeypatch.setattr(named_programs, "_module", None)
    monkeypatch.setattr(named_programs, "_asked_for", set())
    monkeypatch.setenv(named_programs.NAMED, "")
    program, image = tmp_path / "host" / "judge", tmp_path / "board" / "walk.elf"
    write_files(tmp_path, {"host/judge": "#!/bin/sh\n", "board/walk.elf": ""})
    program.chmod(0o755)
    named_programs.of(types.SimpleNamespace(BUILT_PROGRAMS=("host/judge",)))
    subprocess.run([program], check=True)
    for use in (lambda: subprocess.run(["true", image], check=True), image.read_bytes):
        with pytest.raises(RuntimeError, match=r"build/board/walk\.elf, which the BUILT_PROGRAMS"):
            use()
    named_programs.add(image)
    subprocess.run(["true", image], check=True)
    named_programs.of(types.SimpleNamespace(BUILT_PROGRAMS=()))     # the next file, whose test does not ask again
    image.read_bytes()
    monkeypatch.setattr(named_programs, "_asked_for", set())
    named_programs.of(types.SimpleNamespace(BUILT_PROGRAMS=("board/*.elf",)))   # what its tests make themselves
    image.read_bytes()
    assert named_programs.missing() == []
    with pytest.raises(RuntimeError, match="build/host/judge, which"):
        subprocess.run([program], check=True)
    named_programs.of(types.SimpleNamespace(__file__=str(named_programs.ANYWHERE / "docs" / "test_own.py")))
    subprocess.run(["true", image], check=True)
    with pytest.raises(RuntimeError, match="test_own.py has no BUILT_PROGRAMS"):
        named_programs.of(types.SimpleNamespace(__file__=str(tmp_path / "test_own.py")))


def test_a_tool_of_such_a_test_fails_too(build):
    program = "import subprocess; subprocess.run(['build/host/judge', '--help'])"
    for named, fails in (("host/judge", False), ("host/walk", True)):
        done = warm_start.run(["x"], ROOT, environment(**{named_programs.NAMED: named}), program=program)
        assert ("this test runs build/host/judge" in done.stderr) == fails, done.stderr


# --- make test-anywhere -------------------------------------------------------------

def outcome_of(folder, text):
    """The outcome of a file of tests, run by pytest as the command does."""
    file = folder / "test_one.py"
    file.write_text(text, encoding="utf-8")
    code, said, report = test_anywhere.run_file(file, folder)
    return test_anywhere.outcome(code, report), said


@pytest.mark.parametrize("text, line", [
    ("def test_a(): pass\ndef test_b(): pass\n", "p: passed: 2 tests"),
    ("import pytest\ndef test_a(): pass\ndef test_b(): pytest.skip('needs conan')\n", "p: passed: 1 tests; not run: needs conan (1 tests)"),
    ("import pytest\ndef test_b(): pytest.skip('needs conan')\n", "p: not run: needs conan (1 tests)"),
    ("import pytest\npytest.importorskip('no_such', reason='needs Dask')\n", "p: not run: needs Dask (1 tests)"),
    ("import pytest\npytest.skip('not today', allow_module_level=True)\n", "p: FAILED: 1 of 1 tests"),
    ("import pytest\ndef test_a(): pass\ndef test_b(): pytest.skip('not today')\n", "p: FAILED: 1 of 2 tests"),
    ("def test_a(): assert 1 == 2\n", "p: FAILED: 1 of 1 tests"),
    ("import no_such_module\n", "p: FAILED: 1 of 1 tests"),
    ("x = 1\n", "p: not run: needs a test"),
])
def test_what_a_line_says(tmp_path, text, line):
    found, said = outcome_of(tmp_path, text)
    assert test_anywhere.line("p", found) == line, said


def test_figures_of_tests_are_kept(tmp_path):
    found, said = outcome_of(tmp_path, "def test_a(record_property): record_property('figure', '3 pixels')\ndef test_b(): pass\n")
    assert found == {"passed": 2, "failed": 0, "needs": [], "figures": ["3 pixels"]}, said


def test_parts_are_folders_and_make_test_has_none_of_them():
    found = test_anywhere.files()
    assert "packages/test_cmake" in found
    assert not list((CHECKOUT / "host_tests" / "anywhere").glob("test_*.py")), "make test would run it"
    assert list(test_anywhere.chosen("packages/test_cmake", found)) == ["packages/test_cmake"]
    assert set(test_anywhere.chosen("packages", found)) < set(test_anywhere.chosen("", found)) or set(found) == set(test_anywhere.chosen("packages", found))
    with pytest.raises(ToolError, match="no part 'package'; did you mean packages"):
        test_anywhere.chosen("package", found)


def test_an_unknown_part_is_one_sentence():
    assert_one_sentence(run_cli("test-anywhere", "--only", "nowhere"), "nowhere", "packages")


def test_make_passes_the_part_on():
    assert "fixel/launcher.py make test-anywhere" in dry_run("test-anywhere", "ONLY=packages").stdout
