# SPDX-License-Identifier: MIT
"""Small mistakes in C code: which there are in a file, found by the code's text.

A mistake is one of
    a comparison that takes or leaves its limit, or is turned about (< to <=, == to !=)
    + for -, - for +, << for >>, & for |, && for ||, and so on
    a whole number one larger or one smaller
    true for false, a ! left out
    a statement left out: an assignment, a call, ++, --
Comments, strings, preprocessor lines, assertions and numbers outside functions are left alone. So are two changes
that are another choice and no mistake: an array that is declared one larger, and what the build has set
(!FXL_IS_SMALL).

Mutants that change no result stand in a file of the project, with the reason of each. An entry names the file, the text of the line,
the change as a mutant's name has it, and why it changes no result. One whose line or change is no longer there is refused, so that
no reason outlives what it was about.
"""

import dataclasses
import hashlib
import pathlib
import re
import tomllib

from fixel.base.errors import ToolError

SWAPS = {
    "<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<"),
    "==": ("!=",), "!=": ("==",), "&&": ("||",), "||": ("&&",),
    "+": ("-",), "-": ("+",), "*": ("+",), "/": ("*",), "%": ("/",),
    "+=": ("-=",), "-=": ("+=",), "++": ("--",), "--": ("++",),
    "<<": (">>",), ">>": ("<<",), "&": ("|",), "|": ("&",), "^": ("|",), "|=": ("&=", "="), "&=": ("|=", "="),
    "!": ("",), "true": ("false",), "false": ("true",),
}
BINARY_ONLY = {"+", "-", "*", "&"}      # as a sign, a dereference or an address they are not mutated
HIDDEN = re.compile(r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.DOTALL)
LINKAGE = re.compile(r"^#ifdef __cplusplus\n.*?^#endif$", re.DOTALL | re.MULTILINE)    # its braces would hide all functions of a header
PREPROCESSOR = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.MULTILINE)
ASSERTION = re.compile(r"\b(?:FXL_ASSERT|FXL_STATIC_ASSERT)\s*\([^;]*;")
TOKEN = re.compile(r"0[xX][0-9a-fA-F]+[uUlL]*|\d+[uUlL]*|[A-Za-z_]\w*|<<=|>>=|->|\+\+|--|<<|>>|<=|>=|==|!=|"
                   r"&&|\|\||[-+*/%&|^]=|[^\s\w]")
STATEMENT = re.compile(r"(?<=[;{}])(\s*)([^;{}]+;)")
NO_STATEMENT = re.compile(r"^(?:return|break|continue|goto|case|default|else|if|for|while|do|static|const|typedef|"
                          r"struct|enum|union|extern)\b|^(?:\w+\s+|\w+\s*\*\s*)+\**\w+(?:\[[^\]]*\])*\s*[=,;]")
EFFECT = re.compile(r"[^=!<>]=[^=]|\+\+|--|\)\s*;$")
VALUE = re.compile(r"[\w)\]]$")
ARRAY = re.compile(r"^(?!return\b)(?:\w+\s+)*\w+[\s*]+\w+[^=(]*\[[^\]=(]*$")     # a declaration, up to a length
SETTING = re.compile(r"\s*FXL_IS_")
KEYS = {"file", "line", "change", "reason"}


@dataclasses.dataclass(frozen=True)
class Mutant:
    """A file with text[begin:end] replaced."""
    file: str
    line: int
    begin: int
    end: int
    was: str
    becomes: str

    def apply(self, text):
        return text[:self.begin] + self.becomes + text[self.end:]

    def __str__(self):
        becomes = self.becomes or "(left out)"
        return f"{self.file}:{self.line}: '{' '.join(self.was.split())}' becomes '{becomes}'"


def _blank(match):
    """As many characters, the newlines among them, so that places stay what they are."""
    return re.sub(r"[^\n]", " ", match[0])


def code_of(text):
    """The text with spaces instead of what no mutant is made of."""
    for pattern in (HIDDEN, LINKAGE, PREPROCESSOR, ASSERTION):
        text = pattern.sub(_blank, text)
    return text


def _functions(code):
    """(begin, end) of the bodies of functions: braces at the outermost level that follow a parenthesis."""
    depth, begin, found = 0, 0, []
    for match in re.finditer(r"[{}]", code):
        if match[0] == "{":
            if depth == 0:
                begin = match.start() if code[:match.start()].rstrip().endswith(")") else -1
            depth += 1
        else:
            depth -= 1
            if depth == 0 and begin >= 0:
                found.append((begin, match.end()))
    return found


