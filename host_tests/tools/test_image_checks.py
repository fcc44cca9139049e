# SPDX-License-Identifier: MIT
"""The checks of a scene image at the last value that each takes and the first that it refuses."""

import types

import pytest

from fixel.base.errors import ToolError
from fixel.image import image_billboard, image_models, image_placement, image_surface
from fixel.image.image_tables import Ranges
from fixel.image.image_surface import BITS_4, BITS_8
from fixel.image.image_placement import COORDINATE_MAX, DEPTH_MAX, SCALE_MAX, SCALE_MIN, SLACK, Key, Motion

ONE = 1 << 16


def refuses(status, check, *arguments):
    with pytest.raises(ToolError, match=f"^{status}:"):
        check(*arguments)


# --- objects ------------------------------------------------------------------------

def test_vertices_of_all_objects_together(monkeypatch):
    monkeypatch.setattr(image_models, "PLACED_MAX", 7)
    models = [types.SimpleNamespace(vertices=[(0, 0, 0)] * count) for count in (3, 4)]
    rows = [(1, 2, 3, number, 5, 0) for number in (0, 1)]
    assert [(item.centre, item.model, item.layer) for item in image_models.read_objects(rows, models)] == \
        [((1, 2, 3), 0, 5), ((1, 2, 3), 1, 5)]
    refuses("count", image_models.read_objects, [*rows, rows[0]], models)
    refuses("index", image_models.read_objects, [(1, 2, 3, 2, 5, 0)], models)
    refuses("reserved", image_models.read_objects, [(1, 2, 3, 0, 5, 1)], models)


def test_a_billboard_reaches_as_far_as_its_model_and_no_farther(monkeypatch):
    monkeypatch.setattr(image_billboard, "_read_board", lambda *_: None)
    monkeypatch.setattr(image_billboard, "_check_board", lambda *_: None)
    model = types.SimpleNamespace(kind=None, faces=[None])
    found = dict(zip(image_billboard.TABLES, ([()], [1], b"")))

    def read(square):
        monkeypatch.setattr(image_billboard, "_reach", lambda board: square)
        return image_billboard.read(found, [model], [5])
    assert read(25).model_map == [1]
    refuses("radius", read, 26)
    refuses("index", image_billboard.read, {**found, "billboard map": [2]}, [model], [5])
    refuses("count", image_billboard.read, found, [types.SimpleNamespace(kind=None, faces=[None, None])], [5])


# --- surfaces -----------------------------------------------------------------------

def surfaces(**changes):
    """The tables of an image with a texture of 2 x 2 texels and one surface, which no face has."""
    return {**dict(zip(image_surface.TABLES, ([(0, 0, 1, 1, BITS_8, 0, 0, 1, 0)], b"abcd", [(1, 0, 0, 16, 0, 0, 0)], [], [0], [], []))),
            **changes}


MODELS = [types.SimpleNamespace(vertices=[(0, 0, 0), (4, 0, 0), (4, 4, 0), (8, 8, 0)],
                                faces=[types.SimpleNamespace(corners=(0, 1, 2, 3), mapped=None)])]


def test_texels_and_colours_end_with_their_table():
    texture = image_surface.read(surfaces(), 0, MODELS).textures[0]
    assert bytes(texture.texels) == b"abcd" and texture.log_width == 1
    refuses("offset", image_surface.read, surfaces(texels=b"abc"), 0, MODELS)
    four = [(0, 2, 1, 1, BITS_4, 0, 0, 1, 0)]
    texture = image_surface.read(surfaces(textures=four, texels=bytes(range(18))), 0, MODELS).textures[0]
    assert bytes(texture.texels) == b"\0\1" and bytes(texture.colours) == bytes(range(2, 18))
    refuses("offset", image_surface.read, surfaces(textures=four, texels=bytes(17)), 0, MODELS)
    refuses("reserved", image_surface.read, surfaces(textures=[(0, 1, 1, 1, BITS_8, 0, 0, 1, 0)]), 0, MODELS)


