# SPDX-License-Identifier: MIT
"""Reading TOML strictly: unknown keys and wrong values are errors that say where, and what was probably meant; the kinds of values, of
which keys.py makes its tables. And a scene as a dictionary of TOML's shape, written as the text of a scene file."""

import difflib
import json
import re
import tomllib
import typing
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction

from fixel.base import reading
from fixel.base.errors import ToolError
from fixel.base.reading import QUOTE_MAX, quoted
from fixel.model import quantity

FILE_MAX = 16 << 20     # bytes
MANY = 1 << 30           # entries of a list without a limit of its own
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


def _in_words(values, last):
    """Values of TOML as a message or the page lists them."""
    said = [inline(value) for value in values]
    return f"{', '.join(said[:-1])} {last} {said[-1]}" if len(said) > 1 else said[0]


@dataclass(frozen=True)
class Number:
    """A number of low..high, both included; above: low is not."""
    low: object = None
    high: object = None
    unit: str = ""
    above: bool = False

    def read(self, value, where):
        number = quantity.fraction(value, where)
        if self.above and not self.low < number <= self.high:
            raise ToolError(f"{where} = {quantity.shown(number)} is outside {self.low}..{self.high} ({self.low} not included)")
        return number if self.low is None else quantity.in_range(number, self.low, self.high, where, self.unit)

    def values(self):
        """What docs/scenes.md says of the value."""
        if self.low is None:
            return "a number"
        ends = f"above {self.low}, at most {self.high}" if self.above else f"{self.low}..{self.high}"
        return f"{ends} {self.unit}".strip()

    def _near(self, number):
        return number if self.low is None else min(max(Fraction(number), self.low), self.high)

    def sound(self):
        """Small values that are read."""
        return [self._near(number) for number in (2, 5, Fraction(1, 2))]

    def wrong(self):
        """Values that are refused."""
        return [True, "x", *([] if self.low is None else [self.low if self.above else self.low - 1, self.high + 1])]


@dataclass(frozen=True)
class Whole(Number):
    """A whole number of low..high."""

    def read(self, value, where):
        if isinstance(value, bool) or not isinstance(value, int):
            raise ToolError(f"{where}: expected a whole number, found {quoted(value)}")
        return int(super().read(value, where))

    def sound(self):
        return [int(self._near(number)) for number in (2, 9)] + [self.low]

    def wrong(self):
        return [*super().wrong(), Fraction(2 * self.low + 1, 2)]


@dataclass(frozen=True)
class Degrees(Number):
    """An angle; without an end it has no limit."""

    def read(self, value, where):
        if isinstance(value, str) and value.strip().endswith("turn"):
            return super().read(360 * quantity.fraction(value.strip()[:-4], where), where)
        return super().read(value, where)

    def values(self):
        return "degrees" if self.low is None else super().values()

    def sound(self):
        return [*super().sound(), "3/512 turn"] if self.low is None else super().sound()


@dataclass(frozen=True)
class Several:
    """A list of count values of one kind; count may be a range: (least, most)."""
    kind: object
    count: object
    names: str = ""         # of the values, for a message
    lone: bool = False      # whether a value alone stands for the list: repeated where it fills, else before zeros
    fills: bool = False

    def _ends(self):
        return self.count if isinstance(self.count, tuple) else (self.count, self.count)

    def read(self, value, where):
        least, most = self._ends()
        if self.lone and not isinstance(value, list):
            first = self.kind.read(value, where)
            return (first,) + (first if self.fills else Fraction(0),) * (least - 1)
        if not isinstance(value, list) or not least <= len(value) <= most:
            found = f"a list of {len(value):,}" if isinstance(value, list) and value else quoted(value)
            raise ToolError(f"{where}: expected {self.values().replace('`', '')}; found {found}")
        return tuple(self.kind.read(item, f"{where}[{i}]") for i, item in enumerate(value))

    def values(self):
        least, most = self._ends()
        listed = f"`{self.names}`" if self.names else f"a list of {least}" if least == most else \
            f"a list of {least} to {most}" if most < MANY else "a list with at least one entry" if least else "a list"
        one = self.kind.values()
        listed += f", each {one}" if one != "a number" else ""
        return f"{self.names[1:].split(',')[0] if self.names and not self.fills else 'one value'}, or {listed}" if self.lone else listed

    def sound(self):
        item = self.kind.sound()
        least, most = self._ends()
        return [(item * least)[:least], (item[::-1] * least)[:least], *([item[0]] if self.lone else []), *([item[:most]] if least < min(most, len(item)) else [])]

    def wrong(self):
        least, most = self._ends()
        good, bad = self.kind.sound()[0], self.kind.wrong()
        long = [[good] * (most + 1)] if most < MANY else []
        return [{}, *([[good] * (least - 1)] if least else []), *long, *([each] + [good] * (max(least, 1) - 1) for each in bad), *(bad if self.lone else [])]


@dataclass(frozen=True)
class OneOf:
    """One of these values of TOML, or what another kind reads."""
    those: tuple
    other: object = None

    def read(self, value, where):
        if any(value == each and type(value) is type(each) for each in self.those):
            return value
        if self.other and not (isinstance(value, str) and all(isinstance(each, str) for each in self.those)):
            return self.other.read(value, where)
        if isinstance(value, str) and all(isinstance(each, str) for each in self.those):
            near = difflib.get_close_matches(value[:QUOTE_MAX], self.those, 1)
            hint = f'did you mean "{near[0]}"?' if near else f"one of: {', '.join(self.those)}"
            raise ToolError(f"{where}: unknown value {quoted(value)}; {hint}")
        raise ToolError(f"{where}: expected {_in_words(self.those, 'or')}, found {quoted(value)}")

    def values(self):
        found = ", ".join(f"`{inline(each)}`" for each in self.those)
        return f"{found}, or {self.other.values()}" if self.other else found

    def sound(self):
        return [*self.those, *(self.other.sound() if self.other else [])]

    def wrong(self):
        return [bad for bad in (self.other.wrong() if self.other else ["x", 77, {}]) if bad not in self.those]


