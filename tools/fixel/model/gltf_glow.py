# SPDX-License-Identifier: MIT
"""Colours of light and of screens, and images of glTF that are sums of light: base colours and emissive ones."""

import numpy as np

from fixel.model.texture_image import Texture

_STEPS = 4096           # of light between none and all
_ROWS = 64              # of an image at a time


def srgb(linear):
    """A part 0..1 of light as 0..255 of a screen."""
    linear = min(max(linear, 0.0), 1.0)
    return round(255 * (12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055))


def _linear(screen):
    """The inverse of srgb."""
    part = screen / 255
    return part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4


_LIGHT = np.array([_linear(screen) for screen in range(256)], dtype=np.float32)
_SCREEN = np.array([srgb(step / (_STEPS - 1)) for step in range(_STEPS)], dtype=np.uint8)


def _light(pixels, factor):
    """The light of rows of pixels, times a factor; pixels None: white."""
    return np.asarray(factor, dtype=np.float32) * (1 if pixels is None else _LIGHT[pixels[..., :3]])


def added(base, factor, other, glow):
    """The image base times factor, and the image other times glow added. Either image may be None, which is white; not both. The alpha is
    that of base. An image that is black adds nothing."""
    if other is not None and base is not None and not other.pixels[..., :3].any():
        other, glow = None, (0.0, 0.0, 0.0)

    def make():
        size = [max(getattr(image, side) for image in (base, other) if image is not None) for side in ("width", "height")]
        one, two = (image and image.scaled(*size) for image in (base, other))
        made = np.full((size[1], size[0], 4), 255, dtype=np.uint8)
        for row in range(0, size[1], _ROWS):
            rows = slice(row, row + _ROWS)
            light = sum(_light(None if image is None else image[rows], part) for image, part in ((one, factor), (two, glow)))
            made[rows, :, :3] = _SCREEN[(np.clip(light, 0, 1) * (_STEPS - 1)).round().astype(int)]
        if one is not None:
            made[..., 3] = one[..., 3]
        return made
    first = base if base is not None else other
    return first.once(("added", tuple(factor), other and id(other), tuple(glow)), make)
