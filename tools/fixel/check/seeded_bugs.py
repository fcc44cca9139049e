# SPDX-License-Identifier: MIT
"""Tests the tests: puts one known bug after the other into a copy of the library.

    fixel seeded-bugs [--build DIR] [--only WORD | --sample N]

Each entry of host_tests/breaks with tests must make a test fail; without a
bug none may. --sample tries N bugs, chosen by what the library and its tests
hold, so that the same sources give the same sample and other sources another.
Works on copies under DIR/seeded_bugs and never in the checkout.
Exit: 0 all caught, 1 a bug survived or does not compile (or a test fails without one), 2 could not run.
"""

import argparse
import dataclasses
import json
import os
import pathlib
import shutil
import subprocess
import sys

from fixel.base import children, limits, sampling
from fixel.base.errors import ToolError
from fixel.base.table import coloured, table
from fixel.board import unit_tests
from fixel.check import planting

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
# What make needs to build the library's tests.
COPIED = ("Makefile", "lib", "boards", "firmware", "linker", "bench", "host_tests", "scenes")
# What make has built of them in the checkout, which it need not build again.
COPIED_BUILT = ("host/unit", "equality", "bench/m0", "bench/m3", "core/*/lib", "core/runners", "core/cpu-cortex-m3_float-abi-soft_no-unaligned-access/unit",
                "boards/mps2-an385/boards", "boards/mps2-an385/unit",
                "boards/host/boards", "boards/host/firmware", "boards/host/walk", "host/objects", "host/walk", "host/*.a", "host/judge", "host/raycast",
                "lib_needs.mk", "lib_conditions*")
# What make finds in all sources of the library, in two seconds: a bug in a line changes nothing of it.
FOUND = ("build/lib_needs.mk", "build/lib_conditions.mk")
TEST_CPU = 120          # seconds of CPU time; a bug that never ends is caught too
# A core's kernels against the portable ones, on the emulated core: with so many thousand inputs.
EQUALITY = ("equality/m0", "equality/m3", "equality/m55", "equality/m3-small", "equality/m3-os")
EQUALITY_THOUSANDS = 20
# Those that bugs name of the unit tests on a board with the kernels of Armv7-M.
ON_M3 = ("m3/test_smooth_bands",)
M3_UNITS = "build/boards/mps2-an385/unit/units.json"
# Those that bugs name of UNIT_BARE in host_tests/unit/unit.mk.
BARE = ("test_pick_methods_bare",)
# Frames that the host draws and the reference renderer judges, as make run does: "run/SCENE", "run/SCENE/PIXELS".
RUNS = ("run/room", "run/gallery", "run/gallery/rgb565", "run/grove", "run/landscape", "run/car/rgb565", "run/clamped",
        "run/colours/rgb565")
RUN_FRAMES = 4          # the last one is drawn as two rectangles
RUN_PROGRAMS = ("build/boards/host/walk", "build/host/judge", "build/host/raycast")
RUN_SCENES = ("scenes/{}.toml", "host_tests/breaks/scenes/{}.toml", "host_tests/breaks/scenes/{}.ply")


@dataclasses.dataclass
class Verdict:
    """Which test failed with a bug, and its first words; None where the bug survived, or, with the
    words of the compiler, where it does not compile, so that it shows nothing."""
    bug: planting.Break
    caught_by: str | None
    words: str = ""


# --- a copy, built and run -----------------------------------------------------

def all_tests(root):
    """Names of the library's Unity programs, of the comparisons of kernels, and of the runs that are judged."""
    return sorted(file.stem for file in (pathlib.Path(root) / "host_tests/unit").glob("test_*.c")) + [*BARE, *ON_M3, *EQUALITY, *RUNS]


def target(test):
    """The program of a test, as make knows it; of a run the one that draws."""
    if test in RUNS:
        return RUN_PROGRAMS[0]
    if test in ON_M3:
        return M3_UNITS
    return f"build/{test}.elf" if test in EQUALITY else f"build/host/unit/{test}"


