# SPDX-License-Identifier: MIT
"""Short inputs that took seconds or minutes in one place. The limits are those of test_input_bounds.py."""

import io
import json
import math
import random
import zlib

import numpy as np
import pytest
from PIL import Image

from fixel.base.errors import ToolError
from fixel.image import image
from fixel.model import clusters, triangles
from fixel.scene import compiler, tree, tree_faces
from model_files import gltf
from test_input_bounds import BOX, PATH, assert_ended, run_bounded
from test_input_work import box, item, scene, textures

BUILT_PROGRAMS = ()


def build(folder, file, code, *more):
    """A file is compiled, or refused, within the limits; what was said."""
    found, said = run_bounded("build", file, "-o", folder / "out.fxls", *more)
    assert found == code, said[-500:]
    return said


def test_a_string_of_escaped_quotes(tmp_path):
    build(tmp_path, scene(tmp_path, 'background = "' + '\\"' * 20_000 + '"\n' + BOX), 2)


def test_many_tables_of_different_names(tmp_path):
    text = "".join(f"[a{i}.a.a.a.a.a.a.a]\n" for i in range(45_000))
    assert "unknown key" in build(tmp_path, scene(tmp_path, text), 2)


def test_needles_with_clusters(tmp_path):
    """The apex of a cone was sought one unit at a time, hundreds of thousands of them."""
    body = ('solid = "band"\nsides = 4\ntaper = 0.1\nkind = "sorted"\nclusters = true\nscale = [0.536, 7244, 0.536]\n'
            "rotation = [183.3, 12.4, 274.8]\ncolour_index = 1\ncolour_next = 1\n")
    text = "".join(item(body, f"colour_step = {i + 1}", "repeat = { count = [255, 1, 1], step = [0.001, 0, 0] }") for i in range(10))
    build(tmp_path, scene(tmp_path, text), 0)


def test_an_apex_is_behind_every_plane():
    """Also where the steps to it are leapt over."""
    chance = random.Random(5)
    for _ in range(200):
        tilt = chance.uniform(0, 1e-4)
        normals = [(round(math.cos(a) * (1 << 30)), round(math.sin(a) * (1 << 30) * tilt), round(math.sin(a) * (1 << 30)))
                   for a in (chance.uniform(-1.57, 1.57) for _ in range(4))]
        planes = [(normal, chance.randrange(-1 << 45, 1 << 45)) for normal in normals]
        apex = clusters._apex((0, 0, 0), (1 << 30, 0, 0), planes)
        assert apex is None or all(sum(n * a for n, a in zip(normal, apex)) <= height for normal, height in planes)


@pytest.mark.parametrize("text", ["textures = [" + '"t0", ' * 1000 + "]", None])
def test_the_mean_of_a_texture_is_computed_once(tmp_path, text):
    objects = box(text) if text else box('texture = "t0"') * 600
    build(tmp_path, scene(tmp_path, textures(['pattern = "stones"\nsize = [256, 256]']).replace(BOX, "") + objects), 0)


def test_frames_of_a_scene_without_a_path(tmp_path):
    file = tmp_path / "scene.toml"
    file.write_text(BOX)
    assert "limit of 32,768" in build(tmp_path, file, 2, "--frames", 1_000_000)


ONE_SUM = random.Random(1).sample([(r, g, 382 - r - g) for r in range(256) for g in range(256) if 0 <= 382 - r - g < 256], 250)


@pytest.mark.parametrize("top, keys", [("", "blend = true\nshade = false\n"), ('[light]\nlevels = 64\ndark = "#7f7f80"\n', "")])
def test_colours_of_one_sum(tmp_path, top, keys):
    """The search for the nearest colour looked at all."""
    colours = ", ".join('"#%02x%02x%02x"' % colour for colour in ONE_SUM)
    build(tmp_path, scene(tmp_path, top + item('solid = "floor"', "cells = [16, 16]", keys, f"colours = [{colours}]")), 0)


def test_very_many_keys_of_a_motion(tmp_path):
    assert_ended(tmp_path, scene(tmp_path, box("motion = { keys = [" + "{}, " * 250_000 + "] }")))


