# SPDX-License-Identifier: MIT
"""Measures every claim about accuracy, and compares Fixel with plain 16.16 and float32.

Writes report.json and report.html (one self-contained page). The same seed and number of samples give the
same report on every machine. --only measures some claims, with as many samples as you like, and writes
claims.json. Exit: 0 every claim holds and the ray-cast oracle agrees, 1 not, 2 the report could not be made.
"""

import argparse

from fixel import commands
from fixel.base import bounded
from fixel.base.arguments import whole_number
from fixel.base.errors import ToolError
from fixel.campaign import runner
from fixel.report import report_shards

SAMPLES_MAX = 10 ** 12
MINUTES_MAX = 60 * 24 * 366


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--samples", help="number of vertices, ten million without; the other samples are in proportion (SAMPLES=)")
    made.add_argument("--seed", default="1", help="seed of the random samples (SEED=)")
    made.add_argument("--only", default="", help="measure these claims alone, like \"texel_affine depth_16\"; no page (ONLY=)")
    made.add_argument("--scene", help="judge only the frames of this .toml, .obj or .fxls (SCENE=)")
    bounded.add_options(made)
    made.add_argument("--board", default="mps2-an385", help="board that counts instructions for the claim scale")
    made.add_argument("--minutes", help="of two cores that samples beyond ten million may take: 20, and on a cluster any number; 0: any number "
                                        "(MINUTES=)")
    made.add_argument("--out", default="build/report")
    made.add_argument("--build", default="build", help="folder that make builds in")
    runner.add_options(made)
    made.add_argument("--picture", metavar="FILE",
                      help="only write the README's picture, from the report in --out")
    return made


def before(options):
    """The options, as the command needs them."""
    options.samples = report_shards.SAMPLES if options.samples is None else \
        whole_number("SAMPLES", options.samples, 1, SAMPLES_MAX)
    options.seed = whole_number("SEED", options.seed, 0, 2 ** 64 - 1)
    runner.jobs_of(options)
    minutes = "0" if options.cluster and options.minutes is None else options.minutes or report_shards.MINUTES
    options.minutes = whole_number("MINUTES", minutes, 0, MINUTES_MAX)
    options.only = options.only.split()
    known = [kind.what for kind in report_shards.CLAIMS]
    for word in options.only:
        if word not in known:
            raise ToolError(f"ONLY names '{word}'; the claims that have samples are: {', '.join(known)}")
    return options


main = commands.main_of(parser, "fixel.report.accuracy")
