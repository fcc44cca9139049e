# SPDX-License-Identifier: MIT
"""What the bench measures: bench/bench.toml, and the programs and scenes that it needs."""

import pathlib
import tomllib

from fixel.base import output
from fixel.scene import making
from fixel.bench import bench_changes
from fixel.bench.bench import CORES, EXTRA_CORES, FACES, PLAN, workloads
from fixel.image import image
from fixel.base.errors import ToolError

NAMES = {"m0": "Cortex-M0", "m3": "Cortex-M3", "m4f": "Cortex-M4F", "m55": "Cortex-M55", "rv32": "RISC-V RV32IMC"}
DOUBLE, OURS = "listing-double", "fixel"


class Plan:
    """The plan, and where its programs are built."""

    def __init__(self, build):
        self.build = pathlib.Path(build)
        with PLAN.open("rb") as file:
            data = tomllib.load(file)
        self.workloads = {each["name"]: each for each in data["workloads"]}
        self.renderers = {each["name"]: each for each in data["renderers"]}
        self.kernels = {each["name"]: each for each in data["kernels"]}
        self.variants = {each["name"]: each for each in data["variants"]}
        self.rgb565 = {each["name"]: each for each in data["rgb565"]}
        self.rgb565_variants = data["rgb565_variants"]
        self.peers = data["peers"]
        self.budgets, self.programs = data["budgets"], data["programs"]
        self.faces = data["faces"]
        self.kept, self.has_faces = False, True
        self.store = None       # a base.kept.Kept of what programs counted
        self.growth, self.stages = data["growth"], data["stages"]

    @property
    def counter(self):
        """The counting plugin."""
        return self.build / "host" / "bench_counter.so"

    def program(self, core, name):
        """A program of the bench."""
        return self.build / "bench" / core / f"{name}.elf"

    def workload(self, name):
        """A workload by its name, or a ToolError that says which there are."""
        if name not in self.workloads:
            raise ToolError(f"there is no workload '{name}'; the workloads are: {', '.join(workloads())}")
        return self.workloads[name]

    def keep(self, names):
        """Leaves out all workloads but these, of frames in RGB565 and faces of all sizes too."""
        others = [*self.rgb565, FACES]
        self.workloads = {name: self.workload(name) for name in names if name not in others}
        self.rgb565 = {name: entry for name, entry in self.rgb565.items() if name in names}
        self.kept, self.has_faces = True, FACES in names

    def runs(self, cores):
        """(core, workload, renderer) of everything to be drawn."""
        return [(core, workload, renderer) for core in cores for workload in self.workloads
                for renderer, entry in self.renderers.items()
                if workload in entry.get("only", self.workloads) and (renderer == OURS or core not in EXTRA_CORES) and
                renderer in self.workloads[workload].get("by", self.renderers)]

    def variant_runs(self, cores):
        """(core, workload, variant) of everything to be drawn by the variants."""
        return [(core, workload, name) for name, entry in self.variants.items()
                for core, workload in self.planned(entry, cores)]

    def variants_of_rgb565(self):
        """The workloads of RGB565 that variants draw too."""
        return [name for name in self.rgb565 if any(name in entry.get("rgb565", ()) for entry in self.variants.values())]

    def rgb565_variant_runs(self, cores):
        """{(core, workload, variant): (its program, the library's own)} of workloads of RGB565."""
        return {(core, workload, name): (f"fixel-native-{name}", "fixel-native") for name, entry in self.variants.items()
                for workload in entry.get("rgb565", ()) if workload in self.rgb565 for core in entry["cores"] if core in cores}

    def planned(self, entry, cores):
        """(core, workload) that an entry with both asks for and that are measured."""
        return [(core, workload) for core in entry["cores"] if core in cores
                for workload in entry["workloads"] if workload in self.workloads]


def compile_scene(workload, folder):
    """A workload's scene image in a folder: (file, scene)."""
    file = pathlib.Path(folder) / f"{workload['name']}.fxls"
    if "with" in workload:
        compiled = bench_changes.compile_file(workload, workload["with"], folder)
        save_scene(compiled, file)
        return file, compiled
    making.build(workload["scene"], file)
    compiled = image.load(file)
    if "turned" in workload:
        compiled = bench_changes.turned(compiled, workload["turned"])
        save_scene(compiled, file)
    return file, compiled


def faces_of(scene):
    """How many faces a scene places, seen or not."""
    return sum(len(scene.models[each.model].faces) for each in scene.objects)


def units_of(workload, scene):
    """How many units a frame of a workload has."""
    return scene.width * scene.height if workload["unit"] == "pixel" else faces_of(scene)


def save_scene(scene, file):
    """A scene as an image file."""
    output.write_file(file, image.pack(scene))
    return file
