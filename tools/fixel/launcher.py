# SPDX-License-Identifier: MIT
"""fixel COMMAND: the tools as commands of one program, .venv/bin/fixel, which set-up makes.

It imports the tool that is asked for and nothing else: a command needs only the Python packages of its own tool.
"""

import importlib
import os
import pathlib
import sys

TOOLS = pathlib.Path(__file__).resolve().parents[1]

SCENE = "fixel.scene.command"   # has several commands, and takes their name as its first word
# {room: {command: (module, one line of help)}}
ROOMS = {
    "Scenes": {
        "build": (SCENE, "compile a scene file or a model into a scene image"),
        "export": (SCENE, "write a scene as a C header"),
        "info": (SCENE, "say what is in a scene image"),
        "texture": (SCENE, "write an image as a texture in C"),
        "font": ("font", "write a font as a C header"),
    },
    "Boards": {
        "run": ("run", "draw a scene's path on a board, and compare it with double"),
        "screen": ("screen", "save what a board's screen shows"),
        "flash": ("flash", "write a program and a scene to a board"),
        "boot": ("boot", "boot a board from its flash image"),
        "gdb": ("gdb", "open a debugger on a board"),
        "boards": ("boards", "compare all boards"),
        "view": ("view", "show a board live on a web page"),
        "record": ("record", "record the live window"),
    },
    "Pictures and reports": {
        "compare": ("compare", "compare pictures, folders of pictures, or frame dumps"),
        "wire": ("wire", "draw a scene's path as wireframes"),
        "report": ("report", "measure every claim about accuracy"),
        "pictures": ("pictures", "make a picture of the documents from frames"),
        "first-program": ("first_program", "draw the picture of an example"),
    },
    "What it costs": {
        "predict": ("predict", "predict flash, RAM, stack and instructions a frame"),
        "size": ("size", "print flash, RAM and stack"),
        "bench": ("bench", "count the instructions of frames and kernels"),
        "bench-diff": ("bench_diff", "compare a bench with the baseline"),
        "clippers": ("clippers", "compare every clipper with every visibility method"),
        "costs": ("costs", "measure what predict predicts from"),
        "profile": ("profile_frame", "show where a workload's instructions go"),
    },
    "Tests": {
        "test": ("test", "run the tests that make has built"),
        "coverage": ("coverage", "print what the library's tests reach"),
        "equality": ("equality", "compare every kernel with the portable one"),
        "frame-hashes": ("frame_hashes", "add a scene's hashes to the record"),
        "fuzz": ("fuzz", "fuzz the library and the tools' input"),
        "kills": ("kills", "kill commands at random moments"),
        "mutants": ("mutants", "put random small mistakes into the library"),
        "tool-mutants": ("tool_mutants", "put random small mistakes into the tools"),
        "seeded-bugs": ("seeded_bugs", "break the library on purpose"),
    },
}
COMMANDS = {name: tool for room in ROOMS.values() for name, (tool, _) in room.items()}


def usage():
    """The list of commands, by room."""
    width = max(map(len, COMMANDS))
    rooms = ("\n".join([f"{room}:", *(f"  {name:{width}}  {what}" for name, (_, what) in commands.items())])
             for room, commands in ROOMS.items())
    return "usage: fixel COMMAND ...\n\n" + "\n\n".join(rooms) + "\n\nfixel COMMAND --help tells more of one."


def main(argv):
    """Runs a command; the exit code."""
    from fixel.base.errors import ToolError
    from fixel.base.nearest import question
    name, *words = argv or ["--help"]
    if name in ("-h", "--help"):
        print(usage())
        return 0
    if name not in COMMANDS:
        raise ToolError(f"fixel has no command '{name}'{question(name, COMMANDS)} (see fixel --help)")
    tool = importlib.import_module(COMMANDS[name])
    sys.argv[0] = "fixel" if COMMANDS[name] == SCENE else f"fixel {name}"
    return tool.main([name, *words] if COMMANDS[name] == SCENE else words)


if __name__ == "__main__":
    sys.path[0] = str(TOOLS)
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")     # interpreter.py says why
    from fixel.base import interpreter
    sys.excepthook = interpreter.explain
    from fixel.base.errors import run_main
    run_main(main)
