# SPDX-License-Identifier: MIT
"""How many pixels of a model's frames show a wrong face because they are drawn in an order, without a depth buffer: rays
through the pixels of the host's frames tell."""

import pathlib

from fixel.base import kept, scratch
from fixel.board import drawing, firmware
from fixel.board.programs import HostPrograms
from fixel.image import image as images

FRAMES = 6      # that are drawn, of the whole path: double draws them too, which takes the longest


def is_certain(scene):
    """Whether the order of a scene's frames cannot be wrong: a depth buffer or a tree decides, or one convex model is all."""
    alone = len(scene.objects) == 1 and scene.models[0].kind == images.CONVEX
    return bool(scene.depth_bits) or (scene.tree is not None and not scene.by_distance) or alone


# place pixel-format: the names of what a scene is drawn by
def names_of(scene, has_surfaces):
    """Which faces rays are to tell by their names instead of their colours: beams and surfaces change colours as no ray
    knows, lines hide faces from all but a look at names, and in RGB565 two entries of the palette may be one colour. None where they tell colours."""
    if scene.surfaces and has_surfaces:
        return "opaque"
    lines = any(model.lines for model in scene.models)
    return "all" if scene.surfaces or scene.beams or lines or scene.pixel_bits == 16 else None


def _sampled(scene, file, folder):
    """The image to draw: that of the file, with at most so many of its poses."""
    if len(scene.path) <= FRAMES:
        return file
    scene.path = scene.path[::-(-len(scene.path) // FRAMES)]
    made = folder / "sampled.fxls"
    made.write_bytes(images.pack(scene))
    return made


def count(build, file):
    """(pixels that show a wrong face, pixels that rays judged, frames) of a scene image; None where the programs that tell are
    not built. The path is one of poses."""
    build = pathlib.Path(build)
    walk = build / "boards" / firmware.HOST / "walk"
    if not all(path.exists() for path in (walk, build / "host" / "judge", build / "host" / "raycast")):
        return None
    scene, store = images.load(file), kept.Kept(build)
    with scratch.folder("order", build) as folder:
        drawn = _sampled(scene, file, folder)
        frames = drawing.draw(store, "host", firmware.HOST, walk, drawn, folder)
        names = names_of(scene, True)
        programs, told = HostPrograms(build, store), folder / "names.fxld"
        programs.judge(drawn, frames, folder / "judge.json", folder / "double.fxld", (), told if names else None)
        verdict = programs.raycast(drawn, told if names else folder / "double.fxld", folder / "rays.json", 1, names)
    return verdict["pixels_unexplained"], verdict["pixels"], len(scene.path)


def text(build, file):
    """What there is to say of the order of a scene image's frames, or ""."""
    scene = images.load(file)
    found = None if is_certain(scene) else count(build, file)
    if found is None:
        return ""
    wrong, judged, frames = found
    all_frames = len(scene.path)
    seen = f"{frames} frames" if frames == all_frames else f"{frames} of the path's {all_frames} frames"
    return f"the order by distance shows a wrong face at {wrong:,} of {judged:,} pixels ({100 * wrong / judged:.2g} %) of {seen}" if wrong \
        else f"the order by distance is right at every pixel of {seen}"