def test_a_chain_of_turned_parents(tmp_path):
    """The numbers of a turn became longer with each parent."""
    text = box('name = "p0"', "turn = [1.1, 2.3, 3.7]") + \
        "".join(box(f'name = "p{i}"', f'parent = "p{i - 1}"', "turn = [1.1, 2.3, 3.7]") for i in range(1, 8)) + \
        box('parent = "p7"', "turn = [1.1, 2.3, 3.7]", "repeat = { count = [50, 90, 1], step = [0, 0, 0] }")
    build(tmp_path, scene(tmp_path, text), 0)


# --- files ---------------------------------------------------------------------------------------

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


def test_one_mtl_file_named_very_often(tmp_path):
    (tmp_path / "d").mkdir()
    (tmp_path / "a.mtl").write_text("newmtl a\n")
    (tmp_path / "m.obj").write_text("mtllib " + "a.mtl " * 20_000 + "\n" + TRIANGLE)
    build(tmp_path, scene(tmp_path, f'[[objects]]\nmodel = "{"d/../" * 500}m.obj"\n'), 0)


def test_one_mtl_file_of_many_models(tmp_path):
    """It is read again for each."""
    (tmp_path / "a.mtl").write_text("newmtl a\n" + "\n" * 1_000_000)
    for number in range(30):
        (tmp_path / f"m{number}.obj").write_text("mtllib a.mtl\n" + TRIANGLE)
    build(tmp_path, scene(tmp_path, "".join(f'[[objects]]\nmodel = "m{i}.obj"\n' for i in range(3))), 0)
    (tmp_path / "out.fxls").unlink()
    assert_ended(tmp_path, scene(tmp_path, "".join(f'[[objects]]\nmodel = "m{i}.obj"\n' for i in range(30))))


def test_a_jpeg_of_very_many_segments(tmp_path):
    made = io.BytesIO()
    Image.new("RGB", (8, 8)).save(made, "JPEG")
    whole, segment = made.getvalue(), b"\xff\xe1" + (48).to_bytes(2, "big") + b"Exif\0\0" + bytes(40)
    (tmp_path / "p.jpg").write_bytes(whole[:2] + segment * 80_000 + whole[2:])
    (tmp_path / "a.mtl").write_text("newmtl a\nmap_Kd p.jpg\n")
    (tmp_path / "m.obj").write_text("mtllib a.mtl\nusemtl a\n" + TRIANGLE)
    assert "64 segments of Exif" in build(tmp_path, scene(tmp_path, '[[objects]]\nmodel = "m.obj"\n'), 0), "a note: it is not read"


def test_one_image_named_in_very_many_materials(tmp_path):
    (tmp_path / "d").mkdir()
    Image.new("RGB", (4, 4)).save(tmp_path / "p.png")
    (tmp_path / "a.mtl").write_text("newmtl a\n" + "map_Kd p.png\n" * 20_000)
    (tmp_path / "m.obj").write_text("mtllib a.mtl\nusemtl a\n" + TRIANGLE)
    build(tmp_path, scene(tmp_path, f'[[objects]]\nmodel = "{"d/../" * 100}m.obj"\n'), 0)


def with_texts(folder, name, chunks):
    """A PNG of a pixel, and compressed texts."""
    Image.new("RGB", (1, 1)).save(folder / name)
    blob, packed = (folder / name).read_bytes(), zlib.compress(b"a" * (1 << 20), 9)
    made = b""
    for number in range(chunks):
        body = b"zTXtk%d\0\0" % number + packed
        made += (len(body) - 4).to_bytes(4, "big") + body + zlib.crc32(body).to_bytes(4, "big")
    (folder / name).write_bytes(blob[:33] + made + blob[33:])


def test_an_image_with_much_text(tmp_path):
    with_texts(tmp_path, "z.png", 63)
    rows = [f'file = "z.png"\nmost_colours = {number}' for number in range(1, 256)]
    build(tmp_path, scene(tmp_path, textures(rows)), 2)
    with_texts(tmp_path, "z.png", 3)
    build(tmp_path, scene(tmp_path, textures(rows)), 0)


