# SPDX-License-Identifier: MIT
"""Scene files into scene images or C headers, and images into textures: read and compiled in a process of their own, under
limits (fixel/base/bounded.py), which sends the result. This process puts it in place. And the scene image that a command draws."""

import os
import pathlib
import re
import sys
from dataclasses import dataclass

from fixel.base import bounded, output, reading
from fixel.base.errors import ToolError, one_line
from fixel.base.reading import quoted
from fixel.base.table import count_of
from fixel.commands import late
from fixel.image import c_names, image_header
from fixel.image.fields import IMAGE_MAX
from fixel.scene.look import PLAIN

image_file, target = late("fixel.image", "image"), late("fixel.scene", "target")

ROWS = 16       # of a band of a program that is written, where no board has room for fewer
WORKER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "worker.py")


@dataclass(frozen=True)
class Made:
    """What was made of a scene: bytes of the result, and what there is to say about it."""
    size: int
    objects: int
    frames: int
    notes: list
    text: str       # the scene file of a model, where one is asked for
    program: str = None     # the program that draws an exported scene, where one is asked for


def _make(out, request, subject, limits, writes=False, program=None):
    """Has a job done and puts its result in place, with the scene file of a model if writes, or with a program, whose file this
    is; answers what the job answers."""
    answer, made = bounded.run(WORKER, request, subject, limits)
    if program:
        output.write_both(out, made, program, answer["program"], "--program")
    elif writes and request["write"]:
        output.write_both(out, made, request["write"], answer["text"], "--write")
    else:
        output.write_file(out, made)
    return answer


def build(scene, out, frames=None, screen=None, layers=None, limits=None, asked=None, looks=(PLAIN,), write=None, verbose=False, writes=False):
    """Compiles a scene file or a model into an image file; answers a Made. screen: width and height instead of the
    scene's. layers: those that are to have a tree, or "none"; without it, what the scene says. limits: a bounded.Limits. asked: what it is drawn as instead,
    a target.Target. looks: how a
    model looks, look.Looks: the first that an image holds. write: where its scene file is to stand. verbose: whether notes are told
    that are the same for every file. writes: whether the scene file is put there too, or left to the caller as the Made's text."""
    request = {"job": "build", "scene": os.fspath(scene), "frames": frames, "screen": screen, "layers": layers, "framed": "walk",
               "target": vars(asked) if asked else {}, "looks": [vars(look) for look in looks], "write": write, "verbose": verbose}
    return Made(**_make(out, request, scene, limits, writes))


def export(scene, out, name=None, frames=None, screen=None, layers=None, limits=None, asked=None, looks=(PLAIN,), write=None, verbose=False,
           writes=False, program=None, rows=ROWS):
    """Writes a scene, a model or a scene image as a C header; answers a Made. frames: with so many poses of the path. program: where
    a program that draws it is to stand, in bands of so many rows; then the header has the path."""
    own = c_names.name_of_file(scene)
    beside = os.path.relpath(out, os.path.dirname(program) or ".") if program else None
    request = {"job": "export", "scene": os.fspath(scene), "name": own if name is None else name, "frames": frames,
               "screen": screen, "layers": layers, "framed": "walk" if program else "program",
               "target": vars(asked) if asked else {}, "looks": [vars(look) for look in looks], "write": write, "verbose": verbose,
               "program": beside, "rows": rows}
    return Made(**_make(out, request, scene, limits, writes, program))


def texture(image, out, name, size=None, levels=1, clamp=False, limits=None):
    """Writes an image as a texture in C; answers (the number of its texels, notes)."""
    request = {"job": "texture", "image": os.fspath(image), "name": name, "size": size, "levels": levels, "clamp": clamp}
    answer = _make(out, request, image, limits)
    return answer["texels"], answer["notes"]


def parse_screen(text):
    """Width and height from "128x64"."""
    match = re.fullmatch(r"([0-9]{1,4})x([0-9]{1,4})", text)
    screen = tuple(map(int, match.groups())) if match else ()
    if not screen or not all(1 <= side <= image_header.SCREEN_MAX for side in screen):
        raise ToolError(f"SCREEN is {quoted(text)}; it must be like 128x64, both from 1 to {image_header.SCREEN_MAX}")
    return screen


def tell_notes(notes):
    """What there is to say, for people."""
    for note in notes:
        print(f"note: {one_line(note)}", file=sys.stderr)


def tell(out, made, path=None):
    """What was written, for people. path: what there is to say of it where not all its frames are in it."""
    path = path or count_of(made.frames, "frame")
    tell_notes(made.notes)
    print(f"{one_line(out)}: {made.size:,} bytes, {count_of(made.objects, 'object')}, {path}", file=sys.stderr)


def check_frames(scene, wanted, there):
    """Refuses more frames than a path has."""
    if wanted > there:
        raise ToolError(f"{scene}: path: {wanted} frames are asked for, and the path has {there}")


def retargeted(scene, folder, asked):
    """A copy of a scene image, in folder, that is drawn as something else."""
    image = pathlib.Path(folder) / "scene.fxls"
    output.write_file(image, target.rewritten(reading.read_whole(scene, IMAGE_MAX, "give a scene image"), asked, scene))
    return image


def make_scene_image(scene, folder, frames, screen=None, limits=None, asked=None, verbose=False):
    """The scene image of a .toml or a model, compiled into folder; an .fxls is one already, and is copied into folder where
    it is to be drawn as something else. asked: a target.Target. verbose: as that of build."""
    if pathlib.Path(scene).suffix == ".fxls":
        if screen:
            raise ToolError(f"{scene} is a scene image, which has its screen already: give the .toml or the model")
        if frames:
            check_frames(scene, frames, image_file.load(scene).frames)
        return retargeted(scene, folder, asked) if asked else pathlib.Path(scene)
    image = folder / "scene.fxls"
    for note in build(scene, image, frames, screen, limits=limits, asked=asked, verbose=verbose).notes:
        print(f"  {one_line(note)}", file=sys.stderr)
    return image
