# SPDX-License-Identifier: MIT
"""The breaks of host_tests/breaks, a ledger a room of the library, and how each is put into a copy of the checkout.

The head of an entry has the file, the function and the id. The function may also be a macro, a table of constants, a label
of assembly, or a heading of a document: the last definition that begins at or above the line. An entry finds its lines by
the function and their text, wherever they stand; if the function has left the file, in the one file that has them. The
text of a line is what stands between its indentation and the comments at its end, without the backslash with which a macro
goes on. A line that is a comment and no more is known by that comment.
"""

import concurrent.futures
import contextlib
import dataclasses
import difflib
import functools
import pathlib
import queue
import re
import threading
import tomllib

from fixel.base.errors import ToolError
from fixel.base.progress import Progress

FOLDER = pathlib.Path("host_tests/breaks")
LIBRARY = pathlib.Path("lib")
SOURCES = (".c", ".h", ".S")
NEEDED = {"line": str, "becomes": str, "why": str}
OPTIONAL = {"kind": str, "occurrence": int, "tests": list, "rows": list, "clause": str, "blind": bool, "command": str, "names": str}
BLIND = {"blind", "kind", "command", "names"}           # what a blind entry has; it names nothing of the tests
BLIND_KINDS = ("clause", "contract", "bound", "coverage")
COMMANDS = ("make test", "make trace", "make prove", "make report", "make coverage", "make rules")

MACRO = re.compile(r"#\s*define\s+(\w+)")
IS_ASSEMBLY = re.compile(r"^\s*(?:\w+\s+\.req|\.macro|\.global)\s", re.MULTILINE)
IS_DOCUMENT = re.compile(r"\A(?:<!--.*?-->\s*)?# ", re.DOTALL)
ASSEMBLY = re.compile(r"([A-Za-z_]\w*):|\s*\.macro\s+(\w+)")
HEADING = re.compile(r"#+ (.*)")
C = re.compile(r"(?=[A-Za-z]).*?(\w+)\s*(?:[(\[={;]|$)")   # its name stands on the first line that is not indented
ATTRIBUTE = re.compile(r"__attribute__\s*\(\(.*?\)\)\s*")
END = re.compile(r"(?:\s*/\*(?:(?!\*/).)*\*/)*\s*\\?$")     # comments, and what goes on with a macro


def text_of(line):
    """The text by which a line is known."""
    return END.sub("", line).strip() or line.strip()


@functools.cache
def functions(text):
    """The name of the function, or of the other definition, that each line of a file is in."""
    definition = ASSEMBLY if IS_ASSEMBLY.search(text) else HEADING if IS_DOCUMENT.match(text) else C
    function, macro, found = "", "", []
    for line in text.splitlines():
        if not macro:
            begun = MACRO.match(line)
            macro = begun[1] if begun else ""
            begun = None if macro else definition.match(ATTRIBUTE.sub("", line))
            function = begun[begun.lastindex] if begun else function
        found.append(macro or function)
        macro = macro if line.endswith("\\") else ""
    return found


@functools.cache
def _texts(text):
    """What each line of a file is known by."""
    return [text_of(line) for line in text.splitlines()]


