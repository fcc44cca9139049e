# SPDX-License-Identifier: MIT
"""The program of the process in which scenes and images are read and compiled: fixel/scene/making.py starts it."""

import os
import signal
import sys

if __name__ == "__main__":
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)    # Ctrl-C comes to this process too, which then says nothing
    sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
    from fixel.base import interpreter
    sys.excepthook = interpreter.explain    # of a missing package

from fixel.image import c_names, c_scene, c_setup, image, image_tables
from fixel.model import suffixes
from fixel.scene import c_texture
from fixel.base import job
from fixel.base.errors import ToolError
from fixel.base.notes import told
from fixel.scene import compiler, look, target


def _compiled(request, wanted, report):
    """(SceneImage, notes) with one look.Look of a model."""
    return compiler.compile_scene(request["scene"], request["frames"], request["screen"] and tuple(request["screen"]),
                                  request["layers"], request["framed"], report, target.Target(**request["target"]), wanted,
                                  request["write"])


def _build(request, report):
    """The scene image of a scene or a model, and what its caller tells of it: of several looks the first that an image
    holds."""
    wanted, more = [look.Look(**each) for each in request["looks"]], []
    while True:
        compiled, notes = _compiled(request, wanted[0], report)
        report.stage("packing and checking the image")
        try:
            return compiler.packed(compiled, request["scene"]), compiled, notes + more
        except image.TooLarge:
            wanted = look.after(wanted, compiled)
            if not wanted:
                raise
            more = [look.smaller_text(request["scene"], wanted[0])]


def build(request, report):
    """A scene or a model as a scene image."""
    blob, compiled, notes = _build(request, report)
    return _given(request, report, blob, compiled, notes)


def export(request, report):
    """A scene, a model or a scene image as a C header."""
    scene = request["scene"]
    c_names.check_name(request["name"])
    if suffixes.suffix_of(scene) == ".fxls":
        if request["frames"] or request["screen"] or request["layers"]:
            raise ToolError(f"{scene}: --frames, --screen and --tree are for a .toml or a model; a scene image "
                            "has its path, its screen and its tree already")
        report.stage("reading the scene image")
        compiled, notes = image.load(scene), []
        target.apply(compiled, compiled.tree is not None, target.Target(**request["target"]), scene)
        image_tables.check_apart(compiled, scene)
    else:
        _, compiled, notes = _build(request, report)
    report.stage("writing the header")
    frames = request["frames"] is not None or (bool(request["program"]) and compiled.path_kind == image.POSES)
    text = c_scene.header(compiled, request["name"], os.path.basename(scene), frames)
    program = c_setup.program(compiled, request["name"], request["program"], c_scene.printable(os.path.basename(scene)),
                              frames, request["rows"]) if request["program"] else None
    return {**_given(request, report, text.encode(), compiled, notes), "program": program}


def texture(request, report):
    """An image as a texture in C."""
    report.stage("reading the image")
    text, texels, notes = c_texture.header(request["image"], request["name"], request["size"] and tuple(request["size"]),
                                           request["levels"], request["clamp"])
    report.give(text.encode())
    return {"texels": texels, "notes": notes}


def _given(request, report, data, compiled, notes):
    report.give(data)
    return {"size": len(data), "objects": len(compiled.objects), "frames": compiled.frames, "notes": told(notes, request["verbose"]),
            "text": compiled.text if request["write"] else None}


if __name__ == "__main__":
    job.serve(lambda request, report: {"build": build, "export": export, "texture": texture}[request["job"]](request, report))
