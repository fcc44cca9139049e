# SPDX-License-Identifier: MIT
"""Images of textures, read by Pillow within limits."""

import io
import warnings
import zlib

import numpy as np
from PIL import Image, PngImagePlugin, UnidentifiedImageError

from fixel.base import foreign, reading
from fixel.base.errors import ToolError
from fixel.base.reading import shortened

FILE_MAX = 272 << 20    # bytes: 8192 x 8192 pixels of 32 bits, and a head
SIDE_MAX = 8192         # pixels
KEPT_MAX = 2048         # pixels: an image with a longer side is shrunk as it is read
STRIPS_MAX = 16 << 20   # bytes of all its pixels, compressed, which are kept beside it
FORMATS = ("PNG", "JPEG", "BMP", "TGA", "GIF", "PPM", "WEBP")
EXIF_MAX, _EXIF = 64, b"Exif\0\0"
COMMENTS_MAX, _PLAIN = 64, (b"P1", b"P2", b"P3")
PngImagePlugin.MAX_TEXT_MEMORY = 1 << 22    # bytes of compressed texts that Pillow reads before anything else
ALPHA_MOST = 4      # of 255
_EDGE_SHARE = 1 / 20
_CHUNK = 1024           # triangles at a time
_ROWS = 256             # of an image of 16 bits, at a time
_STEPS = 8              # a triangle's mean has samples at this many places along an edge
_ORIENTATION = 0x0112       # of Exif
# How a picture of each orientation is turned upright; 1 is upright.
_UPRIGHT = {2: Image.Transpose.FLIP_LEFT_RIGHT, 3: Image.Transpose.ROTATE_180, 4: Image.Transpose.FLIP_TOP_BOTTOM,
            5: Image.Transpose.TRANSPOSE, 6: Image.Transpose.ROTATE_270, 7: Image.Transpose.TRANSVERSE, 8: Image.Transpose.ROTATE_90}
_TOO_LARGE = f"; both sides must be 1..{SIDE_MAX}: make it smaller"


