# SPDX-License-Identifier: MIT
"""The rows of make prove, and the lists of what is measured: host_tests/proofs/README.md says what they hold.

A row is TOML in a comment above its harness: a function of a C or Python file, or the text of Z3 or Gappa below it.
host_tests/proofs/measured.toml has the functions that no row proves, each with the campaign that measures it, and the kernels of
make equality that compare the files of assembly with the C text.
"""

import dataclasses
import json
import pathlib
import re
import textwrap
import tomllib

from fixel.base.errors import ToolError
from fixel.check import planting

PROOFS = pathlib.Path("host_tests/proofs")
MEASURED = PROOFS / "measured.toml"
MEASURED_HEAD = """# SPDX-License-Identifier: MIT
# Functions that no row proves, what measures them, and why no row does; most: how many a room has, so that none is added unseen.
# fixel prove --tidy takes out what is proved. A new function without a row is added by hand, and its room's "most" raised.
# [assembly]: the kernels of make equality that compare a file with the C text.
"""
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
            "links": list, "loops": bool, "equations": bool, "text": list, "of": dict, "formula": str, "induction": str, "unwindset": dict, "stands_in": dict, "every": bool, "unreached": dict, "narrows": str, "clause": str}
MILLION = 1_000_000
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
    of: dict = dataclasses.field(default_factory=dict)      # {FILE:NAME that a transcription was written from: the hash of its text}
    formula: str = ""           # of an enumeration: the row of Z3 or Gappa whose formula it runs beside the function
    text: list = dataclasses.field(default_factory=list)    # recomputed: lines that have the numbers
    induction: str = ""         # why a circle of contracts is none
    clause: str = ""            # the clauses and sentences that it shows, as a tag has them: "SPEC 2.2a, accuracy 1.1c"
    narrows: str = ""           # why a conversion may change a value: such rows are counted, and become fewer
    unreached: dict = dataclasses.field(default_factory=dict)   # functions that it calls, and that no input of the row reaches: why
    every: bool = False         # enumeration runs the host's text of the function on each input that it may get

    @property
    def file(self):
        """The file of the function."""
        return self.function.rpartition(":")[0]

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
    """({FILE:NAME: (campaign, why it is not proved)}, what is wrong with the length of the lists)."""
    found, counts, path = {}, {}, pathlib.Path(root) / MEASURED
    listed = _read(path)
    for number, entry in enumerate(listed.get("measured", []), 1):
        _check_measured(path, number, entry)
        for key in [f"{file}:{name}" for file, names in entry["functions"].items() for name in names.split()]:
            if key in found:
                raise ToolError(f"{path}: {key} is named twice")
            found[key] = (", ".join(entry["by"]), entry["why"])
            counts[key.split("/")[1]] = counts.get(key.split("/")[1], 0) + 1
    most = listed.get("most", {})
    return found, [f"{path}: it names {counts.get(room, 0)} functions of {room}, and 'most' allows {most.get(room, 0)}: "
                   f"{'prove the new ones, or ' if counts.get(room, 0) > most.get(room, 0) else ''}write {room} = {counts.get(room, 0)} below [most]"
                   for room in sorted({*counts, *most}) if counts.get(room, 0) != most.get(room, 0)]


def assembly(root):
    """{FILE: the kernels of make equality that compare it with the C text}."""
    return _read(pathlib.Path(root) / MEASURED).get("assembly", {})


def _check_measured(path, number, entry):
    if not all(isinstance(entry.get(field), kind) for field, kind in (("by", list), ("why", str), ("functions", dict))):
        raise ToolError(f"{path}: entry {number}: it needs by, why, and functions by their files")
    unknown = [each for each in entry["by"] if each not in CAMPAIGNS] or (not entry["by"] and ["nothing"])
    if unknown:
        raise ToolError(f"{path}: entry {number}: no campaign '{unknown[0]}'; there are: {', '.join(CAMPAIGNS)}")


def save_measured(root, listed):
    """Writes the lists of what is measured, as tomllib reads them, but with the names of a file as a list or a string."""
    def names(some):
        text = " ".join(sorted(some.split() if isinstance(some, str) else some))
        short = len(text) < 100
        return f'"{text}"' if short else '"""\n' + textwrap.fill(text, 150, initial_indent="    ", subsequent_indent="    ") + '"""'

    out = [MEASURED_HEAD + "\n[most]\n" + "".join(f"{room} = {count}\n" for room, count in sorted(listed["most"].items()) if count)]
    for entry in listed["measured"]:
        out.append(f"[[measured]]\nby = {json.dumps(entry['by'])}\nwhy = {json.dumps(entry['why'])}\n[measured.functions]\n"
                   + "".join(f'"{file}" = {names(some)}\n' for file, some in sorted(entry["functions"].items())))
    out.append("[assembly]\n" + "".join(f'"{file}" = {json.dumps(some)}\n' for file, some in sorted(listed["assembly"].items())))
    (pathlib.Path(root) / MEASURED).write_text("\n".join(out), encoding="utf-8")


