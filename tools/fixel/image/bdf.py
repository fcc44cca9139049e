# SPDX-License-Identifier: MIT
"""Reading fonts in BDF, Adobe's Glyph Bitmap Distribution Format (version 2.1)."""

from dataclasses import dataclass, field
import re

from fixel.base import foreign, reading
from fixel.base.errors import ToolError
from fixel.base.reading import quoted

FILE_MAX = 16 << 20     # bytes
SIDE_MAX = 255          # pixels of a character, of its advance and of a line
OFFSET_MAX = 127        # of a picture from the pen and from the top of the line
CODES = range(256)
UNENCODED = 1 << 32             # and above: in place of the code of a character that has none
_MARK = "\xef\xbb\xbf"       # a byte order mark of UTF-8, read as Latin-1
RENUMBERED = range(32, 256)     # the codes of a font's characters that has none of CODES


@dataclass
class Glyph:
    """A character: its picture, row by row as bytes with the leftmost pixel in the highest bit."""
    width: int
    height: int
    left: int       # of the picture, from the pen
    top: int        # of the picture, from the top of the line
    advance: int
    rows: list


@dataclass
class Font:
    """The characters of a file, by code."""
    ascent: int
    descent: int
    glyphs: dict
    notes: list = field(default_factory=list)

    @property
    def line_height(self):
        return self.ascent + self.descent


class _Lines:
    """The lines of a file as words, with their numbers."""

    def __init__(self, text, name):
        self.lines, self.at, self.name = text.splitlines(), 0, name

    @property
    def where(self):
        return f"{self.name}:{self.at}"

    def next(self):
        """The words of the next line that is not empty; None at the end."""
        while self.at < len(self.lines):
            self.at += 1
            words = self.lines[self.at - 1].split()
            if words:
                return words
        return None

    def numbers(self, words, count, limit):
        """The whole numbers after a keyword."""
        given = words[1:1 + count]
        if len(given) < count or not all(re.fullmatch(r"[+-]?[0-9]{1,9}", word) for word in given):
            raise ToolError(f"{self.where}: {words[0]} must have {count} whole number{'s' * (count > 1)}")
        numbers = [int(word) for word in given]
        if any(abs(number) > limit for number in numbers):
            raise ToolError(f"{self.where}: {quoted(' '.join(words))} is outside -{limit}..{limit}")
        return numbers


def _rows(lines, width, height):
    """The rows of a BITMAP: hexadecimal digits, whole bytes; what is right of the width is cleared."""
    size, rows = (width + 7) // 8, []
    for _ in range(height):
        words = lines.next()
        if not words or not re.fullmatch("(?:[0-9A-Fa-f]{2}){%d,128}" % max(size, 1), words[0]):
            raise ToolError(f"{lines.where}: expected a row of {max(size, 1)} or more bytes as hexadecimal digits")
        bits = int(words[0][:2 * size] or "0", 16) >> (8 * size - width) << (8 * size - width)
        rows.append(bits.to_bytes(size, "big"))
    return rows


def _glyph(lines, advance):
    """(code, character without its top) from after STARTCHAR to ENDCHAR; a box says how far up it reaches. advance: that of the font's
    characters without one, or None."""
    start, code, box, rows = lines.where, None, None, None
    while (words := lines.next()) and words[0] != "ENDCHAR":
        if words[0] == "ENCODING":
            code, = lines.numbers(words, 1, 0x7FFFFFF)
        elif words[0] == "DWIDTH":
            advance, _ = lines.numbers(words, 2, SIDE_MAX)
        elif words[0] in ("BBX", "BITMAP") and rows is not None:
            raise ToolError(f"{lines.where}: a second {words[0]} of the character, or one after its BITMAP")
        elif words[0] == "BBX":
            box = lines.numbers(words, 4, SIDE_MAX)
            if box[0] < 0 or box[1] < 0:
                raise ToolError(f"{lines.where}: a box of {box[0]} x {box[1]} pixels")
        elif words[0] == "BITMAP":
            if box is None:
                raise ToolError(f"{lines.where}: BITMAP stands before BBX")
            rows = _rows(lines, box[0], box[1])
        elif words[0] in ("STARTCHAR", "ENDFONT"):
            words = None
            break
    if not words:
        raise ToolError(f"{start}: the character that begins here does not end")
    missing = [key for key, value in (("ENCODING", code), ("DWIDTH", advance), ("BBX", box), ("BITMAP", rows))
               if value is None]
    if missing:
        raise ToolError(f"{start}: the character that begins here has no {missing[0]}")
    if advance < 0:
        raise ToolError(f"{start}: the character that begins here goes to the left")
    return code, box, Glyph(box[0], box[1], box[2], 0, advance, rows)


