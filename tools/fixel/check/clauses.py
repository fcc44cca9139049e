# SPDX-License-Identifier: MIT
"""The clauses of the specification, their ids, and the record of which id has which text.

A clause begins a line of SPEC.md or of a page below docs/ with its number in bold: "**4.5 Facing.** A face ...". Its id
is the page's name and the number: "SPEC 4.5", "beams 2.2". Behind the number "(informative)" marks a clause that only
explains. All others are normative: code and a test must have their ids.

The record, host_tests/build/trace/clauses.txt, has the first words of each clause and of each of its sentences (sentences.py).
A clause whose words stand at another id there was renumbered, and what cites the id would speak of another clause.

Tags say which clauses a function, a block or a test is about. In C and assembly a tag is a comment of ids alone on a line:
/* SPEC 4.5 */ or /* SPEC 4.5, 4.6b-d, beams 2.2 */. It stands above a function or a block, and is about the lines from there to the
next tag, at most to the end of the function. Above a test of host_tests/ it is about that test. In Python it is a comment
(# formats 1.2) above a function or block; a test has it in its docstring: formats 1.2.
"""

import ast
import dataclasses
import itertools
import pathlib
import re
import string

from fixel.base import output
from fixel.base.errors import ToolError
from fixel.check import sentences

PAGES = ("SPEC.md", "docs/*.md", "docs/extras/*.md")
RECORD = pathlib.Path("host_tests/build/trace/clauses.txt")
BEGIN = re.compile(r"^(?:[*-] )?\*\*(\d+(?:\.\d+)+)( [^*]*)?\*\*[ .,]*(\(informative\))?(.*)$")
MARKUP = re.compile(r"\[([^\]]*)\]\([^)]*\)|[*`]|(\|)")
WORDS = 8       # of a clause in the record
NUMBERS = r"\d+(?:\.\d+)+[a-z]*"
RANGE = rf"{NUMBERS}(?:-[a-z]+)?"       # of a clause's sentences: "4.3b-d"
ENTRY = re.compile(rf"(\w+ {NUMBERS})(?:, ({'|'.join(sentences.STATES[1:])}))?: (.*)")
HEAD = """# SPDX-License-Identifier: MIT
# The first words of each clause, and of each of its sentences, by their ids: make trace fails where one has another id than here.
# make trace ACCEPT=1 adds new ones and takes other words; each keeps its id. ", prose" is a sentence that demands nothing,
# ", open" one that no test has a tag of yet. A new sentence has a test, or you write ", prose".
"""
CODE = ("lib", "boards", "firmware", "tools/fixel", "host_tests/judges")
JUDGED = "accuracy"     # the page that says what the judges do: their code is code of this page alone
TESTS = "host_tests"
C_SUFFIXES = (".c", ".h", ".S")
C_TAG = re.compile(r"^[ \t]*/\*[ \t]*(\w+ \d+\.\d[\d., ;\w-]*?)[ \t]*\*/[ \t]*$", re.MULTILINE)
PY_TAG = re.compile(r"^[ \t]*#[ \t]*(\w+ \d+\.\d[\d., ;\w-]*?)[ \t]*$", re.MULTILINE)
C_TEST = re.compile(r"^void (test_\w+)\(void\)")
WORD = re.compile(rf"\b[A-Za-z_0-9]+ {RANGE}\b(?:[,;] (?:[A-Za-z_0-9]+ )?{RANGE}\b)*")


@dataclasses.dataclass(frozen=True)
class Clause:
    """A clause, where it stands, and its first words. sentences: what it demands, one by one; none of an informative one."""
    id: str
    file: str
    line: int
    words: str
    normative: bool
    sentences: tuple = ()


def clause_of(id_):
    """The id of the clause of a sentence's id; of a clause its own."""
    return id_.rstrip(string.ascii_lowercase)


def place(id_):
    """For sorting: SPEC first, then pages by name, numbers as numbers."""
    page, number = id_.split(" ")
    return page != "SPEC", page, [int(part) for part in number.split(".")]


def _plain(text):
    return MARKUP.sub(lambda match: match[1] or " " * bool(match[2]), text)


def _words(text):
    """The first words, without what Markdown adds."""
    return " ".join(_plain(text).split()[:WORDS])


