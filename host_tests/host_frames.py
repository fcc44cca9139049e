# SPDX-License-Identifier: MIT
"""Frames that the host draws of a scene image, and what the judge says of them, for tests."""

import json
import subprocess

from conftest import run_cli

from fixel.board import dump


def compiled(scene, image, *options):
    """The image of a scene, as `fixel build` makes it."""
    made = run_cli("build", scene, "-o", image, *options)
    assert made.returncode == 0, made.stderr
    return image


def run(*words):
    """What a program of the host prints; it must not refuse."""
    done = subprocess.run(list(map(str, words)), text=True, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def drawn(build, image, name, *options):
    """The dump of an image's frames, beside the image."""
    out = image.with_name(f"{name}.fxld")
    run(build / "host" / "frames", image, out, *options)
    return out


def judged(build, image, dumped, *options):
    """What the judge says of a dump, by options as those of the frames."""
    out = dumped.with_suffix(".json")
    run(build / "host" / "judge", image, dumped, "--json", out, *options)
    return json.loads(out.read_text(encoding="utf-8"))


def pixels(dumped):
    """The pixels of each frame of a dump."""
    return [bytes(frame.pixels) for frame in dump.read_dump(dumped).frames]