@pytest.mark.parametrize("scans", [2, 10_000])
def test_a_jpeg_of_very_many_scans(tmp_path, scans):
    made = io.BytesIO()
    Image.new("L", (1024, 1024), 128).save(made, "JPEG", progressive=True, quality=50)
    whole = made.getvalue()
    last = whole.rindex(b"\xff\xda")
    (tmp_path / "p.jpg").write_bytes(whole[:last] + whole[last:-2] * scans + whole[-2:])
    (tmp_path / "a.mtl").write_text("newmtl a\nmap_Kd p.jpg\n")
    (tmp_path / "m.obj").write_text("mtllib a.mtl\nusemtl a\nvt 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/1 3/1\n")
    assert_ended(tmp_path, scene(tmp_path, '[[objects]]\nmodel = "m.obj"\n'))


def loops(count, circles, chance):
    """Corners of circles in random places, most of which run backwards."""
    made = []
    for _ in range(circles):
        x, y, way = chance.randrange(-10 ** 6, 10 ** 6), chance.randrange(-10 ** 6, 10 ** 6), chance.choice((1, -1, -1))
        made += [(x + int(1e5 * math.cos(way * 2 * math.pi * i * circles / count)),
                  y + int(1e5 * math.sin(way * 2 * math.pi * i * circles / count))) for i in range(count // circles)]
    return made


def test_faces_that_cross_themselves_in_loops(tmp_path):
    """Earcut takes cubic time for them."""
    points = loops(2000, 4, random.Random(3))
    (tmp_path / "m.obj").write_text("".join(f"v {x / 1000} {y / 1000} 0\n" for x, y in points) +
                                    ("f " + " ".join(map(str, range(1, len(points) + 1))) + "\n") * 6)
    build(tmp_path, scene(tmp_path, '[[objects]]\nmodel = "m.obj"\nscale = "1/10"\n'), 0)


def test_what_surely_crosses_itself():
    """As the sum of the areas of earcut's triangles says."""
    chance = random.Random(8)
    for count in (205, 300):
        circle = [(round(1e6 * math.cos(2 * math.pi * i / count)), round(1e6 * math.sin(2 * math.pi * i / count))) for i in range(count)]
        assert not triangles._crosses_itself(circle)
        crossed = list(circle)
        first, other = sorted(chance.sample(range(count), 2))
        crossed[first], crossed[other] = crossed[other], crossed[first]
        assert triangles._crosses_itself(crossed)
        star = [(x * (2 + i % 2), y * (2 + i % 2)) for i, (x, y) in enumerate(circle)]
        assert not triangles._crosses_itself(star)


def test_what_crosses_itself_by_the_sides_of_its_corners():
    """Of four and five random points no three lie nearly on a line."""
    def side(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0

    def cross(a, b, c, d):
        return side(a, b, c) != side(a, b, d) and side(c, d, a) != side(c, d, b)
    chance, seen = random.Random(9), set()
    for count in 40 * [4, 5]:
        points = [(chance.randrange(10 ** 6), chance.randrange(10 ** 6)) for _ in range(count)]
        edges = list(zip(points, points[1:] + points[:1]))
        crosses = any(cross(*edges[i], *edges[j]) for i in range(count) for j in range(i + 2, count - (i == 0)))
        assert triangles._crosses_itself(points) == crosses
        seen.add((count, crosses))
    assert len(seen) == 4


def test_large_faces_with_surfaces(tmp_path):
    """The coordinates of all corners were looked up for each piece."""
    (tmp_path / "m.obj").write_text("".join(f"v {1e3 * math.cos(i / 3000 * 2 * math.pi):.3f} {1e3 * math.sin(i / 3000 * 2 * math.pi):.3f} 0\n"
                                            for i in range(3000)) + "f " + " ".join(map(str, range(1, 3001))) + "\n")
    build(tmp_path, scene(tmp_path, '[[objects]]\nmodel = "m.obj"\nfit = 1000\nopacity = 8\n'), 0)


def test_glTF_files_over_one_buffer(tmp_path):
    """Few triangles, and very many vertices that are read."""
    data, blob = gltf(np.zeros((20_000, 3)).tolist()[:-3] + [[0, 0, 0], [1, 0, 0], [0, 1, 0]], [(19_997, 19_998, 19_999)])
    data["meshes"][0]["primitives"] *= 12
    data["buffers"][0]["uri"] = "all.bin"
    (tmp_path / "all.bin").write_bytes(blob)
    for number in range(200):
        (tmp_path / f"m{number}.gltf").write_text(json.dumps(data))
    assert_ended(tmp_path, scene(tmp_path, "".join(f'[[objects]]\nmodel = "m{i}.gltf"\n' for i in range(200))))


def test_parts_that_are_convex_have_no_clusters(tmp_path):
    build(tmp_path, scene(tmp_path, item('solid = "island"', "cells = [30, 30]", "parts = [8, 8]", "clusters = true")), 0)
    made = image.load(tmp_path / "out.fxls")
    assert {bool(model.clusters) for model in made.models if model.kind == image.SORTED} == {True}


# --- trees ------------------------------------------------------------------------------------

def planted(folder, name, objects):
    """What a tree of a scene is made of, over all its objects: parts and lines."""
    file = folder / f"{name}.toml"
    file.write_text(f"view = {{ far = 4000 }}\n{objects}{PATH}", encoding="utf-8")
    compiled, _ = compiler.compile_scene(str(file), None, None, None, "program")
    lines = tree.Lines()
    parts = tree.parts_of(compiled, range(len(compiled.objects)), (0, 0, 0), lines)
    return parts, lines


def boxes(count):
    return f'[[objects]]\nsolid = "box"\nrepeat = {{ count = [{count}, 10, 10], step = [3, 4, 5] }}\n'


COMB = """[[objects]]
solid = "box"
scale = [200, 4, 1]
[[objects]]
solid = "box"
scale = ["1/4", 6, 6]
rotation = [10, 0, 0]
repeat = { count = [150, 1, 1], step = [1, 0, 0] }
"""


def ring(count):
    """Discs of 24 corners on one another, which share no edge."""
    rows = [f"v {math.cos(i / 12 * math.pi) * (1 + k / 9999):.6f} 0 {math.sin(i / 12 * math.pi) * (1 + k / 9999):.6f}\n"
            for k in range(count) for i in range(24)]
    return "".join(rows) + "".join(f"f {' '.join(str(24 * k + i + 1) for i in range(24))}\n" for k in range(count))


@pytest.mark.parametrize("objects, words", [
    (boxes(110), "66,000 faces"),
    ('[[objects]]\nobj = "ring.obj"\nkind = "sorted"\nrepeat = { count = [32, 1, 1], step = [3, 1, 0] }\n', "vertices")])
def test_more_than_a_model_has_is_refused_before_the_work(tmp_path, objects, words):
    (tmp_path / "ring.obj").write_text(ring(2000), encoding="utf-8")
    file = tmp_path / "scene.toml"
    file.write_text(objects + PATH, encoding="utf-8")
    code, said = run_bounded("build", file, "-o", tmp_path / "out.fxls", "--tree", "all")
    assert code == 2 and f"{words} or more, and a model has at most 65,535" in said, said
    assert not (tmp_path / "out.fxls").exists()


def test_cuts_beyond_the_faces_of_a_model_end_at_once(tmp_path, monkeypatch):
    parts, lines = planted(tmp_path, "scene", COMB)
    monkeypatch.setattr(tree, "FACES_MAX", len(parts) + 9)
    with pytest.raises(ToolError, match=f"would have {len(parts) + 10} faces or more"):
        tree.grow(parts, lines)


def test_faces_that_beams_divide_are_counted_before(tmp_path, monkeypatch):
    """A disc of 24 corners becomes 22 triangles."""
    (tmp_path / "ring.obj").write_text(ring(9), encoding="utf-8")
    parts, lines = planted(tmp_path, "scene", '[[objects]]\nobj = "ring.obj"\nkind = "sorted"\n')
    monkeypatch.setattr(tree_faces, "halve", None)
    monkeypatch.setattr(tree, "FACES_MAX", len(parts) * 22 - 1)
    with pytest.raises(ToolError, match=f"would have {len(parts) * 22} faces or more"):
        tree.grow(parts, lines, most=3)
