#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""First inputs for the fuzz targets: small scene images, and bytes for the pipeline.

    seeds.py OUT SCENE...       writes OUT/scene/* and OUT/pipeline/*
"""

import contextlib
import dataclasses
import pathlib
import random
import re
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))

from fixel.image import image
from fixel.scene import toml_scene, tree
from fixel.base.errors import ToolError, run_main

LARGEST = 8000          # bytes of a scene that is worth mutating
POSES = 3               # that a seed has of its scene's path
PARTS = 28              # what the pipeline's first byte chooses among
LENGTHS = (200, 400, 800, 2000)
BEAMS = re.compile(r"^\[\[?(?:glow|beams)\]\]?\n(?:(?!\[).*\n)*", re.MULTILINE)
ONLY_RGB565 = re.compile(r"pixels = \"rgb565\"(?:, |\n)|^bits = 16\n", re.MULTILINE)


def scene_seeds(file):
    """An image of a scene file, once with a path of poses and once of strides."""
    compiled, _ = toml_scene.compile_file(str(file))
    small = dataclasses.replace(compiled, width=64, height=48, palette=[(0, 0, 0)] * 256)
    start, path = small.start, small.path[:POSES] if small.path_kind == image.POSES else [small.start]
    yield image.pack(dataclasses.replace(small, path_kind=image.POSES, path=[start, start]))
    yield image.pack(dataclasses.replace(small, path_kind=image.STRIDES,
                                         path=[(image.KEYS["forward"], 2), (0xFF, 1)]))
    small.billboards = None     # their models are convex, and in no tree
    kinds = [dataclasses.replace(model, kind=image.SORTED) for model in small.models]
    yield image.pack(dataclasses.replace(small, models=kinds, path_kind=image.POSES, path=[start]))
    planted = dataclasses.replace(small, path_kind=image.POSES, path=path)
    yield image.pack(planted)
    try:
        tree.plant(planted, tree.layers_of("most", planted), compiled.moving)
    except ToolError:
        return  # all that could be in a tree moves
    yield image.pack(planted)


def seeds_of(file):
    """The seeds of a scene file; of the same scene without beams; of the same of a palette, if it is of RGB565 and can be."""
    yield from scene_seeds(file)
    text = pathlib.Path(file).read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "scene.toml"
        for pattern in (BEAMS, ONLY_RGB565):
            other = pattern.sub("", text)
            if other != text:
                copy.write_text(other, encoding="utf-8")
                with contextlib.suppress(ToolError):    # it has what a palette has not, or names a model
                    yield from list(scene_seeds(copy))


def pipeline_seeds(generator):
    """Noise behind each choice of part."""
    for length in LENGTHS:
        for part in range(PARTS):
            yield bytes([part]) + generator.randbytes(length)


def main(argv):
    if len(argv) < 2:
        raise ToolError("usage: seeds.py OUT SCENE...")
    out = pathlib.Path(argv[0])
    images = [blob for file in argv[1:] for blob in seeds_of(file) if len(blob) <= LARGEST]
    for target, blobs in (("scene", images), ("pipeline", pipeline_seeds(random.Random(1)))):
        folder = out / target
        folder.mkdir(parents=True, exist_ok=True)
        for number, blob in enumerate(blobs):
            (folder / f"seed-{number:03}").write_bytes(blob)
    return 0


if __name__ == "__main__":
    run_main(main)
