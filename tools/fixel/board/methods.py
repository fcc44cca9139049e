# SPDX-License-Identifier: MIT
"""The program that a board runs, and the clipper and the visibility method that it draws with."""

import pathlib

DEPTH_BITS = {"depth": 16, "depth-32": 32}  # of the visibility methods with a depth buffer
WALK = "walk"   # the program whose frames the judge can draw too: only the eye moves


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


def depth_bits(options, scene):
    """Bits of the depth buffer that a scene image is drawn with; None without one."""
    if options.visibility:
        return DEPTH_BITS.get(options.visibility)
    return scene.depth_bits or None


def shows_surfaces(options):
    """Whether the choice draws a scene's surfaces, if it has some."""
    return options.visibility in (None, "surfaces", *DEPTH_BITS)


def judge_options(options):
    """The choice in the words of the judge and of the reference renderer in the live window."""
    return [*(["--hidden", options.visibility] if options.visibility else []),
            *(["--clipper", options.clipper] if options.clipper else [])]


def elf_of(board, build, name=WALK):
    """A program built for a board."""
    from fixel.board import firmware    # it needs a package, and whoever reads the options of a command needs none
    return pathlib.Path(build) / "boards" / board / f"{name}{'' if board == firmware.HOST else '.elf'}"
