# SPDX-License-Identifier: MIT
"""Checks the library by the rules of MISRA C:2012 that cppcheck knows.

    fixel rules [--renew | --accept-new] [--json FILE]

docs/safety/rules.md has each rule, in our own words, and whether the library keeps it or deviates from it, where and why.
host_tests/build/rules.json has what is on record: for each file and rule, the lines. A rule's lines in a file may only become fewer.
Exit: 0 nothing new, 1 a finding is new or its rule is not deviated from there, 2 not run: another cppcheck, or none.
"""

import argparse
import json
import pathlib

from fixel.base import output
from fixel.base.errors import ToolError
from fixel.base.table import table
from fixel.check import misra

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGE = "docs/safety/rules.md"
RECORD = "host_tests/build/rules.json"


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
    for rule in sorted({each.rule for each in findings}, key=misra.number):
        there = [each for each in findings if each.rule == rule]
        said = page.get(rule)
        rows.append([rule, len(there), len({each.file for each in there}), said.decision if said else "not in the page",
                     said.words if said else ""])
    return rows


def refusals(page, findings, record):
    """(what the page does not allow, what is new against the record), each as sentences with places."""
    undecided = misra.not_allowed(page, findings)
    new = misra.new(findings, record)
    said = []
    if undecided:
        said.append(f"{len(undecided)} findings of rules from which {PAGE} does not deviate there. Mend the line, or give the page a reason:\n"
                    + places(undecided))
    if new:
        said.append(f"{len(new)} findings are new. Mend the lines; or, if the reason in {PAGE} holds for them,\n"
                    ".venv/bin/fixel rules --accept-new takes them into the record:\n" + places(new))
    return undecided, new, said


def write_record(root, findings):
    (root / RECORD).write_text(misra.record_text(findings), encoding="utf-8")
    print(f"{RECORD} has {len(findings):,} findings")


def main(argv):
    options = parser().parse_args(argv)
    root = pathlib.Path(options.root).resolve()
    page = misra.read_page(root / PAGE)
    misra.require_version()
    findings = misra.findings(root)
    record = json.loads((root / RECORD).read_text(encoding="utf-8"))
    rows = report(page, findings)
    print(table(rows, ["rule", "findings", "files", "decision", "what it asks"]))
    kept = sum(rule.decision == "kept" for rule in page.values())
    undecided, new, said = refusals(page, findings, record)
    fewer = misra.fewer(findings, record)
    output.write_json(root / options.json, {
        "cppcheck": misra.VERSION, "new": len(new), "not_allowed": len(undecided), "fewer": fewer,
        "rules": [dict(zip(("rule", "findings", "files", "decision", "words"), row)) for row in rows],
        "findings": [vars(each) for each in findings]})
    print(f"\ncppcheck {misra.VERSION}: {len(page)} rules, {kept} kept without a finding, {len(rows)} deviated from in {len(findings):,} lines; {options.json}")
    if undecided or (new and not options.accept_new):
        raise ToolError("the library breaks rules where it did not", 1, "\n".join(said))
    if options.accept_new or options.renew:
        write_record(root, findings)
    elif fewer:
        print(f"{fewer} findings fewer than on record: make rules RENEW=1 takes that into {RECORD}")
    for rule in misra.stale(page, findings):
        print(f"note: {PAGE} deviates from rule {rule}, of which there is no finding any more")
    return 0
