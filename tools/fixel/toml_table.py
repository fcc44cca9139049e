# SPDX-License-Identifier: MIT
"""Reading TOML strictly: unknown keys and wrong types are errors that say
where, and what was probably meant."""

from decimal import Decimal
import difflib
import tomllib

from fixel import quantity
from fixel.errors import ToolError


def read(path):
    """A TOML file as a dictionary; decimals stay exact."""
    try:
        with open(path, "rb") as file:
            return tomllib.loads(file.read().decode("utf-8"), parse_float=Decimal)
    except OSError as error:
        raise ToolError(f"{path}: cannot be read ({error.strerror})") from error
    except UnicodeDecodeError as error:
        raise ToolError(f"{path}: not UTF-8 text (byte {error.start})") from error
    except tomllib.TOMLDecodeError as error:
        raise ToolError(f"{path}: not TOML: {error}") from error


class Table:
    """A TOML table whose keys are known. where stands before every message."""

    def __init__(self, data, where, known):
        if not isinstance(data, dict):
            raise ToolError(f"{where}: expected a table of keys, found {data!r}")
        for key in data:
            if key not in known:
                near = difflib.get_close_matches(key, known, 1, 0.5)
                hint = (f'did you mean "{near[0]}"?' if near
                        else f"known keys: {', '.join(sorted(known))}")
                raise ToolError(f'{where}: unknown key "{key}"; {hint}')
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
            raise ToolError(f"{self.at(key)}: expected a whole number, found {value!r}")
        return int(quantity.in_range(value, low, high, self.at(key)))

    def degrees(self, key, default=0):
        return quantity.degrees(self.data.get(key, default), self.at(key))

    def position(self, key):
        return quantity.position(self.need(key), self.at(key))

    def switch(self, key, default):
        value = self.data.get(key, default)
        if not isinstance(value, bool):
            raise ToolError(f"{self.at(key)}: expected true or false, found {value!r}")
        return value

    def choice(self, key, default, allowed):
        value = self.need(key) if default is None else self.data.get(key, default)
        if value not in allowed:
            near = difflib.get_close_matches(str(value), allowed, 1)
            hint = f'did you mean "{near[0]}"?' if near else f"one of: {', '.join(allowed)}"
            raise ToolError(f"{self.at(key)}: unknown value {value!r}; {hint}")
        return value

    def text(self, key):
        value = self.need(key)
        if not isinstance(value, str):
            raise ToolError(f"{self.at(key)}: expected a string, found {value!r}")
        return value

    def rows(self, key):
        value = self.need(key)
        if not isinstance(value, list) or not value:
            raise ToolError(f"{self.at(key)}: expected a list with at least one entry")
        return value

    def only_one(self, *keys):
        """The one of these keys that is there."""
        found = [key for key in keys if key in self.data]
        if len(found) != 1:
            what = f"both {found[0]} and {found[1]} are given" if found else "none is given"
            raise ToolError(f"{self.where}: one of {', '.join(keys)} is needed, but {what}")
        return found[0]
