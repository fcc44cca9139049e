# SPDX-License-Identifier: MIT
"""The rows of make prove, and the lists of what is measured: host_tests/proofs/README.md says what they hold.

A row is TOML in a comment above its harness: a function of a C or Python file, or the text of Z3 or Gappa below it.
host_tests/proofs/ROOM/measured.toml has the functions of a room that no row proves, each with the campaign that measures it.
"""

import dataclasses
import pathlib
import re
import tomllib

from fixel.base.errors import ToolError

PROOFS = pathlib.Path("host_tests/proofs")
TOOLS = ("cbmc", "z3", "gappa", "enumeration", "recomputed")
TOOL_OF = {".py": "recomputed", ".smt2": "z3", ".gappa": "gappa"}
ENUMERATES = '#include "enumeration.h"'     # in a .c whose rows are not of CBMC
MARK = "[[row]]"
# What divides a harness file: a row, without what its lines begin with as a comment, or an include of the library.
PARTS = re.compile(r'^(?:(?:/\*|[;#]) \[\[row\]\]\n(?P<row>(?:(?: \*|[;#]) .*\n)+)(?: \*/\n)?|#include "(?P<include>\w+/.*)")', re.MULTILINE)
LEADER = re.compile(r"^(?: \*|[;#]) ", re.MULTILINE)
HARNESS = re.compile(r"^(?:void|def) (\w+)\(", re.MULTILINE)
FIELDS = {"function": str, "property": str}
OPTIONAL = {"id": str, "contract": bool, "uses": list, "stubs": dict, "unwind": int, "cases": list, "checks": int, "flags": list,
            "links": list, "loops": bool, "equations": bool, "text": list, "induction": str, "unwindset": dict, "stands_in": dict, "every": bool, "narrows": str, "clause": str}
CAMPAIGNS = ("equality", "fuzz", "report", "unit tests", "frames", "seeded bugs", "stages")


@dataclasses.dataclass
class Row:
    """A property of a function, and what proves it."""
    function: str               # FILE:NAME
    property: str
    place: pathlib.Path         # the harness, or another prover's text
    id: str
    tool: str = "cbmc"
    harness: str = ""           # the function below the row
    program: str = ""           # of Z3 and Gappa: the text that is proved
    contract: bool = False      # the contract at the declaration is what is proved
    uses: list = dataclasses.field(default_factory=list)    # functions that are taken by their contracts
    stubs: dict = dataclasses.field(default_factory=dict)   # functions that the harness defines itself: why that may be
    stands_in: dict = dataclasses.field(default_factory=dict)   # {a function with a row of its own: the harness's that is called for it}
    unwind: int = 6             # rounds of each loop: also of the checks of what a contract assigns
    unwindset: dict = dataclasses.field(default_factory=dict)   # loops apart: {FUNCTION.NUMBER: times}
    cases: list = dataclasses.field(default_factory=lambda: [None])     # of the macro CASE: a run for each
    checks: int = 0             # how many there are at least
    flags: list = dataclasses.field(default_factory=list)
    links: list = dataclasses.field(default_factory=list)   # sources besides those that the harness includes
    loops: bool = False         # loops have contracts, which are applied
    equations: bool = False     # rows of Z3 prove what the contract says by FXL_EQUATES
    text: list = dataclasses.field(default_factory=list)    # lines that the transcription stands for, in their order
    induction: str = ""         # why a circle of contracts is none
    clause: str = ""            # the clauses and sentences that it shows, as a tag has them: "SPEC 2.2a, accuracy 1.1c"
    narrows: str = ""           # why a conversion may change a value: such rows are counted, and become fewer
    every: bool = False         # enumeration runs the host's text of the function on each input that it may get

    @property
    def name(self):
        """The function without its file."""
        return self.function.rpartition(":")[2]

    @property
    def is_whole(self):
        """Whether the row shows that nothing in the function is undefined. Others show something of its results."""
        return self.tool == "cbmc" or self.every


def _read(path):
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, tomllib.TOMLDecodeError) as error:
        raise ToolError(f"{path}: cannot be read: {error}") from error


