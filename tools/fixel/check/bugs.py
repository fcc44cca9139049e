# SPDX-License-Identifier: MIT
"""The bugs that fixel seeded-bugs puts into the library, and the lines that they stand on.

A line of the library is marked by a comment at its end, or by one alone on the line before:

    screen->y = centre_y - y; /* bug: screen-y-up */

host_tests/build/seeded_bugs/bugs.toml says what the line becomes.
"""

import dataclasses
import pathlib
import re
import tomllib

from fixel.base.errors import ToolError

BUGS = pathlib.Path("host_tests/build/seeded_bugs/bugs.toml")
LIBRARY = pathlib.Path("lib")
SOURCES = (".c", ".h", ".S")
MARKER = re.compile(r"/\* bug: (\S+) \*/")
# A whole line: its indentation, the code, the marker, and what goes on with a macro.
MARKED = r"^(?P<indent>[ \t]*)(?P<code>[^\n]*?)[ \t]*/\* bug: {} \*/(?P<macro>[ \t]*\\?)\n"
FIELDS = {"marker": str, "name": str, "kind": str, "becomes": str, "why": str, "tests": list}


@dataclasses.dataclass
class Bug:
    """A line and the same line with a mistake, and which tests are likeliest to see it."""
    marker: str
    name: str
    kind: str
    becomes: str
    why: str
    tests: list
    file: str

    def seed(self, text):
        """The text of the bug's file with the bug in it."""
        match = re.search(MARKED.format(re.escape(self.marker)), text, re.MULTILINE)
        if not match:
            raise ToolError(f"bug '{self.marker}': {self.file} has no line that ends with its marker")
        begin, end = match.span()
        if not match["code"]:   # the marker stands alone, and marks the next line
            begin, end = end, text.index("\n", end) + 1
        lines = "".join(f"{match['indent']}{line}\n" for line in self.becomes.splitlines())
        return text[:begin] + lines + text[end:]


def markers(root):
    """{marker: [file]} of all markers in the library."""
    found = {}
    for path in sorted((pathlib.Path(root) / LIBRARY).rglob("*")):
        if path.suffix in SOURCES:
            for name in MARKER.findall(path.read_text(encoding="utf-8")):
                found.setdefault(name, []).append(path.relative_to(root).as_posix())
    return found


def read(root):
    """The bugs. Each must have its place in the library as it is, and each marker there its bug."""
    path = pathlib.Path(root) / BUGS
    try:
        entries = tomllib.loads(path.read_text(encoding="utf-8")).get("bug", [])
    except (OSError, tomllib.TOMLDecodeError) as error:
        raise ToolError(f"{path}: cannot be read: {error}") from error
    marked = markers(root)
    bugs = [_bug(entry, number, path, marked) for number, entry in enumerate(entries)]
    if not bugs:
        raise ToolError(f"{path}: holds no [[bug]]")
    names = [bug.marker for bug in bugs]
    for name in sorted({name for name in names if names.count(name) > 1}):
        raise ToolError(f"{path}: two bugs have the marker '{name}'")
    for name in sorted(set(marked) - set(names)):
        raise ToolError(f"{', '.join(marked[name])}: marker '{name}' has no bug in {BUGS}")
    for bug in bugs:
        _check_place(root, bug)
    return bugs


def _bug(entry, number, path, marked):
    for field, kind in FIELDS.items():
        if not isinstance(entry.get(field), kind):
            raise ToolError(f"{path}: bug {number}: '{field}' is missing or no {kind.__name__}")
    if set(entry) != set(FIELDS):
        raise ToolError(f"{path}: bug {number}: unknown {', '.join(sorted(set(entry) - set(FIELDS)))}")
    places = marked.get(entry["marker"], [])
    if len(places) != 1:
        where = f": {', '.join(places)}" if places else ""
        raise ToolError(f"bug '{entry['marker']}': its marker is in {LIBRARY}/ {len(places)} times, not once{where}")
    return Bug(file=places[0], **entry)


def _check_place(root, bug):
    text = (pathlib.Path(root) / bug.file).read_text(encoding="utf-8")
    if bug.seed(text) == text:
        raise ToolError(f"bug '{bug.name}': it changes nothing in {bug.file}")
