# SPDX-License-Identifier: MIT
"""What git says of the checkout."""

from fixel.base import children
from fixel.base.errors import ToolError


def git(root, *words):
    """What a command of git prints, as bytes."""
    done = children.run(["git", *words], cwd=root)
    if done.returncode:
        raise ToolError(f"git {words[0]}: failed in {root}", words=done.stderr.decode("utf-8", "replace").strip())
    return done.stdout


def text(root, *words):
    return git(root, *words).decode("utf-8", "replace").strip()


def require(root):
    """Refuses a folder that is not the top of a checkout of git."""
    done = children.run(["git", "rev-parse", "--show-prefix"], cwd=root)
    if done.returncode or done.stdout.strip():
        raise ToolError(f"{root}: this command needs a checkout of git")


def last_tag(root):
    """The newest tag of a version that HEAD has behind it, or None."""
    done = children.run(["git", "describe", "--tags", "--abbrev=0", "--match", "v[0-9]*"], cwd=root)
    return done.stdout.decode().strip() if done.returncode == 0 else None
