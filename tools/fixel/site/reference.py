# SPDX-License-Identifier: MIT
"""The reference of all public functions and types: what Doxygen reads of the headers, as pages for Sphinx, by Breathe.

The headers have ordinary comments; Doxygen takes only comments with marks of its own, so it reads a text that is made of each
header. Each line stays where it is, so that Doxygen's line numbers are those of the header:

    the first comment                                   what the header is for
    a comment that stands right above a declaration     its documentation
    a comment behind a declaration                      the same
    FXL_E_...: at the beginning of a line               a status that the function returns
    declarations without an empty line between them     share the comment above them
    lines that are indented further, "- " excepted      laid out as they are
    the name of a type, a function, a constant          a link, which must lead somewhere
"""

import pathlib
import re
import shutil
import xml.etree.ElementTree

from fixel.base import children, version
from fixel.base.errors import ToolError

ROOT = pathlib.Path(__file__).resolve().parents[3]
HEADERS = ROOT / "lib" / "include"
SETTINGS = """
PROJECT_NAME = Fixel
PROJECT_NUMBER = {version}
INPUT = headers
RECURSIVE = YES
STRIP_FROM_PATH = headers
STRIP_FROM_INC_PATH = headers
OUTPUT_DIRECTORY = .
OPTIMIZE_OUTPUT_FOR_C = YES
TYPEDEF_HIDES_STRUCT = YES
DISTRIBUTE_GROUP_DOC = YES
EXTRACT_STATIC = YES
JAVADOC_AUTOBRIEF = YES
MARKDOWN_SUPPORT = NO
SORT_MEMBER_DOCS = NO
MACRO_EXPANSION = YES
EXPAND_ONLY_PREDEF = YES
PREDEFINED = "FXL_STATIC_ASSERT(condition,text)=" FXL_ALIGN_8=
GENERATE_TAGFILE = names.xml
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
VERBATIM_HEADERS = NO
HAVE_DOT = NO
QUIET = YES
WARN_LOGFILE = said.txt
"""
# Of members, constants and macros that have no comment of their own, the one above them says enough.
MAY_BE_WITHOUT = re.compile(r"Member .*\((?:variable|macro definition|enumeration value)\).* is not documented\.$")
WARNING = re.compile(r"^(?:\S*/headers/)?(\S+?):(\d+): warning: (.*)$")
CONDITION = re.compile(r"^# *(?:if|elif|ifdef|ifndef)\b.*", re.MULTILINE)
COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
LICENCE = "SPDX-License-Identifier"
BOX = re.compile(r"/\* -{3}|/\* [a-z ]+ -{3}|/\* place [a-z-]+: ")      # /* --- records ----- */, and tags of recipes
NAME = re.compile(r"(?<![\w/.\"<])(?:fxl|FXL)_[A-Za-z0-9_]*[A-Za-z0-9](?![\w*/.]*[\w*/])(?!\.\.\.)")
SPECIAL = re.compile(r"[\\@<>&$#%\"~]")
STATUS = re.compile(r"^\s*(FXL_E_\w+)(?=[:,] )")
STATUSES_END = re.compile(r"^ With (?:each|both|either)\b")
MEMBERS = re.compile(r"^(\s+(?:const )?(?:struct )?\w+(?: \w+)* )(\**\w+(?:\[\w+\])?(?:, \**\w+(?:\[\w+\])?)+);[ ]*(/\*.*)?$")


def headers(folder):
    """{name as a program includes it: text}."""
    return {str(file.relative_to(folder)): file.read_text(encoding="utf-8") for file in sorted(folder.rglob("*.h"))}


def faults(said):
    """What Doxygen says that is an error, with the places of the headers."""
    found = []
    for line in said.splitlines():
        place = WARNING.match(line)
        if place is None:
            found.append(line)
        elif not MAY_BE_WITHOUT.search(place[3]):
            found.append(f"lib/include/{place[1]}:{place[2]}: {place[3]}")
    return found


def counted(tags):
    """(functions, types) that have a page, by the file that Doxygen writes for other tools."""
    root = xml.etree.ElementTree.parse(tags).getroot()
    members = {(member.get("kind"), member.findtext("name")) for member in root.iter("member")}
    kinds = [kind for kind, _ in members]
    return kinds.count("function"), kinds.count("typedef") + kinds.count("enumeration") + sum(
        compound.get("kind") in ("struct", "union") for compound in root.iter("compound"))


def written(texts, folder):
    """Runs Doxygen in a folder: (what is wrong, functions, types). What it read is in folder/xml."""
    names = set().union(*(re.findall(r"\b(?:fxl|FXL)_\w+", CONDITION.sub("", COMMENT.sub("", text))) for text in texts.values()))
    for name, text in texts.items():
        file = folder / "headers" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(for_doxygen(text, name, names), encoding="utf-8")
    (folder / "Doxyfile").write_text(SETTINGS.format(version=version.version()), encoding="utf-8")
    done = children.run(["doxygen"], cwd=folder, text=True)
    if done.returncode:
        raise ToolError("doxygen: failed", words=done.stdout + done.stderr)
    return faults((folder / "said.txt").read_text(encoding="utf-8")), *counted(folder / "names.xml")


def pages(texts):
    """{file of a page: its text}: one for each header, by Breathe, and the index, which lists them. No other page's list of contents has them."""
    made = {"index.md": "# Functions and types\n\nA first program includes `fixel.h` alone.\n\n"}
    for name, text in texts.items():
        page = name.removesuffix(".h").replace("/", "-") + ".rst"
        made["index.md"] += f"* [{name}]({page}): {first_sentence(text)}\n"
        made[page] = f":orphan:\n\n{name}\n{'=' * len(name)}\n\n.. doxygenfile:: {pathlib.Path(name).name}\n"
    return made


def first_sentence(text):
    """What the first comment of a header says first."""
    words = " ".join(line.strip(" *") for line in first_comment(text).split("\n"))
    return re.match(r"\s*(.*?\.)(?:\s|$)", words)[1]


def read(folder):
    """Has Doxygen read the headers of the library into folder/xml: (pages, functions, types). What is wrong with a comment is refused."""
    if shutil.which("doxygen") is None:
        raise ToolError("not run: needs doxygen: run 'sudo apt-get install doxygen'")
    texts = headers(HEADERS)
    wrong, functions, types = written(texts, folder)
    if wrong:
        raise ToolError(f"the reference: {len(wrong)} places to mend", exit_code=1, words="\n".join(wrong))
    return pages(texts), functions, types


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
