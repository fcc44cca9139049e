# SPDX-License-Identifier: MIT
"""The bugs that fixel seeded-bugs puts into the library, and the lines that they replace.

An entry of host_tests/build/seeded_bugs/bugs.toml names a file, a function and the text of a line. The function may also
be a macro, a table of constants, or a label of assembly: the last definition that begins at or above the line. The text
of a line is what stands between its indentation and the comments at its end. It leaves out the backslash with which a
macro goes on. If a function has a line twice, the entry says which of them it replaces.
"""

import dataclasses
import functools
import pathlib
import re
import tomllib

from fixel.base.errors import ToolError

BUGS = pathlib.Path("host_tests/build/seeded_bugs/bugs.toml")
PROOFS_BUGS = pathlib.Path("host_tests/proofs/bugs.toml")
LIBRARY = pathlib.Path("lib")
SOURCES = (".c", ".h", ".S")
FIELDS = {"id": str, "name": str, "kind": str, "file": str, "function": str, "line": str, "becomes": str, "why": str,
          "tests": list}
OPTIONAL = {"occurrence": int, "clause": str, "prove": str}

MACRO = re.compile(r"#\s*define\s+(\w+)")
IS_ASSEMBLY = re.compile(r"^\s*(?:\w+\s+\.req|\.macro|\.global)\s", re.MULTILINE)
ASSEMBLY = re.compile(r"([A-Za-z_]\w*):|\s*\.macro\s+(\w+)")
C = re.compile(r"(?=[A-Za-z]).*?(\w+)\s*(?:[(\[={;]|$)")   # its name stands on the first line that is not indented
END = re.compile(r"(?:\s*/\*(?:(?!\*/).)*\*/)*\s*\\?$")     # comments, and what goes on with a macro


def text_of(line):
    """The text by which a line is known."""
    return END.sub("", line).strip()


@functools.cache
def functions(text):
    """The name of the function, or of the other definition, that each line of a file is in."""
    definition = ASSEMBLY if IS_ASSEMBLY.search(text) else C
    function, macro, found = "", "", []
    for line in text.splitlines():
        if not macro:
            begun = MACRO.match(line)
            macro = begun[1] if begun else ""
            begun = None if macro else definition.match(line)
            function = begun[begun.lastindex] if begun else function
        found.append(macro or function)
        macro = macro if line.endswith("\\") else ""
    return found


@dataclasses.dataclass
class Bug:
    """A line and the same line with a mistake, and which tests are likeliest to see it."""
    id: str
    name: str
    kind: str
    file: str
    function: str
    line: str
    becomes: str
    why: str
    tests: list
    occurrence: int = 0     # counted from 1; 0: the line stands once
    clause: str = ""        # of the specification, that the bug breaks: "SPEC 4.5", or several (trace.py)
    prove: str = ""         # the row of make prove that must fail with the bug

    def places(self, text):
        """The numbers of the lines of a file's text that have the bug's function and text, counted from 0."""
        return [number for number, (line, function) in enumerate(zip(text.splitlines(), functions(text)))
                if function == self.function and text_of(line) == self.line]

    def seed(self, text):
        """The text of the bug's file with the bug in it."""
        lines, places = text.splitlines(), self.places(text)
        if not places or (len(places) > 1) != (self.occurrence > 0) or self.occurrence > len(places):
            raise ToolError(f"bug '{self.id}': {self.file}: {self._count(places)}")
        number = places[max(self.occurrence, 1) - 1]
        line = lines[number]
        indent, end = line[:len(line) - len(line.lstrip())], " \\" if line.endswith("\\") else ""
        lines[number:number + 1] = [f"{indent}{each}{end}" for each in self.becomes.splitlines()]
        seeded = "".join(f"{each}\n" for each in lines)
        if seeded == text:
            raise ToolError(f"bug '{self.id}': it changes nothing in {self.file}")
        return seeded

    def _count(self, places):
        """What is wrong with so many places."""
        if len(places) > 1:
            return f"{self.function} has the line '{self.line}' {len(places)} times: give occurrence = 1 to {len(places)}"
        if places:
            return f"{self.function} has the line '{self.line}' once: leave occurrence out"
        return f"{self.function} has no line '{self.line}'"


