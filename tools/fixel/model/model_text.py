# SPDX-License-Identifier: MIT
"""The text of model files: which encoding, and which statements a reader leaves out."""

import codecs
import collections
import io

from fixel.base.reading import quoted

_MARKS = ((codecs.BOM_UTF8, "utf-8"), (codecs.BOM_UTF16_LE, "utf-16-le"), (codecs.BOM_UTF16_BE, "utf-16-be"))
KINDS_MAX = 12          # words that a note lists


def without_mark(blob):
    """(bytes, encoding) of a text without the byte order mark that it may begin with."""
    for mark, encoding in _MARKS:
        if blob.startswith(mark):
            return blob[len(mark):], encoding
    return blob, "utf-8"


def lines_of(blob):
    """(line number, line) of a text. What is no text of its encoding is replaced."""
    rest, encoding = without_mark(blob)
    return enumerate(io.TextIOWrapper(io.BytesIO(rest), encoding, "replace"), 1)


class LeftOut:
    """Statements that a reader of a file leaves out, counted by their first word."""

    def __init__(self):
        self.counts, self.first = collections.Counter(), {}

    def add(self, word, where):
        """One more. where: for the note."""
        self.counts[word] += 1
        self.first.setdefault(word, where)

    def notes(self, name, kind, counted=True):
        """At most one note. kind: what these statements are, such as "ignored". counted: whether it says how often each is there."""
        if not self.counts:
            return []
        shown = list(self.counts.items())[:KINDS_MAX]
        more = f" and {len(self.counts) - len(shown):,} other words" if len(self.counts) > len(shown) else ""
        listed = ", ".join((f"{times} x " if counted else "") +
                           (word if word.isidentifier() and word.isascii() and len(word) < 24 else quoted(word)) for word, times in shown)
        first = next(filter(None, self.first.values()), None)
        return [f"{name}: {kind} {listed}{more}" + (f" (first: {first})" if first else "")]
