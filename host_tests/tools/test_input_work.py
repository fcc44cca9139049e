# SPDX-License-Identifier: MIT
"""Short scene files that ask for much work, of one thing or of several, each of which would be fine alone: what is the same is made once, and
the limits of test_input_bounds.py end the rest. Images whose textures or sprites overlap, pictures that hide their work, and a font that
says its box twice."""

import io
import struct
import tracemalloc

import numpy as np
import pytest
from PIL import Image

from conftest import CHECKOUT, run_cli, without_progress
from fixel.image import image, image_billboard, image_surface
from fixel.model import texture_image
from fixel.scene import compiler
# place field: images that are broken, for the tools
from scene_sections import replaced
from test_input_bounds import BOX, LITTLE, PATH, assert_built, assert_ended, assert_refused, run_bounded

BUILT_PROGRAMS = ()
PARTED = '[[objects]]\nsolid = "floor"\ncells = [100, 100]\nparts = [64, 64]\nrepeat = {{ count = [{}, 1, 1], step = [0, 0, 0] }}\n'


def scene(folder, text):
    file = folder / "scene.toml"
    file.write_text(text + PATH, encoding="utf-8")
    return file


def noise(folder, name, side=256):
    """A file with an image of as many colours as pixels."""
    chance = np.random.default_rng(len(name))
    Image.fromarray(chance.integers(0, 256, (side, side, 3), dtype=np.uint8)).save(folder / name)
    return folder / name


def textures(rows):
    return "".join(f'[[textures]]\nname = "t{i}"\n{row}\n' for i, row in enumerate(rows)) + BOX


def billboards(rows):
    return "".join(f'[[billboards]]\nname = "b{i}"\nsize = [1, 1]\n{row}\n' for i, row in enumerate(rows)) + BOX


def test_parts_are_made_once(tmp_path):
    assert "16,384 objects" in assert_built(tmp_path, scene(tmp_path, PARTED.format(4)))


def test_parts_of_copies_beyond_the_limit(tmp_path):
    assert_refused(tmp_path, scene(tmp_path, PARTED.format(190)), "parts", "65,535 objects")


@pytest.mark.parametrize("solid", ['solid = "island"\ncolours = ["#203040", "#405060", "#a0a0a0"]\n', 'solid = "floor"\n'])
def test_a_solid_of_many_objects_is_made_once(tmp_path, solid):
    assert_built(tmp_path, scene(tmp_path, f"[[objects]]\n{solid}cells = [140, 140]\n" * 90))


def test_keys_of_quoted_parts_with_escapes(tmp_path):
    """Such parts hid how long a key is, and it took quadratic time and memory."""
    key = ".".join(['"\\"-"'] * 20_000)
    assert_refused(tmp_path, scene(tmp_path, f"{key} = 1\n"), "more than 16 parts")


def test_a_picture_of_many_textures_is_made_once(tmp_path):
    picture = noise(tmp_path, "noise.png")
    assert_built(tmp_path, scene(tmp_path, textures(['file = "noise.png"\nlevels = 9\nmost_colours = 255',
                                                     'file = "./noise.png"\nlevels = 9\nmost_colours = 255'] * 30)))


def test_many_pictures_of_one_file(tmp_path):
    picture = noise(tmp_path, "noise.png")
    rows = [f'file = "noise.png"\nlevels = 9\nmost_colours = {255 - i}' for i in range(30)]
    assert_ended(tmp_path, scene(tmp_path, textures(rows)))


def test_many_texels_of_files(tmp_path):
    pictures = [noise(tmp_path, "n" * (number + 1) + ".png", 128) for number in range(16)]
    rows = [f'file = "{picture.name}"\nlevels = 8' for picture in pictures]
    assert_built(tmp_path, scene(tmp_path, textures(rows)))


