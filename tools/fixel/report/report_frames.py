# SPDX-License-Identifier: MIT
"""Walks of many scenes, drawn by the host board and judged pixel by pixel against double; and one scene at several
sizes: the picture must not change, nor what it costs."""

import dataclasses
import pathlib

from fixel.base import output
from fixel.base.errors import ToolError
from fixel.base.progress import Progress
from fixel.board import counted, drawing, dump, emulator, firmware, methods
from fixel.image import image
from fixel.scene import making

SCENES = ("scenes/plaza.toml", "scenes/plaza-turned.toml", "scenes/spin.toml", "scenes/w1.toml", "scenes/w3.toml",
          "scenes/tiny.toml", "scenes/cube.toml")
# Models that others made; a checkout of the project alone does without.
MODELS = ("../shared/models/spot.obj", "../shared/models/teapot.obj")
VIEWS = 60                      # of a scene with a single one
ROLL = round(2 ** 32 / 9)       # of the second walk: edges at other slopes
DISTANCE = 1 / 8192             # pixel; what differs farther from an edge is unexplained
SHOWN = 3                       # frames in the page
FULL_TURN = 2 ** 32
SCENE = "scenes/w1.toml"
SCALES = (1, 4, 16, 64)
TIMEOUT = 120.0     # seconds of CPU time without a new frame


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


def scaled(scene, factor):
    """World, camera, near, far and inset times factor."""
    def times(numbers):
        return tuple(factor * number for number in numbers)
    models = [dataclasses.replace(model, vertices=[times(vertex) for vertex in model.vertices])
              for model in scene.models]
    objects = [dataclasses.replace(each, centre=times(each.centre)) for each in scene.objects]
    path = scene.path
    if scene.path_kind == image.POSES:
        path = [(*times(pose[:3]), *pose[3:]) for pose in path]
    return dataclasses.replace(
        scene, near=factor * scene.near, far=factor * scene.far, inset=factor * scene.inset,
        models=models, objects=objects, path=path,
        start=(*times(scene.start[:3]), *scene.start[3:]),
        gait=(*times(scene.gait[:3]), scene.gait[3]))


def _draw(programs, board, scene, factor, folder, progress):
    """What the board draws of a scene at a scale."""
    file = folder / "scaled.fxls"
    output.write_file(file, image.pack(scaled(scene, factor)))
    return dump.read_dump(drawing.draw(programs.kept, "board", board, methods.elf_of(board, programs.build), file, folder,
                                       timeout=TIMEOUT, progress=progress))


def measure(programs, board, scene, folder):
    """[{scale, frames, pixels, pixels_differing, instructions_per_frame, instructions_percent}], against
    the first scale; the percentage is how far a frame's mean lies from the first scale's."""
    rows, first = [], None
    if board == firmware.HOST:
        raise ToolError("the host counts no instructions, and the claim scale needs them; "
                        "choose an emulated board (BOARD=mps2-an385)")
    emulator.find_qemu()
    with Progress(f"W1 at {len(SCALES)} scales on {board}", len(SCALES) * scene.frames) as progress:
        for place, factor in enumerate(SCALES):
            drawn = _draw(programs, board, scene, factor, folder,
                          lambda done, _, before=place * scene.frames: progress(before + done))
            counts = counted.counts_of(drawn.frames)
            if not all(counts):
                raise ToolError(f"board {board} did not count the instructions of every frame, and the claim "
                                "scale needs them", 1)
            first = first or (drawn, counts)
            differing = sum(int((one.pixels != other.pixels).sum())
                            for one, other in zip(drawn.frames, first[0].frames, strict=True))
            rows.append({"scale": factor, "frames": len(drawn.frames),
                         "pixels": len(drawn.frames) * drawn.width * drawn.height,
                         "pixels_differing": differing,
                         "instructions_per_frame": round(sum(counts) / len(counts)),
                         "instructions_percent": 100 * abs(sum(counts) / sum(first[1]) - 1)})
    return rows