def _check(where, entry):
    for field, kind in FIELDS.items():
        if not isinstance(entry.get(field), kind):
            raise ToolError(f"{where}: '{field}' is missing or no {kind.__name__}")
    for field, value in entry.items():
        kind = {**FIELDS, **OPTIONAL}.get(field)
        if kind is None:
            raise ToolError(f"{where}: unknown '{field}'")
        if type(value) is not kind:
            raise ToolError(f"{where}: '{field}' is no {kind.__name__}")


def _entry(path, text, place, file):
    """The fields of a row, whose function stands in `file` unless the row says FILE:NAME."""
    where = f"{path}:{text.count(chr(10), 0, place.start()) + 1}"
    try:
        entry = tomllib.loads(LEADER.sub("", place["row"]))
    except tomllib.TOMLDecodeError as error:
        raise ToolError(f"{where}: cannot be read: {error}") from error
    _check(where, entry)
    if ":" not in entry["function"]:
        if not file:
            raise ToolError(f"{where}: no include of the library stands above: where is {entry['function']}? Write FILE:{entry['function']}")
        entry["function"] = f"{file}:{entry['function']}"
    return where, entry


def _harness(path, where, text, places, number):
    """Of a row: the function below it, or the text that is proved, which it may share with the rows right above and below."""
    tool = TOOL_OF.get(path.suffix, "enumeration" if ENUMERATES in text else "cbmc")
    last = number
    while last + 1 < len(places) and not text[places[last].end():places[last + 1].start()].strip():
        last += 1
    below = text[places[last].end():places[last + 1].start() if last + 1 < len(places) else len(text)]
    if tool in ("z3", "gappa"):
        return {"tool": tool, "program": text[:places[0].start()] + below}
    named = HARNESS.search(below)
    if not named:
        raise ToolError(f"{where}: there is no harness below it")
    return {"tool": tool, "harness": named[1]}


def rows_of(path):
    """The rows of a file, in their order."""
    text = path.read_text(encoding="utf-8")
    parts = list(PARTS.finditer(text))
    places = [part for part in parts if part["row"]]
    if text.count(MARK) != len(places):
        raise ToolError(f"{path}: it has {MARK} {text.count(MARK)} times, and {len(places)} comments of rows: a row is a comment of its own, "
                        f"each line of TOML behind the comment's sign and a blank")
    found, file, group = [], None, None
    for part in parts:
        if part["include"]:
            # the first one of a group is what the rows below are of
            file, group = (file if group else f"lib/{part['include']}"), True
            continue
        group = None
        where, entry = _entry(path, text, part, file)
        found.append(Row(place=path, id=entry.pop("id", entry["function"].rpartition(":")[2]), **entry, **_harness(path, where, text, places, len(found))))
    return found


def lines_of_rows(text):
    """How many lines of a file are rows."""
    return sum(1 + part["row"].count("\n") for part in PARTS.finditer(text) if part["row"])


def files(root):
    """All files that may have rows."""
    return [path for path in sorted((pathlib.Path(root) / PROOFS).glob("*/*")) if path.suffix in (".c", *TOOL_OF)]


def read(root):
    """All rows, in the order of their files."""
    found = [row for path in files(root) for row in rows_of(path)]
    ids = [row.id for row in found]
    twice = sorted({each for each in ids if ids.count(each) > 1})
    if twice:
        raise ToolError(f"{PROOFS}: two rows have the id '{twice[0]}': give one of them an id of its own")
    return found


def measured(root):
    """({FILE:NAME: (campaign, why it is not proved)}, what is wrong with the length of the lists, which only become shorter)."""
    found, wrong = {}, []
    for path in sorted((pathlib.Path(root) / PROOFS).glob("*/measured.toml")):
        table = _read(path)
        before = len(found)
        for number, entry in enumerate(table.get("measured", []), 1):
            _check_measured(path, number, entry)
            for key in [f"{file}:{name}" for file, names in entry["functions"].items() for name in names]:
                if key in found:
                    raise ToolError(f"{path}: {key} is named twice")
                found[key] = (", ".join(entry["by"]), entry["why"])
        count, most = len(found) - before, table.get("most")
        if count != most:
            wrong.append(f"{path}: it names {count} functions, and 'most' allows {most}: "
                         f"{'prove the new ones' if count > (most or 0) else f'write most = {count}, so that none comes back'}")
    return found, wrong


