# SPDX-License-Identifier: MIT
"""Looks at the values of a make command's variables before anything is installed or built: one that its tool would refuse is
refused now, in one sentence.

    python3 tools/fixel/base/before.py COMMAND

It runs by any Python, without the packages of .venv. It reads the variables by the command's own options, and asks what all
commands have in common: whether the scene is there, whether a result can be written. A command that knows more has a function
before(options) beside its parser(), which imports no package either.
"""

import importlib
import os
import pathlib
import sys

if __name__ == "__main__":
    sys.path[0] = str(pathlib.Path(__file__).resolve().parents[2])

from fixel import commands
from fixel.base import bounded, make, reading
from fixel.base.errors import ToolError, run_main
from fixel.campaign import runner
from fixel.model import suffixes
from fixel.scene import look, scene_options

RESULTS = ("out", "keep", "json", "badge")   # options that name a result


def asked(name, words):
    """The options that words make of a command's parser, without those that its recipe adds."""
    parser = commands.parser(name)
    for part in (*parser._actions, *parser._mutually_exclusive_groups):     # argparse has no other way
        part.required = False
    for action in parser._actions:
        if not action.option_strings and action.nargs not in ("?", "*"):
            action.nargs = "*"

    def refuse(message):
        raise ToolError(f"make {name}: {message}")
    parser.error = refuse
    options = parser.parse_args(words)
    for action in parser._actions:
        value = getattr(options, action.dest, None)
        if action.type in (int, float) and isinstance(value, (int, float)) and not value >= 0:
            refuse(f"{action.option_strings[0]} is {value}; it must not be negative")
    return options


def check_scene(options):
    """The scene of a command that draws one, and how it is to be drawn."""
    if options.scene is not None:
        reading.open_regular(options.scene)[0].close()
        if pathlib.Path(options.scene).suffix != ".fxls":
            suffixes.check_scene(options.scene)
    if hasattr(options, "has_targets"):
        given, options.scene = options.scene, options.scene or "scenes/plaza.toml"     # the recipe has another one
        scene_options.check(options)
        look.check(options.look, options.scene, suffixes.is_model(options.scene))
        options.scene = given


def check_result(path):
    """Whether a file or folder can be made at a path: the nearest folder above it that is there can be written in."""
    place = pathlib.Path(os.path.abspath(path))
    above = next(each for each in (place, *place.parents) if each.exists())
    if above != place and not above.is_dir():
        raise ToolError(f"{path}: cannot be written: {above} is a file; name another place")
    if not os.access(above, os.W_OK) or str(above).startswith(("/proc", "/sys")):
        raise ToolError(f"{path}: cannot be written: {above} takes no files; name another place")


def look_at(name, environment):
    """Refuses what the command's tool would refuse."""
    options = asked(name, make.options(name, environment))
    if hasattr(options, "scene"):
        check_scene(options)
    if hasattr(options, "cpu_limit"):
        bounded.limits_of(options)
    if hasattr(options, "cluster"):
        runner.check(options)
    for result in RESULTS:
        if getattr(options, result, None) not in (None, True, False, "", "-"):
            check_result(getattr(options, result))
    module = importlib.import_module(commands.COMMANDS[name])
    if hasattr(module, "before"):
        module.before(options)


def look_at_command(argv):
    """The exit code. argv: the command. A command without a tool has nothing that is looked at."""
    if argv[0] in commands.COMMANDS and argv[0] in make.variables():
        look_at(argv[0], os.environ)
    return 0


if __name__ == "__main__":
    run_main(look_at_command)
