# SPDX-License-Identifier: MIT
"""The version of the project, as lib/include/fixel/version.h states it."""

import pathlib
import re

HEADER = pathlib.Path(__file__).resolve().parents[3] / "lib" / "include" / "fixel" / "version.h"
PARTS = ("MAJOR", "MINOR", "PATCH")


def version(header=HEADER):
    """Three numbers, as in 0.9.0."""
    stated = dict(re.findall(r"^#define FXL_VERSION_(\w+) (\d+)$", header.read_text(encoding="utf-8"), re.MULTILINE))
    return ".".join(stated[part] for part in PARTS)
