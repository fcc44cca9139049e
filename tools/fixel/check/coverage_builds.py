# SPDX-License-Identifier: MIT
"""Says what of the library's builds for other cores runs: instructions of each file of assembly, lines of C in each room of lib/.

    fixel coverage-builds --of BUILD PROGRAM... [--of ...] --out coverage_builds.json

A PROGRAM is a units.json, all of whose programs of unit tests run, or a program of make equality. They run on the emulated core, where
the counting plugin (bench/plugin) says which code was executed; the line tables of the programs say what it was compiled from. Of
C a line is reached if an instruction of it was executed in one place, of assembly each instruction counts, as macros make many of
one line. An instruction that its condition skips is executed. What is in no program of a build does not count, and what the linker left out does.
What of assembly no build of its file reaches is printed with its line.
Exit: 0 done, 1 a program failed; 2 could not run.
"""

import argparse
import bisect
import collections
import concurrent.futures
import os
import pathlib

from fixel.base import output, scratch
from fixel.base.errors import ToolError
from fixel.base.progress import Progress
from fixel.base.table import table
from fixel.check.coverage import percent
from fixel.commands import late

elffile = late("elftools.elf.elffile")
counter, machine_code = late("fixel.bench", "counter machine_code")
emulator, endings, qemu, unit_tests = late("fixel.board", "emulator execute qemu unit_tests")

PORTABLE = "portable/"      # firmware/equality/equality.mk puts it before the names of the portable side's files
NEVER = 0xFFFFFFFF          # an address without code
CPU = 3600.0                # seconds for a program
NOPS = (0xBF00, 0x46C0)     # what fills up to an aligned address


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--of", nargs="+", action="append", required=True, metavar=("BUILD", "PROGRAM"),
                      help="a build of the library, and programs that have it: units.json, or programs of make equality")
    made.add_argument("--plugin", required=True, help="the counting plugin")
    made.add_argument("--out", required=True, help="the JSON file")
    made.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    return made


# --- what ran ------------------------------------------------------------------

def execute(elf, code, plugin, words, folder):
    """(the ending of a run with these words, the addresses that it executed)."""
    folder.mkdir()
    (folder / counter.MAP).write_text(f"begin {code.symbol('main'):x}\nend {NEVER:x}\n", encoding="ascii")
    ending = emulator.run_text(elf, words, CPU, icount=False, extra=[
        "-plugin", f"{qemu.escape(pathlib.Path(plugin).resolve())},map={qemu.escape(folder / counter.MAP)},"
                   f"out={qemu.escape(folder / counter.COUNTS)},detail=on"])
    return ending, set(counter.by_address(counter.parse((folder / counter.COUNTS).read_text(encoding="ascii"))))


def run(elf, code, plugin, is_unit, folder):
    """The addresses that a program executed. One of unit tests whose stack has no room for a file of tests runs on behind it."""
    folder.mkdir()
    words, reached = ["unittest"] if is_unit else ["equality", "frames=1"], set()
    for number in range(1000):
        ending, executed = execute(elf, code, plugin, words, folder / str(number))
        reached |= executed
        begun = unit_tests.BEGUN.findall(ending.output)
        if ending.code == endings.exit_code("DONE"):
            return reached
        if ending.code != endings.exit_code("STACK") or not begun:
            break
        words = ["unittest", f"after={begun[-1]}"]
    raise ToolError(f"{elf}: {endings.describe(ending)}", exit_code=1, words=ending.output[-2000:])


# --- what it was compiled from ---------------------------------------------------

def sequences(lines):
    """Splits a line program's rows [(address, file, line, is the end)] into sequences, one for each section of code: rows, the end last."""
    found, rows = [], []
    for row in lines:
        rows.append(row)
        if row[3]:
            found.append(rows)
            rows = []
    return found


def line_programs(elf):
    """[[(address, file, line, is the end)]] of each unit of lib/, from a program's line table."""
    with open(elf, "rb") as file:
        dwarf, found = elffile.ELFFile(file).get_dwarf_info(), []
        for unit in dwarf.iter_CUs():
            program = dwarf.line_program_for_CU(unit)
            header = program.header
            new = header.version >= 5       # counts files and folders from 0
            folders = [b"", *header.include_directory][new:]
            names = [os.path.normpath(os.fsdecode(b"/".join(filter(None, (folders[each.dir_index], each.name)))))
                     for each in header.file_entry]
            if any(in_library(name) for name in names):
                found.append([(entry.state.address, names[entry.state.file - (not new)], entry.state.line, entry.state.end_sequence)
                              for entry in program.get_entries() if entry.state])
    return found


def in_library(name):
    return name.removeprefix(PORTABLE).startswith("lib/")


