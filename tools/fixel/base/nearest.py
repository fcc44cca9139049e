# SPDX-License-Identifier: MIT
"""The word that was meant by one that is not known.

    nearest.py NAME ENDING WORD...   the question, for an error of the Makefile, which asks before there is .venv
"""

import sys

FAR = 0.4   # errors for each character of the longer word: beyond it another word was meant


def distance(one, other):
    """How many characters to insert, remove, replace, or swap with their neighbour make one word the other."""
    rows = [list(range(len(other) + 1))]
    for i, a in enumerate(one, 1):
        row = [i]
        for j, b in enumerate(other, 1):
            row.append(min(rows[-1][j] + 1, row[-1] + 1, rows[-1][j - 1] + (a != b)))
            if i > 1 and j > 1 and (a, b) == (other[j - 2], one[i - 2]):
                row[-1] = min(row[-1], rows[-2][j - 2] + 1)
        rows.append(row)
    return rows[-1][-1]


def nearest(name, words):
    """The words that are nearest to a name; none where even they are far from it."""
    far = {word: distance(name, word) for word in words}
    least = min(far.values(), default=0)
    return [word for word in words if far[word] == least <= FAR * max(len(name), len(word))]


def question(name, words, ending=""):
    """"; did you mean A or B?", or nothing. ending: what stands after each word."""
    near = nearest(name, words)
    return f"; did you mean {' or '.join(f'{word}{ending}' for word in near)}?" if near else ""


if __name__ == "__main__":
    print(question(sys.argv[1], sys.argv[3:], sys.argv[2]))
