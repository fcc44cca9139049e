# SPDX-License-Identifier: MIT
"""Writes a program and a scene to a board: to its persistent flash image, or by a debug probe to the real one."""

import argparse

from fixel.base import bounded


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    made.add_argument("--board", required=True, help="the board of the program and the scene")
    made.add_argument("--elf", required=True, help="the program")
    made.add_argument("--scene", required=True, help="a scene image (.fxls), or a .toml or a model (.obj, .gltf, .glb, .stl) to compile")
    made.add_argument("--scenes", default="build/scenes", help="folder for the compiled scene image")
    made.add_argument("--frames", help="number of frames (default: the whole path)")
    made.add_argument("--screen", help="width and height, like 128x64 (default: the scene's)")
    made.add_argument("--image", required=True, help="the flash image to write")
    made.add_argument("--probe", default="", help="openocd: program the real board instead")
    made.add_argument("--dry-run", action="store_true", help="with --probe: only print the command")
    bounded.add_options(made)
    return made


def main(argv):
    options = parser().parse_args(argv)
    from fixel.board import flashing
    return flashing.command(options)
