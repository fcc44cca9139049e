# SPDX-License-Identifier: MIT
"""The CRCs of a frame dump, a line for each frame."""

import json

from fixel.base.errors import ToolError
from fixel.board import controllers, dump, frame_crc, wires


def lines(found):
    """What is printed: a line for each frame, and one for all of them."""
    sent = found["sent_crc"] or [None] * len(found["frame_crc"])
    each = [f"{number}: {frame_crc.both(*pair)}" for number, pair in enumerate(zip(found["frame_crc"], sent))]
    return [*each, f"all: {frame_crc.both(found['frame_crc_all'], found['sent_crc_all'])}"]


def command(options):
    """The command; its exit code."""
    if bool(options.wires) != bool(options.driver):
        raise ToolError("--wires and --driver belong together: one says what was sent, the other to which display")
    if options.driver and options.driver not in controllers.MODULES:
        raise ToolError(f"there is no driver {options.driver}; the drivers are: {' '.join(sorted(controllers.MODULES))}")
    drawn = dump.read_dump(options.dump)
    sent = wires.compare(options.wires, options.driver, drawn).sent if options.wires else None
    found = frame_crc.summary(frame_crc.drawn(drawn.frames), sent)
    print(json.dumps(found) if options.json else "\n".join(lines(found)))
    return 0
