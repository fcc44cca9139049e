# SPDX-License-Identifier: MIT
"""Textures: their images, which way up, greys of 16 bits, and those that cannot be read; what they show at the edges of faces, and which have
levels by default; and how large they are, as the path shows or as an option says."""

import base64
import io
import math
import random
import struct
import zlib
from fractions import Fraction

import numpy
import pytest
from PIL import Image

from conftest import assert_one_sentence, run_cli
from fixel.base.errors import ToolError
from fixel.image import image, image_surface
from fixel.model import texture_image
from fixel.scene import compiler, look, surfaces, texture_size
from fixel.scene.target import Target
from model_files import SQUARE, build, glb, gltf, png

BUILT_PROGRAMS = ()
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


# --- images that cannot be read ---------------------------------------------------------------------

UNREADABLE = {
    "DDS": (b"DDS " + bytes(124), ["DDS", "PNG"]), "TIFF": (file_of(PICTURE, "TIFF"), ["TIFF", "PNG"]),
    "PSD": (b"8BPS\0\1" + bytes(40), ["PSD", "PNG"]), "KTX2": (b"\xabKTX 20\xbb\r\n\x1a\n" + bytes(60), ["KTX", "PNG"]),
    "AVIF": (b"\0\0\0 ftypavif" + bytes(40), ["AVIF", "PNG"]), "brand": (b"\0\0\0 ftypmif1\0\0\0\0mif1avif" + bytes(40), ["AVIF", "PNG"]),
    "cut off": (file_of(PICTURE)[:40], ["cannot be read", "PNG"]), "empty": (b"", ["empty", "PNG"]),
    "model": (b"BLENDER-v293" + bytes(90), ["Blender"]), "noise": (b"noise" * 20, ["cannot be read", "PNG"])}
OBJ = """\
mtllib m.mtl
v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0
vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1
usemtl a\nf 1/1 2/2 3/3 4/4
"""
PLY = ("ply\nformat ascii 1.0\ncomment TextureFile skin.png\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
       "property float s\nproperty float t\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
       "0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n")


def _gltf(image):
    """A glTF file whose material is green: what names the image, and its bytes."""
    def change(blob):
        data, buffer = gltf(*SQUARE, uvs=[(0, 0), (1, 0), (1, 1), (0, 1)], image=blob, material={"baseColorFactor": [0, 1, 0, 1]})
        if image:
            data["images"] = [{"uri": image(blob)}]
        return glb(data, buffer)
    return change


# {name of the model: its bytes by those of the image}. The image stands beside it, too.
MODELS = {
    "m.obj": lambda _: OBJ.encode(), "m.ply": lambda _: PLY.encode(), "view.glb": _gltf(None), "beside.glb": _gltf(lambda _: "skin.png"),
    "data.glb": _gltf(lambda blob: "data:image/png;base64," + base64.b64encode(blob).decode())}


def built_model(folder, model, blob, *options):
    """fixel build of a model with an image."""
    (folder / "m.mtl").write_text("newmtl a\nKd 0 1 0\nmap_Kd skin.png\n")
    (folder / "skin.png").write_bytes(blob)
    (folder / model).write_bytes(MODELS[model](blob))
    return run_cli("build", folder / model, "-o", folder / "out.fxls", "--frames", 1, *options)


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("kind", UNREADABLE)
def test_an_image_that_cannot_be_read_is_a_note(tmp_path, model, kind):
    """The model is drawn in the colour of its material: with --no-textures in the place of the image's mean colour."""
    blob, words = UNREADABLE[kind]
    for options in ((), ("--no-textures",)):
        done = built_model(tmp_path, model, blob, *options)
        assert done.returncode == 0, done.stderr
        notes = [line for line in done.stderr.splitlines() if "colour of their material" in line]
        assert len(notes) == 1 and all(word in notes[0] for word in words), done.stderr
        assert model in notes[0] or "m.mtl:3" in notes[0]
        assert "no image is named" not in done.stderr


@pytest.mark.parametrize("model", MODELS)
def test_a_scene_that_asks_for_an_image_that_cannot_be_read_is_told_why(tmp_path, model):
    """It is the only one of the model."""
    blob, words = UNREADABLE[next(iter(UNREADABLE))]
    built_model(tmp_path, model, blob)
    (tmp_path / "scene.toml").write_text(f'[[objects]]\nmodel = "{model}"\nimages = true\n')
    done = run_cli("build", tmp_path / "scene.toml", "-o", tmp_path / "other.fxls")
    assert_one_sentence(done, "scene.toml", "images", *words)
    assert not (tmp_path / "other.fxls").exists()


