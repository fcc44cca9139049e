# SPDX-License-Identifier: MIT
"""The work of fixel docs: Doxygen reads the headers as reference_text.py writes them."""

import pathlib
import re
import shutil
import xml.etree.ElementTree

from fixel.base import children, output, scratch, version
from fixel.base.errors import ToolError
from fixel.package import reference_text

ROOT = pathlib.Path(__file__).resolve().parents[3]
HEADERS = ROOT / "lib" / "include"
SETTINGS = """
PROJECT_NAME = Fixel
PROJECT_NUMBER = {version}
INPUT = headers main.dox
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
PREDEFINED = "FXL_STATIC_ASSERT(condition,text)="
GENERATE_TAGFILE = names.xml
GENERATE_LATEX = NO
HTML_TIMESTAMP = NO
VERBATIM_HEADERS = NO
HAVE_DOT = NO
QUIET = YES
WARN_LOGFILE = said.txt
"""
# Of members, constants and macros that have no comment of their own, the one above them says enough.
MAY_BE_WITHOUT = re.compile(r"Member .*\((?:variable|macro definition|enumeration value)\).* is not documented\.$")
WARNING = re.compile(r"^(?:\S*/headers/)?(\S+?):(\d+): warning: (.*)$")
CONDITION = re.compile(r"^# *(?:if|elif|ifdef|ifndef)\b.*", re.MULTILINE)


def headers(folder):
    """{name as a program includes it: text}."""
    return {str(file.relative_to(folder)): file.read_text(encoding="utf-8") for file in sorted(folder.rglob("*.h"))}


def main_page(texts):
    """The first page: what fixel.h says, and a line for each header."""
    lines = [f"- @ref {name} \"{name}\": {first_sentence(text)}" for name, text in texts.items()]
    return "\n".join(["/** @mainpage", "Fixel is a fixed-point 3-D renderer for microcontrollers. A first program includes fixel.h alone.", "",
                      "The headers:", "", *lines, "*/", ""])


def first_sentence(text):
    """What the first comment of a header says first."""
    words = " ".join(line.strip(" *") for line in reference_text.first_comment(text).split("\n"))
    return reference_text.escaped(re.match(r"\s*(.*?\.)(?:\s|$)", words)[1], ())


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
    """Runs Doxygen in a folder: (what is wrong, functions, types). The pages are in html."""
    names = set().union(*(re.findall(r"\b(?:fxl|FXL)_\w+", CONDITION.sub("", reference_text.COMMENT.sub("", text))) for text in texts.values()))
    for name, text in texts.items():
        file = folder / "headers" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(reference_text.for_doxygen(text, name, names), encoding="utf-8")
    (folder / "main.dox").write_text(main_page(texts), encoding="utf-8")
    (folder / "Doxyfile").write_text(SETTINGS.format(version=version.version()), encoding="utf-8")
    done = children.run(["doxygen"], cwd=folder, text=True)
    if done.returncode:
        raise ToolError("doxygen: failed", words=done.stdout + done.stderr)
    return faults((folder / "said.txt").read_text(encoding="utf-8")), *counted(folder / "names.xml")


def command(options):
    if shutil.which("doxygen") is None:
        raise ToolError("not run: needs doxygen: run 'sudo apt-get install doxygen'")
    texts = headers(HEADERS)
    with scratch.folder("docs") as folder:
        folder = pathlib.Path(folder)
        wrong, functions, types = written(texts, folder)
        if wrong:
            print("\n".join(wrong))
            print(f"docs: {len(wrong)} places to mend; nothing was written")
            return 1
        pages = sorted((file for file in (folder / "html").rglob("*") if file.is_file()), key=lambda file: file.name == "index.html")
        for page in pages:      # the one that a reader opens comes last
            place = options.out / page.relative_to(folder / "html")
            output.make_folder(place.parent)
            output.write_file(place, page.read_bytes())
    print(f"docs: {functions} functions and {types} types of {len(texts)} headers: {options.out / 'index.html'}")
    return 0