def make_copy(root, folder):
    """What make needs, alone in a folder."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name in COPIED:
        source = pathlib.Path(root) / name
        if source.is_dir():
            shutil.copytree(source, folder / name, ignore=shutil.ignore_patterns("corpus"))
        else:
            shutil.copy2(source, folder / name)
    built = pathlib.Path(root) / "build"
    for source in (source for pattern in COPIED_BUILT for source in built.glob(pattern)):
        # with their times, by which make sees what is new enough
        copied = folder / "build" / source.relative_to(built)
        if source.is_dir():
            shutil.copytree(source, copied)
        else:
            copied.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(source, copied)


def build_targets(folder, targets, jobs):
    """Builds files in a copy, by their names for make; what the compiler said, or None if all went well."""
    environment = {name: value for name, value in os.environ.items()
                   if name not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL", "MAKEOVERRIDES")}
    kept = [word for name in FOUND if (folder / name).exists() for word in ("-o", name)]
    done = children.run(["make", "-s", f"-j{jobs}", f"PY={sys.executable}", *kept, *targets],
                        cwd=folder, stderr=subprocess.STDOUT, text=True, errors="replace", env=environment)
    return done.stdout if done.returncode else None


def build_tests(folder, tests, jobs):
    """The same of tests."""
    judges = RUN_PROGRAMS[1:] if any(test in RUNS for test in tests) else ()
    return build_targets(folder, [*map(target, tests), *judges], jobs)


def judge_run(folder, test):
    """run_test of a scene that the host draws."""
    _, name, *pixels = test.split("/")
    scene = next(file for file in (folder / pattern.format(name) for pattern in RUN_SCENES) if file.exists())
    out = folder / "build" / "judged"
    shutil.rmtree(out, ignore_errors=True)
    command = [sys.executable, str(CHECKOUT / "tools/fixel/launcher.py"), "run", "--board", "host", "--scene", str(scene),
               "--frames", str(RUN_FRAMES), "--build", str(folder / "build"), "--out", str(out), "--fresh"]
    try:
        done = limits.run(command + [word for each in pixels for word in ("--pixels", each)], TEST_CPU, merge=True, text=True, cwd=folder)
    except limits.LimitError as error:
        return str(error)
    if done.returncode == 0:
        return None
    if not (out / "summary.json").exists():
        return f"ended with {done.returncode}"
    summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
    return f"{summary['pixels_unexplained']} of {summary['pixels']} pixels are unexplained"


def run_on_m3(folder, name):
    """run_test of a unit test on the board."""
    units = folder / M3_UNITS
    programs = json.loads(units.read_text(encoding="utf-8"))["programs"]
    elf = next(units.parent / program for program, names in programs.items() if name in names)
    [file] = unit_tests.run(elf, [name], every=False)
    return next((line for line in file.output.splitlines() if ":FAIL" in line), "failed") if file.failed else None


def run_test(folder, test):
    """None if the program passes, else its first words of failure."""
    if test in RUNS:
        return judge_run(folder, test)
    if test in ON_M3:
        return run_on_m3(folder, test.removeprefix("m3/"))
    if test in EQUALITY:
        from fixel.check import equality     # it needs packages, and whoever reads the options needs none
        return equality.first_difference(folder / target(test), EQUALITY_THOUSANDS, TEST_CPU)
    try:
        done = limits.run([str(folder / target(test))], TEST_CPU, merge=True, text=True, cwd=folder)
    except limits.LimitError as error:
        return str(error)
    if done.returncode == 0:
        return None
    lines = done.stdout.splitlines()
    return next((line for line in lines if ":FAIL" in line or "runtime error" in line),
                f"ended with {done.returncode}")


def try_bug(folder, bug, tests, jobs):
    """Seeds a bug in a copy, runs tests until one fails, takes the bug out again."""
    with planting.planted(folder, [bug]):
        likely = [test for test in bug.tests if test in tests]
        for group in (likely, [test for test in tests if test not in likely]):
            said = build_tests(folder, group, jobs) if group else None
            if said:
                return Verdict(bug, None, said)
            for test in group:
                words = run_test(folder, test)
                if words:
                    return Verdict(bug, test, words)
        return Verdict(bug, None)


# --- all together ----------------------------------------------------------------

def check_unharmed(folder, tests, jobs):
    """Builds everything that the bugs need, and demands that it passes as it is."""
    said = build_tests(folder, tests, jobs)
    if said:
        raise ToolError("the library's tests do not build", words=said)
    for test in tests:
        words = run_test(folder, test)
        if words:
            raise ToolError(f"{test} fails without a seeded bug: {words}", exit_code=1)


def print_verdicts(verdicts):
    """For people."""
    rows = [[verdict.bug.id, verdict.bug.kind,
             verdict.caught_by or coloured("NOT COMPILED" if verdict.words else "SURVIVED", "red")]
            for verdict in verdicts]
    print(table(rows, ["bug", "kind", "caught by"]))
    for verdict in verdicts:
        if verdict.caught_by is None:
            print(f"{verdict.bug.file}: bug '{verdict.bug.id}' does not compile, so it shows nothing: {verdict.words}"
                  if verdict.words else f"{verdict.bug.file}: no test sees: {verdict.bug.why}")
    caught = sum(verdict.caught_by is not None for verdict in verdicts)
    print(f"{caught} of {len(verdicts)} bugs caught")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--build", default="build", help="the build folder")
    made.add_argument("--root", default=str(CHECKOUT), help="the checkout to copy from")
    made.add_argument("--only", default="", help="only bugs with this in their id, kind or file")
    made.add_argument("--sample", type=int, default=0, help="so many of the bugs (all)")
    made.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    return made


def before(options):
    """The bugs that are asked for; refuses a word that none has."""
    bugs = [bug for bug in planting.seeded(options.root) if bug.is_called(options.only)]
    if not bugs:
        raise ToolError(f"no bug has '{options.only}' in its id, kind or file")
    return bugs


def main(argv):
    options = parser().parse_args(argv)
    bugs = before(options)
    if options.sample:
        bugs = sampling.choose(options.root, "seeded bugs", bugs, options.sample)
    tests = all_tests(options.root)
    unknown = {test for bug in bugs for test in bug.tests} - set(tests)
    if unknown:
        raise ToolError(f"{planting.FOLDER}: there is no {', '.join(sorted(unknown))}")
    scratch = pathlib.Path(options.build).resolve() / "seeded_bugs"
    copies = [scratch / str(number) for number in range(max(1, min(options.jobs, len(bugs))))]
    print("seeded bugs: building the tests as they are", file=sys.stderr, flush=True)
    make_copy(options.root, copies[0])
    check_unharmed(copies[0], sorted({test for bug in bugs for test in bug.tests}), options.jobs)
    for folder in copies[1:]:
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(copies[0], folder)
    verdicts = planting.try_all("seeded bugs", bugs, copies, lambda folder, bug: try_bug(folder, bug, tests, 1))
    print_verdicts(verdicts)
    return 1 if any(verdict.caught_by is None for verdict in verdicts) else 0
