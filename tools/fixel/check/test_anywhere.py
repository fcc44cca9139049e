# SPDX-License-Identifier: MIT
"""Runs the tests of host_tests/anywhere: Fixel outside its checkout, in packages and on machines that make test has no tools for.

A part is a folder there; ONLY= names one, or a file as packages/test_cmake. Each file prints a line when it runs and one when it
is done. What a test needs and this machine lacks is told as "not run: needs ...", and counts as skipped, never as passed.
Exit: 0 nothing failed, 1 a test failed, 2 there is no such part.
"""

import argparse

from fixel import commands
from fixel.check import anywhere


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--only", default="", metavar="PART", help="a folder of host_tests/anywhere, or a file of one")
    made.add_argument("--json", help="write the result of each file")
    return made


def before(options):
    """Refuses a name that no part has."""
    anywhere.chosen(options.only, anywhere.files())


main = commands.main_of(parser, "fixel.check.anywhere")
