# SPDX-License-Identifier: MIT
"""The header of a scene image (docs/formats.md, section 1.1), checked, and its lens: the ranges that the loader asks for (SPEC.md, section 3.1)."""

import math
import zlib
from types import SimpleNamespace

from fixel.image.fields import ENTRY, HEAD, HEADER, IMAGE_MAX, MAGIC, VERSION, entry
from fixel.image.image_tree import fail

POSES, STRIDES = 0, 1            # kinds of path
DEPTHS = (0, 16, 32)            # bits of the depth buffer that an image asks for, by the low bits of its target
# place pixel-format: the bits of target
RGB565, BY_DISTANCE = 4, 8      # bits of the target


def pack(values):
    """The bytes of a header: {member: a number, or the numbers of a field of several}."""
    numbers = []
    for field in HEADER:
        value = values[field.member]
        numbers += value if isinstance(value, (list, tuple)) else [value]
    return HEAD.pack(*numbers)


def _fields(blob):
    numbers, found = iter(HEAD.unpack_from(blob)), {}
    for field in HEADER:
        count = int(field.format[:-1] or 1) if field.format[-1] != "s" else 1
        values = tuple(next(numbers) for _ in range(count))
        found[field.member.replace(".", "_")] = values if count > 1 else values[0]
    return SimpleNamespace(**found)


def read(blob):
    """The header's fields by their members, checked."""
    if len(blob) < HEAD.size:
        fail("size", f"{len(blob)} bytes are fewer than a header's {HEAD.size}")
    head = _fields(blob)
    if head.magic != MAGIC:
        fail("magic", "this is not a scene image (it does not begin with FXLS)")
    if head.version != VERSION:
        fail("version", f"a scene image of version {head.version}; this tool knows version {VERSION}: build it again")
    size = head.image_size
    if size % 4 or not HEAD.size + head.section_count * ENTRY.size <= size <= IMAGE_MAX or size > len(blob):
        fail("size", f"the image says that it has {size} bytes; there are {len(blob)}")
    if zlib.crc32(blob[16:size]) != head.crc:
        fail("crc", "the checksum does not match: the image is damaged")
    if head.target >= 2 * BY_DISTANCE or head.target % RGB565 >= len(DEPTHS):
        fail("reserved", "the header asks for a target that is not known")
    return head


def target(scene):
    """What a scene asks for, as one byte."""
    return DEPTHS.index(scene.depth_bits) + (RGB565 if scene.pixel_bits == 16 else 0) + (BY_DISTANCE if scene.by_distance else 0)


def _offset(member):
    before = [field.member for field in HEADER].index(member)
    return sum(field.size for field in HEADER[:before])


def retargeted(blob, scene):
    """The bytes of an image, longer or not, that asks for what a SceneImage asks for."""
    made, crc = bytearray(blob), _offset("crc")
    made[_offset("target")] = target(scene)
    made[crc:crc + 4] = zlib.crc32(made[16:scene.size]).to_bytes(4, "little")
    return bytes(made)


SCREEN_MAX = 1024
FOV_MIN, FOV_MAX = 119304647, 1789569707
NEAR_MIN, FAR_MAX, INSET_MAX = 256, 32767 << 16, 1 << 16
CENTRE = entry("centre of the lens")
SCALE = entry("scale of the lens")
SCALE_MIN, SCALE_MAX = 1 << 12, 1 << 28


def focal_pixels(width, fov):
    """The focal length that the library will use, in pixels."""
    return width / 2 / math.tan(fov * math.pi / 2 ** 32)


def hidden_border(scene):
    """The widest border in pixels that the inset hides, at the near plane (docs/accuracy.md, 4.1)."""
    focal, half = focal_pixels(scene.width, scene.fov), max(scene.width, scene.height) / 2
    return focal * scene.inset * math.hypot(1, half / focal) / (scene.near + scene.inset)


def note_of_inset(scene):
    """A sentence about an inset that hides centres of pixels; None where it hides none."""
    border = hidden_border(scene)
    if border <= 0.5:
        return None
    return (f"view.inset = {scene.inset / 65536:g} hides a border of up to {border:.2f} pixel of {scene.width}x{scene.height} (near = "
            f"{scene.near / 65536:g}): pixels there count as unexplained, since double has no inset; a smaller one ends that, 0 is enough")


def middle(width, height):
    """The middle of the screen in the image's integers: the centre of every other lens."""
    return width << 15, height << 15


def check_scale(scale, inset):
    """The range of the scale of an orthographic lens, in the image's integers, and what it goes with."""
    if not SCALE_MIN <= scale <= SCALE_MAX:
        fail("range", f"scale = {scale / 65536:.6g}: an orthographic lens has 1/16..4096 pixels a unit")
    if inset:
        fail("range", f"inset = {inset / 65536:.6g}: an orthographic lens has no inset")


def check_centre(width, height, fov, inset, centre):
    """The range of the centre (x, y), in the image's integers."""
    if inset:
        fail("range", f"inset = {inset / 65536:.6g}: a lens that is off-centre has no inset")
    focal = round(focal_pixels(width, fov) * 65536)
    for value, at, extent, name in zip(centre, middle(width, height), (width, height), "xy"):
        most = min(3 * extent << 15, 4 * focal)
        if abs(value - at) > most:
            fail("range", f"the centre's {name} = {value / 65536:.6g} is farther from the middle of the screen, "
                 f"{at / 65536:g}, than {most / 65536:.6g} pixels: one and a half screens, or four focal lengths")


def check_lens(width, height, fov, near, far, inset):
    """The lens's ranges, in the image's integers."""
    if not (1 <= width <= SCREEN_MAX and 1 <= height <= SCREEN_MAX):
        fail("range", f"a screen of {width}x{height} is outside 1..{SCREEN_MAX}")
    if not FOV_MIN <= fov <= FOV_MAX:
        fail("range", f"a field of view of {fov * 360 / 2**32:.4g} degrees is outside 10..150")
    if near < NEAR_MIN:
        fail("range", f"near = {near / 65536:.6g} is below 1/256")
    if far > FAR_MAX:
        fail("range", f"far = {far / 65536:.6g} is above 32767")
    if not 0 <= inset <= INSET_MAX:
        fail("range", f"inset = {inset / 65536:.6g} is outside 0..1")
    if near + 2 * inset >= far:
        fail("range", f"near + 2 inset = {(near + 2 * inset) / 65536:.6g} is not below "
             f"far = {far / 65536:.6g}")
