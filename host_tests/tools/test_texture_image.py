# SPDX-License-Identifier: MIT
"""Images of textures: which way up, and greys of 16 bits."""

import io
import struct
import zlib

import numpy
import pytest
from PIL import Image

from fixel.model import texture_image

PICTURE = Image.fromarray(numpy.array([[(250, 0, 0), (0, 250, 0), (0, 0, 250)], [(90, 90, 90), (0, 0, 0), (250, 250, 250)]], dtype=numpy.uint8))


def file_of(picture, kind="PNG", **more):
    out = io.BytesIO()
    picture.save(out, kind, **more)
    return out.getvalue()


def with_orientation(number):
    exif = Image.Exif()
    exif[0x0112] = number
    return exif


# How a camera stores an upright picture for each orientation, by the definition in Exif 2.3: where row 0 and column 0 are.
STORED = {1: lambda p: p, 2: lambda p: p[:, ::-1], 3: lambda p: p[::-1, ::-1], 4: lambda p: p[::-1],
          5: lambda p: p.swapaxes(0, 1), 6: lambda p: p.swapaxes(0, 1)[::-1], 7: lambda p: p[::-1, ::-1].swapaxes(0, 1),
          8: lambda p: p.swapaxes(0, 1)[:, ::-1]}


@pytest.mark.parametrize("orientation", STORED)
@pytest.mark.parametrize("kind", ["PNG", "WEBP"])
def test_an_image_is_turned_upright_as_its_exif_says(orientation, kind):
    upright = numpy.asarray(PICTURE)
    stored = Image.fromarray(numpy.ascontiguousarray(STORED[orientation](upright)))
    more = {"lossless": True} if kind == "WEBP" else {}
    found = texture_image.decode(file_of(stored, kind, exif=with_orientation(orientation), **more), "m")
    assert (found.width, found.height) == (3, 2) and (found.pixels[..., :3] == upright).all()


def test_a_jpeg_that_is_decoded_smaller_is_upright_too():
    tall = Image.new("RGB", (600, 5000), (250, 0, 0))
    tall.paste((0, 0, 250), (0, 2500, 600, 5000))
    stored = tall.transpose(Image.Transpose.ROTATE_90)      # of which a camera says 6: turn it clockwise
    found = texture_image.decode(file_of(stored, "JPEG", exif=with_orientation(6)), "m")
    assert found.height <= texture_image.KEPT_MAX and found.height > 8 * found.width
    assert found.pixels[0, 0, 0] > 200 > 90 > found.pixels[-1, 0, 0]


@pytest.mark.parametrize("exif", [b"Exif\0\0", b"Exif\0\0II*\0\xff\xff\xff\xff", b"Exif\0\0" + bytes(40)])
def test_damaged_exif_says_nothing(exif):
    found = texture_image.decode(file_of(PICTURE, exif=exif), "m")
    assert (found.pixels[..., :3] == numpy.asarray(PICTURE)).all()


def test_greys_of_16_bits_are_scaled_and_their_clear_grey_is_clear():
    greys = numpy.array([[0, 257, 32896, 65535]], dtype=numpy.uint16)
    found = texture_image.decode(file_of(Image.fromarray(greys)), "m")
    assert found.pixels.tolist() == [[[grey, grey, grey, 255] for grey in (0, 1, 128, 255)]]
    blob = file_of(Image.fromarray(greys))
    clear = b"tRNS" + struct.pack(">H", 32896)
    chunk = struct.pack(">I", 2) + clear + struct.pack(">I", zlib.crc32(clear))
    at = blob.index(b"IDAT") - 4
    found = texture_image.decode(blob[:at] + chunk + blob[at:], "m")
    assert found.pixels.tolist() == [[[grey, grey, grey, alpha] for grey, alpha in ((0, 255), (1, 255), (128, 0), (255, 255))]]


def test_greys_of_16_bits_are_scaled_in_strips():
    """As they are at once: more rows than a strip has."""
    greys = numpy.random.default_rng(4).integers(0, 65536, (600, 3)).astype(numpy.uint16)
    out = io.BytesIO()
    Image.fromarray(greys).save(out, "PNG")
    found = texture_image.decode(out.getvalue(), "g").pixels
    assert (abs(found[..., 0] - greys / 257) <= 0.5).all() and (found[..., 3] == 255).all()
