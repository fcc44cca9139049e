# SPDX-License-Identifier: MIT
"""The options by which a command takes a scene: which one, how much of its path, on what screen, within what limits."""

from fixel.base import bounded
from fixel.base.errors import ToolError
from fixel.base.reading import quoted
from fixel.scene import look, making, target

WHAT = "a .toml, a model (.obj, .gltf, .glb, .stl, .ply), or a scene image (.fxls)"
BOARD = "mps2-an385"    # as the Makefile's


def add_board(parser):
    """--board of a command that needs no more of it than its name."""
    parser.add_argument("--board", default=BOARD, help=f"the board (default: {BOARD})")


def add(parser, frames=True, targets=True, looks=True):
    """The scene, --screen, the limits of compiling, --frames, what it is drawn as: --pixels, --order, --depth, and how a model
    looks: --palette and others."""
    parser.add_argument("file", nargs="?", metavar="SCENE", help=WHAT)
    parser.add_argument("--scene", help="the same as an option")
    if frames:
        parser.add_argument("--frames", help="number of frames (default: the whole path)")
    else:
        parser.set_defaults(frames=None)
    parser.add_argument("--screen", help="width and height, like 128x64 (default: the scene's)")
    bounded.add_options(parser)
    parser.set_defaults(has_targets=targets, has_looks=looks)     # another command may have an --order of its own
    if targets:
        target.add_options(parser)
    if looks:
        look.add_options(parser)


def check(options):
    """Makes options.scene of the scene that is named, numbers of --frames and --screen where they are given, and
    options.target and options.look of what it is drawn as."""
    if options.file is not None and options.scene is not None:
        raise ToolError(f"{quoted(options.file)} and --scene {quoted(options.scene)}: a command takes one scene")
    options.scene = options.scene if options.file is None else options.file
    if options.scene is None:
        raise ToolError(f"no scene is named: give {WHAT}")
    options.frames = frame_count(options.frames) if options.frames is not None else None
    options.screen = making.parse_screen(options.screen) if options.screen else None
    options.look = look.of_options(options) if options.has_looks else look.Asked()
    options.target = target.of_options(options) if options.has_targets else target.Target()


def frame_count(text):
    """A number of frames from a command line."""
    if not (text.isascii() and text.isdigit() and len(text) < 20 and 1 <= int(text) <= 1_000_000):
        raise ToolError(f"FRAMES is {quoted(text)}; it must be a whole number from 1 to 1,000,000")
    return int(text)
