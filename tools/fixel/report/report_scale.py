# SPDX-License-Identifier: MIT
"""One scene at several sizes: the picture must not change, nor what it costs."""

import dataclasses

from fixel.base import output
from fixel.board import counted, drawing, dump, emulator, firmware, methods
from fixel.image import image
from fixel.base.errors import ToolError
from fixel.base.progress import Progress

SCENE = "scenes/w1.toml"
SCALES = (1, 4, 16, 64)
TIMEOUT = 120.0     # seconds of CPU time without a new frame


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