# --- all bugs ------------------------------------------------------------------

def sources(root):
    """{file: text} of the library."""
    root = pathlib.Path(root)
    return {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8")
            for path in sorted((root / LIBRARY).rglob("*")) if path.suffix in SOURCES}


def _wrong(bug, texts):
    """Why a bug does not apply, and where else it would; None if it does."""
    words = f"bug '{bug.id}': there is no {bug.file}"
    if bug.file in texts:
        try:
            bug.seed(texts[bug.file])
            return None
        except ToolError as error:
            words = error.message
    others = [file for file, text in texts.items() if file != bug.file and bug.places(text)]
    return f"{words}; it stands in {', '.join(others)} now: name that file" if others else words


def stale(root, bugs):
    """A sentence for each bug that does not apply to the library as it is."""
    texts = sources(root)
    return [words for words in (_wrong(bug, texts) for bug in bugs) if words]


def entries(root):
    """The bugs of the table, whether they apply or not."""
    path = pathlib.Path(root) / BUGS
    try:
        found = tomllib.loads(path.read_text(encoding="utf-8")).get("bug", [])
    except (OSError, tomllib.TOMLDecodeError) as error:
        raise ToolError(f"{path}: cannot be read: {error}") from error
    bugs = [_bug(entry, number, path) for number, entry in enumerate(found)]
    if not bugs:
        raise ToolError(f"{path}: holds no [[bug]]")
    names = [bug.id for bug in bugs]
    for name in sorted({name for name in names if names.count(name) > 1}):
        raise ToolError(f"{path}: two bugs have the id '{name}'")
    return bugs


def _bug(entry, number, path):
    for field, kind in FIELDS.items():
        if not isinstance(entry.get(field), kind):
            raise ToolError(f"{path}: bug {number}: '{field}' is missing or no {kind.__name__}")
    unknown = sorted(set(entry) - set(FIELDS) - set(OPTIONAL))
    if unknown:
        raise ToolError(f"{path}: bug {number}: unknown {', '.join(unknown)}")
    if type(entry.get("occurrence", 1)) is not int or entry.get("occurrence", 1) < 1:
        raise ToolError(f"{path}: bug {number}: 'occurrence' is no whole number from 1 on")
    if not isinstance(entry.get("clause", ""), str):
        raise ToolError(f"{path}: bug {number}: 'clause' is no text")
    return Bug(**entry)


def of_proofs(root):
    """The bugs that rows of make prove must notice: those of the table that name a row, and those of host_tests/proofs."""
    path = pathlib.Path(root) / PROOFS_BUGS
    try:
        found = tomllib.loads(path.read_text(encoding="utf-8")).get("bug", [])
    except (OSError, tomllib.TOMLDecodeError) as error:
        raise ToolError(f"{path}: cannot be read: {error}") from error
    own = [_bug({"name": entry.get("why"), "kind": "proof", "tests": [], **entry}, number, path) for number, entry in enumerate(found)]
    bugs = [bug for bug in entries(root) if bug.prove] + own
    wrong = stale(root, bugs)
    if wrong:
        raise ToolError(f"{PROOFS_BUGS}: {len(wrong)} of {len(bugs)} bugs do not apply to {LIBRARY}/", words="\n".join(wrong))
    return bugs


def read(root):
    """The bugs, each of which applies to the library as it is."""
    bugs = entries(root)
    wrong = stale(root, bugs)
    if wrong:
        raise ToolError(f"{BUGS}: {len(wrong)} of {len(bugs)} bugs do not apply to {LIBRARY}/", words="\n".join(wrong))
    return bugs
