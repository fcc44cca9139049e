# SPDX-License-Identifier: MIT
"""The commands of fixel: their modules, and how one starts.

A command's module has parser(), its options, and main(argv), which does its work. It is imported when the command starts, and no
other's. Options are read without any Python package (base/before.py, fixel completion), so the module imports by late() what needs one.
"""

import importlib
import sys

SCENE = "fixel.scene.command"   # has several commands, and takes their name as its first word
# {room: {command: (module, one line of help)}}
ROOMS = {
    "Scenes": {
        "build": (SCENE, "compile a scene file or a model into a scene image"),
        "export": (SCENE, "write a scene as a C header"),
        "info": (SCENE, "say what is in a scene image, a scene file or a model"),
        "texture": (SCENE, "write an image as a texture in C"),
        "font": ("fixel.image.font", "write a font as a C header"),
        "formats": ("fixel.image.formats", "write what C and documents say of an image's fields"),
    },
    "Boards": {
        "run": ("fixel.board.run", "draw a scene's path on a board, and compare it with double"),
        "screen": ("fixel.board.screen", "save what a board's screen shows"),
        "flash": ("fixel.board.flash", "write a program and a scene to a board"),
        "boot": ("fixel.board.boot", "boot a board from its flash image"),
        "gdb": ("fixel.board.gdb", "open a debugger on a board"),
        "boards": ("fixel.board.boards", "compare all boards"),
        "benchmark": ("fixel.board.benchmark", "run the benchmark for real boards, and write its UF2 file"),
        "crc": ("fixel.board.crc", "print the CRC-32 of each frame of a frame dump"),
        "view": ("fixel.view.view", "show a board live on a web page"),
        "record": ("fixel.view.record", "record the live window"),
    },
    "Pictures and reports": {
        "compare": ("fixel.report.compare", "compare pictures, folders of pictures, or frame dumps"),
        "wire": ("fixel.report.wire", "draw a scene's path as wireframes"),
        "report": ("fixel.report.report", "measure every claim about accuracy"),
        "pictures": ("fixel.report.pictures", "make a picture of the documents from frames"),
        "showcase": ("fixel.report.showcase", "make a page of 24 models as people have them"),
        "first-program": ("fixel.report.first_program", "draw the picture of an example"),
    },
    "What it costs": {
        "predict": ("fixel.bench.predict", "predict flash, RAM, stack, instructions and cycles a frame"),
        "size": ("fixel.bench.size", "print flash, RAM and stack"),
        "bench": ("fixel.bench.bench", "count the instructions of frames and kernels"),
        "bench-diff": ("fixel.bench.bench_diff", "compare a bench with the baseline"),
        "clippers": ("fixel.bench.clippers", "compare every clipper with every visibility method"),
        "costs": ("fixel.bench.costs", "measure what predict predicts from"),
        "profile": ("fixel.bench.profile", "show where a workload's instructions go"),
    },
    "Tests": {
        "test": ("fixel.check.test", "run the tests that make has built"),
        "test-anywhere": ("fixel.check.test_anywhere", "run the tests of packages and of other machines"),
        "breaks": ("fixel.check.breaks", "break what the project claims, and see which commands notice"),
        "changed": ("fixel.check.changed", "build pictures up from what changed, and compare them with whole frames"),
        "corpus": ("fixel.check.corpus", "list the fuzzer's corpus, or add an input"),
        "coverage": ("fixel.check.coverage", "print what the library's tests reach"),
        "coverage-builds": ("fixel.check.coverage_builds", "print what of the library's other builds runs on emulated cores"),
        "equality": ("fixel.check.equality", "compare every kernel with the portable one"),
        "frame-hashes": ("fixel.check.frame_hashes", "add a scene's hashes to the record"),
        "fuzz": ("fixel.check.fuzz", "fuzz the library and the tools' input"),
        "kills": ("fixel.check.kills", "kill commands at random moments"),
        "mutants": ("fixel.check.mutants", "put random small mistakes into the library and the tools"),
        "places": ("fixel.check.places", "print the places of a recipe of CONTRIBUTING.md"),
        "prove": ("fixel.prove.prove", "prove properties of the library for every input"),
        "rules": ("fixel.check.rules", "check the library by the rules of MISRA C:2012"),
        "size-of-tree": ("fixel.check.size_of_tree", "count files, lines, places and build steps against a record"),
        "seeded-bugs": ("fixel.check.seeded_bugs", "break the library on purpose"),
        "trace": ("fixel.check.trace", "join clauses of the specification with code and tests"),
    },
    "Packages": {
        "release": ("fixel.package.release", "build every artefact of a version into dist"),
        "api-check": ("fixel.package.api_check", "compare the public headers and functions with the last tag"),
        "one-file": ("fixel.package.one_file", "write the library as fixel.h and fixel.c"),
        "site": ("fixel.site.site", "write the site: a page that draws, and all documents"),
        "docs": ("fixel.site.docs", "write all documents, and the reference of the public functions, as pages"),
        "packages": ("fixel.package.packages", "write packages for Arduino, PlatformIO, ESP-IDF, Zephyr, Conan and Rust"),
    },
    "Shell and Makefile": {
        "completion": ("fixel.base.completion", "print a script that completes commands in bash or zsh"),
        "make": ("fixel.base.make", "a command with the options that variables of make become"),
    },
}
COMMANDS = {name: tool for room in ROOMS.values() for name, (tool, _) in room.items()}


def parser(name):
    """The options of a command, as argparse has them. It imports no package."""
    module = importlib.import_module(COMMANDS[name])
    return module.parsers()[name] if COMMANDS[name] == SCENE else module.parser()


class Late:
    """A module that is imported when one of its names is first asked for. What is put into it, by a test, the module gets."""
    __slots__ = ("__name__",)   # no __dict__ of its own: that of the module is found

    def __init__(self, name):
        object.__setattr__(self, "__name__", name)

    def __getattr__(self, name):
        return getattr(importlib.import_module(self.__name__), name)

    def __setattr__(self, name, value):
        setattr(importlib.import_module(self.__name__), name, value)


def late(package, modules=""):
    """What a command's module works with and its options do without: a package, or modules of it, imported when they are first used.
    modules: their names, with blanks between."""
    made = [Late(f"{package}.{name}") for name in modules.split()]
    return made[0] if len(made) == 1 else made or Late(package)


def start(name, words, program="fixel"):
    """Runs a command; the exit code. program: what it says that it is, before its name."""
    module = COMMANDS[name]
    tool = importlib.import_module(module)
    sys.argv[0] = program if module == SCENE else f"{program} {name}"
    return tool.main([name, *words] if module == SCENE else words)
