# SPDX-License-Identifier: MIT
"""Bytes that a display is sent a frame, and the share of them that boxes save: what changed since the frame before (docs/extras/changed.md)."""

from fixel.board import controllers

# place pixel-format: bytes of a pixel that is sent
PIXEL_BYTES = 2     # of RGB565: where no driver is named


def steps_of(driver):
    """Columns and rows that the boxes of a driver's display begin and end with; 0 columns for whole rows."""
    model = controllers.model(driver) if driver else controllers.Colour
    return (0, 1) if issubclass(model, controllers.MemoryLcd) else model.UNIT


def _bytes_of(driver, columns, rows):
    if not driver:
        return PIXEL_BYTES * columns * rows
    model, glass = controllers.MODULES[driver]
    return model.frame_bytes(columns, rows, glass)


def told(driver, width, height, boxes):
    """What a display is sent, for JSON. boxes: of each frame [(first column, columns, first row, rows)]; None: they are not known. The
    first frame is always whole, so its boxes do not count."""
    whole, sent = _bytes_of(driver, width, height), None
    if boxes is not None and len(boxes) > 1:
        sent = sum(_bytes_of(driver, columns, rows) for frame in boxes[1:] for _, columns, _, rows in frame) / (len(boxes) - 1)
    return {"display_bytes": whole, "display_bytes_by_boxes": None if sent is None else round(sent),
            "display_share_saved": None if sent is None else round(1 - sent / whole, 4)}


def eye_moves(frames):
    """Whether the eye is elsewhere in each frame of a dump than in the one before; then each is the whole frame."""
    poses = [(frame.position, frame.angles) for frame in frames]
    return all(one != other for one, other in zip(poses, poses[1:]))


def row(summary, are_sent=False, unknown=""):
    """A row for people. summary: with what told() says; are_sent: the program sent boxes; unknown: what to say where they are not known."""
    whole, sent, saved = (summary[key] for key in ("display_bytes", "display_bytes_by_boxes", "display_share_saved"))
    said = f"{whole:,} to a display" + ("" if summary.get("driver") else " of RGB565")
    if sent is None:
        said += f"; {unknown}" if unknown else ""
    elif are_sent:
        said += f"; {sent:,} came in boxes in a mean frame after the first: {100 * saved:.0f} % saved"
    elif saved < 0.0005:
        said += "; what changed is the whole frame each time"
    else:
        said += f"; boxes of what changed would take {sent:,} in a mean frame after the first: {100 * saved:.0f} % saved"
    return ["bytes a frame", said]
