# SPDX-License-Identifier: MIT
"""Draws the first program (examples/cube), another example, or a pair of docs/looks.md on this machine and writes its picture."""

import argparse
import pathlib
import sys

from fixel.base import children, scratch
from fixel.base.errors import ToolError
from fixel.commands import late
from fixel.report.pictures import GAP

Image = late("PIL.Image")
output, picture = late("fixel.base", "output picture")
dump = late("fixel.board", "dump")
examples = late("fixel.report", "examples")

ROOT = pathlib.Path(__file__).resolve().parents[3]
MODELS = "host_tests/tools/models"
# Of each pair: file and options that look wrong, and those that look right. Both are drawn from the frame of this number.
LOOKS = {
    "order": ("scenes/gallery.toml --depth 0", "scenes/gallery.toml", 2),
    "tree": ("scenes/knot.toml --order distance", "scenes/knot.toml", 2),
    "backs": ("docs/looks/open.toml", "docs/looks/open_both.toml", 2),
    "facets": (f"{MODELS}/ball_textured.obj --flat", f"{MODELS}/ball_textured.obj --smooth 40", 2),
    "mean": (f"{MODELS}/plain_texture.glb --no-textures", f"{MODELS}/plain_texture.glb", 2),
    "colours": (f"{MODELS}/vertex_colours.obj --palette", f"{MODELS}/vertex_colours.obj", 2),
    "dark": ("docs/looks/dark.toml", "docs/looks/lit.toml", 0),
    "decal": ("docs/looks/decal.toml --depth 16", "docs/looks/decal.toml --depth 32", 3),
}
SCREEN, FRAMES = "160x120", 8


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
    if options.look:
        output.write_file(options.out, picture.png_bytes(pair(options.library.parent / "frames", options.look)))
        return 0
    if options.hud:
        pixels, palette = examples.draw_hud(options.library)
    elif options.example in examples.WIDE_PICTURES:
        pixels, palette = examples.draw_wide(options.library, options.example), picture.rgb565_colours()
    else:
        pixels, palette = examples.draw_example(options.library, options.example)
    output.write_file(options.out, picture.png_bytes(picture.palette_image(pixels, palette)))
    return 0


def draw(frames, words, number):
    """A frame of a scene that is built with options. frames: the program build/host/frames."""
    with scratch.folder("look") as folder:
        image, drawn = pathlib.Path(folder) / "look.fxls", pathlib.Path(folder) / "look.fxld"
        for command in ([sys.executable, ROOT / "tools" / "fixel" / "launcher.py", "build", *words.split(), "--screen", SCREEN, "--frames", FRAMES,
                         "-o", image], [frames, image, drawn]):
            done = children.run(list(map(str, command)), cwd=ROOT, text=True)
            if done.returncode != 0:
                raise ToolError(f"{words} cannot be drawn", words=done.stderr.strip())
        made = dump.read_dump(drawn)
    return picture.palette_image(made.frames[number].pixels, made.palette).convert("RGB")


def pair(frames, name):
    """Both pictures of a pair, side by side."""
    if name not in LOOKS:
        raise ToolError(f"there is no look '{name}'; there are: {', '.join(LOOKS)}")
    wrong, right, number = LOOKS[name]
    shown = [draw(frames, words, number) for words in (wrong, right)]
    width, height = shown[0].size
    row = Image.new("RGB", (2 * width + GAP, height), (255, 255, 255))
    row.paste(shown[0], (0, 0))
    row.paste(shown[1], (width + GAP, 0))
    return row
