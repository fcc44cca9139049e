# SPDX-License-Identifier: MIT
"""Reading TOML strictly: unknown keys and wrong types are errors that say where, and what was probably meant. And a scene as a
dictionary of TOML's shape, written as the text of a scene file."""

import difflib
import json
import re
import tomllib
from decimal import Decimal
from fractions import Fraction

from fixel.base import reading
from fixel.base.errors import ToolError
from fixel.base.reading import QUOTE_MAX, quoted
from fixel.model import quantity

FILE_MAX = 16 << 20     # bytes
_COUNTS = {2: "two", 3: "three"}
LISTED_MAX = 40         # keys in a message
PARTS_MAX = 16          # of a dotted key: tomllib takes quadratic time and memory for them
# No quantifier gives back what it took, and no key begins behind a backslash: the time is that of one look.
_PART = r"""(?:[\w-]++|"(?:[^"\\\n]++|\\.)*+"|'[^'\n]*+')"""
_LONG_KEY = re.compile(r"""(?<![\w."'\\-])(?:%s[ \t]*+\.[ \t]*+){%d}""" % (_PART, PARTS_MAX))


def read(path):
    """A TOML file as a dictionary; decimals stay exact."""
    blob = reading.read_whole(path, FILE_MAX, "use repeat, ring or an OBJ file for what is many")
    try:
        text = blob.decode("utf-8-sig")
        long_key = _LONG_KEY.search(text)
        if long_key:
            line = text.count("\n", 0, long_key.start()) + 1
            raise ToolError(f"{path}: line {line}: a key of more than {PARTS_MAX} parts; no key of a scene has so many")
        return tomllib.loads(text, parse_float=quantity.decimal)
    except UnicodeDecodeError as error:
        raise ToolError(f"{path}: not UTF-8 text (byte {error.start})") from error
    except RecursionError:
        raise ToolError(f"{path}: lists or tables are nested deeper than the reader of TOML follows") from None
    except tomllib.TOMLDecodeError as error:
        raise ToolError(f"{path}: not TOML: {reading.shortened(str(error))}") from error
    except ValueError:
        # The only others are those of int and of quantity.decimal.
        raise ToolError(f"{path}: a number has more than {quantity.DIGITS_MAX} characters, or is out of every range") from None


class Table:
    """A TOML table whose keys are known. where stands before every message."""

    def __init__(self, data, where, known):
        if not isinstance(data, dict):
            raise ToolError(f"{where}: expected a table of keys, found {quoted(data)}")
        for key in data:
            if key not in known:
                near = difflib.get_close_matches(key[:QUOTE_MAX], known, 1, 0.5)
                hint = (f'did you mean "{near[0]}"?' if near
                        else f"known keys: {', '.join(sorted(known))}" if len(known) <= LISTED_MAX else
                        f"docs/scenes.md lists the {len(known)} known keys")
                raise ToolError(f"{where}: unknown key {quoted(key)}; {hint}")
        self.data = data
        self.where = where

    def at(self, key):
        return f"{self.where}: {key}"

    def __contains__(self, key):
        return key in self.data

    def need(self, key):
        if key not in self.data:
            raise ToolError(f'{self.where}: "{key}" is missing')
        return self.data[key]

    def table(self, key, known):
        return Table(self.data.get(key, {}), self.at(key), known)

    def number(self, key, default=None, low=None, high=None, unit=""):
        value = self.need(key) if default is None else self.data.get(key, default)
        value = quantity.fraction(value, self.at(key))
        if low is not None:
            quantity.in_range(value, low, high, self.at(key), unit)
        return value

    def whole(self, key, default, low, high):
        value = self.need(key) if default is None else self.data.get(key, default)
        if isinstance(value, bool) or not isinstance(value, int):
            raise ToolError(f"{self.at(key)}: expected a whole number, found {quoted(value)}")
        return int(quantity.in_range(quantity.fraction(value, self.at(key)), low, high, self.at(key)))

    def wholes(self, key, count, high):
        """So many whole numbers from 1 on."""
        value = self.rows(key)
        if len(value) != count or not all(type(n) is int and 1 <= n <= high for n in value):     # true is no number
            raise ToolError(f"{self.at(key)}: expected {_COUNTS[count]} whole numbers from 1 to {high}")
        return tuple(value)

    def degrees(self, key, default=0):
        return quantity.degrees(self.data.get(key, default), self.at(key))

    def position(self, key):
        return quantity.position(self.need(key), self.at(key))

    def switch(self, key, default):
        value = self.data.get(key, default)
        if not isinstance(value, bool):
            raise ToolError(f"{self.at(key)}: expected true or false, found {quoted(value)}")
        return value

    def choice(self, key, default, allowed):
        value = self.need(key) if default is None else self.data.get(key, default)
        if not isinstance(value, str) or value not in allowed:
            near = difflib.get_close_matches(value[:QUOTE_MAX], allowed, 1) if isinstance(value, str) else []
            hint = f'did you mean "{near[0]}"?' if near else f"one of: {', '.join(allowed)}"
            raise ToolError(f"{self.at(key)}: unknown value {quoted(value)}; {hint}")
        return value

    def text(self, key):
        value = self.need(key)
        if not isinstance(value, str):
            raise ToolError(f"{self.at(key)}: expected a string, found {quoted(value)}")
        return value

    def rows(self, key):
        value = self.need(key)
        if not isinstance(value, list) or not value:
            raise ToolError(f"{self.at(key)}: expected a list with at least one entry")
        return value

    def named(self, key, what, most, read):
        """What read(data, where) makes of each row of a list, as {name: value}; read answers (name, value). Without the
        list, there is none."""
        rows = self.rows(key) if key in self else []
        if len(rows) > most:
            raise ToolError(f"{self.at(key)}: {len(rows)} {key} are more than {most}")
        found = {}
        for i, data in enumerate(rows):
            where = f"{self.at(key)}[{i}]"
            name, value = read(data, where)
            if name in found:
                raise ToolError(f"{where}: there is a {what} {quoted(name)} already")
            found[name] = value
        return found

    def only_one(self, *keys):
        """The one of these keys that is there."""
        found = [key for key in keys if key in self.data]
        if len(found) != 1:
            what = f"both {found[0]} and {found[1]} are given" if found else "none is given"
            raise ToolError(f"{self.where}: one of {', '.join(keys)} is needed, but {what}")
        return found[0]


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
