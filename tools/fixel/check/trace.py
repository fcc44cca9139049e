# SPDX-License-Identifier: MIT
"""Joins each clause of the specification with the code that has its tag and with the tests that show it.

    fixel trace [--only WORD] [--json FILE] [--accept]
    fixel trace --break [--only WORD | --sample N] --units DIR --cc COMMAND [--build DIR] [--fresh]
    fixel trace --release --cores CORE...

Fails where a normative clause has no code or no test, where a sentence of it has no test and the record does not say that it
is prose or open, where a tag or a seeded bug names a clause or sentence that there is not, and where one has another id than on
record. --only prints a line for each clause with that word in its id, and for each of its sentences.
--accept takes new clauses and sentences and changed first words into the record, and "open" away where there is a test now. --break breaks each clause, by its seeded bugs or by
mutants of the tagged lines, and runs only the tests tagged with it (trace_break.py).
Names the kernels that have fewer inputs on record (equality.py) than a release needs. --release fails for
these, and goes by the kernels of the cores' programs as they are now.
Writes all as JSON. Exit: 0 all is well, 1 something is missing or no test sees a clause broken, 2 could not run.
"""

import argparse
import importlib
import pathlib
import sys
import textwrap
import tomllib

from fixel.base import output, sampling, spent
from fixel.base.errors import ToolError
from fixel.base.table import table
from fixel.campaign import runner
from fixel.check import clauses, equality, planting, sentences
from fixel.commands import late
from fixel.prove import rows as proofs

report_claims = late("fixel.report", "report_claims")

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
FOLDER = pathlib.Path("host_tests/build/trace")
UNBROKEN = FOLDER / "unbroken.toml"
SURVIVORS = "host_tests/build/survivors.toml"
KINDS = ("code", "test")
SAID = 20       # sentences on what is wrong, at most
WIDTH = 120     # of a line


# --- the join ----------------------------------------------------------------------

def join(found, code, tests, seeded):
    """{id: row} of all clauses; what has a tag but no clause is left out. A tag of a sentence is one of its clause too."""
    rows = {id_: {"id": id_, "clause": clause, "code": [], "tests": [], "bugs": []} for id_, clause in found.items()}
    pages = pages_of(found)
    for name, tagged in (("code", code), ("tests", tests)):
        for tag in tagged:
            row = rows.get(clauses.clause_of(tag.id))
            if row:
                row[name].append(tag)
    for bug in seeded:
        for id_ in clauses.ids_of(bug.clause, pages) or [] if bug.clause else []:
            if clauses.clause_of(id_) in rows:
                rows[clauses.clause_of(id_)]["bugs"].append(bug)
    return rows


def tests_of(row, sentence):
    """The tests with the tag of a sentence; where its clause has no other one, those with that of the clause."""
    return [tag for tag in row["tests"] if tag.id == row["id"] + (sentence.letter or "?") or
            (tag.id == row["id"] and len(row["clause"].sentences) == 1)]


def pages_of(found):
    """The names of the pages that have clauses."""
    return {id_.split(" ")[0] for id_ in found}


def lacks(row):
    """What a clause is without: "code", "test"."""
    return [kind for kind, tagged in zip(KINDS, (row["code"], row["tests"])) if not tagged] if row["clause"].normative else []


def unknown(found, code, tests, seeded):
    """Sentences on tags and seeded bugs whose clause or sentence is not there."""
    files = {id_.split(" ")[0]: clause.file for id_, clause in found.items()}
    ids = {*found, *(id_ + each.letter for id_, clause in found.items() for each in clause.sentences if each.letter)}
    wrong = []
    for tag in (*code, *tests):
        if tag.id not in ids:
            page = files[tag.id.split(" ")[0]]
            wrong.append(f"{tag.file}:{tag.line}: the tag '{tag.id}' names no clause: look up the number in {page}"
                         f"{f', and the letter in {clauses.RECORD}' if clauses.clause_of(tag.id) != tag.id else ''}")
    for bug in seeded:
        named = clauses.ids_of(bug.clause, files) if bug.clause else []
        if named is None or not ids.issuperset(named):
            wrong.append(f"{bug.ledger}: {bug}: clause = '{bug.clause}' names no clause such as 'SPEC 4.5': look up "
                         "the number")
    return wrong


