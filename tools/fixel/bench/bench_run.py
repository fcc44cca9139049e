# SPDX-License-Identifier: MIT
"""Runs the programs of the bench: what drawing the workloads and running the kernels took."""

import dataclasses
import pathlib
import re

import numpy

from fixel.base import scratch
from fixel.bench import bench_plan, bench_changes, counter, cycles, places
from fixel.board import dump, emulator, firmware, qemu
from fixel.bench.debug_lines import DebugLines
from fixel.base.errors import ToolError
from fixel.bench.machine_code import MachineCode, read_once

TIMEOUT = 300.0     # seconds of CPU time without a new frame; kernels print nothing on the way
CLEAR_OF_VIEW = 200 * 65536     # 16.16: farther from W1's eye than its far plane
HARDLY_MOVED = 64               # 16.16: a thousandth of a unit


@dataclasses.dataclass
class Drawn:
    """Frames drawn by a renderer: instructions of each, pixels, and what the program said."""
    instructions: list
    pixels: numpy.ndarray
    memory: int
    stack: int


def _said(pattern, output, elf):
    found = re.search(pattern, output, re.MULTILINE)
    if found is None:
        raise ToolError(f"{elf}: did not print '{pattern}'", exit_code=1)
    return int(found[1])


def count(plan, elf, folder, scene=None, frames=None, detail=False):
    """(what a program said, Counts): as it ran in a folder, where its frames are too, or as the plan has kept it."""
    said = pathlib.Path(folder) / "said.txt"

    def run():
        output, _ = counter.run(elf, read_once(MachineCode, elf), plan.counter, folder, scene, frames, detail, TIMEOUT)
        said.write_text(output, encoding="utf-8", newline="")
    files = [said, pathlib.Path(folder) / counter.COUNTS, *([pathlib.Path(folder) / emulator.DUMP_NAME] if scene and not detail else [])]
    store = getattr(plan, "store", None)
    if store is None:
        run()
    else:
        inputs = [elf, plan.counter, pathlib.Path(scene) if scene else "no scene", frames or 0, detail, qemu.version(firmware.load(elf).emulator)]
        store.obtain("counts", inputs, files, run)
    return said.read_text(encoding="utf-8"), counter.read(folder)


def refuse_other_pixels(who, what, ours, theirs):
    """Refuses figures of a program that draws other pixels than the library."""
    differing = int((ours != theirs).sum())
    if differing:
        raise ToolError(f"{who} draws {what} unlike fixel: {differing:,} pixels", exit_code=1)


def draw(plan, core, renderer, scene, frames=None):
    """Draws a scene image."""
    elf = plan.program(core, renderer)
    with scratch.folder("bench") as folder:
        output, counts = count(plan, elf, folder, scene, frames)
        drawn = dump.read_dump(folder / emulator.DUMP_NAME)
    if len(counts.regions) != len(drawn.frames) or not drawn.frames:
        raise ToolError(f"{elf}: {len(counts.regions)} regions, {len(drawn.frames)} frames", exit_code=1)
    return Drawn(counts.regions, numpy.stack([frame.pixels for frame in drawn.frames]),
                 _said(r"^bench: memory (\d+)$", output, elf), _said(r"^bench: stack (\d+)$", output, elf))


def profile(plan, core, renderer, scene, frames=None, is_whole=True):
    """(Profile, frames): a scene drawn with every place counted; is_whole: that of places.Profile."""
    elf = plan.program(core, renderer)
    code = read_once(MachineCode, elf)
    with scratch.folder("profile") as folder:
        _, counts = count(plan, elf, folder, scene, frames, detail=True)
    taken = places.Profile(code, counts, read_once(DebugLines, elf), cycles.models(core), is_whole=is_whole)
    # The call of the end marker is the region's last instruction, and nobody's work.
    expected = sum(counts.regions) + counter.MARKER_CALL * len(counts.regions)
    if taken.total.instructions != expected:
        raise ToolError(f"{elf}: the places add up to {taken.total.instructions:,} instructions, "
                        f"the regions to {expected:,}; the plugin has a bug", exit_code=1)
    return taken, len(counts.regions)


def kernels(plan, core):
    """{name: (instructions, units)} of the kernels and the limits."""
    elf = plan.program(core, "kernels")
    with scratch.folder("bench") as folder:
        output, counts = count(plan, elf, folder)
    said = re.findall(r"^bench: kernel (\S+) (\d+)$", output, re.MULTILINE)
    if len(said) != len(counts.regions):
        raise ToolError(f"{elf}: {len(counts.regions)} regions, {len(said)} kernels", exit_code=1)
    if {name for name, _ in said} != set(plan.kernels):
        strange = {name for name, _ in said} ^ set(plan.kernels)
        raise ToolError(f"bench/bench.toml and bench/firmware/kernel_list.c differ in: "
                        f"{', '.join(sorted(strange))}")
    return {name: (instructions, int(units))
            for (name, units), instructions in zip(said, counts.regions)}


def more_cubes(scene, factor, culled):
    """A scene with so many times its objects: the new ones far behind the far plane, or in the very
    places of the old ones, as good as."""
    def copy(item, number):
        x, y, z = item.centre
        centre = (x + number * CLEAR_OF_VIEW, y, z) if culled else (x, y, z + number * HARDLY_MOVED)
        return dataclasses.replace(item, centre=centre)
    return dataclasses.replace(scene, objects=[copy(item, number) for number in range(factor)
                                               for item in scene.objects])


def resized(scene, width, height):
    """A scene on another screen; the field of view stays."""
    return dataclasses.replace(scene, width=width, height=height)


def growth_scenes(plan, folder):
    """[(axis, factor, scene, file)] of the scenes that show how costs grow."""
    growth = plan.growth
    _, scene = bench_plan.compile_scene({"name": "growth", "scene": growth["scene"]}, folder)
    made = [("cubes culled", factor, more_cubes(scene, factor, True)) for factor in growth["cubes"]]
    made += [("cubes seen", factor, more_cubes(scene, factor, False)) for factor in growth["cubes"]]
    smallest = growth["screens"][0]
    made += [("pixels", width * height // (smallest[0] * smallest[1]), resized(scene, width, height))
             for width, height in growth["screens"]]
    made += [(axis, faces // growth["faces"][0], bench_changes.terrain(scene, faces, patch))
             for axis, patch in (("faces, one model", None), ("faces, patches", growth["patch_cells"]))
             for faces in growth["faces"]]
    return [(axis, factor, each, bench_plan.save_scene(
                each, pathlib.Path(folder) / f"{re.sub('[ ,]+', '-', axis)}-{factor}.fxls"))
            for axis, factor, each in made]


def grow(plan, entry):
    """A row of the growth table."""
    axis, factor, scene, file = entry
    drawn = draw(plan, plan.growth["core"], "fixel", file)
    counts = drawn.instructions
    return {"axis": axis, "factor": factor, "core": plan.growth["core"], "objects": len(scene.objects),
            "faces": bench_plan.faces_of(scene), "pixels": scene.width * scene.height, "frames": len(counts),
            "instructions": round(sum(counts) / len(counts))}
