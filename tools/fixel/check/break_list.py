# SPDX-License-Identifier: MIT
"""The breaks of fixel breaks: host_tests/build/breaks.toml. Each replaces a text, which its file has once, by another."""

import dataclasses
import pathlib
import tomllib

from fixel.base.errors import ToolError

LIST = pathlib.Path("host_tests/build/breaks.toml")
KINDS = ("clause", "contract", "bound", "coverage")
COMMANDS = ("make test", "make trace", "make prove", "make report", "make coverage", "make rules")


@dataclasses.dataclass(frozen=True)
class Break:
    """A text of a file, what it becomes, and the command that must fail then and name something. It is made as a seeded
    bug (bugs.py) and as a mutant (mutate.py) are."""
    id: str
    kind: str
    file: str
    old: str
    new: str
    what: str       # the break is
    command: str
    names: str      # a clause, a function, a claim or a rule

    def seed(self, text):
        """The file's text with the break."""
        if text.count(self.old) != 1:
            raise ToolError(f"break '{self.id}': {self.file} has its text {text.count(self.old)} times")
        return text.replace(self.old, self.new)

    apply = seed

    def __str__(self):
        return f"break '{self.id}'"


def read(root):
    """All breaks."""
    path = pathlib.Path(root) / LIST
    try:
        found = tomllib.loads(path.read_text(encoding="utf-8")).get("break", [])
    except (OSError, tomllib.TOMLDecodeError) as error:
        raise ToolError(f"{path}: cannot be read: {error}") from error
    fields = {field.name for field in dataclasses.fields(Break)}
    for number, entry in enumerate(found, 1):
        if entry.keys() != fields or not all(isinstance(value, str) for value in entry.values()):
            raise ToolError(f"{path}: break {number}: it needs the texts {', '.join(sorted(fields))}, and nothing else")
        if entry["kind"] not in KINDS or entry["command"] not in COMMANDS:
            raise ToolError(f"{path}: break {number}: kind is one of {', '.join(KINDS)}, command one of {', '.join(COMMANDS)}")
    ids = [entry["id"] for entry in found]
    twice = sorted({each for each in ids if ids.count(each) > 1})
    if twice or not found:
        raise ToolError(f"{path}: two breaks have the id '{twice[0]}'" if twice else f"{path}: holds no [[break]]")
    return [Break(**entry) for entry in found]


def stale(root, breaks):
    """{id: a sentence} of the breaks that cannot be made: their file is gone, or does not have their text once."""
    wrong = {}
    for each in breaks:
        path = pathlib.Path(root) / each.file
        count = path.read_text(encoding="utf-8").count(each.old) if path.is_file() else None
        if count != 1:
            wrong[each.id] = f"{each.id}: {each.file} is gone" if count is None else f"{each.id}: {each.file} has its text {count} times"
    return wrong