class Texture:
    """An image as rows of red, green, blue, alpha. strips: of one that was shrunk all pixels, compressed, some rows each; none where
    they are too many. notes: what there is to say of the file."""

    def __init__(self, name, pixels, strips=(), notes=()):
        self.name, self.pixels, self.strips, self.notes = name, pixels, strips, notes
        self.pictures = {}      # made of it for textures (toml_images.py)
        self.height, self.width = pixels.shape[:2]

    def scaled(self, width, height):
        """Its pixels in another size, each the mean of what it covers."""
        return np.asarray(Image.fromarray(np.ascontiguousarray(self.pixels)).resize((width, height), Image.Resampling.BOX))

    def whole(self):
        """The image as it was before it was shrunk, where it is known."""
        if not self.strips:
            return self
        width, strips = self.strips
        return Texture(self.name, np.concatenate([np.frombuffer(zlib.decompress(strip), dtype=np.uint8).reshape(-1, width, 4) for strip in strips]))

    def once(self, key, make):
        """An image that is made of this one, once."""
        if key not in self.pictures:
            self.pictures[key] = Texture(self.name, make())
        return self.pictures[key]

    def with_alpha(self, cutoff):
        """The image without its alpha, or, from an alpha of 0..1 on, opaque and clear below."""
        def make():
            pixels = self.pixels.copy()
            pixels[..., 3] = 255 if cutoff is None else np.where(pixels[..., 3] >= 255 * cutoff, 255, 0)
            return pixels
        return self if (self.pixels[..., 3] == 255).all() and (cutoff is None or cutoff <= 1) else self.once(("alpha", cutoff), make)

    def cut(self, mask):
        """The image where another one shows it: by the alpha of that one, or how bright it is if it is all opaque."""
        def make():
            size = max(self.width, mask.width), max(self.height, mask.height)
            pixels, other = self.scaled(*size).copy(), mask.scaled(*size)
            shown = other[..., 3] if (other[..., 3] < 255).any() else np.asarray(Image.fromarray(other).convert("L"))
            pixels[..., 3] = (pixels[..., 3].astype(np.uint16) * shown + 127) // 255
            return pixels
        return self if mask is self else self.once(("cut", id(mask)), make)

    def is_translucent(self):
        """Whether more than a few of its pixels, as edges have them, are neither clear nor opaque."""
        alpha = self.pixels[..., 3]
        return bool(np.count_nonzero((alpha > 0) & (alpha < 255)) > _EDGE_SHARE * alpha.size)

    def one_alpha(self):
        """The alpha, 1..254, of all but a few of its pixels that are not clear, to within ALPHA_MOST; None where they have several."""
        shown = self.pixels[..., 3][self.pixels[..., 3] > 0].astype(int)
        middle = int(np.median(shown)) if shown.size else 255
        off = np.count_nonzero(np.abs(shown - middle) > ALPHA_MOST)
        return middle if middle < 255 and off <= _EDGE_SHARE * self.pixels[..., 3].size else None

    def mirrored(self, across, down):
        """The image and its mirror image beside it, below it, or both."""
        def make():
            wide = np.concatenate([self.pixels, self.pixels[:, ::-1]], axis=1) if across else self.pixels
            return np.concatenate([wide, wide[::-1]], axis=0) if down else wide
        return self.once(("mirrored", across, down), make)

    def tiled(self, axis, first, count, mirrors):
        """The image count times one after the other, along 0 across or 1 down. mirrors: each odd one is mirrored; first: the number of the
        first."""
        def make():
            along = 1 - axis
            return np.concatenate([np.flip(self.pixels, along) if mirrors and number % 2 else self.pixels
                                   for number in range(first, first + count)], along)
        is_same = count == 1 and not (mirrors and first % 2)
        return self if is_same else self.once(("tiled", axis, mirrors and first % 2, count, mirrors), make)

    def _of_triangles(self, corners, clamp):
        """What lies at some places of each triangle, of (count, 3 corners, 2) coordinates. clamp: beyond its edges the image shows them;
        else it repeats."""
        first, along = corners[:, None, 0], corners[:, None, 1:] - corners[:, None, :1]
        places = first + along[:, :, 0] * _INSIDE[:, :1] + along[:, :, 1] * _INSIDE[:, 1:]
        places = np.clip(places, 0, 1) if clamp else places % 1.0
        columns = np.minimum((places[:, :, 0] * self.width).astype(int), self.width - 1)
        rows = np.minimum((places[:, :, 1] * self.height).astype(int), self.height - 1)
        return self.pixels[rows, columns]

    def _of_fans(self, outlines, figure, clamp):
        """(a figure of what lies in each triangle of the outlines' fans, the first triangle of each, how many it has)."""
        fans = [[(outline[0], b, c) for b, c in zip(outline[1:], outline[2:])] for outline in outlines]
        corners = np.array([three for fan in fans for three in fan], dtype=float)
        found = np.concatenate([figure(self._of_triangles(corners[start:start + _CHUNK], clamp))
                                for start in range(0, len(corners), _CHUNK)])
        counts = np.array([len(fan) for fan in fans])
        return found, np.cumsum(counts) - counts, counts

    def means(self, outlines, clamp=False):
        """The mean colour of what lies between the corners of each outline, as a fan of triangles."""
        found, firsts, counts = self._of_fans(outlines, lambda seen: seen[..., :3].mean(axis=1), clamp)
        sums = np.add.reduceat(found, firsts, axis=0)
        return list(map(tuple, (sums / counts[:, None]).round().astype(int).tolist()))

    def spreads(self, outlines, clamp=False):
        """Of each outline the most by which red, green, blue or alpha differ at some places between its corners."""
        low, firsts, _ = self._of_fans(outlines, lambda seen: seen.min(axis=1), clamp)
        high, *_ = self._of_fans(outlines, lambda seen: seen.max(axis=1), clamp)
        spread = np.maximum.reduceat(high, firsts, axis=0).astype(int) - np.minimum.reduceat(low, firsts, axis=0)
        return spread.max(axis=1).tolist()


# Places in a triangle, as parts of its two edges from the first corner.
_INSIDE = np.array([((2 * i + 1) / (2 * _STEPS + 1), (2 * j + 1) / (2 * _STEPS + 1))
                    for i in range(_STEPS) for j in range(_STEPS - i)])


def _upright(opened):
    """How Exif of an image says that it is to be turned; None for one that is upright. Damaged Exif says nothing."""
    try:
        return _UPRIGHT.get(opened.getexif().get(_ORIENTATION))
    except MemoryError:
        raise
    except Exception:       # Pillow's reader raises anything
        return None


