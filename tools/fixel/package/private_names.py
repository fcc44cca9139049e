# SPDX-License-Identifier: MIT
"""The names that a C file has for itself: static functions and objects, types, members of enumerations.

Not a parser of C: it reads the style of the library, in which a declaration at file scope begins at the start of a statement.
"""

import functools
import re

SKIPPED = re.compile(r"/\*.*?\*/|//[^\n]*|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*'", re.DOTALL)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.MULTILINE)
EXTERN_C = re.compile(r"^#ifdef __cplusplus\n(?:extern \"C\" \{|\})\n#endif\n", re.MULTILINE)
ATTRIBUTE = re.compile(r"__attribute__\(\([^()]*\)\)")
WORD = r"[A-Za-z_]\w*"
IDENTIFIER = re.compile(WORD)
# What begins the definition of a function or an object which only this file has: static or a macro for it. Another macro may be an
# attribute: then the name tells, because what other files see begins with fxl_.
STATIC = re.compile(r"static|FXL_APART|FXL_IN_PLACE")
MACRO = re.compile(r"FXL_[A-Z_]+")


@functools.cache
def code(text):
    """A file's text without comments and strings."""
    return SKIPPED.sub(" ", EXTERN_C.sub("", text))


@functools.cache
def identifiers(text):
    """The words of a file that may be names of file scope: not those of members, after a dot or an arrow."""
    return set(re.findall(rf"(?<![\w.>]){WORD}", code(text)))


def macros(text):
    """The macros that a file defines."""
    return set(re.findall(rf"^[ \t]*#[ \t]*define[ \t]+({WORD})", text, re.MULTILINE))


def statements(text):
    """[(a statement of file scope with {} for each pair of braces, what stands in the braces)]."""
    found, outside, inside, depth = [], "", "", 0
    for part in re.split(r"([{};])", DIRECTIVE.sub("", code(text))):
        if part == "{":
            outside += "{}" if depth == 0 else ""
            depth += 1
        elif part == "}":
            depth -= 1
        elif depth > 0:
            inside += part
        elif part != ";":
            # A function's body ends its definition; what follows the braces of a type or an object goes on to the semicolon.
            if outside.endswith("{}") and is_function(outside):
                found.append((outside, inside))
                outside = inside = ""
            outside += part
        else:
            found.append((outside, inside))
            outside = inside = ""
    return [(" ".join(ATTRIBUTE.sub(" ", words).split()), braces) for words, braces in found if words.strip()]


def is_function(words):
    """Whether the braces at the end of a statement are a function's body."""
    return ATTRIBUTE.sub("", words)[:-2].rstrip().endswith(")")


def declared(words, braces):
    """The names that a statement makes for its file alone."""
    names = set(re.findall(rf"\b(?:struct|union|enum) ({WORD}) ?\{{\}}", words))
    if re.search(r"\benum\b[^(]*\{\}", words):
        names |= set(re.findall(rf"(?:^|,)\s*({WORD})", braces))
    if words.startswith("typedef"):
        pointer = re.search(rf"\(\*({WORD})\)", words)
        names.add(pointer[1] if pointer else IDENTIFIER.findall(re.split(r"[(\[]", words)[0])[-1])
    elif STATIC.fullmatch(words.split()[0]) and "(*" in words.split("=")[0]:
        names.add(re.search(rf"\(\*(?:const )?({WORD})", words)[1])
    elif STATIC.fullmatch(words.split()[0]) or MACRO.fullmatch(words.split()[0]):
        name = IDENTIFIER.findall(re.split(r"[(\[=]", words)[0])[-1]
        names |= {name} if STATIC.fullmatch(words.split()[0]) or not name.startswith("fxl_") else set()
    return names


@functools.cache
def private(text):
    """The names of a file that no other file may see."""
    return {name for words, braces in statements(text) for name in declared(words, braces)}


def renamed(text, names, suffix):
    """A file's text with a suffix at each of the names, but in comments and strings, and where a name is a member."""
    if not names:
        return text
    word = re.compile(rf"({SKIPPED.pattern})|(?<![\w.>])({'|'.join(sorted(names))})\b", re.DOTALL)
    return word.sub(lambda found: found[0] if found[1] else f"{found[2]}_{suffix}", text)
