#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Links a board's unit tests: few programs, each with as many files of tests as fit the board.

Sizes of objects propose which files share a program, and the linker decides: where it says that a region overflows,
the program is cut in two, and a file that does not fit even alone is left out. units.json in the folder of the
programs names both:

    {"programs": {"units-01.elf": ["test_a", ...], ...}, "left_out": {"test_b": "RAM overflowed by 952 bytes", ...}}
"""

import argparse
import collections
import dataclasses
import json
import pathlib
import re
import subprocess
import sys

ENTRY = "unittest_entry_"
OVERFLOW = re.compile(r"region `(\w+)' overflowed by (\d+) bytes")
REGION = re.compile(r"^\s*(FLASH|RAM):\s+(\d+) (.?B)\s+(\d+) (.?B)", re.MULTILINE)
BYTES = {"B": 1, "KB": 1 << 10, "MB": 1 << 20, "GB": 1 << 30}
ENOUGH_STACK = 16 << 10     # for any file of tests
OTHER_RAM = 4 << 10         # handlers' stack, heap and the data of the parts of the board, at most


@dataclasses.dataclass(frozen=True)
class Object:
    """A member of an archive: its bytes in flash and in RAM, the symbols that it defines and those that it wants."""
    flash: int
    ram: int
    defines: frozenset
    wants: frozenset


def run(command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def read_archive(file, cross):
    """{name: Object} of an archive's members."""
    defines, wants = collections.defaultdict(set), collections.defaultdict(set)
    for line in run([f"{cross}nm", "-A", "-P", file]).splitlines():
        place, symbol, kind, *_ = line.split()
        name = re.search(r"\[(.+)\]:?$", place)[1]
        if kind == "U":
            wants[name].add(symbol)
        elif kind.isupper():
            defines[name].add(symbol)
    found = {}
    for line in run([f"{cross}size", file]).splitlines()[1:]:
        text, data, bss, _, _, name, *_ = line.split()
        found[name] = Object(int(text) + int(data), int(data) + int(bss), frozenset(defines[name]),
                             frozenset(wants[name]))
    return found


class Sizes:
    """What each file of tests takes, with what it links of the archives."""

    def __init__(self, tests, archives, cross):
        self.objects = {}
        for file in (tests, *archives):
            self.objects.update(read_archive(file, cross))
        self.owner = {symbol: name for name, each in self.objects.items() for symbol in each.defines}
        self.needs = {name.removesuffix(".o"): self._closure(name) for name in read_archive(tests, cross)}

    def _closure(self, name):
        found, left = set(), [name]
        while left:
            name = left.pop()
            if name not in found:
                found.add(name)
                left += [self.owner[symbol] for symbol in self.objects[name].wants if symbol in self.owner]
        return frozenset(found)

    def flash(self, tests):
        return self._sum(tests, "flash")

    def ram(self, tests):
        return self._sum(tests, "ram")

    def _sum(self, tests, what):
        return sum(getattr(self.objects[name], what) for name in frozenset().union(*(self.needs[test] for test in tests)))


class Linker:
    """Links programs, and knows how large the board's regions are."""

    def __init__(self, command, folder):
        self.command, self.folder = command, folder
        self.room = {}

    def link(self, tests, file):
        """None, or why the tests do not fit."""
        entries = [f"-Wl,-u,{ENTRY}{test}" for test in tests]
        done = subprocess.run([*self.command, *entries, "-Wl,--print-memory-usage", "-o", str(self.folder / file)],
                              capture_output=True, text=True, check=False)
        text = done.stdout + done.stderr
        self.room = {name: (int(used) * BYTES[used_unit], int(size) * BYTES[unit])
                     for name, used, used_unit, size, unit in REGION.findall(text)}
        if done.returncode == 0:
            return None
        over = OVERFLOW.findall(text)
        if not over:
            sys.exit(f"error: {file} with {', '.join(tests)} cannot be linked:\n{text}")
        return ", ".join(f"{region} overflowed by {size} bytes" for region, size in over)


def propose(sizes, flash, ram):
    """Lists of files that share a program. flash: what there is for the objects that Sizes knows. ram: all of it.
    Each file gets all the stack that a program of tests can have, or nearly as much as alone."""
    groups = []
    for test in sorted(sizes.needs, key=lambda test: (sizes.ram([test]), test)):
        for group in groups:
            together = [*group, test]
            taken = sizes.ram(together)
            if sizes.flash(together) <= flash and \
                    (taken <= ram - ENOUGH_STACK - OTHER_RAM or taken - sizes.ram(group[:1]) <= ram // 8):
                group.append(test)
                break
        else:
            groups.append([test])
    return groups


def link_all(linker, groups):
    """The programs that were linked, and what was left out."""
    programs, left_out = {}, {}
    left = collections.deque(groups)
    while left:
        tests = left.popleft()
        file = f"units-{len(programs) + 1:02}.elf"
        why = linker.link(tests, file)
        if why is None:
            programs[file] = tests
        elif len(tests) == 1:
            left_out[tests[0]] = why
        else:
            left += [tests[:len(tests) // 2], tests[len(tests) // 2:]]
    return programs, left_out


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--folder", type=pathlib.Path, required=True, help="where the programs go")
    parser.add_argument("--cross", required=True, help="prefix of the binary utilities")
    parser.add_argument("--tests", required=True, help="archive of the tests, an object for each file of tests")
    parser.add_argument("--archives", nargs="+", required=True, help="archives of what the tests call")
    parser.add_argument("command", nargs="+", help="how to link, without the tests' names and the output")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    for old in options.folder.glob("units-*.elf"):
        old.unlink()
    sizes = Sizes(options.tests, options.archives, options.cross)
    linker = Linker(options.command, options.folder)
    least = min(sizes.needs, key=lambda test: (sizes.ram([test]), sizes.flash([test])))
    linker.link([least], "units-01.elf")
    if set(linker.room) != {"FLASH", "RAM"}:
        sys.exit("error: the linker did not say how large the regions FLASH and RAM are")
    (flash_used, flash), (_, ram) = linker.room["FLASH"], linker.room["RAM"]
    groups = propose(sizes, flash - max(0, flash_used - sizes.flash([least])), ram)
    programs, left_out = link_all(linker, groups)
    (options.folder / "units.json").write_text(json.dumps({"programs": programs, "left_out": left_out}, indent=1) + "\n",
                                               encoding="utf-8")


if __name__ == "__main__":
    main()
