# SPDX-License-Identifier: MIT
"""A prediction as a small picture (SVG) for a README: the rate, or the instructions where the core's cycles are not known."""

import html
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[3]
TEMPLATE = ROOT / "tools" / "templates" / "badge.svg"
NAME = re.compile(r"^# (?!SPDX)(.+?): ", re.MULTILINE)      # of a board's first sentence
LETTER = 6.2        # pixels of a letter: the text is drawn as long as this makes it, in whatever font there is
BESIDE = 58         # pixels beside the words


def name_of(board):
    """What people call a board, by what its board.mk says of it first; without that, its name for make."""
    file = ROOT / "boards" / board / "board.mk"
    found = NAME.search(file.read_text(encoding="utf-8")) if file.is_file() else None
    return found[1] if found else board


def words(board, clock, cycles, instructions):
    """What a badge says. board: what people call it. cycles: of a mean frame; None: not known, or no clock. None, None: the board has no room."""
    if cycles and clock:
        rate = clock * 1e6 / cycles
        return f"{rate:.0f} frames a second on {board} at {clock} MHz, drawing alone, by model" if rate >= 10 else \
            f"{rate:.1f} frames a second on {board} at {clock} MHz, drawing alone, by model"
    return f"{instructions:,} instructions a frame on {board}, by model" if instructions else f"no room on {board}, by model"


def picture(said):
    """The picture of these words."""
    length = round(LETTER * len(said))
    text = TEMPLATE.read_text(encoding="utf-8")
    for name, value in {"words": html.escape(said), "length": str(length), "width": str(length + BESIDE)}.items():
        text = text.replace("{{" + name + "}}", value)
    return text


def of_prediction(result):
    """The picture of what fixel predict found."""
    cycles, taken = result["cycles"] or {}, result["instructions_per_frame"] or {}
    return picture(words(name_of(result["board"]), cycles.get("clock"), cycles.get("mean"), taken.get("mean")))
