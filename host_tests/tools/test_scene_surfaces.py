# SPDX-License-Identifier: MIT
"""Scene files with textures: what becomes of each key, and each refusal."""

import dataclasses
import math
import struct
import zlib

import numpy as np
import pytest
from PIL import Image

from conftest import CHECKOUT, run_cli
from fixel.image import image, image_surface
from fixel.image.fields import entry
from fixel.scene import palette, surfaces, texture, toml_scene
from fixel.base.errors import ToolError
# place field: images that are broken, for the tools
from scene_sections import section
from model_files import build

BUILT_PROGRAMS = ()
TEXTURE = '[[textures]]\nname = "t"\npattern = "checker"\nsize = [16, 8]\n'
CLAMPED = TEXTURE + 'wrap = "clamp"\n'
BOX = '[[objects]]\nsolid = "box"\nscale = [4, 2, 6]\nposition = [0, 0, 9]\ntexture = "t"\n'
TILE = '[[objects]]\nsolid = "tile"\nposition = [0, -1, 5]\ntexture = "t"\n'
LEVELS = "[light]\nlevels = 4\n"
ONE = 65536


def faces_of(scene, model=0):
    return scene.models[model].faces


def texels_of(face):
    """{corner of the face: (u, v) in texels}."""
    return {face.corners.index(vertex): (u / ONE, v / ONE) for vertex, (u, v) in zip(face.mapped.vertices, face.mapped.texels)}


def everywhere(model, face):
    """{vertex: (u, v)} of all of a face's vertices: affine, from its three corners."""
    points = [model.vertices[c] for c in face.corners]
    known = texels_of(face)
    (a, b, c), origin = sorted(known), points[sorted(known)[0]]
    one, two = (tuple(p - q for p, q in zip(points[i], origin)) for i in (b, c))
    dot = lambda p, q: sum(x * y for x, y in zip(p, q))
    whole = dot(one, one) * dot(two, two) - dot(one, two) ** 2
    result = {}
    for point in points:
        way = tuple(p - q for p, q in zip(point, origin))
        s = (dot(way, one) * dot(two, two) - dot(way, two) * dot(one, two)) / whole
        t = (dot(way, two) * dot(one, one) - dot(way, one) * dot(one, two)) / whole
        result[point] = tuple(known[a][k] + s * (known[b][k] - known[a][k]) + t * (known[c][k] - known[a][k])
                              for k in range(2))
    return result


# --- the image -----------------------------------------------------------------------------------

def test_a_textured_lit_triangle_takes_at_most_60_bytes_with_a_depth_buffer(tmp_path):
    """Of a terrain of 800 triangles: what its sections have for each. Face bounds are 20 more."""
    side = 21
    rows = [f"v {x} {math.sin(x) + math.cos(z)} {z}\n" for z in range(side) for x in range(side)]
    rows += [f"vt {x / 8} {z / 8}\n" for z in range(side) for x in range(side)]
    for at in (z * side + x + 1 for z in range(side - 1) for x in range(side - 1)):
        rows += [f"f {a}/{a} {b}/{b} {c}/{c}\n" for a, b, c in ((at, at + side, at + 1), (at + 1, at + side, at + side + 1))]
    (tmp_path / "terrain.obj").write_text("".join(rows), encoding="utf-8")
    made = build(tmp_path, LEVELS + TEXTURE + '[[objects]]\nobj = "terrain.obj"\nkind = "sorted"\ntexture = "t"\nmapping = "file"\n'
                                              'smooth = true\nposition = [0, -4, 9]\n')
    names = ("vertices", "corners", "faces", "mapped faces", "face map", "mapped corners", "normals of corners", "keys")

    def taken(scene):
        return sum(section(image.pack(scene), name)[1] * entry(name).size for name in names)

    deep = dataclasses.replace(made, depth_bits=16)
    assert len(faces_of(made)) == 800 and taken(deep) <= 60 * 800 and taken(made) == taken(deep) + 20 * 800


def test_textures_make_an_image_with_surfaces(tmp_path):
    plain = build(tmp_path, BOX.replace('texture = "t"\n', ""))
    made = build(tmp_path, TEXTURE + BOX)
    assert plain.surfaces is None and section(image.pack(plain), "surfaces") == (0, 0)
    assert section(image.pack(made), "surfaces")[1] == len(made.surfaces.surfaces)
    assert all(face.mapped for face in faces_of(made))
    assert {(one.log_width, one.log_height, one.format, one.levels) for one in made.surfaces.textures} == {(4, 3, 0, 1)}