def tidy(root, gone):
    """Takes functions, FILE:NAME, out of the lists of what is measured, and lowers the limits of these."""
    listed = {"most": {}, "assembly": {}, "measured": [], **_read(pathlib.Path(root) / MEASURED)}
    listed["most"] = dict.fromkeys(listed["most"], 0)
    for entry in listed["measured"]:
        left = {file: [name for name in names.split() if f"{file}:{name}" not in gone] for file, names in entry["functions"].items()}
        entry["functions"] = {file: names for file, names in left.items() if names}
        for file, names in left.items():
            listed["most"][file.split("/")[1]] = listed["most"].get(file.split("/")[1], 0) + len(names)
    listed["measured"] = [entry for entry in listed["measured"] if entry["functions"]]
    save_measured(root, listed)


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


def accept(root, some, text_of):
    """Writes into rows the hashes of the functions that they were written from, as these are now."""
    for path in sorted({row.place for row in some if row.of}):
        text = path.read_text(encoding="utf-8")
        for row in some:
            for function, known in row.of.items() if row.place == path else ():
                text = text.replace(f'"{function}" = "{known}"', f'"{function}" = "{text_of(root, function)}"')
        path.write_text(text, encoding="utf-8")


def lemmas(root, rows):
    """What is wrong with the equations that stand within functions: each such function must be one that a row of Z3 was written from."""
    known = {function for row in rows if row.tool == "z3" for function in row.of}
    found = [f"{path.relative_to(root).as_posix()}:{owner}" for path in sorted((pathlib.Path(root) / "lib").rglob("*.[ch]")) if path.name != "contract.h"
             for text in [path.read_text(encoding="utf-8")] if "FXL_LEMMA(" in text
             for line, owner in zip(text.splitlines(), planting.functions(text)) if "FXL_LEMMA(" in line]
    return [f"{function} has a FXL_LEMMA, and no row of Z3 was written from it" for function in found if function not in known]


def unrun(rows):
    """What is wrong with transcriptions: each is run beside its function, on a million inputs or more."""
    run = {(row.formula, row.function) for row in rows if row.tool == "enumeration" and row.checks >= MILLION}
    return [f"{row.id}: no row of an enumeration has formula = \"{row.id}\" and runs {row.name} on a million inputs" for row in rows
            if row.tool in ("z3", "gappa") and (row.id, row.function) not in run]


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


# --- what stubs assume ---------------------------------------------------------------------------

BODY = re.compile(r"(?ms)^(?!#)\w[^\n;{}=]*?\b(\w+)\([^;{}]*\)\n\{\n(.*?)^\}")
VARIABLE = re.compile(r"(?<![\w.])(?!sizeof\b|\w+_t\b)[a-z_]\w*(?![\w(])")
# Functions of harnesses whose assumption a row of Z3 states, of integers: its id.
BY_Z3 = {
    "clip/line.c": {"fxl_half_space_distance": "fxl_half_space_distance exact"},
    "clip/volume.c": {"any_su32": "fxl_multiply_su32 bound", "any_s32": "fxl_multiply_s32 bound"},
    "raster/edge.c": {"any_divide": "fxl_edge_divide bound", "some_divide": "fxl_edge_divide bound"},
    "scene/motion_check.c": {"any_product": "fxl_multiply_s64 bound"},
}
# Those whose assumption no row states, and what shows it. None is added, and one that a row states is taken out.
UNSTATED = {
    "clip/clip_by_view.c": {
        "any_fetch": "a vertex that was rotated by unit axes lies below 2^61, by the inequality of Cauchy and Schwarz: rows bound each product alone",
        "fxl_project_inside": "a vertex inside all planes lies on the screen, to half a pixel: make report measures it",
    },
    "clip/intersection.c": {"any_part": "a part of an extent is not longer: a quotient of products, of which the contract has the bound of 28 bits alone"},
    "raster/active_edges.c": {"any_step": "an edge stays between its ends over all rows of a fill: its row states one step, exactly"},
    "raster/chains.c": {"any_trapezoid": "x of an edge that is far from the screen is near it in the rows for which it holds, as fxl_edge is exact"},
    "raster/edge.c": {
        "any_floor": "the floor of a number below 0 is below 0, and not below the number: the contract allows 0, and 1 less",
        "some_quotient": "a dividend of at most 2^14 heights: the contract has the bound of 28 bits",
        "first_of": "the dividend of a first row: the row of fxl_edge_first_dividend asserts its range",
    },
    "scene/cluster_check.c": {"any_dot_units": "the product of two unit vectors, to within their tolerance, by the inequality of Cauchy and Schwarz"},
    "scene/lens.c": {"fxl_sin_q31": "the sine of 10 to 150 degrees is above 1/8: the enumeration runs every angle"},
    "scene/scene_open.c": {"fxl_scene_section": "where an entry lies is what check_place left of the image, no result of the search for it"},
}


