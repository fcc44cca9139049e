# SPDX-License-Identifier: MIT
"""What make clippers compares: bench/clippers.toml, its programs and its scenes."""

import dataclasses
import math
import pathlib
import tomllib

from fixel.scene import making
from fixel.bench import bench_plan
from fixel.bench.clippers import CORES, PLAN, refuse_strange
from fixel.board import dump, emulator
from fixel.image import image

UNIT = 65536            # of a pixel, and of a world unit


@dataclasses.dataclass(frozen=True)
class Combination:
    """A clipper and what hides what."""
    clipper: str
    hidden: str

    @property
    def name(self):
        """Of its programs."""
        return f"{self.clipper}-{self.hidden}"


class Plan:
    """The plan, and where its programs are built."""

    def __init__(self, build, only=""):
        self.build = pathlib.Path(build)
        with PLAN.open("rb") as file:
            data = tomllib.load(file)
        self.clippers = {each["name"]: each for each in data["clippers"]}
        self.hidden = {each["name"]: each for each in data["hidden"]}
        self.scenes = {each["name"]: each for each in data["scenes"]}
        self.cores = {core: core for core in CORES}
        self._choose(only.replace(",", " ").split())

    def _choose(self, words):
        """Keeps of each kind the entries that are named; a kind of which none is named stays whole."""
        kinds = ("clippers", "hidden", "scenes", "cores")
        names = {name for kind in kinds for name in getattr(self, kind)}
        refuse_strange(words, names)
        for kind in kinds:
            entries = getattr(self, kind)
            wanted = {name: entry for name, entry in entries.items() if name in words}
            setattr(self, kind, wanted or entries)

    @property
    def counter(self):
        """The counting plugin."""
        return self.build / "host" / "bench_counter.so"

    def program(self, core, name):
        """A combination's program for a core."""
        return self.build / "bench" / core / "clippers" / f"{name}.elf"

    def size_map(self, core, name):
        """The linker's map of a combination's renderer alone."""
        return self.build / "bench" / core / "clippers" / "size" / f"{name}.map"

    def operations_program(self, core, clipper):
        """The program that counts what cutting a polygon takes."""
        return self.build / "bench" / core / "clippers" / "operations" / f"{clipper}.elf"

    def host_program(self, name):
        """A combination's program for the host."""
        return self.build / "host" / "comparison" / name

    def combinations(self):
        """All of them, one clipper after the other."""
        return [Combination(clipper, name) for clipper in self.clippers for name, hidden in self.hidden.items()
                if clipper in hidden.get("only", self.clippers)]

    def explained(self, clipper, scene):
        """The distance from an edge, in pixels, that explains a differing pixel of a SceneImage."""
        stated = self.clippers[clipper]["explained"] / UNIT
        return max(stated, 2 * focal(scene) / scene.near) if self.clippers[clipper].get("in_world") else stated


def focal(scene):
    """Focal length in pixels."""
    return scene.width / 2 / math.tan(math.pi * scene.fov / 2 ** 32)


def spread(count, wanted):
    """So many of 0..count - 1, spread evenly, the first among them."""
    wanted = min(count, wanted)
    return [number * count // wanted for number in range(wanted)]


def is_here(entry):
    """Whether a scene's source is there; only a model of others may be absent."""
    return not entry.get("others") or pathlib.Path(entry["scene"]).exists()


def compile_scene(plan, entry, folder, tree, frames=None):
    """(file, SceneImage) of a scene with so many poses of its walk, spread over it. tree: all that stands
    still is in a tree."""
    name = f"{entry['name']}-tree" if tree else entry["name"]
    whole = pathlib.Path(folder) / f"{name}-whole.fxls"
    making.build(entry["scene"], whole, layers=entry.get("layers", "all") if tree else "none")
    scene = image.load(whole)
    poses = scene.path
    if scene.path_kind != image.POSES:
        walked = pathlib.Path(folder) / f"{name}-whole.fxld"
        emulator.run("host", whole, plan.build / "boards" / "host" / "walk", walked)
        poses = [(*frame.position, *frame.angles) for frame in dump.read_dump(walked).frames]
    wanted = frames or entry["frames"]
    if len(poses) == 1:
        poses = turned(scene, poses[0], wanted)
    chosen = [poses[number] for number in spread(len(poses), wanted)]
    scene = dataclasses.replace(scene, path_kind=image.POSES, path=chosen)
    file = pathlib.Path(folder) / f"{name}.fxls"
    bench_plan.save_scene(scene, file)
    return file, scene


def turned(scene, pose, views):
    """A single view, turned from one edge of the field of view to the other."""
    x, y, z, yaw, pitch, roll = pose
    turns = [round(scene.fov * (place / max(1, views - 1) - 0.5)) for place in range(views)]
    return [(x, y, z, (yaw + turn) % 2 ** 32, pitch, roll) for turn in turns]