def test_equal_objects_share_a_model_and_others_do_not(tmp_path):
    text = TEXTURE + BOX + BOX + BOX + "opacity = 5\n"
    scene = build(tmp_path, text)
    assert [item.model for item in scene.objects] == [0, 0, 1]


# --- where a texture lies ------------------------------------------------------------------------

def test_a_tile_covers_a_face_as_it_is_seen(tmp_path):
    """From the front the upper left corner of the texture is at the face's upper left."""
    model = build(tmp_path, CLAMPED + BOX).models[0]
    for face in model.faces:
        found = everywhere(model, face)
        assert sorted({round(u, 9) for u, _ in found.values()}) == [0, 16]
        assert sorted({round(v, 9) for _, v in found.values()}) == [0, 8]
    front = next(face for face in model.faces if face.normal[2] < 0)
    found = everywhere(model, front)
    assert found[-2 * ONE, ONE, -3 * ONE] == (0, 0) and found[2 * ONE, -ONE, -3 * ONE] == (16, 8)
    right = next(face for face in model.faces if face.normal[0] > 0)
    assert everywhere(model, right)[2 * ONE, ONE, -3 * ONE] == (0, 0)
    above = next(face for face in model.faces if face.normal[1] > 0)
    assert everywhere(model, above)[-2 * ONE, ONE, 3 * ONE] == (0, 0)


@pytest.mark.parametrize("inside", [False, True])
def test_no_texture_is_mirrored(tmp_path, inside):
    """u, v and the way to the eye turn as right, down and the face's normal do."""
    model = build(tmp_path, TEXTURE + BOX + f"inside = {str(inside).lower()}\n").models[0]
    for face in model.faces:
        found = everywhere(model, face)
        (p, q, r) = [model.vertices[c] for c in face.corners[:3]]
        along, across = [b - a for a, b in zip(p, q)], [b - a for a, b in zip(p, r)]
        turn = [along[i - 2] * across[i - 1] - along[i - 1] * across[i - 2] for i in range(3)]
        assert sum(a * b for a, b in zip(turn, face.normal)) > 0
        (u0, v0), (u1, v1), (u2, v2) = found[p], found[q], found[r]
        assert (u1 - u0) * (v2 - v0) - (v1 - v0) * (u2 - u0) > 0


def test_texels_a_unit_are_the_same_on_all_faces(tmp_path):
    model = build(tmp_path, TEXTURE + BOX + "texels_per_unit = 2.5\n").models[0]
    for face in model.faces:
        found = list(everywhere(model, face).items())
        for (p, (u0, v0)), (q, (u1, v1)) in zip(found, found[1:]):
            length = sum(((a - b) / ONE) ** 2 for a, b in zip(p, q)) ** 0.5
            assert abs(((u1 - u0) ** 2 + (v1 - v0) ** 2) ** 0.5 - 2.5 * length) < 0.001


def test_an_offset_moves_a_texture(tmp_path):
    plain, moved = (texels_of(faces_of(build(tmp_path, CLAMPED + TILE + text))[0])
                    for text in ("", 'texel_offset = [1.5, "1/4"]\n'))
    assert {c: (u + 1.5, v + 0.25) for c, (u, v) in plain.items()} == moved


def test_a_texture_turns_with_its_model(tmp_path):
    for text in ("", "rotation = [30, 20, 10]\n"):
        model = build(tmp_path, CLAMPED + BOX + text).models[0]
        for face in model.faces:
            found = sorted((round(u, 2), round(v, 2)) for u, v in everywhere(model, face).values())
            assert found == [(0, 0), (0, 8), (16, 0), (16, 8)]


def test_what_repeats_begins_near_nought_and_what_is_clamped_stays(tmp_path):
    text = "texels_per_unit = 100\nscale = 40\ntexel_offset = [1600, 0]\n"
    repeated = build(tmp_path, TEXTURE + TILE + text)
    assert 0 <= min(u for u, _ in texels_of(faces_of(repeated)[0]).values()) < 16
    clamped = build(tmp_path, TEXTURE + 'wrap = "clamp"\n' + TILE + text)
    assert min(u for u, _ in texels_of(faces_of(clamped)[0]).values()) == 1600 - 2000
    assert clamped.surfaces.textures[0].flags == image_surface.CLAMP


