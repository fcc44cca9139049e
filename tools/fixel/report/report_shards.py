# SPDX-License-Identifier: MIT
"""Samples in numbered shards, merged so that any number of processes gives the same figures.

What a shard holds depends on its kind, the seed and its number alone; how
many shards there are and how long each is, on the number of samples alone;
and results are added up in the order of the shards.

Up to the default number of samples all shards are computed. A report of more samples ends when its minutes are over: it
is about the first shards of each kind, as far as they are done, and the same command goes on with the next ones.
"""

import dataclasses
import importlib
import json
import math
import sys

from fixel.base.errors import ToolError
from fixel.campaign import runner
from fixel.campaign.shards import Shard

# The whole report's number of samples; everything below is a share of it.
SAMPLES = 10_000_000
FEWEST = 100    # of any kind
MOST_SHARDS = 4000      # of any kind: those of more samples are longer
MINUTES, CORES = "20", 2    # what samples beyond the default may take

# --- as a campaign (fixel/campaign/shards.py) ----------------------------------

SHARD_SETUP = "oracle"


def run_shard(build, parameters):
    """What a program says of a shard."""
    return _run(_command(build, **parameters))


def shard_inputs(build, parameters):
    return [build / "host" / parameters["program"]]


def shard_targets(build, parameters):
    return [f"{build}/host/{parameters['program']}"]


# --- the kinds --------------------------------------------------------------------


