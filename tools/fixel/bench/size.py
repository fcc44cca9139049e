# SPDX-License-Identifier: MIT
"""Prints flash, RAM and stack of the firmware, and of the library for each core.

Also checks on the Cortex-M0 build, or on another one where that is not given, that the library links neither floating point nor a heap: by its undefined
symbols, and by linking all of it with the compiler's own helpers alone. Exit 1 if the check fails.
"""

import argparse
import pathlib
import re
import sys

from fixel.base import output, reading, scratch
from fixel.base.errors import ToolError, one_line
from fixel.base.table import coloured, table
from fixel.commands import late

elffile = late("elftools.elf.elffile")
spent = late("fixel.base", "spent")
linked_size, stack = late("fixel.bench", "linked_size stack")
firmware, fleet = late("fixel.board", "firmware fleet")
making = late("fixel.scene", "making")

# What the library may ask of its surroundings: C's memory functions, which
# freestanding gcc may call by itself, and libgcc's helpers for whole numbers.
MEMORY_FUNCTIONS = {"memcpy", "memmove", "memset", "memcmp"}
ALLOWED = re.compile(
    r"^(memcpy|memmove|memset|memcmp|__aeabi_mem(cpy|move|set|clr)[48]?"
    r"|__aeabi_(lmul|lcmp|ulcmp|llsl|llsr|lasr|u?idiv|u?idivmod|u?ldivmod|idiv0|ldiv0)"
    r"|__(clz|ctz|popcount)[sd]i2|__gnu_thumb1_case_(sqi|uqi|shi|uhi|si))$")
# What must not be in the linked result, whoever brought it.
FORBIDDEN = re.compile(
    r"^(__aeabi_([fd](add|sub|rsub|mul|div|neg|cmp|2)|c[fd]|u?[il]2[fd]|h2f)\w*"
    r"|__\w*[sdtx]f[23i]?\w*|__(add|sub|mul|div|neg)[sd]f3|__(fix|float)\w*"
    r"|_?(malloc|free|calloc|realloc|sbrk)(_r)?|_?_?(printf|puts)\w*)$")
PROOF_CORE = "cortex-m0"    # if its library is there: it asks the compiler for most
EXCEPTION_FRAME = 36    # bytes that an interrupt pushes onto the program's stack, with alignment
SCENES = [pathlib.Path(__file__).resolve().parents[3] / "scenes" / f"{name}.toml" for name in ("tiny", "plaza")]
SCENE_FRAMES = 4        # of each scene that the board walks, so that its stack can be measured
FLASH, RAM = "flash", "ram"
SHF_WRITE, SHF_ALLOC = 1, 2


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--board", required=True)
    made.add_argument("--elf", help="the firmware (default: only the library)")
    made.add_argument("--usage", nargs="*", default=[], help="folders with its objects' .su files")
    made.add_argument("--library", action="append", default=[], metavar="CORE=FILE",
                      help="libfixel.a for a core")
    made.add_argument("--cross", default="arm-none-eabi-")
    made.add_argument("--out", required=True, help="the JSON file to write")
    return made


def sections_size(elf):
    """Bytes that a program or object needs of flash and of RAM; a stack section is not counted."""
    size = {FLASH: 0, RAM: 0}
    for section in elf.iter_sections():
        if not section["sh_flags"] & SHF_ALLOC or section.name.startswith(".stack"):
            continue
        filled = section["sh_type"] != "SHT_NOBITS"
        if filled:
            size[FLASH] += section["sh_size"]
        if section["sh_flags"] & SHF_WRITE or not filled:
            size[RAM] += section["sh_size"]
    return size


def archive_size(file, cross):
    """The same for a library, all its objects."""
    total = {FLASH: 0, RAM: 0}
    with scratch.folder("size") as folder:
        stack.run([f"{cross}ar", "x", "--output", folder, str(file)])
        for member in sorted(pathlib.Path(folder).iterdir()):
            with reading.open_file(member) as handle:
                for kind, size in sections_size(elffile.ELFFile(handle)).items():
                    total[kind] += size
    return total


def symbols_of(elf):
    """Symbols of a program: name -> value."""
    return {symbol.name: symbol["st_value"] for symbol in
            elf.get_section_by_name(".symtab").iter_symbols() if symbol.name}


def entry_name(elf):
    """The function that the ELF header names as its entry."""
    start = elf["e_entry"] & ~1
    for symbol in elf.get_section_by_name(".symtab").iter_symbols():
        if symbol["st_info"]["type"] == "STT_FUNC" and symbol["st_value"] & ~1 == start:
            return symbol.name
    raise ToolError("the program's entry is not a function with a name")


def measure_firmware(file, cross, usage_folders):
    """Flash, RAM, worst stack of a program."""
    with reading.open_file(file) as handle:
        elf = elffile.ELFFile(handle)
        size, symbols, entry = sections_size(elf), symbols_of(elf), entry_name(elf)
    graph = stack.Graph(stack.disassemble(file, cross), stack.read_usage(*usage_folders),
                        lambda name: name == entry, stack.addresses_taken(file, cross) - {entry})
    deepest = graph.depth(entry)
    handlers = [graph.depth(name).size for name in graph.roots() if name != entry]
    return {"file": str(file), **size,
            "stack": deepest.size + EXCEPTION_FRAME, "stack_path": deepest.path,
            "stack_reserved": symbols.get("fxl_stack_size"),
            "handler_stack": max(handlers, default=0),
            "not_bounded": graph.unbounded()}