def test_textures_take_turns_and_some_faces_have_none(tmp_path):
    other = TEXTURE.replace('"t"', '"o"').replace("[16, 8]", "[4, 4]")
    scene = build(tmp_path, TEXTURE + other + BOX.replace('texture = "t"', 'textures = ["t", "", "o"]'))
    sizes = [0 if face.mapped is None else
             scene.surfaces.textures[scene.surfaces.surfaces[face.mapped.surface].texture - 1].log_width
             for face in faces_of(scene)]
    assert sizes == [4, 0, 2, 4, 0, 2]


def test_keys_of_a_surface_become_its_fields(tmp_path):
    for text, field, value in (("division = 8\n", "division", 1), ("division = 1\n", "division", 2),
                               ('division = "affine"\n', "division", 3), ("opacity = 7\n", "opacity", 7),
                               ("blend = true\n", "flags", image_surface.BLENDED), ("", "division", 0)):
        scene = build(tmp_path, TEXTURE + TILE + text)
        assert {getattr(one, field) for one in scene.surfaces.surfaces} == {value}


def test_opacity_needs_no_texture(tmp_path):
    scene = build(tmp_path, TILE.replace('texture = "t"\n', "opacity = 3\n"))
    assert scene.surfaces.textures == [] and scene.surfaces.surfaces == [image_surface.Surface(0, 0, 0, 3)]


# --- files ---------------------------------------------------------------------------------------

QUAD = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"


