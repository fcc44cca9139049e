# SPDX-License-Identifier: MIT
"""fixel.render: the frames that the host's walk draws of a scene, as an array."""

import argparse
import os
import pathlib

import numpy

from fixel import programs
from fixel.base import scratch
from fixel.base.errors import ToolError
from fixel.board import drawing, dump, firmware, methods, model_look
from fixel.base import kept
from fixel.scene import scene_options


class _Parser(argparse.ArgumentParser):
    """Options of a function: a mistake is an error, not the end of the program."""

    def error(self, message):
        raise ToolError(message)


def words(options):
    """The words of a command line that options of render become."""
    for name, value in options.items():
        option = f"--{name.replace('_', '-')}"
        if value is True:
            yield option
        elif value is not None and value is not False:
            yield f"{option}={value}"


def parsed(scene, frames, size, options):
    parser = _Parser(prog="fixel.render", add_help=False)
    scene_options.add(parser)
    methods.add_options(parser)
    kept.add_option(parser)
    more = {"frames": frames, "screen": f"{size[0]}x{size[1]}" if size else None, **options}
    found = parser.parse_args([f"--scene={os.fspath(scene)}", *words(more)])
    scene_options.check(found)
    methods.check(found)
    return found


def render(scene, frames, size, options):
    indices = options.pop("indices", False)
    found, build = parsed(scene, frames, size, options), programs.build()
    elf = methods.elf_of(firmware.HOST, build, methods.program(found))
    with scratch.folder("render", build) as folder:
        image = model_look.scene_image(found, elf, folder)
        read = dump.read_dump(drawing.draw(kept.Kept(build, found.fresh), "board", firmware.HOST, elf, image, pathlib.Path(folder), found.frames))
    pixels = numpy.stack([frame.pixels for frame in read.frames])
    return pixels if indices else read.palette[pixels]
