# SPDX-License-Identifier: MIT
"""What goes together (docs/extras/combinations.md, section 3): every order, target and attribute is drawn, whatever the delivery, and the
reference renderer explains each pixel. This file writes the table of that page: .venv/bin/python host_tests/judges/test_combinations.py."""

import dataclasses
import itertools
import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

import numpy
import pytest

BUILT_PROGRAMS = ("host/frames", "host/judge", "bench/*")
HERE = Path(__file__).resolve().parent
if __name__ == "__main__":
    sys.path[:0] = [str(HERE.parent), *(str(HERE.parent / room) for room in ("boards", "tools")), str(HERE.parents[1] / "tools")]

from board_programs import made
from drawn_scenes import head
from fixel.base.errors import ToolError
from fixel.board import dump, emulator
from fixel.image import image
from fixel.scene import compiler
from fixel.scene.target import VALUES

PAGE = HERE.parents[1] / "docs" / "extras" / "combinations.md"
BEGIN, END = "<!-- table -->\n", "<!-- end of table -->\n"
BEGIN_FLAT = "<!-- table of an orthographic lens -->\n"
LEAST = 5           # per cent of the frame that an attribute must change
LINE, BORDER = 1, 2     # palette indices
WIDTH, HEIGHT = 64, 48

# place pixel-format: what the format cannot draw
TARGETS = {f"{pixels}{f', depth {bits}' if bits else ''}": (pixels, bits) for pixels in VALUES["pixels"] for bits in (0, 16, 32)}
WAYS = [(order, name) for order in ("distance", "tree") for name in TARGETS if order == "distance" or not TARGETS[name][1]]
FLAT_WAYS = [("orthographic", name) for name in TARGETS]    # by distance too, with an orthographic lens

BASE = 'background = "#203040"\n%(top)s\n' + head(WIDTH, HEIGHT, [
    'pixels = "%(pixels)s"', "depth = %(depth)d", "near = 0.25", "far = %(far)s"]) + """%(tables)s
[[objects]]
solid = "floor"
cells = [3, 3]
scale = [14, 1, 14]
position = [0, -2, 0]
colour = "#4c6c54"
[[objects]]
solid = "box"
scale = [0.8, 5, 0.8]
position = [-2.2, 0, 0.4]
colour = "#a0703c"
[[objects]]
solid = "box"
scale = [0.7, 4, 0.7]
position = [1.6, 0, -1.2]
colour = "#d8d0a0"
[[objects]]
solid = "box"
name = "subject"
scale = [3.4, 2.8, 2.2]
position = [0.2, 0, 0]
colour = "#b04838"
%(moves)s
%(subject)s
[path]
keys = [{ position = [1.6, 1.2, -5.5], look_at = [0, 0, 0] }, { position = [-2.5, 0.8, -5], look_at = [0, 0, 0], frames = 1 }]
"""
TEXTURE = '[[textures]]\nname = "t"\npattern = "%s"\nsize = [16, 16]\n%s\n'
# Of a grille, 18 texels of 16: it ends with a bar, as it begins with one, of which the edge of the texture hides a third of a texel.
FRAMED = 'texture = "t"\ntiles = [1.125, 1.125]'
LIGHT = '[light]\nlevels = 16\ndirection = [0.3, -1, 0.8]\nambient = 0.35\ndark = "#203040"\n'

COLOURED_BOX = "".join(f"v {x} {y} {z} {x + 0.5} {y + 0.5} {0.5 - z}\n" for z in (-0.5, 0.5) for y in (-0.5, 0.5) for x in (-0.5, 0.5)) + \
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"