@pytest.mark.parametrize("rows", [
    [f'pattern = "bricks"\nsize = [256, 256]\nlevels = 9\ncolours = ["#{i:02x}0000", "red", "green", "blue"]' for i in range(30)],
    [f'pattern = "stones"\nsize = [8, 16]\nlevels = 5\ncolours = ["#{i:02x}0000", "red", "green"]' for i in range(256)],
    ['pattern = "checker"\nsize = [256, 256]\nlevels = 9'] * 256])
def test_patterns(tmp_path, rows):
    """Many of other colours take long, unless they are small; many of the same are one."""
    different = len(set(rows)) > 1 and "256, 256" in rows[0]
    (assert_ended if different else assert_built)(tmp_path, scene(tmp_path, textures(rows)))


def test_billboards_of_one_file(tmp_path):
    picture = noise(tmp_path, "noise.png")
    rows = [f'file = "noise.png"\nmost_colours = {255 - i}' for i in range(60)]
    assert_ended(tmp_path, scene(tmp_path, billboards(rows)))
    assert_built(tmp_path, scene(tmp_path, billboards(rows[:1] * 60)))


@pytest.mark.parametrize("line", ["cells = [true, 2]", "parts = [2, true]",
                                  "repeat = { count = [true, 1, 1], step = [1, 0, 0] }"])
def test_true_is_no_number(tmp_path, line):
    assert_refused(tmp_path, scene(tmp_path, f'[[objects]]\nsolid = "floor"\n{line}\n'), "object 0", line.split()[0], "True")


def test_true_is_no_number_of_pixels(tmp_path):
    assert_refused(tmp_path, scene(tmp_path, billboards(['pattern = "tree"\npixels = [8, true]'])), "billboards[0]", "pixels", "True")


def test_many_objects_of_one_large_model_with_materials(tmp_path):
    """What an object's faces wish for was compared face by face with what others wished for."""
    (tmp_path / "m.mtl").write_text("newmtl a\nKd 1 0 0\n")
    (tmp_path / "m.obj").write_text("mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\n" + "f 1 2 3\n" * 40_000)
    assert_built(tmp_path, scene(tmp_path, '[[objects]]\nobj = "m.obj"\n' * 5000))


def test_islands_of_few_faces_and_many_cells(tmp_path):
    text = "".join(f'[[objects]]\nsolid = "island"\ncells = [200, 200]\nsea = 0.9\nseed = {seed}\n' for seed in range(200))
    assert_ended(tmp_path, scene(tmp_path, text))


def test_a_long_list_of_textures_on_many_copies(tmp_path):
    names = ", ".join(['"t0"'] * 40_000)
    text = textures(['pattern = "crate"\nsize = [4, 4]']).replace(BOX, "") + \
        f'[[objects]]\nsolid = "tile"\ntextures = [{names}]\nring = {{ count = 1000, radius = 9 }}\n'
    assert_built(tmp_path, scene(tmp_path, text))


def test_a_solid_of_very_many_faces_with_a_texture(tmp_path):
    text = textures(['pattern = "bricks"']).replace(BOX, "") + \
        '[[objects]]\nsolid = "floor"\ncells = [200, 200]\ntexture = "t0"\n'
    assert_ended(tmp_path, scene(tmp_path, text))


# --- much of several things -------------------------------------------------------------------

NOISE = '[[textures]]\nname = "t0"\nfile = "noise.png"\nmost_colours = 255\n'
BRICKS = '[[textures]]\nname = "t0"\npattern = "bricks"\n'


def item(*lines):
    return "\n".join(["[[objects]]", *lines, ""])


def box(*lines):
    return item('solid = "box"', *lines)


def copies(*count):
    return f"repeat = {{ count = {list(count)}, step = [0, 0, 0] }}"