SWITCH = OneOf((True, False))


@dataclass(frozen=True)
class Text:
    """Any string."""
    says: str = "a string"

    @staticmethod
    def read(value, where):
        if not isinstance(value, str):
            raise ToolError(f"{where}: expected a string, found {quoted(value)}")
        return value

    def values(self):
        return self.says

    @staticmethod
    def sound():
        return ["a"]

    @staticmethod
    def wrong():
        return [3, ["a"], True]


@dataclass(frozen=True)
class Sub:
    """A table of keys; of rows: what they are read by."""
    keys: dict

    def read(self, value, where):
        return Table(value, where, self.keys)

    @staticmethod
    def values():
        return "a table"

    def sound(self):
        need = {name: key.kind.sound()[0] for name, key in self.keys.items() if key.default is REQUIRED}
        return [need, *({**need, name: key.kind.sound()[-1]} for name, key in self.keys.items())]

    @staticmethod
    def wrong():
        return [3, True, {"no_key": 1}]


@dataclass(frozen=True)
class Read:
    """What a function reads; good and bad: examples of values."""
    read: object
    says: str
    good: tuple
    bad: tuple

    def values(self):
        return self.says

    def sound(self):
        return list(self.good)

    def wrong(self):
        return list(self.bad)


REQUIRED = object()     # the default of a key that must be there


class Key(typing.NamedTuple):
    """A key of a table: the kind of its value, and what it is where it is not said. told: the default as docs/scenes.md tells it where
    that is no value."""
    kind: object
    default: object = None
    told: str = ""

    def default_words(self):
        """The default as docs/scenes.md tells it."""
        if self.default is REQUIRED:
            return "required"
        if self.told or self.default is None or self.default == ():
            return self.told
        if isinstance(self.default, tuple):
            return f"`[{', '.join(map(str, self.default))}]`"
        return f"`{inline(self.default)}`" if isinstance(self.default, str) else str(self.default) if isinstance(self.default, Fraction) \
            else inline(self.default)


class Table:
    """A TOML table whose keys are known: {name: Key}. where stands before every message."""

    def __init__(self, data, where, keys):
        if not isinstance(data, dict):
            raise ToolError(f"{where}: expected a table of keys, found {quoted(data)}")
        for key in data:
            if key not in keys:
                near = difflib.get_close_matches(key[:QUOTE_MAX], keys, 1, 0.5)
                hint = (f'did you mean "{near[0]}"?' if near
                        else f"known keys: {', '.join(sorted(keys))}" if len(keys) <= LISTED_MAX else
                        f"docs/scenes.md lists the {len(keys)} known keys")
                raise ToolError(f"{where}: unknown key {quoted(key)}; {hint}")
        self.data, self.where, self.keys, self.known = data, where, keys, {}

    def at(self, key):
        return f"{self.where}: {key}"

    def __contains__(self, key):
        return key in self.data

    def __getitem__(self, key):
        """What a key says, by its kind; its default where it is not said."""
        kind, default, _ = self.keys[key]
        if key in self.data:
            if key not in self.known:
                self.known[key] = kind.read(self.data[key], self.at(key))
            return self.known[key]
        if default is REQUIRED:
            raise ToolError(f'{self.where}: "{key}" is missing')
        return default

    def get(self, key, default):
        """The same, with a default that depends on more."""
        return self[key] if key in self else default

    def need(self, key):
        """The same of a key that must be there."""
        if key not in self.data:
            raise ToolError(f'{self.where}: "{key}" is missing')
        return self[key]

    def table(self, key):
        """The table of a key; where it is not said, one that says nothing."""
        return self.keys[key].kind.read(self.data.get(key, {}), self.at(key))

    def rows(self, key):
        """The tables of a list; none where it is not said."""
        return self[key] or ()

    def named(self, key, what, read):
        """What read(row) makes of each row of a list, as {name: value}; read answers (name, value). Without the list, there is none."""
        found = {}
        for row in self.rows(key):
            name, value = read(row)
            if name in found:
                raise ToolError(f"{row.where}: there is a {what} {quoted(name)} already")
            found[name] = value
        return found

    def refuse(self, keys, why):
        """Refuses each of these keys that is there. why: a format with {key}."""
        for key in keys:
            if key in self:
                raise ToolError(f"{self.at(key)}: {why.format(key=key)}")

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


def inline(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Fraction):
        return _number(value)
    if isinstance(value, str):
        return _string(value)
    if isinstance(value, list):
        return f"[{', '.join(map(inline, value))}]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{_key(name)} = {inline(item)}" for name, item in value.items()) + " }"
    return repr(value)


def _is_rows(value):
    return isinstance(value, list) and bool(value) and all(isinstance(row, dict) for row in value)


def text(data):
    """The text of a scene. Tables of the top and lists of tables stand under a heading each."""
    lines = [f"{_key(name)} = {inline(value)}" for name, value in data.items()
             if not isinstance(value, dict) and not _is_rows(value)]
    for name, value in data.items():
        for heading, table in [(f"[{_key(name)}]", value)] if isinstance(value, dict) else \
                [(f"[[{_key(name)}]]", row) for row in value] if _is_rows(value) else []:
            lines += ["", heading, *(f"{_key(key)} = {inline(item)}" for key, item in table.items())]
    return "\n".join(lines) + "\n"