def _check_measured(path, number, entry):
    if not all(isinstance(entry.get(field), kind) for field, kind in (("by", list), ("why", str), ("functions", dict))):
        raise ToolError(f"{path}: entry {number}: it needs by, why, and functions by their files")
    unknown = [each for each in entry["by"] if each not in CAMPAIGNS] or (not entry["by"] and ["nothing"])
    if unknown:
        raise ToolError(f"{path}: entry {number}: no campaign '{unknown[0]}'; there are: {', '.join(CAMPAIGNS)}")


def tidy(root, gone):
    """Takes functions, FILE:NAME, out of the lists of what is measured, and lowers the limits of these."""
    for path in sorted((pathlib.Path(root) / PROOFS).glob("*/measured.toml")):
        out, file, count = [], "", 0
        for line in path.read_text(encoding="utf-8").splitlines():
            file = line.split('"')[1] if line.startswith('"') else file
            name = line.strip().strip('",') if line.startswith('    "') else ""
            if f"{file}:{name}" not in gone:
                out.append(line)
                count += bool(name)
        text = "\n".join(f"most = {count}" if line.startswith("most = ") else line for line in out) + "\n"
        # a file without functions, then an entry without files
        text = re.sub(r'(?m)^"[^\n]*" = \[\n\]\n', "", text)
        text = re.sub(r"\n\[\[measured\]\]\n(?:\w+ = [^\n]*\n)*\[measured\.functions\]\n(?=\n|\Z)", "\n", text)
        path.write_text(re.sub(r"\n{3,}", "\n\n", text).rstrip("\n") + "\n", encoding="utf-8")


def record_checks(root, counts):
    """Writes how many checks rows have, {id: count}, into the rows."""
    def with_count(part):
        row = part["row"] and tomllib.loads(LEADER.sub("", part["row"]))
        name = row and row.get("id", row["function"].rpartition(":")[2])
        if name not in counts:
            return part[0]
        without = re.sub(r"(?m)^(?: \*|[;#]) checks = .*\n", "", part[0])
        return re.sub(r"(?m)^((?: \*|[;#]) )(property = .*\n)", rf"\1\2\1checks = {counts[name]}\n", without)

    for path in files(root):
        before = path.read_text(encoding="utf-8")
        text = PARTS.sub(with_count, before)
        if text != before:
            path.write_text(text, encoding="utf-8")


def lemmas(root, rows):
    """What is wrong with the equations that stand within functions: each must be quoted by a row of Z3."""
    quoted = {" ".join(line.split()) for row in rows if row.tool == "z3" for line in row.text}
    found = [(path, " ".join(lemma.split())) for path in sorted((pathlib.Path(root) / "lib").rglob("*.[ch]")) if path.name != "contract.h"
             for lemma in re.findall(r"FXL_LEMMA\([^;]*;", path.read_text(encoding="utf-8"))]
    return [f"{path}: no row of Z3 quotes '{lemma}'" for path, lemma in found if lemma not in quoted]


def circles(rows):
    """What is wrong with the uses of contracts: a contract that no row proves, and a circle without an induction."""
    proved = {row.name: row for row in rows if row.contract and row.tool == "cbmc"}
    exact = {row.name for row in rows if row.tool == "z3"}
    wrong = [f"{row.id}: no row of Z3 proves the equations of {row.name}" for row in rows if row.equations and row.name not in exact]
    wrong += [f"{row.id} uses the contract of {name}, which no row proves" for row in rows for name in row.uses if name not in proved]
    every = {row.name for row in rows}
    wrong += [f"{row.id} calls {to} for {name}, which no row proves" for row in rows for name, to in row.stands_in.items()
              if name not in every and name not in row.stubs]
    for row in rows:
        reached, waiting = set(), list(row.uses)
        while waiting:
            name = waiting.pop()
            if name not in reached and name in proved:
                reached.add(name)
                waiting += proved[name].uses
        if row.contract and row.name in reached and not row.induction:
            wrong.append(f"{row.id} is proved by its own contract, by way of {', '.join(sorted(reached))}: state the induction")
    return wrong