def without_test(rows):
    """Sentences on sentences that have no test and no word for that in the record, or both."""
    wrong = []
    for id_, row in rows.items():
        for each in (each for each in row["clause"].sentences if each.letter):
            at, tests = f"{row['clause'].file}:{each.line}: {id_}{each.letter} ('{each.words}')", tests_of(row, each)
            if not tests and not each.state:
                wrong.append(f"{at} has no test: put its id into the tag of the test that fails when it is broken; if it demands "
                             f"nothing, write ', {sentences.PROSE}' behind its id in {clauses.RECORD}")
            elif tests and each.state:
                wrong.append(f"{at} has a test, {tests[0].file}:{tests[0].line}: take ', {each.state}' out of {clauses.RECORD}")
    return wrong


def missing(rows):
    """Sentences on clauses without code or test."""
    how = {"code": "put /* {} */ above the function or block that does what it says",
           "test": "put /* {} */ above the test that fails when it is broken (pytest: the id into the docstring)"}
    return [f"{row['clause'].file}:{row['clause'].line}: {id_} has no {kind}: {how[kind].format(id_)}, or mark the clause "
            "(informative) if it demands nothing"
            for id_, row in rows.items() for kind in lacks(row)]


def unbroken(root, rows):
    """({id: reason} of clauses that need not be shown to break, sentences on entries that are wrong)."""
    path = pathlib.Path(root) / UNBROKEN
    try:
        entries = tomllib.loads(path.read_text(encoding="utf-8")).get("reasons", {}) if path.exists() else {}
    except tomllib.TOMLDecodeError as error:
        raise ToolError(f"{UNBROKEN}: cannot be read: {error}") from error
    return entries, [f"{UNBROKEN}: '{id_}' is no normative clause: take its line out" for id_ in entries
                     if id_ not in rows or not rows[id_]["clause"].normative]


# --- what is printed and written -----------------------------------------------------

def as_json(row):
    """A row as the JSON file has it."""
    clause = row["clause"]
    return {"clause": row["id"], "file": clause.file, "line": clause.line, "words": clause.words, "normative": clause.normative,
            "code": [f"{tag.file}:{tag.line}-{tag.last}" for tag in row["code"]],
            "tests": [f"{tag.file}:{tag.test.split('::')[-1]}" for tag in row["tests"]],
            "bugs": [bug.id for bug in row["bugs"]],
            "sentences": [{"id": f"{row['id']}{each.letter or '?'}", "line": each.line, "words": each.words, "state": each.state,
                           "tests": [f"{tag.file}:{tag.test.split('::')[-1]}" for tag in tests_of(row, each)]}
                          for each in clause.sentences]}


def by_page(rows):
    """Rows of the table of pages."""
    pages = {}
    for id_, row in rows.items():
        normative, said = row["clause"].normative, row["clause"].sentences
        counts = [1, normative, *(normative and bool(row[kind]) for kind in ("code", "tests", "bugs")), len(said),
                  sum(bool(tests_of(row, each)) for each in said),
                  *(sum(each.state == state for each in said) for state in sentences.STATES[1:])]
        page = id_.split(" ")[0]
        pages[page] = [sum(pair) for pair in zip(pages.get(page, [0] * len(counts)), counts)]
    return [[page, *counts] for page, counts in pages.items()] + [["all", *map(sum, zip(*pages.values()))]]


