# SPDX-License-Identifier: MIT
"""Says what of the library its tests reach: lines, branches and conditions of each room of lib/.

    fixel coverage --library libfixel-coverage.so --tests PROGRAM... [--replay PROGRAM CORPUS]... [--reasons FILE] --out coverage.json

The library is built by Clang with counters (host_tests/unit/unit_coverage.mk). Runs the unit tests of the host and the
replays of the fuzzer's corpus. With --reasons each branch and each condition must be reached, or stand in that file with a
proof or a reason. The JSON file has every file of lib/, and what nothing reaches with its reason.
A condition is reached where two tests show that it alone decides (MC/DC): the decision's value changes with it while the other
conditions stay or do not matter. A decision of one condition has none: its branches say the same. A gap is named by its file, its
function and its text, so it stays the same where lines move.
Exit: 0 done, 1 a test failed, or a branch or a condition is neither reached nor has a reason; 2 could not run.
"""

import argparse
import collections
import concurrent.futures
import dataclasses
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib

from fixel.base import children, output, scratch
from fixel.base.errors import ToolError
from fixel.base.progress import Progress
from fixel.base.table import table
from fixel.check import corpus

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
KINDS = ("lines", "branches", "conditions")
# Of what llvm-cov show prints. The views of a header's functions, one for each file that includes it, stand further right.
SOURCE = re.compile(r"(?:  \|)* *(?P<line>\d+)\|(?P<count>[^|]*)\|")
BRANCH = re.compile(r"(?:  \|)+  Branch \((?P<line>\d+):(?P<column>\d+)\): \[True: (?P<true>[^,]+), False: (?P<false>[^\]]+)\]")
DECISION = re.compile(r"(?:  \|)+---> MC/DC Decision Region")
CONDITION = re.compile(r"(?:  \|)+     Condition C\d+ --> \((?P<line>\d+):(?P<column>\d+)\)")
PAIR = re.compile(r"(?:  \|)+  C(?P<number>\d+)-Pair: (?P<how>.*)")
FUNCTION = re.compile(r"#define (?P<macro>\w+)|(?!typedef)(?:[A-Za-z_][\w *]*[ *])?(?P<name>[A-Za-z_]\w*)\(")
ATTRIBUTE = re.compile(r"__attribute__\(\(\w+\)\) ?")
WORDS = 2000    # the last characters of what a program said
LEVELS = 3      # of a path: lib/include/fixel
LINES = 6       # at most, of a condition
SIDES = ("true", "false", "alone")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--root", default=str(CHECKOUT), help="the checkout that the library was built in")
    made.add_argument("--library", required=True, help="the library with counters, a shared object")
    made.add_argument("--tests", nargs="+", required=True, help="unit tests that load it")
    made.add_argument("--replay", nargs=2, action="append", default=[], metavar=("PROGRAM", "CORPUS"),
                      help="a program that replays a corpus, and the corpus's archive")
    made.add_argument("--reasons", help="the file of what cannot be reached, and why; without it nothing is compared")
    made.add_argument("--version", default="19", help="of LLVM's tools (default: 19)")
    made.add_argument("--out", required=True, help="the JSON file")
    made.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    return made


def compare(files, stated, path):
    """Says what has a reason, and what has none or no longer needs one. Whether nothing has to be done."""
    reasons = with_reasons(files, stated)
    new, gone = sentences(files, stated)
    print(f"with a proof or a reason in {path}: {reasons['branches']} branches, {reasons['conditions']} conditions; "
          f"without one: {len(new)} places")
    if new:
        print("not reached, and without a reason. Write a test; or a reason, if no test can reach it:\n"
              + "".join(f"  {line}\n" for line in new), file=sys.stderr)
    if gone:
        print(f"reached by now, or gone. Take these out of {path}:\n" + "".join(f"  {line}\n" for line in gone), file=sys.stderr)
    return not new and not gone


def main(argv):
    options = parser().parse_args(argv)
    if shutil.which(f"llvm-cov-{options.version}") is None:
        raise ToolError(f"not run: needs clang {options.version} and its llvm tools")
    root = pathlib.Path(options.root).resolve()
    stated = read(root / options.reasons) if options.reasons else {}
    programs = [[test] for test in options.tests]
    library = pathlib.Path(options.library).resolve()
    with scratch.folder("coverage", library.parent) as folder, scratch.folder("corpus") as inputs:
        programs += [[program, *corpus.unpack(corpus.read(archive), inputs)] for program, archive in options.replay]
        counts, failed = run_programs(programs, folder.resolve(), options.jobs)
        files = measured(library, counts, options.version, root)
    rooms = by_room(files)
    listed = {name: {kind: counted[kind] for kind in KINDS} for name, counted in files.items()}
    output.write_json(options.out, {"rooms": rooms, "files": listed, "open": as_rows(files, stated)})
    print(table(rows(rooms), ["room", *KINDS]))
    for name, words in failed.items():
        print(f"{name} failed, so what it reaches may be more:\n{words}", file=sys.stderr)
    is_covered = compare(files, stated, options.reasons) if options.reasons else True
    print(options.out)
    return 0 if is_covered and not failed else 1


