#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes a board's persistent flash image: a program and a scene."""

import argparse

from fixel.errors import run_main
from fixel.flash import flash
from fixel.table import table


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--board", required=True, help="the board that both must be for")
    parser.add_argument("--elf", required=True, help="the program")
    parser.add_argument("--scene", required=True, help="the scene image (.fxls)")
    parser.add_argument("--image", required=True, help="the flash image to write")
    options = parser.parse_args(argv)
    result = flash(options.board, options.elf, options.scene, options.image)
    rows = [(part.name, f"{part.address:#010x}", part.size, part.room) for part in result.parts]
    print(table(rows, ("part", "address", "bytes", "of")))
    if result.sector_size:
        print(f"{result.sectors_erased} sectors of {result.sector_size} bytes erased and programmed")
    print(f"{result.verified} bytes verified: {result.image}")
    return 0


if __name__ == "__main__":
    run_main(main)
