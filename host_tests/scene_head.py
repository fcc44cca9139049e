# SPDX-License-Identifier: MIT
"""The head of scene files that tests write."""


def head(width, height, view=(), textures=()):
    """[screen], [view] and [[textures]]. view: lines. textures: (name, pattern, side in texels, more lines).

    Keys of the top of the file may stand before it."""
    lines = ["[screen]", f"width = {width}", f"height = {height}"]
    if view:
        lines += ["[view]", *view]
    for name, pattern, side, *more in textures:
        lines += ["[[textures]]", f'name = "{name}"', f'pattern = "{pattern}"', f"size = [{side}, {side}]", *more]
    return "\n" + "\n".join(lines) + "\n"
