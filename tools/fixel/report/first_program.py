# SPDX-License-Identifier: MIT
"""Draws the first program (examples/cube), another example, or a pair of docs/looks.md on this machine and writes its picture."""

import argparse
import pathlib


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    made.add_argument("--library", type=pathlib.Path, required=True, help="libfixel.a of this machine")
    made.add_argument("--out", type=pathlib.Path, required=True, help="the picture, a PNG")
    made.add_argument("--hud", action="store_true", help="with text and sprites over it (host_tests/boards/examples/hud.c)")
    made.add_argument("--example", default="cube", metavar="NAME", help="a folder of examples, such as maze")
    made.add_argument("--look", metavar="NAME", help="a pair of pictures of docs/looks.md, by the program `frames` beside the library")
    return made


def main(argv):
    options = parser().parse_args(argv)
    from fixel.base import output, picture
    from fixel.report import examples
    if options.look:
        from fixel.report import looks
        output.write_file(options.out, picture.png_bytes(looks.pair(options.library.parent / "frames", options.look)))
        return 0
    if options.hud:
        pixels, palette = examples.draw_hud(options.library)
    elif options.example in examples.WIDE_PICTURES:
        pixels, palette = examples.draw_wide(options.library, options.example), picture.rgb565_colours()
    else:
        pixels, palette = examples.draw_example(options.library, options.example)
    output.write_file(options.out, picture.png_bytes(picture.palette_image(pixels, palette)))
    return 0