@pytest.mark.parametrize("what", ["folder", "gone"])
def test_an_image_that_is_no_file_is_a_note(tmp_path, what):
    (tmp_path / "m.obj").write_text(OBJ)
    (tmp_path / "m.mtl").write_text("newmtl a\nKd 0 1 0\nmap_Kd skin\n")
    if what == "folder":
        (tmp_path / "skin").mkdir()
    done = run_cli("build", tmp_path / "m.obj", "-o", tmp_path / "out.fxls", "--frames", 1)
    assert done.returncode == 0 and sum("m.mtl:3" in line and "skin" in line for line in done.stderr.splitlines()) == 1


@pytest.mark.parametrize("kind", UNREADABLE)
def test_an_image_that_a_command_or_a_scene_names_is_refused(tmp_path, kind):
    """There is no material whose colour could take its place."""
    blob, words = UNREADABLE[kind]
    (tmp_path / "skin.png").write_bytes(blob)
    assert_one_sentence(run_cli("texture", tmp_path / "skin.png", "-o", tmp_path / "out.h"), "skin.png", *words)
    (tmp_path / "s.toml").write_text('[[textures]]\nname = "t"\nfile = "skin.png"\n[path]\norbit = { radius = 4 }\n'
                                     '[[objects]]\nsolid = "box"\ntexture = "t"\n')
    assert_one_sentence(run_cli("build", tmp_path / "s.toml", "-o", tmp_path / "out.fxls"), "skin.png", *words)
    assert not (tmp_path / "out.h").exists() and not (tmp_path / "out.fxls").exists()


@pytest.mark.parametrize("kind", ["GIF", "WEBP", "PNG"])
def test_of_several_frames_the_first_is_shown_and_said(tmp_path, kind):
    frames = [Image.new("RGB", (8, 8), colour) for colour in ((250, 0, 0), (0, 250, 0))]
    several = file_of(frames[0], kind, save_all=True, append_images=frames[1:])
    for blob, count in ((several, 1), (file_of(frames[0], kind), 0)):
        found = texture_image.decode(blob, "m")
        assert len(found.notes) == count and found.pixels[0, 0, 0] > 200
        done = built_model(tmp_path, "m.obj", blob)
        assert done.returncode == 0 and done.stderr.count("several frames") == count
        done = run_cli("texture", tmp_path / "skin.png", "-o", tmp_path / "out.h")
        assert done.returncode == 0 and done.stderr.count("several frames") == count


# --- sizes ------------------------------------------------------------------------------------

NOISE = [[((37 * x + 91 * y) % 256 & 0xC0, (53 * x * y) % 256 & 0xC0, (11 * x + 7 * y * y) % 256 & 0xC0) for x in range(256)] for y in range(256)]
FOCAL = 160 / math.tan(math.radians(37.5))
WALL = """
[[textures]]
name = "noise"
file = "noise.png"
{size}
[[objects]]
solid = "tile"
rotation = [0, -90, 0]
scale = [4, 1, 4]
texture = "noise"
{more}
[path]
keys = [{{ position = [0, 0, -{far}], frames = 20 }}, {{ position = [0, 0, -{near}] }}]
"""


def sides(scene):
    """Of each texture."""
    return [(1 << each.log_width, 1 << each.log_height) for each in scene.surfaces.textures]


def wall(tmp_path, size, far, near, more="", pixels=256):
    (tmp_path / "noise.png").write_bytes(png([row[:pixels] for row in NOISE[:pixels]]))
    (tmp_path / "s.toml").write_text(WALL.format(size=size, far=far, near=near, more=more))
    made, notes = compiler.compile_scene(str(tmp_path / "s.toml"))
    assert image.unpack(image.pack(made)) == made
    return sides(made), notes


@pytest.mark.parametrize("shown, side", [(300, 256), (129, 256), (127, 128), (65, 128), (63, 64), (9, 16)])
def test_a_wall_has_as_many_texels_as_the_nearest_pose_shows_pixels(tmp_path, shown, side):
    near = 4 * FOCAL / shown        # a wall of 4 units is so many pixels wide
    found, notes = wall(tmp_path, 'size = "path"', 1.5 * near, near)
    assert found == [(side, side)] and any(f"no more than {side} texels a side" in note for note in notes)


