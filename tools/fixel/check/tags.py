# SPDX-License-Identifier: MIT
"""The tags of code and tests: which clauses a function, a block or a test is about.

In C and assembly a tag is a comment of ids alone on a line: /* SPEC 4.5 */ or /* SPEC 4.5, 4.6, beams 2.2 */. It stands
above a function or a block, and is about the lines from there to the next tag, at most to the end of the function. Above
a test of host_tests/ it is about that test. In Python it is a comment (# formats 1.2) above a function or block; a test
has it in its docstring: formats 1.2.
"""

import ast
import dataclasses
import pathlib
import re

from fixel.base.errors import ToolError
from fixel.check import clauses

CODE = ("lib", "boards", "firmware", "tools/fixel", "host_tests/judges")
JUDGED = "accuracy"     # the page that says what the judges do: their code is code of this page alone
TESTS = "host_tests"
C_SUFFIXES = (".c", ".h", ".S")
C_TAG = re.compile(r"^[ \t]*/\*[ \t]*(\w+ \d+\.\d[\d., ;\w]*?)[ \t]*\*/[ \t]*$", re.MULTILINE)
PY_TAG = re.compile(r"^[ \t]*#[ \t]*(\w+ \d+\.\d[\d., ;\w]*?)[ \t]*$", re.MULTILINE)
C_TEST = re.compile(r"^void (test_\w+)\(void\)")
WORD = re.compile(r"\b[A-Za-z_0-9]+ \d+(?:\.\d+)+(?:[,;] (?:[A-Za-z_0-9]+ )?\d+(?:\.\d+)+)*")


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
    ids = clauses.ids_of(text, pages)
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
            ids = clauses.ids_of(match[0], pages)
            name = f"{file.removeprefix(TESTS + '/')}::{node.name}"
            found += [Tag(id_, file, node.lineno, node.end_lineno, name) for id_ in ids or []]
    return found


def _files(root, folder, suffixes):
    return [path for path in sorted((root / folder).rglob("*")) if path.suffix in suffixes and path.is_file()]


def read(root, pages):
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
