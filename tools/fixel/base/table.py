# SPDX-License-Identifier: MIT
"""Plain tables and coloured words for a terminal."""

import os
import sys


def count_of(number, one):
    """3, "face" -> "3 faces"."""
    plural = {"vertex": "vertices"}.get(one, one + "s")
    return f"{number:,} {one if number == 1 else plural}"


def table(rows, header=None):
    """Lines of a table; numbers go right, the rest left. rows are sequences of str or numbers."""
    shown = [[_cell(cell) for cell in row] for row in rows]
    everything = ([list(header)] if header else []) + shown
    widths = [max(len(row[column]) for row in everything) for column in range(len(everything[0]))]
    right = [all(isinstance(row[column], (int, float)) or row[column] is None for row in rows)
             for column in range(len(widths))]
    lines = [_line(row, widths, right) for row in everything]
    if header:
        lines.insert(1, "  ".join("-" * width for width in widths))
    return "\n".join(lines)


def _cell(value):
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, int):
        return f"{value:,}"
    if isinstance(value, float):
        return f"{value:.4g}"
    return str(value)


def _line(cells, widths, right):
    placed = [cell.rjust(width) if to_right else cell.ljust(width)
              for cell, width, to_right in zip(cells, widths, right)]
    return "  ".join(placed).rstrip()


def coloured(text, colour, stream=None):
    """text in green, red or yellow where stream is a terminal and NO_COLOR is not set."""
    stream = stream or sys.stdout
    codes = {"green": 32, "red": 31, "yellow": 33}
    if not stream.isatty() or os.environ.get("NO_COLOR"):
        return text
    return f"\033[{codes[colour]}m{text}\033[0m"
