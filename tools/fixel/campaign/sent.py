# SPDX-License-Identifier: MIT
"""Which files of a checkout are sent to a cluster."""

import os

from fixel.base import children
from fixel.base.errors import ToolError, one_line


def inside(root, names):
    """The names, in order, of those that are files. A link out of the checkout is refused: its content would go to the cluster."""
    found, home = sorted(name for name in names if (root / name).is_file()), root.resolve()
    for name in found:
        real = (root / name).resolve()
        if not real.is_relative_to(home):
            raise ToolError(f"{root / name}: leads to {real}, outside the checkout, and the cluster would get that file: remove the link, or let "
                            ".gitignore name it")
    return found


def of_git(root):
    """The paths of the files of a checkout: those of git and new ones."""
    done = children.run(["git", "-C", root, "ls-files", "-z", "--cached", "--others", "--exclude-standard"])
    if done.returncode:
        raise ToolError(f"{root}: git does not list the files of the checkout: {one_line(done.stderr.decode(errors='replace').strip())}")
    return inside(root, set(map(os.fsdecode, filter(None, done.stdout.split(b"\0")))))
