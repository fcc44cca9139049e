# SPDX-License-Identifier: MIT
"""What a board's clock counted of each frame: instructions, or the cycles of an emulator."""

import statistics

NOTHING = {"min": None, "median": None, "mean": None, "max": None}
PARTED_EVERY = 4    # frames; the walk draws the last one of each as two rectangles, and counts nothing there


def counts_of(frames):
    """The counts of frames, without those that the walk drew as two rectangles; a 0 was not counted."""
    return [frame.instructions for frame in frames if frame.instructions or frame.number % PARTED_EVERY != PARTED_EVERY - 1]


def figures(frames):
    """Of the counts of frames; null where the board cannot count."""
    counts = counts_of(frames)
    if not counts or not all(counts):
        return NOTHING
    return {"min": min(counts), "median": int(statistics.median(counts)),
            "mean": round(statistics.fmean(counts)), "max": max(counts)}


def summary(frames, program):
    """For summary.json. program: a firmware.Program."""
    found = {"instructions_per_frame": NOTHING, "cycles_per_frame": NOTHING}
    return found | {f"{program.counts}_per_frame": figures(frames), "emulator": None if program.hosted else program.emulator}


def row(told):
    """A row for people. told: a summary."""
    instructions, cycles = told["instructions_per_frame"], told["cycles_per_frame"]
    if cycles["min"] is not None:
        return ["cycles a frame", f"{cycles['min']:,} to {cycles['max']:,}, median {cycles['median']:,}, as {told['emulator']} counts: "
                                  "a real chip also waits for its flash"]
    return ["instructions a frame", "not counted on this board" if instructions["min"] is None else
            f"{instructions['min']:,} to {instructions['max']:,}, median {instructions['median']:,}"]
