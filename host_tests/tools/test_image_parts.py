# SPDX-License-Identifier: MIT
"""Faces that show one colour of an image need no texture, and of others a texture has the part that faces show."""

import random

import numpy
import pytest
from PIL import Image

from fixel.image import image, image_surface
from fixel.model import texture_image
from fixel.scene import compiler, image_cut, look
from fixel.scene.palette import rgb565
from model_files import glb, gltf, png
from test_model_files import colours, compiled

BUILT_PROGRAMS = ()


def texture(pixels):
    """An image of rows of red, green, blue, alpha or of red, green, blue."""
    pixels = numpy.array(pixels, dtype=numpy.uint8)
    alpha = numpy.full((*pixels.shape[:2], 4 - pixels.shape[2]), 255, dtype=numpy.uint8)
    return texture_image.Texture("t", numpy.concatenate([pixels, alpha], axis=2))


def atlas(side, cells, seed=1):
    """An image of cells by cells of one colour each, side texels wide; and their colours."""
    found = numpy.random.default_rng(seed).integers(0, 256, (cells, cells, 3), dtype=numpy.uint8)
    return found.repeat(side // cells, axis=0).repeat(side // cells, axis=1), found


def squares(count):
    """(vertices, triangles) of so many unit squares in a row, with gaps."""
    points = [(2 * i + x, y, 0) for i in range(count) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return points, [tuple(4 * i + c for c in three) for i in range(count) for three in ((0, 1, 2), (0, 2, 3))]


def scene_of(folder, uvs, pixels, **more):
    """The scene of squares with these coordinates, four each, without light."""
    points, triangles = squares(len(uvs) // 4)
    more = "".join(f"{key} = {value}\n" for key, value in more.items()) or "images = true\n"
    return compiled(folder, f'[[objects]]\nmodel = "m.glb"\nshade = false\nmerge = false\n{more}',
                    m_glb=glb(*gltf(points, triangles, uvs=uvs, image=png(pixels))))[0]


def test_colours_of_a_palette_of_256_texels_are_exact(tmp_path):
    """The case that was tried: points of a palette of 256 x 1, which a texture of 64 x 1 would mix."""
    pixels, _ = numpy.random.default_rng(2).integers(0, 256, (1, 256, 3), dtype=numpy.uint8), None
    chosen = range(0, 256, 17)
    made = scene_of(tmp_path, [((i + 0.5) / 256, 0.5) for i in chosen for _ in range(4)], pixels)
    assert made.surfaces is None
    assert colours(made) == {tuple(pixels[0, i].tolist()) for i in chosen}


@pytest.mark.parametrize("inset", [0, 0.3])
def test_cells_of_an_atlas_that_faces_fill_exactly_are_one_colour(tmp_path, inset):
    pixels, cells = atlas(256, 8)
    uvs = [((x + (inset, 1 - inset)[right]) / 8, (y + (inset, 1 - inset)[low]) / 8) for x, y in ((0, 0), (3, 5), (7, 7))
           for right, low in ((0, 1), (1, 1), (1, 0), (0, 0))]
    made = scene_of(tmp_path, uvs, pixels)
    assert made.surfaces is None and colours(made) == {tuple(cells[y, x].tolist()) for x, y in ((0, 0), (3, 5), (7, 7))}


@pytest.mark.parametrize("side, cells", [(64, 7), (1024, 13), (3000, 11), (4096, 13)])
def test_cells_of_any_width_are_one_colour_in_a_file_of_six_digits(tmp_path, side, cells):
    """Also of an image that is shrunk as it is read: its texels are those of the whole image."""
    ends = numpy.linspace(0, side, cells + 1).astype(int)
    shades = numpy.random.default_rng(13).integers(0, 256, (cells, cells, 3), dtype=numpy.uint8)
    Image.fromarray(shades.repeat(numpy.diff(ends), axis=0).repeat(numpy.diff(ends), axis=1)).save(tmp_path / "m.png")
    chosen = [(x, y) for y in range(cells) for x in range(cells)][:100]
    lines = ["mtllib m.mtl", "usemtl a"]
    for i, (x, y) in enumerate(chosen):
        lines += [f"v {2 * i + a} {b} 0" for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
        lines += [f"vt {ends[x + a] / side:.6f} {1 - ends[y + b] / side:.6f}" for a, b in ((0, 1), (1, 1), (1, 0), (0, 0))]
        lines.append("f " + " ".join(f"{4 * i + c}/{4 * i + c}" for c in (1, 2, 3, 4)))
    (tmp_path / "m.obj").write_text("\n".join([*lines, ""]))
    (tmp_path / "m.mtl").write_text("newmtl a\nmap_Kd m.png\n")
    (tmp_path / "s.toml").write_text('[view]\npixels = "rgb565"\n[[objects]]\nmodel = "m.obj"\nshade = false\nmerge = false\n'
                                     'images = { bits = 16 }\n')
    made, _ = compiler.compile_scene(str(tmp_path / "s.toml"))
    assert made.surfaces is None and colours(made) == {tuple(shades[y, x].tolist()) for x, y in chosen}


def test_a_small_part_of_a_large_image_keeps_its_texels(tmp_path):
    """It is cut out before anything is scaled."""
    pixels = numpy.zeros((4096, 4096, 3), dtype=numpy.uint8)
    pixels[101:121, 301:331] = numpy.random.default_rng(14).integers(0, 256, (20, 30, 3))
    whole = texture_image.decode(png(pixels), "t")
    assert (whole.width, whole.whole().width) == (2048, 4096)
    found = image_cut.Outlines(whole.whole(), [rectangle(301, 101, 331, 121, 4096, 4096)], False)
    ((cut, numbers),) = image_cut.cuts(found, 256)
    assert (image_cut.canvas(found, cut, numbers).pixels[2:22, 2:32, :3] == pixels[101:121, 301:331]).all()


@pytest.mark.parametrize("by, plain", [(4, True), (5, False)])
def test_how_far_the_texels_of_one_colour_may_differ(by, plain):
    found = image_cut.colours(texture([[(100, 100, 100), (100 + by, 100, 100)]]), [[(0, 0), (1, 0), (1, 1), (0, 1)]])
    assert found == [(102, 100, 100) if plain else None]


def test_a_texel_between_the_places_of_a_sample_is_seen():
    """A face over 200 x 200 texels of which one differs."""
    pixels = numpy.full((200, 200, 3), 90)
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    for x, y in ((0, 0), (3, 190), (101, 77), (199, 199)):
        changed = pixels.copy()
        changed[y, x] = 200
        assert image_cut.colours(texture(changed), [square, [(0, 0), (0.001, 0), (0, 0.001)]])[0] is None
    assert image_cut.colours(texture(pixels), [square]) == [(90, 90, 90)]


def test_texels_beside_a_triangle_do_not_count():
    """Only those that it touches, judged point by point."""
    rng = numpy.random.default_rng(3)
    for _ in range(40):
        three = rng.uniform(0, 12, (3, 2))
        touched = numpy.zeros((12, 12), dtype=bool)
        for s, t in rng.uniform(0, 1, (4000, 2)):
            s, t = (1 - s, 1 - t) if s + t > 1 else (s, t)
            x, y = three[0] + s * (three[1] - three[0]) + t * (three[2] - three[0])
            touched[int(y), int(x)] = True
        pixels = numpy.where(touched[..., None], 50, 200) * numpy.ones(3)
        found = image_cut.colours(texture(pixels), [(three / 12).tolist()])[0]
        grown = numpy.pad(touched, 1)
        near = sum(grown[1 + a:13 + a, 1 + b:13 + b] for a in (-1, 0, 1) for b in (-1, 0, 1)) > 0
        near_alone = image_cut.colours(texture(numpy.where(near[..., None], 50, 200) * numpy.ones(3)), [(three / 12).tolist()])[0]
        assert near_alone == (50, 50, 50) and found in ((50, 50, 50), None)


def shown(made, face, place=(0.5, 0.25)):
    """(the colour of RGB565 that a face shows at a place between three of its corners, whether it is a texel)."""
    number = made.surfaces.surfaces[face.mapped.surface].texture if face.mapped else 0
    if not number:
        return rgb565(made.palette[face.colour]), False
    one = made.surfaces.textures[number - 1]
    texels = numpy.array(face.mapped.texels, dtype=float) / 65536
    u, v = texels[0] + place[0] * (texels[1] - texels[0]) + place[1] * (texels[2] - texels[0])
    number = (int(v) % (1 << one.log_height) << one.log_width) + int(u) % (1 << one.log_width)
    return int.from_bytes(one.texels[2 * number:2 * number + 2], "little"), True


def test_of_very_many_colours_the_most_frequent_are_flat(tmp_path, monkeypatch):
    """The palette has no room for more; the others are texels of one picture, which nothing mixes."""
    from fixel.scene import toml_images
    monkeypatch.setattr(toml_images, "PLAIN_MAX", 2)
    pixels = [[(10, 20, 30), (90, 20, 30), (10, 99, 30), (9, 9, 99)]]
    uvs = [((i + 0.5) / 4, 0.5) for i in (0, 1, 1, 2, 3, 3, 3) for _ in range(4)]
    (tmp_path / "m.glb").write_bytes(glb(*gltf(*squares(7), uvs=uvs, image=png(pixels))))
    for bits, flat in ((16, 10), (8, 14)):      # texels of 8 bits are of the palette themselves
        (tmp_path / "s.toml").write_text('[view]\npixels = "rgb565"\n[[objects]]\nmodel = "m.glb"\nshade = false\nmerge = false\n'
                                         f'images = {{ size = 4, bits = {bits} }}\n')
        made, _ = compiler.compile_scene(str(tmp_path / "s.toml"))
        plain = [made.palette[face.colour] for face in made.models[0].faces if face.mapped is None]
        assert {(9, 9, 99), (90, 20, 30)} <= set(plain) and len(plain) == flat and len(made.models[0].faces) == 14
        others = {shown(made, face)[0] for face in made.models[0].faces if face.mapped}
        assert others == ({1 << 11 | 5 << 5 | 4, 1 << 11 | 24 << 5 | 4} if bits == 16 else set())


@pytest.mark.parametrize("pixels", ["rgb565", "palette"])
def test_all_cells_of_a_palette_of_256_colours_have_their_own(tmp_path, pixels):
    """More colours than the palette of a scene has room for, each on a face that fills its cell to the border."""
    row = numpy.random.default_rng(7).integers(0, 256, (1, 256, 3), dtype=numpy.uint8)
    uvs = [(x / 256, y) for i in range(256) for x, y in ((i, 0), (i + 1, 0), (i + 1, 1), (i, 1))]
    (tmp_path / "m.glb").write_bytes(glb(*gltf(*squares(256), uvs=uvs, image=png(row))))
    made, _ = compiler.compile_scene(str(tmp_path / "m.glb"), 2, look=look.Look(pixels))
    model, bits = made.models[0], numpy.array([31, 63, 31])
    for face in model.faces:
        left = min(model.vertices[corner][0] for corner in face.corners) - min(x for x, _, _ in model.vertices)
        cell = round(left / (max(x for x, _, _ in model.vertices) - min(x for x, _, _ in model.vertices)) * 511 / 2)
        value, _ = shown(made, face)
        found = numpy.array([value >> 11, value >> 5 & 63, value & 31]) * 255 / bits
        assert abs(found - row[0, cell]).max() < 9, cell
    assert made.surfaces is None or [(each.log_width, each.log_height, each.levels) for each in made.surfaces.textures] == [(4, 4, 1)]
    divisions = {each.division for each in made.surfaces.surfaces if each.texture} if made.surfaces else {image_surface.AFFINE}
    assert divisions == {image_surface.AFFINE}      # one texel all over a face


def test_what_is_clear_keeps_its_texture():
    clear = [[(9, 9, 9, 0)] * 4] * 4
    assert image_cut.colours(texture(clear), [[(0, 0), (1, 0), (1, 1)]]) == [None]


def cut_of(pixels, outlines, size=256, clamp=False):
    """The cuts of an image and the outlines on it."""
    found = image_cut.Outlines(texture(pixels), outlines, clamp)
    return image_cut.cuts(found, size), found


def canvas_of(pixels, outlines, size=256, clamp=False):
    """The canvas of the only cut."""
    ((cut, numbers),), found = cut_of(pixels, outlines, size, clamp)
    return image_cut.canvas(found, cut, numbers).pixels[..., :3]


def rectangle(left, top, right, bottom, width, height):
    """An outline of texels of an image of so many."""
    return [(x / width, y / height) for x, y in ((left, top), (right, top), (right, bottom), (left, bottom))]


def test_a_texture_is_cut_to_what_faces_show_and_padded():
    """By 2 texels, which have the colours of the nearest that are shown: not of what lies beside them in the image."""
    pixels = numpy.random.default_rng(4).integers(0, 256, (64, 128, 3), dtype=numpy.uint8)
    square = rectangle(32, 16, 64, 32, 128, 64)
    moved = [(u + 3, v - 2) for u, v in square]     # by whole images
    for outlines in ([square], [square, moved]):
        ((cut, numbers),), found = cut_of(pixels, outlines)
        assert (cut.across.side, cut.down.side, cut.clamps, numbers) == (64, 32, False, list(range(len(outlines))))
        for number in numbers:
            assert numpy.allclose(image_cut.within(found, cut, number),
                                  [(2 / 64, 2 / 32), (34 / 64, 2 / 32), (34 / 64, 18 / 32), (2 / 64, 18 / 32)])
    shown = canvas_of(pixels, [square])
    assert (shown[2:18, 2:34] == pixels[16:32, 32:64]).all()
    assert (shown[:3, 2:34] == pixels[16, 32:64]).all() and (shown[17:, 2:34] == pixels[31, 32:64]).all()
    assert (shown[2:18, :3] == pixels[16:32, 32:33]).all() and (shown[2:18, 33:] == pixels[16:32, 63:64]).all()


def test_what_is_not_cut():
    pixels = numpy.zeros((64, 128, 3))
    assert cut_of(pixels, [[(0, 0), (1.5, 0), (1, 1)]])[0] is None      # it repeats
    assert cut_of(pixels, [[(0, 0), (1, 0), (1, 0.9)]])[0] is None      # nearly all
    assert cut_of(numpy.zeros((90, 128, 3)), [[(0, 0), (9, 0), (1, 1)]])[0] is None     # more than a canvas holds
    ((cut, _),), _ = cut_of(pixels, [[(0, 0), (0.1, 0), (0, 0.1)]])
    assert (cut.across.first, cut.across.end, cut.down.first, cut.down.end) == (0, 13, 0, 7)


@pytest.mark.parametrize("size", [(98, 82), (13, 11), (255, 3), (1, 200)])
def test_an_image_of_any_size_keeps_its_texels(size):
    """On a canvas that has room for them, and where faces repeat it too."""
    width, height = size
    pixels = numpy.random.default_rng(8).integers(0, 256, (height, width, 3), dtype=numpy.uint8)
    whole = rectangle(0, 0, width, height, width, height)
    ((cut, _),), _ = cut_of(pixels, [whole])
    shown = canvas_of(pixels, [whole])
    assert (shown[cut.down.start:, cut.across.start:][:height, :width] == pixels).all()
    if max(size) < 20:
        twice = canvas_of(pixels, [[(2 * u, 3 * v) for u, v in whole]])
        assert (twice[2:, 2:][:3 * height, :2 * width] == numpy.tile(pixels, (3, 2, 1))).all()


def test_texels_that_no_face_shows_mix_with_none():
    """A part that is scaled: what lies beside a triangle in the image is of another colour."""
    rng = numpy.random.default_rng(9)
    for _ in range(8):
        three = rng.uniform(0, 600, (3, 2))
        columns, rows = numpy.arange(600), numpy.arange(600)
        inside = image_cut.touched(three.tolist(), columns, rows)
        pixels = numpy.where(inside[..., None], (40 + columns % 50)[None, :, None], 255) * numpy.ones(3)
        shown = canvas_of(pixels, [(three / 600).tolist()], 64)
        assert shown.max() < 90 and shown.shape[0] <= 64


def test_a_texture_that_has_no_room_for_padding_does_not_repeat():
    ((cut, _),), _ = cut_of(numpy.zeros((1024, 1024, 3)), [rectangle(100, 100, 356, 110, 1024, 1024)])
    assert (cut.across.side, cut.across.count, cut.down.side, cut.clamps) == (256, 256, 16, True)


def test_parts_that_lie_far_apart_are_textures_of_their_own():
    """If these have fewer texels together than one about both."""
    pixels = numpy.random.default_rng(10).integers(0, 256, (1024, 1024, 3), dtype=numpy.uint8)
    two = [rectangle(10, 20, 40, 50, 1024, 1024), rectangle(900, 1000, 930, 1020, 1024, 1024)]
    found, _ = cut_of(pixels, two)
    assert [numbers for _, numbers in found] == [[0], [1]] and [(cut.across.count, cut.across.side) for cut, _ in found] == [(30, 64)] * 2
    assert [(cut.across.count, cut.across.side) for cut, _ in cut_of(pixels, two, 16)[0]] == [(16, 16)] * 2
    assert len(cut_of(pixels, [*two, rectangle(20, 30, 920, 1010, 1024, 1024)])[0] or [0]) == 1
    near = [rectangle(10, 20, 40, 50, 1024, 1024), rectangle(40, 20, 70, 50, 1024, 1024)]
    assert len(cut_of(pixels, near)[0]) == 1


def test_rectangles_that_touch_at_a_side_or_a_corner_are_one_island():
    """By definition: rectangles touch where neither ends before the other begins, and those of a chain of such are together."""
    chance, side = random.Random(3), image_cut._CELLS
    shapes = ((1, 1), (2, 3), (9, 4), (30, 1), (1, 40))
    for count in (1, 2, 5, 20, 60, 200):
        boxes = [((x, x + w), (y, y + h)) for w, h in chance.choices(shapes, k=count)
                 for x, y in [(chance.randrange(side - w + 1), chance.randrange(side - h + 1))]]
        groups = []
        for box in boxes:
            near = [group for group in groups if any(all(a <= d and c <= b for (a, b), (c, d) in zip(box, other)) for other in group)]
            groups = [group for group in groups if group not in near] + [sum(near, [box])]
        labels = image_cut._labels(boxes)
        found = [{int(labels[top, left]) for (left, _), (top, _) in group} for group in groups]
        assert all(len(each) == 1 and 0 not in each for each in found) and len(set.union(*found)) == len(groups)
        assert (labels > 0).sum() == len({(x, y) for (a, b), (c, d) in boxes for x in range(a, b) for y in range(c, d)})


def test_an_image_that_clamps_is_cut_and_flat_too():
    """Beyond its edges it shows them."""
    pixels = numpy.zeros((64, 64, 3), dtype=numpy.uint8)
    pixels[:, 32:] = numpy.random.default_rng(11).integers(0, 256, (64, 32, 3))
    beyond = [(-3, 0.2), (0.4, 0.2), (0.4, 0.9), (-3, 0.9)]
    assert image_cut.colours(texture(pixels), [beyond], True) == [(0, 0, 0)] and image_cut.colours(texture(pixels), [beyond]) == [None]
    shown = [(0.75, 0.25), (1.5, 0.25), (1.5, 0.5), (0.75, 0.5)]
    ((cut, _),), found = cut_of(pixels, [shown], clamp=True)
    assert (cut.across.first, cut.across.end, cut.down.first, cut.down.end) == (48, 64, 16, 32)
    made = image_cut.canvas(found, cut, [0]).pixels[..., :3]
    assert (made[2:18, 18:] == pixels[16:32, 63:]).all()
    assert numpy.allclose(image_cut.within(found, cut, 0)[1], [(2 + 48) / 32, 2 / 32])


@pytest.mark.parametrize("bits", [8, 16])
def test_the_texels_of_a_part_are_those_of_the_image(tmp_path, bits):
    """Faces on 12 x 12 texels of an image of 256 x 256: the part of 16 x 16 is not scaled, and its border has the texels beside it."""
    pixels = numpy.zeros((256, 256, 3), dtype=numpy.uint8)
    pixels[100:112, 40:52] = numpy.random.default_rng(5).integers(0, 4, (12, 12, 3)) * 64 + 30
    uvs = [(40 / 256, 112 / 256), (52 / 256, 112 / 256), (52 / 256, 100 / 256), (40 / 256, 100 / 256)]
    (tmp_path / "m.glb").write_bytes(glb(*gltf(*squares(1), uvs=uvs, image=png(pixels))))
    (tmp_path / "s.toml").write_text(f'[view]\npixels = "rgb565"\n[[objects]]\nmodel = "m.glb"\nshade = false\n'
                                     f'images = {{ bits = {bits}, size = 64{", colours = 255" if bits == 8 else ""} }}\n')
    made, _ = compiler.compile_scene(str(tmp_path / "s.toml"))
    found, = made.surfaces.textures
    assert (found.log_width, found.log_height) == (4, 4)
    step = bits // 8
    for face in made.models[0].faces:
        for u, v in face.mapped.texels:
            assert u in (2 << 16, 14 << 16) and v in (2 << 16, 14 << 16)
    for y in range(16):
        for x in range(16):
            texel = int.from_bytes(found.texels[step * (16 * y + x):][:step], "little")
            real = tuple(pixels[100 + min(max(y - 2, 0), 11), 40 + min(max(x - 2, 0), 11)].tolist())
            assert made.palette[texel] == real if bits == 8 else abs((texel >> 5 & 63) - (rgb565(real) >> 5 & 63)) <= 1


def test_a_model_of_which_every_face_has_one_colour_is_flat_and_merges(tmp_path):
    pixels, cells = atlas(256, 8)
    point = (2.5 / 8, 4.5 / 8)
    data = glb(*gltf(*squares(1), uvs=[point] * 4, image=png(pixels)))
    (tmp_path / "m.glb").write_bytes(data)
    made, _ = compiler.compile_scene(str(tmp_path / "m.glb"), 2, look=look.Look())
    assert made.surfaces is None and {len(face.corners) for face in made.models[0].faces} == {4}
    assert image.unpack(image.pack(made)) == made
    assert (made.pixel_bits, cells[4, 2].tolist() != [0, 0, 0]) == (16, True)


def test_one_image_on_all_faces_of_a_cube_is_one_texture():
    import pathlib
    made, _ = compiler.compile_scene(str(pathlib.Path(__file__).parent / "models" / "plain_texture.glb"), 2, look=look.Look())
    assert len(made.surfaces.textures) == 1 and sum(face.mapped is not None for face in made.models[0].faces) == 12


@pytest.mark.parametrize("other", ["same", "a.png", "b.png", "b.bmp"])
def test_one_image_is_stored_once(tmp_path, other):
    """On faces of two materials, from two files, and in two formats."""
    pixels = numpy.random.default_rng(12).integers(0, 256, (32, 32, 3), dtype=numpy.uint8)
    for name in ("a.png", "b.png", "b.bmp"):
        Image.fromarray(pixels).save(tmp_path / name)
    lines = [f"v {2 * i + x} {y} 0" for i in range(6) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))] + ["vt 0 0", "vt 1 0", "vt 1 1", "vt 0 1"]
    for i in range(6):
        material = "a" if i % 2 == 0 or other == "same" else "b"
        lines += [f"usemtl {material}", "f " + " ".join(f"{4 * i + 1 + c}/{1 + c}" for c in range(4))]
    (tmp_path / "m.obj").write_text("\n".join(["mtllib m.mtl", *lines, ""]))
    (tmp_path / "m.mtl").write_text(f"newmtl a\nmap_Kd a.png\nnewmtl b\nmap_Kd {'a.png' if other == 'same' else other}\n")
    made, _ = compiler.compile_scene(str(tmp_path / "m.obj"), 2, look=look.Look(texels=32, is_fixed=True))
    one, = made.surfaces.textures
    assert len(one.texels) == 2 * (32 * 32 + 16 * 16 + 8 * 8 + 4 * 4) and all(face.mapped for face in made.models[0].faces)


@pytest.mark.parametrize("size, sides", [((3, 4), (4, 4)), ((48, 45), (64, 32)), ((300, 1), (256, 1)), ((700, 90), (256, 64))])
def test_a_picture_of_any_size_is_scaled_to_the_nearest_sides_of_a_texture(tmp_path, size, sides):
    (tmp_path / "p.png").write_bytes(png(numpy.full((size[1], size[0], 3), 77)))
    (tmp_path / "s.toml").write_text('[[textures]]\nname = "p"\nfile = "p.png"\n[[objects]]\nsolid = "box"\ntexture = "p"\nshade = false\n')
    made, _ = compiler.compile_scene(str(tmp_path / "s.toml"))
    one, = made.surfaces.textures
    assert (1 << one.log_width, 1 << one.log_height) == sides and {made.palette[entry] for entry in one.texels} == {(77, 77, 77)}
