# SPDX-License-Identifier: MIT
"""The text of model files: which encoding, which numbers, and which statements a reader leaves out.

Python's float, int and Decimal take more than a number of such a file: nan, inf, 1_0, digits of every script. Other programs read these
differently, or not at all."""

import codecs
import collections
import io
import math
import re

from fixel.base.reading import quoted

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


_MARKS = ((codecs.BOM_UTF8, "utf-8"), (codecs.BOM_UTF16_LE, "utf-16-le"), (codecs.BOM_UTF16_BE, "utf-16-be"))
KINDS_MAX = 20          # words that a note lists
_CONTINUED = re.compile(r"^[^#]*[\s\d.]\\$|^\\$")      # not a folder, which ends so in a name
_COMMENT = re.compile(r"(?:^|\s)#")


def without_mark(blob):
    """(bytes, encoding) of a text without the byte order mark that it may begin with."""
    for mark, encoding in _MARKS:
        if blob.startswith(mark):
            return blob[len(mark):], encoding
    return blob, "utf-8"


def _as_latin(error):
    """The characters of bytes that are no text in UTF-8, as older programs write names: those of Latin-1."""
    return "".join(map(chr, error.object[error.start:error.end])), error.end


codecs.register_error("fixel.latin", _as_latin)


def lines_of(blob):
    """(line number, line) of a text."""
    rest, encoding = without_mark(blob)
    return enumerate(io.TextIOWrapper(io.BytesIO(rest), encoding, "fixel.latin"), 1)


def statements(blob):
    """(line number, line) of a text whose lines may go on behind a backslash; comments are part of them."""
    held = []
    for number, line in lines_of(blob):
        line = line.rstrip()
        if line.endswith("\\") and _CONTINUED.search(line):
            held.append(line[:-1])
            continue
        if held:
            line, held = " ".join([*held, line]), []
        if line:
            yield number, line
    if held:
        yield number, " ".join(held)


def words_of(line):
    """The words of a line without its comment. A # within a word is a part of it, as in Material#1."""
    return _COMMENT.split(line, 1)[0].split() if "#" in line else line.split()


class LeftOut:
    """Statements that a reader of a file leaves out, counted by their first word."""

    def __init__(self):
        self.counts, self.first = collections.Counter(), {}

    def add(self, word, where):
        """One more. where: for the note."""
        self.counts[word] += 1
        self.first.setdefault(word, where)

    def taken(self, words):
        """The LeftOut of some words, which this one then has no more."""
        made = LeftOut()
        for word in [word for word in self.counts if word in words]:
            made.counts[word], made.first[word] = self.counts.pop(word), self.first.pop(word)
        return made

    def notes(self, name, kind, counted=True, meanings=None):
        """At most one note. kind: what these statements are, such as "ignored". counted: whether it says how often each is there. meanings:
        {word: what it would do}."""
        if not self.counts:
            return []
        shown = list(self.counts.items())[:KINDS_MAX]
        more = f" and {len(self.counts) - len(shown):,} other words" if len(self.counts) > len(shown) else ""
        listed = ", ".join((f"{times} x " if counted else "") +
                           (word if word.isidentifier() and word.isascii() and len(word) < 24 else quoted(word)) +
                           (f" ({meanings[word]})" if meanings and word in meanings else "") for word, times in shown)
        first = next(filter(None, self.first.values()), None)
        return [f"{name}: {kind} {listed}{more}" + (f" (first: {first})" if first else "")]
