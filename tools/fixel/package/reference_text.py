# SPDX-License-Identifier: MIT
"""A header as Doxygen reads it. The headers have ordinary comments; Doxygen takes only comments with marks of its own.

Each line stays where it is, so that Doxygen's line numbers are those of the header:

    the first comment                                   what the header is for
    a comment that stands right above a declaration     its documentation
    a comment behind a declaration                      the same
    FXL_E_...: at the beginning of a line               a status that the function returns
    declarations without an empty line between them     share the comment above them
    lines that are indented further, "- " excepted      laid out as they are
    the name of a type, a function, a constant          a link, which must lead somewhere
"""

import re

COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
LICENCE = "SPDX-License-Identifier"
BOX = re.compile(r"/\* -{3}|/\* [a-z ]+ -{3}|/\* place [a-z-]+: ")      # /* --- records ----- */, and tags of recipes
NAME = re.compile(r"(?<![\w/.\"<])(?:fxl|FXL)_[A-Za-z0-9_]*[A-Za-z0-9](?![\w*/.]*[\w*/])(?!\.\.\.)")
SPECIAL = re.compile(r"[\\@<>&$#%\"~]")
STATUS = re.compile(r"^\s*(FXL_E_\w+)(?=[:,] )")
STATUSES_END = re.compile(r"^ With (?:each|both|either)\b")
MEMBERS = re.compile(r"^(\s+(?:const )?(?:struct )?\w+(?: \w+)* )(\**\w+(?:\[\w+\])?(?:, \**\w+(?:\[\w+\])?)+);[ ]*(/\*.*)?$")


def escaped(text, names):
    """Text of a comment, in which nothing is a command or a tag, and names that there are become links."""
    text = SPECIAL.sub(lambda found: "\\" + found[0], text)
    text = NAME.sub(lambda found: f"#{found[0]}" if found[0] in names else found[0], text)
    return re.sub(r"`([^`]+)`", r"<code>\1</code>", text)


def told(text, names):
    """The inside of a comment, line by line: statuses, what is laid out as it stands, and text."""
    made, margin, in_statuses = [], None, False
    lines = [line[line.index("*") + 1:] if line.lstrip().startswith("*") else line.strip() for line in text.split("\n")]
    for number, line in enumerate(lines):
        stands = re.match(r" {3,}(?!- )\S", line) is not None and not in_statuses and not _goes_on(lines[:number])
        if margin is not None and not stands and line.strip():
            made[-1] += " @endverbatim"
            margin = None
        if stands:
            begins = margin is None
            margin = len(line) - len(line.lstrip()) if begins else margin
            made.append(("@verbatim " if begins else "") + line[margin:])
            continue
        status = STATUS.match(line)
        if status:
            in_statuses = True
            made.append(f"@retval {status[1]} {escaped(line[status.end() + 2:], names)}")
        elif in_statuses and STATUSES_END.match(line):
            made.append(f"@note {escaped(line.strip(), names)}")
        else:
            made.append(escaped(line, names))
    return "\n".join(made) + (" @endverbatim" if margin is not None else "")


def _goes_on(above):
    """Whether an indented line belongs to an item of a list: the lines above it, upward."""
    for line in reversed(above):
        if re.match(r"\s*- ", line):
            return True
        if not re.match(r" {3,}\S", line):
            return False
    return False


def split_members(text):
    """Members that share a comment, each with the comment: Doxygen would give it to the last one."""
    def split(found):
        words = found[3] or ""
        if words and not words.endswith("*/"):
            return found[0]
        each = found[2].split(", ")
        return " ".join(f"{found[1] if number == 0 else found[1].strip() + ' '}{name}; {words}" for number, name in enumerate(each))
    return "\n".join(MEMBERS.sub(split, line) for line in text.split("\n"))


def first_comment(text):
    """The inside of the comment that says what a header is for."""
    return next(found[0][2:-2] for found in COMMENT.finditer(text) if LICENCE not in found[0])


def for_doxygen(text, name, names):
    """A header's text as Doxygen reads it. name: the header, as a program includes it. names: what may be linked."""
    made, end, is_first, closing = [], 0, True, None
    text = split_members(text)
    for found in COMMENT.finditer(text):
        made.append(text[end:found.start()])
        if closing is not None and closing <= found.start():
            made[-1] = _closed(made[-1], end, closing)
            closing = None
        end = found.end()
        before = text[text.rfind("\n", 0, found.start()) + 1:found.start()]
        after = text[found.end():]
        inside = found[0][2:-2]
        if LICENCE in inside or BOX.match(found[0]):
            made.append(found[0])
        elif is_first:
            is_first = False
            made.append(f"/** @file {name} {told(inside, names)}*/")
        elif before.strip():
            made.append(f"/**<{told(inside, names)}*/")
        elif re.match(r"[ \t]*\n(?=[ \t]*[A-Za-z#}])", after):
            block = _block(text, found.end())
            if block and not before:
                closing = block
            made.append(("/**@{*/ " if block and not before else "") + f"/**{told(inside, names)}*/")
        else:
            made.append(found[0])
    rest = text[end:]
    return "".join(made) + (rest if closing is None else _closed(rest, end, closing))


def _closed(part, start, closing):
    """A part of the text, which begins at start, with the end of a group at the line break at closing."""
    return part[:closing + 1 - start] + "/**@}*/" + part[closing + 1 - start:]


def _block(text, start):
    """Where the declarations end that share the comment which ends at start: the line break before an empty line or the next
    comment; 0 if there are not several."""
    end = min(filter(lambda place: place > 0, (text.find("\n\n", start), text.find("\n/*", start))), default=0)
    block = COMMENT.sub("", text[start:end])
    is_shared = len(re.findall(r"^#define|^\w[^;]*;", block, re.MULTILINE)) > 1 or re.search(r"^extern [^;]*,", block, re.MULTILINE)
    return end if end > 0 and is_shared and not re.search(r"[{}]|^# *(?!define)", block, re.MULTILINE) else 0
