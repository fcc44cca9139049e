# SPDX-License-Identifier: MIT
"""The clauses of the specification, their ids, and the record of which id has which text.

A clause begins a line of SPEC.md or of a page below docs/ with its number in bold: "**4.5 Facing.** A face ...". Its id
is the page's name and the number: "SPEC 4.5", "beams 2.2". Behind the number "(informative)" marks a clause that only
explains. All others are normative: code and a test must have their ids.

The record, host_tests/build/trace/clauses.txt, has the first words of each clause. A clause whose words stand at another
id there was renumbered, and what cites the id would speak of another clause.
"""

import dataclasses
import pathlib
import re

from fixel.base.errors import ToolError

PAGES = ("SPEC.md", "docs/*.md", "docs/extras/*.md")
RECORD = pathlib.Path("host_tests/build/trace/clauses.txt")
BEGIN = re.compile(r"^(?:[*-] )?\*\*(\d+(?:\.\d+)+)( [^*]*)?\*\*[ .,]*(\(informative\))?(.*)$")
MARKUP = re.compile(r"\[([^\]]*)\]\([^)]*\)|[*`]|(\|)")
WORDS = 8       # of a clause in the record
NUMBERS = r"\d+(?:\.\d+)+"
HEAD = """# SPDX-License-Identifier: MIT
# The first words of each clause, by its id: make trace fails where a clause has another number than here.
# make trace ACCEPT=1 adds new clauses and takes other words; a clause keeps its number.
"""


@dataclasses.dataclass(frozen=True)
class Clause:
    """A clause, where it stands, and its first words."""
    id: str
    file: str
    line: int
    words: str
    normative: bool


def place(id_):
    """For sorting: SPEC first, then pages by name, numbers as numbers."""
    page, number = id_.split(" ")
    return page != "SPEC", page, [int(part) for part in number.split(".")]


def _plain(text):
    return MARKUP.sub(lambda match: match[1] or " " * bool(match[2]), text)


def _words(title, text, after):
    """The first words, without what Markdown adds; of the lines after, if the clause's own line has too few."""
    found = _plain(f"{title or ''} {text}").split()
    for line in after:
        if len(found) >= WORDS or not line.strip() or BEGIN.match(line):
            break
        found += _plain(line).split()
    return " ".join(found[:WORDS])


def of_text(file, text):
    """The clauses of a page."""
    lines, page = text.splitlines(), pathlib.PurePath(file).stem
    matches = [(number, BEGIN.match(line)) for number, line in enumerate(lines, 1)]
    return [Clause(f"{page} {match[1]}", file, number, _words(match[2], match[4], lines[number:number + 3]), match[3] is None)
            for number, match in matches if match]


def read(root):
    """{id: clause} of all pages."""
    found, root = {}, pathlib.Path(root)
    for path in (path for pattern in PAGES for path in sorted(root.glob(pattern))):
        for clause in of_text(path.relative_to(root).as_posix(), path.read_text(encoding="utf-8")):
            if clause.id in found:
                raise ToolError(f"{clause.file}:{clause.line}: the clause {clause.id} stands at line {found[clause.id].line} "
                                "already; give this one a number of its own")
            found[clause.id] = clause
    return dict(sorted(found.items(), key=lambda pair: place(pair[0])))


def ids_of(text, pages):
    """The ids of a tag's text: "SPEC 4.5, 4.6, beams 2.2". None if the text is anything else."""
    found, page = [], None
    for part in re.split(r"[,;] ?| (?=[A-Za-z])", text.strip()):
        match = re.fullmatch(rf"(?:([A-Za-z_0-9]+) )?({NUMBERS})", part) if part else None
        page = (match[1] or page) if match else None
        if page not in pages:
            return None
        found.append(f"{page} {match[2]}")
    return found


# --- the record --------------------------------------------------------------------

def recorded(root):
    """{id: first words} of the record."""
    try:
        lines = (pathlib.Path(root) / RECORD).read_text(encoding="utf-8").splitlines()
    except OSError as error:
        raise ToolError(f"{RECORD}: cannot be read: {error.strerror}; make trace ACCEPT=1 writes it") from error
    pairs = [line.split(": ", 1) for line in lines if line and not line.startswith("#")]
    if any(len(pair) != 2 for pair in pairs):
        raise ToolError(f"{RECORD}: a line is not 'id: first words'; make trace ACCEPT=1 writes it anew")
    return {id_: words for id_, words in pairs}


def renumbered(found, record):
    """Sentences on clauses that stand at another id in the record."""
    ids = {}
    for id_, words in record.items():
        ids.setdefault(words, []).append(id_)
    return [f"{clause.file}:{clause.line}: {clause.id} was {' and '.join(ids[clause.words])}: give it that number again, "
            "and a number that was never used to a new clause"
            for clause in found.values() if clause.words in ids and clause.id not in ids[clause.words]]


def differences(found, record):
    """Sentences on clauses that are renumbered, new, gone, or begin with other words."""
    wrong = renumbered(found, record)
    moved = {":".join(words.split(":")[:2]) for words in wrong}
    for clause in found.values():
        at = f"{clause.file}:{clause.line}"
        if at in moved:
            continue
        if clause.id not in record:
            wrong.append(f"{at}: {clause.id} is not in {RECORD}: run make trace ACCEPT=1")
        elif clause.words != record[clause.id]:
            wrong.append(f"{at}: {clause.id} begins with other words than in {RECORD}: if it says the same, "
                         "run make trace ACCEPT=1; if it is another clause, give it a number that was never used")
    wrong += [f"{RECORD}: {id_} is there no more: put the clause back, or take its line out of the record and do not use "
              "its number again" for id_ in record if id_ not in found]
    return wrong


def record_text(found):
    """The record's text."""
    return HEAD + "".join(f"{clause.id}: {clause.words}\n" for clause in found.values())
