# SPDX-License-Identifier: MIT
"""Checks the library by the rules of MISRA C:2012 that cppcheck knows.

    fixel rules [--renew | --accept-new] [--json FILE]

docs/safety/rules.md has each rule, in our own words, and whether the library keeps it, disapplies it, which only an advisory rule may be, or
deviates from it: where, why, and by which permits, each of a construct that the lines have. host_tests/build/rules.json has what is on record:
for each file and rule that is deviated from, the lines. A rule's lines in a file may only become fewer.
The record knows a line by the hash of its text, so that it does not change where lines move.
Exit: 0 nothing new, 1 a finding is new, its rule is not deviated from there or it has no permit, 2 not run: another cppcheck, or none.
"""

import argparse
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

from fixel.base import children, output, scratch
from fixel.base.errors import ToolError
from fixel.base.progress import Progress
from fixel.base.table import table

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGE = "docs/safety/rules.md"
RECORD = "host_tests/build/rules.json"
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
PERMIT = re.compile(r"^\| (?P<name>P\d+) \| (?P<rule>\d+\.\d+) \| (?P<construct>[^|]+) \| (?P<texts>[^|]+) \| (?P<stands>[^|]+) \|$")
DECISIONS = ("kept", "mended", "deviated", "disapplied")
# Of MISRA C:2012; all others are required or mandatory.
ADVISORY = frozenset("""1.2 2.3 2.4 2.5 2.6 2.7 4.2 5.9 8.7 8.9 8.11 8.13 10.5 11.4 11.5 12.1 12.3 12.4 13.3 13.4 15.1 15.4 15.5 17.5 17.8
    18.4 18.5 19.2 20.1 20.5 20.10 21.12""".split())
HASH = 6            # digits


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    how = made.add_mutually_exclusive_group()
    how.add_argument("--renew", action="store_true", help="take into the record what has become less; refused if something is new")
    how.add_argument("--accept-new", action="store_true", help="take what is new into the record too; the page must deviate from its rule there")
    made.add_argument("--root", default=str(ROOT), help="the checkout that is checked")
    made.add_argument("--json", default="build/rules.json", help="the result as JSON (default: build/rules.json)")
    return made


def places(findings):
    """One line for each finding: where, its rule, the text of the line."""
    return "".join(f"  {each.file}:{each.line}: rule {each.rule}: {each.text}\n" for each in findings)


def report(page, findings):
    """Rows of the table: of each rule with findings the number, how many, in how many files, what the page says."""
    rows = []
    for rule in sorted({each.rule for each in findings}, key=number):
        there = [each for each in findings if each.rule == rule]
        said = page.get(rule)
        rows.append([rule, len(there), len({each.file for each in there}), said.decision if said else "not in the page",
                     said.words if said else ""])
    return rows


def refusals(page, permits, findings, record):
    """(what the page does not allow, what is new against the record), each as sentences with places."""
    undecided = not_allowed(page, findings)
    bare = without_permit(page, permits, findings)
    new = new_findings(findings, record)
    said = []
    if bare:
        said.append(f"{len(bare)} findings have no text of a permit of their rule. Mend the line, or give {PAGE} a permit:\n" + places(bare))
    if undecided:
        said.append(f"{len(undecided)} findings of rules from which {PAGE} does not deviate there. Mend the line, or give the page a reason:\n"
                    + places(undecided))
    if new:
        said.append(f"{len(new)} findings are new. Mend the lines; or, if the reason in {PAGE} holds for them,\n"
                    ".venv/bin/fixel rules --accept-new takes them into the record:\n" + places(new))
    return undecided + bare, new, said


def write_record(root, findings):
    (root / RECORD).write_text(record_text(findings), encoding="utf-8")
    print(f"{RECORD} has {len(findings):,} findings")


def main(argv):
    options = parser().parse_args(argv)
    root = pathlib.Path(options.root).resolve()
    page, permits = read_page(root / PAGE), read_permits(root / PAGE)
    require_version()
    every = all_findings(root)
    findings = [each for each in every if not is_disapplied(page, each)]
    record = json.loads((root / RECORD).read_text(encoding="utf-8"))
    rows = report(page, every)
    print(table(rows, ["rule", "findings", "files", "decision", "what it asks"]))
    kept = sum(rule.decision == "kept" for rule in page.values())
    undecided, new, said = refusals(page, permits, findings, record)
    fewer = count_of_fewer(findings, record)
    output.write_json(root / options.json, {
        "cppcheck": VERSION, "new": len(new), "not_allowed": len(undecided), "fewer": fewer,
        "rules": [dict(zip(("rule", "findings", "files", "decision", "words"), row)) for row in rows],
        "findings": [vars(each) for each in findings]})
    deviated = len({each.rule for each in findings})
    print(f"\ncppcheck {VERSION}: {len(page)} rules, {kept} kept without a finding, {deviated} deviated from in {len(findings):,} lines by "
          f"{len(permits)} permits, {len(rows) - deviated} advisory ones disapplied; {options.json}")
    if undecided or (new and not options.accept_new):
        raise ToolError("the library breaks rules where it did not", 1, "\n".join(said))
    if options.accept_new or options.renew:
        write_record(root, findings)
    elif fewer:
        print(f"{fewer} findings fewer than on record: make rules RENEW=1 takes that into {RECORD}")
    for rule in stale(page, every):
        print(f"note: {PAGE} deviates from rule {rule} or disapplies it, of which there is no finding any more")
    for permit in idle(permits, findings):
        print(f"note: {PAGE}: no finding of rule {permit.rule} has a text of {permit.name} alone")
    return 0


