# SPDX-License-Identifier: MIT
"""Compiles a scene file or a model in this process. Tools do it in a process under limits: fixel/scene/making.py."""

import dataclasses

from fixel.image import image
from fixel.model import model_file, suffixes
from fixel.scene import framing, keys, look as looks, target, toml_scene, tree
from fixel.base.job import Quiet
from fixel.base.errors import ToolError

FRAMINGS = {"walk": framing.WALK, "program": framing.PROGRAM}


def compile_scene(scene, frames=None, screen=None, layers=None, framed="walk", report=None, asked=None, look=looks.PLAIN,
                  write=None):
    """Compiles a .toml or a model; answers the SceneImage and what there is to say about it. screen: width
    and height instead of the scene's. layers: those that are to have a tree (tree.layers_of), instead of what the scene
    says. framed: how a model is framed (FRAMINGS). report: a job.Report. asked: what it is drawn as, a target.Target. look:
    a look.Look of a model; write: where its scene file is to stand."""
    report = report or Quiet()
    is_model = suffixes.is_model(scene)
    if not is_model and suffixes.suffix_of(scene) != ".toml":
        model_file.refuse_by_all(scene, scene)
    suffixes.check_scene(scene)
    if frames is not None and not 1 <= frames <= keys.FRAMES_MAX:
        raise ToolError(f"--frames {frames} is outside 1..{keys.FRAMES_MAX}")
    report.stage("reading the file")
    if is_model:
        look = _still(look, scene) if layers and layers != "none" else look
        compiled, notes = framing.compile_model(scene, frames, report, screen, FRAMINGS[framed], look, write)
    else:
        compiled, notes = toml_scene.compile_file(scene, frames, report, screen, asked)
    where, layers = (f"{scene}: --tree", layers) if layers else (f"{scene}: tree", compiled.layers)
    if asked:
        target.apply(compiled, layers != "none", asked, scene)
    target.check(compiled, asked, scene)
    if layers != "none":
        report.stage("building the tree")
        notes = notes + [plant(compiled, layers, scene, where, report)]
    return compiled, notes


def _still(look, scene):
    """The Look of a model that has a tree: in one part, of which nothing moves."""
    option = next((name for name in ("keep", "animation") if getattr(look, name)), None)
    if option:
        raise ToolError(f"{scene}: --tree and --{option} exclude each other: a tree holds what stands still, "
                        "in one object")
    return dataclasses.replace(look, whole=True)


def packed(compiled, name):
    """The bytes of a scene's image, in which everything is checked."""
    try:
        return image.pack(compiled)
    except ToolError as error:
        raise type(error)(f"{name}: {error}") from error


def plant(compiled, layers, name, where, report):
    """Gives a scene a tree; answers what there is to say about it. where: what asks for the tree, for messages."""
    if compiled.depth_bits and not compiled.by_distance:
        raise ToolError(f'{where}: [view] asks for a depth buffer; remove it, leave the tree out, or give view.order = "distance"')
    try:
        counts = tree.plant(compiled, tree.layers_of(layers, compiled), compiled.moving, report)
    except ToolError as error:
        raise ToolError(f"{where}: {error}") from error
    return f"{name}: tree: {counts.text()}"
