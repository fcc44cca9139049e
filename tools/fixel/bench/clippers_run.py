# SPDX-License-Identifier: MIT
"""Runs the programs of make clippers: on the host with the reference renderer, and on emulated cores."""

import collections
import dataclasses
import json
import pathlib
import statistics
import zlib

from fixel.base import scratch
from fixel.bench import bench_run, counter, link_map
from fixel.board import dump, programs
from fixel.base.errors import ToolError
from fixel.bench.machine_code import MachineCode

# Kinds of instructions (thumb.py).
OPERATIONS = {"multiplications": ("multiply", "multiply add", "long multiply", "long multiply add"),
              "divisions": ("divide",)}
MARKERS = ("operations_begin", "operations_end")


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


def operations(plan, core, clipper, file):
    """{"polygons", "instructions", "multiplications", "divisions"}: how many polygons the clipper cut, and what
    that took, their vertices being known, and projecting what was left, of all of them together."""
    elf = plan.operations_program(core, clipper)
    code = MachineCode(elf)
    with scratch.folder("clippers") as folder:
        _, counts = counter.run(elf, code, plan.counter, folder, file, detail=True, timeout=bench_run.TIMEOUT,
                                markers=MARKERS)
    kinds = collections.Counter()
    for address, (times, _) in counter.by_address(counts).items():
        kinds[code.instruction(address).kind] += times
    return {"polygons": len(counts.regions), "instructions": sum(counts.regions),
            **{word: sum(kinds[kind] for kind in each) for word, each in OPERATIONS.items()}}


def size(plan, core, combination):
    """Bytes of flash of the renderer with this combination alone."""
    found = link_map.measure(plan.size_map(core, combination.name))
    return found["code"] + found["constants"] + found["run_time"]


def summary(counts):
    """Least, median and most."""
    return {"min": min(counts), "median": round(statistics.median(counts)), "max": max(counts)}
