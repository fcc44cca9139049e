# SPDX-License-Identifier: MIT
"""UF2, the file that a board's boot ROM takes as a drive would take a copy: blocks of 512 bytes, each with an address and 256
bytes for it (the format's specification, "USB Flashing Format")."""

import struct

from fixel.base import output
from fixel.base.errors import ToolError

PAGE = 256                  # bytes of flash in a block
BLOCK = 512
_HEAD = struct.Struct("<8I")    # two marks, flags, address, size, number, blocks, family
_BEGIN, _SECOND, _END = 0x0A324655, 0x9E5D5157, 0x0AB16F30
_HAS_FAMILY = 0x2000


def encode(pieces, family):
    """Blocks of pieces (address, bytes) that begin and end with a page: bytes."""
    pages = [(address + at, content[at:at + PAGE]) for address, content in pieces for at in range(0, len(content), PAGE)]
    if any(address % PAGE or len(page) != PAGE for address, page in pages):
        raise ValueError("a piece does not begin and end with a page")
    return b"".join(_HEAD.pack(_BEGIN, _SECOND, _HAS_FAMILY, address, PAGE, number, len(pages), family)
                    + page.ljust(BLOCK - _HEAD.size - 4, b"\0") + struct.pack("<I", _END)
                    for number, (address, page) in enumerate(pages))


def decode(data, family):
    """{address: 256 bytes} of all blocks; refuses what a boot ROM of that family would not take whole."""
    def require(condition, what):
        if not condition:
            raise ToolError(f"the UF2 file is damaged: {what}", 1)

    require(data and len(data) % BLOCK == 0, "it does not end with a block")
    pages = {}
    for number in range(len(data) // BLOCK):
        block = data[number * BLOCK:(number + 1) * BLOCK]
        begin, second, flags, address, size, told, count, named = _HEAD.unpack_from(block)
        require((begin, second, *struct.unpack_from("<I", block, BLOCK - 4)) == (_BEGIN, _SECOND, _END), f"block {number} has no marks")
        require((flags, named) == (_HAS_FAMILY, family), f"block {number} is for another chip")
        require((told, count) == (number, len(data) // BLOCK), f"block {number} is out of order")
        require(size == PAGE and address % PAGE == 0 and address not in pages, f"block {number} is for a place that it cannot be for")
        pages[address] = block[_HEAD.size:_HEAD.size + PAGE]
    return pages


def sectors(program, data):
    """The sectors of a flash image that are not erased, as pieces for encode: a boot ROM erases whole sectors."""
    found, start = [], 0
    for size in program.sectors:
        content = data[start:start + size]
        if content.strip(b"\xff"):
            found.append((program.address(start), content))
        start += size
    return found


def write(program, image, file):
    """Writes the UF2 file of a flash image, and reads it back: how many blocks it has."""
    pieces = sectors(program, image)

    def check(path):
        pages = decode(path.read_bytes(), program.uf2)
        if b"".join(pages[address] for address in sorted(pages)) != b"".join(content for _, content in pieces):
            raise ToolError(f"verification failed: {path} does not hold what was written", 1)
        return len(pages)

    return output.replace(file, encode(pieces, program.uf2), check)