@dataclasses.dataclass(frozen=True)
class Finding:
    """A line that a rule is broken in."""
    file: str
    line: int
    rule: str
    text: str


@dataclasses.dataclass(frozen=True)
class Rule:
    """What the page says of a rule. where: globs of files, () if it has no finding or is disapplied."""
    words: str
    decision: str
    where: tuple
    reason: str


@dataclasses.dataclass(frozen=True)
class Permit:
    """A construct in which a rule is deviated from. texts: expressions, of which a line has one."""
    name: str
    rule: str
    construct: str
    texts: tuple
    stands: str

    def holds(self, finding):
        return finding.rule == self.rule and any(text.search(finding.text) for text in self.texts)


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
        if row["decision"] == "disapplied" and (row["rule"] not in ADVISORY or not row["reason"].strip()):
            raise ToolError(f"{path.name}:{place}: a rule that is disapplied is an advisory one and has a reason")
        rules[row["rule"]] = Rule(row["words"].strip(), row["decision"], where, row["reason"].strip())
    return rules


def read_permits(path):
    """[Permit, ...] of the page."""
    permits = []
    for place, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if not re.match(r"\| P\d+ \|", line):
            continue
        row = PERMIT.match(line)
        texts = re.findall(r"`([^`]+)`", row["texts"]) if row else []
        if not texts or not row["stands"].strip():
            raise ToolError(f"{path.name}:{place}: a permit is | P1 | rule | construct | `its line has` | what stands for the rule |")
        if row["name"] in {each.name for each in permits}:
            raise ToolError(f"{path.name}:{place}: permit {row['name']} stands there twice")
        try:
            permits.append(Permit(row["name"], row["rule"], row["construct"].strip(), tuple(map(re.compile, texts)), row["stands"].strip()))
        except re.error as error:
            raise ToolError(f"{path.name}:{place}: {row['name']}: no expression: {error}") from None
    return permits


def require_version():
    """Refuses another cppcheck than the one whose findings are on record."""
    if shutil.which(COMMAND[0]) is None:
        raise ToolError(f"not run: needs cppcheck {VERSION}, which is not there")
    said = children.run([COMMAND[0], "--version"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout.strip()
    if said != f"Cppcheck {VERSION}":
        raise ToolError(f"not run: needs cppcheck {VERSION}, as Debian 12 has it; this is {said}")


def all_findings(root):
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


def new_findings(found, record):
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


def count_of_fewer(found, record):
    """By how many the findings are fewer than on record, in files and rules where they are."""
    now = by_place(found)
    return sum(max(0, len(hashes.split()) - (len(now[file][rule]) if file in now and rule in now[file] else 0))
               for file, rules in record.items() for rule, hashes in rules.items())


def not_allowed(page, found):
    """The findings of rules from which the page does not deviate in their file."""
    return [each for each in found
            if each.rule not in page or not any(fnmatch.fnmatchcase(each.file, glob) for glob in page[each.rule].where)]


def is_disapplied(page, each):
    return each.rule in page and page[each.rule].decision == "disapplied"


def without_permit(page, permits, found):
    """The findings of rules from which the page deviates whose lines have no text of a permit of the rule."""
    return [each for each in found
            if each.rule in page and page[each.rule].decision == "deviated" and not any(permit.holds(each) for permit in permits)]


def idle(permits, found):
    """Permits of which each line has one of another permit of its rule, too: what they permit is not seen apart."""
    return [permit for permit in permits
            if not any(permit.holds(each) and not any(other.holds(each) for other in permits if other != permit) for each in found)]


def stale(page, found):
    """Rules from which the page deviates, or which it disapplies, without a finding."""
    there = {each.rule for each in found}
    return [rule for rule, said in page.items() if said.decision in ("deviated", "disapplied") and rule not in there]
