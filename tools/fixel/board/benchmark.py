# SPDX-License-Identifier: MIT
"""Runs the benchmark for real boards on the host or on an emulated board, and writes the file that the real one takes."""

import argparse

from fixel import commands


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    made.add_argument("--board", required=True, help="the board of the program")
    made.add_argument("--elf", required=True, help="the program, firmware/benchmark")
    made.add_argument("--uf2", help="the UF2 file to write, for a board that takes one")
    return made


main = commands.main_of(parser, "fixel.board.benchmarking")