def by_clause(rows):
    """Rows of the table of clauses and their sentences."""
    def short(names):
        return f"{names[0]}{f' + {len(names) - 1}' if len(names) > 1 else ''}" if names else "-"

    def test(tags):
        return short([tag.test if tag.test.startswith("make ") else f"{pathlib.PurePath(tag.file).name}: {tag.test.split('::')[-1]}"
                      for tag in tags])
    found = []
    for id_, row in rows.items():
        found.append([id_, "" if row["clause"].normative else "informative",
                      short([f"{tag.file}:{tag.line}" for tag in row["code"]]), test(row["tests"]), len(row["bugs"])])
        found += [[f"{id_}{each.letter or '?'}", each.state, each.words, test(tests_of(row, each)), ""]
                  for each in row["clause"].sentences]
    return found


def print_rows(rows, only):
    """For people."""
    if only:
        print(table(by_clause(rows), ["clause", "", "code, or a sentence's words", "test", "bugs"]))
    else:
        print(table(by_page(rows), ["page", "clauses", "normative", "with code", "with a test", "with a seeded bug",
                                    "sentences", "with a test", *sentences.STATES[1:]]))
    normative = [row for row in rows.values() if row["clause"].normative]
    whole = sum(not lacks(row) for row in normative)
    print(f"{whole} of {len(normative)} normative clauses have code and a test")


# --- breaking ------------------------------------------------------------------------

def judge_broken(results, reasons):
    """Sentences on clauses that no test sees broken, and on reasons that hold no more."""
    wrong = []
    for result in results:
        id_ = result["clause"]
        if not result["shown"] and id_ not in reasons:
            survived = [each["change"] for each in result["tried"] if each["result"] == "survived"]
            wrong.append(f"{id_}: its tests do not see it broken ({result['by']}{'; survived: ' if survived else ''}"
                         f"{'; '.join(survived)}): write a test that does, seed a bug with clause = \"{id_}\", or give a reason in {UNBROKEN}")
        if result["shown"] and id_ in reasons:
            wrong.append(f"{UNBROKEN}: {id_} is shown to break now (by {result['by']}): take its line out")
    return wrong


def chosen(rows, reasons, options):
    """The normative clauses that are broken: all, or a sample of those that are to be shown."""
    ready = [row for row in rows.values() if row["clause"].normative and row["code"] and row["tests"]]
    if not options.sample:
        return ready
    return sampling.choose(CHECKOUT, "trace", [row for row in ready if row["id"] not in reasons], options.sample)


# --- kernels -----------------------------------------------------------------------------

def kernels_behind(options):
    """Prints which kernels have too few inputs on record; the sentences on what is wrong for that."""
    programs = equality.programs_of(options) if options.release else None
    short, count = equality.short_of(equality.recorded(equality.RECORD), programs)
    print(f"{count - len(short)} of {count} kernels are compared with {equality.ENOUGH:,} inputs or more, by "
          f"{'their hashes' if options.release else 'the record; RELEASE=1 asks for their hashes, and fails for the others'}")
    by_name = {}
    for core, name, inputs in short:
        by_name.setdefault((name, inputs), []).append(core)
    named = "; ".join(f"{name} {inputs:,} ({' '.join(cores)})" for (name, inputs), cores in sorted(by_name.items()))
    print(textwrap.fill(f"with fewer: {named}", WIDTH, break_long_words=False, break_on_hyphens=False) if short else "none has fewer")
    return [f"{len(short)} kernels have fewer than {equality.ENOUGH:,} inputs on record, as a release needs: run make equality"] \
        if short and options.release else []


# --- the command -----------------------------------------------------------------------

def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--root", default=str(CHECKOUT), help="the checkout to read")
    made.add_argument("--build", default="build", help="the build folder")
    made.add_argument("--json", help="the JSON file (BUILD/trace.json)")
    made.add_argument("--only", default="", help="only clauses with this in their id, a line for each and for its sentences: 'SPEC 4', 'beams 2.2'")
    made.add_argument("--accept", action="store_true", help="take new clauses and other first words into the record")
    made.add_argument("--break", action="store_true", dest="breaks", help="break clauses, and see whether their tests fail")
    made.add_argument("--sample", type=int, default=0, help="break so many clauses (all)")
    made.add_argument("--release", action="store_true", help="fail for each kernel with too few inputs on record (RELEASE=1)")
    made.add_argument("--cores", nargs="+", default=[], metavar="CORE", help="whose programs of make equality are built")
    made.add_argument("--units", help="the folder of the unit tests that make has built")
    made.add_argument("--cc", help="the compiler and the flags of the unit tests")
    runner.add_options(made)
    return made