def test_without_a_size_a_file_keeps_its_own(tmp_path):
    assert wall(tmp_path, "", 90, 60)[0] == [(256, 256)]


@pytest.mark.parametrize("pixels, size, side", [(256, 64, 64), (200, 256, 256), (100, 32, 32), (16, 64, 16)])
def test_a_size_is_the_most_of_a_side(tmp_path, pixels, size, side):
    assert wall(tmp_path, f"size = {size}", 9, 6, pixels=pixels)[0] == [(side, side)]


@pytest.mark.parametrize("size, more, words", [
    ("size = 48", "", ["size", "48", "256"]), ('size = "all"', "", ["size", '"all"', "256"]), ("size = [64, 64]", "", ["size", "[64, 64]", '"path"']),
    ('size = "path"', "texels_per_unit = 4", ["texels_per_unit", '"noise"', "object 0"]),
    ('size = "path"', "texel_offset = [1, 2]", ["texel_offset", "number"])])
def test_sizes_that_are_wrong(tmp_path, size, more, words):
    with pytest.raises(ToolError) as caught:
        wall(tmp_path, size, 9, 6, more)
    assert all(word in str(caught.value) for word in words)


def test_what_moves_and_what_a_player_walks_keeps_its_size(tmp_path):
    for more in ("spin = { yaw = 3 }", ""):
        text = WALL.format(size='size = "path"', far=90, near=60, more=more)
        if not more:
            text = text.partition("[path]")[0] + '[path]\nstart = { position = [0, 0, -90] }\nsteps = [{ keys = ["forward"], frames = 4 }]\n'
        (tmp_path / "noise.png").write_bytes(png(NOISE))
        (tmp_path / "s.toml").write_text(text)
        assert sides(compiler.compile_scene(str(tmp_path / "s.toml"))[0]) == [(256, 256)]


def model(tmp_path):
    """A square with a picture of 256 x 256."""
    (tmp_path / "m.glb").write_bytes(glb(*gltf(*SQUARE, uvs=[(0, 0), (1, 0), (1, 1), (0, 1)], image=png(NOISE))))
    return tmp_path / "m.glb"


def test_a_model_alone_has_what_its_circle_shows(tmp_path):
    file = model(tmp_path)
    for screen, side in (((320, 240), 256), ((160, 120), 128), ((64, 48), 64)):
        made, _ = compiler.compile_scene(str(file), 4, screen, look=look.Look())
        assert sides(made) == [(side, side)]
    made, _ = compiler.compile_scene(str(file), 4, (64, 48), look=look.of(look.Asked(texture=128), "rgb565", 16, 128))
    assert sides(made) == [(128, 128)]
    assert texture_size.needed(made) == {1: (64, 64)}


def test_the_option_gives_the_most_and_no_more_is_tried(tmp_path):
    file, out = model(tmp_path), tmp_path / "out.fxls"
    for words, side in ((["--texture", "32"], 32), (["--look", "--texture 8"], 8), ([], 256)):
        done = run_cli("build", file, "-o", out, *words)
        assert done.returncode == 0, done.stderr
        assert sides(image.load(out)) == [(side, side)]
    wanted = look.smaller(look.Asked(texture=64), "rgb565", 16)
    assert [(each.texels, each.is_fixed) for each in wanted] == [(64, True), (32, False), (16, False), (0, False), (0, False), (0, False)]
    assert [each.animation for each in wanted] == [""] * 5 + ["none"], "what moves is left out last"
    assert look.best(look.Asked(texture=64), Target(), False).texels == 64


def test_the_scene_file_of_a_model_has_the_size(tmp_path):
    file = model(tmp_path)
    done = run_cli("build", file, "-o", tmp_path / "a.fxls", "--screen", "64x48", "--write", tmp_path / "s.toml")
    assert done.returncode == 0, done.stderr
    assert run_cli("build", tmp_path / "s.toml", "-o", tmp_path / "b.fxls").returncode == 0
    assert (tmp_path / "a.fxls").read_bytes() == (tmp_path / "b.fxls").read_bytes() and "size = 64" in (tmp_path / "s.toml").read_text()


@pytest.mark.parametrize("words, said", [(["--texture", "48"], "power of two"), (["--texture", "512"], "power of two"),
                                         (["--texture", "64", "--no-textures"], "exclude each other")])
def test_options_that_are_wrong(tmp_path, words, said):
    done = run_cli("build", model(tmp_path), "-o", tmp_path / "out.fxls", *words)
    assert done.returncode == 2 and said in done.stderr