def places(units, code):
    """{place: (file, line, its address)} of what can be reached: of C, where a line has code, of assembly each instruction. A place
    is the same in each program that has the same object. units: as line_programs says. code: the addresses of instructions that
    are no filling, in order. The address of what the linker left out is None."""
    found = {}
    for unit in units:
        for number, rows in enumerate(sequences(unit)):
            start = rows[0][0]
            for (address, name, line, _), (end, *_) in zip(rows, rows[1:]):
                if end == address or not in_library(name):
                    continue
                inside = code[bisect.bisect_left(code, address):bisect.bisect_left(code, end)] if name.endswith(".S") and start else [address]
                for each in inside:
                    found[unit[0][1], number, each - start, name, line] = (name, line, each if start else None)
    return found


def instructions(code):
    """The addresses of a program's instructions that are no filling, in order."""
    return sorted(address for address, _ in code.each_instruction() if code._halfword(address) not in NOPS)


# --- the figures -----------------------------------------------------------------

def programs_of(build, paths):
    """[(build, program, whether it is one of unit tests)]."""
    found = []
    for path in paths:
        units = [each for _, each, _ in unit_tests.of_boards(argparse.Namespace(units=[(build, path)]))] if path.endswith(".json") else []
        found += [(build, each, bool(units)) for each in units or [pathlib.Path(path)]]
    return found


def measure(job, plugin, folder):
    """{(build, place): (file, line, reached)} of a program. The portable side of a program of make equality is a build of its own."""
    build, elf, is_unit = job
    code = machine_code.MachineCode(elf)
    reached = run(elf, code, plugin, is_unit, folder)
    return {("portable" if name.startswith(PORTABLE) else build, *place): (name.removeprefix(PORTABLE), line, address in reached)
            for place, (name, line, address) in places(line_programs(elf), instructions(code)).items()}


def merged(found):
    """({(build, file): {instruction or line: reached}}) of several programs: what one of them reaches is reached."""
    files = collections.defaultdict(lambda: collections.defaultdict(bool))
    for each in found:
        for (build, *place), (name, line, reached) in each.items():
            files[build, name][(*place[:3], line) if name.endswith(".S") else line] |= reached
    return files


def count(some):
    """[reached, all] of several files' places."""
    return [sum(sum(each.values()) for each in some), sum(map(len, some))]


def never(files):
    """["file:line: N instructions"] of assembly that no build of its file reaches."""
    reached, left = set(), {}
    for (build, name), some in sorted(files.items()):
        if name.endswith(".S"):
            reached |= {(name, place[-1]) for place, is_reached in some.items() if is_reached}
            for line, number in collections.Counter(place[-1] for place, is_reached in some.items() if not is_reached).items():
                left.setdefault((name, line), (number, build))
    return [f"{name}:{line}: {number} instructions of {build}" for (name, line), (number, build) in sorted(left.items())
            if (name, line) not in reached]


def rows(files):
    """[[what, figure]] of the table: assembly by its file, each build of it, then C by build and room."""
    found = []
    for name in sorted({name for _, name in files if name.endswith(".S")}):
        found += [[name, build, *_figure(count([files[build, name]]))] for build in sorted({one for one, other in files if other == name})]
    of_c = collections.defaultdict(list)
    for (build, name), some in files.items():
        if not name.endswith(".S"):
            of_c[os.path.dirname(name), build].append(some)
            of_c["all C", build].append(some)
        else:
            of_c["all assembly", build].append(some)
    return found + [[room, build, *_figure(count(some))] for (room, build), some in
                    sorted(of_c.items(), key=lambda each: (each[0][0].startswith("all "), each[0]))]


def _figure(counted):
    return f"{counted[0]:,} of {counted[1]:,}", f"{percent(*counted):5.1f} %"


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    if not pathlib.Path(options.plugin).exists():
        raise ToolError(f"{options.plugin} is not built: make coverage-builds builds it")
    jobs = [job for build, *paths in options.of for job in programs_of(build, paths)]
    with scratch.folder("coverage") as folder, Progress("programs", len(jobs)) as progress, \
            concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        found = []
        for each in pool.map(lambda job: measure(job[1], options.plugin, pathlib.Path(folder).resolve() / str(job[0])), enumerate(jobs)):
            found.append(each)
            progress(len(found))
    files = merged(found)
    left = never(files)
    output.write_json(options.out, {"files": [{"file": name, "build": build, "reached": count([some])[0], "all": len(some)}
                                              for (build, name), some in sorted(files.items())], "never": left})
    print(table(rows(files), ["instructions of assembly, lines of C", "build", "reached", ""]))
    print(f"of assembly no build reaches {len(left)} lines\n" + "".join(f"  {line}\n" for line in left) + options.out)
    return 0
