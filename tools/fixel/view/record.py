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
FORMATS = [(540, 128), (540, 96), (500, 96), (460, 64), (400, 64)]  # pixels across, colours; the first that fits
REFINED = 3                 # turns of the palette's refinement
MILLISECONDS = 120          # between two pictures, and what taking one takes
LAST = 1.0                  # seconds that the last picture stands
SIZE_MAX = 700_000          # bytes
# For each picture: what is pressed and what is let go before it ("1".."3" choose what is shown beside).
SCRIPT = [[], ["+w"], [], [], [], [], ["+d"], [], ["-d", "+a"], [], ["-a"], [], [], ["-w", "1"], [], ["+q"], [],
          ["-q", "+e"], [], ["-e", "3"], [], ["+a"], [], [], ["-a", "+w"], [], [], ["-w", "2"], [], ["+d"], [], [],
          ["-d", "+s"], [], [], ["-s", "0"], []]


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    made.add_argument("--board", required=True)
    made.add_argument("--scene", required=True)
    made.add_argument("--build", default="build", help="folder that make builds in")
    made.add_argument("--out", type=pathlib.Path, required=True, help="the recording, a GIF")
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


def animation(taken, lasting, colours):
    """An endless GIF of pictures, with one palette for all."""
    sheet = Image.new("RGB", (taken[0].width, sum(each.height for each in taken[::6])))
    for place, each in enumerate(taken[::6]):
        sheet.paste(each, (0, place * each.height))
    palette = sheet.quantize(colours, Image.Quantize.MEDIANCUT, kmeans=REFINED)
    small = [each.quantize(palette=palette, dither=Image.Dither.NONE) for each in taken]
    block = io.BytesIO()
    small[0].save(block, "GIF", save_all=True, append_images=small[1:], loop=0, duration=lasting)
    return block.getvalue()


def fitting(shots, lasting):
    """The largest animation that SIZE_MAX has room for: how much changes between two pictures is the machine's
    speed, so one format can't fit every recording."""
    for width, colours in FORMATS:
        data = animation([scaled(shot, width) for shot in shots], lasting, colours)
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