def run_programs(programs, folder, jobs):
    """Runs [program, arguments...] each: (files of counts in the folder, {name of a program that failed: its words})."""
    def run(job):
        number, command = job
        counts = folder / f"{number}.profraw"
        done = children.run([str(word) for word in command], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True, errors="replace",
                            env={**os.environ, "LLVM_PROFILE_FILE": str(counts)})
        return counts, done.stdout[-WORDS:] if done.returncode else None

    with Progress("programs", len(programs)) as progress, concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        found = []
        for result in pool.map(run, enumerate(programs)):
            found.append(result)
            progress(len(found))
    failed = {pathlib.Path(command[0]).name: words for command, (_, words) in zip(programs, found) if words is not None}
    return [counts for counts, _ in found if counts.exists()], failed


def call(tool, *words):
    done = children.run([tool, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        raise ToolError(f"{tool} fails", 1, done.stderr[-WORDS:])
    return done.stdout


def measured(library, counts, version, checkout):
    """{file of lib/: {kind: [reached, all], "open": [Gap, ...]}}, after the programs that wrote these counts."""
    merged = library.with_name("coverage.profdata")
    listed = library.with_name("counts.txt")
    listed.write_text("".join(f"{file}\n" for file in counts), encoding="utf-8")
    call(f"llvm-profdata-{version}", "merge", "-sparse", "-f", listed, "-o", merged)
    shown = call(f"llvm-cov-{version}", "show", "-show-branches=count", "-show-mcdc", "-show-regions=false", "-use-color=false",
                 f"-instr-profile={merged}", library)
    return {name: found.result() for name, found in sorted(views(shown, checkout).items())}


@dataclasses.dataclass(frozen=True)
class Gap:
    """What no test reaches of a condition. function, condition: text of the source, by which a reason finds it again."""
    line: int
    function: str
    condition: str
    open: tuple     # of "true", "false", "alone"


class File:
    """What the views of a file say. A function of a header has a view for each file that has it: what one of them reaches is
    reached."""

    def __init__(self, text):
        self.text = text
        self.lines = collections.defaultdict(bool)          # {line: reached}
        self.branches = {}                                  # {(line, column): [was true, was false]}
        self.conditions = collections.defaultdict(bool)     # {(line, column): decided alone}

    def result(self):
        """{kind: [reached, all], "open": [Gap, ...]}."""
        sides = [side for both in self.branches.values() for side in both]
        return {"lines": [sum(self.lines.values()), len(self.lines)], "branches": [sum(sides), len(sides)],
                "conditions": [sum(self.conditions.values()), len(self.conditions)], "open": self.gaps()}

    def gaps(self):
        """The conditions of which something is open. A text that a function has twice gets a number."""
        found, seen = [], collections.Counter()
        for place in sorted({*self.branches, *self.conditions}):
            function, condition = function_of(self.text, place[0]), condition_at(self.text, *place)
            seen[function, condition] += 1
            if seen[function, condition] > 1:
                condition += f" #{seen[function, condition]}"
            was_true, was_false = self.branches.get(place, (True, True))
            sides = (("true", was_true), ("false", was_false), ("alone", self.conditions.get(place, True)))
            left = tuple(side for side, reached in sides if not reached)
            if left:
                found.append(Gap(place[0], function, condition, left))
        return found


def views(shown, checkout):
    """{name: File} of lib/, from what llvm-cov show prints."""
    files, file, places = {}, None, []
    for line in shown.splitlines():
        if line.startswith("/") and line.endswith(":"):
            name = os.path.relpath(line[:-1], checkout)
            file = File((checkout / name).read_text(encoding="utf-8").splitlines()) if name.startswith("lib/") else None
            if file:
                files[name] = file
        elif file and (found := SOURCE.match(line)):
            if found["count"].strip():
                file.lines[int(found["line"])] |= found["count"].strip() != "0"
        elif file and (found := BRANCH.match(line)):
            both = file.branches.setdefault((int(found["line"]), int(found["column"])), [False, False])
            both[:] = [both[0] or found["true"] != "0", both[1] or found["false"] != "0"]
        elif DECISION.match(line):
            places = []
        elif found := CONDITION.match(line):
            places.append((int(found["line"]), int(found["column"])))
        elif file and (found := PAIR.match(line)) and found["how"] != "constant folded":
            file.conditions[places[int(found["number"]) - 1]] |= found["how"].startswith("covered")
    return files


def function_of(text, line):
    """The function, or the macro, that has a line: each begins in column 0."""
    for above in range(line - 1, -1, -1):
        found = FUNCTION.match(ATTRIBUTE.sub("", text[above]))
        if found and not text[above].endswith(";"):
            return found["macro"] or found["name"]
    return ""


def condition_at(text, line, column):
    """The text of the condition that begins there, up to the end of its operand."""
    rest, depth = " ".join([text[line - 1][column - 1:], *text[line:line + LINES]]), 0
    for place, character in enumerate(rest):
        if depth == 0 and (character in ";?{:)" or rest[place:place + 2] in ("&&", "||")):
            rest = rest[:place]
            break
        depth += (character in "([") - (character in ")]")
    return " ".join(rest.replace("\\", "").split())


def by_room(files):
    """{room of lib/: {kind: [reached, all]}}, and "all together"."""
    rooms = collections.defaultdict(lambda: {kind: [0, 0] for kind in KINDS})
    for name, counted in files.items():
        for room in ("/".join(name.split("/")[:-1][:LEVELS]), "all together"):
            for kind in KINDS:
                rooms[room][kind] = [a + b for a, b in zip(rooms[room][kind], counted[kind])]
    together = rooms.pop("all together", None)
    return {**dict(sorted(rooms.items())), **({"all together": together} if together else {})}


def percent(reached, every):
    return 100 * reached / every if every else None


def rows(rooms):
    """Rows of the table: for each room reached, all and per cent of each kind."""
    return [[room, *(f"{reached:,} of {every:,}" + (f"  {percent(reached, every):5.1f} %" if every else "")
                     for reached, every in counted.values())] for room, counted in rooms.items()]


def read(path):
    """{(file, function, condition): (the sides that are stated, the reason)}."""
    stated = {}
    for number, entry in enumerate(tomllib.loads(path.read_text(encoding="utf-8")).get("reason", []), 1):
        if entry.keys() != {"why", "gaps"} or not entry["why"].strip():
            raise ToolError(f"{path.name}: reason {number} needs why and gaps, and nothing else")
        for line in entry["gaps"]:
            key, sides = parsed(line, path.name)
            if key in stated:
                raise ToolError(f'{path.name}: "{" | ".join(key)}" stands there twice')
            stated[key] = (sides, entry["why"].strip())
    return stated


def parsed(line, name):
    """((file, function, condition), sides) of a line. A condition may have a | of its own."""
    parts = line.split(" | ", 2)
    parts[2:] = parts[2].rsplit(" | ", 1) if len(parts) == 3 else []
    sides = tuple(parts[-1].split())
    if len(parts) != 4 or not sides or not set(sides) <= set(SIDES):
        raise ToolError(f'{name}: a gap is "file | function | condition | {" ".join(SIDES)}", not "{line}"')
    return tuple(parts[:3]), sides


def found(files):
    """{(file, function, condition): Gap} of what was measured."""
    return {(name, gap.function, gap.condition): gap for name, counted in files.items() for gap in counted["open"]}


def sentences(files, stated):
    """(what is open without a reason, what has a reason and is not open), as lines with places."""
    measured = found(files)
    new, gone = [], []
    for key, gap in measured.items():
        left = [side for side in gap.open if side not in stated.get(key, ((), ""))[0]]
        if left:
            new.append(f"{key[0]}:{gap.line}: {' | '.join(key)} | {' '.join(left)}")
    for key, (sides, _) in stated.items():
        left = [side for side in sides if key not in measured or side not in measured[key].open]
        if left:
            gone.append(f"{' | '.join(key)} | {' '.join(left)}")
    return new, gone


def with_reasons(files, stated):
    """{kind: how many have a reason}: branches and conditions that are open and have one."""
    counted = collections.Counter()
    for key, gap in found(files).items():
        for side in set(gap.open) & set(stated.get(key, ((), ""))[0]):
            counted["conditions" if side == "alone" else "branches"] += 1
    return counted


def as_rows(files, stated):
    """The gaps as JSON has them."""
    return [{"file": key[0], "line": gap.line, "function": key[1], "condition": key[2], "open": list(gap.open),
             "why": stated.get(key, ((), None))[1]} for key, gap in found(files).items()]