RING = "ring = { count = 1000, radius = 9 }"
SPIN = "spin = { yaw = 2 }"
# What may take more than there is.
BEYOND = {
    "shapes": "".join(item('solid = "tile"', f"rotation = [0, {i}, {i}]", RING) for i in range(30)),
    "known shapes": item('solid = "tile"', RING) * 40,
    "motions": box("motion = { circle = 1, degrees = 2 }", copies(39, 1000, 1)),
    "spins": box("spin = { axis = [0, 1, 0], degrees = 3 }", copies(19, 1000, 1)),
    "rings that turn": box("ring = { count = 1000, radius = 9, turned = true }") * 40,
    "parents": box('name = "p"', "turn = 3") + box('parent = "p"') * 15_000,
    "faces, copies and motions": "".join(item('solid = "floor"', "cells = [30, 30]", f"rotation = [0, {i}, 0]") for i in range(43)) +
                                 box(copies(40, 600, 1)) + box(SPIN, copies(39, 1000, 1)),
    "corners": BRICKS + item('solid = "disc"', "sides = 24", 'texture = "t0"', RING),
    "short objects": "objects = [" + '{ solid = "box" }, ' * 54_000 + "]\n",
    "objects that turn": "objects = [" + '{ solid = "box", turn = 1 }, ' * 30_000 + "]\n",
    "solids": "".join(item('solid = "prism"', f"taper = {1 + i / 10_000}") for i in range(8000)),
    "colours of textures": NOISE + "".join(box(f"rotation = [{i}, {i}, {i}]", 'texture = "t0"') for i in range(300)),
    "keys": box("motion = { keys = [{ turn = 1e7, frames = 900000 }, {}] }"),
    "parts": item('solid = "floor"', "cells = [140, 140]", "parts = [64, 64]", copies(15, 1, 1)),
}
# What looks as hostile, and is not: the same is made once.
WITHIN = {
    "colours of a texture": NOISE + item('solid = "floor"', "cells = [60, 60]", 'texture = "t0"'),
    "copies": box(copies(65, 1000, 1)),
    "copies at fractions": box('position = ["1/999999999999999997", 0, 0]',
                               copies(65, 1000, 1).replace("[0, 0, 0]", '["1/99999999999999991", 0, 0]')),
    "one solid in six ways": "".join(item('solid = "floor"', "cells = [141, 141]", f'anchor = "{anchor}"', f'kind = "{kind}"')
                                     for anchor in ("origin", "base", "middle") for kind in ("convex", "sorted")),
    "a large solid": item('solid = "floor"', "cells = [190, 190]"),
    "motions": box("motion = { by = [1, 1, 1], frames = 9, back = true }", copies(6, 1000, 1)),
}


@pytest.mark.parametrize("name", BEYOND)
def test_beyond(tmp_path, name):
    noise(tmp_path, "noise.png", 64)
    assert_ended(tmp_path, scene(tmp_path, BEYOND[name]))


def test_keys_of_motions_are_counted_before_they_are_made(tmp_path):
    """A turn of ten million degrees between two keys needs a key in every few frames."""
    text = box("motion = { keys = [{ turn = 1e8, frames = 900000 }, {}] }")
    assert_refused(tmp_path, scene(tmp_path, text * 2), "1,000,000 keys together")


@pytest.mark.parametrize("name", WITHIN)
def test_within(tmp_path, name):
    noise(tmp_path, "noise.png", 64)
    assert_built(tmp_path, scene(tmp_path, WITHIN[name]))


def test_a_chain_of_parents(tmp_path):
    """Its depth was checked when the whole scene was packed."""
    text = box('name = "n0"', "turn = 3") + "".join(box(f'name = "n{i + 1}"', f'parent = "n{i}"') for i in range(8000))
    assert_refused(tmp_path, scene(tmp_path, text), 'object 9 ("n9")', "more than 8 parents")


def test_decimals_of_hundreds_of_digits(tmp_path):
    digits = "0.0" + "7" * 200
    text = box(f"position = [{digits}, 0, 0]", copies(65, 1000, 1).replace("0, 0, 0", f"{digits}, 0, 0"))
    assert_refused(tmp_path, scene(tmp_path, text), "a number has more than 24 characters")


def test_texels_take_little_memory(tmp_path):
    """Each was an object of its own while they were packed, which took a hundred bytes."""
    noise(tmp_path, "noise.png", 64)
    file = scene(tmp_path, NOISE + "".join(box(f"rotation = [{i}, {i}, {i}]", 'texture = "t0"') for i in range(60)))
    compiled, _ = compiler.compile_scene(str(file))
    texels = sum(len(texture.texels) for texture in compiled.surfaces.textures)
    tracemalloc.start()
    image.pack(compiled)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert texels > 500_000 and most < 20 * texels