def test_two_textures_of_one_file_have_a_size_each(tmp_path):
    """The second had one texel; and where both need the same, one is stored."""
    (tmp_path / "noise.png").write_bytes(png(NOISE))
    near = 4 * FOCAL / 200
    for far, found in ((4, [(256, 256), (64, 64)]), (1, [(256, 256)])):
        rows = "".join(f'[[textures]]\nname = "{name}"\nfile = "noise.png"\nsize = "path"\n' for name in "ab")
        walls = "".join(f'[[objects]]\nsolid = "tile"\nrotation = [0, -90, 0]\nscale = [4, 1, 4]\nposition = [{x}, 0, {(away - 1) * near}]\n'
                        f'texture = "{name}"\nshade = false\n' for name, x, away in (("a", -2, 1), ("b", 2, far)))
        (tmp_path / "s.toml").write_text(rows + walls + f"[path]\nkeys = [{{ position = [0, 0, -{near}] }}]\n")
        assert sides(compiler.compile_scene(str(tmp_path / "s.toml"))[0]) == found


def test_the_file_of_a_texture_may_have_as_many_pixels_as_an_image(tmp_path):
    """A file of more than 4 MiB, which was refused."""
    Image.fromarray(numpy.zeros((1500, 1200, 3), dtype=numpy.uint8)).save(tmp_path / "large.bmp")
    assert (tmp_path / "large.bmp").stat().st_size > 5 << 20
    (tmp_path / "s.toml").write_text('[[textures]]\nname = "t"\nfile = "large.bmp"\n[[objects]]\nsolid = "box"\ntexture = "t"\nshade = false\n')
    assert sides(compiler.compile_scene(str(tmp_path / "s.toml"))[0]) == [(256, 256)]


# --- edges and levels -------------------------------------------------------------------------

TEXTURE = '[[textures]]\nname = "t"\npattern = "checker"\nsize = [16, 8]\n'
TILE = '[[objects]]\nsolid = "tile"\nposition = [0, -1, 5]\ntexture = "t"\n'
CORNERS = [(0, 0, 0), (9, 0, 0), (9, 9, 0), (0, 9, 0)]
MARGIN = surfaces.edge_margin(16, 1, image_surface.DIVIDE_16)


def kept(*coordinates, margin=MARGIN):
    """Those of a face of three or four corners on a texture of 16 x 8 texels that repeats."""
    values = [tuple(map(Fraction, corner)) for corner in coordinates]
    return surfaces.within_edges(CORNERS[:len(values)], values, (0, 1, 2), (16, 8), margin)


@pytest.mark.parametrize("division, between", [(image_surface.DIVIDE_16, 0.3), (image_surface.DIVIDE_8, 0.075), (image_surface.DIVIDE_1, 0)])
def test_a_margin_is_what_a_coordinate_may_be_off(division, between):
    """What SPEC.md, 9.2, allows between two divisions, and rounding, which grows with the texture and with its levels."""
    for side, levels in ((8, 1), (64, 4), (256, 4), (256, 8)):
        rounding = surfaces.edge_margin(side, levels, division) - Fraction(between)
        assert 9 * side / 65536 + 2 ** (levels - 1) / 256 < rounding < 20 * side / 65536 + 2 ** levels / 256


def test_what_ends_at_an_edge_of_a_texture_that_repeats_stays_on_its_side():
    m = MARGIN
    assert kept((0, 0), (16, 0), (16, 8), (0, 8)) == [(m, m), (16 - m, m), (16 - m, 8 - m), (m, 8 - m)]
    assert kept((-16, 8), (32, 8), (32, 24)) == [(m - 16, 8 + m), (32 - m, 8 + m), (32 - m, 24 - m)]     # three times, from its edges on
    assert kept((0, 1), (5, 1), (5, 7)) == [(m, 1), (5, 1), (5, 7)]
    assert kept((Fraction(-1, 200), 1), (5, 1), (5, 7))[0] == (m, 1)     # a file's rounding beyond the edge
    for crosses in ([(3, 1), (20, 1), (20, 7)], [(-1, 1), (15, 1), (15, 7)], [(8, 1), (Fraction(161, 10), 1), (12, 7)]):
        assert kept(*crosses) == crosses                                 # it shows both sides


