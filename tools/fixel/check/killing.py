# SPDX-License-Identifier: MIT
"""Commands killed at random moments, and what they leave."""

import random
import signal
import sys

from fixel.base import output, scratch
from fixel.scene import making
from fixel.check import kill_campaign
from fixel.check import kills as kills_command
from fixel.base.progress import Progress
from fixel.base.table import coloured, table

SCENE = "scenes/tiny.toml"


def make_campaign(options, folder):
    scenes = {}
    for name, frames in kill_campaign.FRAMES.items():
        scenes[name] = folder / f"{name}.fxls"
        making.build(SCENE, str(scenes[name]), frames)
    with Progress("running each command undisturbed"):
        campaign = kill_campaign.Campaign(folder, options.build, scenes, options.samples, options.board,
                                          options.streaming)
        campaign.prepare(options.commands)
    return campaign


def carry_out(options, campaign):
    """All kills; one that leaves something is told at once."""
    choose, kills = random.Random(options.seed), []
    with Progress("kills", options.kills) as progress:
        for number in range(options.kills):
            kills.append(campaign.kill(options.commands[number % len(options.commands)], choose))
            for sentence in kills[-1].complaints:
                print(f"kill {number}, {kills[-1].command} by {kills[-1].signal.name} after {kills[-1].seconds:.2f} s"
                      f"{' with a child' if kills[-1].at_child else ''}: {sentence}", file=sys.stderr, flush=True)
            progress(len(kills))
    return kills


def print_kills(kills, commands):
    rows = [[command, *(sum(kill.command == command and kill.signal == each for kill in kills)
                        for each in kill_campaign.SIGNALS),
             sum(kill.command == command and kill.early for kill in kills),
             sum(kill.command == command and bool(kill.complaints) for kill in kills)] for command in commands]
    print(table(rows, ["kills of", *(each.name for each in kill_campaign.SIGNALS), "at work", "left something"]))
    bad = sum(bool(kill.complaints) for kill in kills)
    print(f"{coloured('FAIL', 'red') if bad else coloured('pass', 'green')}: {len(kills) - bad} of {len(kills)} kills "
          "left no process, no file and nothing half-written")
    return bad


def command(options):
    """The command; its exit code."""
    options = kills_command.before(options)
    # A shell ignores it for what it starts in the background, and so would the commands.
    if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    output.make_folder(options.build)
    with scratch.folder("kills", options.build) as folder:
        kills = carry_out(options, make_campaign(options, folder))
    return 1 if print_kills(kills, options.commands) else 0
