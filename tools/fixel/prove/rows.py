# SPDX-License-Identifier: MIT
"""The rows of make prove, and the lists of what is measured: host_tests/proofs/README.md says what they hold.

host_tests/proofs/ROOM/NAME.toml has rows beside the harnesses of NAME.c. host_tests/proofs/ROOM/measured.toml has the
functions of a room that no row proves, each with the campaign that measures it.
"""

import dataclasses
import pathlib
import re
import tomllib

from fixel.base.errors import ToolError

PROOFS = pathlib.Path("host_tests/proofs")
TOOLS = ("cbmc", "z3", "gappa", "enumeration", "recomputed")
FIELDS = {"function": str, "property": str}
OPTIONAL = {"id": str, "file": str, "tool": str, "harness": str, "contract": bool, "uses": list, "stubs": dict, "unwind": int,
            "cases": list, "checks": int, "flags": list, "links": list, "loops": bool, "equations": bool, "text": list, "program": str,
            "induction": str, "unwindset": dict, "stands_in": dict, "every": bool}
CAMPAIGNS = ("equality", "fuzz", "report", "unit tests", "frames", "seeded bugs", "stages")


@dataclasses.dataclass
class Row:
    """A property of a function, and what proves it."""
    function: str               # FILE:NAME
    property: str
    place: pathlib.Path         # the harness, or another prover's text
    id: str
    tool: str = "cbmc"
    harness: str = ""
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


def _check(path, number, entry):
    for field, kind in FIELDS.items():
        if not isinstance(entry.get(field), kind):
            raise ToolError(f"{path}: row {number}: '{field}' is missing or no {kind.__name__}")
    for field, value in entry.items():
        kind = {**FIELDS, **OPTIONAL}.get(field)
        if kind is None:
            raise ToolError(f"{path}: row {number}: unknown '{field}'")
        if type(value) is not kind:
            raise ToolError(f"{path}: row {number}: '{field}' is no {kind.__name__}")
    if entry.get("tool", "cbmc") not in TOOLS:
        raise ToolError(f"{path}: row {number}: no tool '{entry['tool']}'; there are: {', '.join(TOOLS)}")


def _row(path, number, entry, file):
    """A row of a file, whose functions stand in `file` unless the row says otherwise."""
    entry = {**({"file": file} if file else {}), **entry}
    _check(path, number, entry)
    if "file" not in entry:
        raise ToolError(f"{path}: row {number}: 'file' is missing, here and at the top: where is {entry['function']}?")
    name = entry.pop("function")
    entry["function"] = f"{entry.pop('file')}:{name}"
    entry.setdefault("harness", f"prove_{name.removeprefix('fxl_')}")
    place = path.parent / entry.pop("program") if "program" in entry else path.with_suffix(".c")
    if not place.is_file():
        raise ToolError(f"{path}: row {number}: there is no {place}")
    return Row(place=place, id=entry.pop("id", name), **entry)


def read(root):
    """All rows, in the order of their files."""
    found = []
    for path in sorted((pathlib.Path(root) / PROOFS).glob("*/*.toml")):
        if path.name != "measured.toml":
            table = _read(path)
            unknown = set(table) - {"file", "row"}
            if unknown:
                raise ToolError(f"{path}: unknown {', '.join(sorted(unknown))}; a file has 'file' and [[row]]")
            found += [_row(path, number, dict(entry), table.get("file")) for number, entry in enumerate(table.get("row", []), 1)]
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
            for name in entry["functions"]:
                key = f"{entry['file']}:{name}"
                if key in found:
                    raise ToolError(f"{path}: {key} is named twice")
                found[key] = (", ".join(entry["by"]), entry["why"])
        count, most = len(found) - before, table.get("most")
        if count != most:
            wrong.append(f"{path}: it names {count} functions, and 'most' allows {most}: "
                         f"{'prove the new ones' if count > (most or 0) else f'write most = {count}, so that none comes back'}")
    return found, wrong


def _check_measured(path, number, entry):
    if not all(isinstance(entry.get(field), kind) for field, kind in
               (("file", str), ("by", list), ("why", str), ("functions", list))):
        raise ToolError(f"{path}: entry {number}: it needs file, by, why and functions")
    unknown = [each for each in entry["by"] if each not in CAMPAIGNS] or (not entry["by"] and ["nothing"])
    if unknown:
        raise ToolError(f"{path}: entry {number}: no campaign '{unknown[0]}'; there are: {', '.join(CAMPAIGNS)}")


def tidy(root, gone):
    """Takes functions, FILE:NAME, out of the lists of what is measured, and lowers the limits of these."""
    for path in sorted((pathlib.Path(root) / PROOFS).glob("*/measured.toml")):
        out, file, count = [], "", 0
        for line in path.read_text(encoding="utf-8").splitlines():
            file = line.split('"')[1] if line.startswith("file = ") else file
            name = line.strip().strip('",') if line.startswith('    "') else ""
            if f"{file}:{name}" not in gone:
                out.append(line)
                count += bool(name)
        text = "\n".join(f"most = {count}" if line.startswith("most = ") else line for line in out) + "\n"
        # an entry without functions
        text = re.sub(r'\n\[\[measured\]\]\n(?:\w+ = [^\n]*\n)*functions = \[\n\]\n', "\n", text)
        path.write_text(re.sub(r"\n{3,}", "\n\n", text).rstrip("\n") + "\n", encoding="utf-8")


def record_checks(root, counts):
    """Writes how many checks rows have, {id: count}, beside the rows."""
    for path in sorted((pathlib.Path(root) / PROOFS).glob("*/*.toml")):
        if path.name == "measured.toml":
            continue
        head, *blocks = re.split(r"(?m)^(?=\[\[row\]\])", path.read_text(encoding="utf-8"))
        for number, block in enumerate(blocks):
            name = (re.search(r'(?m)^id = "(.*)"', block) or re.search(r'(?m)^function = "(.*)"', block))[1]
            if name in counts:
                block = re.sub(r"(?m)^checks = .*\n", "", block)
                blocks[number] = re.sub(r"(?m)^(property = .*\n)", rf"\1checks = {counts[name]}\n", block)
        text = head + "".join(blocks)
        if text != path.read_text(encoding="utf-8"):
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

