# SPDX-License-Identifier: MIT
"""Images of textures: which way up, greys of 16 bits, and those that cannot be read."""

import base64
import io
import struct
import zlib

import numpy
import pytest
from PIL import Image

from conftest import assert_one_sentence, run_cli
from fixel.model import texture_image
from model_files import SQUARE, glb, gltf

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


def build(folder, model, blob, *options):
    """fixel build of a model with an image."""
    (folder / "m.mtl").write_text("newmtl a\nKd 0 1 0\nmap_Kd skin.png\n")
    (folder / "skin.png").write_bytes(blob)
    (folder / model).write_bytes(MODELS[model](blob))
    return run_cli("build", folder / model, "-o", folder / "out.fxls", "--frames", 1, *options)


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("kind", UNREADABLE)
def test_an_image_that_cannot_be_read_is_a_note(tmp_path, model, kind):
    """The model is drawn in the colour of its material. --no-textures needs no image, and so no note."""
    blob, words = UNREADABLE[kind]
    done = build(tmp_path, model, blob)
    assert done.returncode == 0, done.stderr
    notes = [line for line in done.stderr.splitlines() if "colour of their material" in line]
    assert len(notes) == 1 and all(word in notes[0] for word in words), done.stderr
    assert model in notes[0] or "m.mtl:3" in notes[0]
    assert "no image is named" not in done.stderr
    done = build(tmp_path, model, blob, "--no-textures")
    assert done.returncode == 0 and "colour of their material" not in done.stderr


@pytest.mark.parametrize("model", MODELS)
def test_a_scene_that_asks_for_an_image_that_cannot_be_read_is_told_why(tmp_path, model):
    """It is the only one of the model."""
    blob, words = UNREADABLE[next(iter(UNREADABLE))]
    build(tmp_path, model, blob)
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
        done = build(tmp_path, "m.obj", blob)
        assert done.returncode == 0 and done.stderr.count("several frames") == count
        done = run_cli("texture", tmp_path / "skin.png", "-o", tmp_path / "out.h")
        assert done.returncode == 0 and done.stderr.count("several frames") == count
