# SPDX-License-Identifier: MIT
"""Frames as pictures: PNGs with the scene's palette, animations, side-by-side differences."""

import functools
import io

import numpy
from PIL import Image, ImageDraw, ImageFont

GAP = 6                 # pixels between panels
CAPTION = 14            # pixels of height for a panel's caption
PAPER = (24, 26, 32)
INK = (226, 228, 233)
MARK = (255, 0, 160)    # what differs
RING = (255, 170, 220)  # around it
RING_DISTANCE = 3
FRAME_MS = 40           # of the animation


def palette_image(pixels, palette):
    """A picture of pixels, of which the palette has a colour for each value. Indices of 8 bits stay indices, so equal
    frames give equal files."""
    if pixels.dtype.itemsize > 1:
        return Image.fromarray(as_rgb(pixels, palette))
    image = Image.fromarray(numpy.ascontiguousarray(pixels))
    image = image.convert("L") if image.mode != "L" else image
    image.putpalette(palette.tobytes(), "RGB")
    return image


@functools.cache
def rgb565_colours():
    """The 65,536 colours of RGB565 (x 3): each channel's largest value is 255, rounded to nearest."""
    values = numpy.arange(1 << 16)
    channels = [(2 * 255 * channel + most) // (2 * most)
                for channel, most in ((values >> 11, 31), (values >> 5 & 63, 63), (values & 31, 31))]
    return numpy.stack(channels, axis=-1).astype(numpy.uint8)


def animation_bytes(frames, palette, milliseconds=FRAME_MS):
    """An endless GIF of frames (arrays of pixels)."""
    images = [palette_image(pixels, palette) for pixels in frames]
    block = io.BytesIO()
    images[0].save(block, "GIF", save_all=True, append_images=images[1:], loop=0,
                   duration=milliseconds, disposal=1, optimize=False)
    return block.getvalue()


def png_bytes(image):
    """An image as the bytes of a PNG."""
    block = io.BytesIO()
    image.save(block, "PNG", optimize=True)
    return block.getvalue()


def as_rgb(pixels, palette):
    """Colours (height x width x 3) of pixels."""
    return palette[pixels]


def difference_panel(a, differs, ring=0):
    """a in dim grey with every differing pixel marked, and a square ring around it at that distance:
    one pixel of a large frame is easily overlooked."""
    grey = (a[..., :3].mean(axis=2) * 0.35 + 20).astype(numpy.uint8)
    panel = numpy.repeat(grey[..., None], 3, axis=2)
    if ring:
        panel[_grown(differs, ring) & ~_grown(differs, ring - 1)] = RING
    panel[differs] = MARK
    return panel


def _grown(mask, by):
    """A mask with everything within a distance of it, rows and columns alike."""
    for axis in (0, 1):
        padded = numpy.pad(mask, [(by, by) if each == axis else (0, 0) for each in (0, 1)])
        mask = numpy.lib.stride_tricks.sliding_window_view(padded, 2 * by + 1, axis).any(axis=-1)
    return mask


def differing_region(differs, size=24):
    """A window (y0, y1, x0, x1) of about size pixels square with the most differing pixels in it."""
    height, width = differs.shape
    rows, columns = min(size, height), min(size, width)
    sums = numpy.zeros((height + 1, width + 1), numpy.int64)
    sums[1:, 1:] = differs.cumsum(axis=0).cumsum(axis=1)
    counts = (sums[rows:, columns:] - sums[:-rows, columns:] - sums[rows:, :-columns]
              + sums[:-rows, :-columns])
    best = counts.max()
    tops, lefts = numpy.nonzero(counts == best)
    # Of all windows that hold as many, the middle one centres what it shows.
    y0 = int(tops[len(tops) // 2])
    beside = lefts[tops == y0]
    x0 = int(beside[len(beside) // 2])
    return y0, y0 + rows, x0, x0 + columns


def side_by_side(a, b, differs, names):
    """Panels a | b | difference; below, the same three enlarged where they differ most."""
    panels = [a[..., :3], b[..., :3], difference_panel(a, differs, RING_DISTANCE)]
    height, width = differs.shape
    sheet_rows = [(panels, 1, [*names, f"difference: {int(differs.sum())} pixels"])]
    if differs.any() and min(height, width) >= 16:
        y0, y1, x0, x1 = differing_region(differs)
        scale = max(2, width // (x1 - x0))
        cuts = [panel[y0:y1, x0:x1] for panel in (*panels[:2], difference_panel(a, differs))]
        caption = f"columns {x0}..{x1 - 1}, rows {y0}..{y1 - 1}, x{scale}"
        sheet_rows.append((cuts, scale, [caption, "", ""]))
    return _sheet(sheet_rows)


def _sheet(rows):
    """Rows of (panels, scale, captions) on one picture."""
    scaled = [([numpy.repeat(numpy.repeat(panel, scale, 0), scale, 1) for panel in panels],
               captions) for panels, scale, captions in rows]
    width = max(sum(panel.shape[1] + GAP for panel in panels) + GAP for panels, _ in scaled)
    height = sum(panels[0].shape[0] + CAPTION + GAP for panels, _ in scaled) + GAP
    sheet = Image.new("RGB", (width, height), PAPER)
    draw, font, y = ImageDraw.Draw(sheet), ImageFont.load_default(), GAP
    for panels, captions in scaled:
        x = GAP
        for panel, caption in zip(panels, captions):
            draw.text((x, y), caption, fill=INK, font=font)
            sheet.paste(Image.fromarray(numpy.ascontiguousarray(panel.astype(numpy.uint8))),
                        (x, y + CAPTION))
            x += panel.shape[1] + GAP
        y += panels[0].shape[0] + CAPTION + GAP
    return sheet
