# SPDX-License-Identifier: MIT
"""What a face costs, by its size and by what it shows: [faces] of bench/bench.toml, to pixels of RGB565 with a depth buffer."""

import math

from fixel.base import parallel, scratch
from fixel.bench import bench_changes, bench_plan, bench_run

PROGRAM, WITHOUT = "fixel-native", "fixel-native-without-tiny"
COUNT = bench_changes.TRIANGLES
# Of a triangle with equal sides, by the radius of its corners: pixels, and rows, as the mean of all ways to turn it.
AREA, HEIGHT = 3 * math.sqrt(3) / 4, 3 * math.sqrt(3) / math.pi


def pixels_of(radius):
    """How many pixels a face has."""
    return AREA * radius * radius


def floor_of(kind, radius):
    """What a face of a kind takes at least on an M3, by the counts of the plan: its rows are those after the first."""
    floor = kind["floor"]
    return floor["face"] + floor["row"] * max(0, HEIGHT * radius - 1) + floor["pixel"] * pixels_of(radius)


def scene_of(faces, kind, radius, folder):
    """The scene of faces of a kind. Light changes every face of one colour, so only kinds that are lit have it."""
    tables = {**faces["scene"], "light": faces["light"]} if kind.get("lit") else faces["scene"]
    return bench_changes.triangles(tables, kind["object"], radius, folder)


def _draw(plan, kind, radius, cores):
    """The rows of a size of a kind."""
    rows = []
    with scratch.folder("faces") as folder:
        file = bench_plan.save_scene(scene_of(plan.faces, kind, radius, folder), folder / "faces.fxls")
        for core in cores:
            drawn, row = bench_run.draw(plan, core, PROGRAM, file), {"kind": kind["name"], "radius": radius, "core": core}
            other = bench_run.draw(plan, core, WITHOUT, file) if kind.get("tiny") else drawn
            bench_run.refuse_other_pixels(f"{WITHOUT} on {core}", f"faces of {radius} pixels", drawn.pixels, other.pixels)
            rows.append({**row, "frame": drawn.instructions[0], "without": other.instructions[0] if kind.get("tiny") else None})
    return rows


def measure(plan, cores):
    """[{kind, radius, core, frame, without}]; without: the same frame without the way of tiny faces, of kinds that have one. Nothing
    where workloads were named, and not these."""
    chosen = [core for core in plan.faces["cores"] if core in cores]
    if not (plan.has_faces and chosen):
        return []
    drawn = parallel.run("drawing faces of all sizes", {(kind["name"], radius): (_draw, plan, kind, radius, chosen)
                                                        for kind in plan.faces["kinds"] for radius in plan.faces["radii"]})
    return [row for rows in drawn.values() for row in rows]


def of(result, kind, radius, core):
    """A row; None where it was not measured."""
    return next((row for row in result["faces"] if (row["kind"], row["radius"], row["core"]) == (kind, radius, core)), None)