@dataclasses.dataclass(frozen=True)
class Break:
    """Lines of a function, the same lines with a mistake, and who must notice it."""
    file: str
    function: str
    id: str
    line: str               # or several, one below the other
    becomes: str
    why: str
    ledger: str
    kind: str = ""
    occurrence: int = 0     # counted from 1; 0: the lines stand once
    tests: tuple = ()       # of the host, or m3/TEST, equality/CORE or run/SCENE, that are likeliest to see it
    rows: tuple = ()        # of make prove that must fail
    clause: str = ""        # of the specification, that it breaks: "SPEC 4.5", or several
    blind: bool = False     # written by somebody who had not read the tests: make breaks draws these
    command: str = ""       # of a blind one: which must fail
    names: str = ""         # and what it must name: a clause, a function, a claim or a rule

    def __str__(self):
        return f"{'break' if self.blind else 'seeded bug'} '{self.id}'"

    def is_called(self, word):
        """Whether a user means it by ONLY=."""
        return word in f"{self.id} {self.kind} {self.file}"

    def places(self, text):
        """The numbers of the lines, counted from 0, with which its lines begin in a file's text."""
        names, known = functions(text), _texts(text)
        wanted = [text_of(line) for line in self.line.splitlines()]
        return [number for number, name in enumerate(names)
                if name == self.function and known[number:number + len(wanted)] == wanted]

    def apply(self, text):
        """The text of its file with the mistake."""
        lines, places = text.splitlines(), self.places(text)
        if not places or (len(places) > 1) != (self.occurrence > 0) or self.occurrence > len(places):
            raise ToolError(f"{self}: {self.file}: {self._count(places)}")
        number = places[max(self.occurrence, 1) - 1]
        line = lines[number]
        indent, end = line[:len(line) - len(line.lstrip())], " \\" if line.endswith("\\") else ""
        lines[number:number + len(self.line.splitlines())] = [f"{indent}{each}{end}" for each in self.becomes.splitlines()]
        broken = "".join(f"{each}\n" for each in lines)
        if broken == text:
            raise ToolError(f"{self}: it changes nothing in {self.file}")
        return broken

    def _count(self, places):
        """What is wrong with so many places."""
        if len(places) > 1:
            return f"{self.function} has the line '{self.line}' {len(places)} times: give occurrence = 1 to {len(places)}"
        if places:
            return f"{self.function} has the line '{self.line}' once: leave occurrence out"
        return f"{self.function} has no line '{self.line}'"


# --- all breaks ------------------------------------------------------------------

def sources(root):
    """{file: text} of the library."""
    root = pathlib.Path(root)
    return {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8")
            for path in sorted((root / LIBRARY).rglob("*")) if path.suffix in SOURCES}


def entries(root):
    """The breaks of all ledgers, whether they apply or not, each with the file in which its lines are now."""
    texts, found = sources(root), {}
    for path in sorted((pathlib.Path(root) / FOLDER).glob("*.toml")):
        for each in _entries_of(path):
            if each.id in found:
                raise ToolError(f"{path}: there is an entry '{each.id}' in {found[each.id].ledger}, too")
            found[each.id] = _where_it_is(each, root, texts)
    if not found:
        raise ToolError(f"{pathlib.Path(root) / FOLDER}: has no *.toml with an entry [\"FILE\".FUNCTION.ID]")
    return list(found.values())


def _entries_of(path):
    try:
        found = tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, tomllib.TOMLDecodeError) as error:
        raise ToolError(f"{path}: cannot be read: {error}") from error
    for file, of_file in found.items():
        for function, named in _tables(path, of_file):
            for id_, entry in _tables(path, named):
                _check(f"{path}: '{id_}'", entry)
                lists = {key: tuple(entry[key]) for key in ("tests", "rows") if key in entry}
                yield Break(file, function, id_, ledger=(FOLDER / path.name).as_posix(), **entry | lists)


def _tables(path, table):
    """What a part of the head of entries has below it."""
    if not isinstance(table, dict) or not table or not all(isinstance(each, dict) for each in table.values()):
        raise ToolError(f'{path}: the head of an entry is ["FILE".FUNCTION.ID]')
    return table.items()


def _check(where, entry):
    """Refuses an entry that lacks something, or has what it must not have."""
    for key, kind in (NEEDED | OPTIONAL).items():
        if key in NEEDED and key not in entry or key in entry and type(entry[key]) is not kind:
            raise ToolError(f"{where}: '{key}' is missing or no {kind.__name__}")
    unknown = sorted(set(entry) - set(NEEDED) - set(OPTIONAL))
    if unknown:
        raise ToolError(f"{where}: unknown {', '.join(unknown)}")
    if entry.get("occurrence", 1) < 1:
        raise ToolError(f"{where}: 'occurrence' is no whole number from 1 on")
    has = {key for key in entry if key not in NEEDED and key != "occurrence"}
    if entry.get("blind"):
        if has != BLIND:
            raise ToolError(f"{where}: a blind entry has {', '.join(sorted(BLIND))} and nothing of the tests: no tests, rows or clause")
        if entry["kind"] not in BLIND_KINDS or entry["command"] not in COMMANDS:
            raise ToolError(f"{where}: kind is one of {', '.join(BLIND_KINDS)}, command one of {', '.join(COMMANDS)}")
    elif has & BLIND - {"kind"} or not (entry.get("tests") or entry.get("rows")):
        raise ToolError(f"{where}: give tests or rows that must notice it; command and names are of entries with blind = true")


