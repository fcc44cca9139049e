# SPDX-License-Identifier: MIT
"""A sample of what would take too long whole: chosen by a hash of the sources, so that the same sources give the same
sample, and other sources another."""

import hashlib
import pathlib
import random

SOURCES = ("lib", "host_tests/unit", "host_tests/breaks")


def _digest(root):
    digest = hashlib.sha256()
    for folder in SOURCES:
        for path in sorted((pathlib.Path(root) / folder).rglob("*")):
            if path.is_file():
                digest.update(path.relative_to(root).as_posix().encode() + b"\0" + path.read_bytes())
    return digest.digest()


def choose(root, name, values, count):
    """So many of the values, or all if there are no more. The name of what they are for gives each sample its own."""
    values = list(values)
    return random.Random(_digest(root) + name.encode()).sample(values, min(count, len(values)))