def of_text(file, text):
    """The clauses of a page. The bold words behind a number are the clause's title, and no sentence, if they end as one."""
    lines, page = text.splitlines(), pathlib.PurePath(file).stem
    ends = [number for number, line in enumerate(lines) if BEGIN.match(line) or line.startswith("#")] + [len(lines)]
    found = []
    for number, line in enumerate(lines):
        match = BEGIN.match(line)
        if not match:
            continue
        title = match[2] or ""
        begin = match[4] if title.endswith((".", ":")) else f"{title} {match[4]}"
        body = [begin, *lines[number + 1:min(end for end in ends if end > number)]]
        after = itertools.takewhile(str.strip, body[1:])
        said = sentences.of_lines(list(enumerate(body, number + 1)), _words) if match[3] is None else ()
        found.append(Clause(f"{page} {match[1]}", file, number + 1, _words(" ".join([title, match[4], *after])), match[3] is None,
                            tuple(said)))
    return found


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
    """The ids of a tag's text: "SPEC 4.5, 4.6b-d, beams 2.2". None if the text is anything else."""
    found, page = [], None
    for part in re.split(r"[,;] ?| (?=[A-Za-z])", text.strip()):
        match = re.fullmatch(rf"(?:([A-Za-z_0-9]+) )?({NUMBERS})(?:-([a-z]+))?", part) if part else None
        page = (match[1] or page) if match else None
        if page not in pages:
            return None
        first, last = f"{page} {match[2]}", match[3]
        letters = sentences.between(first.removeprefix(clause_of(first)), last) if last else [""]
        if not letters:
            return None
        found += [(clause_of(first) if last else first) + letter for letter in letters]
    return found


# --- the record --------------------------------------------------------------------

def recorded(root):
    """({id: first words}, {id of a clause: [(letter, state, first words) of a sentence]}) of the record."""
    try:
        lines = (pathlib.Path(root) / RECORD).read_text(encoding="utf-8").splitlines()
    except OSError as error:
        raise ToolError(f"{RECORD}: cannot be read: {error.strerror}; make trace ACCEPT=1 writes it") from error
    found, said = {}, {}
    for line in (line for line in lines if line and not line.startswith("#")):
        match = ENTRY.fullmatch(line)
        if not match:
            raise ToolError(f"{RECORD}: '{line}' is not 'id: first words'; make trace ACCEPT=1 writes it anew")
        id_, state, words = match.groups(default="")
        clause = clause_of(id_)
        if id_ == clause:
            found[id_] = words
        else:
            said.setdefault(clause, []).append((id_.removeprefix(clause), state, words))
    return found, said


def match_sentences(found, said):
    """Gives each sentence the letter that the record has for it. Returns the ids there of which there is none any more."""
    gone = [id_ + letter for id_ in said if id_ not in found for letter, _, _ in said[id_]]
    for clause in found.values():
        gone += [clause.id + letter for letter in sentences.match(clause.sentences, said.get(clause.id, []))]
    return gone


def renumbered(found, record):
    """Sentences on clauses that stand at another id in the record."""
    ids = {}
    for id_, words in record.items():
        ids.setdefault(words, []).append(id_)
    return [f"{clause.file}:{clause.line}: {clause.id} was {' and '.join(ids[clause.words])}: give it that number again, "
            "and a number that was never used to a new clause"
            for clause in found.values() if clause.words in ids and clause.id not in ids[clause.words]]


def differences(found, record, gone):
    """Sentences on clauses that are renumbered, new, gone, or begin with other words, and on sentences likewise."""
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
        else:
            wrong += [f"{clause.file}:{each.line}: '{each.words}' of {clause.id} is not in {RECORD}: run make trace ACCEPT=1"
                      for each in clause.sentences if each.words != each.recorded]
    wrong += [f"{RECORD}: {id_} is there no more: put the clause back, or take its line out of the record and do not use "
              "its number again" for id_ in record if id_ not in found]
    return wrong + [f"{RECORD}: there is no sentence {id_} any more: put it back, or run make trace ACCEPT=1" for id_ in gone]


def record_text(found):
    """The record's text. Each sentence has a letter."""
    lines = []
    for clause in found.values():
        lines.append(f"{clause.id}: {clause.words}\n")
        lines += [f"{clause.id}{each.letter}{', ' * bool(each.state)}{each.state}: {each.words}\n" for each in clause.sentences]
    return HEAD + "".join(lines)


def accept(root, found, said):
    """Takes the record from the pages: new sentences have letters that none has, and no state."""
    for clause in found.values():
        sentences.name_new(clause.sentences, said.get(clause.id, []))
    output.write_file(pathlib.Path(root) / RECORD, record_text(found))


@dataclasses.dataclass(frozen=True)
class Tag:
    """A clause's tag, and the lines that it is about (from 1 on, the last one included). test: the name of a test; of
    pytest as "folder/file.py::name"."""
    id: str
    file: str
    line: int
    last: int
    test: str = ""


