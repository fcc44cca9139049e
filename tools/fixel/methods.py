# SPDX-License-Identifier: MIT
"""The clipper and the visibility method that a board's walk draws with: options, and the program that has them."""

import pathlib

from fixel import firmware


def add_options(parser):
    """--visibility and --clipper. make knows the names, and refuses others."""
    parser.add_argument("--visibility", help="the visibility method (default: the scene's BSP tree if it has one, "
                                             "else sorted)")
    parser.add_argument("--clipper", help="the clipper (default: view)")


def suffix(options):
    """What the program of a choice has behind its name; firmware/firmware.mk says the same."""
    if not options.visibility and not options.clipper:
        return ""
    return f"-{options.visibility or 'unasked'}-{options.clipper or 'view'}"


def judge_options(options):
    """The choice in the words of the judge and of the reference renderer in the live window."""
    return [*(["--hidden", options.visibility] if options.visibility else []),
            *(["--clipper", options.clipper] if options.clipper else [])]


def elf_of(board, build, more=""):
    """The walk built for a board; more: the suffix of a choice."""
    return pathlib.Path(build) / "boards" / board / f"walk{more}{'' if board == firmware.HOST else '.elf'}"
