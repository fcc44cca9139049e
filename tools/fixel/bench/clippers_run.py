# SPDX-License-Identifier: MIT
"""Runs the programs of make clippers: on the host with the reference renderer, and on emulated cores. Each run is a shard of
a campaign (fixel/campaign/shards.py). Its parameters have the scene image, so that it depends on the programs alone. What was drawn, judged and counted becomes the rows
of clippers.json, and what is wrong with them is said."""

import base64
import collections
import json
import pathlib
import statistics
import zlib

import numpy

from fixel.base import scratch
from fixel.base.errors import ToolError
from fixel.bench import bench_run, clippers_plan, counter, linked_size
from fixel.bench.machine_code import MachineCode, read_once
from fixel.board import dump, programs, qemu
from fixel.campaign.shards import Shard
from fixel.image import image
from fixel.report.report_frames import Shown

# Kinds of instructions (thumb.py).
OPERATIONS = {"multiplications": ("multiply", "multiply add", "long multiply", "long multiply add"),
              "divisions": ("divide",)}
MARKERS = ("operations_begin", "operations_end")
HOST = "host"
SHARD_SETUP = "report"


# --- the campaign ------------------------------------------------------------------
CLAIM_BEYOND = 1e-4     # of outlines may be beyond the claim: docs/extras/clippers.md says why


def shard_of(number, what, core, combination, scene):
    """A shard. what: "frames", on the host or a core, or "operations"."""
    return Shard("clippers", number, {"what": what, "core": core, "clipper": combination.clipper, "hidden": combination.hidden,
                                      "image": packed(scene["file"].read_bytes())},
                 f"{core} {what}", 0)


def run_shard(build, parameters):
    plan = clippers_plan.Plan(build)
    combination = clippers_plan.Combination(parameters["clipper"], parameters["hidden"])
    with scratch.folder("clippers") as folder:
        file = folder / "scene.fxls"
        file.write_bytes(unpacked(parameters["image"]))
        if parameters["what"] == "operations":
            return operations(plan, parameters["core"], combination.clipper, file)
        if parameters["core"] == HOST:
            return on_host(plan, combination, file, folder)
        return on_core(plan, parameters["core"], combination, file)


def _programs(build, parameters):
    plan = clippers_plan.Plan(build)
    combination = clippers_plan.Combination(parameters["clipper"], parameters["hidden"])
    if parameters["core"] == HOST:
        return [plan.host_program(combination.name), plan.build / "host" / "judge"]
    return [plan.operations_program(parameters["core"], combination.clipper) if parameters["what"] == "operations" else
            plan.program(parameters["core"], combination.name), plan.counter]


def shard_inputs(build, parameters):
    return [*_programs(build, parameters), clippers_plan.PLAN, "" if parameters["core"] == HOST else qemu.version()]


def shard_targets(build, parameters):
    return list(map(str, _programs(build, parameters)))


def packed(data):
    """Bytes as text."""
    return base64.b64encode(zlib.compress(data)).decode()


def unpacked(text):
    return zlib.decompress(base64.b64decode(text))


def shown(name, host, number):
    """A frame of a scene of which the host's result has the pictures, for the page."""
    one = host["shown"][str(number)]
    return Shown(name, number, host["differing"][number], numpy.frombuffer(unpacked(host["palette"]), numpy.uint8).reshape(-1, 3),
                 *(numpy.frombuffer(unpacked(one[side]), one["type"]).reshape(one["shape"]) for side in ("drawn", "twin")))


# --- what is run -------------------------------------------------------------------

def frame_sums(frames):
    """CRC-32 of each frame's pixels."""
    return [zlib.crc32(pixels.tobytes()) for pixels in frames]


