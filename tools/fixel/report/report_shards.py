# SPDX-License-Identifier: MIT
"""Samples in numbered shards, on all cores; merged so that any number of processes gives the same figures.

What a shard holds depends on its kind, the seed and its number alone; how
many shards there are and how long each is, on the number of samples alone;
and results are added up in the order of the shards.
"""

import concurrent.futures
import dataclasses
import json
import math
import os

from fixel.base.errors import ToolError
from fixel.board.programs import run_program
from fixel.base.progress import Progress

# The whole report's number of samples; everything below is a share of it.
SAMPLES = 10_000_000
FEWEST = 100    # of any kind


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


CLAIMS = tuple(Kind("oracle", *kind) for kind in (
    ("matrix_entry", 2_000_000, 100_000),
    ("matrix_entry_instance", 10_000_000, 250_000),
    ("orientation_angles", 10_000_000, 250_000),
    ("orientation_axis", 10_000_000, 250_000),
    ("orientation_look_at", 10_000_000, 250_000),
    ("orientation_product", 10_000_000, 250_000),
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
    ("depth_32", 2_000_000, 50_000)))
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
    return [(number, min(kind.shard, left - number * kind.shard))
            for number in range(-(-left // kind.shard))]


def _command(build, kind, seed, number, samples):
    return [build / "host" / kind.program, kind.what, "--samples", str(samples), "--seed", str(seed),
            "--shard", str(number)]


def _run(command):
    try:
        text = run_program(command)
    except ToolError as error:
        words = " ".join(str(word) for word in command)
        raise ToolError(f"{error.message} (command: {words})", error.exit_code, error.words) from error
    try:
        return json.loads(text)
    except ValueError as error:
        raise ToolError(f"{command[0]}: its output is not the JSON agreed on: {error}") from error


def run_shards(build, kinds, total, seed, processes=None):
    """The results of every kind's shards, in order: {what: [result, ...]}."""
    jobs = [(kind, number, samples) for kind in kinds for number, samples in shards_of(kind, total)]
    label = f"drawing {sum(samples for _, _, samples in jobs):,} samples, in shards"
    with Progress(label, len(jobs)) as progress, \
            concurrent.futures.ThreadPoolExecutor(processes or os.cpu_count()) as pool:
        futures = [pool.submit(_run, _command(build, kind, seed, number, samples))
                   for kind, number, samples in jobs]
        try:
            for done, future in enumerate(concurrent.futures.as_completed(futures), 1):
                future.result()
                progress(done)
            results = [future.result() for future in futures]
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise
    by_kind = {kind.what: [] for kind in kinds}
    assert len(by_kind) == len(kinds), "two kinds of one name"
    for (kind, _, _), result in zip(jobs, results):
        by_kind[kind.what].append(result)
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
