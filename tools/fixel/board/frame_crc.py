# SPDX-License-Identifier: MIT
"""Frames as numbers: the CRC-32 that lib/include/fixel/crc.h computes on a board, of what was drawn and of what a display got."""

import dataclasses
import zlib


@dataclasses.dataclass
class Crcs:
    """The CRC of each of a row of frames, and of all of them as one."""
    each: list = dataclasses.field(default_factory=list)    # eight hexadecimal digits
    _all: int = 0

    def add(self, data):
        """The next frame: its pixels as bytes, rows downward."""
        self.each.append(f"{zlib.crc32(data):08x}")
        self._all = zlib.crc32(data, self._all)

    @property
    def all(self):
        """Eight digits for all frames, one after the other."""
        return f"{self._all:08x}"


def pixel_bytes(pixels):
    """A frame's pixels as fxl_band_crc takes them: those of 16 bits have the high byte first."""
    return pixels.astype(">u2").tobytes() if pixels.itemsize == 2 else pixels.tobytes()


def drawn(frames):
    """The CRCs called "frame": of the frames of a dump."""
    made = Crcs()
    for frame in frames:
        made.add(pixel_bytes(frame.pixels))
    return made


def summary(frame, sent):
    """The CRCs for JSON. sent: None where no display's wires were recorded."""
    return {"frame_crc": frame.each, "frame_crc_all": frame.all,
            "sent_crc": sent.each if sent else None, "sent_crc_all": sent.all if sent else None}


def both(frame, sent):
    """The two numbers of a frame, or of all, for people."""
    return f"frame {frame}, sent {sent or '-'}"
