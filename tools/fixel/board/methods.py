# SPDX-License-Identifier: MIT
"""The program that a board runs, and the clipper and the visibility method that it draws with."""

import dataclasses
import functools
import pathlib

from fixel.base.errors import ToolError

TABLE = pathlib.Path(__file__).resolve().parents[3] / "firmware/visibility.txt"
WALK = "walk"   # the program whose frames the judge can draw too: only the eye moves


@dataclasses.dataclass(frozen=True)
class Row:
    """What a value of VISIBILITY= stands for."""
    order: str          # "distance" or "tree"
    depth_bits: int
    shows_surfaces: bool
    target: str         # the study's, or ""


@functools.cache
def rows():
    """{value of VISIBILITY=: Row}."""
    lines = (line.split() for line in TABLE.read_text(encoding="ascii").splitlines() if line and line[0] != "#")
    return {name: Row(order, int(depth), faces == "all", target.removeprefix("-")) for name, order, depth, faces, target in lines}


def add_options(parser):
    """--program, --visibility, --clipper and --rows. make knows the names, and refuses others."""
    parser.add_argument("--program", default=WALK, help="the program (default: walk)")
    parser.add_argument("--visibility", help="the visibility method (default: what the scene asks for, its BSP "
                                             "tree or its surfaces if it has some, else sorted)")
    parser.add_argument("--clipper", help="the clipper (default: view)")
    parser.set_defaults(driver=None)    # fixel run alone takes one
    parser.add_argument("--rows", help="the most rows of a band (default: what fits into the board's memory)")


def program(options):
    """The name of the program of a choice; firmware/firmware.mk says the same."""
    rows = (f"-rows-{options.rows}" if options.rows else "") + (f"-on-{options.driver}" if options.driver else "")
    if not options.visibility and not options.clipper:
        return options.program + rows
    return f"{options.program}-{options.visibility or 'unasked'}-{options.clipper or 'view'}{rows}"


def program_on_board(options):
    """The name of the program that draws on --board: on the host make run has one that draws whole frames."""
    return program(options) + ("-whole" if options.whole_frames else "")


def check(options):
    """Refuses a choice beside what a scene is asked to be drawn as; scene_options.check comes before."""
    asked = options.target
    if not options.visibility:
        return
    if options.visibility not in rows():
        raise ToolError(f"there is no VISIBILITY {options.visibility!r}; the visibility methods are: {', '.join(rows())}")
    if asked.order or asked.depth:
        raise ToolError(f"VISIBILITY={options.visibility} stands for an order and a depth: leave it out, or leave out "
                        f"{dataclasses.replace(asked, pixels=None).text}")


# place pixel-format: which target a scene is drawn by
def check_scene(options, scene):
    """Refuses a choice for a scene image that asks for RGB565."""
    if options.visibility and rows()[options.visibility].target and scene.pixel_bits == 16:
        raise ToolError(f"VISIBILITY={options.visibility} draws palette indices alone, and the scene asks for RGB565: leave it out, "
                        "or give PIXELS=palette")


def depth_bits(options, scene):
    """Bits of the depth buffer that a scene image is drawn with; 0 without one."""
    return rows()[options.visibility].depth_bits if options.visibility else scene.depth_bits


def shows_surfaces(options):
    """Whether the choice draws a scene's surfaces, if it has some."""
    return not options.visibility or rows()[options.visibility].shows_surfaces


def judge_options(options):
    """The choice in the words of the judge and of the reference renderer in the live window."""
    return [*(["--hidden", options.visibility] if options.visibility else []),
            *(["--clipper", options.clipper] if options.clipper else [])]


def elf_of(board, build, name=WALK):
    """A program built for a board."""
    from fixel.board import firmware    # it needs a package, and whoever reads the options of a command needs none
    return pathlib.Path(build) / "boards" / board / f"{name}{'' if board == firmware.HOST else '.elf'}"