def _ids(text, pages, file, line):
    ids = ids_of(text, pages)
    if ids is None and text.split(" ")[0] not in pages and not WORD.fullmatch(text):
        return []       # a comment about something else
    if ids is None:
        raise ToolError(f"{file}:{line}: the tag '{text}' is no list of clauses such as 'SPEC 4.5, 4.6, beams 2.2'; the pages "
                        f"with clauses are {', '.join(sorted(pages))}")
    return ids


def _places(pattern, text, pages, file):
    """[(line, ids)] of the tags of a text."""
    found = []
    for match in pattern.finditer(text):
        line = text.count("\n", 0, match.end()) + 1
        ids = _ids(match[1], pages, file, line)
        if ids:
            found.append((line, ids))
    return found


def c_code(file, text, pages):
    """The tags of a file of C or assembly."""
    lines, places = text.split("\n"), _places(C_TAG, text, pages, file)
    ends = [number for number, line in enumerate(lines, 1) if line.startswith("}")] + [len(lines)]
    nexts = [line - 1 for line, _ in places[1:]] + [len(lines)]
    return [Tag(id_, file, line, min(min((end for end in ends if end > line), default=line), following))
            for (line, ids), following in zip(places, nexts) for id_ in ids]


def c_tests(file, text, pages):
    """The tags of a file of tests in C: each is above a test."""
    lines, found = text.split("\n"), []
    for line, ids in _places(C_TAG, text, pages, file):
        for number in range(line, len(lines)):
            test = C_TEST.match(lines[number])
            if test or lines[number].startswith("}"):
                break
        else:
            test = None
        if not test:
            raise ToolError(f"{file}:{line}: the tag is above no test: put it above 'void test_...(void)'")
        found += [Tag(id_, file, line, number + 1, test[1]) for id_ in ids]
    return found


def python_code(file, text, pages):
    """The tags of a module: to the end of the function or class that begins behind the tag, or that holds it."""
    places = _places(PY_TAG, text, pages, file)
    if not places:
        return []
    blocks = [(node.lineno, node.end_lineno) for node in ast.walk(ast.parse(text))
              if isinstance(node, (ast.FunctionDef, ast.ClassDef))]
    count = text.count("\n") + 1
    nexts = [line - 1 for line, _ in places[1:]] + [count]
    found = []
    for (line, ids), following in zip(places, nexts):
        inside = [last for first, last in blocks if first <= line <= last]
        after = [(first, last) for first, last in blocks if first > line]
        last = min(inside) if inside else min(after)[1] if after else count
        found += [Tag(id_, file, line, min(last, following)) for id_ in ids]
    return found


def python_tests(file, text, pages):
    """The ids in the docstrings of tests."""
    found = []
    if not any(page in text for page in pages):
        return found
    for node in ast.walk(ast.parse(text)):
        words = ast.get_docstring(node) if isinstance(node, ast.FunctionDef) and node.name.startswith("test_") else None
        for match in WORD.finditer(words or ""):
            ids = ids_of(match[0], pages)
            name = f"{file.removeprefix(TESTS + '/')}::{node.name}"
            found += [Tag(id_, file, node.lineno, node.end_lineno, name) for id_ in ids or []]
    return found


def _files(root, folder, suffixes):
    return [path for path in sorted((root / folder).rglob("*")) if path.suffix in suffixes and path.is_file()]


def read_tags(root, pages):
    """([tag of code], [tag of a test]) of a checkout. pages: the names of the pages that have clauses."""
    root, code, tests = pathlib.Path(root), [], []
    for folder in CODE:
        for path in _files(root, folder, (*C_SUFFIXES, ".py")):
            file, text = path.relative_to(root).as_posix(), path.read_text(encoding="utf-8")
            if not path.name.startswith("test_"):
                found = (python_code if path.suffix == ".py" else c_code)(file, text, pages)
                for tag in found if folder.startswith(TESTS) else []:
                    if tag.id.split(" ")[0] != JUDGED:
                        raise ToolError(f"{file}:{tag.line}: the tag '{tag.id}' is in a judge, whose code is that of clauses of "
                                        f"{JUDGED} alone: tag the library's code, or the test")
                code += found
    for path in _files(root, TESTS, (".c", ".py")):
        file, text = path.relative_to(root).as_posix(), path.read_text(encoding="utf-8")
        if path.name.startswith("test_"):
            tests += (python_tests if path.suffix == ".py" else c_tests)(file, text, pages)
    return code, tests