def _arguments(text, word):
    """What stands within the brackets of each call of a macro or function."""
    for found in re.finditer(rf"\b{word}\(", text):
        end, depth = found.end(), 1
        while depth:
            depth += (text[end] == "(") - (text[end] == ")")
            end += 1
        yield text[found.end():end - 1]


def _split(words, sign):
    """The parts of an expression between signs that are in no brackets."""
    parts, depth, begin = [], 0, 0
    for place, letter in enumerate(words):
        depth += (letter in "([") - (letter in ")]")
        if not depth and words.startswith(sign, place):
            parts.append(words[begin:place])
            begin = place + len(sign)
    return [*parts, words[begin:]]


def _terms(words, name):
    """{(a term, with marks for its variables: these)} of what an expression says where what stands before its last || is false. What
    the function `name` returns is a variable."""
    words = "".join(words.split()).replace("->", ".").replace("[0]", "").replace("FXL_BELOW", "WITHIN").replace("FXL_RESULT", "result")
    words = re.sub(r"(?<![\w)\]&])[&*](?=[a-z])", "", words)     # a place for what stands there
    for inside in list(_arguments(words, name)):
        words = words.replace(f"{name}({inside})", "result")
    last = _split(words, "||")[-1]
    while last.startswith("(") and next(_arguments(f"x{last}", "x")) == last[1:-1]:
        last = last[1:-1]
    return [(VARIABLE.sub("@", term), VARIABLE.findall(term)) for term in _split(last, "&&")]


def _are_among(terms, said, names):
    """Whether terms are among those that are said, with one name there for each name here."""
    if not terms:
        return True
    text, own = terms[0]
    for other, theirs in said:
        known = {**names, **dict(zip(own, theirs))}
        if text == other and [known[each] for each in own] == theirs and len(set(known.values())) == len(known) and \
                all(known[each] == names[each] for each in names) and _are_among(terms[1:], said, known):
            return True
    return False


def _said_of(row, bodies, library):
    """The terms that a row of CBMC says of its function: by the assertions of its harness, and by its contract."""
    said = [_terms(each.partition('",')[2], row.name) for each in _arguments(bodies(row.place).get(row.harness, ""), "ASSERT")]
    if row.contract:
        words = ("FXL_ENSURES", *(["FXL_EQUATES"] if row.equations else []))
        said += [_terms(each, row.name) for found in re.finditer(rf"\b{row.name}\([^;{{]*", library) for word in words for each in _arguments(found[0], word)]
    return [term for terms in said for term in terms]


def assumptions(root, rows):
    """[(ROOM/FILE.c, a function of it, for which function it is called)] of those that assume what no row of this one says in the same words."""
    texts = {}

    def bodies(place):
        if place not in texts:
            texts[place] = dict(BODY.findall(place.read_text(encoding="utf-8")))
        return texts[place]

    library = "\n".join(path.read_text(encoding="utf-8") for path in sorted((pathlib.Path(root) / "lib").rglob("*.[ch]")))
    proved, exact = [row for row in rows if row.tool == "cbmc"], {(row.name, row.id) for row in rows if row.tool == "z3"}
    some = dict.fromkeys((row.place, to, name) for row in proved for name, to in (*row.stands_in.items(), *((name, name) for name in row.stubs)))
    found = []
    for place, to, name in some:
        assumed = [_terms(each, name) for each in _arguments(bodies(place).get(to, ""), "ASSUME")]
        said = [_said_of(row, bodies, library) for row in proved if row.name == name] if assumed else []
        by_z3 = BY_Z3.get(f"{place.parent.name}/{place.name}", {}).get(to)
        if (name, by_z3) in exact:
            continue
        if not all(any(_are_among(terms, each, {}) for each in said) for terms in assumed):
            found.append((f"{place.parent.name}/{place.name}", to, name))
    return found


def check_assumptions(root, rows):
    """Refuses a function of a harness that assumes what no row says."""
    for place, to, name in assumptions(root, rows):
        if to not in UNSTATED.get(place, {}):
            raise ToolError(f"{PROOFS}/{place}: {to} assumes what no row of {name} asserts in the same words: assert it in the harness of one, or "
                            "in its contract by FXL_ENSURES, and assume no more")
