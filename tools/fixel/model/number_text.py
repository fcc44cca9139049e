# SPDX-License-Identifier: MIT
"""Numbers as text files of models write them.

Python's float, int and Decimal take more: nan, inf, 1_0, digits of every script. Other programs read these differently, or
not at all."""

import math
import re

_DECIMAL = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?")
_WHOLE = re.compile(r"[+-]?[0-9]+")


def is_decimal(text):
    """Whether a text is a decimal number: digits 0 to 9, at most one point, an exponent or none."""
    return _DECIMAL.fullmatch(text) is not None


def decimal(text):
    """A decimal number as a float; ValueError where the text is none, or the float would be infinite."""
    if not is_decimal(text):
        raise ValueError("no decimal number")
    value = float(text)
    if not math.isfinite(value):
        raise ValueError("too large")
    return value


def whole(text):
    """A whole number as an int; ValueError where the text is none, or has thousands of digits."""
    if not _WHOLE.fullmatch(text):
        raise ValueError("no whole number")
    return int(text)
