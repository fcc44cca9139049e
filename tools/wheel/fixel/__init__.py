# SPDX-License-Identifier: MIT
"""Fixel on this machine: render() draws a scene or a model, and the command fixel has the tools.

The tools' own modules (fixel.scene, fixel.image and so on) stand below fixel/tree as in a checkout, where they find what they
read. They may change with any version; render() is what a program calls.
"""

import pathlib

TREE = pathlib.Path(__file__).resolve().parent / "tree"
__path__.append(str(TREE / "tools" / "fixel"))

from fixel.base.version import version as _version
from fixel.base.errors import ToolError as Error

__version__ = _version()


def render(scene, frames=None, size=None, **options):
    """Draws a scene's path; a NumPy array of uint8: frames, rows, columns, and red, green and blue.

    scene: a scene file (.toml), a model (.obj, .gltf, .glb, .stl, .ply) or a scene image (.fxls). frames: how many, instead of
    the whole path. size: (width, height) instead of the scene's. Other options are those of "fixel run --help" with _ for -:
    pixels="rgb565", depth=16, palette=True. indices=True gives the pixels as the library draws them, without a last axis:
    entries of the palette, or RGB565 as uint16.
    Raises fixel.Error with a sentence where the scene or an option is refused.
    """
    from fixel import drawn
    return drawn.render(scene, frames, size, options)