def _where_it_is(each, root, texts):
    """The break with the file that has its lines: the one that it names, or else the only one."""
    path = pathlib.Path(root) / each.file
    if each.file not in texts and path.is_file():
        texts[each.file] = path.read_text(encoding="utf-8")
    if each.places(texts.get(each.file, "")):
        return each
    files = [file for file, text in texts.items() if each.places(text)]
    return dataclasses.replace(each, file=files[0]) if len(files) == 1 else each


def stale(root, breaks):
    """{id: a sentence} of the breaks that do not apply to the checkout as it is."""
    texts, wrong = sources(root), {}
    for each in breaks:
        path = pathlib.Path(root) / each.file
        if each.file not in texts and path.is_file():
            texts[each.file] = path.read_text(encoding="utf-8")
        try:
            if each.file not in texts:
                raise ToolError(f"{each}: there is no {each.file}")
            each.apply(texts[each.file])
        except ToolError as error:
            wrong[each.id] = f"{each.ledger}: {error.message}{_probable(each, texts)}"
    return wrong


def _probable(each, texts):
    """Which line a break that finds its own no more probably means."""
    files = [file for file, text in texts.items() if each.places(text)]
    if files:
        return f"; it stands in {', '.join(files)}: name that file" if each.file not in files else ""
    text, first = texts.get(each.file, ""), text_of((each.line.splitlines() or [""])[0])
    for numbers in ([number for number, name in enumerate(functions(text)) if name == each.function], range(len(_texts(text)))):
        near = difflib.get_close_matches(first, [_texts(text)[number] for number in numbers], 1)
        if near:
            number = next(number for number in numbers if _texts(text)[number] == near[0])
            return f"; it probably means line {number + 1}, in {functions(text)[number] or 'no function'}: '{near[0]}'"
    return ""


def read(root, is_wanted):
    """The breaks that are wanted, each of which applies."""
    breaks = [each for each in entries(root) if is_wanted(each)]
    wrong = stale(root, breaks)
    if wrong:
        raise ToolError(f"{FOLDER}: {len(wrong)} of {len(breaks)} entries do not apply", words="\n".join(wrong.values()))
    return breaks


def seeded(root):
    """Those that tests must notice."""
    return read(root, lambda each: each.tests)


def of_rows(root):
    """Those that rows of make prove must notice."""
    return read(root, lambda each: each.rows)


# --- planting ----------------------------------------------------------------------

@contextlib.contextmanager
def planted(folder, breaks, write=None):
    """Within it a copy has breaks, or mutants, of different files. write: puts a text into a file of the copy."""
    folder = pathlib.Path(folder)
    write = write or (lambda file, text: (folder / file).write_text(text, encoding="utf-8"))
    good = {each.file: (folder / each.file).read_text(encoding="utf-8") for each in breaks}
    try:
        for each in breaks:
            write(each.file, each.apply(good[each.file]))
        yield
    finally:
        for file, text in good.items():
            write(file, text)


def try_all(name, breaks, copies, attempt):
    """attempt(copy, break) of each, in their order; one thread at a time has a copy."""
    free, done, lock = queue.SimpleQueue(), [], threading.Lock()
    for folder in copies:
        free.put(folder)

    def one(each):
        folder = free.get()
        try:
            return attempt(folder, each)
        finally:
            free.put(folder)
            with lock:
                done.append(each)
                progress(len(done))

    with Progress(name, len(breaks)) as progress, concurrent.futures.ThreadPoolExecutor(len(copies)) as pool:
        return list(pool.map(one, breaks))
