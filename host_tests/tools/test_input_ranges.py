# SPDX-License-Identifier: MIT
"""Images whose textures or sprites overlap, pictures that hide their work, and a font that says its box twice.

The bounds are those of test_input_bounds.py."""

import io
import struct

from PIL import Image
import pytest

from conftest import CHECKOUT, run_cli, without_progress
# place field: images that are broken, for the tools
from scene_sections import replaced
from test_input_bounds import LITTLE, assert_ended, run_bounded
from test_input_work import noise, scene, textures
from fixel.image import image, image_billboard, image_surface
from fixel.model import texture_image
from fixel.scene import compiler

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
