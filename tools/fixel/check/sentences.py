# SPDX-License-Identifier: MIT
"""The sentences of a clause, and the letters that they keep.

A clause says several things, and a test of one of them shows nothing of the others. So each sentence, each entry of a list
and each row of a table has an id of its own: that of its clause and a letter, "SPEC 4.3b". The record of clauses
(clauses.py) has the letter and the first words. A sentence is found again by its words, between those before and behind
it: one that comes in takes a letter that none has, and moves no other.

In the record a sentence that demands nothing is ", prose" behind its letter; one that demands something and has no test
with its tag yet is ", open".
"""

import dataclasses
import difflib
import itertools
import re
import string

PROSE, OPEN = "prose", "open"
STATES = ("", PROSE, OPEN)
BLOCK = re.compile(r"^(?:[*-]|\d+\.) +")
RULE = re.compile(r"^\|[ :|-]+\|$")
END = re.compile(r"(?<=[.!?:;])[)\"*_]*\s+(?=[(\"*_`|⌊√\[]*[A-Z0-9`⌊√|])")
MOST = 26 + 26 * 26     # letters of a clause
SHORT = ("e.g.", "i.e.", "vs.", "Fig.", "no.")


@dataclasses.dataclass
class Sentence:
    """A sentence, the line on which it begins, and what the record has of it: its letter, or None if it is new."""
    line: int
    words: str
    letter: str | None = None
    state: str = ""
    recorded: str = ""


def blocks(lines):
    """[(number of the first line, text)] of paragraphs, entries of lists and rows of tables; code belongs to what is before it."""
    found, fresh, fenced = [], True, False
    for number, line in lines:
        bare = line.strip()
        fenced ^= bare.startswith("```")
        if not bare or fenced or bare.startswith(("```", "<!--")):
            fresh = True
        elif bare.startswith("|"):
            found.append((number, bare))
            fresh = True
        elif line.startswith("    ") and fresh:
            continue
        elif fresh or BLOCK.match(bare):
            found.append((number, BLOCK.sub("", bare)))
            fresh = False
        else:
            found[-1] = (found[-1][0], found[-1][1] + "\n" + bare)
    heads = {place - 1 for place, (_, text) in enumerate(found) if RULE.match(text)}
    return [each for place, each in enumerate(found) if place not in heads and place - 1 not in heads or
            not each[1].startswith("|")]


def split(text):
    """The sentences of a block. A row of a table is one."""
    if text.startswith("|"):
        return [text]
    found, begin = [], 0
    for match in END.finditer(text):
        if text[begin:match.start()].endswith(SHORT) or text[match.start() - 1] in ":;":
            continue
        found.append(text[begin:match.end()])
        begin = match.end()
    return [*found, text[begin:]]


def of_lines(lines, words):
    """The sentences of numbered lines. words: the first words of a text."""
    found = []
    for number, text in blocks(lines):
        for sentence in split(text):
            if words(sentence):
                found.append(Sentence(number, words(sentence)))
            number += sentence.count("\n")
    return found


def letters():
    """a, b, .. z, aa, ab, .."""
    for length in itertools.count(1):
        yield from map("".join, itertools.product(string.ascii_lowercase, repeat=length))


def between(first, last):
    """The letters from one to another; none if the last one does not come behind the first."""
    every = list(itertools.islice(letters(), MOST))
    return every[every.index(first):every.index(last) + 1] if first in every and last in every else []


def match(found, record):
    """Gives sentences the letters that a record, [(letter, state, words)], has for them. Those of other words between the
    same two neighbours are the same ones, reworded. Returns the letters that no sentence has any more."""
    steps = difflib.SequenceMatcher(None, [each.words for each in found], [words for _, _, words in record], autojunk=False)
    used = set()
    for kind, first, last, old, end in steps.get_opcodes():
        if kind == "equal" or (kind == "replace" and last - first == end - old):
            for each, (letter, state, words) in zip(found[first:last], record[old:end]):
                each.letter, each.state, each.recorded = letter, state, words
                used.add(letter)
    return [letter for letter, _, _ in record if letter not in used]


def name_new(found, record):
    """Gives the sentences without a letter one that the record doesn't have."""
    known = {letter for letter, _, _ in record}
    free = (letter for letter in letters() if letter not in known)
    for each in found:
        each.letter = each.letter or next(free)