def shown_elsewhere(root, pages):
    """The tags of rows of make prove and of claims of make report: their key "clause"."""
    named = [(row.clause, row.place.relative_to(root).as_posix(), f"make prove: {row.id}") for row in proofs.read(root)]
    file = pathlib.Path(report_claims.__file__).relative_to(CHECKOUT)
    if (root / file).exists():
        named += [(claim.clause, file.as_posix(), f"make report: {claim.id}") for claim in report_claims.CLAIMS]
    found = []
    for text, file, name in named:
        ids = clauses.ids_of(text, pages) if text else []
        if ids is None:
            raise ToolError(f"{file}: {name}: clause = '{text}' is no list of clauses such as 'SPEC 4.5, 4.6b, beams 2.2'")
        found += [clauses.Tag(id_, file, 1, 1, name) for id_ in ids]
    return found


def read(root):
    """(clauses, tags of code, tags of tests, seeded bugs)."""
    found, root = clauses.read(root), pathlib.Path(root)
    if not found:
        raise ToolError(f"{root}: none of {', '.join(clauses.PAGES)} has a clause")
    code, tests = clauses.read_tags(root, pages_of(found))
    return found, code, tests + shown_elsewhere(root, pages_of(found)), planting.entries(root)


def before(options):
    """Refuses a word that no clause has in its id."""
    if not any(options.only in id_ for id_ in clauses.read(options.root)):
        raise ToolError(f"no clause has '{options.only}' in its id; ids are such as 'SPEC 4.5' and 'beams 2.2'")


def main(argv):
    options = parser().parse_args(argv)
    if options.breaks and not (options.units and options.cc):
        raise ToolError("--break needs --units and --cc: run make trace BREAK=1")
    found, code, tests, seeded = read(options.root)
    rows = join(found, code, tests, seeded)
    if options.accept:
        record, said = clauses.recorded(options.root) if (pathlib.Path(options.root) / clauses.RECORD).exists() else ({}, {})
        moved = clauses.renumbered(found, record)
        if moved:
            raise ToolError(f"{clauses.RECORD}: not changed: {len(moved)} clauses have other numbers", 1, words="\n".join(moved))
        clauses.match_sentences(found, said)
        for row in rows.values():
            for each in row["clause"].sentences:
                each.state = "" if each.state == sentences.OPEN and tests_of(row, each) else each.state
        clauses.accept(options.root, found, said)
    record, said = clauses.recorded(options.root)
    gone = clauses.match_sentences(found, said)
    reasons, unreasoned = unbroken(options.root, rows)
    wrong = [*clauses.differences(found, record, gone), *unknown(found, code, tests, seeded), *missing(rows), *without_test(rows),
             *unreasoned]
    before(options)
    here = {id_: row for id_, row in rows.items() if options.only in id_}
    print_rows(here, options.only)
    wrong += kernels_behind(options) if not options.only else []
    said = {"clauses": [as_json(row) for row in rows.values()], "wrong": wrong}
    if options.breaks:
        broken = importlib.import_module("fixel.check.trace_break")    # which uses this module
        results = broken.break_all(chosen(here, reasons, options), options)
        wrong += judge_broken(results, reasons)
        shown = sum(result["shown"] for result in results)
        print(f"{shown} of {len(results)} clauses broken are seen by their tests; {len(reasons)} have a reason in {UNBROKEN}")
        said["broken"] = results
        spent.tell()
    output.write_json(options.json or pathlib.Path(options.build) / "trace.json", said)
    for words in wrong[:SAID]:
        print(words, file=sys.stderr)
    if len(wrong) > SAID:
        print(f"... and {len(wrong) - SAID} more: the JSON file has all", file=sys.stderr)
    return 1 if wrong else 0