# --- ranges that overlap ----------------------------------------------------------------------

RECORDS = 6000


def overlapping(kind, folder):
    """An image of half a megabyte with records of 400 MB and more."""
    source = CHECKOUT / "scenes" / {"textures": "room.toml", "sprites": "grove.toml"}[kind]
    compiled, _ = compiler.compile_scene(str(source))
    blob = image.pack(compiled)
    if kind == "textures":
        blob = replaced(blob, texels=bytes(87_384 + RECORDS), textures=b"".join(
            image_surface.TEXTURE.pack(i, 0, 8, 8, 0, 0, 0, 9, 0) for i in range(RECORDS)))
    else:
        boards = compiled.billboards.boards
        sides = [(one.width, one.height, one.anchor_x, one.anchor_y) for one in boards] + [(1, 1, 0, 0)] * (RECORDS - len(boards))
        blob = replaced(blob, sprite_pixels=bytes(65_536 + RECORDS), billboards=b"".join(
            image_billboard.BOARD.pack(i, 0, 256, 256, 256, 8, 0, *sides[i]) for i in range(RECORDS)))
    file = folder / "overlapping.fxls"
    file.write_bytes(blob)
    return file


@pytest.mark.parametrize("kind", ["textures", "sprites"])
def test_what_overlaps_is_not_copied(tmp_path, kind):
    """The loader takes such an image, so the tools do; as C each texture would be a table of its own."""
    file = overlapping(kind, tmp_path)
    code, said = run_bounded("info", file)
    assert code == 0 and f"{RECORDS}" in said, said
    out = tmp_path / "out.h"
    code, said = run_bounded("export", "--c", file, "--name", "a", "-o", out)
    assert code == 2 and "textures and sprites overlap" in said and not out.exists(), said


@pytest.mark.parametrize("name", ["room", "grove"])
def test_an_image_of_the_tools_is_exported(tmp_path, name):
    built = run_cli("build", CHECKOUT / "scenes" / f"{name}.toml", "-o", tmp_path / "a.fxls")
    assert built.returncode == 0, built.stderr
    for source, out in ((tmp_path / "a.fxls", "image.h"), (CHECKOUT / "scenes" / f"{name}.toml", "scene.h")):
        done = run_cli("export", "--c", source, "--name", "a", "-o", tmp_path / out)
        assert done.returncode == 0, done.stderr
    first, second = ((tmp_path / out).read_text().splitlines() for out in ("image.h", "scene.h"))
    assert [line for line in first if "_texels" in line or "_sprite" in line] == \
        [line for line in second if "_texels" in line or "_sprite" in line] != []


def test_many_small_textures_are_exported_in_time(tmp_path):
    """Their names were counted anew for each."""
    compiled, _ = compiler.compile_scene(str(CHECKOUT / "scenes/room.toml"))
    count = 12_000
    table = b"".join(struct.pack("<Q", number) for number in range(count))
    records = b"".join(image_surface.TEXTURE.pack(8 * i, 0, 3, 0, 0, 0, 0, 1, 0) for i in range(count))
    file = tmp_path / "small.fxls"
    file.write_bytes(replaced(image.pack(compiled), textures=records, texels=table))
    code, said = run_bounded("export", "--c", file, "--name", "a", "-o", tmp_path / "a.h")
    assert code == 0 and f"a_texels_{count - 1}[" in (tmp_path / "a.h").read_text(), said


# --- pictures ----------------------------------------------------------------------

