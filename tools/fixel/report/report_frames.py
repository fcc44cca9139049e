# SPDX-License-Identifier: MIT
"""Walks of many scenes, drawn by the host board and judged pixel by pixel against double."""

import dataclasses
import pathlib

from fixel.base import output
from fixel.scene import making
from fixel.board import drawing, dump, firmware, methods
from fixel.image import image
from fixel.base.errors import ToolError
from fixel.base.progress import Progress

SCENES = ("scenes/plaza.toml", "scenes/plaza-turned.toml", "scenes/spin.toml", "scenes/w1.toml", "scenes/w3.toml",
          "scenes/tiny.toml", "scenes/cube.toml")
# Models that others made; a checkout of the project alone does without.
MODELS = ("../shared/models/spot.obj", "../shared/models/teapot.obj")
VIEWS = 60                      # of a scene with a single one
ROLL = round(2 ** 32 / 9)       # of the second walk: edges at other slopes
DISTANCE = 1 / 8192             # pixel; what differs farther from an edge is unexplained
SHOWN = 3                       # frames in the page
FULL_TURN = 2 ** 32


@dataclasses.dataclass
class Walk:
    """A scene and the path that is walked in it."""
    name: str
    scene: image.SceneImage


@dataclasses.dataclass
class Shown:
    """A frame for the page."""
    scene: str
    frame: int
    differing: int
    palette: object
    fixed: object       # palette indices
    double: object


def _at_most(scene, limit):
    """A scene with its path cut to so many frames; None: as it is."""
    if limit is None or scene.frames <= limit:
        return scene
    if scene.path_kind == image.POSES:
        return dataclasses.replace(scene, path=scene.path[:limit])
    path = []
    for keys, frames in scene.path:
        if limit > 0:
            path.append((keys, min(frames, limit)))
        limit -= frames
    return dataclasses.replace(scene, path=path)


def _swept(scene, views):
    """A single view, turned from one edge of the field of view to the other."""
    x, y, z, yaw, pitch, roll = scene.path[0]
    turns = [round(scene.fov * (place / max(1, views - 1) - 0.5)) for place in range(views)]
    path = [(x, y, z, (yaw + turn) % FULL_TURN, pitch, roll) for turn in turns]
    return dataclasses.replace(scene, path=path)


def _rolled(scene):
    """The same walk with the camera held at a slant."""
    def slant(pose):
        return (*pose[:5], (pose[5] + ROLL) % FULL_TURN)
    path = [slant(pose) for pose in scene.path] if scene.path_kind == image.POSES else scene.path
    return dataclasses.replace(scene, path=path, start=slant(scene.start))


def load_scene(source, folder, limits=None):
    """A .toml or .obj compiled, or a scene image read. limits: a bounded.Limits."""
    if pathlib.Path(source).suffix == ".fxls":
        return image.load(source)
    file = folder / "compiled.fxls"
    making.build(str(source), file, limits=limits)
    return image.load(file)


def walks(sources, folder, limit=None, limits=None):
    """Every walk: each scene's own, and again with the camera rolled. limits: a bounded.Limits for compiling."""
    found = []
    for source in sources:
        name, scene = pathlib.Path(source).stem, load_scene(source, folder, limits)
        if scene.frames == 1 and scene.path_kind == image.POSES:
            scene = _swept(scene, VIEWS if limit is None else min(VIEWS, limit))
        scene = _at_most(scene, limit)
        found += [Walk(name, scene), Walk(f"{name}, rolled", _rolled(scene))]
    return found


def default_sources():
    """The project's scenes, and the models of others that are there."""
    return [*SCENES, *(model for model in MODELS if pathlib.Path(model).exists())]


def _judge(programs, walk, folder):
    """The host's dump of a walk, the reference renderer's, and the verdict."""
    file, twin = folder / "walk.fxls", folder / "double.fxld"
    output.write_file(file, image.pack(walk.scene))
    drawn = drawing.draw(programs.kept, "host", firmware.HOST, methods.elf_of(firmware.HOST, programs.build), file, folder)
    verdict = programs.judge(file, drawn, folder / "judge.json", twin, ["--distance", str(DISTANCE)])
    return dump.read_dump(drawn), dump.read_dump(twin), verdict


def _check(walk, verdict, drawn, twin):
    """The judge's counts against our own: two programs read these dumps."""
    for entry, one, other in zip(verdict["frames"], drawn.frames, twin.frames, strict=True):
        ours = int((one.pixels != other.pixels).sum())
        if ours < entry["pixels_differing"] or \
                ours > entry["pixels_differing"] + (entry.get("pixels_tied") or 0):
            raise ToolError(f"{walk.name}, frame {one.number}: the judge counts "
                            f"{entry['pixels_differing']} differing pixels, this tool {ours}", 1)


def _frame(walk, entry):
    return {"scene": walk.name, "frame": entry["frame"],
            "pixels_differing": entry["pixels_differing"],
            "pixels_unexplained": entry["pixels_unexplained"],
            "pixels_tied": entry.get("pixels_tied"),
            "max_edge_distance_px": entry["max_edge_distance_px"]}


def _worst(shown):
    """The frames that differ most, each of another scene."""
    by_scene = {}
    for each in sorted(shown, key=lambda each: -each.differing):
        by_scene.setdefault(each.scene.split(",")[0], each)
    return list(by_scene.values())[:SHOWN]


def judge_walks(programs, found, folder):
    """(frames[] of the report, how many pixels they have, the frames to show)."""
    frames, shown, pixels = [], [], 0
    with Progress("judging frames against double", sum(walk.scene.frames for walk in found)) as progress:
        for walk in found:
            drawn, twin, verdict = _judge(programs, walk, folder)
            _check(walk, verdict, drawn, twin)
            frames += [_frame(walk, entry) for entry in verdict["frames"]]
            pixels += len(drawn.frames) * drawn.width * drawn.height
            worst = max(verdict["frames"], key=lambda entry: entry["pixels_differing"])
            number = worst["frame"]
            shown.append(Shown(walk.name, number, worst["pixels_differing"], drawn.palette,
                               drawn.frames[number].pixels, twin.frames[number].pixels))
            progress(len(frames))
    return frames, pixels, _worst(shown)


def cast_rays(programs, walk, folder, wanted):
    """The ray-cast oracle's verdict on about so many reference frames of a walk."""
    with Progress("casting rays"):
        _judge(programs, walk, folder)
        verdict = programs.raycast(folder / "walk.fxls", folder / "double.fxld", folder / "rays.json",
                                   max(1, walk.scene.frames // wanted))
    return {"scene": walk.name, **{key: verdict[key] for key in
            ("frames_judged", "pixels", "pixels_differing", "pixels_unexplained")}}
