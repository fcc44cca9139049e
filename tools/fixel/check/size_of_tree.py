# SPDX-License-Identifier: MIT
"""Counts what the project consists of, and holds it to the counts on record.

    fixel size-of-tree [--reason TEXT] [--json FILE]

Files that git tracks, lines of code by folder and language, public headers and functions, the files with the tag of each recipe,
sentences of clauses without a test, and the steps in which make builds the programs of make run and of make test from nothing. A count may be up to 2 % above its record, for
a branch at work; the record is no older commit, so many small steps do not pass. --reason renews the record, and is kept in it.
Exit: 0 no count is above its record, 1 one is.
"""

import argparse
import ast
import collections
import json
import os
import pathlib
import re

from fixel.base import children, output, scratch
from fixel.base.errors import ToolError
from fixel.base.table import coloured, table
from fixel.check import clauses, places, sentences
from fixel.package import repository
from fixel.prove import rows

ROOT = pathlib.Path(__file__).resolve().parents[3]
RECORD = "host_tests/build/tree.json"
SLACK = 0.02
FOLDERS = ("lib", "tools", "host_tests", "firmware", "boards", "bench", "ports", "examples")
LANGUAGES = {".c": "C", ".h": "C", ".S": "assembly", ".py": "Python", ".toml": "TOML", ".mk": "make", ".mjs": "JavaScript", ".rs": "Rust"}
ASSEMBLY = re.compile(r"_armv\w+\.h$")    # headers of assembly: what several sources of it share
HASH = re.compile(r"^[ \t]*#.*", re.MULTILINE)
COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)
HEADERS = "lib/include"
FUNCTION = re.compile(r"\bfxl_\w+\s*\([^;{}]*\)\s*;")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--reason", default="", help="take the counts into the record, for this reason")
    made.add_argument("--json", default="build/tree.json", help="the result as JSON (default: build/tree.json)")
    return made


def lines_of_code(text, suffix):
    """Lines that are neither blank nor of a comment or a docstring alone."""
    if suffix == ".py":
        return _lines_of_python(text)
    text = (HASH if suffix in (".toml", ".mk") else COMMENT).sub("", text)
    return sum(bool(line.strip()) for line in text.splitlines())


def _lines_of_python(text):
    strings = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
            strings |= set(range(node.lineno, node.end_lineno + 1))
    return sum(bool(line.strip()) and number not in strings for number, line in enumerate(HASH.sub("", text).splitlines(), 1))


def count_lines(files, root=ROOT):
    """{"lines of lib, C": how many, ...}. Rows of proofs are TOML, though they stand in comments."""
    found = collections.Counter()
    for name in files:
        folder, suffix = name.partition("/")[0], os.path.splitext(name)[1]
        if folder in FOLDERS and suffix in LANGUAGES:
            language = "assembly" if ASSEMBLY.search(name) else LANGUAGES[suffix]
            found[f"lines of {folder}, {language}"] += lines_of_code((root / name).read_text(encoding="utf-8"), suffix)
        if name.startswith(f"{rows.PROOFS}/"):
            found[f"lines of {folder}, TOML"] += rows.lines_of_rows((root / name).read_text(encoding="utf-8"))
    return dict(sorted(found.items()))


def count_interface(files, root=ROOT):
    """Public headers, and the functions that they declare."""
    headers = [name for name in files if name.startswith(f"{HEADERS}/") and name.endswith(".h")]
    functions = {declared.split("(")[0].strip() for name in headers
                 for declared in FUNCTION.findall(COMMENT.sub(" ", HASH.sub("", (root / name).read_text(encoding="utf-8"))))}
    return {"public headers": len(headers), "public functions": len(functions)}


def count_places(root=ROOT):
    """{"places of RECIPE": how many files have its tag}."""
    known, _ = places.load(root)
    tags = places.tags(known, root)
    return {f"places of {recipe.title}": len({tag.file for tag in tags if tag.word == word}) for word, recipe in known.items()}


def count_open(root=ROOT):
    """How many sentences of clauses have no test yet."""
    _, said = clauses.recorded(root)
    return {"sentences without a test": sum(state == sentences.OPEN for entries in said.values() for _, state, _ in entries)}


def count_steps(root=ROOT):
    """In how many steps make would build what two commands need, where nothing is built yet."""
    found = {}
    with scratch.folder("tree") as nowhere:
        run = [f"{nowhere}/{name}" for name in ("boards/mps2-an385/walk.elf", "boards/host/walk", "host/judge", "host/raycast")]
        for command, goals in (("make run", run), ("make test", ["test-programs"])):
            environment = {name: value for name, value in os.environ.items() if name not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL", "ONLY")}
            done = children.run(["make", "-n", f"BUILD={nowhere}", *goals], cwd=root, text=True, env={**environment, "FIXEL_COUNTING": "1"})
            if done.returncode:
                raise ToolError("make -n: it failed", words=done.stderr)
            found[f"build steps of {command}"] = done.stdout.splitlines().count("+")
    return found


def count(root=ROOT):
    """{what is counted: how many}."""
    files = [name for name in places.listed("ls-files", folder=root) if (root / name).is_file()]
    return {"files": len(files), **count_lines(files, root), **count_interface(files, root), **count_places(root), **count_open(root),
            **count_steps(root)}


def most(recorded):
    """The most that passes beside a record."""
    return recorded + int(recorded * SLACK)


def grown(now, record):
    """What is above its record, or has none."""
    return [what for what, number in now.items() if number > most(record.get(what, 0))]


def main(argv):
    """The command."""
    options = parser().parse_args(argv)
    repository.require(ROOT)
    file = ROOT / RECORD
    kept = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {"reasons": [], "counts": {}}
    now = count()
    above = grown(now, kept["counts"])
    shown = [[what, kept["counts"].get(what), number, coloured("more", "red") if what in above else ""] for what, number in now.items()]
    print(table(shown, ["what", "record", "now", ""]))
    output.write_json(options.json, {"counts": now, "record": kept["counts"], "above": above})
    if options.reason:
        output.write_json(file, {"reasons": [*kept["reasons"], options.reason], "counts": now})
        print(f"renewed: {RECORD}")
        return 0
    if above and kept["counts"]:
        print(f"more than {SLACK:.0%} above the record: {', '.join(above)}. Make it less, or renew the record with a reason: "
              'make size-of-tree REASON="..."')
    return 1 if above else 0
