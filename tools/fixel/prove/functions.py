# SPDX-License-Identifier: MIT
"""Every function of the library, as the host's compiler finds them in the shipped text, and the entries of its assembly.

GCC writes for each file that it reads which functions it defines and where (-aux-info), those of headers, static ones and
those of macros too. A function is known as FILE:NAME, by the file that has its text. Functions of one text that several
files include under several names are one.
"""

import concurrent.futures
import hashlib
import os
import pathlib
import re

from fixel.base import children, scratch
from fixel.base.errors import ToolError
from fixel.check import mutate, planting

ROOMS = ("math", "view", "clip", "raster", "scene", "draw", "paint", "order", "game", "screen", "study", "include")
FLAGS = ("-std=c11", "-Ilib/include", "-Ilib")
# Its text is one file's definition: /* lib/math/arith.c:35:NF */ extern uint32_t fxl_divide_u64 (uint64_t, ...
LINE = re.compile(r"/\* (lib/\S+?):(\d+):.F \*/ (.*)")
NAME = re.compile(r"(?:\(\*\s*)?\b([A-Za-z_]\w*) \(")
ENTRY = re.compile(r"^\s*\.global (fxl_\w+)$", re.MULTILINE)      # of assembly


def name_in(declaration):
    """The name of the function that a line of -aux-info declares: the first word before a bracket, for no type of the
    library has brackets before it."""
    found = NAME.search(declaration)
    return found[1] if found else None


def defined_in(root, file, folder, flags=()):
    """(file, line, whether it is static, name) of each function of the library that a source defines, or a header of it."""
    place = folder / str(file).replace("/", "+")
    done = children.run(["gcc", *FLAGS, *flags, "-fsyntax-only", "-aux-info", place, file], cwd=root, text=True, errors="replace")
    if done.returncode:
        raise ToolError(f"{file}: the compiler refuses it, so its functions are not known", words=done.stderr)
    return [(os.path.normpath(match[1]), int(match[2]), match[3].startswith("static"), name_in(match[3]))
            for match in map(LINE.match, place.read_text(encoding="utf-8").splitlines()) if match]


def find(root, rooms=ROOMS):
    """{FILE:NAME: whether it has external linkage}, in the order of the text."""
    root = pathlib.Path(root)
    files = [path.relative_to(root).as_posix() for room in rooms for path in sorted((root / "lib" / room).glob("*.c"))]
    with scratch.folder("functions") as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        found = [each for part in pool.map(lambda file: defined_in(root, file, folder), files) for each in part]
    names = {}
    for file, line, static, name in found:
        if file.split("/")[1] in rooms:
            names.setdefault((file, line), (name, static))
    functions = {}
    for (file, _), (name, static) in sorted(names.items(), key=lambda each: (rooms.index(each[0][0].split("/")[1]), *each[0])):
        functions[f"{file}:{name}"] = functions.get(f"{file}:{name}", False) or not static
    return functions


def text_of(root, function):
    """The hash of the text of FILE:NAME, without comments and white space: of all texts that the file has for a name."""
    file, _, name = function.rpartition(":")
    try:
        text = (pathlib.Path(root) / file).read_text(encoding="utf-8")
    except OSError as error:
        raise ToolError(f"{function}: {error}") from error
    lines = [line for line, owner in zip(mutate.code_of(text).splitlines(), planting.functions(text)) if owner == name]
    if not lines:
        raise ToolError(f"{file} has no function {name}")
    return hashlib.sha256(" ".join(" ".join(lines).split()).encode()).hexdigest()[:16]


def assembly(root):
    """{FILE:NAME} of the entries of the library's assembly: functions that C calls, and tables of code."""
    root = pathlib.Path(root)
    return {f"{path.relative_to(root).as_posix()}:{name}" for path in sorted((root / "lib").glob("*/*.S"))
            for name in ENTRY.findall(path.read_text(encoding="utf-8"))}
