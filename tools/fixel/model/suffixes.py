# SPDX-License-Identifier: MIT
"""The endings of model files' names. It needs no package."""

import os

from fixel.base import foreign
from fixel.base.errors import ToolError

READ = (".obj", ".gltf", ".glb", ".stl", ".ply")
SUFFIXES = "an .obj, .gltf, .glb, .stl or .ply file"


def suffix_of(path):
    """The ending that says what a file holds."""
    return os.path.splitext(os.fspath(path))[1].lower()


def is_model(path):
    """Whether a file is a model, by its name."""
    return suffix_of(path) in READ


def holds_triangles(path):
    """Whether the format has triangles alone, so that flat faces come in pieces."""
    return suffix_of(path) in (".gltf", ".glb", ".stl", ".ply")


def check_scene(path):
    """Refuses what is neither a scene file nor a model by its name."""
    if not is_model(path) and suffix_of(path) != ".toml":
        refuse_other(path, path)
        raise ToolError(f"{path}: a scene is a .toml file, or a model: {SUFFIXES}")


def refuse_other(path, where):
    """Refuses a file by its name that is of a known format which is not read, with the way to one that is. where: what names the file."""
    found = foreign.by_ending(path)
    if found:
        raise ToolError(f"{where}: {found.kind} is not read as a scene or a model: {found.way_to_model()}")