# Of an attribute: what the scene has beside, and what its subject has. "flat" is the scene itself.
ATTRIBUTES = {
    "flat": ("", ""),
    "texture of 8 bits": (TEXTURE % ("stones", ""), 'texture = "t"'),
    "texture of 4 bits": (TEXTURE % ("bricks", "bits = 4"), 'texture = "t"'),
    "texture with holes": (TEXTURE % ("grille", ""), FRAMED),
    "texture of RGB565": (TEXTURE % ("stones", "bits = 16\nlevels = 5"), 'texture = "t"'),
    "texture of RGB565 with holes": (TEXTURE % ("grille", "bits = 16"), FRAMED),
    "stipple": ("", "opacity = 7"),
    "blend": ("", "blend = true"),
    "added": ("", 'blend = "add"'),
    "colours at corners": ("", 'vertex_colours = true'),
    "lit flat": (LIGHT, ""),
    "lit smooth": (LIGHT, "smooth = true"),
    "fog": (LIGHT + "fog = { near = 2, far = 14 }\n", ""),
    "beams": ('[glow]\nstrength = 2\n[[beams]]\ndirection = [0.2, -0.5, 1]\n'
              "window = [[-3, 0.5, -4], [-3, 4, -4], [3, 4, -4], [3, 0.5, -4]]\n", ""),
    "billboards": ('[[billboards]]\nname = "b"\npattern = "tree"\npixels = [16, 24]\nsize = [2, 3]\n'
                   '[[objects]]\nbillboard = "b"\nposition = [-1.2, -2, -2]\n', ""),
    "outlines": ("", ""),
    "lines": ("", 'edges = { colour = "white", width = 4 }'),
    "horizon": ('[horizon]\ndegrees = [-25, -8, 0, 9, 30]\ncolours = ["#402010", "#604020", "#806040", "#80b0f0", "#6090e0", "#4070c0"]\n', ""),
}

# What only frames of RGB565 show, and how the tool calls it.
OF_RGB565 = {"texture of RGB565": "texels of RGB565", "texture of RGB565 with holes": "texels of RGB565", "added": 'blend = "add"', "colours at corners": "colours at corners"}

# How a frame is delivered: options of build/host/frames. The pixels are those of the whole frame.
DELIVERIES = {"bands": ("--rows", "7"), "spilled list": ("--rows", "7", "--list", "60"), "two cores": ("--rows", "7", "--cores", "2"),
              "two cores, spilled list": ("--rows", "7", "--cores", "2", "--list", "60")}
OVERLAY = ("--border", BORDER, "--rows", "7")


def is_refused(order, target, name):
    """docs/extras/combinations.md, section 2, says so by FXL_E_COMBINATION. Of the outlines: the scene's subject moves, and a tree
    would cut it."""
    return name == "outlines" and order == "tree"


# Of which the tool makes no image, and what it says.
NO_IMAGE = {("tree", "lines"): "lines and a tree do not go together",
            ("orthographic", "horizon"): "an orthographic lens and a horizon do not go together"}


def is_cut(order, name):
    """Whether the tool makes no image of a scene."""
    return (order, name) in NO_IMAGE


def is_of_rgb565(target, name):
    """Whether frames of a palette cannot show an attribute: no image of such a scene is made."""
    return TARGETS[target][0] == "palette" and name in OF_RGB565


def image_of(folder, order, target, name, tables, subject):
    """The image of the scene with tables and lines of its subject. name: of the file."""
    pixels, bits = TARGETS[target]
    file = folder / "scene.toml"
    file.write_text(BASE % {"top": 'tree = "all"' if order == "tree" else "", "pixels": pixels, "depth": bits, "tables": tables,
                            "moves": "moves = true" if order == "tree" else "", "subject": subject,
                            "far": "64\nscale = 8" if order == "orthographic" else "64"})
    if "vertex_colours" in subject:     # which a model's file has
        (folder / "subject.obj").write_text(COLOURED_BOX)
        file.write_text(file.read_text().replace('solid = "box"\nname = "subject"', 'model = "subject.obj"\nname = "subject"')
                        .replace('colour = "#b04838"\n', ""))
    compiled, _ = compiler.compile_scene(str(file))
    made = folder / f"{name}.fxls"
    made.write_bytes(image.pack(compiled))
    return made


