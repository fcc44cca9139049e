# SPDX-License-Identifier: MIT
"""Rows of constants that come from a formula: the formula is computed again, exactly, and the text must have the result.

A row quotes the text that has the numbers: {} stands for one number, {*} for all up to the end of the braces, {.byte} for
those of lines of bytes. The function of its program, host_tests/proofs/ROOM/constants.py, gives the numbers that belong there, in their order.
"""

import re
import runpy
import time

from fixel.prove.cbmc import Failed

NUMBER = r"(?<![\w.])-?(?:0x[0-9A-Fa-f]+|[0-9]+(?:\.[0-9]+)?)(?=[uUlL]*(?![\w.])|\.(?!\d))"
MARKS = {"{}": f"({NUMBER})", "{*}": r"([^{}]*(?:\{[^{}]*\}[^{}]*)*)(?=\})", "{.byte}": r"((?:\s*\.byte [^\n]*)+)"}


def preprocessed(root, row, _case):
    """All that the result depends on."""
    return row.place.read_bytes(), (root / row.file).read_bytes()


def _value(word):
    return int(word, 16) if "0x" in word.lower() else float(word) if "." in word else int(word)


def _pattern(words):
    """What finds a row's text, whatever white space the file has between its words."""
    parts = re.split(r"(\{(?:\*|\.byte)?\}|\s+)", words)
    return "".join(MARKS.get(part, r"\s+" if part.isspace() else re.escape(part)) for part in parts if part)


def numbers_of(text, quotes):
    """The numbers that a file's text has where the quotes have {} and {*}."""
    found = []
    # a comment's lines begin with a star, which is no word of its text
    text = re.sub(r"\n \* ", "\n ", text)
    for quote in quotes:
        places = list(re.finditer(_pattern(quote), text))
        if len(places) != 1:
            raise Failed(f"the file has '{quote}' {len(places) or 'no'} times, and once is wanted")
        found += [_value(word) for group in places[0].groups() for word in re.findall(NUMBER, group)]
    return found


def prove(_programs, root, row, _case):
    """As cbmc.prove."""
    began = time.process_time()
    wanted = runpy.run_path(str(row.place)).get(row.harness)
    if wanted is None:
        raise Failed(f"{row.place.name} has no function {row.harness}")
    wanted, found = list(wanted()), numbers_of((root / row.file).read_text(encoding="utf-8"), row.text)
    if len(wanted) != len(found) or not found:
        raise Failed(f"its formula gives {len(wanted)} numbers, and {row.file} has {len(found)}")
    for number, (want, have) in enumerate(zip(wanted, found)):
        if want != have:
            place = f"number {number} of {row.name}" if len(wanted) > 1 else row.name
            raise Failed(f"{place} is {have}, and its formula gives {want}")
    return {"checks": len(found), "within": [], "seconds": time.process_time() - began}