def test_coordinates_of_a_file_are_used(tmp_path):
    """OBJ: u to the right, v upward, 1 across."""
    (tmp_path / "quad.obj").write_text(QUAD + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n")
    scene = build(tmp_path, CLAMPED + '[[objects]]\nobj = "quad.obj"\ntexture = "t"\nmapping = "file"\n')
    [model] = scene.models
    assert everywhere(model, model.faces[0]) == {
        (-ONE, -ONE, 0): (0, 8), (ONE, -ONE, 0): (16, 8), (ONE, ONE, 0): (16, 0), (-ONE, ONE, 0): (0, 0)}


def test_a_face_is_cut_where_its_coordinates_are_not_affine(tmp_path):
    (tmp_path / "quad.obj").write_text(QUAD + "vt 0 0\nvt 1 0\nvt 0.5 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n")
    scene = build(tmp_path, CLAMPED + '[[objects]]\nobj = "quad.obj"\ntexture = "t"\nmapping = "file"\n')
    assert [len(face.corners) for face in faces_of(scene)] == [3, 3]
    found = everywhere(scene.models[0], faces_of(scene)[0]) | everywhere(scene.models[0], faces_of(scene)[1])
    assert found[ONE, ONE, 0] == (8, 0) and found[ONE, -ONE, 0] == (16, 8)


def test_a_face_without_coordinates_is_named(tmp_path):
    (tmp_path / "quad.obj").write_text(QUAD + "f 1 2 3 4\n")
    with pytest.raises(ToolError, match="quad.obj:5.*no texture coordinates"):
        build(tmp_path, TEXTURE + '[[objects]]\nobj = "quad.obj"\ntexture = "t"\nmapping = "file"\n')


# --- pictures ------------------------------------------------------------------------------------

def test_a_picture_of_a_file_has_its_colours_and_its_holes(tmp_path):
    picture = Image.new("RGBA", (4, 2), (200, 10, 20, 255))
    picture.putpixel((3, 1), (0, 0, 0, 0))
    picture.putpixel((0, 0), (10, 200, 30, 255))
    picture.save(tmp_path / "p.png")
    for bits in (8, 4):
        scene = build(tmp_path, f'[[textures]]\nname = "t"\nfile = "p.png"\nbits = {bits}\n' + TILE + "shade = false\n")
        [made] = scene.surfaces.textures
        assert made.flags == image_surface.KEYED and made.key == 0 and len(made.texels) == bits
        numbers = made.texels if bits == 8 else [made.colours[n] for b in made.texels for n in (b & 15, b >> 4)]
        assert [scene.palette[n] if n else None for n in numbers] == \
            [(10, 200, 30)] + [(200, 10, 20)] * 6 + [None]


def test_many_colours_of_a_file_are_merged(tmp_path):
    picture = Image.new("RGB", (16, 16))
    picture.putdata([(i, 255 - i, i * 7 % 256) for i in range(256)])
    picture.save(tmp_path / "p.png")
    for text, most in (("", 32), ("most_colours = 5\n", 5), ("bits = 4\n", 15)):
        scene = build(tmp_path, f'[[textures]]\nname = "t"\nfile = "p.png"\n{text}' + TILE + "shade = false\n")
        [made] = scene.surfaces.textures
        assert len(set(made.colours[:15] if made.colours else made.texels)) == most


@pytest.mark.parametrize("name", list(texture.PATTERNS))
def test_patterns_repeat_at_any_size(name):
    colours = [(i, i, i) for i in range(len(texture.PATTERNS[name][1]))]
    for size in ((1, 1), (2, 4), (64, 16), (256, 256)):
        made = texture.pattern(name, *size, colours)
        assert (made.width, made.height) == size
        assert all(n is texture.CLEAR or 0 <= n < len(colours) for row in made.levels[0] for n in row)
    made = texture.pattern(name, 32, 32, colours)
    assert {n for row in made.levels[0] for n in row} - {None} == set(range(len(colours)))
    assert made.has_clear == (name in ("grille", "tree"))


@pytest.mark.parametrize("name, size, rows", [
    ("checker", (8, 4), "00001111 00001111 11110000 11110000"),
    ("grille", (16, 8), "0000000000000000 01......01...... 01......01...... 01......01...... " * 2),
])
def test_a_pattern_as_text(name, size, rows):
    made = texture.pattern(name, *size, [(0, 0, 0)] * len(texture.PATTERNS[name][1]))
    assert ["".join("." if n is texture.CLEAR else str(n) for n in row) for row in made.levels[0]] == rows.split()


@pytest.mark.parametrize("name, crc", [
    ("checker", 0x081df354), ("bricks", 0x2a5e6c78), ("planks", 0xe1430413), ("crate", 0xdda1dbc7), ("grille", 0x9de5a604),
    ("tree", 0x69235fc3), ("stones", 0x986ac541)])
def test_a_scene_keeps_its_patterns(name, crc):
    """A pattern is part of a scene's image. Where one is to look otherwise, put the new figure in."""
    found = 0
    for size in ((4, 4), (8, 64), (32, 16), (64, 64), (128, 32)):
        made = texture.pattern(name, *size, [(0, 0, 0)] * len(texture.PATTERNS[name][1]))
        found = zlib.crc32(bytes(255 if n is texture.CLEAR else n for row in made.levels[0] for n in row), found)
    assert found == crc


def test_a_smaller_level_is_clear_where_half_of_its_texels_are():
    clear = texture.codes_of(np.zeros((1, 1, 3), np.uint8), True).item()
    red, odd = 0x400000, 0x400103
    [_, level] = texture.levels_of(np.array([[red, odd, red, clear], [odd, clear, clear, red]], np.int32), 2)
    assert level.tolist() == [[0x400102, clear]]      # of three the mean, rounded: 0, 1, 1 and 0, 3, 3
    # A level of one row is only halved in width, down to the least.
    row = np.array([[0, 2, 4, 6]], np.int32)
    assert [level.tolist() for level in texture.levels_of(row, 9)] == [[[0, 2, 4, 6]], [[1, 5]], [[3]]]
    assert [level.tolist() for level in texture.levels_of(np.array([[0, 2], [4, 6]], np.int32), 9, 2)] == [[[0, 2], [4, 6]], [[2, 4]]]


@pytest.mark.parametrize("rows, nearest", [([[0, 1], [0, 0]], 0), ([[1, 1], [0, 1]], 1)])
def test_a_smaller_level_has_the_nearest_of_the_colours_where_no_other_is_allowed(rows, nearest):
    picture = texture.Picture([rows], [(0, 0, 0), (255, 255, 255)])
    assert texture.with_levels(picture, 2, 2, 1).levels == [rows, [[nearest]]]
    made = texture.with_levels(picture, 2, 3, 1)
    assert made.colours[:2] == picture.colours and made.levels == [rows, [[2]]]
    assert made.colours[2] == 3 * ([64, 191][nearest],)


def test_colours_of_a_picture_are_coarser_where_there_are_too_many():
    few = np.arange(texture.DISTINCT_MAX, dtype=np.int32).reshape(32, 64)
    assert (texture.coarser(few) == few).all()
    noise = np.random.default_rng(5).integers(0, 1 << 24, (64, 64), np.int32)
    for many, dropped in ((np.arange(0x800000, 0x800000 + 4096, dtype=np.int32).reshape(64, 64), 1), (noise, 4)):
        made = texture.coarser(many)
        shades = [(made >> shift & 255, many >> shift & 255) for shift in (0, 8, 16)]
        # In the middle of those that become one.
        assert all((found == (was >> dropped << dropped) + (1 << dropped >> 1)).all() for found, was in shades)


def test_levels_are_means_of_the_level_before(tmp_path):
    scene = build(tmp_path, TEXTURE + 'colours = ["#000000", "#ffffff"]\nlevels = 9\n' + TILE + "shade = false\n")
    [made] = scene.surfaces.textures
    assert made.levels == 5 and len(made.texels) == 16 * 8 + 8 * 4 + 4 * 2 + 2 + 1
    assert scene.palette[made.texels[-1]] == (128, 128, 128)
    first = [scene.palette[n] for n in made.texels[128:160]]
    assert first == [(0, 0, 0) if (x < 4) == (y < 2) else (255, 255, 255) for y in range(4) for x in range(8)]
    scene = build(tmp_path, TEXTURE + "bits = 4\nlevels = 9\n" + TILE + "shade = false\n")
    assert len(scene.surfaces.textures[0].texels) == (16 * 8 + 8 * 4 + 4 * 2 + 2 + 2) // 2


# --- colours and light ---------------------------------------------------------------------------

# place light: the ramp that the tools make
@pytest.mark.parametrize("bits", [4, 8])
def test_the_tools_light_shades_a_texture_for_each_direction(tmp_path, bits):
    scene = build(tmp_path, TEXTURE + f"bits = {bits}\n" + BOX)
    assert len(scene.surfaces.textures) == 6
    assert len({one.texels for one in scene.surfaces.textures}) == (1 if bits == 4 else 6)
    unlit = build(tmp_path, TEXTURE + f"bits = {bits}\n" + BOX + "shade = false\n")
    assert len(unlit.surfaces.textures) == 1


def test_many_directions_keep_the_textures_colours(tmp_path):
    scene = build(tmp_path, TEXTURE + '[[objects]]\nsolid = "sphere"\nposition = [0, 0, 4]\ntexture = "t"\n')
    assert len(scene.surfaces.textures) == 1


def test_a_textured_face_has_the_mean_colour(tmp_path):
    text = TEXTURE + 'colours = ["#200000", "#400080"]\n' + TILE + "shade = false\n"
    assert {(0x30, 0, 0x40)} == {(lambda s: s.palette[faces_of(s)[0].colour])(build(tmp_path, text))}
    scene = build(tmp_path, text + 'colour = "#010203"\n')
    assert scene.palette[faces_of(scene)[0].colour] == (1, 2, 3)


def test_light_at_run_time_gives_corners_normals(tmp_path):
    scene = build(tmp_path, LEVELS + TEXTURE + BOX)
    assert {one.flags for one in scene.surfaces.surfaces} == {image_surface.LIT} and len(scene.surfaces.textures) == 1
    for face in faces_of(scene):
        assert {scene.surfaces.normals[n] for n in face.mapped.normals} == {face.normal}
    plain = build(tmp_path, LEVELS + TEXTURE + BOX + "lit = false\n")
    assert {one.flags for one in plain.surfaces.surfaces} == {0} and plain.surfaces.normals == []


def test_smooth_normals_are_shared_by_neighbours(tmp_path):
    scene = build(tmp_path, LEVELS + '[[objects]]\nsolid = "octahedron"\nposition = [0, 0, 4]\nsmooth = true\n')
    [model] = scene.models
    for face in model.faces:
        for number, normal in zip(face.mapped.vertices, map(scene.surfaces.normals.__getitem__, face.mapped.normals)):
            assert all(abs(n - v * (1 << 30) / (ONE // 2)) < 1 << 14 for n, v in zip(normal, model.vertices[number]))


def test_a_blend_table_has_the_nearest_entries(tmp_path):
    """rgb565 2.2c."""
    scene = build(tmp_path, TEXTURE + TILE + "[palette]\nblend = 5\n" +
                  '[[objects]]\nsolid = "tile"\nposition = [0, 0, 4]\ncolour = "#40c0e0"\nshade = false\nblend = true\n')
    made = scene.surfaces
    assert len(made.blend) == 1 and scene.palette[made.blend_first] == (0x40, 0xC0, 0xE0)
    assert [each.sixteenths for each in made.surfaces] == [0, 5]      # in RGB565
    for beneath, shown in enumerate(made.blend[0]):
        wanted = palette.between(scene.palette[beneath], (0x40, 0xC0, 0xE0), 5, 16)
        distances = [sum((a - b) ** 2 for a, b in zip(entry, wanted)) for entry in scene.palette]
        assert beneath == made.blend_first == shown or distances[shown] == min(distances)


WIDE = '[view]\npixels = "rgb565"\n'


def value_of(red, green, blue):
    """Of docs/extras/pixels.md, section 1."""
    return red // 8 << 11 | green // 4 << 5 | blue // 8


def test_texels_of_rgb565_keep_every_colour(tmp_path):
    """The palette has none of them; what is clear has a colour that no texel has."""
    noise = np.random.default_rng(5).integers(0, 256, (32, 64, 4), dtype=np.uint8)
    noise[..., 3] = 255
    noise[3, 5] = noise[0, 0] = (0, 0, 0, 0)
    noise[0, 1] = (0, 3, 1, 255)        # black: the first colour is taken
    Image.fromarray(noise).save(tmp_path / "noise.png")
    scene = build(tmp_path, WIDE + '[[textures]]\nname = "t"\nfile = "noise.png"\nbits = 16\nlevels = 2\n' + TILE +
                  "shade = false\nopacity = 9\nblend = true\n")
    [made] = scene.surfaces.textures
    texels = np.frombuffer(made.texels, dtype="<u2").tolist()
    pixels = noise.reshape(-1, 4).tolist()
    assert texels[:64 * 32] == [value_of(*pixel[:3]) if pixel[3] else made.key_565 for pixel in pixels]
    assert len(texels) == 64 * 32 + 32 * 16
    assert made.key_565 > 0 and texels.count(made.key_565) == 2
    assert (made.format, made.flags, made.key, made.levels) == (image_surface.RGB565, image_surface.KEYED, 0, 2)
    assert scene.surfaces.blend == [] and {tuple(entry) for entry in scene.palette[2:]} == {(0, 0, 0)}    # the mean alone


def test_the_tools_light_shades_texels_of_rgb565(tmp_path):
    scene = build(tmp_path, WIDE + TEXTURE + "bits = 16\n" + BOX)
    assert len({one.texels for one in scene.surfaces.textures}) == 6


def test_holes_find_no_colour_where_all_are_taken():
    with pytest.raises(ToolError, match="holes need one"):
        image_surface.free_key([*range(1 << 16), None])
    assert image_surface.free_key([None, *range(0xFFFF)]) == 0xFFFF


def test_blend_says_whether_colours_are_mixed_or_added(tmp_path):
    """surfaces 1.3d."""
    for value, flags in (("true", image_surface.BLENDED), ("false", 0), ('"add"', image_surface.ADDED)):
        scene = build(tmp_path, WIDE + TEXTURE + TILE + f"blend = {value}\n")
        assert {one.flags for one in scene.surfaces.surfaces} == {flags}
        assert bool(scene.surfaces.blend) == (flags == image_surface.BLENDED)
        assert [one.sixteenths for one in scene.surfaces.surfaces] == [8 if flags == image_surface.BLENDED else 0]
    scene = build(tmp_path, WIDE + '[[objects]]\nsolid = "tile"\nposition = [0, -1, 5]\nblend = "add"\n')
    assert {one.flags for one in scene.surfaces.surfaces} == {image_surface.ADDED}


def test_the_faces_of_a_tree_keep_their_surfaces(tmp_path):
    done = run_cli("build", "scenes/room.toml", "-o", tmp_path / "room.fxls", "--tree", "all")
    assert done.returncode == 0 and "surfaces" not in done.stderr
    made = image.load(tmp_path / "room.fxls")
    assert sum(face.mapped is not None for face in faces_of(made, made.objects[made.tree.object].model)) == 21


# --- refusals ------------------------------------------------------------------------------------

def test_what_is_wrong_is_named(tmp_path):
    (tmp_path / "bad.png").write_bytes(b"\x89PNG\r\n\x1a\nno picture")
    Image.new("RGB", (3, 4)).save(tmp_path / "odd.png")
    # Pillow's reader of this format raises what none of the others does.
    Image.new("RGB", (8, 8)).save(tmp_path / "odd.dds")
    blob = bytearray((tmp_path / "odd.dds").read_bytes())
    blob[80:84] = struct.pack("<I", 1)      # the pixel format's flags
    (tmp_path / "odd.dds").write_bytes(blob)
    own = '[[textures]]\nname = "t"\n'
    for text, parts in (
            (own, ["file, pattern", "none is given"]),
            (own + 'pattern = "brick"\n', ['did you mean "bricks"']),
            (own + 'pattern = "checker"\nfile = "p.png"\n', ["both file and pattern"]),
            (own + 'pattern = "checker"\nsize = 16\n', ["size", "[width, height]", "16"]),
            (own + 'pattern = "checker"\ncolours = ["red"]\n', ["1 colours", "2"]),
            (own + 'file = "odd.png"\nbits = 16\nmost_colours = 9\n', ["most_colours", "RGB565 keep every colour"]),
            (own + 'pattern = "checker"\nsize = [1, 8]\nbits = 4\n', ["at least 2 wide"]),
            (own + 'pattern = "checker"\nmost_colours = 5\n', ["most_colours", "belongs to a file"]),
            (own + 'file = "gone.png"\n', ["there is no file", "gone.png"]),
            (own + 'file = "bad.png"\n', ["bad.png", "cannot be read", "PNG"]),
            (own + 'file = "odd.dds"\n', ["odd.dds", "DDS", "save it as PNG", "PNG"]),
            (own + 'file = "odd.png"\nsize = [4, 4]\n', ["size", '"path"', "[4, 4]"]),
            (TEXTURE + TEXTURE, ['there is a texture "t" already'])):
        with pytest.raises(ToolError) as caught:
            build(tmp_path, text + TILE)
        assert not [part for part in parts if part not in str(caught.value)], caught.value


def test_what_is_wrong_of_an_object_is_named(tmp_path):
    for text, parts in (
            ('textures = ["t"]\n', ["both texture and textures"]),
            ("tiles = [1, 1]\ntexels_per_unit = 2\n", ["both texels_per_unit and tiles"]),
            ("texels_per_unit = 16384\nscale = 4\n", ["more than 16383 texels long"]),
            ("lit = true\n", ["lit", "[light] levels"]),
            ("smooth = true\n", ["smooth", "[light] levels"]),
            ('mapping = "file"\ntiles = [1, 1]\n', ["tiles", 'mapping = "box"']),
            ('mapping = "file"\n', ["no texture coordinates"])):
        with pytest.raises(ToolError) as caught:
            build(tmp_path, TEXTURE + TILE + text)
        assert not [part for part in parts if part not in str(caught.value)], caught.value
    for text, parts in (('texture = "x"\n', ['no texture "x"', "t"]), ("tiles = [1, 1]\n", ["tiles", "without a texture"])):
        with pytest.raises(ToolError) as caught:
            build(tmp_path, TEXTURE + TILE.replace('texture = "t"\n', text))
        assert not [part for part in parts if part not in str(caught.value)], caught.value


def test_the_own_scene_has_what_it_promises():
    scene, notes = toml_scene.compile_file(str(CHECKOUT / "scenes" / "room.toml"))
    kinds = {(one.flags, one.log_width) for one in scene.surfaces.textures}
    assert (image_surface.KEYED, 5) in kinds and (0, 6) in kinds and scene.motions
    assert {one.opacity for one in scene.surfaces.surfaces} == {6, 16}
    assert not [note for note in notes if "merged" in note]


def test_surfaces_divides_what_it_must_and_no_more():
    square = [(0, 0, 0), (0, ONE, 0), (ONE, ONE, 0), (ONE, 0, 0)]
    assert surfaces.place(square, [(0, 0), (0, 9), (9, 9), (9, 0)], surfaces.Paint(None, 8, True), "")[0] == (0, 1, 2)
