# SPDX-License-Identifier: MIT
"""Records the live window for the README: a walk through the plaza, by keys, in a headless browser."""

import argparse
import io
import itertools
import pathlib
import time

from fixel.base import output
from fixel.base.errors import ToolError, one_line
from fixel.base.progress import steps
from fixel.commands import late
from fixel.view import browser

Image = late("PIL.Image")

WIDTH, HEIGHT = 1280, 800   # of the browser's window
FORMATS = [(540, 45), (540, 30), (460, 30), (400, 30)]      # pixels across, quality; the first that fits
METHOD = 4                  # of WebP: a better one takes longer
MILLISECONDS = 120          # between two pictures, and what taking one takes
LAST = 1.0                  # seconds that the last picture stands
SIZE_MAX = 140_000          # bytes
# For each picture: what is pressed and what is let go before it ("1".."3" choose what is shown beside).
SCRIPT = [[], ["+w"], [], [], ["+d"], [], ["-d", "+a"], ["-a"], ["-w", "1"], [], ["+q"], ["-q", "+e"], ["-e", "3"], [], ["+a"], ["-a", "+w"], [],
          ["-w", "2"], [], ["+d"], ["-d", "+s"], ["-s", "0"], []]


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    made.add_argument("--board", required=True)
    made.add_argument("--scene", required=True)
    made.add_argument("--build", default="build", help="folder that make builds in")
    made.add_argument("--out", type=pathlib.Path, required=True, help="the recording, a WebP")
    return made


def play(page, actions):
    for action in actions:
        if action[0] == "+":
            page.keyboard.down(action[1:])
        elif action[0] == "-":
            page.keyboard.up(action[1:])
        else:
            page.keyboard.press(action)


def pictures(page, script):
    """Pictures of the page as it plays, as PNG, and for how many milliseconds it looked so."""
    shots, times = [], []
    for actions in steps("recording", script):
        play(page, actions)
        page.wait_for_timeout(MILLISECONDS)
        times.append(time.monotonic())
        shots.append(page.screenshot())
    times.append(times[-1] + LAST)
    return shots, [round(1000 * (end - start)) for start, end in itertools.pairwise(times)]


def scaled(shot, width):
    with Image.open(io.BytesIO(shot)) as picture:
        size = width, round(width * picture.height / picture.width)
        return picture.convert("RGB").resize(size, Image.Resampling.LANCZOS)


def animation(taken, lasting, quality):
    """An endless WebP of pictures."""
    block = io.BytesIO()
    taken[0].save(block, "WEBP", save_all=True, append_images=taken[1:], loop=0, duration=lasting, quality=quality, method=METHOD)
    return block.getvalue()


def fitting(shots, lasting):
    """The largest animation that SIZE_MAX has room for: how much changes between two pictures is the machine's
    speed, so one format can't fit every recording."""
    for width, quality in FORMATS:
        data = animation([scaled(shot, width) for shot in shots], lasting, quality)
        if len(data) <= SIZE_MAX:
            return data
    raise ToolError(f"the smallest recording takes {len(data):,} bytes; {SIZE_MAX:,} are allowed", exit_code=1)


def record(options):
    """The recording's bytes."""
    with browser.viewing(options.board, options.scene, options.build) as (_, address), \
            browser.chromium() as chromium, browser.page(chromium, address, WIDTH, HEIGHT) as page:
        page.wait_for_timeout(1000)     # until the rates are measured
        taken, lasting = pictures(page, SCRIPT)
        if page.complaints:
            raise ToolError(f"the page complains: {page.complaints[0]}", exit_code=1)
    return fitting(taken, lasting)


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    output.write_file(options.out, record(options))
    print(one_line(options.out))
    return 0
