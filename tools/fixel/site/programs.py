# SPDX-License-Identifier: MIT
"""The programs of examples/ as WebAssembly, one by one, for the site: each with what it draws by, and the command that runs it on a board.

firmware/web/frames.c is their board: it keeps the frames that firmware/own/own.c hands out, so a program stays as it is.
"""

import functools
import pathlib
import re
import shlex
import sys
from dataclasses import dataclass, replace

from fixel.base import children, scratch
from fixel.base.errors import ToolError

ROOT = pathlib.Path(__file__).resolve().parents[3]
EXAMPLES = ROOT / "examples"
PAGE = ROOT / "docs" / "examples.md"
LAUNCHER = ROOT / "tools" / "fixel" / "launcher.py"
MAIN = "main.c"
ROW = re.compile(r"^\| !\[(\w+)\]\(([\w./]+)\) \| [^|]+ \| \d+ \| ([^|]+) \|", re.MULTILINE)    # of the page: name, picture, what is new in it
EXPORT = re.compile(r'#include "([\w.]+)" /\* (tools/scene\.py export [^*]+?) -o \1 \*/')      # a header, and the command that makes it
PALETTE = re.compile(r"\b(\w*palette)\[256\]\[3\]")
UNDEFINED = re.compile(r"undefined symbol: (\w+)")
COMPILE = ("clang", "--target=wasm32", "-Oz", "-flto", "-std=gnu11", "-ffreestanding", "-fno-builtin", f"-I{ROOT / 'lib' / 'include'}")
LINK = ("wasm-ld", "--no-entry", "--gc-sections", "--strip-all", "--stack-first", "-z", "stack-size=65536")
SHOWS_ROWS = "firmware/own/show_rows.o"     # for a program that hands out rows itself, and for no other
GLUE = """#define main program_main
#include "{main}"
#undef main
int __real_main(int argc, char **argv);
int __real_main(int argc, char **argv)
{{
    (void)argc;
    (void)argv;
    return program_main();
}}
"""
PALETTE_GLUE = """__attribute__((export_name("palette"))) const void *its_palette(void);
const void *its_palette(void)
{{
    return {palette};
}}
"""


@dataclass(frozen=True)
class Program:
    """A program of examples/. said: what is new in it. picture: its picture's file. why_not: why it does not run in a page, or ""."""
    name: str
    said: str
    picture: pathlib.Path
    why_not: str = ""

    @property
    def files(self):
        """Its files of C, the first with what it is."""
        return sorted((EXAMPLES / self.name).glob("*.c"))

    @property
    def code(self):
        """The text of the first file."""
        return self.files[0].read_text(encoding="utf-8")

    @property
    def exports(self):
        """[(a header that it includes, the command that makes it but for its -o)]."""
        return EXPORT.findall(self.code)


def of_the_tree():
    """The programs of examples/, in the order of docs/examples.md."""
    rows = {name: (picture, said) for name, picture, said in ROW.findall(PAGE.read_text(encoding="utf-8"))}
    folders = {folder.name for folder in EXAMPLES.iterdir() if any(folder.glob("*.c"))}
    if folders != set(rows):
        raise ToolError(f"{PAGE.name}: has no row of {', '.join(sorted(folders - set(rows)) or ['each program, or one of none'])}")
    return [Program(name, said.replace("`", ""), PAGE.parent / picture) for name, (picture, said) in rows.items()]


def command(program, board):
    """What runs it on a board."""
    made = [f"{words} -o examples/{program.name}/{header}" for header, words in program.exports]
    has_main = (EXAMPLES / program.name / MAIN).exists()
    return " && ".join([*made, f"make run BOARD={board} PROGRAM={f'examples/{program.name}' if has_main else program.name}"])


@functools.cache
def _exported(words):
    """The text of a header, of the command that makes it."""
    with scratch.folder("export") as folder:
        out = pathlib.Path(folder) / "scene.h"
        done = children.run([sys.executable, LAUNCHER, *shlex.split(words)[1:], "-o", out], cwd=ROOT, text=True)
        if done.returncode:
            raise ToolError(f"not made: {words}", words=done.stderr)
        return out.read_text(encoding="utf-8")


def write_headers(program, folder):
    """Writes the headers that a program includes and a tool makes."""
    for header, words in program.exports:
        (pathlib.Path(folder) / header).write_text(_exported(words), encoding="utf-8")


def _glue(program):
    """What is compiled: the program, whose main gets another name, and its palette where it has one."""
    found = PALETTE.findall(program.code) or [f"{header.removesuffix('_scene.h')}_palette" for header, _ in program.exports]
    return GLUE.format(main=program.files[0]) + (PALETTE_GLUE.format(palette=found[0]) if found else "")


def _run(command, what):
    done = children.run(list(map(str, command)), text=True)
    if done.returncode:
        raise ToolError(f"{what}: not compiled for a page", words=done.stderr)


def compiled(program, own, out):
    """The program, with why it does not run in a page: or it is compiled into a WebAssembly module. own: the folder in which make has what it links."""
    if not (EXAMPLES / program.name / MAIN).exists():
        return replace(program, why_not=f"it has no {MAIN}: firmware/{program.name} has its main, its keys and a record of them")
    with scratch.folder("program") as made:
        folder = pathlib.Path(made)
        write_headers(program, folder)
        (folder / "glue.c").write_text(_glue(program), encoding="utf-8")
        _run([*COMPILE, "-include", own / "wrapped.h", f"-I{folder}", "-c", folder / "glue.c", "-o", folder / "glue.o"], program.name)
        linked = [name for name in (own / "objects.txt").read_text(encoding="utf-8").split() if not name.endswith(SHOWS_ROWS) or "display_rows" in program.code]
        done = children.run([*map(str, LINK), str(folder / "glue.o"), *linked, "-o", str(pathlib.Path(out).resolve())], cwd=ROOT, text=True)
    missing = sorted(set(UNDEFINED.findall(done.stderr or "")))
    if done.returncode and not missing:
        raise ToolError(f"{program.name}: not linked for a page", words=done.stderr)
    return replace(program, why_not=f"it needs {' and '.join(missing)}, which you write" if missing else "")
