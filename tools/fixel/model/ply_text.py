# SPDX-License-Identifier: MIT
"""The tables of a text PLY file. Its numbers stand in one row, whatever lines they are on."""

import re

import numpy as np

from fixel.base.errors import ToolError
from fixel.base.reading import quoted, shortened
from fixel.model.ply_binary import Damaged

_PART = 1 << 20         # bytes whose words are numbers at a time
_NEWLINE = re.compile(rb"\r\n|\r|\n")
_OTHER = re.compile(rb"[^0-9eE+\-.naifytNAIFYT\s]")      # of no number, of no NaN and of no infinity


def _numbers(words):
    """The words as an array of doubles; ValueError where one is no number."""
    return np.array(list(map(float, words)), dtype=float)


def _whole_words(body, at):
    """(the words from a place on, about a part of them; where the next one begins)."""
    end = at + _PART
    while end < len(body) and not body[end:end + 1].isspace():
        end += 1
    return body[at:end], end


class _Row:
    """The numbers of a body, as many of them as are numbers, and the first word that is none."""

    def __init__(self, body):
        self.at, parts, self.bad, self.words_behind, at = 0, [], None, 0, 0
        while at < len(body) and self.bad is None:
            start, (part, at) = at, _whole_words(body, at)
            try:
                if _OTHER.search(part):
                    raise ValueError("no number")
                parts.append(_numbers(part.split()))
            except ValueError:
                parts.append(self._up_to_bad(body, start, part))
        self.numbers = np.concatenate(parts) if parts else np.zeros(0)
        if self.bad is not None:
            self.words_behind = len(body[at:].split()) + self.in_part

    def _up_to_bad(self, body, start, part):
        """The numbers of a part before the first word that is none."""
        found = []
        words = list(re.finditer(rb"\S+", part))
        for number, word in enumerate(words):
            try:
                if _OTHER.search(word[0]):
                    raise ValueError("no number")
                found.append(float(word[0]))
            except ValueError:
                line = 1 + len(_NEWLINE.findall(body, 0, start + word.start()))
                self.bad, self.in_part = (line, word[0].decode("utf-8", "replace")), len(words) - number
                break
        return np.array(found)

    def take(self, count):
        """The next numbers; None where there are fewer."""
        if self.at + count > len(self.numbers):
            return None
        self.at += count
        return self.numbers[self.at - count:self.at]


def _length(value, most):
    """The length of a list as a whole number; -1 for what is none."""
    return int(value) if 0 <= value <= most and value == int(value) else -1


def _uneven(row, element):
    """The columns of a table with lists, row by row; None where numbers are missing."""
    found = [[] for _ in element.properties]
    for _ in range(element.rows):
        for column, (_, count, _) in zip(found, element.properties):
            length = 1
            if count:
                given = row.take(1)
                length = -1 if given is None else _length(given[0], len(row.numbers))
            numbers = row.take(length) if length >= 0 else None
            if numbers is None:
                return None
            column.append(numbers if count else numbers[0])
    return found


def _even(row, element):
    """The columns of a table all of whose lists are as long as those of its first row; None where they are not."""
    at, places = row.at, []
    for _, count, _ in element.properties:
        length = 1
        if count:
            length = _length(row.numbers[at], len(row.numbers)) if at < len(row.numbers) else -1
            if length < 0:
                return None
            at += 1
        places.append((at - row.at, length, count))
        at += length
    size = at - row.at
    if not size or row.at + size * element.rows > len(row.numbers):
        return None
    table = row.numbers[row.at:row.at + size * element.rows].reshape(element.rows, size)
    if any(count and (table[:, place - 1] != length).any() for place, length, count in places):
        return None
    row.at += size * element.rows
    return [table[:, place:place + length] if count else table[:, place] for place, length, count in places]


def _of_kind(column, kind):
    """Whole numbers of a property that says it has such; in the kind's range."""
    if kind[0] == "f":
        return np.asarray(column, dtype=float)
    most = np.iinfo(kind)
    return np.clip(np.nan_to_num(np.asarray(column, dtype=float)), most.min, most.max).astype(kind)


def tables(header, name):
    """({element: {property: its numbers, one a row, or an array a row}} of a file, how many words stand behind them)."""
    row, found = _Row(header.body), {}
    for element in header.elements:
        if not element.rows or not element.properties:
            continue
        columns = _even(row, element) or _uneven(row, element)
        if columns is None and row.bad:
            raise ToolError(f"{name}:{header.lines + row.bad[0]}: {quoted(row.bad[1])} is not a number")
        if columns is None:
            raise Damaged(f"it ends within the {element.rows:,} rows of {shortened(element.name)}")
        found[element.name] = {key: column if count else _of_kind(column, kind)
                               for (key, count, kind), column in zip(element.properties, columns)}
    return found, len(row.numbers) - row.at + row.words_behind
