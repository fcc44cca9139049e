# SPDX-License-Identifier: MIT
"""Prints the CRC-32 of each frame of a frame dump: "frame" of what was drawn, "sent" of what a display got.

With --wires and --driver, the record of the display's wires says what the display got. Exit: 0 printed, 2 a file cannot be read,
1 the wires are not those of the dump's frames. The numbers are those that lib/include/fixel/crc.h
computes on a board.
"""

import argparse
import dataclasses
import json
import zlib

from fixel.base.errors import ToolError
from fixel.commands import late

controllers, dump, wires = late("fixel.board", "controllers dump wires")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("dump", help="a frame dump, as make run leaves it: build/run/board.fxld")
    made.add_argument("--wires", help="the record of a display's wires, wires.bin")
    made.add_argument("--driver", help="the driver that sent them, as DRIVER= names it")
    made.add_argument("--json", action="store_true", help="JSON instead of the lines")
    return made


def lines(found):
    """What is printed: a line for each frame, and one for all of them."""
    sent = found["sent_crc"] or [None] * len(found["frame_crc"])
    each = [f"{number}: {both(*pair)}" for number, pair in enumerate(zip(found["frame_crc"], sent))]
    return [*each, f"all: {both(found['frame_crc_all'], found['sent_crc_all'])}"]


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    if bool(options.wires) != bool(options.driver):
        raise ToolError("--wires and --driver belong together: one says what was sent, the other to which display")
    if options.driver and options.driver not in controllers.MODULES:
        raise ToolError(f"there is no driver {options.driver}; the drivers are: {' '.join(sorted(controllers.MODULES))}")
    whole = dump.read_dump(options.dump)
    sent = wires.compare(options.wires, options.driver, whole).sent if options.wires else None
    found = summary(drawn(whole.frames), sent)
    print(json.dumps(found) if options.json else "\n".join(lines(found)))
    return 0


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
