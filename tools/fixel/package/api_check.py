# SPDX-License-Identifier: MIT
"""Compares the public headers and functions with those of the last tag: what a program relies on must stay, or the version must say so.

Exit: 0 nothing is gone, or the version allows it, or there is no tag; 1 something is gone or changed; 2 a tool is missing.
"""

import argparse

from fixel import commands


def parser():
    """The options of the command: none."""
    return argparse.ArgumentParser(description=__doc__.splitlines()[0])


main = commands.main_of(parser, "fixel.package.api")