def _changed(token, before, after):
    """What a token may become; before is the code before it from the statement's beginning on, after the code after it."""
    if token[0].isdigit():
        suffix = token[len(token.rstrip("uUlL")):]
        value = int(token.rstrip("uUlL"), 0)
        larger = [] if ARRAY.search(before) else [f"{value + 1}{suffix}"]
        return larger + ([f"{value - 1}{suffix}"] if value else [])
    before = before.rstrip()
    if token in BINARY_ONLY and (not VALUE.search(before) or re.search(r"\b(return|case)$", before)):
        return []
    if token == "!" and SETTING.match(after):
        return []
    return SWAPS.get(token, ())


def _statement_before(code, place):
    """The code from the beginning of the statement of a place on, up to it."""
    return re.split(r"[;{}]", code[max(0, place - 400):place])[-1].lstrip()


def _statements(code, begin, end):
    """Places of the statements of a function that may be left out."""
    for match in STATEMENT.finditer(code, begin, end):
        text = match[2].lstrip()
        if EFFECT.search(text) and not NO_STATEMENT.search(text):
            yield match.end() - len(text), match.end()


def mutants(file, text):
    """All mutants of a file, in the order of their places."""
    code, found = code_of(text), []
    for begin, end in _functions(code):
        places = [(match.start(), match.end(), becomes) for match in TOKEN.finditer(code, begin, end)
                  for becomes in _changed(match[0], _statement_before(code, match.start()), code[match.end():match.end() + 40])]
        places += [(first, last, ";") for first, last in _statements(code, begin, end)]
        found += [Mutant(file, text.count("\n", 0, first) + 1, first, last, text[first:last],
                         becomes if becomes != ";" else "(void)0;") for first, last, becomes in places]
    return sorted(found, key=lambda mutant: (mutant.begin, mutant.end, mutant.becomes))


def includes(notes, folder, file):
    """Whether a file of the folder went into an object, by the compiler's notes on it (-MMD)."""
    names = notes.read_text(encoding="utf-8").partition(":")[2].partition("\n\n")[0].replace("\\\n", " ").split()
    wanted = (folder / file).resolve()
    return any(name.endswith(wanted.name) and (folder / name).resolve() == wanted for name in names)


def change_of(mutant):
    """What an entry calls a mutant's change."""
    return str(mutant).partition(": ")[2]


def keyed(mutants, text):
    """[((file, line's text, change, number), mutant)] of a file's mutants: no two keys are equal. number: of those with
    the same line and change."""
    lines, found, before = text.split("\n"), [], {}
    for mutant in mutants:
        key = (mutant.file, lines[mutant.line - 1].strip(), change_of(mutant))
        before[key] = before.get(key, 0) + 1
        found.append(((*key, before[key]), mutant))
    return found


def place_of(seed, key):
    """Where the order of a seed has a mutant: a hash of its key, so that a change of one line moves no other mutant."""
    return hashlib.sha256(repr((seed, key)).encode()).digest()


def find(checkout, key, mutants_of):
    """The mutant of a key of keyed()."""
    text = (pathlib.Path(checkout) / key[0]).read_text(encoding="utf-8")
    return dict(keyed(mutants_of(key[0], text), text))[tuple(key)]


def load(path, checkout, mutants_of):
    """{(file, line's text, change): reason} of a file of survivors. mutants_of(file, text): all mutants of a file."""
    entries = tomllib.loads(pathlib.Path(path).read_text(encoding="utf-8")).get("survivors", [])
    known, there = {}, {}
    for number, entry in enumerate(entries, 1):
        if set(entry) != KEYS or not all(isinstance(value, str) and value.strip() for value in entry.values()):
            raise ToolError(f"{path}: survivor {number}: it needs {', '.join(sorted(KEYS))}, each a text")
        file = entry["file"]
        if file not in there:
            there[file] = keys_of(checkout, file, mutants_of)
        key = (file, entry["line"].strip(), entry["change"])
        if key not in there[file]:
            raise ToolError(f"{path}: survivor {number}: {file} no longer has the line '{key[1]}' with the change "
                            f"{key[2]}; look at the line, and take the entry out or write it anew")
        known[key] = entry["reason"]
    return known


def keys_of(checkout, file, mutants_of):
    """{(file, line's text, change)} of all mutants of a file; none where it is gone."""
    path = pathlib.Path(checkout) / file
    if not path.is_file():
        return set()
    text = path.read_text(encoding="utf-8")
    return {key[:3] for key, _ in keyed(mutants_of(file, text), text)}