def test_texels_of_rgb565_are_for_an_image_of_rgb565():
    """A key of their own, an even place, two bytes a texel."""
    def wide(place, key=0, bits=16):
        found = surfaces(textures=[(place, 0, 1, 1, image_surface.RGB565, image_surface.KEYED, key, 1, 0xFEDC)], texels=bytes(range(11)))
        return image_surface.read, found, 0, MODELS, bits

    read, *arguments = wide(2)
    texture = read(*arguments).textures[0]
    assert bytes(texture.texels) == bytes(range(2, 10)) and texture.key_565 == 0xFEDC
    refuses("offset", *wide(4))
    refuses("alignment", *wide(1))
    refuses("reserved", *wide(2, key=1))
    refuses("reserved", *wide(2, bits=8))
    refuses("reserved", image_surface.read, surfaces(textures=[(0, 0, 1, 1, BITS_8, 0, 0, 1, 1)]), 0, MODELS)


def test_colours_are_added_in_an_image_of_rgb565():
    def looks(flags, bits):
        return image_surface.read, surfaces(surfaces=[(0, 0, flags, 16, 0, 0, 0)]), 0, MODELS, bits

    added, blended = image_surface.ADDED, image_surface.BLENDED
    for flags in (added, added | image_surface.LIT, blended):   # which needs no table
        read, *arguments = looks(flags, 16)
        assert read(*arguments).surfaces[0].flags == flags
    refuses("reserved", *looks(added, 8))
    refuses("argument", *looks(blended, 8))
    refuses("reserved", *looks(added | blended, 16))
    refuses("reserved", *looks(2 * image_surface.COLOURS, 16))
    refuses("reserved", *looks(image_surface.COLOURS, 8))


def test_a_blend_table_ends_with_the_palette():
    rows = [bytes(256)] * 6
    made = image_surface.read(surfaces(**{"blend table": rows}), 250, MODELS)
    assert made.blend_first == 250 and len(made.blend) == 6
    refuses("count", image_surface.read, surfaces(**{"blend table": rows}), 251, MODELS)
    assert image_surface.read(surfaces(), 255, MODELS).blend_first == 255
    refuses("count", image_surface.read, surfaces(), 256, MODELS)


def test_a_blended_surface_shows_up_to_all_of_its_own_colour():
    def looks(flags, sixteenths, *reserved):
        return surfaces(surfaces=[(0, 0, flags, 16, sixteenths, *reserved)], **{"blend table": [bytes(256)]})

    for sixteenths in (0, 1, 16):
        assert image_surface.read(looks(image_surface.BLENDED, sixteenths, 0, 0), 0, MODELS).surfaces[0].sixteenths == sixteenths
    refuses("range", image_surface.read, looks(image_surface.BLENDED, 17, 0, 0), 0, MODELS)
    refuses("reserved", image_surface.read, looks(0, 1, 0, 0), 0, MODELS)
    refuses("reserved", image_surface.read, looks(image_surface.BLENDED, 1, 0, 1), 0, MODELS)


def mapped(*vertices, surface=0, coordinates=(0, 0, 1, 0, 1, 1), reserved=0):
    return surfaces(**{"mapped faces": [(surface, *vertices, 0, 0, 0, reserved, *coordinates)], "face map": [1]})


def test_a_face_has_a_mapping_of_three_vertices_that_are_on_no_line():
    most = image_surface.TEXEL_MAX
    image_surface.read(mapped(0, 1, 2, coordinates=(most, -most, 0, 0, 0, 0)), 0, MODELS)
    assert MODELS[0].faces[0].mapped.texels[0] == (most, -most) and MODELS[0].faces[0].mapped.vertices == (0, 1, 2)
    for status, found in (("degenerate", mapped(0, 2, 3)), ("index", mapped(0, 1, 4)), ("degenerate", mapped(1, 1, 2)),
                          ("index", mapped(0, 1, 2, surface=1)), ("reserved", mapped(0, 1, 2, reserved=1)),
                          ("range", mapped(0, 1, 2, coordinates=(most + 1, 0, 0, 0, 0, 0))),
                          ("index", {**mapped(0, 1, 2), "face map": [2]})):
        refuses(status, image_surface.read, found, 0, MODELS)


