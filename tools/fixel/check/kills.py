# SPDX-License-Identifier: MIT
"""Kills run, flash, boot, view and report at random moments, and looks at what they leave.

After each kill another command runs. Then there must be no process and no file of theirs, and every result must be
whole, the old one or the new one. Exit: 0 so it was, 1 not.
"""

import argparse

from fixel import commands
from fixel.base.arguments import whole_number

KILLS_MAX = 1_000_000

COMMANDS = ("run", "flash", "boot", "view", "view-stream", "report")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--kills", default="200", help="how many (KILLS=)")
    made.add_argument("--seed", default="1", help="of what is killed, by which signal, and when (SEED=)")
    made.add_argument("--commands", nargs="+", default=list(COMMANDS), choices=COMMANDS)
    made.add_argument("--board", required=True, help="an emulated board")
    made.add_argument("--streaming", required=True, help="one that streams its frames to the live window")
    made.add_argument("--samples", default="1000", help="of a report")
    made.add_argument("--build", default="build", help="folder that make builds in")
    return made


def before(options):
    """The options, as the command needs them."""
    options.kills = whole_number("KILLS", options.kills, 1, KILLS_MAX)
    options.seed = whole_number("SEED", options.seed, 0, 2 ** 64 - 1)
    return options


main = commands.main_of(parser, "fixel.check.killing")
