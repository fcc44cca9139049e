# SPDX-License-Identifier: MIT
"""Draws a scene's path as wireframes on this machine, and compares them with double."""

import argparse

from fixel.base import kept
from fixel.base import bounded


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    made.add_argument("--scene", required=True, help="a .toml, a model (.obj, .gltf, .glb, .stl), or a scene image (.fxls)")
    made.add_argument("--frames", help="number of frames (default: the whole path)")
    made.add_argument("--screen", help="width and height, like 128x64 (default: the scene's)")
    bounded.add_options(made)
    made.add_argument("--out", default="build/wire", help="folder for the results")
    made.add_argument("--build", default="build", help="folder that make builds in")
    kept.add_option(made)
    return made


def main(argv):
    options = parser().parse_args(argv)
    from fixel.report import wireframes
    return wireframes.command(options)