def _renumber(font, boxes, name):
    """Leaves the characters of CODES. A font that has none of these but 0, of icons or of another script, gets others in turn; so does one
    whose characters have no codes."""
    codes = [code for code in sorted(font.glyphs) if 0 < code < UNENCODED] or [code for code in sorted(font.glyphs) if code]
    kept = {code: code for code in font.glyphs if code in CODES}
    if codes and not any(kept):
        kept = dict(zip(codes, RENUMBERED))
        known = "have codes above 255: " + f"U+{codes[0]:04X} to U+{max(kept):04X}" if codes[0] < UNENCODED else \
            f"have no code: the first {len(kept):,}"
        font.notes.append(f"{name}: all {len(codes):,} characters {known}, in turn, are written as {RENUMBERED[0]} to {max(kept.values())}")
    font.glyphs = {new: font.glyphs[code] for code, new in kept.items()}
    return {new: boxes[code] for code, new in kept.items()}


def parse(text, name):
    """A Font from the text of a file."""
    lines, boxes, font = _Lines(text.removeprefix(_MARK), name), {}, Font(None, None, {})
    bounds, advance = None, None
    words = lines.next()
    while words and words[0] == "COMMENT":
        words = lines.next()
    if not words or words[0] != "STARTFONT":
        raise ToolError(f"{name}: is not a BDF font: the first line must be STARTFONT 2.1")
    while (words := lines.next()) and words[0] != "ENDFONT":
        if words[0] == "FONTBOUNDINGBOX":
            bounds = lines.numbers(words, 4, SIDE_MAX)
        elif words[0] == "FONT_ASCENT":
            font.ascent, = lines.numbers(words, 1, SIDE_MAX)
        elif words[0] == "FONT_DESCENT":
            font.descent, = lines.numbers(words, 1, SIDE_MAX)
        elif words[0] == "DWIDTH":
            advance, _ = lines.numbers(words, 2, SIDE_MAX)
        elif words[0] == "STARTCHAR":
            where = lines.where
            code, box, glyph = _glyph(lines, advance)
            if code in font.glyphs:
                raise ToolError(f"{where}: character {code} is there a second time")
            code = code if code >= 0 else UNENCODED + len(font.glyphs)
            font.glyphs[code], boxes[code] = glyph, (where, box)
    if not words:
        if not font.glyphs:
            raise ToolError(f"{name}: ENDFONT is missing, and there is no character, so the file is not whole")
        font.notes.append(f"{name}: ENDFONT is missing: the file may be cut off behind a character")
    return _with_tops(font, bounds, _renumber(font, boxes, name), name)


def _with_tops(font, bounds, boxes, name):
    """The font with each picture's place below the top of the line, from the ascent."""
    if (font.ascent is None or font.descent is None) and bounds is None:
        raise ToolError(f"{name}: neither FONT_ASCENT and FONT_DESCENT nor FONTBOUNDINGBOX say how high a line is")
    font.ascent = bounds[1] + bounds[3] if font.ascent is None else font.ascent
    font.descent = -bounds[3] if font.descent is None else font.descent
    if not 1 <= font.line_height <= SIDE_MAX:
        raise ToolError(f"{name}: a line is {font.line_height} pixels high; it must be 1..{SIDE_MAX}")
    for code, glyph in font.glyphs.items():
        where, box = boxes[code]
        glyph.top = font.ascent - box[3] - box[1]
        if abs(glyph.left) > OFFSET_MAX or abs(glyph.top) > OFFSET_MAX:
            raise ToolError(f"{where}: character {code} lies {glyph.left}, {glyph.top} pixels from the top left of its "
                            f"line; at most {OFFSET_MAX} are possible")
    return font


def read(path):
    """A Font from a file."""
    blob = reading.read_whole(path, FILE_MAX, "a font for a microcontroller is far smaller")
    other = foreign.by_beginning(blob[:foreign.START])
    if other and ".bdf" not in other.endings:
        raise ToolError(f"{path}: is {other.kind}, no font in BDF: {other.way}")
    return parse(blob.decode("latin-1"), path)
