# SPDX-License-Identifier: MIT
"""A scene as a dictionary of TOML's shape, as the text of a scene file."""

from decimal import Decimal
from fractions import Fraction
import json
import re

DIGITS = 14     # behind the point, and before it: a model's scale has at most these

def _key(name):
    return name if re.fullmatch("[A-Za-z0-9_-]+", name) else _string(name)


def _string(text):
    """A basic string: JSON's escapes are TOML's, but for the pairs of surrogates. A character without a picture is escaped too: a mark of
    direction would change how a line is read."""
    return "".join(json.dumps(c)[1:-1] if ord(c) < 127 else c if c.isprintable() else f"\\U{ord(c):08x}" for c in text).join('""')


def _number(value):
    """A Fraction exactly: with a decimal point where it has few digits behind it."""
    scaled = value * 10 ** DIGITS
    if scaled.denominator != 1 or abs(value) >= 10 ** DIGITS:
        return f'"{value.numerator}/{value.denominator}"'
    found = f"{Decimal(scaled.numerator).scaleb(-DIGITS):f}".rstrip("0").rstrip(".")
    return found or "0"


def _value(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Fraction):
        return _number(value)
    if isinstance(value, str):
        return _string(value)
    if isinstance(value, list):
        return f"[{', '.join(map(_value, value))}]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{_key(name)} = {_value(item)}" for name, item in value.items()) + " }"
    return repr(value)


def _is_rows(value):
    return isinstance(value, list) and bool(value) and all(isinstance(row, dict) for row in value)


def text(data):
    """The text of a scene. Tables of the top and lists of tables stand under a heading each."""
    lines = [f"{_key(name)} = {_value(value)}" for name, value in data.items()
             if not isinstance(value, dict) and not _is_rows(value)]
    for name, value in data.items():
        for heading, table in [(f"[{_key(name)}]", value)] if isinstance(value, dict) else \
                [(f"[[{_key(name)}]]", row) for row in value] if _is_rows(value) else []:
            lines += ["", heading, *(f"{_key(key)} = {_value(item)}" for key, item in table.items())]
    return "\n".join(lines) + "\n"
