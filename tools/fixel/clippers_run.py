# SPDX-License-Identifier: MIT
"""Runs the programs of make clippers: on the host with the double twin, and on emulated cores."""

import dataclasses
import json
import pathlib
import statistics
import zlib

from fixel import bench_run, dump, link_map, programs
from fixel.errors import ToolError

# Kinds of instructions (fixel/places.py) that are a multiplication; a division.
MULTIPLY, DIVIDE = ("multiply", "long multiply"), ("divide",)
# Stages (bench/stages.toml) of a polygon's way to the screen: before it is cut, and the cut itself.
CUT_STAGES = ("clip",)


@dataclasses.dataclass
class OnHost:
    """A scene drawn by a combination on the host: the judge's verdict, what the clipper did, and
    each frame's CRC."""
    verdict: dict
    found: dict
    sums: list
    drawn: object       # dump.Dump: the library's frames
    twin: object        # the same from double


def frame_sums(frames):
    """CRC-32 of each frame's pixels."""
    return [zlib.crc32(pixels.tobytes()) for pixels in frames]


def on_host(plan, combination, scene, file, folder):
    """Draws a scene with lib/ and with double, and judges."""
    name = f"{combination.name}-{scene['name']}"
    drawn, twin, report = (pathlib.Path(folder) / f"{name}{end}" for end in (".fxld", "-double.fxld", ".json"))
    said = programs.run_program([plan.host_program(combination.name), plan.clippers[combination.clipper]["sides"],
                                 file, drawn])
    explained = plan.explained(combination.clipper, scene["image"])
    programs.run_program([plan.build / "host" / "judge", file, drawn, "--json", report, "--twin", twin,
                          "--distance", repr(explained),
                          "--clipper", combination.clipper,
                          "--hidden", "tree" if plan.hidden[combination.hidden]["tree"] else "sorted"])
    frames = dump.read_dump(drawn)
    try:
        found = json.loads(said)
    except ValueError as error:
        raise ToolError(f"{combination.name}: its output is not the JSON agreed on: {error}", 1) from error
    return OnHost(programs.read_json(report), found, frame_sums([frame.pixels for frame in frames.frames]),
                  frames, dump.read_dump(twin))


def on_core(plan, core, combination, file):
    """Drawn (bench_run): a scene drawn on an emulated core."""
    return bench_run.draw(plan, core, combination.name, file)


def operations(plan, core, combination, file):
    """{"multiplications", "divisions"}: instructions of these kinds that the stages that cut executed,
    over all frames."""
    taken, _ = bench_run.profile(plan, core, combination.name, file)
    return {word: sum(taken.kinds[stage, group] for stage in CUT_STAGES for group in groups)
            for word, groups in (("multiplications", MULTIPLY), ("divisions", DIVIDE))}


def size(plan, core, combination):
    """Bytes of flash of the renderer with this combination alone."""
    found = link_map.measure(plan.size_map(core, combination.name))
    return found["code"] + found["constants"] + found["run_time"]


def summary(counts):
    """Least, median and most."""
    return {"min": min(counts), "median": round(statistics.median(counts)), "max": max(counts)}
