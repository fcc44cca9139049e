# SPDX-License-Identifier: MIT
"""Writes a bitmap font, a BDF file, as a C header for fxl_draw_text.

    fixel font FONT.bdf -o OUT.h [--name NAME] [--characters FIRST-LAST]
        NAME: by default that of the file, with _ for what no C name has
        FIRST-LAST: codes of Latin-1, by default 32-126, or all of a font that has none of these"""

import argparse

from fixel import commands


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    made.add_argument("font", help="a BDF file")
    made.add_argument("-o", "--out", required=True)
    made.add_argument("--name", help="what the header's names begin with; without, the file's name")
    made.add_argument("--characters", metavar="FIRST-LAST", help="codes, 32-126 by default")
    return made


main = commands.main_of(parser, "fixel.image.c_font")