def _of_16_bits(opened):
    """An image of greys of 16 bits, which Pillow would cut off at 255, in 8 bits; the grey that is clear is."""
    greys, clear = np.asarray(opened), opened.info.get("transparency")
    grey = np.empty(greys.shape, dtype=np.uint8)
    for first in range(0, len(greys), _ROWS):
        some = np.clip(greys[first:first + _ROWS].astype(np.int64), 0, 65535)
        grey[first:first + _ROWS] = (some * 255 + 32767) // 65535
    if not isinstance(clear, int):
        return Image.fromarray(grey)
    return Image.fromarray(np.stack([grey, np.where(greys == clear, 0, 255).astype(np.uint8)], axis=-1)).convert("RGBA")


def _strips(opened):
    """(width, its rows in strips) of an image in 8 bits: compressed as those of few colours are; () where that is much."""
    width, height = opened.size
    strips, left = [], STRIPS_MAX
    for top in range(0, height, _ROWS):
        strips.append(zlib.compress(opened.crop((0, top, width, min(top + _ROWS, height))).convert("RGBA").tobytes(), 1))
        left -= len(strips[-1])
        if left < 0:
            return ()
    return width, strips


def _read(opened, name):
    """The Texture of an image that Pillow has opened: in 8 bits, shrunk by whole factors, upright."""
    opened.draft("RGB", (KEPT_MAX, KEPT_MAX))       # of a JPEG, which is then decoded smaller
    turn = _upright(opened)
    if opened.mode.startswith("I"):
        opened = _of_16_bits(opened)
    elif opened.mode == "F":
        opened = Image.fromarray(np.clip(np.asarray(opened), 0, 255).round().astype(np.uint8))
    elif opened.mode not in ("RGB", "L", "RGBA"):
        opened = opened.convert("RGBA")
    factor, strips = -(-max(opened.size) // KEPT_MAX), ()
    if factor > 1:
        strips = _strips(opened) if turn is None else ()
        opened = opened.reduce(factor)
    if turn is not None:
        opened = opened.transpose(turn)
    return Texture(name, np.asarray(opened.convert("RGBA")), strips)


def _notes(opened, name):
    """What there is to say of an image whose first frame was read. A damaged second one says nothing."""
    try:
        has_more = getattr(opened, "is_animated", False)
    except MemoryError:
        raise
    except Exception:       # Pillow's reader raises anything
        has_more = False
    return [f"{name}: a {opened.format} of several frames, of which the first is shown; to show another one, save that as PNG: "
            "magick 'IN[3]' OUT.png"] if has_more else []


def _unreadable(blob, name, error):
    """What there is to say of an image that cannot be read: what it is instead, and the way on."""
    found = foreign.by_beginning(blob[:foreign.START])
    if found and found.sort == foreign.IMAGE:
        return ToolError(f"{name}: {found.kind}, which is not read; {found.way}")
    if found and ".png" not in found.endings:
        return ToolError(f"{name}: holds {found.kind}, which is no image: {found.way}")
    why = " (the file is empty)" if not blob else "" if isinstance(error, UnidentifiedImageError) else f" ({shortened(str(error)) or type(error).__name__})"
    return ToolError(f"{name}: this image cannot be read{why}; it must be a sound file of {', '.join(FORMATS[:-1])} or {FORMATS[-1]}")


def decode(blob, name):
    """The Texture in an image file's bytes."""
    if len(blob) > FILE_MAX:
        raise ToolError(f"{name}: an image of {len(blob):,} bytes is more than the limit of {FILE_MAX:,}; make it smaller")
    if blob[:2] in _PLAIN and blob.count(b"#") > COMMENTS_MAX:  # Pillow copies all that follows for each of them
        raise ToolError(f"{name}: a PPM file of digits with more than {COMMENTS_MAX} comments; save it without")
    if blob.count(_EXIF) > EXIF_MAX:    # Pillow takes quadratic time for them
        raise ToolError(f"{name}: an image with more than {EXIF_MAX} segments of Exif; save it without")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with Image.open(io.BytesIO(blob), formats=FORMATS) as opened:
                width, height = opened.size
                if not (1 <= width <= SIDE_MAX and 1 <= height <= SIDE_MAX):
                    raise ToolError(f"{name}: an image of {width}x{height} pixels{_TOO_LARGE}")
                made = _read(opened, name)
                made.notes = _notes(opened, name)
                return made
    except (ToolError, MemoryError):
        raise
    except Image.DecompressionBombError:
        raise ToolError(f"{name}: an image of very many pixels{_TOO_LARGE}") from None
    except Exception as error:      # Pillow's readers raise anything for a damaged file; one names its place in memory
        raise _unreadable(blob, name, error) from None


def read(path, name):
    """The Texture in a file that a command names."""
    blob = reading.read_whole(path, FILE_MAX, "make the image smaller")
    return decode(blob, name)