def measure_run(board, elf, scenes):
    """The deepest stack that was seen when the board walked the scenes that it has room for; None where it
    walked none."""
    seen = []
    with scratch.folder("size") as folder:
        for scene in scenes:
            image = pathlib.Path(folder) / f"{pathlib.Path(scene).stem}.fxls"
            making.build(scene, image, frames=SCENE_FRAMES)
            if image.stat().st_size <= firmware.load(elf, board).scene_size:
                seen.append(fleet.stack_seen(board, elf, image, pathlib.Path(folder)))
    return max(filter(None, seen), default=None)


def measure_library(core, file, cross, usage_folder):
    """Flash, RAM, worst stack of the library's public functions."""
    graph = stack.Graph(stack.disassemble(file, cross), stack.read_usage(usage_folder), is_public,
                        stack.addresses_taken(file, cross))
    deepest = max(map(graph.depth, filter(is_public, graph.functions)), key=lambda depth: depth.size)
    return {"core": core, **archive_size(file, cross), **linked_size.measure(core, file, cross),
            "stack": deepest.size, "stack_path": deepest.path, "not_bounded": graph.unbounded()}


def is_public(name):
    """Whether a function of the library is not static."""
    return name.startswith("fxl_")


def undefined_symbols(library, cross):
    """What a library asks of others."""
    wanted, defined = set(), set()
    for line in stack.run([f"{cross}nm", str(library)]).splitlines():
        fields = line.split()
        if len(fields) == 2 and fields[0] in "Uw":
            wanted.add(fields[1])
        elif len(fields) == 3:
            defined.add(fields[2])
    return sorted(wanted - defined)


def link_alone(library, cross, core, program):
    """Links all of a library with libgcc and nothing else; what the linker says if it cannot.

    The memory functions are the firmware's, so their names get an address here.
    """
    given = [f"-Wl,--defsym={name}=0" for name in sorted(MEMORY_FUNCTIONS)]
    try:
        stack.run([f"{cross}gcc", f"-mcpu={core}", "-mthumb", "-nostdlib", "-Wl,--whole-archive",
                   str(library), "-Wl,--no-whole-archive", *given, "-lgcc", "-Wl,--entry=0",
                   "-o", str(program)])
    except ToolError as error:
        return str(error)
    return None


def prove_pure(library, cross, core=PROOF_CORE):
    """That a library has no float and no heap: what was looked at, and what is wrong."""
    undefined = undefined_symbols(library, cross)
    wrong = [f"it asks for {name}" for name in undefined if not ALLOWED.match(name)]
    linked = []
    with scratch.folder("size") as folder:
        program = pathlib.Path(folder) / "proof.elf"
        complaint = link_alone(library, cross, core, program)
        if complaint:
            wrong.append(f"it does not link by itself: {complaint}")
        else:
            with reading.open_file(program) as handle:
                linked = sorted(symbols_of(elffile.ELFFile(handle)))
            wrong += [f"linked, it contains {name}" for name in linked if FORBIDDEN.match(name)]
    return {"core": core, "undefined": undefined, "linked_symbols": len(linked), "wrong": wrong,
            "passes": not wrong}


def stack_text(each):
    """A depth of which nothing is known to be deeper, or the least that there is: never too small a figure."""
    figure = max(each["stack"], each.get("stack_measured") or 0)
    return f"at least {figure:,}" if each["not_bounded"] else f"{figure:,}"


def print_sizes(result):
    """For people."""
    rows = [[f"firmware {result['board']}", each[FLASH], each[RAM], stack_text(each), each.get("stack_measured"),
             each["stack_reserved"]] for each in result["firmware"]]
    rows += [[f"library {each['core']}", each["linked_flash"], each["linked_ram"], stack_text(each), None, None]
             for each in result["library"]]
    print(table(rows, ["bytes", "flash", "RAM", "stack", "measured", "reserved"]))
    print("library: what the first program of README.md links of it, without the compiler's arithmetic\n"
          f"({', '.join(str(each['linked_helpers']) for each in result['library'])} bytes); its memory is the "
          "program's.\n"
          "stack: frames by gcc -fstack-usage along the deepest way through the calls in the\n"
          f"machine code; the firmware's with {EXCEPTION_FRAME} bytes for an interrupt; of the library, of all public\n"
          "functions, linked or not. At least: where a pointer may lead further, as below. measured: the\n"
          "deepest that was seen in a run. RAM without stacks.")
    for each in result["firmware"] + result["library"]:
        print(f"deepest, {each.get('core', result['board'])}: {' > '.join(each['stack_path'])}")
        if each["not_bounded"]:
            print(f"  not bounded: {', '.join(each['not_bounded'])}")
    proof = result["proof"]
    if proof["passes"]:
        print(f"{coloured('no float, no heap', 'green')}: linked alone for {proof['core']}; "
              f"asks only for {', '.join(proof['undefined']) or 'nothing'}")
    else:
        print(f"{coloured('FAIL', 'red')}: the library for {proof['core']} is not free of float and heap:")
        print("\n".join(f"  {line}" for line in proof["wrong"]))


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    libraries = dict(item.split("=", 1) for item in options.library)
    if not libraries:
        raise ToolError("--library CORE=FILE is missing: the proof needs one")
    proved = PROOF_CORE if PROOF_CORE in libraries else next(iter(libraries))
    result = {"board": options.board,
              "firmware": [{**measure_firmware(options.elf, options.cross, options.usage),
                            "stack_measured": measure_run(options.board, options.elf, SCENES)}]
              if options.elf else [],
              "library": [measure_library(core, file, options.cross, pathlib.Path(file).parent)
                          for core, file in libraries.items()],
              "proof": prove_pure(libraries[proved], options.cross, proved)}
    output.write_json(options.out, result)
    print_sizes(result)
    print(f"JSON: {one_line(options.out)}", file=sys.stderr)
    spent.tell()
    return 0 if result["proof"]["passes"] else 1