def build_image(folder, order, target, name):
    """The image of the scene with an attribute; "": without one."""
    return image_of(folder, order, target, name or "without", *(ATTRIBUTES[name] if name else ("", "")))


def tables_of(first, second):
    """The tables of two attributes; light stands there once."""
    tables = [ATTRIBUTES[name][0] for name in (first, second)]
    if all(each.startswith(LIGHT) for each in tables):
        return max(tables, key=len)
    return "".join(tables)


def run(build, program, *words):
    return subprocess.run([build / "host" / program, *map(str, words)], text=True, capture_output=True, check=False)


def frames_of(build, scene, *options):
    out = scene.with_suffix(".fxld")
    done = run(build, "frames", scene, out, *options)
    assert done.returncode == 0, (scene, options, done.stderr)
    return dump.read_dump(out)


def shown(read):
    """The colours of all frames."""
    return numpy.array([read.palette[frame.pixels] for frame in read.frames], dtype=int)


def values(read):
    return numpy.array([frame.pixels for frame in read.frames])


def judged(build, scene, *options):
    """What the reference says of the frames that were drawn last: the number of pixels that it cannot explain; the names of what it
    shows; its pixels."""
    out, names, twin = (scene.with_suffix(suffix) for suffix in (".json", ".names", ".twin"))
    done = run(build, "judge", scene, scene.with_suffix(".fxld"), "--json", out, "--shown", names, "--twin", twin, *options)
    assert done.returncode == 0, done.stderr
    return json.loads(out.read_text())["pixels_unexplained"], values(dump.read_dump(names)), values(dump.read_dump(twin))


def near(names):
    """For each pixel the names of the nine about it."""
    padded = numpy.pad(names, ((0, 0), (1, 1), (1, 1)), mode="edge")
    count, height, width = names.shape
    return numpy.array([padded[:, y:y + height, x:x + width] for y in range(3) for x in range(3)]).reshape(9, count, height, width)


@dataclasses.dataclass
class Cell:
    """A cell of the table. per_cent: of the frames, that the attribute changes, or None where it is refused; crcs: of the pixels of
    the whole frames and of those with an overlay; refusal: what the library says instead."""
    per_cent: int | None
    image: bytes        # none where the tool makes none
    has_outlines: bool
    crcs: tuple = ()
    refusal: str = ""


def crc_of(read):
    return zlib.crc32(values(read).tobytes())


def check_cell(build, folder, order, target, name, without):
    """The cell. without: the colours of the frames without its attribute."""
    scene = build_image(folder, order, target, name)
    extra = extra_of(name)
    picks = scene.with_suffix(".picks")
    whole = frames_of(build, scene, *extra, "--picks", picks)
    unexplained, names, twin = judged(build, scene, *extra)
    where = (order, target, name)
    assert unexplained == 0, where
    # Where the frame is the reference's, the pick is what the reference shows. At the edge of a face it may be that of a neighbour of
    # the same colour. A line of an outline is not picked.
    picked = values(dump.read_dump(picks))
    assert ((near(names) == picked).any(axis=0) | (values(whole) != twin)).all(), where
    assert (picked == names).mean() > 0.98, where
    for delivery, options in DELIVERIES.items():
        assert (values(frames_of(build, scene, *extra, *options)) == values(whole)).all(), (where, delivery)
    over = frames_of(build, scene, *extra, *OVERLAY)
    border = numpy.zeros((HEIGHT, WIDTH), bool)
    border[4:20, 4:28] = True
    border[5:19, 5:27] = False
    assert (values(over)[:, ~border] == values(whole)[:, ~border]).all(), where
    assert len(numpy.unique(values(over)[:, border])) == 1, where
    return Cell(round(100 * (shown(whole) != without).any(axis=-1).mean()), scene.read_bytes(), name == "outlines",
                (crc_of(whole), crc_of(over)))


