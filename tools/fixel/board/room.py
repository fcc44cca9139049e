# SPDX-License-Identifier: MIT
"""Says that a program is too large for its board, before it is linked or in the place of the linker's lines: what it takes, what
there is, and which boards have so much.

    python3 tools/fixel/board/room.py BOARD PROGRAM FILE-WITH-THE-LINKER'S-LINES
    python3 tools/fixel/board/room.py BOARD PROGRAM --sizes FILE-WITH-THE-LINES-OF-size-A

The makefile of the boards calls it with the sizes of a user's objects, whose tables and arrays alone may be too large (exit 1), and
where the linker failed; it runs by any Python, without a package. Lines that say something else are printed as they are, with a
sentence about functions that nothing defines.
"""

import pathlib
import re
import sys

BOARDS = pathlib.Path(__file__).resolve().parents[3] / "boards"
KINDS = {"FLASH": "flash", "RAM": "RAM"}
UNDEFINED = re.compile(r"undefined reference to [`']([A-Za-z_]\w*)'")
OVERFLOW = re.compile(r"region [`'](FLASH|RAM)' overflowed by (\d+) bytes?")
UNITS = {"": 1, "K": 1 << 10, "M": 1 << 20}
# What each section of an object takes whatever is linked beside it: functions that nothing calls are left out, tables and arrays stay.
SECTION = re.compile(r"^\.(rodata|srodata|data|sdata|bss|sbss)[.\w]* +(\d+) ", re.MULTILINE)
TAKES = {"rodata": ["FLASH"], "srodata": ["FLASH"], "data": ["FLASH", "RAM"], "sdata": ["FLASH", "RAM"], "bss": ["RAM"], "sbss": ["RAM"]}


def setting(board, name):
    """{word: value} of the WORD=VALUE of a setting of a board's board.mk, {} without; sizes in bytes."""
    text = (BOARDS / board / "board.mk").read_text(encoding="utf-8").replace("\\\n", " ")
    found = re.search(rf"^{name} := (.*)$", text, re.MULTILINE)
    return {word: int(value, 16) if value.startswith("0x") else int(value.rstrip("KM")) * UNITS[value.lstrip("0123456789")]
            for word, value in (each.split("=") for each in (found[1].split() if found else []))}


def memory(board):
    """The words of BOARD_MEMORY, the board's memory map; of a program without surfaces."""
    return setting(board, "BOARD_MEMORY")


def room(board):
    """{kind: bytes} that a board has for a program. Where that depends on the program, the least."""
    has = memory(board)
    return {"FLASH": has["program_size"], "RAM": has["ram_size"]}


def boards():
    """The names of those that have a memory map."""
    return sorted(folder.parent.name for folder in BOARDS.glob("*/board.mk") if memory(folder.parent.name))


def boards_for_scene(size):
    """The names of the boards whose scene partition has so many bytes. One where a program may take a part of it is none."""
    parts = {each: memory(each) for each in boards() if not setting(each, "BOARD_MEMORY_FOR_SURFACES")}
    return [each for each, has in parts.items() if (has.get("scene_flash_size") or has["flash_size"] - has["program_size"]) >= size]


def used(map_file):
    """{kind: bytes} that a board has by the linker's map, which knows what depends on the program."""
    try:
        text = pathlib.Path(map_file).read_text(encoding="utf-8", errors="replace")
    except OSError:
        return {}
    return {kind: int(length, 16) for kind, length in re.findall(r"^(FLASH|RAM) +0x[0-9a-f]+ +0x([0-9a-f]+) ", text, re.MULTILINE)}


def needed(said, has):
    """{kind: bytes} that a program needs of what the linker says is too small. has: {kind: bytes} of the board."""
    return {kind: has[kind] + int(count) for kind, count in OVERFLOW.findall(said)}


def needed_by_objects(said, has):
    """{kind: bytes} that the tables and arrays of objects need of what is too small for them. said: the lines of size -A."""
    takes = dict.fromkeys(KINDS, 0)
    for section, count in SECTION.findall(said):
        for kind in TAKES[section]:
            takes[kind] += int(count)
    return {kind: count for kind, count in takes.items() if count > has[kind]}


def sentence(board, program, needs, has):
    """What does not fit; None if needs is empty, {kind: bytes} of what is too small. has: {kind: bytes} of the board."""
    if not needs:
        return None
    fitting = [each for each in boards() if each != board and all(room(each)[kind] >= count for kind, count in needs.items())]
    return (f"program {program} needs {' and '.join(f'{count:,} bytes of {KINDS[kind]}' for kind, count in needs.items())}, and BOARD={board} has "
            f"{' and '.join(f'{has[kind]:,}' for kind in needs)}; "
            + (f"the boards that have so much are: {' '.join(fitting)}" if fitting else "no board has so much: make its arrays smaller")
            + ("; bands of rows take less than a whole frame: docs/hello.md, section 4" if "RAM" in needs else ""))


def undefined(said):
    """What there is to say of functions that a program calls and nothing defines, or ""."""
    names = list(dict.fromkeys(UNDEFINED.findall(said)))
    return "" if not names else \
        f"error: no file of the program defines {', '.join(names[:5])}{' and others' if names[5:] else ''}, and a board has no C library: " \
        "it has memcpy and its like, and system_text() of contract/system.h, which prints; BOARD=host has the others: docs/hello.md, section 3\n"


def main(board, program, *words):
    """Prints what there is to say; the exit code."""
    text = pathlib.Path(words[-1]).read_text(encoding="utf-8", errors="replace")
    file, has, before = pathlib.Path(program), room(board), words[0] == "--sizes"
    if not before:
        has |= used(file.with_suffix(".map"))
    found = sentence(board, file.stem.removeprefix("own-"), (needed_by_objects if before else needed)(text, has), has)
    print(f"error: {found}\n" if found else "" if before else text + undefined(text), end="", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