def test_what_lies_on_an_edge_or_within_its_margin_shows_one_column():
    narrow = Fraction(1, 10)
    assert kept((0, 1), (narrow, 1), (0, 7)) == [(MARGIN, 1), (MARGIN, 1), (MARGIN, 7)]
    assert kept((16, 1), (16 - narrow, 1), (16, 7)) == [(16 - MARGIN, 1), (16 - MARGIN, 1), (16 - MARGIN, 7)]
    assert {u for u, _ in kept((0, 1), (0, 2), (0, 7))} == {MARGIN} and {u for u, _ in kept((16, 1), (16, 2), (16, 7))} == {16 - MARGIN}


def test_kept_coordinates_are_affine_and_hardly_move():
    """Also where a parallelogram has one corner at an edge. Faces of three corners that share one agree about it."""
    chance, touched = random.Random(48), 0
    for _ in range(300):
        (a, b), (c, d), (e, f) = ((chance.choice((0, 1, 4, 8, 12, 16)), chance.choice((0, 1, 3, 6, 8))) for _ in range(3))
        face = [(a, b), (c, d), (c + e - a, d + f - b), (e, f)]
        found = kept(*face)
        touched += found != face
        (p, q), (r, s), (t, u), (v, w) = found
        assert abs(p + t - r - v) <= surfaces.BEND_MAX and abs(q + u - s - w) <= surfaces.BEND_MAX
        assert all(abs(x - y) <= MARGIN for one, other in zip(face, found) for x, y in zip(one, other))
    assert touched > 100
    one, other = kept((0, 1), (5, 0), (9, 3)), kept((0, 1), (9, 3), (2, 8))
    assert one[0] == other[0] == (MARGIN, 1) and one[2] == other[1]


def test_a_texture_that_clamps_keeps_its_coordinates(tmp_path):
    whole, moved = ([(u / 65536, v / 65536) for u, v in build(tmp_path, TEXTURE + says + TILE).models[0].faces[0].mapped.texels]
                    for says in ('wrap = "clamp"\n', ""))
    assert {u for u, _ in whole} == {0, 16} and {v for _, v in whole} == {0, 8}
    assert all(0.3 < u < 15.7 and 0.3 < v < 7.7 for u, v in moved)


@pytest.mark.parametrize("shown", ['texture = "t"', 'textures = ["", "t"]'])
@pytest.mark.parametrize("solid, said, levels", [("floor", "", 5), ("floor", "levels = 1\n", 1), ("floor", "levels = 3\n", 3), ("tile", "", 1)])
def test_a_texture_of_a_floor_has_levels_unless_it_says_otherwise(tmp_path, solid, said, levels, shown):
    """A texture that another solid shows has one level."""
    shown = shown if solid == "floor" else 'texture = "t"'
    scene = build(tmp_path, TEXTURE + said + f'[[objects]]\nsolid = "{solid}"\nscale = [8, 1, 8]\nposition = [0, -1, 5]\n{shown}\n')
    assert [each.levels for each in scene.surfaces.textures] == [levels]


def big_png(width, height):
    """A sound head that promises a large image."""
    def part(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return b"\x89PNG\r\n\x1a\n" + part(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) + \
        part(b"IDAT", zlib.compress(b"")) + part(b"IEND", b"")


@pytest.mark.parametrize("size", [(60_000, 60_000), (8193, 1), (1, 8193)])
def test_images_of_absurd_sizes(size):
    with pytest.raises(ToolError, match=f"an image of ({size[0]}x{size[1]}|very many) pixels; both sides must be 1..8192"):
        texture_image.decode(big_png(*size), "big.png")


def test_an_image_of_more_than_2048_pixels_is_shrunk_by_whole_factors():
    pixels = numpy.zeros((3, 4098, 3), dtype=numpy.uint8)
    pixels[:, 3:6] = 90
    made = texture_image.decode(png(pixels), "wide.png")
    assert (made.width, made.height) == (1366, 1) and made.pixels[0, :3, 0].tolist() == [0, 90, 0]
    assert texture_image.decode(png(pixels[:, :2048]), "a.png").width == 2048


def test_an_image_of_as_many_bytes_as_are_allowed(monkeypatch):
    blob = png([[(1, 2, 3)]])
    monkeypatch.setattr(texture_image, "FILE_MAX", len(blob))
    assert texture_image.decode(blob, "a.png").pixels.tolist() == [[[1, 2, 3, 255]]]
    with pytest.raises(ToolError, match=f"an image of {len(blob) + 1} bytes is more than the limit"):
        texture_image.decode(blob + b"x", "a.png")
