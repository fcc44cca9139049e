# SPDX-License-Identifier: MIT
"""Scene files into scene images or C headers, and scene images explained.

    fixel build SCENE -o OUT.fxls [--frames N] [--screen WxH] [--tree LAYERS]
                [--pixels palette|rgb565] [--order distance|tree] [--depth 0|16|32] [LOOK]
        SCENE is a .toml or a model (.obj, .gltf, .glb, .stl, .ply); LAYERS: 5, or 2,4,5, or all, or most (that of most faces),
        or none; without --tree, what the scene's key "tree" says;
        --pixels, --order and --depth stand in the place of what its [view] says;
        LOOK, of a model: [--palette] [--flat | --smooth DEGREES] [--no-textures] [--sorted] [--write SCENE.toml]
    fixel export --c SCENE -o OUT.h [--program FILE.c] [--board NAME] [--name NAME] [--frames N] [--screen WxH] [--tree LAYERS]
                [--pixels palette|rgb565] [--order distance|tree] [--depth 0|16|32] [LOOK]
        SCENE is a .toml, a model or a .fxls; --frames N exports the path too, as N poses
    fixel texture IMAGE -o OUT.h [--name NAME] [--size WxH] [--levels N] [--clamp]
        an image as a texture of a program's RGB565 frames
    fixel info OUT.fxls [--json]

tools/scene.py is the same without set-up's fixel: scene.py build ..."""

import argparse
import contextlib
import io
import os
import re
import sys

from fixel.base import bounded, scratch
from fixel.base.errors import ToolError, one_line
from fixel.base.reading import quoted
from fixel.image import c_names, image_surface
from fixel.model import suffixes
from fixel.scene import look, making, target


def whole(text):
    """A number of frames from the command line, as argparse wants it."""
    if not re.fullmatch("[+-]?[0-9]{1,19}", text):
        raise argparse.ArgumentTypeError(f"{quoted(text)} is not a whole number")
    return int(text)


def takes_frames(scene):
    """Whether --frames adds a path to the header of a scene: not of a scene image."""
    return suffixes.suffix_of(scene) != ".fxls"


def make_texture(arguments):
    """Writes an image as a texture in C."""
    from fixel.scene import texture
    sides = re.fullmatch(r"([0-9]{1,3})x([0-9]{1,3})", arguments.size) if arguments.size else None
    size = tuple(map(int, sides.groups())) if sides else None
    if arguments.size and (size is None or not set(size) <= set(texture.SIDES)):
        raise ToolError(f"--size is {quoted(arguments.size)}; it must be like 64x32, both powers of two from 1 to "
                        f"{texture.SIDE_MAX}")
    if not 1 <= arguments.levels <= image_surface.LEVELS_MAX:
        raise ToolError(f"--levels is {arguments.levels}; it must be from 1 to {image_surface.LEVELS_MAX}")
    name = arguments.name or c_names.name_of_file(arguments.image, "texture")
    texels, notes = making.texture(arguments.image, arguments.out, name, size, arguments.levels, arguments.clamp,
                                   bounded.limits_of(arguments))
    making.tell_notes(notes)
    print(f"{one_line(arguments.out)}: {name}_texture, {2 * texels:,} bytes of texels")