def on_host(plan, combination, file, folder):
    """A scene drawn with lib/ and with double, and judged: the judge's verdict, what the clipper did, each frame's CRC, and
    pictures of the middle frame and of the one that differs most."""
    drawn, twin, report = (folder / name for name in ("drawn.fxld", "double.fxld", "judge.json"))
    said = programs.run_program([plan.host_program(combination.name), plan.clippers[combination.clipper]["sides"],
                                 file, drawn])
    explained = plan.explained(combination.clipper, image.load(file))
    programs.run_program([plan.build / "host" / "judge", file, drawn, "--json", report, "--twin", twin,
                          "--distance", repr(explained),
                          "--clipper", combination.clipper,
                          "--hidden", "tree" if plan.hidden[combination.hidden]["tree"] else "sorted"])
    frames, doubles, verdict = dump.read_dump(drawn), dump.read_dump(twin), programs.read_json(report)
    try:
        found = json.loads(said)
    except ValueError as error:
        raise ToolError(f"{combination.name}: its output is not the JSON agreed on: {error}", 1) from error
    differing = [entry["pixels_differing"] for entry in verdict.pop("frames")]
    pictures = {len(differing) // 2, differing.index(max(differing))}
    return {"verdict": verdict, "found": found, "sums": frame_sums([frame.pixels for frame in frames.frames]),
            "split_bands": sum(frame.counters.get("split_bands", 0) for frame in frames.frames), "differing": differing,
            "palette": packed(frames.palette.tobytes()),
            "shown": {str(number): {"drawn": packed(frames.frames[number].pixels.tobytes()),
                                    "twin": packed(doubles.frames[number].pixels.tobytes()),
                                    "type": str(frames.frames[number].pixels.dtype), "shape": frames.frames[number].pixels.shape}
                      for number in sorted(pictures)}}


def on_core(plan, core, combination, file):
    """A scene drawn on an emulated core."""
    drawn = bench_run.draw(plan, core, combination.name, file)
    return {"instructions": drawn.instructions, "sums": frame_sums(drawn.pixels), "memory": drawn.memory, "stack": drawn.stack}


def operations(plan, core, clipper, file):
    """{"polygons", "instructions", "multiplications", "divisions"}: how many polygons the clipper cut, and what
    that took, their vertices being known, and projecting what was left, of all of them together."""
    elf = plan.operations_program(core, clipper)
    code = read_once(MachineCode, elf)
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
    found = linked_size.sizes_of_map(plan.size_map(core, combination.name))
    return found["code"] + found["constants"] + found["run_time"]


def summary(counts):
    """Least, median and most."""
    return {"min": min(counts), "median": round(statistics.median(counts)), "max": max(counts)}


def row(plan, core, combination, scene, host, drawn, text_bytes):
    """A row: one combination, scene and core."""
    verdict, found = host["verdict"], host["found"]
    return {"clipper": combination.clipper, "hidden": combination.hidden, "scene": scene["name"], "board": core,
            "frames": len(drawn["instructions"]), "instructions": summary(drawn["instructions"]),
            "text_bytes": text_bytes, "ram_bytes": drawn["memory"], "stack_bytes": drawn["stack"],
            "max_error_units": found["max_error_units"], "max_error_units_at_all": found["max_error_units_at_all"],
            "pixels": verdict["pixels"], "pixels_differing": verdict["pixels_differing"],
            "pixels_tied": verdict["pixels_tied"], "pixels_unexplained": verdict["pixels_unexplained"],
            "max_edge_distance_px": verdict["max_edge_distance_px"],
            "explained_px": plan.explained(combination.clipper, scene["image"]),
            "equal_to_host": drawn["sums"] == host["sums"],
            "crcs": [f"{value:08x}" for value in host["sums"]],
            **{key: found[key] for key in ("faces", "crossing", "missed", "refused", "beyond", "vertices",
                                           "screen_px", "view_units", "intersections", "distances")},
            "split_bands": host["split_bands"]}


def operation_rows(counted, hosts, hidden):
    """[{clipper, scene, board, crossing, polygons, instructions, multiplications, divisions, intersections,
    distances}]: all of a scene's frames together. crossing: polygons that the planes of the lens cut, whoever cuts
    them;
    intersections and distances from planes are the whole scene's, the rest is that of the polygons cut."""
    rows = []
    for (core, clipper, scene), taken in counted.items():
        found = hosts[clipper, hidden, scene]["found"]
        rows.append({"clipper": clipper, "scene": scene, "board": core, "crossing": found["crossing"], **taken,
                     "intersections": found["intersections"], "distances": found["distances"]})
    return rows


def complaints(plan, result):
    """Everything that is not as it should be, in sentences."""
    found = []
    for each in result["rows"]:
        name = f"{each['clipper']} x {each['hidden']}, {each['scene']}, {each['board']}"
        if each["pixels_unexplained"]:
            found.append(f"{name}: {each['pixels_unexplained']:,} pixels differ from double without explanation")
        if not each["equal_to_host"]:
            found.append(f"{name}: the frames of the emulated core are not those of the host")
        claim = plan.clippers[each["clipper"]].get("claim")
        if claim and each["max_error_units"] > claim and each["beyond"] > CLAIM_BEYOND * each["faces"]:
            found.append(f"{name}: {each['beyond']:,} of {each['faces']:,} outlines err by more than {claim}/65536 "
                         f"pixel, by {each['max_error_units']:.3g} at most")
        if each["missed"]:
            found.append(f"{name}: {each['missed']:,} faces are drawn or left out unlike exact clipping")
        if each["refused"]:
            found.append(f"{name}: {each['refused']:,} faces were refused")
    return found


def as_lines(result):
    """clippers.json with a line for each row, without the frames' CRCs."""
    def lines(rows):
        kept = ({key: value for key, value in row.items() if key != "crcs"} for row in rows)
        return "[\n" + ",\n".join(json.dumps(row, separators=(",", ":")) for row in kept) + "]"
    return "{" + ",\n".join(f"{json.dumps(key)}: {lines(value) if key == 'rows' else json.dumps(value)}"
                            for key, value in result.items()) + "}\n"
