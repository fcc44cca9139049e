# SPDX-License-Identifier: MIT
"""Runs the tests of host_tests/anywhere: Fixel outside its checkout, in packages and on machines that make test has no tools for.

A part is a folder there; ONLY= names one, or a file as packages/test_cmake. Each file prints a line when it runs and one when it
is done. What a test needs and this machine lacks is told as "not run: needs ...", and counts as skipped, never as passed.
Exit: 0 nothing failed, 1 a test failed, 2 there is no such part.
"""

import argparse
import pathlib
import re
import sys
import xml.etree.ElementTree

from fixel.base import children, limits, output, scratch
from fixel.base.errors import ToolError
from fixel.base.nearest import question

ROOT = pathlib.Path(__file__).resolve().parents[3]
FOLDER = ROOT / "host_tests" / "anywhere"
CPU = 1200.0        # seconds of CPU time for one file
NO_TESTS = 5        # how pytest ends then
NEEDS = "needs "    # how the reason of a test begins that this machine cannot run


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--only", default="", metavar="PART", help="a folder of host_tests/anywhere, or a file of one")
    made.add_argument("--json", help="write the result of each file")
    return made


def before(options):
    """Refuses a name that no part has."""
    chosen(options.only, files())


def files(folder=FOLDER):
    """{"part/test_name": file}."""
    return {f"{file.parent.name}/{file.stem}": file for file in sorted(folder.glob("*/test_*.py"))}


def chosen(only, found):
    """Those that --only names."""
    parts = {name.split("/")[0] for name in found}
    if only and only not in parts | set(found):
        raise ToolError(f"there is no part '{only}'{question(only, sorted(parts | set(found)))}; there are: {', '.join(sorted(parts))}")
    return {name: file for name, file in found.items() if only in ("", name, name.split("/")[0])}


def run_file(file, folder):
    """(exit code, what pytest said, its report) of one file."""
    report = folder / "report.xml"
    command = [sys.executable, "-m", "pytest", str(file), "-q", "--tb=long", "--color=no", "-p", "no:cacheprovider",
               f"--junitxml={report}", f"--basetemp={folder}/tmp"]
    try:
        done = limits.run(command, CPU, merge=True, text=True, cwd=ROOT)
    except limits.LimitError as error:
        return 1, str(error), None
    return done.returncode, done.stdout, report


def _reason(skipped):
    """Why a test, or all of a file, was skipped: of a whole file the report has it in its text alone."""
    found = re.search(r"Skipped: (.*)['\"]\)$", (skipped.text or "").strip())
    return found[1] if skipped.get("message") == "collection skipped" and found else skipped.get("message", "")


def outcome(code, report):
    """{"passed", "failed": how many tests, "needs": the reasons of those that were not run, "figures": what tests have measured}."""
    try:
        cases = list(xml.etree.ElementTree.parse(report).getroot().iter("testcase"))
    except (OSError, TypeError, xml.etree.ElementTree.ParseError):
        return {"passed": 0, "failed": 1, "needs": [], "figures": []}
    skipped = [_reason(case.find("skipped")) for case in cases if case.find("skipped") is not None]
    failed = sum(case.find("failure") is not None or case.find("error") is not None for case in cases)
    strange = [reason for reason in skipped if not reason.startswith(NEEDS)]
    failed += len(strange)      # a test that is skipped for another reason hides something
    passed = len(cases) - len(skipped) - failed + len(strange)
    if code not in (0, NO_TESTS) and not failed:
        failed = 1
    figures = [each.get("value") for case in cases for each in case.iter("property") if each.get("name") == "figure"]
    return {"passed": passed, "failed": failed, "needs": [reason for reason in skipped if reason.startswith(NEEDS)], "figures": figures}


def line(name, found):
    """What a file's outcome is, as a line."""
    words = []
    if found["failed"]:
        words.append(f"FAILED: {found['failed']} of {found['failed'] + found['passed'] + len(found['needs'])} tests")
    elif found["passed"]:
        words.append(f"passed: {found['passed']} tests")
    for reason in dict.fromkeys(found["needs"]):
        words.append(f"not run: {reason} ({found['needs'].count(reason)} tests)")
    return f"{name}: {'; '.join(words) or 'not run: needs a test'}"


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    wanted, results = chosen(options.only, files()), {}
    setup = children.run(["tools/setup.sh", "anywhere"], cwd=ROOT, stdout=None, stderr=None)
    if setup.returncode:
        print("set-up could not install everything; what lacks a tool is not run", flush=True)
    with scratch.folder("anywhere") as folder:
        for name, file in wanted.items():
            print(f"{name}: run", flush=True)
            code, said, report = run_file(file, folder)
            results[name] = outcome(code, report)
            if results[name]["failed"]:
                print(said, flush=True)
            print(line(name, results[name]), flush=True)
    if options.json:
        output.write_json(options.json, results)
    print()
    for name, found in results.items():
        print("\n".join([line(name, found), *(f"    {figure}" for figure in found["figures"])]))
    passed, failed = (sum(found[what] for found in results.values()) for what in ("passed", "failed"))
    print(f"{passed} passed, {failed} failed, {sum(len(found['needs']) for found in results.values())} skipped")
    return 1 if failed else 0