# place pixel-format: the help of the option pixels
def _parsers():
    """The options of the commands: of all together, and {command: its own}."""
    made = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    commands = made.add_subparsers(dest="command", required=True)
    building = commands.add_parser("build", help="compile a .toml or a model into a scene image")
    exporting = commands.add_parser("export", help="write a .toml, a model or a .fxls as a C header")
    exporting.add_argument("--c", action="store_true", required=True, help="as C, the only language there is")
    exporting.add_argument("--program", metavar="FILE.c", help="write a program too that draws the scene in bands, with its path")
    exporting.add_argument("--board", help="a model as make run BOARD= draws it there (default: the best look, as on the host)")
    exporting.add_argument("--name", help="what the header's names begin with; without, the file's name")
    for command in (building, exporting):
        command.add_argument("scene")
        command.add_argument("-o", "--out", required=True)
        command.add_argument("--frames", type=whole, help="frames of the path; export writes no path without it")
        command.add_argument("--screen", help="width and height instead of the scene's, like 128x64")
        command.add_argument("--tree", metavar="LAYERS", help="draw these layers by a tree: 5, or 2,4,5, or all, or most, "
                             "or none, instead of what the scene says")
        target.add_options(command)
        look.add_options(command)
    drawing = commands.add_parser("texture", help="write an image as a texture of RGB565, in C")
    drawing.add_argument("image")
    drawing.add_argument("-o", "--out", required=True)
    drawing.add_argument("--name", help="what the header's names begin with; without, the file's name")
    drawing.add_argument("--size", help="width and height to scale it to, like 64x64")
    drawing.add_argument("--levels", type=whole, default=1, help="with smaller pictures for what is far, so many in all")
    drawing.add_argument("--clamp", action="store_true", help="beyond its edge it shows the texel of the edge")
    for command in (building, exporting, drawing):
        bounded.add_options(command)
    telling = commands.add_parser("info", help="say what is in a scene image, or in that of a .toml or a model")
    telling.add_argument("image", help="a .fxls; a .toml or a model is compiled as build does, and nothing is written")
    telling.add_argument("--json", action="store_true")
    return made, commands.choices


def parser():
    """The options of the commands, together."""
    return _parsers()[0]


def parsers():
    """{command: its options}."""
    return _parsers()[1]


def tell_of(arguments):
    """Says what is in a scene image. A scene file or a model is compiled first, with what build says of it on standard error."""
    from fixel.scene import summary
    if suffixes.suffix_of(arguments.image) == ".fxls" or not os.path.exists(arguments.image):
        summary.info(arguments.image, arguments.json)
        return 0
    with scratch.folder("info") as folder:
        compiled, said = os.path.join(folder, "scene.fxls"), io.StringIO()
        try:
            with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
                main(["build", arguments.image, "-o", compiled])
        finally:
            print(said.getvalue().replace(compiled, one_line(arguments.image)), end="", file=sys.stderr)
        summary.info(compiled, arguments.json, arguments.image)
    return 0


def main(argv):
    arguments = parser().parse_args(argv)
    if arguments.command == "info":
        return tell_of(arguments)
    if arguments.command == "texture":
        make_texture(arguments)
        return 0
    limits, screen = bounded.limits_of(arguments), making.parse_screen(arguments.screen) if arguments.screen else None
    asked, wanted = target.of_options(arguments), look.of_options(arguments)
    is_model = suffixes.is_model(arguments.scene)
    look.check(wanted, arguments.scene, is_model)
    has_tree = arguments.tree not in (None, "none")
    how = {"looks": look.smaller(wanted, *look.targets(wanted, asked, has_tree)[0]), "write": wanted.write, "writes": True} if is_model else {}
    board, rows = getattr(arguments, "board", None), making.ROWS
    if board and not is_model:
        raise ToolError(f"--board is for a model without a scene file; {arguments.scene} says itself how it is drawn")
    if board and board != "host":
        from fixel.bench import predict
        drawn = predict.drawn_of(board, arguments, screen, asked, wanted)
        how["looks"], rows = [drawn.look], min(rows, drawn.rows)
    common = arguments.frames, screen, arguments.tree, limits, asked
    if arguments.command == "export":
        if arguments.program and wanted.write:
            raise ToolError("--program and --write are for one command each: leave out one of them")
        made = making.export(arguments.scene, arguments.out, arguments.name, *common, verbose=wanted.verbose, program=arguments.program, rows=rows, **how)
    else:
        made = making.build(arguments.scene, arguments.out, *common, verbose=wanted.verbose, **how)
    has_path = arguments.command == "build" or arguments.frames is not None or (arguments.program and made.frames > 0)
    making.tell(arguments.out, made, None if has_path else "no path" + (" (--frames adds one)" if takes_frames(arguments.scene) else ""))
    if arguments.command == "export" and arguments.program:
        print(f"a program that draws it: {one_line(arguments.program)}")
    if wanted.write:
        print(f"the same as a scene file: {one_line(wanted.write)}")
    return 0
