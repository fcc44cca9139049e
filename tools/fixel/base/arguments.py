# SPDX-License-Identifier: MIT
"""Numbers on a command line."""

from fixel.base.errors import ToolError

DIGITS_MAX = 20     # of a number on a command line


def number(name, low, high):
    """What argparse takes as type=: a whole number of this range."""
    return lambda text: whole_number(name, text, low, high)


def whole_number(name, text, low, high):
    """A whole number from a command line. name: what the message calls it."""
    if not (text.isascii() and text.isdigit() and len(text) <= DIGITS_MAX and low <= int(text) <= high):
        raise ToolError(f"{name} is '{text}'; it must be a whole number from {low:,} to {high:,}")
    return int(text)