def jpeg_of_scans(several):
    """A JPEG of 2048 x 2048 with thousands of empty scans; several: with a segment that says that the file holds more."""
    file = io.BytesIO()
    Image.new("RGB", (2048, 2048)).save(file, "JPEG", progressive=True)
    blob = file.getvalue()
    at = blob.rindex(b"\xff\xda")
    if not several:
        return blob[:at] + blob[at:-2] * 3000 + blob[-2:]
    blob = blob[:at] + blob[at:-2] * 3000 + blob[-2:]
    entries = b"".join(struct.pack("<IIIHH", flags, len(blob), 0, 0, 0) for flags in (0x030000, 0))
    tags = [(0xB000, 7, 4, b"0100"), (0xB001, 4, 1, struct.pack("<I", 2)), (0xB002, 7, len(entries), struct.pack("<I", 50))]
    table = b"II*\0" + struct.pack("<IH", 8, len(tags)) + \
        b"".join(struct.pack("<HHI", tag, kind, size) + value for tag, kind, size, value in tags) + bytes(4)
    segment = b"MPF\0" + table + entries
    return blob[:2] + b"\xff\xe2" + struct.pack(">H", len(segment) + 2) + segment + blob[2:]


@pytest.mark.parametrize("several", [False, True], ids=["JPEG", "MPO"])
def test_very_many_scans_in_every_kind_of_jpeg(tmp_path, several):
    picture = tmp_path / "scans.jpg"
    picture.write_bytes(jpeg_of_scans(several))
    with Image.open(picture) as opened:
        assert opened.format == ("MPO" if several else "JPEG")
    code, said = run_bounded("texture", picture, "-o", tmp_path / "out.h", "--size", "16x16", cpu=LITTLE)
    assert (code == 0) != (f"{picture}: at the stage 'reading the image'" in said), said
    assert_ended(tmp_path, scene(tmp_path, textures(['file = "scans.jpg"'])))


def test_a_plain_picture_has_few_comments(tmp_path):
    picture = tmp_path / "plain.ppm"
    picture.write_bytes(b"P3\n2 2\n255\n" + b"#\n" * texture_image.COMMENTS_MAX + b"1 2 3 4 5 6 7 8 9 10 11 12\n")
    code, said = run_bounded("texture", picture, "-o", tmp_path / "out.h")
    assert code == 0, said
    picture.write_bytes(b"P3\n2 2\n255\n" + b"#\n" * 2_000_000 + b"1 2 3 4 5 6 7 8 9 10 11 12\n")
    code, said = run_bounded("texture", picture, "-o", tmp_path / "out.h")
    assert code == 2 and "more than 64 comments" in said, said


def test_an_ordinary_picture_becomes_a_texture(tmp_path):
    picture = noise(tmp_path, "noise.png")
    code, said = run_bounded("texture", picture, "-o", tmp_path / "out.h", "--levels", "9")
    assert code == 0 and "noise_texture" in said, said


def test_what_is_no_picture_is_refused_in_the_same_words_each_time(tmp_path):
    picture = tmp_path / "words.png"
    picture.write_text("not a picture")
    first, second = (run_cli("texture", picture, "-o", tmp_path / "out.h") for _ in range(2))
    assert first.returncode == 2 and without_progress(first.stderr) == without_progress(second.stderr)
    assert "words.png: this image cannot be read; it must be" in first.stderr


# --- fonts -------------------------------------------------------------------------

BDF = """STARTFONT 2.1
FONTBOUNDINGBOX 8 8 0 0
STARTCHAR A
ENCODING 65
DWIDTH 8 0
BBX 1 1 0 0
BITMAP
80
{}ENDCHAR
ENDFONT
"""


@pytest.mark.parametrize("line", ["BBX 100 100 0 0\n", "BITMAP\n80\n"])
def test_a_character_has_one_box_and_one_picture(tmp_path, line):
    """A box after the picture made a header whose font reads outside its table."""
    file, out = tmp_path / "font.bdf", tmp_path / "font.h"
    file.write_text(BDF.format(""))
    assert run_cli("font", file, "-o", out).returncode == 0
    out.unlink()
    file.write_text(BDF.format(line))
    done = run_cli("font", file, "-o", out)
    assert done.returncode == 2 and "font.bdf:9: a second" in done.stderr and not out.exists()
