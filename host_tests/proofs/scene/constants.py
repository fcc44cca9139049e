# SPDX-License-Identifier: MIT
"""The constants of lib/scene, computed from their formulas. The row above each function says where they stand."""

from fixel.prove.exact import ceil, floor, pi, tangent

POLYNOMIAL = 0xEDB88320     # of CRC-32 (IEEE 802.3), its bits reversed


# [[row]]
# id = "least and largest focal length"
# function = "lib/scene/lens.c:focal_in_range"
# property = "of the widest and the narrowest view, moved outward to 8 bits"
# checks = 2
# text = ["#define FOCAL_LEAST {}", "#define FOCAL_MOST {}"]
def focal_lengths():
    """1 / (2 tan(fov / 2)) of 150 and of 10 degrees in units of 2^-16, to 8 bits: downward, and upward."""
    least, most = (2 ** 16 / (2 * tangent(pi() * degrees / 360)) for degrees in (150, 10))
    low, high = 2 ** (floor(least).bit_length() - 8), 2 ** (floor(most).bit_length() - 8)
    return [floor(least / low) * low, ceil(most / high) * high]


# [[row]]
# id = "magic of an image"
# function = "lib/scene/scene_sections.c:MAGIC"
# property = "it is the four letters"
# checks = 1
# text = ["#define MAGIC {}u"]
def magic():
    return [int.from_bytes(b"FXLS", "little")]


# [[row]]
# id = "table of the CRC"
# function = "lib/scene/crc.c:remainders"
# property = "each entry is the remainder of four bits"
# checks = 17
# text = ["for the reflected polynomial {}.", "static const uint32_t remainders[16] = {{*}}"]
def remainders():
    """The polynomial, and of each four bits what shifting them out leaves."""
    found = [POLYNOMIAL]
    for value in range(16):
        for _ in range(4):
            value = value >> 1 ^ (POLYNOMIAL if value & 1 else 0)
        found.append(value)
    return found
