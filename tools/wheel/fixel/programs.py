# SPDX-License-Identifier: MIT
"""Where the installed tools have their programs, and where they write what they keep: a folder of the user's cache, with a link
to each program."""

import os
import pathlib

from fixel import TREE, __version__
from fixel.base.errors import ToolError

PROGRAMS = TREE / "programs"


def cache():
    """A folder that may be written."""
    home = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    folder = pathlib.Path(home) / "fixel" / __version__ / "build"
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError:
        pass
    if not os.access(folder, os.W_OK):
        raise ToolError(f"{folder}: cannot be written; set XDG_CACHE_HOME to a folder that can")
    return folder


def build():
    """The folder that stands for the checkout's build folder."""
    folder = cache()
    for program in PROGRAMS.rglob("*"):
        if program.is_file():
            link = folder / program.relative_to(PROGRAMS)
            if not link.is_symlink() or os.readlink(link) != str(program):
                link.parent.mkdir(parents=True, exist_ok=True)
                new = link.with_name(f"{link.name}.{os.getpid()}")
                new.symlink_to(program)
                os.replace(new, link)
    return folder