def background_of(pixels):
    """The colour of the scene's background."""
    red, green, blue = 0x20, 0x30, 0x40
    number = red // 8 << 11 | green // 4 << 5 | blue // 8
    return dump.colours(16, None)[number] if pixels == "rgb565" else numpy.array((red, green, blue))


def cells_of(build, folder, ways):
    """(order, target, attribute) -> its cell."""
    found = {}
    for order, target in ways:
        plain = shown(frames_of(build, build_image(folder, order, target, "")))
        empty = numpy.broadcast_to(background_of(TARGETS[target][0]), plain.shape)
        for name in ATTRIBUTES:
            if is_of_rgb565(target, name):
                with pytest.raises(ToolError, match=f"frames of a palette cannot show .*{OF_RGB565[name]}"):
                    build_image(folder, order, target, name)
                found[order, target, name] = Cell(None, b"", False)
            elif is_cut(order, name):
                with pytest.raises(ToolError, match=NO_IMAGE[order, name]):
                    build_image(folder, order, target, name)
                found[order, target, name] = Cell(None, b"", False)
            elif is_refused(order, target, name):
                scene = build_image(folder, order, target, name)
                done = run(build, "frames", scene, folder / "none.fxld", "--outlines", LINE)
                assert done.returncode == 2 and "do not go together" in done.stderr, (order, target, name)
                found[order, target, name] = Cell(None, scene.read_bytes(), True, refusal=done.stderr.strip().split(": ", 2)[2])
            else:
                found[order, target, name] = check_cell(build, folder, order, target, name, empty if name == "flat" else plain)
    return found


def table_of(cells, ways):
    head = ["attribute", *(f"{order}: {target}" for order, target in ways)]
    rows = [[name, *("refused" if cells[(*way, name)].per_cent is None else f"{cells[(*way, name)].per_cent} %" for way in ways)] for name in ATTRIBUTES]
    return "".join(f"| {' | '.join(row)} |\n" for row in (head, ["---"] * len(head), *rows))


@pytest.fixture(scope="module", name="cells")
def fixture_cells(build, tmp_path_factory):
    return cells_of(build, tmp_path_factory.mktemp("combinations"), WAYS)


def test_an_orthographic_lens_draws_its_table(build, tmp_path):
    cells = cells_of(build, tmp_path, FLAT_WAYS)
    assert {key: cell.per_cent for key, cell in cells.items() if cell.per_cent is not None and cell.per_cent < LEAST} == {}
    written = PAGE.read_text(encoding="utf-8").split(BEGIN_FLAT)[1].split(END)[0]
    assert written == table_of(cells, FLAT_WAYS), f"{PAGE}: .venv/bin/python {Path(__file__).name} writes the table"


def test_each_attribute_changes_the_frame(cells):
    assert {key: cell.per_cent for key, cell in cells.items() if cell.per_cent is not None and cell.per_cent < LEAST} == {}
    assert sum(cell.per_cent is None for cell in cells.values()) == 4 + 4 * len(OF_RGB565)


def test_the_page_has_the_table(cells):
    written = PAGE.read_text(encoding="utf-8").split(BEGIN)[1].split(END)[0]
    assert written == table_of(cells, WAYS), f"{PAGE}: .venv/bin/python {Path(__file__).name} writes the table"


# The cores for which bench/bench.mk links a program that draws the cells, and two with the library for few bytes.
CORES = ("m0/cells", "m3/cells", "m55/cells", "m0/cells-small", "m3/cells-small")


def words_of(options):
    """Options of build/host/frames as bench/firmware/cells.c has them."""
    chosen = {"--rows": HEIGHT, "--list": 1 << 20, "--cores": 1, "--border": -1, **dict(zip(options[::2], map(int, options[1::2])))}
    return chosen["--rows"], chosen["--list"], chosen["--cores"], chosen["--border"] + 1


