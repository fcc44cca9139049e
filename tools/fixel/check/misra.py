# SPDX-License-Identifier: MIT
"""What cppcheck's addon finds of MISRA C:2012 in lib/, what docs/safety/rules.md says of each rule, and what is on record.

The record knows a line by the hash of its text, so that it does not change where lines move.
"""

import collections
import dataclasses
import fnmatch
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess

from fixel.base import children, scratch
from fixel.base.errors import ToolError
from fixel.base.progress import Progress

VERSION = "2.10"    # of cppcheck, that of Debian 12: each version finds other lines
# One configuration: the C text of every kernel, for a core of 32 bits.
COMMAND = ("cppcheck", "--enable=style", "--addon=misra", "--std=c11", "--platform=arm32-wchar_t4", "-DFXL_PORTABLE_KERNELS=1",
           "-Ilib/include", "-Ilib", "--suppress=missingIncludeSystem", "--template={file}:{line}:{id}:{message}")
FOUND = re.compile(r"(?P<file>lib/[^:]+):(?P<line>\d+):misra-c2012-(?P<rule>\d+\.\d+):")
# cppcheck or its addon gave up on a file, or did not read it.
UNREAD = re.compile(r":(?:syntaxError|internalError|internalAstError|preprocessorErrorDirective|cppcheckError|unknownMacro|toomanyconfigs|"
                    r"noValidConfiguration|misra-config):|Bailing out|Traceback")
DONE = re.compile(r"(\d+)/(\d+) files checked")
ROW = re.compile(r"^\| (?P<rule>\d+\.\d+) \| (?P<words>[^|]+) \| (?P<decision>[^|]+) \| (?P<where>[^|]*)\|(?P<reason>[^|]*)\|$")
DECISIONS = ("kept", "mended", "deviated")
HASH = 6            # digits


@dataclasses.dataclass(frozen=True)
class Finding:
    """A line that a rule is broken in."""
    file: str
    line: int
    rule: str
    text: str


@dataclasses.dataclass(frozen=True)
class Rule:
    """What the page says of a rule. where: globs of files, () if it has no finding."""
    words: str
    decision: str
    where: tuple
    reason: str


def number(rule):
    """A rule's place in an order."""
    return tuple(map(int, rule.split(".")))


def read_page(path):
    """{rule: Rule} of the page's tables."""
    rules = {}
    for place, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if not re.match(r"\| \d+\.\d+ \|", line):
            continue
        row = ROW.match(line)
        if not row or row["decision"] not in DECISIONS:
            raise ToolError(f"{path.name}:{place}: a row is | rule | what it asks | {', '.join(DECISIONS)} | files | reason |")
        where = tuple(re.findall(r"`([^`]+)`", row["where"]))
        if row["rule"] in rules:
            raise ToolError(f"{path.name}:{place}: rule {row['rule']} stands there twice")
        if (row["decision"] == "deviated") != bool(where) or (where and not row["reason"].strip()):
            raise ToolError(f"{path.name}:{place}: a rule that is deviated from, and no other, has files and a reason")
        rules[row["rule"]] = Rule(row["words"].strip(), row["decision"], where, row["reason"].strip())
    return rules


def require_version():
    """Refuses another cppcheck than the one whose findings are on record."""
    if shutil.which(COMMAND[0]) is None:
        raise ToolError(f"not run: needs cppcheck {VERSION}, which is not there")
    said = children.run([COMMAND[0], "--version"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout.strip()
    if said != f"Cppcheck {VERSION}":
        raise ToolError(f"not run: needs cppcheck {VERSION}, as Debian 12 has it; this is {said}")


def findings(root):
    """All findings in lib/, in order. cppcheck writes beside the files that it reads, so it reads copies."""
    with scratch.folder("rules") as folder:
        copy = pathlib.Path(folder)
        shutil.copytree(root / "lib", copy / "lib")
        said, code = run(copy)
        unread = [line for line in said if UNREAD.search(line)]
        if code or unread:
            raise ToolError("cppcheck could not read all of lib/", 1, "".join(unread or said[-20:]))
        return of_words(said, copy)


def run(folder):
    """(the lines that cppcheck prints of a folder's lib/, its exit code)."""
    said = []
    process = children.start([*COMMAND, f"-j{os.cpu_count() or 1}", "lib"], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, text=True)
    with Progress("cppcheck reads lib/: files") as progress, process:
        for line in process.stdout:
            files = DONE.match(line)
            if files:
                progress(int(files[1]), int(files[2]))
            else:
                said.append(line)
    return said, process.returncode


def of_words(words, root):
    """The findings of lines that cppcheck printed."""
    lines = {}
    found = set()
    for match in filter(None, map(FOUND.match, words)):
        file, line = match["file"], int(match["line"])
        if file not in lines:
            lines[file] = (root / file).read_text(encoding="utf-8").splitlines()
        found.add((file, number(match["rule"]), line))
    return [Finding(file, line, ".".join(map(str, rule)), lines[file][line - 1].strip()) for file, rule, line in sorted(found)]


def hash_of(text):
    return hashlib.sha256(text.encode()).hexdigest()[:HASH]


def by_place(found):
    """{file: {rule: [its findings]}}."""
    places = collections.defaultdict(lambda: collections.defaultdict(list))
    for each in found:
        places[each.file][each.rule].append(each)
    return places


def record_text(found):
    """The record of findings: {file: {rule: hashes of the lines}}, a line for each file and rule."""
    files = {file: {rule: " ".join(sorted(hash_of(each.text) for each in there)) for rule, there in rules.items()}
             for file, rules in by_place(found).items()}
    return json.dumps(files, indent=1) + "\n"


def new(found, record):
    """The findings whose text is not on record, in files that have more of a rule than on record."""
    more = []
    for file, rules in by_place(found).items():
        for rule, there in rules.items():
            known = collections.Counter(record.get(file, {}).get(rule, "").split())
            if len(there) <= known.total():
                continue
            unknown = []
            for each in there:
                if known[hash_of(each.text)]:
                    known[hash_of(each.text)] -= 1
                else:
                    unknown.append(each)
            more += unknown
    return more


def fewer(found, record):
    """By how many the findings are fewer than on record, in files and rules where they are."""
    now = by_place(found)
    return sum(max(0, len(hashes.split()) - (len(now[file][rule]) if file in now and rule in now[file] else 0))
               for file, rules in record.items() for rule, hashes in rules.items())


def not_allowed(page, found):
    """The findings of rules from which the page does not deviate in their file."""
    return [each for each in found
            if each.rule not in page or not any(fnmatch.fnmatchcase(each.file, glob) for glob in page[each.rule].where)]


def stale(page, found):
    """Rules from which the page deviates without a finding."""
    there = {each.rule for each in found}
    return [rule for rule, said in page.items() if said.decision == "deviated" and rule not in there]
