# SPDX-License-Identifier: MIT
"""Nodes of a model file: the parts that have names, where each is placed, and how it moves."""

from dataclasses import dataclass, field, replace

import numpy as np

RATE = 30                   # frames a second, in which animations are played
FRAMES_MAX = 9000           # of an animation: what comes later is left out


@dataclass(frozen=True)
class Node:
    """pivot: the point about which the node turns, in 1/UNIT, as the file's vertices stand. parent: the name of the node above
    it, or None. mesh: the name of its mesh, None without one. is_animated: whether an animation moves the node itself. poses: None
    for what no animation moves, else a function that answers matrices of 3x4, one a frame, which take the vertices of the file
    to their places in that frame. bears: the names of the nodes whose faces, or some of them, hang on this one, so that its group has
    them too; hangs: whether its faces hang on others so."""
    name: str
    parent: str = None
    pivot: tuple = (0, 0, 0)
    mesh: str = None
    is_animated: bool = False
    poses: object = None
    bears: tuple = ()
    hangs: bool = False

    def moved(self, way, unit):
        """The same of a file whose vertices lie so far on; way in 1/unit."""
        if not any(way):
            return self
        step = np.array([c / unit for c in way])

        def poses():
            found = self.poses().copy()
            found[:, :, 3] += step - found[:, :, :3] @ step
            return found
        return replace(self, pivot=tuple(p + w for p, w in zip(self.pivot, way)), poses=self.poses and poses)


@dataclass(frozen=True)
class _Placed:
    """matrix: of 3x4, from what stands at a node to the vertices as they are read; it looks along its z."""

    def moved(self, way, unit):
        """The same of a file whose vertices lie so far on."""
        step = np.array([c / unit for c in way])
        return replace(self, matrix=np.column_stack([self.matrix[:, :3], self.matrix[:, 3] + step]))


@dataclass(frozen=True)
class Camera(_Placed):
    """name: of its node. angle: of its view, from top to bottom in degrees; None without perspective. near: in the file's units.
    half: of an orthographic one, half of the width that it sees, in the file's units; else None."""
    name: str
    angle: float
    near: float
    matrix: object
    half: float = None


@dataclass(frozen=True)
class Light(_Placed):
    """name: of its node. kind: directional, point or spot. strength: in the file's units. range: in the file's units, or None."""
    name: str
    kind: str
    strength: float
    range: float
    is_coloured: bool
    matrix: object


@dataclass
class Scenery:
    """What a file has beside faces. nodes: {name: Node}, parents first. left_out: {kind: what there is to say where nothing
    is made of it}. animations: their names. play: a function that answers, for the pattern of an animation's name or None for
    the first one, (nodes with poses, how many frames it takes, notes); frames are 0 without an animation."""
    nodes: dict = field(default_factory=dict)
    count: int = 0              # of the nodes of the file's scene
    left_out: dict = field(default_factory=dict)
    animations: list = field(default_factory=list)
    play: object = None
    cameras: list = field(default_factory=list)     # of Camera
    lights: list = field(default_factory=list)      # of Light

    def moved(self, way, unit):
        """The same of a file whose vertices lie so far on."""
        def play(wanted):
            nodes, frames, notes = self.play(wanted)
            return {name: node.moved(way, unit) for name, node in nodes.items()}, frames, notes
        return replace(self, nodes={name: node.moved(way, unit) for name, node in self.nodes.items()}, play=self.play and play,
                       cameras=[camera.moved(way, unit) for camera in self.cameras], lights=[light.moved(way, unit) for light in self.lights])