@dataclasses.dataclass(frozen=True)
class Kind:
    """A kind of samples: who draws them, how many of every ten million, how many a shard."""
    program: str
    what: str
    share: int
    shard: int

    def samples(self, total):
        """How many of these a report of so many samples draws."""
        return max(FEWEST, total * self.share // SAMPLES)


# place claim: how many samples
CLAIMS = tuple(Kind("oracle", *kind) for kind in (
    ("matrix_entry", 2_000_000, 100_000),
    ("matrix_entry_instance", 10_000_000, 250_000),
    ("orientation_angles", 10_000_000, 250_000),
    ("orientation_axis", 10_000_000, 250_000),
    ("orientation_look_at", 10_000_000, 250_000),
    ("orientation_product", 10_000_000, 250_000),
    ("orientation_quaternion", 10_000_000, 250_000),
    ("quaternion", 10_000_000, 100_000),
    ("orientation_parents", 10_000_000, 100_000),
    ("sine_cosine", 2_000_000, 100_000),
    ("vertex_unclipped", 10_000_000, 250_000),
    ("vertex_turned", 10_000_000, 250_000),
    ("outline_clipped", 1_000_000, 10_000),
    ("coverage", 1_000_000, 10_000),
    ("watertight", 500_000, 10_000),
    ("texel_divided", 2_000_000, 50_000),
    ("texel_every_16", 2_000_000, 50_000),
    ("texel_every_8", 2_000_000, 50_000),
    ("texel_affine", 1_000_000, 50_000),
    ("light_level", 1_000_000, 50_000),
    ("corner_colour", 1_000_000, 50_000),
    ("depth_16", 2_000_000, 50_000),
    ("depth_32", 2_000_000, 50_000),
    ("horizon", 1_000_000, 20_000),
    ("orthographic_vertex", 10_000_000, 250_000),
    ("orthographic_texel", 1_000_000, 50_000),
    ("orthographic_depth", 2_000_000, 50_000)))
STAGES = tuple(Kind("designs", *kind) for kind in (
    ("matrix", 1_000_000, 100_000),
    ("vertex", 10_000_000, 250_000),
    ("clip", 2_000_000, 100_000),
    ("fill", 200_000, 10_000),
    *((stage, 200_000, 10_000) for stage in (
        "texel", "texel_16", "texel_8", "affine", "light", "depth_buffer_16", "depth_buffer_32"))))
# Of each point of the sweep.
SWEEPS = tuple(Kind("designs", f"sweep:{name}", 100_000, 10_000) for name in (
    "near", "depth", "fov", "coordinates", "edge_length", "plane_angle")) + tuple(
    Kind("designs", f"sweep:{name}", 20_000, 2_000) for name in (
        "texel_depth", "texel_size", "texel_face", "light_depth", "distance_16", "distance_32"))


def shards_of(kind, total):
    """(number, samples) of each shard."""
    left = kind.samples(total)
    length = kind.shard * -(-left // (kind.shard * MOST_SHARDS))
    return [(number, min(length, left - number * length)) for number in range(-(-left // length))]


def _command(build, program, what, seed, shard, samples):
    return [build / "host" / program, what, "--samples", str(samples), "--seed", str(seed), "--shard", str(shard)]


def _run(command):
    try:
        text = importlib.import_module("fixel.board.programs").run_program(command)     # it needs NumPy
    except ToolError as error:
        words = " ".join(str(word) for word in command)
        raise ToolError(f"{error.message} (command: {words})", error.exit_code, error.words) from error
    try:
        return json.loads(text)
    except ValueError as error:
        raise ToolError(f"{command[0]}: its output is not the JSON agreed on: {error}") from error


def plan(kinds, total, seed):
    """(the shards, how many of the first ones are computed whatever they take). Those behind them stand so that all kinds
    come to their end together."""
    first, rest = [], []
    for place, kind in enumerate(kinds):
        some, least, behind = shards_of(kind, total), kind.samples(min(total, SAMPLES)), 0
        for number, samples in some:
            (first if behind < least else rest).append((number / len(some), place, kind, number, samples))
            behind += samples
    first.sort(key=lambda each: each[1])
    rest.sort(key=lambda each: each[:2])
    return [Shard("report", place, {"program": kind.program, "what": kind.what, "seed": seed, "shard": number,
                                    "samples": samples}, f"{kind.program} {kind.what}", samples)
            for place, (_, _, kind, number, samples) in enumerate(first + rest)], len(first)


def draw(options, kinds):
    """The results of every kind's shards, in order: {what: [result, ...]}."""
    assert len({kind.what for kind in kinds}) == len(kinds), "two kinds of one name"
    some, first = plan(kinds, options.samples, options.seed)
    budget = runner.Budget(60 * CORES * options.minutes if options.minutes else None)
    done = runner.run(f"drawing {sum(shard.samples for shard in some):,} samples, in shards", some, options, budget, first)
    by_kind, ended = {kind.what: [] for kind in kinds}, set()
    for shard in some:
        what = shard.parameters["what"]
        if shard.number not in done.results:
            ended.add(what)
        elif what not in ended:
            by_kind[what].append(done.results[shard.number])
    done.tell(options.build, options.samples)
    if ended:
        print(f"after {options.minutes} minutes of {CORES} cores the report is about the shards that are done: the same command goes "
              "on with the others, and MINUTES=0 lets it run to its end", file=sys.stderr)
    return by_kind


def merge(parts):
    """One tally of several: max, mean, rms, samples, histogram, and the first of the worst inputs."""
    try:
        samples = sum(part["samples"] for part in parts)
        worst = max(parts, key=lambda part: part["max"])
        counts = {}
        for part in parts:
            for entry in part["histogram"]:
                counts[entry["upto"]] = counts.get(entry["upto"], 0) + entry["count"]
        return {"max": worst["max"], "mean": sum(map(_sum, parts)) / samples,
                "rms": math.sqrt(sum(map(_squares, parts)) / samples), "samples": samples,
                "worst_input": worst["worst_input"],
                "histogram": [{"upto": upto, "count": counts[upto]} for upto in sorted(counts)]}
    except (KeyError, TypeError, ZeroDivisionError) as error:
        raise ToolError(f"a shard's result lacks {error}, or holds no samples") from error


def _sum(part):
    return part["sum"] if "sum" in part else part["mean"] * part["samples"]


def _squares(part):
    if "sum_of_squares" in part:
        return part["sum_of_squares"]
    return part["rms"] * part["rms"] * part["samples"]


def _by_design(results):
    """Merged tallies of [{"designs": [...]}, ...], by design."""
    names = [entry["design"] for entry in results[0]["designs"]]
    return {name: merge([result["designs"][place] for result in results])
            for place, name in enumerate(names)}


def merge_stage(build, about, results):
    """The entries of stages[] of one stage; about is what the program says of it."""
    return [{"stage": about["stage"], "design": design, "unit": about["unit"], **tally,
             "command": f"{build}/host/designs {about['stage']} --input \"{tally['worst_input']}\""}
            for design, tally in _by_design(results).items()]


def merge_sweep(about, results):
    """The entries of sweeps[] of one parameter."""
    points = {}
    for place, point in enumerate(results[0]["points"]):
        for design, tally in _by_design([result["points"][place] for result in results]).items():
            points.setdefault(design, []).append(
                {"value": point["value"], "max": tally["max"], "mean": tally["mean"],
                 "samples": tally["samples"]})
    return [{"parameter": about["parameter"], "design": design, "stage": about["stage"],
             "label": about["label"], "unit": about["unit"], "points": rows}
            for design, rows in points.items()]


def merge_depths(results):
    """[{"design", "points": [{"value", "max", "samples"}]}] of the vertices of a stage's shards, by depth: a
    point holds the depths from its value to twice that."""
    samples, largest = {}, {}
    for bin_ in (each for result in results for each in result["depths"]):
        samples[bin_["value"]] = samples.get(bin_["value"], 0) + bin_["samples"]
        for design, error in bin_["max"].items():
            known = largest.setdefault(design, {})
            known[bin_["value"]] = max(error, known.get(bin_["value"], 0))
    return [{"design": design, "points": [{"value": value, "max": points[value], "samples": samples[value]}
                                          for value in sorted(points)]} for design, points in largest.items()]


def list_designs(build):
    """What build/host/designs compares: {"stages": [...], "sweeps": [...]}."""
    return _run([build / "host" / "designs", "--list"])