def list_of(cells):
    """The list of scenes for that program, and the lines that it is to print."""
    words, lines = b"", []
    for cell in (cell for cell in cells.values() if cell.image):
        ways = [(), *DELIVERIES.values(), OVERLAY] if cell.crcs else [()]
        numbers = [len(cell.image), LINE + 1 if cell.has_outlines else 0, len(ways), *(word for way in ways for word in words_of(way))]
        words += struct.pack(f"<{len(numbers)}I", *numbers) + cell.image + bytes(-len(cell.image) % 4)
        lines += [f"crc {cell.crcs[way is OVERLAY]}" for way in ways] if cell.crcs else [f"refused: {cell.refusal}"]
    return words + bytes(4), lines


@pytest.mark.parametrize("program", CORES)
def test_each_core_draws_the_cells_of_the_host(cells, program, tmp_path):
    """The host's, which the reference has judged."""
    scenes, expected = list_of(cells)
    file = tmp_path / "cells"
    file.write_bytes(scenes)
    ending = emulator.run_text(made(f"build/bench/{program}.elf"), icount=False, scene=file)
    lines = re.findall(r"^cells: (.+)$", ending.output, re.MULTILINE)
    assert ending.code == emulator.exit_code("DONE"), ending.output
    assert lines == [*expected, f"done {len(expected)}"]


# Beams go neither with outlines nor with lines nor with texels of RGB565 nor with colours at corners, which have no texture, and a face is either
# blended or added.
NOT_DRAWN = {("beams", "outlines"), ("beams", "lines"), ("colours at corners", "beams"), *((name, "colours at corners") for name in ATTRIBUTES if name.startswith("texture")),
             ("texture of RGB565", "beams"), ("texture of RGB565 with holes", "beams"), ("blend", "added")}


def extra_of(*names):
    """Options of build/host/frames beside the scene."""
    return ("--outlines", LINE) if "outlines" in names else ()


def is_pair(first, second):
    """Whether a scene may have both attributes, and the reference can say what they show. Smooth light and fog have flat light."""
    is_part = all(mine in other for mine, other in zip(ATTRIBUTES[first], ATTRIBUTES[second]))
    return not is_part and not second.startswith("texture") and (first, second) not in NOT_DRAWN


def pairs():
    """(order, target, first, second) of all pairs of attributes that an object may have."""
    for first, second in itertools.combinations([name for name in ATTRIBUTES if name != "flat"], 2):
        if is_pair(first, second):
            yield from ((order, target, first, second) for order, target in WAYS
                        if not any(is_refused(order, target, name) or is_cut(order, name) or is_of_rgb565(target, name) for name in (first, second)))


def test_pairs_of_attributes_are_those_of_the_reference(build, tmp_path):
    """And each of the two changes what the other one alone shows."""
    count, wrong, unseen, alone = 0, [], [], {}
    for order, target, *names in pairs():
        scene = image_of(tmp_path, order, target, "pair", tables_of(*names), "\n".join(ATTRIBUTES[name][1] for name in names))
        both = shown(frames_of(build, scene, *extra_of(*names)))
        count += 1
        if judged(build, scene, *extra_of(*names))[0] != 0:
            wrong.append((order, target, *names))
        for name in names:
            if (order, target, name) not in alone:
                alone[order, target, name] = shown(frames_of(build, build_image(tmp_path, order, target, name), *extra_of(name)))
            changed = 100 * (both != alone[order, target, name]).any(axis=-1).mean()
            if changed < LEAST:
                unseen.append((order, target, *names, name, changed))
    assert not wrong and not unseen and count > 300, (count, wrong, unseen)


def write(begin, ways):
    """Writes the page's table of these ways."""
    with tempfile.TemporaryDirectory() as scratch:
        made = table_of(cells_of(HERE.parents[1] / "build", Path(scratch), ways), ways)
    before, rest = PAGE.read_text(encoding="utf-8").split(begin)
    _, after = rest.split(END, 1)
    PAGE.write_text(before + begin + made + END + after, encoding="utf-8")
    os.write(1, made.encode())


if __name__ == "__main__":
    write(BEGIN, WAYS)
    write(BEGIN_FLAT, FLAT_WAYS)