@pytest.mark.parametrize("way, is_line", [((1, 0, 0), True), ((0, 1, 0), True), ((0, 0, 1), True), ((1, 2, -3), True),
                                          ((0, 0, 0), True)])
@pytest.mark.parametrize("axis", range(3))
def test_corners_on_one_line(way, is_line, axis):
    a, b = (5, 6, 7), tuple(c + w for c, w in zip((5, 6, 7), way))
    c = tuple(p - 4 * w for p, w in zip(a, way))
    assert image_surface._on_one_line(a, b, c) == is_line
    beside = tuple(p + (i == axis) for i, p in enumerate(c))
    along_axis = [i for i in range(3) if way[i]] in ([axis], [])
    assert image_surface._on_one_line(a, b, beside) == along_axis


# --- motions ------------------------------------------------------------------------

def motion(centre=(0, 0, 0), scale=ONE, parent=0, **more):
    return Motion([Key(0, centre, (0, 0, 0), scale)], parent=parent, **more)


def chain(count, **last):
    """Motions each of which has the one before it as its parent."""
    made = [motion(parent=number) for number in range(count)]
    return [*made, motion(parent=count, **last)]


def test_a_motion_reaches_to_the_end_of_the_world():
    for scale, reach in ((ONE, 100), (2 * ONE, 200), (ONE // 2, 50), (ONE + 1, 101)):
        most = COORDINATE_MAX - reach - SLACK
        image_placement._check_chain([motion((0, -most, 0), scale)], 0, 100)
        refuses("range", image_placement._check_chain, [motion((0, -most - 1, 0), scale)], 0, 100)
    # The radius of a circle counts along x and z.
    most = COORDINATE_MAX - 100 - SLACK - 7
    image_placement._check_chain([motion((most, 0, 0), radius=7)], 0, 100)
    refuses("range", image_placement._check_chain, [motion((most + 1, 0, 0), radius=7)], 0, 100)
    image_placement._check_chain([motion((0, most + 7, 0), radius=7)], 0, 100)


def test_a_child_reaches_as_far_as_its_parents_carry_it():
    """The child is 1000 from its parent, which counts as 1001, since roots are rounded. The parent doubles that, and the
    child's own size too."""
    reach = 2 * 1001 + SLACK + 200 + SLACK
    for beyond in (0, 1):
        motions = [motion((COORDINATE_MAX - reach + beyond, 0, 0), 2 * ONE), motion((600, 0, 800), parent=1)]
        if beyond:
            refuses("range", image_placement._check_chain, motions, 1, 100)
        else:
            image_placement._check_chain(motions, 1, 100)


@pytest.mark.parametrize("parents, own, status", [
    ([ONE], SCALE_MIN, None), ([ONE], SCALE_MAX, None), ([ONE // 2], SCALE_MIN, "range"), ([2 * ONE], SCALE_MAX, "range"),
    ([ONE // 2], 2 * SCALE_MIN, None), ([2 * ONE], SCALE_MAX // 2, None), ([ONE // 2, ONE // 2], 2 * SCALE_MIN, "range")])
def test_the_scale_of_a_child_with_those_of_its_parents(parents, own, status):
    motions = [motion(scale=scale, parent=number) for number, scale in enumerate([*parents, own])]
    if status:
        refuses(status, image_placement._check_chain, motions, len(parents), 0)
    else:
        image_placement._check_chain(motions, len(parents), 0)


def test_how_many_parents_a_motion_may_have():
    image_placement._check_chain(chain(DEPTH_MAX), DEPTH_MAX, 0)
    refuses("count", image_placement._check_chain, chain(DEPTH_MAX + 1), DEPTH_MAX + 1, 0)
